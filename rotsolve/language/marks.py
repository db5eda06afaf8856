"""Marks: how an answer is marked: its points, its tolerance, the form that is wanted, and what a flaw costs. Records only."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import Formula
from rotsolve.core.faults import Span

ALL = "all"  # in place of a name: what holds for every answer
FORMS = ANY, EXACT, NUMBER = ("any", "exact", "number")
UNITS = WANTED, OPTIONAL = ("wanted", "optional")
SIGNS = STRICT, LENIENT = ("strict", "lenient")
FLAWS = UNIT, ROUNDING, FORM, FOLLOWED, CASE = ("unit", "rounding", "form", "followed", "case")


class Tolerance(Struct, frozen=True):
    """How far a number may be from the answer: a `share` of it, an `amount` in SI units, or half a unit of its last of `figures`."""

    text: str
    share: Fraction | None = None
    amount: Formula | None = None
    figures: int | None = None


class Deduction(Struct, frozen=True):
    """What a flaw costs: so many marks, or a share of the points."""

    amount: Fraction
    share: bool = False

    def of(self, points: Fraction) -> Fraction:
        """The marks that are lost, never more than there are."""
        return min(points, self.amount * points if self.share else self.amount)


QUARTER, HALF = Deduction(Fraction(1, 4), share=True), Deduction(Fraction(1, 2), share=True)


class Marking(Struct, frozen=True):
    """How the answer of one name is marked."""

    name: str
    points: Fraction = Fraction(1)
    tolerance: Tolerance = Tolerance("1 %", Fraction(1, 100))
    form: str = ANY
    unit: str = WANTED
    sign: str = STRICT
    deduct: tuple[tuple[str, Deduction], ...] = tuple((flaw, HALF if flaw == CASE else QUARTER) for flaw in FLAWS)
    span: Span | None = None

    def left(self, flaws: Iterable[str]) -> Fraction:
        """The points that are left with these flaws, each of them counted once."""
        costs = dict(self.deduct)
        return max(Fraction(0), self.points - sum(costs[flaw].of(self.points) for flaw in set(flaws)))


def marking_of(markings: Iterable[Marking], name: str) -> Marking:
    """How an answer is marked: as the scene says of it, of all, or as usual."""
    known = {marking.name: marking for marking in markings}
    return known.get(name) or replace(known.get(ALL, Marking(ALL)), name=name)
