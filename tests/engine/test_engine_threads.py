"""Which way a thread pulls, and on which side it leaves a reel, whatever is declared positive and in whatever order it is written."""

from __future__ import annotations

from itertools import product

import pytest

from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

G, M, SMALL, R = 9.8, 3.0, 2.0, 0.05
SCENE = """title: x
given: {M: 3 kg, m: 2 kg, R: 5 cm}
bodies:
  reel:   {shape: cylinder, mass: M, radius: R, moves: REEL}
  weight: {mass: m, moves: WEIGHT}
connections:
  upper: {string: [ceiling, reel]}
  lower: {string: LOWER}
states: {go: at rest}
find: {T: lower.tension, a: weight.acceleration, T2: upper.tension, b: reel.acceleration}
"""
SENSES = tuple(product(("up", "down"), ("", ", turns: clockwise", ", turns: counterclockwise"), ("up", "down")))
SIGN = {"up": 1, "down": -1}


def solved(lower: str, reel: str = "down", weight: str = "down") -> Solution:
    return solve(SCENE.replace("REEL", reel).replace("WEIGHT", weight).replace("LOWER", lower))


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("travel", "turns", "weight"), SENSES)
@pytest.mark.parametrize(
    "said", ["", ", pulls: {weight: up}", ", pulls: {reel: down}", ", pulls: {weight: up, reel: down}"]
)
def test_a_weight_hangs_from_a_falling_reel(travel: str, turns: str, weight: str, said: str) -> None:
    """Both threads leave on the right: what the reel falls it winds up, so that the weight stays where it is."""
    answers = solved(f"[reel, weight]{said}", travel + turns, weight).answers
    assert answers["T"].float == pytest.approx(SMALL * G)
    assert answers["a"].float == 0
    assert answers["T2"].float == pytest.approx(M * G / 3 + SMALL * G)
    assert answers["b"].float == pytest.approx(-2 * G / 3 * SIGN[travel])


@pytest.mark.parametrize(
    "lower", ["[weight, reel]", "[reel, weight], under: reel", "[weight, reel], pulls: {weight: up}"]
)
def test_a_thread_on_the_other_side_would_push(lower: str) -> None:
    """What the reel falls it unwinds twice: the thread goes slack, which is said."""
    assert any(check.holds is False for check in solved(lower).checks)


@pytest.mark.parametrize(
    ("lower", "named"),
    [
        ("[reel, weight], pulls: {weight: up, reel: up}", "reel|weight"),
        ("[weight, reel], pulls: {weight: down, reel: down}", "reel|weight"),
    ],
)
def test_pulls_that_do_not_go_together_are_refused(lower: str, named: str) -> None:
    with pytest.raises((Unsolvable, SceneError), match=named):
        solved(lower)


def test_no_word_of_pulls_is_dropped() -> None:
    """A reel on a thread from the ceiling is pulled up."""
    with pytest.raises((Unsolvable, SceneError), match="reel"):
        solve(SCENE.replace("[ceiling, reel]", "[ceiling, reel], pulls: {reel: down}").replace("LOWER", "[reel, weight]")
              .replace("REEL", "down").replace("WEIGHT", "down"))  # fmt: skip


@pytest.mark.parametrize("names", [("one", "two"), ("two", "one")])
def test_of_two_reels_the_first_hangs_higher(names: tuple[str, str]) -> None:
    """The lower one unwinds freely, I α = T R and m g − T = m a; Newton's laws of both by hand: threads on the right of the upper, on the
    right of the lower's upper side."""
    upper, lower = names
    text = "title: x\ngiven: {M: 3 kg, R: 5 cm}\nbodies:\n"
    text += "".join(f"  {name}: {{shape: cylinder, mass: M, radius: R, moves: down}}\n" for name in ("one", "two"))
    text += f"connections: {{top: {{string: [ceiling, {upper}]}}, mid: {{string: [{upper}, {lower}]}}}}\nstates: {{go: at rest}}\n"
    answers = solve(
        text + f"find: {{T: mid.tension, S: top.tension, a: {upper}.acceleration, b: {lower}.acceleration}}\n"
    ).answers
    # upper falls a and turns counterclockwise a/R; its right side stands still, so that the lower falls as if hung from the ceiling
    assert answers["b"].float == pytest.approx(2 * G / 3)
    assert answers["a"].float == pytest.approx(2 * G / 3)
    assert answers["T"].float == pytest.approx(M * G / 3)
    assert answers["S"].float == pytest.approx(2 * M * G / 3)
