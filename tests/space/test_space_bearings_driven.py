"""A body in two bearings that a constant couple turns comes to an angle as one on a hinge does, by work and energy.

By hand: ω² = w² + 2 (τ θ − M g (L/2) sin θ)/(M L²/3) of a rod that rises about a level axis, and half of that sum about an upright one; two
bearings share what the hinge gives by their arms, and keep an upright axis from being turned by the weight.
"""

from __future__ import annotations

from math import cos, pi, radians, sin, sqrt

import pytest

from rotsolve import solve

ROD = """up: z
given: {M: 2 kg, L: 1 m, tau: 3 N m, w: 12 rad/s, g: 9.8 m/s^2}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start, along: ALONG HELD}}
actions: {motor: {couple: COUPLE, on: rod}}
states: {now: {rod.angle: 0 deg, rod.angular_velocity: w}, then: {rod.angle: 70 deg}}
find: {W: size of rod.angular_velocity at then, F: PUSH at then}
"""
BEARINGS = ", bearings: [-L/4, L/2]"


@pytest.mark.parametrize(("along", "couple", "lift"), [('"-y"', "[0, -tau, 0]", 1), ("z", "[0, 0, tau]", 0)])
def test_work_on_what_two_bearings_hold(along: str, couple: str, lift: int) -> None:
    text = ROD.replace("ALONG", along).replace("COUPLE", couple)
    one = solve(text.replace("HELD", "").replace("PUSH", "pin.force.x"))
    two = solve(text.replace("HELD", BEARINGS).replace("PUSH", "pin.bearing1.force.x"))
    angle = 70 * pi / 180
    work = 3 * angle - lift * 2 * 9.8 / 2 * sin(radians(70))
    for found in (one, two):
        assert found.answers["W"].float == pytest.approx(sqrt(144 + 2 * work / (2 / 3)))
        assert [item.holds for item in found.derivation.confirmed] == [True, True]
    share = 2 / 3  # of a force at the hinge, which is L/2 of 3 L/4 from the second
    turning = 0 if lift else 2 * 9.8 / 2 * cos(radians(70))  # of the weight, about y
    assert two.answers["F"].float == pytest.approx(share * one.answers["F"].float + turning / 0.75)
