"""How much of a derivation a page tells, and how many numbers."""

from __future__ import annotations

import pytest

from rotsolve import Solution, solve

SCENE = """
title: Ball on a slope
given: {m: 2 kg, R: 0.1 m, b: 30 deg}
surfaces: {ramp: {slope: b}}
bodies: {ball: {shape: sphere, mass: m, radius: R, moves: down}}
connections: {grip: {rolls: [ball, ramp]}}
find: {a: ball.acceleration, f: grip.friction_force}
"""


@pytest.fixture(scope="module")
def solution() -> Solution:
    return solve(SCENE)


def test_brief_is_laws_and_answers(solution: Solution) -> None:
    page = solution.to("text", detail="brief")
    assert "Laws" in page and "a = 5 g sin b/7" in page and "Checks" in page
    assert not any(word in page for word in ("Plan", "Forces", "Solve", "Put "))


def test_full_has_the_way_of_each_law_that_gives_the_same(solution: Solution) -> None:
    page = solution.to("text", detail="full")
    assert "energy gives the same a" in page and "The same by energy" in page
    way = page.split("The same by energy")[1]
    assert "power and kinetic energy" in way and "a = 5 g sin b/7" in way
    assert "The same by" not in solution.to("text")


def test_numbers_stand_where_they_are_wanted(solution: Solution) -> None:
    steps, results, none = (
        " ".join(solution.to("text", numbers=kind).split()) for kind in ("steps", "results", "none")
    )
    assert "5·9.8·0.5/7 m/s² = 3.5 m/s²" in steps
    assert "9.8·" not in results and "a = 5 g sin b/7 = 3.5 m/s²" in results
    assert "3.5" not in none and "a = 5 g sin b/7, down the slope" in none


def test_an_answer_without_a_formula_keeps_its_number() -> None:
    scene = SCENE.replace("find: {", "find: {k: 2 + 3, ")
    assert "k = 5" in solve(scene).to("text", numbers="none")


def test_other_words_are_refused(solution: Solution) -> None:
    for told in ({"detail": "long"}, {"numbers": "all"}):
        with pytest.raises(ValueError, match="one of"):
            solution.to("text", **told)
