"""The angle of a vector at one state from one at another: both are read where they are asked, in the derivation and in the assembly."""

from __future__ import annotations

from math import atan2, degrees

import pytest

from rotsolve import solve

GATE = """up: z
gravity: none
given: {w: 2 rad/s, T: 0.4 s}
bodies: {one: {shape: cuboid, mass: 3 kg, sides: [60 cm, 40 cm, 20 cm]}}
connections: {joint: {hinge: one.center, along: z}}
states: {now: {one.angle: 20 deg, one.angular_velocity: w}, later: {time: T}}
find: {d: FIND}
"""
BLOW = """up: z
gravity: none
given: {m: 2 kg, u: 3 m/s, J: 4 N s}
bodies: {ball: {shape: sphere, mass: m, radius: 10 cm}}
states: {before: {ball.velocity: [u, 0, 0], ball.angular_velocity: [0, 0, 1 rad/s]}, after: {}}
events: {hit: {impulse: J, on: ball.center, direction: y, from: before, to: after}}
find: {d: angle of ball.velocity at after from ball.velocity at before in deg}
"""
CASES = {
    "an axis from itself": (
        GATE.replace("FIND", "angle of one.x_axis at later from one.x_axis at now in deg"),
        degrees(0.8),
    ),
    "the other way round": (
        GATE.replace("FIND", "angle of one.x_axis at now from one.x_axis at later in deg"),
        degrees(0.8),
    ),
    "another axis": (
        GATE.replace("FIND", "angle of one.y_axis at later from one.x_axis at now in deg"),
        90 + degrees(0.8),
    ),
    "at one state": (GATE.replace("FIND", "angle of one.y_axis from one.x_axis at later in deg"), 90),
    "after a blow": (BLOW, degrees(atan2(4, 6))),
}


@pytest.mark.parametrize("name", CASES)
def test_vectors_are_read_at_their_own_states(name: str) -> None:
    scene, known = CASES[name]
    derivation = solve(scene).derivation
    (answer,) = derivation.answers
    assert answer.value is not None
    assert answer.value.float == pytest.approx(known)
    assert all(item.holds for item in derivation.confirmed)
