"""Regions: where in the space of a scene's letters each case of its answers holds, and the points at which formulas are compared there.

Letters without a number are positive there, and angles acute, as they are where the answers are printed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from msgspec import Struct

from rotsolve.algebra.formula import Formula
from rotsolve.confirm.course.samples import Numbers, holding, holds, takes_integral, with_givens
from rotsolve.core.derivation import Answer, Equality
from rotsolve.core.symbols import TIME
from rotsolve.grading.comparing.equality import (
    QUARTER,
    FreeLetter,
    Point,
    Region,
    SampledRegion,
    free_letter_of,
    told_by_letters,
)
from rotsolve.motion.limits import limits_of_scene
from rotsolve.motion.positive import is_angle
from rotsolve.pipeline import made_ready
from rotsolve.solution import Solution


class CaseRegion(Struct, frozen=True):
    """Where the same cases of all answers hold: these answers, all their conditions, and some numbers of that kind."""

    answers: tuple[Answer, ...]
    conditions: tuple[Equality, ...]
    numbers: Numbers


def case_regions(solution: Solution) -> list[CaseRegion]:
    """A region for each combination of cases that occurs among the numbers with which the answers were found.

    What holds on an edge alone, `0 if u = v`, is asked of nobody: there many a wrong formula is right.
    """
    found: dict[tuple[int, ...], CaseRegion] = {}
    for start in solution.trace.points:
        numbers = with_givens(solution.problem, {name: float(size) for name, size in start.items()})
        held = [case for answer in solution.derivation.answers if (case := holding(answer, numbers)) is not None]
        conditions = dict.fromkeys(condition for case in held for condition in case.conditions)
        found.setdefault(tuple(map(id, held)), CaseRegion(tuple(held), tuple(conditions), numbers))
    return list(found.values())


def sampled(case: CaseRegion, solution: Solution) -> SampledRegion:
    """A region with its points, all of which lie in it."""
    problem, valid = solution.problem, solution.trace.validity() if solution.trace.validity is not None else None
    givens = {given.name: given for given in problem.givens}
    open_ = {name: size for name, size in case.numbers.items() if name not in givens or givens[name].value is None}
    acute = {name for name in open_ if name in givens and is_angle(givens[name])}
    positive = frozenset(open_.keys() - acute | {TIME}) | (valid.positive if valid is not None else frozenset())
    told = told_by_letters(problem, case.answers)
    letters = [free_letter_of(given, problem.values, positive) for given in problem.givens if given.value is not None]
    for name, size in {TIME: 1.0, **open_}.items():
        quadrant = (0.0, QUARTER) if name in acute else None
        letters.append(FreeLetter(name, size, signed=False, known=False, order=None, quadrant=quadrant))
    free = tuple(letter for letter in letters if letter.name not in told)
    known = {letter.name for letter in free} | told.keys()
    bounds = (*gaps_of_conditions(case.conditions), *(limit.gap for limit in limits_of_scene(made_ready(problem)[1])))
    domain = SampledRegion(
        Region(free, told, positive, tuple(one for one in bounds if one.symbols() <= known)), own=True
    )
    slow = [condition for condition in case.conditions if takes_integral(condition)]
    domain.points = tuple(point for point in domain.points if all(holds(one, floats(point)) for one in slow))
    return domain


def gaps_of_conditions(conditions: Iterable[Equality]) -> Iterator[Formula]:
    """What is not negative where conditions hold; of those with an integral nothing, which takes long."""
    for one in conditions:
        if one.relation in "<>≤≥" and not takes_integral(one):
            yield one.left - one.right if one.relation in ">≥" else one.right - one.left


def floats(point: Point) -> Numbers:
    """The values of letters at a point, roughly."""
    return {name: float(ball.mid()) for name, ball in point.items()}
