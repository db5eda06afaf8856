"""Questions stand alone: each asked alone is answered as beside all others; one without an answer takes no other with it."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import equal
from rotsolve.core.faults import Unsolvable
from rotsolve.language.problem import Find, Problem
from rotsolve.pipeline import solve, solve_problem
from rotsolve.scene.read import read_file
from rotsolve.solution.answer import AnswerView
from solutions import solved

ROOT = Path(__file__).resolve().parents[2]
FILES = sorted((ROOT / "problems").rglob("*.yaml"))
CRANES = """
title: Three machines side by side, of which one is not told well enough
given: {m: 2 kg, R: 10 cm, k: unknown}
bodies:
  disc: {shape: disc, mass: m, radius: R}
  load: {mass: 3 kg, moves: down}
  rod:  {shape: rod, mass: 1 kg, length: 50 cm}
  beam: {shape: rod, mass: 1 kg, length: 50 cm}
connections: {axle: {axle: disc}, cord: {string: [disc, load]}, pin: {hinge: rod.start}, post: {hinge: beam.start}}
states: {go: {at rest: all, beam.angle: 0}}
find:
"""


def speaks_of(find: Find) -> set[str]:
    """The letters in a question, in its condition and in its options."""
    found = set(find.formula.symbols())
    if find.where is not None:
        found |= find.where.value.symbols() if find.where.value is not None else set()
        found |= speaks_of(find.where.phrase) if find.where.phrase is not None else set()
    if find.choice is not None:
        sides = [side for option in find.choice.options for side in option.sides]
        for side in (*sides, *([find.choice.bound] if find.choice.bound is not None else [])):
            found |= speaks_of(side)
    return found


def needed(problem: Problem, find: Find) -> frozenset[str]:
    """The questions that belong to one: itself, those that it names, and those whose conditions settle an unknown letter."""
    asked = {given.name for given in problem.givens if given.asked}
    finds = {item.name: item for item in problem.finds}
    names = {
        find.name,
        *(item.name for item in problem.finds if item.where is not None and item.formula.symbols() & asked),
    }
    while more := {name for own in names for name in speaks_of(finds[own]) if name in finds} - names:
        names |= more
    return frozenset(names)


def parts(answer: AnswerView) -> list[AnswerView]:
    return [answer, *answer.components.values()]


def same(one: AnswerView, other: AnswerView, letters: frozenset[str]) -> bool:
    """Whether two answers say the same: the same number, else the same form."""
    if one.float is None or other.float is None:
        forms = (one.answer.closed, other.answer.closed)
        alike = forms[0] == forms[1] or (None not in forms and equal(*forms, letters))  # type: ignore[arg-type]
        return alike and one.float == other.float and one.word == other.word
    return math.isclose(one.float, other.float, rel_tol=1e-9, abs_tol=1e-12)


@pytest.mark.sampled(9)
@pytest.mark.parametrize("problem_file", FILES, ids=[file.stem for file in FILES])
def test_each_question_alone_is_as_beside_the_others(problem_file: Path) -> None:
    """Those beside the others are confirmed by the assembly, so that what is the same alone needs no other confirmation."""
    problem = read_file(problem_file)
    together = solved(problem_file).complete()
    letters = frozenset(given.name for given in problem.givens)
    for find in problem.finds:
        names = needed(problem, find)
        if len(names) == len(problem.finds):
            continue
        own = tuple(item for item in problem.finds if item.name in names)
        alone = solve_problem(replace(problem, finds=own), confirm=False).complete().answers[find.name]
        for one, other in zip(parts(alone), parts(together.answers[find.name]), strict=True):
            assert same(one, other, letters), f"{find.name}: alone {one}, beside the others {other}"


@pytest.mark.parametrize("order", [(0, 1, 2), (2, 0, 1), (1, 2, 0)])
def test_a_question_without_an_answer_takes_no_other_with_it(order: tuple[int, ...]) -> None:
    lines = ["p: rod.angular_acceleration at go", "a: load.acceleration", "q: beam.angular_acceleration"]
    solution = solve(CRANES + "\n".join(f"  {lines[place]}" for place in order))
    assert list(solution.answers) == [name for name in (lines[place][0] for place in order) if name != "p"]
    assert solution.answers["a"].value == "7.35"
    assert solution.answers["q"].value == "-29.4"
    reason = solution.refused["p"].fault
    assert "`p`" in reason.message and reason.span is not None
    assert reason.span.line == CRANES.count("\n") + order.index(0) + 1
    with pytest.raises(Unsolvable, match="`p`"):
        solution.complete()


def test_what_a_question_alone_speaks_of_is_refused_alone() -> None:
    """Swings that are not there, a function of time of what never moves: faults of the scene's equations, not only of a search."""
    finds = "  T: period of small swings of load\n  a: load.acceleration\n"
    solution = solve(CRANES + finds)
    assert list(solution.answers) == ["a"] and list(solution.refused) == ["T"]


def test_where_nothing_has_an_answer_the_first_reason_is_told() -> None:
    with pytest.raises(Unsolvable, match="`p`"):
        solve(CRANES + "  p: rod.angular_acceleration\n  F: pin.force\n")
