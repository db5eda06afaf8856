"""Consistency: whether everything that the laws write holds at the answers, also what no plan used.

A scene that says too much (a state that is never reached, a block that sticks yet is said to fall) shows here.
"""

from __future__ import annotations

from fractions import Fraction
from math import isfinite

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.formula import ONE, ZERO, Formula, Integral, Number, Symbol
from rotsolve.core.equation import Equation
from rotsolve.core.registry import SEPARATOR
from rotsolve.core.varying import POSITION, RATE, at_any_time
from rotsolve.inquiry.inquiry import Inquiry
from rotsolve.motion.timeline import Interval

TOLERANCE = 1e-6  # data of a few figures may disagree in the last ones
ROUNDS = 8
ALONG_THE_WAY = ("separating the variables, dt = dx/v", "separating the variables, dt = dθ/ω")
POINTS = (Fraction(0), Fraction(1), Fraction(2))


def contradiction(inquiry: Inquiry) -> Equation | None:
    """The first equation that can not hold with what is known and found, or None."""
    numbers = known_numbers(inquiry)
    pending = [equation for equation in inquiry.history.equations if not runs(equation, inquiry)]
    pending += summed(inquiry)
    pending.sort(key=lambda equation: bool(equation.family))  # a rule that is broken says more than a law
    for _ in range(ROUNDS):
        rest = []
        for equation in pending:
            if open_letters(equation, numbers):
                rest.append(equation)
            elif clashes(equation, inquiry, numbers):
                return equation
        pending, settled = [], len(numbers)
        for equation in rest:
            unknown = open_letters(equation, numbers)
            if len(unknown) == 1:
                if impossible(equation, unknown[0], inquiry, numbers):
                    return equation
                settle(equation, unknown[0], inquiry, numbers)
            pending.append(equation)
        if len(numbers) == settled:
            break
    return backwards(inquiry, numbers)


def summed(inquiry: Inquiry) -> list[Equation]:
    """The separated equations carried out with the acceleration that Newton's laws give at any speed, where they have a closed form."""
    found = []
    for name, passage in inquiry.history.passages.items():
        for travel in passage.travels:
            rate = travel.acceleration
            if not (travel.leads and travel.pace == RATE and isinstance(rate, Symbol)):
                continue
            value = inquiry.aside(rate.name)
            for equation in inquiry.history.equations if value is not None else ():
                if equation.section == name and rate.name in equation.summed():
                    found += carried_out(equation.renamed({rate.name: value}), inquiry)  # type: ignore[dict-item]
    return found


def carried_out(equation: Equation, inquiry: Inquiry) -> list[Equation]:
    """An equation with its integrals carried out; nothing where that can not be done, or never comes to an end."""
    try:
        left, right = (inquiry.solver.carried_out(side) for side in (equation.left, equation.right))
    except Undefined:
        return []
    done = replace(equation, left=left, right=right)
    return [] if done.summed() else [done]


def backwards(inquiry: Inquiry, numbers: dict[str, Formula]) -> Equation | None:
    """A phase that would take a negative time: its end lies before its start."""
    for name, passage in inquiry.history.passages.items():
        letters = passage.duration.symbols()
        duration = size(passage.duration.substitute(numbers), inquiry) if letters <= numbers.keys() else None
        if duration is not None and duration < -TOLERANCE:
            return Equation(passage.duration, ZERO, "time runs forwards", name)
    return None


def turned_back(inquiry: Inquiry) -> Interval | None:
    """A phase whose time is summed along the way although the motion turns back in it."""
    used = {index for answered in inquiry.answered for index in answered.used}
    timed = {
        law.section for law in (inquiry.planner.pool[index] for index in used) if law.label.startswith(ALONG_THE_WAY)
    }
    for name, passage in inquiry.history.passages.items():
        for travel in passage.travels if name in timed else ():
            if travel.leads and travel.pace == POSITION:
                aside = inquiry.apart()
                speeds = [aside.settled(value) for value in (travel.before, travel.after)]
                sizes = [aside.number(speed) if speed is not None else None for speed in speeds]
                if sizes[0] is not None and sizes[1] is not None and sizes[0] * sizes[1] < 0:
                    return inquiry.history.arrangement.timeline.interval(name)
    return None


def open_letters(equation: Equation, numbers: dict[str, Formula]) -> list[str]:
    """Letters of the laws in an equation that have no value yet."""
    return sorted(name for name in equation.symbols() if SEPARATOR in name and name not in numbers)


def runs(equation: Equation, inquiry: Inquiry) -> bool:
    """Whether an equation is about any moment of a phase, or sums over one."""
    sides = (equation.left, equation.right)
    letters = equation.symbols()
    return bool(inquiry.running & letters) or at_any_time(letters) or any(side.holds(Integral) for side in sides)


def known_numbers(inquiry: Inquiry) -> dict[str, Formula]:
    """Values of the letters that the inquiry found, in closed form, also on the way to the answers."""
    solver = inquiry.solver
    known = {name: found.formula for name, found in solver.solved.items() if found.formula is not None}
    for name in solver.told.keys() - known.keys():
        value = solver.with_found(Symbol(name))
        if not any(SEPARATOR in letter for letter in value.symbols()):
            known[name] = value
    return known


def impossible(equation: Equation, name: str, inquiry: Inquiry, numbers: dict[str, Formula]) -> bool:
    """Whether the one unknown of an equation drops out and leaves two numbers that differ: 2 rad = 0 · t."""
    values = [{**numbers, name: Number(point)} for point in POINTS[1:]]
    gaps = [size((equation.left - equation.right).substitute(value), inquiry) for value in values]
    if gaps[0] is None or gaps[1] is None or abs(gaps[0] - gaps[1]) > 1e-12 * abs(gaps[0]):
        return False
    return clashes(equation, inquiry, values[0])


def settle(equation: Equation, name: str, inquiry: Inquiry, numbers: dict[str, Formula]) -> bool:
    """Find the one unknown of an equation that is linear in it; whether that could be done."""
    gap = equation.left - equation.right
    at = [size(gap.substitute({**numbers, name: Number(value)}), inquiry) for value in POINTS]
    if at[0] is None or at[1] is None or at[2] is None:
        return False
    slope = at[1] - at[0]
    if not slope or abs(at[2] - at[0] - 2 * slope) > 1e-9 * (abs(at[2]) + abs(at[0]) + abs(slope)):
        return False
    value = -at[0] / slope
    if not isfinite(value):
        return False
    numbers[name] = exact(value)
    return True


def clashes(equation: Equation, inquiry: Inquiry, numbers: dict[str, Formula]) -> bool:
    """Whether both sides are numbers that differ."""
    left, right = (size(side.substitute(numbers), inquiry) for side in (equation.left, equation.right))
    if left is None or right is None:
        return False
    gap = abs(left - right)
    if gap <= TOLERANCE * max(abs(left), abs(right)):
        return False
    return gap > TOLERANCE * max((abs(term) for term in terms(equation, inquiry, numbers)), default=1e-300)


def terms(equation: Equation, inquiry: Inquiry, numbers: dict[str, Formula]) -> list[float]:
    """Sizes of the single terms, against which a difference is measured."""
    found = [
        size(term.substitute(numbers), inquiry) for side in (equation.left, equation.right) for term in side.children()
    ]
    return [value for value in found if value is not None]


def size(value: Formula, inquiry: Inquiry) -> float | None:
    """A number, None where it has letters of the laws or is not real; givens without a number are taken as 1."""
    names = value.symbols() - set(inquiry.values)
    if not all(name in inquiry.givens and not inquiry.givens[name].asked for name in names):
        return None
    try:
        return evaluate(value, {**inquiry.values, **dict.fromkeys(names, ONE)}, digits=10).float
    except (Undefined, ValueError, ZeroDivisionError):
        return None


def exact(value: float) -> Formula:
    return Number(Fraction(value))
