"""Variation: what a scene says under `vary`: which givens take which values, and what the values must obey together."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.formula import Formula


class Varied(Struct, frozen=True):
    """A given with the values that it may take, each as a scene writes it: `1.5 kg`."""

    name: str
    values: tuple[str, ...]


class Comparison(Struct, frozen=True):
    """left − right, a formula of givens, has one of the `signs`; `text` is the condition as written."""

    gap: Formula
    signs: tuple[int, ...]
    text: str


class Variation(Struct, frozen=True):
    """The letters that vary, in the order of the file, and the conditions on them."""

    letters: tuple[Varied, ...]
    conditions: tuple[Comparison, ...] = ()
