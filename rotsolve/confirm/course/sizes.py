"""Sizes: numbers that letters are tried with: ordinary ones beside the numbers of the scene, and the same in every run."""

from __future__ import annotations

import math
from collections.abc import Callable

from msgspec import Struct

from rotsolve.algebra.units import dimension as kinds
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.numbers import value_of
from rotsolve.core.letters import Given
from rotsolve.language.problem import Problem

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
WIDER = (0.05, 1.5)  # what bounded kinds have far beyond them


class NaturalUnits(Struct, frozen=True):
    """A mass, a length and a time of the scene's own numbers, in SI units: what is ordinary beside 5 t is not so beside 5 g."""

    mass: float
    length: float
    time: float

    def of(self, dimension: Dimension | None) -> float:
        """The unit of a dimension, M^a L^b T^c."""
        if dimension is None:
            return 1.0
        powers = ((self.mass, dimension.mass), (self.length, dimension.length), (self.time, dimension.time))
        return math.prod([math.pow(unit, float(power)) for unit, power in powers])


def natural_units(problem: Problem) -> NaturalUnits:
    """By the means of the numbers that measure a mass, a length, a time; 1 where there are none, of times √L, as what falls takes."""
    numbers = [(given.dimension, size) for given in problem.givens if (size := number_of_given(given, problem))]
    sizes = [(kind, abs(size)) for kind, size in numbers if kind is not None]

    def mean(*measures: tuple[Dimension, Callable[[float], float]]) -> float | None:
        found = [change(size) for kind, change in measures for own, size in sizes if own.matches(kind)]
        return math.exp(math.fsum(map(math.log, found)) / len(found)) if found else None

    length = mean((kinds.LENGTH, float)) or 1.0
    mass = mean((kinds.MASS, float), (kinds.INERTIA, lambda size: size / length**2)) or 1.0
    time = mean((kinds.TIME, float), (kinds.VELOCITY, lambda size: length / size)) or math.sqrt(length)
    return NaturalUnits(mass, length, time)


def number_of_given(given: Given, problem: Problem) -> float | None:
    """The number of a given of the scene, as it is told or as others make it; None of a letter."""
    if given.value is None:
        return None
    try:
        return float(value_of(given.value, problem.values))
    except (NotConfirmed, ArithmeticError, ValueError):
        return None


class Sizes(Struct, frozen=True):
    """Sizes for letters, by the number of a set."""

    letters: tuple[Given, ...]
    units: NaturalUnits

    def drawn(self, number: int, beyond: float = BEYOND) -> dict[str, float]:
        """A set of them, of which all but the first go beyond the limits."""
        return {
            given.name: size_drawn(given, number, place, beyond) * self.unit(given)
            for place, given in enumerate(self.letters)
        }

    def unit(self, given: Given) -> float:
        """What is ordinary for a letter; angles and pure numbers have no unit."""
        return 1.0 if given.dimension in BOUNDED else self.units.of(given.dimension)


def letters_open(problem: Problem) -> list[Given]:
    """The letters that have no number and are not asked for."""
    return [given for given in problem.givens if given.value is None and not given.asked]


def sizes_of_letters(problem: Problem) -> Sizes:
    """Sizes for the open letters of a scene."""
    letters = tuple(letters_open(problem))
    return Sizes(letters, natural_units(problem) if letters else NaturalUnits(1.0, 1.0, 1.0))


def size_drawn(given: Given, number: int, place: int, beyond: float = BEYOND) -> float:
    """Between the limits of its kind: the same in every run, and spread evenly from set to set; after the first beyond them too.

    Each letter goes from set to set by a step of its own, so that one grows where another does, or falls.
    """
    lowest, highest = LIMITS.get(given.dimension, OTHERS) if given.dimension is not None else OTHERS
    part = (number * math.sqrt(PRIMES[place % len(PRIMES)]) + place * 0.7548776662 + 0.317) % 1.0
    if given.dimension in BOUNDED and beyond > BEYOND:
        lowest, highest = WIDER
    if number == 0 or given.dimension in BOUNDED:
        return lowest + (highest - lowest) * part
    return lowest / beyond * math.exp(part * math.log(highest / lowest * beyond**2))
