"""Proposals: what may be written next, whatever protocol tells it to an editor."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from msgspec import Struct

from rotsolve.algebra.units.dimension import KINDS, NONE, Dimension, describe
from rotsolve.algebra.units.unit_table import UNITS


class Proposal(Struct, frozen=True):
    """One thing that may be written: its label, what sort of thing it is, its help, and what is inserted where that is not the label.

    A `snippet` has stops of the tab key, `radius: ${1:20 cm}`.
    """

    label: str
    sort: str
    help: str = ""
    insert: str = ""
    snippet: bool = False


def each(labels: Iterable[str], sort: str, help: str = "") -> Iterator[Proposal]:
    """The same help for several labels."""
    yield from (Proposal(label, sort, help) for label in labels)


def proposed_units(dimension: Dimension | None) -> Iterator[Proposal]:
    """The units in which a dimension is measured; all where none is wanted."""
    composed = {kind.unit: kind.dimension for kind in KINDS if kind.unit}
    named = {name: unit.dimension for name, unit in UNITS.items() if name in (unit.text, "deg")}
    for name, measured in {**named, **composed}.items():
        if dimension is None or measured == dimension or (measured.matches(dimension) and measured != NONE):
            yield Proposal(name, "unit", describe(measured, article=True))


def once(proposals: Iterable[Proposal]) -> list[Proposal]:
    """The first of each label."""
    found: dict[str, Proposal] = {}
    for proposal in proposals:
        found.setdefault(proposal.label, proposal)
    return list(found.values())
