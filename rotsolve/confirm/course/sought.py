"""Sought: what the value of a letter has to fulfil, as a function of it: the condition of its question, else a line of a state."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.confirm import NotConfirmed, OverBudget
from rotsolve.confirm.course.asked import Asker
from rotsolve.confirm.course.following import Course
from rotsolve.confirm.course.gauges import HOLDS, gauges
from rotsolve.confirm.course.node import Budget
from rotsolve.confirm.course.samples import Numbers
from rotsolve.confirm.course.scan import Reach
from rotsolve.core.letters import letters_of
from rotsolve.core.symbols import PLACES
from rotsolve.language.problem import Condition, Find, Problem, State

BESIDE = 1.01  # another value of the letter, with which a line that tells it does not hold
Gap = Callable[[Course], float]


def reach_of(find: Find, letter: str, problem: Problem, known: Numbers, budget: Budget) -> Reach | None:
    """How far from what is asked or told the scene is, by the value of a letter; None where nothing tells that by itself."""
    condition = find.where
    if condition is None:
        for state, line in lines_told(problem):
            assert line.value is not None
            gap = line_gap(state, line, line.value)
            reach = reaching(letter, without_line(problem, state, line), gap, known, budget)
            here, beside = reach(known[letter]), reach(known[letter] * BESIDE)
            if here is not None and beside is not None and abs(here[0]) < abs(beside[0]) * HOLDS:
                return reach
        return None
    phrase, goal = condition.phrase, condition.value
    if phrase is None or goal is None or condition.word is not None:
        return None
    return reaching(
        letter, problem, lambda course: Asker(problem, course).valued(phrase).number - course.value(goal), known, budget
    )


def reaching(letter: str, problem: Problem, gap: Gap, known: Numbers, budget: Budget) -> Reach:
    """A gap by the value of a letter, with the way in which all moves; None where the scene has no such course."""

    def reach(size: float) -> tuple[float, object] | None:
        course = Course(problem, {**known, letter: size}, budget)
        try:
            value = gap(course)
        except (NotConfirmed, ArithmeticError, ValueError):
            if budget.left < 0:
                raise OverBudget("its motion takes too long to follow") from None
            return None
        return (value, course.way()) if math.isfinite(value) else None

    return reach


def lines_told(problem: Problem) -> Iterator[tuple[State, Condition]]:
    """The lines of states with a number, the last first: what a motion comes to tells more than how it begins."""
    for state in reversed(problem.states):
        for line in reversed(state.conditions):
            if line.path is not None and line.value is not None:
                yield state, line


def place_told(problem: Problem, letter: str) -> State | None:
    """The later state at whose place a letter is told, and told by nothing else; it says how far a motion goes, and not how."""
    for state, line in lines_told(problem):
        placed = line.path is not None and line.path.quantity in PLACES and line.value == Symbol(letter)
        if placed and state is not problem.states[0] and not any(event.to == state.name for event in problem.events):
            rest = replace(without_line(problem, state, line), finds=())
            return None if letter in letters_of(rest) else state
    return None


def stands_at(problem: Problem, letter: str) -> bool:
    """Whether a letter tells a place at which something is in balance, or stands steadily."""
    still = [state for state in problem.states if state.balance or state.steady]
    return any(
        line.path is not None
        and line.path.quantity in PLACES
        and line.value is not None
        and letter in line.value.symbols()
        for state in still
        for line in state.conditions
    )


def without_line(problem: Problem, state: State, line: Condition) -> Problem:
    """The scene in which a state does not tell one of its lines."""
    bare = replace(state, conditions=tuple(one for one in state.conditions if one is not line))
    return replace(problem, states=tuple(bare if one is state else one for one in problem.states))


def line_gap(state: State, line: Condition, told: Formula) -> Gap:
    """How far the state is from a line that it no longer tells."""

    def gap(course: Course) -> float:
        at, before = course.node(state.name), course.names[max(0, course.names.index(state.name) - 1)]
        if line.path is not None and line.path.quantity == "time":
            elapsed = course.time(before, state.name) if before != state.name else at.time
            return elapsed - course.value(told)
        (gauge,) = gauges(replace(state, conditions=(line,)), at.model, course.node(before))
        return gauge.value(at)

    return gap
