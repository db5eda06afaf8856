"""Bodies that others carry round, without weights and under constant torques: they speed up evenly, while the forces on them go round."""

from __future__ import annotations

from math import hypot, isclose, pi, sqrt

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

ARM = """
title: a disc on a pin at the end of a rod
gravity: none
given: {m: 2 kg, L: 0.5 m, R: 0.1 m, Q: 3 N m}
bodies: {rod: {shape: rod, mass: m, length: L}, disc: {shape: disc, mass: m, radius: R}}
connections: {h: {hinge: rod.start}, p: {hinge: [rod.end, disc.center]}}
actions: {motor: {couple: Q, on: rod}}
states: {now: {at rest: all, rod.angle: 0}, later: {time: 0.5 s}}
find:
  w: rod.angular_velocity at later
  n: rod.rotation from now to later
  F: p.force at later
  s: disc.angular_velocity at later
"""
TRAIN = """
title: a planet between a sun and a ring that is held
gravity: none
given: {a: 0.1 m, b: 0.05 m, m: 2 kg, M: 3 kg, J: 0.02 kg m^2, Q: 30 N m, q: 4 N m}
bodies:
  sun: {inertia: J, radius: a}
  planet: {shape: disc, mass: m, radius: b}
  ring: {radius: a + 2*b}
  arm: {shape: rod, mass: M, length: a + b}
connections:
  s: {axle: sun}
  h: {hinge: arm.start}
  r: {axle: ring, angular_velocity: 0}
  p: {hinge: [arm.end, planet.center]}
  g1: {gear: [sun, planet]}
  g2: {gear: [planet, ring], inside: true}
actions: {motor: {couple: Q, on: arm}, load: {couple: -q, on: sun}}
states: {now: {arm.angle: 0, at rest: all}, later: {arm.rotation: 2 rev}}
find: {t: time from now to later, w: sun.angular_velocity at later}
"""


def test_a_disc_that_a_rod_carries_round() -> None:
    """I = (1/3 + 1) m L²: the disc does not turn; its pin bears m L α across the rod and m L ω² along it."""
    found = solve(ARM)
    rate = 3 / (4 / 3 * 2 * 0.25)
    speed = rate * 0.5
    told = {"w": speed, "n": rate * 0.125, "F": 2 * 0.5 * hypot(rate, speed**2), "s": 0.0}
    assert {name: found.answers[name].float for name in told} == pytest.approx(told)
    assert all(item.holds for item in found.derivation.confirmed)


def test_a_planetary_train_that_a_couple_speeds_up() -> None:
    """The sun turns 3 times as fast as the arm (1 + 0.2/0.1), the planet 3 times the other way (1 − 0.2/0.05)."""
    reach, around, sun = 0.15, 1 - 0.2 / 0.05, 1 + 0.2 / 0.1
    inertia = (2 + 3 / 3) * reach**2 + 0.5 * 2 * 0.05**2 * around**2 + 0.02 * sun**2
    rate = (30 - 4 * sun) / inertia
    found = solve(TRAIN)
    assert isclose(found.answers["t"].float, sqrt(8 * pi / rate), rel_tol=1e-9)
    assert isclose(found.answers["w"].float, sun * sqrt(8 * pi * rate), rel_tol=1e-9)
    assert all(item.holds for item in found.derivation.confirmed)


def test_with_weights_it_does_not_speed_up_evenly() -> None:
    scene = ARM.replace("gravity: none\n", "")
    with pytest.raises(Unsolvable, match="the accelerations vary from now to later"):
        solve(scene[: scene.index("find:")] + "find: {w: rod.angular_velocity at later}\n")
