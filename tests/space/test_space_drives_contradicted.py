"""What a state tells against a drive is said to contradict it, and a state that is never reached is called so for each question."""

from __future__ import annotations

import pytest

from rotsolve import Unsolvable, solve

PLATE = """up: z
given: {M: 1 kg, a: 0.4 m, b: 0.2 mMORE}
bodies: {pl: {shape: rectangle, mass: M, sides: [a, b], points: {A: [-a/2, 0, 0]}}}
connections: {h: {hinge: pl.A, along: y, DRIVE}}
states: {now: {pl.angle: 0 deg, pl.angular_velocity: 2 rad/s}}
find: {FIND}
"""
WHEEL = """up: z
gravity: none
given: {R: 0.2 m, s: 10 rad/s, W: 2 rad/s, m: 1 kg}
bodies: {frame: {mass: 0, points: {O: [0, 0, 0], E: [0.5 m, 0, 0]}}, wheel: {shape: disc, mass: m, radius: R}}
connections:
  post: {hinge: frame.O, along: z, angular_velocity: W}
  axle: {axle: [frame.E, wheel], along: x, angular_velocity: s}
states: {now: {TOLD}}
find: {FIND}
"""


@pytest.mark.parametrize("drive", ["angular_velocity: 5 rad/s", "angle: (3 rad/s)*time"])
@pytest.mark.parametrize("find", ["F: h.force at now", "K: pl.kinetic_energy at now"])
def test_a_rate_against_that_of_a_drive(drive: str, find: str) -> None:
    with pytest.raises(Unsolvable, match="the data contradict each other at `now`"):
        solve(PLATE.replace("MORE", "").replace("DRIVE", drive).replace("FIND", find))


@pytest.mark.parametrize("told", ["wheel.spin: 12 rad/s", "frame.angular_velocity: 3 rad/s"])
@pytest.mark.parametrize("find", ["T: axle.torque in frame axes", "K: wheel.kinetic_energy"])
def test_a_spin_against_that_of_a_motor(told: str, find: str) -> None:
    with pytest.raises(Unsolvable, match="the data contradict each other at `now`"):
        solve(WHEEL.replace("TOLD", told).replace("FIND", find))


def test_the_rate_of_a_drive_that_is_sought_is_tested_by_that_which_a_state_tells() -> None:
    found = solve(PLATE.replace("MORE", ", s: unknown").replace("DRIVE", "angular_velocity: s").replace("FIND", "s: s"))
    assert found.answers["s"].float == 2.0
    assert [item.holds for item in found.derivation.confirmed] == [True]


def test_each_question_is_refused_where_its_state_is_never_reached() -> None:
    text = """up: z
given: {M: 2 kg, a: 0.4 m, b: 0.2 m}
bodies: {pl: {shape: rectangle, mass: M, sides: [a, b], points: {A: [-a/2, 0, 0]}}}
connections: {h: {hinge: pl.A, along: y}}
states: {low: {pl.angle: 90 deg, balance: true}, high: {pl.angle: -90 deg, at rest: all}}
find: {l1: pl.stability at low, F: h.force at high}
"""
    (refusal,) = solve(text).derivation.refused
    assert refusal.name == "F"
    assert refusal.fault.message == "`high` is never reached from `low`"
