"""Offers: what may be written next, whatever protocol tells it to an editor."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from msgspec import Struct

from rotsolve.algebra.units.dimension import KINDS, NONE, Dimension, describe
from rotsolve.algebra.units.unit_table import UNITS

STOP = re.compile(r"\$\{\d+(?::([^}]*)|\|([^,|]*)[^}]*)\}")


class Offer(Struct, frozen=True):
    """One thing that may be written: its word, what sort of thing it is, its help, and what is inserted where that is not the word.

    A `snippet` has stops of the tab key, `radius: ${1:20 cm}`.
    """

    word: str
    sort: str
    help: str = ""
    insert: str = ""
    snippet: bool = False

    @property
    def plain(self) -> str:
        """What is inserted where an editor knows no snippets: the values as they are proposed, of choices the first."""
        text = self.insert or self.word
        return STOP.sub(lambda stop: stop[1] or stop[2] or "", text) if self.snippet else text


def offers(words: Iterable[str], sort: str, help: str = "") -> Iterator[Offer]:
    """The same help for several words."""
    yield from (Offer(word, sort, help) for word in words)


def units_offered(dimension: Dimension | None) -> Iterator[Offer]:
    """The units in which a dimension is measured; all where none is wanted."""
    composed = {kind.unit: kind.dimension for kind in KINDS if kind.unit}
    named = {name: unit.dimension for name, unit in UNITS.items() if name in (unit.text, "deg")}
    for name, measured in {**named, **composed}.items():
        if dimension is None or measured == dimension or (measured.matches(dimension) and measured != NONE):
            yield Offer(name, "unit", describe(measured, article=True))


def once(offers: Iterable[Offer]) -> list[Offer]:
    """The first of each word."""
    found: dict[str, Offer] = {}
    for offer in offers:
        found.setdefault(offer.word, offer)
    return list(found.values())
