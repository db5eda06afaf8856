"""Overtold: where data contradict each other, which line of a state does not go with all else that is told, and what would.

It is tried before it is printed: with a letter in its place the scene has an answer for what it tells, which an assembly of all bodies'
equations confirms.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from itertools import islice

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.balls import RealBalls, Undefined
from rotsolve.algebra.effort import Exhausted
from rotsolve.algebra.formula import ZERO, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.dimension import ANGLE
from rotsolve.algebra.units.quantities import number_in_unit
from rotsolve.algebra.units.unit_table import UNITS, Unit
from rotsolve.core.faults import CONTRADICTORY, Fault, SceneError, Span, Unsolvable
from rotsolve.core.letters import Given
from rotsolve.core.quantity import QUANTITIES
from rotsolve.language.problem import Condition, Find, Path, Problem, State
from rotsolve.paths.meaning import NotYet, path_text
from rotsolve.solution import Solution
from rotsolve.solution.answer import AnswerView

TRIED = 6  # lines without which a scene is looked at: each is a scene to be solved
ALIKE = 1e-9  # of two numbers that are the same, beside their size
Solve = Callable[[Problem], Solution]


class StatedQuantity(Struct, frozen=True):
    """What a state tells of one quantity: a line, or three of a vector."""

    state: State
    lines: tuple[Condition, ...]

    @property
    def path(self) -> Path:
        """The quantity as a whole."""
        path = self.lines[0].path
        assert path is not None
        return replace(path, component=None) if len(self.lines) > 1 else path

    def told_as(self, problem: Problem, lines: tuple[Condition, ...]) -> tuple[State, ...]:
        """The states of a problem with other lines in its place."""
        told = dict(zip(self.lines, lines, strict=True))
        own = replace(self.state, conditions=tuple(told.get(line, line) for line in self.state.conditions))
        return tuple(own if state is self.state else state for state in problem.states)


def overtold(fault: Fault, problem: Problem, solve: Solve) -> Fault | None:
    """A contradiction with which line of a state does not go with all else, and what would; None where no one line is to blame.

    Of a state before the one that is blamed nothing is said: what comes later does not tell what was.
    """
    blamed = next((state for state in problem.states if fault.span in spans_told(state)), None)
    later = problem.states if blamed is None else problem.states[problem.states.index(blamed) :]
    for told in islice((told for told in told_numbers(problem) if told.state in later), TRIED):
        if help := what_else_makes(told, problem, solve):
            right = fault.kind != CONTRADICTORY or fault.span in spans_told(told.state)
            return replace(fault if right else blamed_at(fault, told), help=help)
    return None


def blamed_at(fault: Fault, told: StatedQuantity) -> Fault:
    """A contradiction at the line that does not go with all else."""
    return replace(fault, message=f"the data contradict each other at `{told.state.name}`", span=told.lines[0].span)


def spans_told(state: State) -> list[Span | None]:
    """The places in the file at which something of a state is told."""
    return [state.span, *(line.span for line in state.conditions)]


def told_numbers(problem: Problem) -> Iterator[StatedQuantity]:
    """What states tell of quantities by numbers, the last state first; of one state times at last."""
    for state in reversed(problem.states):
        groups: dict[tuple[str, ...], list[Condition]] = {}
        for line in state.conditions:
            if line.path is None or line.value is None or line.word or line.value.symbols() & problem.sought:
                continue
            named = path_text(replace(line.path, component=None) if line.whole else line.path)
            groups.setdefault((named, line.axes, line.relative), []).append(line)
        found = [StatedQuantity(state, tuple(lines)) for lines in groups.values()]
        found.reverse()
        yield from sorted(found, key=lambda told: told.path.quantity == "time")


def what_else_makes(told: StatedQuantity, problem: Problem, solve: Solve) -> str:
    """What all else that is told makes of a quantity; '' where that is no number, or the one that is told."""
    if told.path.quantity == "time":
        return ""
    letters = tuple(letter_in_place(f"told_{place + 1}", line, problem) for place, line in enumerate(told.lines))
    lines = tuple(replace(line, value=Symbol(letter.name)) for line, letter in zip(told.lines, letters, strict=True))
    finds = tuple(Find(letter.name, Symbol(letter.name), (), unit=letter.unit) for letter in letters)
    givens = (*problem.givens, *letters)
    trial = replace(problem, givens=givens, states=told.told_as(problem, lines), finds=finds)
    answers = {answer.name: answer for answer in confirmed_answers(trial, solve)}
    for letter, line in zip(letters, told.lines, strict=True):
        own, answer = number_told(line, problem), answers.get(letter.name)
        if own is None or answer is None or answer.float is None or answer.value is None:
            return ""
        unit = answer.answer.unit
        size = answer.float * (1.0 if unit is None else float(unit.scale) * math.pi**unit.pi_power)
        if abs(size - own) > ALIKE * max(abs(own), abs(size)):
            return would_be(line, answer, told.state.name, problem)
    return ""


def would_be(line: Condition, answer: AnswerView, state: str, problem: Problem) -> str:
    """What a quantity would be, beside what is told of it, in words."""
    assert line.path is not None
    would = f"{answer.value}{'' if answer.unit == '°' else ' '}{answer.unit}".strip().replace("-", "−")
    along = "" if not line.axes else f" in {line.axes} axes"
    at = f" at `{state}`" if state else ""
    return (
        f"by all else that is told `{path_text(line.path)}`{along} would be {would}{at}, not {text_told(line, problem)}"
    )


def letter_in_place(name: str, line: Condition, problem: Problem) -> Given:
    """An unknown letter in place of what a line tells, in its unit."""
    assert line.path is not None
    dimension = QUANTITIES[line.path.quantity].dimension
    return Given(name, None, dimension, unit_told(line, problem), "unknown", asked=True, automatic=True)


def unit_told(line: Condition, problem: Problem) -> Unit | None:
    """The unit in which a line tells a quantity: that of its given; of an angle that is a number degrees."""
    given = given_of(line, problem)
    number = line.value is not None and not line.value.symbols()
    assert line.path is not None
    angle = number and QUANTITIES[line.path.quantity].dimension == ANGLE
    return UNITS["deg"] if angle else None if given is None else given.unit


def given_of(line: Condition, problem: Problem) -> Given | None:
    """The given that a line tells: also a number that is written in place is one."""
    return next((given for given in problem.givens if line.value == Symbol(given.name)), None)


def text_told(line: Condition, problem: Problem) -> str:
    """What a line tells, as it is written."""
    given, unit, value = given_of(line, problem), unit_told(line, problem), line.value or ZERO
    if given is not None and given.value is not None and not given.value.symbols():
        return given.text
    if unit is None or value.symbols():
        return to_text(value)
    return f"{to_text(number_in_unit(value, unit))}{'' if unit.text == '°' else ' '}{unit.text}"


def number_told(line: Condition, problem: Problem) -> float | None:
    """The number in SI units that a line tells; None where a letter has none."""
    values = {given.name: given.value for given in problem.givens if given.value is not None}
    try:
        return float(RealBalls(values)(line.value or ZERO).mid())
    except (Undefined, KeyError, ArithmeticError, ValueError):
        return None


def confirmed_answers(problem: Problem, solve: Solve) -> Iterator[AnswerView]:
    """The answers to a problem that its assembly confirms; nothing of one that has none, or takes long."""
    try:
        solution = solve(problem)
        told = solution.trace.confirmation() if solution.trace.confirmation is not None else ()
    except (NotYet, Unsolvable, SceneError, Exhausted, ArithmeticError, ValueError):
        return
    fit = {verdict.name for verdict in told if verdict.holds}
    if all(check.holds is not False for check in solution.derivation.checks):
        yield from (AnswerView(answer) for answer in solution.derivation.answers if answer.name in fit)
