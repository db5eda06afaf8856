"""Where many turns are too many to be followed, what turns about fixed directions and gains evenly is confirmed all the same, by its
equations at moments on the way; the forces that it feels at last by hand."""

from __future__ import annotations

from math import cos, sin

import pytest

from rotsolve import solve

SCENE = """up: z
gravity: none
given: {J: 0.02 kg m^2, m: 3 kg, d: 13 cm, T: TIME, M: 2 N m}
bodies:
  fork: {mass: 1 kg, inertia: {principal: [J, J, J]}, points: {O: [0, 0, 0], A: [d, 0, 0]}}
  lump: {shape: particle, mass: m}
  wheel: {shape: disc, mass: 1 kg, radius: 8 cm}
connections:
  shaft: {hinge: fork.O, along: z}
  pin: {clamp: [fork.A, lump]}
  ax: {axle: [fork.O, wheel], along: ALONG}
actions: {turn: {couple: [0, 0, M], on: fork}}
states: {start: {fork.angle: 20 deg, fork.angular_velocity: 1 rad/s, wheel.spin: 200 rad/s}, end: {time: T}}
find: {F: pin.force.x at end, th: fork.angle at end}
"""
I = 0.02 + 3 * 0.13**2  # noqa: E741


@pytest.mark.parametrize("time", [3.0, 50.0])
def test_many_turns_are_confirmed(time: float) -> None:
    found = solve(SCENE.replace("TIME", f"{time} s").replace("ALONG", "z"))
    rate, gain = 1 + 2 / I * time, 2 / I
    angle = 0.3490658503988659 + time + gain * time**2 / 2
    assert found.answers["th"].float == pytest.approx(angle)
    assert found.answers["F"].float == pytest.approx(3 * 0.13 * (-(rate**2) * cos(angle) - gain * sin(angle)))
    assert all(item.holds for item in found.derivation.confirmed)


def test_an_axle_that_is_carried_round_is_none_of_these() -> None:
    """The wheel's own axis goes round: it is not said that this was looked at."""
    found = solve(SCENE.replace("TIME", "50 s").replace("ALONG", "x"))
    assert not any(item.holds for item in found.derivation.confirmed)
