"""A letter in the angular velocity of a top that precesses steadily: its smallest or largest value says which motion is meant.

By hand: a top turning rigidly at W about the vertical, M g l = (I3 − I1) W² cos θ.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import Unsolvable, solve

TOP = """up: z
given: {M: 0.5 kg, l: 6 cm, I1: 2.5e-3 kg m^2, I3: 6e-4 kg m^2, W: unknown}
bodies: {top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}}
connections: {floor: {ball: top.tip}}
states: {now: {top.tilt: 110 deg, top.angular_velocity: [0, 0, W], steady: true}}
find: {W: smallest W}
"""
RATE = math.sqrt(0.5 * 9.8 * 0.06 / ((6e-4 - 2.5e-3) * math.cos(math.radians(110))))


@pytest.mark.parametrize(
    ("along", "word", "value"),
    [
        ("W", "smallest", -RATE),
        ("W", "largest", RATE),
        ("-W", "smallest", -RATE),
        ("W + 5 rad/s", "smallest", -RATE - 5),
        ("5 rad/s - W", "largest", RATE + 5),
    ],
)
def test_an_extreme_letter_picks_the_steady_motion(along: str, word: str, value: float) -> None:
    found = solve(TOP.replace("0, W]", f"0, {along}]").replace("smallest", word))
    assert found.answers["W"].float == pytest.approx(value, rel=1e-9)
    assert all(item.holds for item in found.derivation.confirmed)


def test_the_rate_is_the_larger_one_where_a_letter_against_it_is_smallest() -> None:
    assert "the larger of both" in str(solve(TOP.replace("0, W]", "0, -W]")))


@pytest.mark.parametrize("find", ["W: W", "a: smallest W, b: largest W"])
def test_without_one_extreme_nothing_tells(find: str) -> None:
    with pytest.raises(Unsolvable, match="two steady motions are possible"):
        solve(TOP.replace("W: smallest W", find))
