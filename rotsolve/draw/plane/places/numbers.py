"""Numbers: what the letters of a scene are on paper: their values, and for those that have none some that fit each other."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.units.dimension import ANGLE, LENGTH, NONE
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.numbers import value_of
from rotsolve.core.letters import Given
from rotsolve.language.problem import Problem
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.limits import limits_of_scene

SHARES = (0.62, 0.38, 0.8, 0.25, 0.5, 0.7, 0.3, 0.9)  # of the usual length of a scene, for one that is left open
ACUTE = (0.6, 0.75, 0.45, 0.9, 0.35)  # radians
TRIES = 40


def numbers_for(configuration: Configuration) -> dict[str, float]:
    """A number for every letter of a scene."""
    problem = configuration.problem
    known = known_numbers(problem)
    usual = usual_length(problem, known)
    limits = [limit.gap for limit in limits_of_scene(configuration)] if not problem.space else []
    first: dict[str, float] | None = None
    for turn in range(TRIES):
        numbers = {**known, **dict(guessed(problem, known, usual, turn))}
        first = first or numbers
        if all(may_hold(gap, numbers) for gap in limits):
            return numbers
    return first or known


def known_numbers(problem: Problem) -> dict[str, float]:
    """The values of the givens, which may hold others."""
    letters = {given.name: given.value or given.trial for given in problem.givens}
    found: dict[str, float] = {}
    for name, value in letters.items():
        try:
            found[name] = float(value_of(value, letters)) if value is not None else 0.0
        except (NotConfirmed, ArithmeticError, ValueError):
            continue
    return {name: size for name, size in found.items() if letters[name] is not None}


def usual_length(problem: Problem, known: Mapping[str, float]) -> float:
    """The middle one of the lengths that are told; 1 where none is."""
    lengths = sorted(
        abs(known[given.name]) for given in problem.givens if given.dimension == LENGTH and known.get(given.name)
    )
    return lengths[len(lengths) // 2] if lengths else 1.0


def guessed(problem: Problem, known: Mapping[str, float], usual: float, turn: int) -> Iterator[tuple[str, float]]:
    """Numbers for the letters that have none; each `turn` tries others."""
    open_ = [given for given in problem.givens if given.name not in known]
    for place, given in enumerate(open_):
        yield given.name, guess(given, usual, place + turn * (1 + place))


def guess(given: Given, usual: float, place: int) -> float:
    if given.dimension == LENGTH:
        return usual * SHARES[place % len(SHARES)]
    if given.dimension == ANGLE:
        return ACUTE[place % len(ACUTE)]
    return 0.3 if given.dimension == NONE else 1.0 + 0.17 * (place % 7)


def may_hold(gap: Formula, numbers: Mapping[str, float]) -> bool:
    """Whether a condition of the scene holds, as far as numbers tell."""
    try:
        return float(value_of(gap, numbers)) >= 0.0
    except (NotConfirmed, ArithmeticError, ValueError):
        return True
