"""Powers, potential energy, places and radii of gyration in space: held against heavy points and against the rate of the energy."""

from __future__ import annotations

from math import cos, radians, sin, sqrt
from typing import Any

import numpy as np
import pytest

from rotsolve import solve
from second_route.particles import turn

GATE = """up: z
gravity: 9.81 m/s^2
given: {{M: 2 kg, L: 1 m, w: {w} rad/s, th: {th} deg, tau: {tau} N m, F: {force} N}}
bodies: {{one: {{shape: rod, mass: M, length: L}}}}
connections: {{joint: {{hinge: one.start, along: [0, 3/5, 4/5]{drive}}}}}
actions:
  twist: {{couple: tau, on: one}}
  push: {{force: F, on: one.end, direction: [1, 2, -2]}}
states: {{now: {{one.angle: th{state}}}}}
find:
  P_net: one.power
  P_weight: one.power.gravity
  P_twist: twist.power
  P_push: push.power
  P_joint: joint.power
  U: one.potential_energy
  r: one.end.position
"""
AXIS = np.array([0, 0.6, 0.8])


def numbers(scene: str) -> dict[str, Any]:
    derivation = solve(scene).derivation
    assert all(item.holds for item in derivation.confirmed), [item.why for item in derivation.confirmed]
    parts = {answer.name: answer.components or (answer,) for answer in derivation.answers}
    return {name: [part.value.float for part in own if part.value is not None] for name, own in parts.items()}


@pytest.mark.parametrize(("w", "th", "tau", "force"), [(3, 40, 5, 3), (-2, 200, -1.5, 4)])
def test_powers_on_a_hinge_are_forces_times_velocities(w: float, th: float, tau: float, force: float) -> None:
    found = numbers(GATE.format(w=w, th=th, tau=tau, force=force, drive="", state=", one.angular_velocity: w"))
    end = turn(AXIS, radians(th)) @ np.array([1.0, 0, 0])
    velocity = np.cross(w * AXIS, end)
    powers = {
        "P_weight": [2 * 9.81 * -velocity[2] / 2],
        "P_twist": [tau * w],
        "P_push": [force * velocity @ np.array([1, 2, -2]) / 3],
        "P_joint": [0.0],
    }
    powers["P_net"] = [sum(power for (power,) in powers.values())]
    known = {**powers, "U": [2 * 9.81 * end[2] / 2], "r": list(end)}
    for name, value in known.items():
        assert found[name] == pytest.approx(value, rel=1e-9, abs=1e-12), name


def test_what_drives_a_hinge_gives_what_the_others_take() -> None:
    """At a constant rate the kinetic energy stays."""
    found = numbers(GATE.format(w=3, th=40, tau=5, force=3, drive=", angular_velocity: w", state=""))
    assert found["P_net"] == pytest.approx([0.0], abs=1e-9)
    others = sum(found[name][0] for name in ("P_weight", "P_twist", "P_push"))
    assert found["P_joint"] == pytest.approx([-others])


def test_radii_of_gyration_go_by_their_axis() -> None:
    scene = (
        "up: z\nbodies: {b: {shape: cuboid, mass: 3 kg, sides: [60 cm, 40 cm, 20 cm]}}\n"
        'find: {z: "b.gyration along z", d: "b.gyration along [1, 1, 0]"}\n'
    )
    found = numbers(scene)
    x, y, z = ((0.4**2 + 0.2**2) / 12, (0.6**2 + 0.2**2) / 12, (0.6**2 + 0.4**2) / 12)
    assert found == {"z": pytest.approx([sqrt(z)]), "d": pytest.approx([sqrt((x + y) / 2)])}


def test_the_weight_of_a_top_works_as_it_sinks() -> None:
    """Its power is M g l sin θ θ̇."""
    scene = (
        "up: z\ngravity: 9.81 m/s^2\n"
        "bodies: {top: {mass: 150 g, inertia: {about: tip, principal: [5e-4 kg m^2, 5e-4 kg m^2, 6e-5 kg m^2]}, axis: z, "
        "points: {tip: [0 m, 0 m, -4 cm]}}}\nconnections: {floor: {ball: top.tip}}\n"
        "states: {now: {top.tilt: 25 deg, top.axial_rate: 300 rad/s, top.precession: 2 rad/s, top.nutation: 3 rad/s}}\n"
        "find: {P: top.power, U: top.potential_energy}\n"
    )
    found, weight = numbers(scene), 0.15 * 9.81 * 0.04
    assert found == {
        "P": pytest.approx([weight * sin(radians(25)) * 3]),
        "U": pytest.approx([weight * cos(radians(25))]),
    }
