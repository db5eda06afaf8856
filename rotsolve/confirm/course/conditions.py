"""Conditions: `x where Q = c`, `x where Q is largest`, `largest F where touch sticks`: the answer is tried, and what lies beside it."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import Symbol
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.astray import LetsGo, SlipsOn
from rotsolve.confirm.course.following import Broken, Course, Unbalanced
from rotsolve.confirm.course.reading import Reckoned, number
from rotsolve.confirm.course.settling import Adrift
from rotsolve.confirm.instant import STICKS
from rotsolve.language.problem import EXTREMES, Condition, Find

if TYPE_CHECKING:
    from rotsolve.confirm.course.scans import Scans

NEAR = 1e-5  # how far beside the answer a condition is tried
STRAIGHT = 1e-2  # share of the gap of two places beside an answer by which the line through them may miss it
NONE = 1e-9  # share of the gap on one side below which there is none on the other

Value = Callable[[Find, Course], float]


def tried(find: Find, said: float, course: Course, value: Value, scans: Scans | None) -> Reckoned:
    """The answer itself, where its condition holds with it and not beside it; Broken where it does not hold."""
    condition = find.where
    if condition is None or find.terms or not isinstance(find.formula, Symbol):
        raise NotConfirmed("a quantity under a condition of its own")
    letter = find.formula.name
    if letter not in {given.name for given in course.problem.givens}:
        raise NotConfirmed("an answer under a condition of its own")

    def at(number: float) -> Course:
        return Course(course.problem, {**course.numbers, letter: number}, course.budget)

    phrase = condition.phrase
    if condition.word in EXTREMES and phrase is not None:
        from rotsolve.confirm.course.over_a_letter import place_of_largest

        return number(place_of_largest(find, said, course, value, scans))
    elif phrase is not None and condition.value is not None:
        goal = course.value(condition.value)
        if goal and sign_untold(phrase, at(said)):
            zero(said, lambda found: value(phrase, at(found)) - abs(goal))
            raise NotConfirmed("which way it points, by which its sign counts")
        zero(said, lambda found: value(phrase, at(found)) - goal)
    elif condition.word in ("sticks", "rolls"):
        verge(find, condition, said, at)
    else:
        raise NotConfirmed(f"a condition that says `{condition.word}`")
    return number(said)


def sign_untold(phrase: Find, course: Course) -> bool:
    """Whether a quantity is told by its size alone: friction that holds, which points as a question counts it."""
    from rotsolve.confirm.course.asked import Asker

    try:
        return Asker(course.problem, course).valued(phrase).sized
    except (LetsGo, Unbalanced):  # only just: rounding decides
        return any(term.path.quantity == "friction_force" for term in phrase.terms)


def zero(said: float, gap: Callable[[float], float]) -> None:
    """The gap changes its sign at the answer; where on one side of it the motion has no such end, it vanishes there from the other."""
    step = NEAR * (abs(said) or 1.0)
    low, high = (gap_or_lost(gap, said + side) for side in (-step, step))
    if not (isinstance(low, float) and isinstance(high, float)):
        return last_held(said, gap, low, high)
    if min(abs(low), abs(high)) <= NONE * max(abs(low), abs(high)):
        raise NotConfirmed("its condition holds with other values too")
    if low * high > 0 and abs(gap(said)) > 1e-3 * min(abs(low), abs(high)):
        raise Broken("its condition does not hold with it")


def gap_or_lost(gap: Callable[[float], float], at: float) -> float | LetsGo | Unbalanced:
    """The gap at a number; what lets go before the state is reached, where something does, or that there is no balance."""
    try:
        return float(gap(at))
    except (LetsGo, Unbalanced) as lost:
        return lost


def last_held(
    said: float, gap: Callable[[float], float], low: float | LetsGo | Unbalanced, high: float | LetsGo | Unbalanced
) -> None:
    """The answer is the last value before something lets go, or gives way: the line through the gap at two places on the side where nothing
    does, which is nearly straight there, vanishes at the answer."""
    if not isinstance(low, float):
        if not isinstance(high, float):
            raise low
        near, side = high, 1.0
    else:
        near, side = low, -1.0
    far = gap(said + 2.0 * side * NEAR * (abs(said) or 1.0))
    if abs(far - near) <= NONE * abs(far):
        raise NotConfirmed("its condition holds with other values too")
    if abs(far - 2.0 * near) > STRAIGHT * abs(far - near):
        raise Broken("its condition does not hold with it")


def verge(find: Find, condition: Condition, said: float, at: Callable[[float], Course]) -> None:
    """It sticks on one side of the answer, and slips on the other."""
    step = NEAR * (abs(said) or 1.0) * (-1.0 if find.modifier != "smallest" else 1.0)
    inside, outside = at(said + step), at(said - step)
    told = []
    for name in inside.names:
        held = grip_holds(condition, inside, name)
        looked_for = held and inside.node(name).settled
        told.append((held, grip_beyond(condition, outside, name, looked_for=looked_for)))
    if (True, False) not in told:
        if len(told) > 1:
            raise NotConfirmed(f"the state at which `{condition.owner}` is to stick")
        if told == [(False, False)] and grip_holds(condition, at(said), inside.names[0]):
            raise NotConfirmed(f"`{condition.owner}` sticks with that value alone")
        beside = "a little less" if step < 0 else "a little more"
        raise Broken(f"`{condition.owner}` {'sticks beyond it' if told[0][0] else f'does not stick with {beside}'}")


def grip_beyond(condition: Condition, course: Course, state: str, *, looked_for: bool) -> bool:
    """The same on the other side, where it does not stick either if nothing holds it wherever it gets to."""
    try:
        return grip_holds(condition, course, state, looked_for=looked_for)
    except Adrift:
        return False


def grip_holds(condition: Condition, course: Course, state: str, *, looked_for: bool = True) -> bool:
    """Whether it sticks at a state; where its place is told, and not `looked_for`, it does not if it is held at another one alone."""
    try:
        at = course.node(state)
        modes = at.moment.modes
        if condition.owner in at.moment.clasped:
            return at.moment.clasped[condition.owner] >= 0.0
    except SlipsOn as reason:
        if reason.owner != condition.owner:
            raise
        return False
    except Unbalanced:
        return False
    found = [mode for name, mode in modes.items() if name == condition.owner or name.startswith(f"{condition.owner}.")]
    if not found:
        raise NotConfirmed(f"`{condition.owner}` does not rub")
    return all(mode == STICKS for mode in found) and (looked_for or not at.settled)
