"""Equality: whether two formulas say the same in a scene; a difference is proved by balls at points, agreement by exact algebra."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.certified.balls import Ball, RealBalls, Undefined
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.formula import Formula, Integral
from rotsolve.grading.comparing.formulas.forms import Yardstick, extent
from rotsolve.grading.comparing.formulas.points import BITS, Point, Region, points_of, region_of

if TYPE_CHECKING:
    from rotsolve.solution import Solution

REFERENCES = 256  # that a domain remembers
NOTHING = Fraction(1, 10**20)  # a share by which equal formulas may differ in balls
LARGEST = 20_000  # terms that a formula may have when it is multiplied out


class Domain:
    """The region of a scene with its points; what a reference is there is worked out once."""

    def __init__(self, region: Region, own: bool = False) -> None:
        self.region = region
        self.points = points_of(region, own)
        self._references: dict[Formula, Reference] = {}

    @cached_property
    def own(self) -> Domain:
        """The part of the domain in which all letters have the signs of the scene's numbers, and angles their quadrant."""
        return Domain(self.region, own=True)

    @classmethod
    def of(cls, solution: Solution) -> Domain:
        """The domain of a solved scene."""
        return cls(region_of(solution))

    def reference(self, formula: Formula) -> Reference:
        """The formula made ready for comparisons."""
        if formula not in self._references:
            if len(self._references) >= REFERENCES:
                self._references.clear()
            self._references[formula] = Reference(formula, self)
        return self._references[formula]


class Reference:
    """A formula with its values at the points of a domain and its exact form, each found when first needed."""

    def __init__(self, formula: Formula, domain: Domain) -> None:
        self.region = domain.region
        self.formula = formula.substitute(domain.region.told)
        self.points = tuple(point for point in domain.points if formula.symbols() <= point.keys())
        self._values: dict[int, Ball | None] = {}

    def value(self, index: int) -> Ball | None:
        """The value at a point; None where there is none."""
        if index not in self._values:
            try:
                self._values[index] = value_at(self.formula, self.points[index])
            except Undefined:
                self._values[index] = None
        return self._values[index]

    @cached_property
    def yardstick(self) -> Yardstick | None:
        """The form by which most formulas are judged; None where the reference has no such form."""
        letters = [letter.name for letter in self.region.letters]
        try:
            return Yardstick(self.formula, letters, self.region.positive, self.region.ranks)
        except (ValueError, ArithmeticError):
            return None

    def is_exactly(self, formula: Formula) -> bool | None:
        """Whether the exact layer finds the formula equal to this one wherever both are defined; None where it can not tell."""
        formula = formula.substitute(self.region.told)
        if extent(formula) > LARGEST:
            return None
        found = self.yardstick.equals(formula) if self.yardstick is not None else None
        if found is not None:
            return found
        try:
            return equal(formula, self.formula, self.region.positive) or None
        except (ValueError, ArithmeticError):
            return None


def value_at(formula: Formula, point: Point) -> Ball | None:
    """The value of a formula at a point, None where it can not be told; Undefined where there surely is none."""
    with Precision(BITS):
        ball = RealBalls({}, bound=point)(formula)
    return ball if ball.is_finite() else None


def same(left: Formula, right: Formula, domain: Domain) -> bool | None:
    """Whether both formulas are equal wherever both are defined; None where neither that nor a difference could be proved.

    `right` is the reference. A point at which one side is undefined is no difference, unless the left side is so at all of them.
    """
    if left == right:
        return True
    reference = domain.reference(right)
    if left.holds(Integral):
        return reference.is_exactly(left)  # its values could take seconds
    tried = undefined = met = 0
    for index, point in enumerate(reference.points):
        value = reference.value(index)
        if value is None or not left.symbols() <= point.keys():
            continue
        tried += 1
        try:
            other = value_at(left, point)
        except Undefined:
            undefined += 1
            continue
        if other is None:
            continue
        if not (other - value).contains(0):
            return False
        met += 1
        exact = reference.is_exactly(left) if met == 1 else None
        if exact is not None:
            return exact
    if undefined and undefined == tried:
        return False
    return reference.is_exactly(left) if not tried else None


def same_here(left: Formula, right: Formula, domain: Domain) -> bool:
    """Whether both formulas are equal for the signs that the scene's numbers have, as sin(θ/2) and √(1 − cos θ)/√2 for θ > 0.

    Their squares, or these squared, are proved to be equal, and at every point they have one sign.
    """
    if left.holds(Integral) or right.holds(Integral) or not close(left, right, domain.own, NOTHING):
        return False
    return any(domain.reference(right**power).is_exactly(left**power) for power in (2, 4))


def close(left: Formula, right: Formula, domain: Domain, share: Fraction) -> bool:
    """Whether the left formula is within a share of the right one at every point of a domain: one of its numbers may be rounded."""
    reference, met = domain.reference(right), 0
    for index, point in enumerate(reference.points):
        value = reference.value(index)
        if value is None or not left.symbols() <= point.keys():
            continue
        try:
            other = value_at(left, point)
        except Undefined:
            return False
        if other is None or not abs(other - value) <= abs(value) * share.numerator / share.denominator:
            return False
        met += 1
    return met > 1
