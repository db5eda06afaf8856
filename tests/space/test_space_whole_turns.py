"""Whole turns of a steady precession count: 400° is reached a turn after 40°, and −320° never; by hand T = (φ − φ₀)/Ω."""

from __future__ import annotations

from math import cos, radians, sqrt

import pytest

from rotsolve import Unsolvable, solve

TOP = """up: z
given: {M: 0.3 kg, l: 6 cm, A: 2e-3 kg m^2, C: 5e-4 kg m^2, w: 150 rad/s, g: 9.8 m/s^2, T: unknown}
bodies: {top: {mass: M, inertia: {about: tip, principal: [A, A, C]}, axis: z, points: {tip: [0, 0, -l]}}}
connections: {floor: {ball: top.tip}}
states:
  start: {top.tilt: 50 deg, top.axial_rate: w, top.precession: smallest, top.precession_angle: 10 deg, steady: true}
  later: {LATER}
find: {FIND}
"""
A, C, W, TORQUE, U = 2e-3, 5e-4, 150, 0.3 * 9.8 * 0.06, cos(radians(50))
RATE = (C * W - sqrt((C * W) ** 2 - 4 * A * TORQUE * U)) / (2 * A * U)


def scene(later: str, find: str = "t: T") -> str:
    return TOP.replace("LATER", later).replace("FIND", find).replace(", T: unknown" if "T" not in later else "%", "")


@pytest.mark.sampled(2)
@pytest.mark.parametrize("angle", [40, 300, 370, 400])
def test_the_time_of_an_angle_is_confirmed(angle: int) -> None:
    found = solve(scene(f"time: T, top.precession_angle: {angle} deg"))
    assert found.answers["t"].float == pytest.approx(radians(angle - 10) / RATE)
    assert all(item.holds for item in found.derivation.confirmed)


@pytest.mark.parametrize("angle", [-40, -320])
def test_it_does_not_go_back(angle: int) -> None:
    with pytest.raises(Unsolvable, match="no `T` that it can be"):
        solve(scene(f"time: T, top.precession_angle: {angle} deg"))


def test_an_angle_beside_a_time_is_held_to_its_whole_turns() -> None:
    degrees = 10 + RATE * 3 * 180 / 3.141592653589793
    found = solve(scene(f"time: 3 s, top.precession_angle: {degrees!r} deg", "W: top.precession at later"))
    assert found.answers["W"].float == pytest.approx(RATE)
    with pytest.raises(Unsolvable, match="contradict"):
        solve(scene(f"time: 3 s, top.precession_angle: {degrees - 360!r} deg", "W: top.precession at later"))


def test_an_angle_without_a_time_is_refused_by_name() -> None:
    for find in ("t: time from start to later", "W: top.precession at later"):
        with pytest.raises(Unsolvable, match="tells its `precession_angle` without a time"):
            solve(scene("top.precession_angle: 400 deg", find))
