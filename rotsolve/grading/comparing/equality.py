"""Equality: whether two formulas say the same in a scene; a difference is proved by balls at points, agreement by exact algebra.

The points are random values of the scene's letters, always the same ones. They lie round the scene's own numbers: what is positive stays
so, R > r stays so where the numbers have it so, and no bound on which the closed forms rest is broken. A letter that may have either sign
has both; at the scene's own points it has the sign of its number, and an angle stays within its quadrant, so that √(1 − cos² θ) is sin θ.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import cached_property
from math import pi
from random import Random
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Precision, evaluate
from rotsolve.algebra.certified.balls import Ball, RealBalls, Undefined
from rotsolve.algebra.certified.balls import with_values as in_givens
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.flints import arb
from rotsolve.algebra.formula import Formula, Integral, Symbol
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.derivation import Answer
from rotsolve.core.symbols import TIME
from rotsolve.grading.comparing.forms import Yardstick, term_count
from rotsolve.motion.positive import is_angle

if TYPE_CHECKING:
    from rotsolve.language.problem import Given, Problem
    from rotsolve.solution import Solution

SEED = 20
POINTS = 8
BITS = 96
TRIES = 24  # at one point, before the next ones are taken nearer to the scene's numbers
SPREAD = 1.0  # values are from half to twice the scene's
NEAREST = 0.01
TYPICAL, TYPICAL_ANGLE = 2.0, 0.7  # of a letter without a number; its values differ more
WIDER = 2.0
QUARTER = pi / 2

Point = Mapping[str, Ball]
REFERENCES = 256  # that a domain remembers
LARGEST = 20_000  # terms that a formula may have when it is multiplied out


class FreeLetter(Struct, frozen=True):
    """A letter that may have any value near its own number, the size of which is `number`; `order` says what it is compared with:
    letters of one dimension keep the order that their numbers have. `quadrant` holds the ends of that of an angle, as sizes."""

    name: str
    number: float
    signed: bool
    known: bool
    order: Dimension | None
    negative: bool = False
    quadrant: tuple[float, float] | None = None


class Region(Struct, frozen=True):
    """The letters of a scene, what others are in terms of them (`L: 2*R`, answers), and the bounds, none of which is negative."""

    letters: tuple[FreeLetter, ...]
    told: Mapping[str, Formula]
    positive: frozenset[str]
    bounds: tuple[Formula, ...]

    @property
    def ranks(self) -> list[list[str]]:
        """Letters of one dimension from the smallest to the largest, where the scene's numbers tell them apart."""
        groups: dict[Dimension, list[FreeLetter]] = {}
        for letter in self.letters:
            if letter.order is not None:
                groups.setdefault(letter.order, []).append(letter)
        apart = [group for group in groups.values() if len({letter.number for letter in group}) == len(group) > 1]
        return [[letter.name for letter in sorted(group, key=lambda letter: letter.number)] for group in apart]


def region_of(solution: Solution) -> Region:
    """The region in which the closed forms of a solution hold."""
    givens = {given.name: given for given in solution.problem.givens if not given.asked}
    valid = solution.trace.validity() if solution.trace.validity is not None else None
    positive = valid.positive if valid is not None else frozenset()
    values = solution.problem.values
    told = told_by_letters(solution.problem, solution.derivation.answers)
    free = [free_letter_of(given, values, positive) for name, given in givens.items() if name not in told]
    bounds = (*valid.bounds, *valid.sides) if valid is not None else ()
    others = {TIME, *(name for bound in bounds for name in bound.symbols())} - givens.keys() - told.keys()
    free += [FreeLetter(name, TYPICAL, name not in positive | {TIME}, False, None) for name in sorted(others)]
    return Region(tuple(free), told, positive | {TIME}, bounds)


def told_by_letters(problem: Problem, answers: tuple[Answer, ...]) -> dict[str, Formula]:
    """What givens are that hold others (`L: 2*R`), and answers, by letters that may have any value."""
    givens = {given.name: given.value for given in problem.givens if not given.asked}
    told = {name: value for name, value in givens.items() if value is not None and value.symbols()}
    told |= {name: form for name, form in answer_forms(answers) if name not in givens}
    return {name: in_givens(form, told) for name, form in told.items()}


def answer_forms(answers: tuple[Answer, ...]) -> Iterator[tuple[str, Formula]]:
    """The answers and their components by name, as formulas of the givens."""
    for answer in answers:
        if answer.closed is not None and answer.closed != Symbol(answer.name):
            yield answer.name, answer.closed
        yield from answer_forms(answer.components)


def free_letter_of(given: Given, values: Mapping[str, Formula], positive: frozenset[str]) -> FreeLetter:
    signed = given.name not in positive
    if given.value is None:
        return FreeLetter(given.name, TYPICAL_ANGLE if is_angle(given) else TYPICAL, signed, False, None)
    value = evaluate(given.value, values, digits=6).float
    number = abs(value)
    quadrant = None
    if number and is_angle(given):
        low = number // QUARTER * QUARTER
        quadrant = (low, low + QUARTER)
    return FreeLetter(given.name, number or 1.0, signed, True, None if signed else given.dimension, value < 0, quadrant)


def sample_points(region: Region, own: bool = False) -> tuple[Point, ...]:
    """Values for all letters at several points, `own` ones with the scene's signs; none where no such point is found."""
    random, spread = Random(SEED), SPREAD
    found: list[Point] = []
    while len(found) < POINTS and spread > NEAREST:
        for _ in range(TRIES):
            point = _random_point(region, random, spread, own)
            if point is not None:
                found.append(point)
                break
        else:
            spread /= 2
    return tuple(found)


def _random_point(region: Region, random: Random, spread: float, own: bool) -> Point | None:
    """Values of all letters, None where a bound is broken."""
    numbers = {letter.name: _random_number(letter, random, spread, own) for letter in region.letters}
    for ranked in region.ranks:  # those of one dimension in the order of the scene's
        numbers |= dict(zip(ranked, sorted(numbers[name] for name in ranked), strict=True))
    with Precision(BITS):
        point: dict[str, Ball] = {name: arb(number) for name, number in numbers.items()}
        balls = RealBalls({}, bound=point)
        try:
            if any(balls(bound) < 0 for bound in region.bounds):
                return None
        except Undefined:
            return None
        for name, form in region.told.items():
            try:
                point[name] = RealBalls({}, bound=point)(form)
            except Undefined:
                continue  # a formula with this letter is not compared here
    return point


def _random_number(letter: FreeLetter, random: Random, spread: float, own: bool) -> float:
    power = random.uniform(-1, 1) * spread * (1 if letter.known else WIDER)
    size = float(letter.number * 2.0**power)
    if own:
        if letter.quadrant is not None and not letter.quadrant[0] < size < letter.quadrant[1]:
            low, high = letter.quadrant
            size = low + (high - low) * random.uniform(0.1, 0.9)
        return -size if letter.negative else size
    return -size if letter.signed and random.random() < 0.5 else size


# comparing


class SampledRegion:
    """The region of a scene with its points; what a reference is there is worked out once."""

    def __init__(self, region: Region, own: bool = False) -> None:
        self.region, self.is_own = region, own
        self.points = sample_points(region, own)
        self._references: dict[Formula, Reference] = {}

    @cached_property
    def own(self) -> SampledRegion:
        """The part of the domain in which all letters have the signs of the scene's numbers, and angles their quadrant."""
        if self.is_own:
            return self
        positive = {letter.name for letter in self.region.letters if not letter.negative}
        return SampledRegion(replace(self.region, positive=self.region.positive | positive), own=True)

    @classmethod
    def of(cls, solution: Solution) -> SampledRegion:
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

    def __init__(self, formula: Formula, domain: SampledRegion) -> None:
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
        if term_count(formula) > LARGEST:
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


def same_everywhere(left: Formula, right: Formula, domain: SampledRegion) -> bool | None:
    """Whether both formulas are equal wherever both are defined; None where neither that nor a difference could be proved.

    `right` is the reference. A point at which one side is undefined is no difference; where the left side is so at all of them, nothing
    is proved.
    """
    if left == right:
        return True
    reference = domain.reference(right)
    if left.holds(Integral):
        return reference.is_exactly(left)  # its values could take seconds
    tried = met = 0
    for index, point in enumerate(reference.points):
        value = reference.value(index)
        if value is None or not left.symbols() <= point.keys():
            continue
        tried += 1
        try:
            other = value_at(left, point)
        except Undefined:
            continue
        if other is None:
            continue
        if not (other - value).contains(0):
            return False
        met += 1
        exact = reference.is_exactly(left) if met == 1 else None
        if exact is not None:
            return exact
    return reference.is_exactly(left) if not tried else None


def close_everywhere(left: Formula, right: Formula, domain: SampledRegion, share: Fraction) -> bool:
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
