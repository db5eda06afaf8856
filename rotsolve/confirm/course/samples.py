"""Samples: sets of numbers for letters that have none: small ones and large ones, and such as are right inside the edges of cases."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import islice

from rotsolve.algebra.units import dimension as kinds
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.asked import related
from rotsolve.confirm.numbers import value_of
from rotsolve.core.derivation import Answer, Equality
from rotsolve.language.problem import Given, Problem

SETS, DRAWS = 5, 15  # sets of numbers for letters, and how often one is drawn for them
EDGES = 8  # sets right inside the edges of cases
STEPS, CLOSER = (
    8,
    7,
)  # how often a letter is doubled or halved on the way to an edge, and how often its way there is halved
LIMITS = {  # numbers that are drawn for letters, by what they measure
    kinds.MASS: (0.5, 5.0),
    kinds.LENGTH: (0.3, 1.5),
    kinds.ANGLE: (0.3, 1.2),
    kinds.NONE: (0.15, 0.7),
    kinds.VELOCITY: (1.0, 6.0),
    kinds.FORCE: (3.0, 30.0),
    kinds.TORQUE: (1.0, 20.0),
    kinds.STIFFNESS: (20.0, 200.0),
}
OTHERS = (0.5, 3.0)
BOUNDED = (kinds.ANGLE, kinds.NONE)
PRIMES = (5, 2, 3, 7, 13, 11, 17, 19, 23, 29)  # their roots are the steps from set to set, none a fraction of others
BEYOND = 3.0  # how far the later sets go beyond the limits, so that they are on both sides of what a size decides

Numbers = Mapping[str, float]


def letters_open(problem: Problem) -> list[Given]:
    """The letters that have no number and are not asked for."""
    return [given for given in problem.givens if given.value is None and not given.asked]


def sets_of_numbers(problem: Problem) -> Iterator[Numbers]:
    """The numbers of the givens; where some have none, several sets drawn for those."""
    open_ = letters_open(problem)
    for number in range(DRAWS if open_ else 1):
        yield with_givens(
            problem, {given.name: number_drawn(given, number, place) for place, given in enumerate(open_)}
        )


def near_edges(
    problem: Problem, answers: Sequence[Answer], points: Sequence[Mapping[str, Fraction]]
) -> Iterator[Numbers]:
    """The numbers of cases, with one letter so much larger or smaller that a condition only just holds."""
    letters = {given.name for given in letters_open(problem) if given.dimension != kinds.ANGLE}  # those stay acute
    done: list[Equality] = []
    for point in points:
        numbers = {name: float(size) for name, size in point.items()}
        known = with_givens(problem, numbers)
        cases = [case for answer in answers if (case := holding(answer, known)) is not None]
        for condition in (one for case in cases for one in case.conditions):
            if condition not in done and len(done) < EDGES:
                done.append(condition)
                names = sorted((condition.left.symbols() | condition.right.symbols()) & letters)
                ways = ((name, factor) for name in names for factor in (2.0, 0.5))
                near = (near_edge(problem, condition, numbers, name, factor) for name, factor in ways)
                yield from islice(filter(None, near), 1)


def near_edge(problem: Problem, condition: Equality, numbers: Numbers, name: str, factor: float) -> Numbers | None:
    """Numbers with which a condition holds and with one letter a hundredth further does not; None where it is on no edge that way."""

    def at(size: float) -> Numbers:
        return with_givens(problem, {**numbers, name: size})

    inside = numbers[name]
    further = (inside * factor**step for step in range(1, STEPS))
    outside = next((size for size in further if not holds(condition, at(size))), None)
    if outside is None:
        return None
    for _ in range(CLOSER):
        middle = (inside + outside) / 2
        inside, outside = (middle, outside) if holds(condition, at(middle)) else (inside, middle)
    return at(inside)


def with_givens(problem: Problem, drawn: Numbers) -> Numbers:
    """Numbers of letters with those of the givens."""
    numbers = dict(drawn)
    for given in problem.givens:
        if given.value is not None:
            try:
                numbers[given.name] = float(value_of(given.value, {**problem.values, **numbers}))
            except (NotConfirmed, ZeroDivisionError, OverflowError):
                continue
    return numbers


def number_drawn(given: Given, number: int, place: int) -> float:
    """Between the limits of its kind: the same in every run, and spread evenly from set to set; after the first beyond them too.

    Each letter goes from set to set by a step of its own, so that one grows where another does, or falls.
    """
    lowest, highest = LIMITS.get(given.dimension, OTHERS) if given.dimension is not None else OTHERS
    part = (number * math.sqrt(PRIMES[place % len(PRIMES)]) + place * 0.7548776662 + 0.317) % 1.0
    if number == 0 or given.dimension in BOUNDED:
        return lowest + (highest - lowest) * part
    return lowest / BEYOND * math.exp(part * math.log(highest / lowest * BEYOND**2))


def holding(answer: Answer, numbers: Numbers) -> Answer | None:
    """The answer of the case that the numbers are of."""
    for one in (answer, *answer.otherwise):
        if all(holds(condition, numbers) for condition in one.conditions):
            return one
    return None


def holds(condition: Equality, numbers: Numbers) -> bool:
    """Whether a condition holds by a margin at the numbers; not where it speaks of what has none."""
    try:
        left, right = (float(value_of(side, numbers)) for side in (condition.left, condition.right))
    except (NotConfirmed, ArithmeticError, ValueError):
        return False
    return related(left, condition.relation, right)
