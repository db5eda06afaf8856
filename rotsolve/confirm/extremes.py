"""Extremes over a letter: `x where Q is largest` and `largest Q`: what Q is at places over the letter's range, and between them."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import ANGLE, ANGULAR_VELOCITY
from rotsolve.confirm import NotConfirmed, OverBudget, Unfit
from rotsolve.confirm.course.scan import GOLDEN, places_beside
from rotsolve.language.keys import HIGHEST
from rotsolve.language.limited import limited_letters
from rotsolve.language.problem import EXTREMES, Find, Given, Problem, references

ROUND = 24  # places at which an angle is looked at
SECTIONS = 60  # of an interval between places: to 3e-13 of it, as a size that comes to nothing needs
PEAKS, COARSE = 3, 12  # among the places, the best of which are looked at more closely first
LEAST = -1e300  # a value at all
NOTHING = 1e-9  # of the values at the places beside it: what is nothing
ALIKE = 1e-11  # of two values between which what is followed in time does not tell: then their place is known to 1e-5 of itself
BETTER = 1e-7  # of a value by which another one is larger
BESIDE = 2e-3  # how far beside an answer it is looked whether the quantity falls on both sides
LEVEL = 0.06  # how far an extreme may lie from the middle of what lies beside it, as a share of the drop there

Value = Callable[[float], float]


def phrase_of(find: Find, problem: Problem) -> Find:
    """The quantity of which `largest Q` asks the largest value: itself, or an answer `Q` before it."""
    if find.terms:
        return find
    return next((item for item in problem.finds if item.terms and Symbol(item.name) == find.formula), find)


def plainly_asked(phrase: Find) -> Find:
    """A question without its words for an extreme."""
    terms = tuple(replace(term, modifier="" if term.modifier in EXTREMES else term.modifier) for term in phrase.terms)
    return replace(phrase, modifier="" if phrase.modifier in EXTREMES else phrase.modifier, terms=terms)


def letter_of_extreme(find: Find, problem: Problem) -> Given | None:
    """The letter over which the `largest` of a quantity is asked: the only one that is `unknown`, else the only one without a value; None
    of what is asked over a time, or of several steady motions. NotConfirmed where several letters are open."""
    from rotsolve.confirm.space.rig import NODAL

    steady = {state.name for state in problem.states if state.steady}
    events = {event.name for event in problem.events}
    if any(term.start or (term.during or "") not in {"", *events} for term in find.terms):
        return None
    terms = phrase_of(find, problem).terms
    if any(term.path.quantity in NODAL and (term.at in steady or (term.at is None and steady)) for term in terms):
        return None
    seeking = Counter(item.seeks for item in problem.finds if item.where is not None)
    others = Counter(item.seeks for item in problem.finds if item.where is not None and item.where.word not in EXTREMES)
    open_ = [given for given in problem.givens if given.value is None and not given.automatic]
    free = [given for given in open_ if not (given.asked and seeking[given.name] == others[given.name] == 1)]
    unknown = [given for given in free if given.asked] or free
    if len(unknown) != 1 and (open_ or not find.terms):
        raise NotConfirmed("an extreme over a letter")
    return unknown[0] if unknown else None


def extreme_place(
    given: Given, word: str, own: float, value: Value, reach: float | None, *, sized: bool = False
) -> float:
    """The answer itself where the quantity gets worse on both sides of it, and is better nowhere in the range; else the better place."""
    sign = 1.0 if word == "largest" else -1.0
    worth, step = worth_by(value, sign), BESIDE * (abs(own) or 1.0)
    here = sign * value(own)
    at, best = extreme_over(given, word, own, value, reach, sized=sized)
    if sign * best - here > BETTER * abs(best):
        return at
    low, high = (
        worth(beside) if can_be(given, beside, reach, sized) else -math.inf for beside in (own - step, own + step)
    )
    if math.isinf(low) != math.isinf(high) and max(low, high) < here:
        return own  # an end of the range
    drop = here - 0.5 * (low + high)
    if not (drop > 0.0 and abs(high - low) <= LEVEL * drop):
        raise NotConfirmed("an extreme at the end of a range")
    return own


def can_be(given: Given, at: float, reach: float | None, sized: bool) -> bool:
    """Whether a letter can have a number, as far as its range is told."""
    if reach is not None:
        return 0.0 <= at <= reach
    return at >= 0.0 or is_signed(given, sized) or given.dimension == ANGLE


def is_signed(given: Given, sized: bool) -> bool:
    """Whether a letter may be negative: a rate in space, or where nothing tells what it is, but not where its key has it `sized`."""
    return not sized and (given.dimension is None or given.dimension.matches(ANGULAR_VELOCITY))


def worth_by(value: Value, sign: float) -> Value:
    """How good a place is, −∞ where there is no value; a budget that is spent ends it all."""

    def worth(at: float) -> float:
        try:
            return sign * value(at)
        except OverBudget:
            raise
        except (NotConfirmed, Unfit, ArithmeticError, ValueError):
            return -math.inf

    return worth


def extreme_over(
    given: Given, word: str, own: float, value: Value, reach: float | None, *, sized: bool = False
) -> tuple[float, float]:
    """The best place over the range of a letter, and the value there: the best of places, then golden sections between its neighbours."""
    sign = 1.0 if word == "largest" else -1.0
    worth = worth_by(value, sign)
    around = range_of(given, own, value, reach, sized)
    places = sorted({own, *around} if reach is None else around)
    worths = [worth(place) for place in places]
    last = len(places) - 1
    peaks = [n for n in range(last + 1) if worths[n] >= max(worths[max(0, n - 1)], worths[min(n + 1, last)], LEAST)]
    if not peaks:
        value(own)  # which says why
        raise NotConfirmed("the quantity has a value nowhere in the range")
    best = sorted(peaks, key=worths.__getitem__)[-PEAKS:]
    beside = [(places[max(0, n - 1)], places[n], places[min(n + 1, last)]) for n in best]
    low, middle, high = beside[-1]
    if len(beside) > 1:
        low, middle, high = max(beside, key=lambda at: best_between(at[0], at[1], at[2], worth, COARSE)[1])
    at, top = best_between(low, middle, high, worth, SECTIONS)
    at, top = max((at, top), (places[best[-1]], worths[best[-1]]), key=lambda place: place[1])
    beside_it = [abs(found) for found in (worth(low), worth(high)) if found > LEAST]
    return at, sign * top if abs(top) > NOTHING * max(beside_it, default=0.0) else 0.0


def range_of(given: Given, own: float, value: Value, reach: float | None, sized: bool) -> list[float]:
    """Places over the range of a letter: from 0 to its `reach`, once round of an angle; of a rate, or where nothing tells what it is, on
    both sides of 0, else, and where its key has it `sized`, from 0 on."""
    dimension = given.dimension
    if reach is not None:
        return [reach * number / ROUND for number in range(ROUND + 1)]
    if dimension == ANGLE or (dimension is None and same_a_turn_later(own, value)):
        return [-math.pi + math.tau * (number + 0.5) / ROUND for number in range(-1, ROUND + 1)]
    places = places_beside(own, 1.0, None)
    return [0.0, *places, *(-place for place in places if is_signed(given, sized))]


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
    try:
        here, there = value(own), value(own + math.tau)
    except (NotConfirmed, Unfit):  # which the scene does not let it be
        return False
    return abs(here - there) <= BETTER * max(abs(here), abs(there))


def best_between(low: float, known: float, high: float, worth: Value, sections: int) -> tuple[float, float]:
    """The place between two at which a value is largest, by golden sections, and that value; where there is none, towards a `known` one."""
    one, two = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    first, second = worth(one), worth(two)
    for _ in range(sections):
        if abs(first - second) <= ALIKE * min(abs(first), abs(second)):  # as beside a smooth extreme, not beside a kink
            break
        if first > second or (first == second and known < two):
            high, two, second = two, one, first
            one = high - GOLDEN * (high - low)
            first = worth(one)
        else:
            low, one, first = one, two, second
            two = low + GOLDEN * (high - low)
            second = worth(two)
    return (one, first) if first >= second else (two, second)
