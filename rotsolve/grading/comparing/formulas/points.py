"""Points: random values of a scene's letters at which formulas are compared, always the same ones.

They lie round the scene's own numbers: what is positive stays so, R > r stays so where the numbers have it so, and no bound on which
the closed forms rest is broken. A letter that may have either sign has both; at the scene's own points it has the sign of its number, and
an angle stays within its quadrant, so that √(1 − cos² θ) is sin θ.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import pi
from random import Random
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.certified.ball import Precision, evaluate
from rotsolve.algebra.certified.ball import resolve as in_givens
from rotsolve.algebra.certified.balls import Ball, RealBalls, Undefined
from rotsolve.algebra.flints import arb
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.derivation import Answer
from rotsolve.core.registry import TIME
from rotsolve.motion.positive import is_angle

if TYPE_CHECKING:
    from rotsolve.language.problem import Given
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


class Letter(Struct, frozen=True):
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

    letters: tuple[Letter, ...]
    told: Mapping[str, Formula]
    positive: frozenset[str]
    bounds: tuple[Formula, ...]

    @property
    def ranks(self) -> list[list[str]]:
        """Letters of one dimension from the smallest to the largest, where the scene's numbers tell them apart."""
        groups: dict[Dimension, list[Letter]] = {}
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
    told = {name: given.value for name, given in givens.items() if given.value is not None and given.value.symbols()}
    told |= {name: form for name, form in closed_forms(solution.derivation.answers) if name not in givens}
    told = {name: in_givens(form, told) for name, form in told.items()}
    free = [_letter(given, values, positive) for name, given in givens.items() if name not in told]
    bounds = valid.bounds if valid is not None else ()
    others = {TIME, *(name for bound in bounds for name in bound.symbols())} - givens.keys() - told.keys()
    free += [Letter(name, TYPICAL, name not in positive | {TIME}, False, None) for name in sorted(others)]
    return Region(tuple(free), told, positive | {TIME}, bounds)


def closed_forms(answers: tuple[Answer, ...]) -> Iterator[tuple[str, Formula]]:
    """The answers and their components by name, as formulas of the givens."""
    for answer in answers:
        if answer.closed is not None and answer.closed != Symbol(answer.name):
            yield answer.name, answer.closed
        yield from closed_forms(answer.components)


def _letter(given: Given, values: Mapping[str, Formula], positive: frozenset[str]) -> Letter:
    signed = given.name not in positive
    if given.value is None:
        return Letter(given.name, TYPICAL_ANGLE if is_angle(given) else TYPICAL, signed, False, None)
    value = evaluate(given.value, values, digits=6).float
    number = abs(value)
    quadrant = None
    if number and is_angle(given):
        low = number // QUARTER * QUARTER
        quadrant = (low, low + QUARTER)
    return Letter(given.name, number or 1.0, signed, True, None if signed else given.dimension, value < 0, quadrant)


def points_of(region: Region, own: bool = False) -> tuple[Point, ...]:
    """Values for all letters at several points, `own` ones with the scene's signs; none where no such point is found."""
    random, spread = Random(SEED), SPREAD
    found: list[Point] = []
    while len(found) < POINTS and spread > NEAREST:
        for _ in range(TRIES):
            point = _point(region, random, spread, own)
            if point is not None:
                found.append(point)
                break
        else:
            spread /= 2
    return tuple(found)


def _point(region: Region, random: Random, spread: float, own: bool) -> Point | None:
    """Values of all letters, None where a bound is broken."""
    numbers = {letter.name: _number(letter, random, spread, own) for letter in region.letters}
    with Precision(BITS):
        point: dict[str, Ball] = {name: arb(number) for name, number in _ordered(region, numbers).items()}
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


def _number(letter: Letter, random: Random, spread: float, own: bool) -> float:
    power = random.uniform(-1, 1) * spread * (1 if letter.known else WIDER)
    size = float(letter.number * 2.0**power)
    if own:
        if letter.quadrant is not None and not letter.quadrant[0] < size < letter.quadrant[1]:
            low, high = letter.quadrant
            size = low + (high - low) * random.uniform(0.1, 0.9)
        return -size if letter.negative else size
    return -size if letter.signed and random.random() < 0.5 else size


def _ordered(region: Region, numbers: dict[str, float]) -> dict[str, float]:
    """The numbers of letters of one dimension exchanged so that they have the order of the scene's."""
    for ranked in region.ranks:
        numbers |= dict(zip(ranked, sorted(numbers[name] for name in ranked), strict=True))
    return numbers
