"""Numbers for the tests that confirm answers: steps in time by Runge and Kutta's method, elimination, and what the solver answers.

The solver is asked only for its answers and, by `given`, for the numbers that a scene states; the physics stands in each test.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from pathlib import Path

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import Formula, Number
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
G = 9.8
STEP = 1e-3
MOST_STEPS = 200_000
State = Sequence[float]
Rate = Callable[[float, State], State]  # how fast a state changes at a time
Gap = Callable[[float, State], float]  # vanishes at the time and state that are looked for
Course = Callable[[float, float, float], float]  # of a time, a place and its speed


def stepped(rate: Rate, time: float, state: State, step: float) -> State:
    """One step of the fourth order."""

    def on(slope: State, part: float) -> State:
        return [value + part * rise for value, rise in zip(state, slope, strict=True)]

    first = rate(time, state)
    second = rate(time + step / 2, on(first, step / 2))
    third = rate(time + step / 2, on(second, step / 2))
    fourth = rate(time + step, on(third, step))
    slopes = zip(state, first, second, third, fourth, strict=True)
    return [value + step * (a + 2 * b + 2 * c + d) / 6 for value, a, b, c, d in slopes]


def until(rate: Rate, state: State, gap: Gap, step: float = STEP) -> tuple[float, State]:
    """The time and state where a gap first closes that is open after the first step, if not before; the last step is cut to fit."""
    time, ahead = 0.0, stepped(rate, 0.0, state, step)
    side = gap(time, state) or gap(step, ahead)
    for _ in range(MOST_STEPS):
        if gap(time + step, ahead) * side <= 0:
            break
        time, state, ahead = time + step, ahead, stepped(rate, time + step, ahead, step)
    else:
        raise AssertionError("the gap does not close")
    part = bisect(lambda cut: -side * gap(time + cut, stepped(rate, time, state, cut)), 0.0, step)
    return time + part, stepped(rate, time, state, part)


def run(rate: Rate, state: State, duration: float, steps: int = 1000) -> State:
    """The state after a time."""
    for number in range(steps):
        state = stepped(rate, number * duration / steps, state, duration / steps)
    return state


def motion(acceleration: Course) -> Rate:
    """The rate of the two numbers place and speed."""
    return lambda time, state: (state[1], acceleration(time, state[0], state[1]))


def reach(
    acceleration: Course, place: float, speed: float, gap: Course, step: float = STEP
) -> tuple[float, float, float]:
    """Time, place and speed where a gap first closes."""
    time, state = until(motion(acceleration), (place, speed), lambda now, at: gap(now, at[0], at[1]), step)
    return time, state[0], state[1]


def linear(rows: Sequence[Sequence[float]]) -> list[float]:
    """Gauss elimination; each row ends with its right side."""
    table = [list(row) for row in rows]
    for k in range(len(table)):
        pivot = max(range(k, len(table)), key=lambda i: abs(table[i][k]))
        table[k], table[pivot] = table[pivot], table[k]
        for i in range(len(table)):
            if i != k:
                factor = table[i][k] / table[k][k]
                table[i] = [a - factor * b for a, b in zip(table[i], table[k], strict=True)]
    return [row[-1] / row[k] for k, row in enumerate(table)]


def bisect(gap: Callable[[float], float], low: float, high: float) -> float:
    """The place between where a growing function passes zero."""
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (low, middle) if gap(middle) > 0 else (middle, high)
    return (low + high) / 2


@cache
def solved(name: str, folder: Path = PROBLEMS, at: str | None = None) -> Solution:
    """A problem, solved once for all tests."""
    (file,) = folder.rglob(f"{name}.yaml")
    return solve(file, at=at)


def numbers(solution: Solution) -> dict[str, float]:
    """All answers that are numbers in SI units, the entries of a vector or matrix by their own names."""
    found = {}
    for name, view in solution.answers.items():
        for part in (view.answer, *view.answer.components):
            if part.value is not None:
                size = 1.0 if part.unit is None else evaluate(part.unit.factor, {}, digits=20).float
                found[name if part is view.answer else f"{name}.{part.name}"] = part.value.float * size
    return found


@cache
def answers(name: str, folder: Path = PROBLEMS, at: str | None = None) -> Mapping[str, float]:
    """The solver's answers to a problem in SI units."""
    return numbers(solved(name, folder, at))


def answer(name: str, find: str, **letters: float) -> float:
    """One answer in SI units, by its formula where the scene leaves letters free."""
    if not letters:
        return answers(name)[find]
    formula = solved(name).answers[find].formula
    assert formula is not None
    places = {letter: Number(Fraction(value)) for letter, value in letters.items()}
    return evaluate(formula, {**values(name), **places}, digits=15).float


def given(name: str, letter: str) -> float:
    """A number that a scene states, in SI units."""
    known = values(name)
    return evaluate(known[letter], known, digits=15).float


def values(name: str) -> dict[str, Formula]:
    return {item.name: item.value for item in solved(name).problem.givens if item.value is not None}
