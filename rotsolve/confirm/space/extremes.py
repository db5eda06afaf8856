"""Extremes over a letter: `x where Q is largest` and `largest Q`: what Q is at places over the letter's range, and between them."""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import suppress

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import ANGLE, ANGULAR_VELOCITY
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.scan import GOLDEN, places_beside
from rotsolve.confirm.space.rig import NODAL
from rotsolve.confirm.space.worlds import Unfit
from rotsolve.language.limited import HIGHEST, limited_letters
from rotsolve.language.problem import EXTREMES, Find, Given, Problem, references

ROUND = 24  # places at which an angle is looked at
SECTIONS = 60  # of an interval between places: to 3e-13 of it, as a size that comes to nothing needs
PEAKS, COARSE = 3, 12  # among the places, the best of which are looked at more closely first
LEAST = -1e300  # a value at all
NOTHING = 1e-9  # of the values at the places beside it: what is nothing
BETTER = 1e-7  # of a value by which another one is larger
BESIDE = 2e-3  # how far beside an answer it is looked whether the quantity falls on both sides
LEVEL = 0.06  # how far an extreme may lie from the middle of what lies beside it, as a share of the drop there

Value = Callable[[float], float]


def letter_of_extreme(word: str, find: Find, problem: Problem) -> Given | None:
    """The letter over which the `largest` of a quantity is asked: the only one that is `unknown`, else the only one without a value; None
    of what is asked over a time, or of several steady motions."""
    steady = {state.name for state in problem.states if state.steady}
    events = {event.name for event in problem.events}
    if not word or not find.terms or any(term.start or (term.during or "") not in {"", *events} for term in find.terms):
        return None
    if any(term.path.quantity in NODAL and (term.at in steady or (term.at is None and steady)) for term in find.terms):
        return None
    settled = {item.seeks for item in problem.finds if item.where is not None and item.where.word not in EXTREMES}
    free = [given for given in problem.givens if given.value is None and given.name not in settled]
    unknown = [given for given in free if given.asked] or free
    return unknown[0] if len(unknown) == 1 else None


def extreme_place(given: Given, word: str, own: float, value: Value, reach: float | None) -> float:
    """The answer itself where the quantity gets worse on both sides of it, and is better nowhere in the range; else the better place."""
    sign = 1.0 if word == "largest" else -1.0
    step = BESIDE * (abs(own) or 1.0)
    low, here, high = (sign * value(own + part * step) for part in (-1.0, 0.0, 1.0))
    drop = here - 0.5 * (low + high)
    at, best = extreme_over(given, word, own, value, reach)
    if sign * best - here > BETTER * abs(best):
        return at
    if drop <= 0.0 or abs(high - low) > LEVEL * drop:
        raise NotConfirmed("an extreme at the end of a range")
    return own


def extreme_over(given: Given, word: str, own: float, value: Value, reach: float | None) -> tuple[float, float]:
    """The best place over the range of a letter, and the value there: the best of places, then golden sections between its neighbours."""
    sign = 1.0 if word == "largest" else -1.0

    def worth(at: float) -> float:
        with suppress(NotConfirmed, Unfit, ArithmeticError, ValueError):
            return sign * value(at)
        return -math.inf

    around = range_of(given, own, value, reach)
    places = sorted({own, *around} if reach is None else around)
    worths = [worth(place) for place in places]
    last = len(places) - 1
    peaks = [n for n in range(last + 1) if worths[n] >= max(worths[max(0, n - 1)], worths[min(n + 1, last)], LEAST)]
    if not peaks:
        raise NotConfirmed("the quantity has a value nowhere in the range")
    best = sorted(peaks, key=worths.__getitem__)[-PEAKS:]
    beside = [(places[max(0, n - 1)], places[min(n + 1, last)]) for n in best]
    low, high = max(beside, key=lambda ends: best_between(ends[0], ends[1], worth, COARSE)[1])
    at, top = best_between(low, high, worth, SECTIONS)
    at, top = max((at, top), (places[best[-1]], worths[best[-1]]), key=lambda place: place[1])
    beside_it = [abs(found) for found in (worth(low), worth(high)) if found > LEAST]
    return at, sign * top if abs(top) > NOTHING * max(beside_it, default=0.0) else 0.0


def range_of(given: Given, own: float, value: Value, reach: float | None) -> list[float]:
    """Places over the range of a letter: from 0 to its `reach`, once round of an angle; of a rate, or where nothing tells what it is, on
    both sides of 0, else from 0 on."""
    dimension = given.dimension
    if reach is not None:
        return [reach * number / ROUND for number in range(ROUND + 1)]
    if (dimension is not None and dimension.matches(ANGLE)) or (dimension is None and same_a_turn_later(own, value)):
        return [-math.pi + math.tau * (number + 0.5) / ROUND for number in range(-1, ROUND + 1)]
    places = places_beside(own, 1.0, None)
    signed = dimension is None or dimension.matches(ANGULAR_VELOCITY)
    return [0.0, *places, *(-place for place in places if signed)]


def end_of_range(letter: str, problem: Problem) -> Formula | None:
    """Up to where from 0 a letter can be: along the rod on which it tells a place, or as the key says under which it stands."""
    limits = limited_letters(problem).get(letter)
    if limits in HIGHEST:
        return HIGHEST[limits]
    bodies = {body.name: body for body in problem.bodies}
    for ref in references(problem):
        body = bodies.get(ref.owner)
        if ref.argument == Symbol(letter) and body is not None and body.shape is not None:
            return body.shape.reach()
    return None


def same_a_turn_later(own: float, value: Value) -> bool:
    """Whether a quantity is the same when a letter is greater by 2π."""
    here, there = value(own), value(own + math.tau)
    return abs(here - there) <= BETTER * max(abs(here), abs(there))


def best_between(low: float, high: float, worth: Value, sections: int) -> tuple[float, float]:
    """The place between two at which a value is largest, by golden sections, and that value."""
    one, two = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    first, second = worth(one), worth(two)
    for _ in range(sections):
        if first >= second:
            high, two, second = two, one, first
            one = high - GOLDEN * (high - low)
            first = worth(one)
        else:
            low, one, first = one, two, second
            two = low + GOLDEN * (high - low)
            second = worth(two)
    return (one, first) if first >= second else (two, second)
