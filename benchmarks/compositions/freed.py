"""Freed: a scene with letters for its numbers. What its answers say at these numbers must be what the scene with numbers answers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import isclose

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.formula import PI, Formula
from rotsolve.core.derivation import Answer, Equality
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.core.letters import Given
from rotsolve.language.problem import Problem
from rotsolve.motion.positive import is_angle
from rotsolve.pipeline import solve_problem

HOLDS = {">": (1,), "≥": (1, 0), "<": (-1,), "≤": (-1, 0), "=": (0,)}
CLOSE = 1e-6
REFUSED = "refused in letters"
Values = Mapping[str, Formula]


def freed(problem: Problem) -> Problem:
    """The problem without the numbers that letters may stand for: positive ones, and acute angles; gravity stays."""
    return replace(
        problem, givens=tuple([replace(item, value=None) if free(item) else item for item in problem.givens])
    )


def free(given: Given) -> bool:
    """Whether the number of a given is one of those that a letter stands for."""
    value = given.value
    if value is None or value.symbols() or given.name == "g":
        return False
    sign = SignOracle({}).by_numbers
    return sign(value) == 1 and (not is_angle(given) or sign(PI / 2 - value) == 1)


def differences(problem: Problem) -> Iterator[str]:
    """Where a scene in letters says something else at the scene's numbers than the scene with its numbers."""
    numbered = answers_of(problem)
    if numbered is None:
        return
    values = problem.values
    try:
        lettered = solve_problem(freed(problem)).derivation
    except (Unsolvable, SceneError) as error:
        yield f"{REFUSED}: {str(error).splitlines()[0]}"
        return
    told = {answer.name: answer for answer in lettered.answers}
    for refusal in lettered.refused:
        yield f"{REFUSED}: {refusal.name}: {refusal.fault.message}"
    more = any(check.more for check in lettered.checks)
    for answer in (one for one in numbered if one.name in told):
        if more and not fitting(told[answer.name], values):
            yield f"{REFUSED}: {answer.name}: its case is not worked out"
        else:
            yield from apart(answer, told[answer.name], values)


def answers_of(problem: Problem) -> tuple[Answer, ...] | None:
    """The answers with numbers; None where there are none, or a check objects to them."""
    try:
        derivation = solve_problem(problem, confirm=False).derivation
    except (Unsolvable, SceneError):
        return None
    return None if any(check.holds is False for check in derivation.checks) else derivation.answers


def fitting(lettered: Answer, values: Values) -> list[Answer]:
    """The branches of an answer whose conditions hold."""
    return [case for case in (lettered, *lettered.otherwise) if all(holds(one, values) for one in case.conditions)]


def apart(numbered: Answer, lettered: Answer, values: Values) -> Iterator[str]:
    """How a branch of an answer whose conditions hold differs from the answer with numbers; there has to be one."""
    found = fitting(lettered, values)
    if not found:
        yield f"{numbered.name}: none of {1 + len(lettered.otherwise)} branches holds"
    for one in found:
        if numbered.word != one.word:
            yield f"{numbered.name}: {one.word} instead of {numbered.word}"
        yield from differing(numbered, one, values)


def differing(numbered: Answer, lettered: Answer, values: Values) -> Iterator[str]:
    """How an answer and its components differ."""
    for one, other in zip(numbered.components, lettered.components, strict=False):
        yield from differing(one, other, values)
    if numbered.value is None or numbered.closed is None or lettered.closed is None:
        return
    factor = None if numbered.unit is None else numbered.unit.factor
    try:
        number = evaluate(lettered.closed if factor is None else lettered.closed / factor, values).float
    except (Undefined, ZeroDivisionError, ValueError) as error:
        yield f"{numbered.name}: {error}"
        return
    expected = numbered.value.float
    if numbered.direction and not (lettered.direction or lettered.positive):  # friction, told by its size
        number, expected = abs(number), abs(expected)
    if not isclose(number, expected, rel_tol=CLOSE, abs_tol=CLOSE * 1e-3):
        yield f"{numbered.name} = {number} instead of {expected}"


def holds(condition: Equality, values: Values) -> bool:
    """Whether a condition holds at some numbers."""
    sign = SignOracle(values).by_numbers(condition.left - condition.right)
    return sign in HOLDS[condition.relation]
