"""One physics: every law gives the same answers, and declaring the other sense positive changes no motion."""

from __future__ import annotations

import random
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import pytest
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.equation import FAMILIES
from rotsolve.core.faults import Unsolvable
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Body, Problem
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.owndata import is_own
from rotsolve.pipeline import solve_problem
from rotsolve.search.answering import answer
from rotsolve.search.friction import decide
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search

ProblemOf = Callable[[Path], Problem]
PAIRS = (("left", "right"), ("up", "down"), ("clockwise", "counterclockwise"))
OPPOSITE = {one: other for pair in PAIRS for one, other in (pair, pair[::-1])}
BY_ENERGY = {  # scenes in which energy, asked for, must answer something
    "axle-friction-torque", "belt-crossed", "belt-plain", "contact-ladder", "gear-inside", "gear-plain", "hinge-rod-at-end",
    "hinge-rod-falls", "rolls-down-in-two-states", "rolls-slope-left-down", "rolls-spool-pulled", "spring-level",
    "spring-on-disc-and-block", "string-atwood-heavy", "string-atwood-light", "string-block-drops", "string-block-on-disc",
    "string-chain-of-three", "string-level-pulley-hanging", "string-moving-pulley", "string-roller-axle-and-block",
    "string-slope-left", "string-stepped-drum", "string-yoyo", "torsion-disc", "weld-bob-on-rod",
    "contact-dome-pushed", "rolls-slide-into-loop",
}  # fmt: skip
BY_ANGULAR_MOMENTUM = {
    "axle-friction-torque", "event-blow-on-hanging-rod", "event-bounce-on-rod", "event-discs-joined", "event-putty-on-beam",
    "event-fixes-rod", "event-grips-step",
    "hinge-rod-at-end", "rides-beads", "rides-one-on-disc", "rolls-slope-left-down",
    "string-atwood-heavy", "string-block-on-disc", "string-level-pulley-hanging",
    "string-slope-left", "string-stepped-drum", "string-yoyo",
}  # fmt: skip


def answers(problem: Problem, law: str | None) -> dict[str, Formula]:
    """The closed forms of all questions that a law can answer, with Newton's help where that is given."""
    configuration = Configuration(problem)
    search = Search(
        SceneEquations(configuration, decide(configuration).modes), families_for(law), spare=law is not None
    )
    for find in problem.finds:
        with suppress(Unsolvable):
            answer(search, find)
    return closed_forms(search)


def closed_forms(search: Search) -> dict[str, Formula]:
    found = {item.asked.find.name: item.found.formula for item in search.answered if not item.aside}
    return {name: formula for name, formula in found.items() if formula is not None}


@pytest.mark.sampled(3)
def test_all_laws_give_the_same_answers(
    scene: Path,
    problem_of: ProblemOf,
    search_of: Callable[..., Search],
    number: Callable[..., float],
    nearby: Callable[[Problem, random.Random], dict[str, float]],
) -> None:
    """Those of the bundled problems are held against what was published, law by law, in tests/problems."""
    problem = problem_of(scene)
    plain = closed_forms(search_of(scene))
    values = nearby(problem, random.Random(1))
    for law in FAMILIES:
        for name, formula in answers(problem, law).items():
            assert name in plain, f"only by {law}: {name} = {to_text(formula)}"
            if not (formula.symbols() | plain[name].symbols()) <= set(values):
                continue  # by way of an answer that has a number only
            same = equal(formula, plain[name]) or near(number(formula, values), number(plain[name], values))
            assert same, f"{name} by {law}: {to_text(formula)}; by the shortest way: {to_text(plain[name])}"


def near(one: float, other: float) -> bool:
    return abs(one - other) <= 1e-9 * max(1.0, abs(one), abs(other))


def unanswered(path: Path, law: str, problem_of: ProblemOf) -> str:
    """Why a law does not answer all that a scene asks; '' where it does and has a part in it."""
    try:
        solve_problem(problem_of(path), law=law, confirm=False)
    except Unsolvable as error:
        return f"{path.stem}: {error}"
    return ""


@pytest.mark.parametrize("name", sorted(BY_ENERGY))
def test_energy_serves_where_it_must(name: str, scenes: list[Path], problem_of: ProblemOf) -> None:
    assert not unanswered(scenes[0].with_stem(name), "energy", problem_of)


@pytest.mark.parametrize("name", sorted(BY_ANGULAR_MOMENTUM))
def test_angular_momentum_serves_where_it_must(name: str, scenes: list[Path], problem_of: ProblemOf) -> None:
    assert not unanswered(scenes[0].with_stem(name), "angular-momentum", problem_of)


@pytest.mark.sampled(3)
def test_newton_serves_every_scene_without_events(scene: Path, problem_of: ProblemOf) -> None:
    problem = problem_of(scene)
    stored = any(item.word in ("spring", "drapes") for item in problem.connections) and len(problem.states) > 1
    unknown = any(surface.word == "profile unknown" for surface in problem.surfaces)
    names = {body.name for body in problem.bodies}
    inner = any(is_own(line, names) for state in problem.states for line in state.conditions)
    if not problem.events and not stored and not unknown and not inner:  # sums over the way are left to other laws
        assert not unanswered(scene, "newton", problem_of)


# declared senses


def signed_in_words(problem: Problem) -> bool:
    """Whether the scene says something that counts along a declared sense, so that turning it round would change the scene."""
    along = any(getattr(item, "direction", "") is None for item in (*problem.actions, *problem.events))
    driven = any(getattr(item, "angular_acceleration", None) is not None for item in problem.connections)
    lines = [line for state in problem.states for line in state.conditions if not line.rest]
    return (
        along or driven or any(line.path is None or line.path.quantity not in ("angle", "elongation") for line in lines)
    )


def turned_round(body: Body, index: int, which: int) -> Body:
    """A body with the other sense declared positive, of its travel or its turning, for some of the bodies."""
    if which & 1 and index % 2 == 0 and body.moves:
        body = replace(body, moves=OPPOSITE[body.moves])
    if which & 2 and index % 2 == 1 and body.moves:
        body = replace(body, moves=OPPOSITE[body.moves])
    if which & 4 and body.turns:
        body = replace(body, turns=OPPOSITE[body.turns])
    return body


@pytest.mark.sampled(3)
@pytest.mark.parametrize("which", [1, 6])
def test_declared_senses_change_no_motion(scene: Path, which: int, problem_of: ProblemOf) -> None:
    problem = problem_of(scene)
    bodies = tuple(turned_round(body, index, which) for index, body in enumerate(problem.bodies))
    if signed_in_words(problem) or bodies == problem.bodies:
        return  # nothing to turn round
    before = solve_problem(problem, confirm=False).derivation.answers
    after = solve_problem(replace(problem, bodies=bodies), confirm=False).derivation.answers
    for one, other in zip(before, after, strict=True):
        assert one.value is not None and other.value is not None
        assert one.direction == other.direction, f"{one.name}: {one.direction}, then {other.direction}"
        sizes = [value.float if one.direction == "" else abs(value.float) for value in (one.value, other.value)]
        assert near(*sizes), f"{one.name}: {sizes[0]}, then {sizes[1]} {other.direction}"
