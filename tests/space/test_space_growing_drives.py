"""A steady state lasts: what acts on a body that goes round, and the acceleration of what carries it, do not change in time."""

from __future__ import annotations

import pytest

from rotsolve import solve
from rotsolve.core.faults import Unsolvable

TOP = """title: t
up: z
given: {M: 0.5 kg, l: 6 cm, I1: 2.5e-3 kg m^2, I3: 6e-4 kg m^2, b: 3 m/s^3, c: 0.1 N/s, a: 4 m/s^2, v: 1 m/s}
bodies:
  lift: {mass: 0, LED, points: {P: [0, 0, 0]}}
  top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}
connections: {floor: {ball: [lift.P, top.tip]}}
states: {now: {time: 0 s, top.tilt: 50 deg, top.axial_rate: 150 rad/s, steady: true}}
find: {P: smallest top.precession at now}
"""
PULL = "actions: {pull: {force: [0, 0, c*time], on: top.center}}\n"


@pytest.mark.parametrize(
    "led", ["acceleration: [0, 0, b*time]", "velocity: [0, 0, b*time^2/2]", "position: [0, 0, b*time^3]"]
)
def test_a_lift_whose_acceleration_grows(led: str) -> None:
    with pytest.raises(Unsolvable, match="acceleration of `lift` changes in time"):
        solve(TOP.replace("LED", led))


def test_a_force_that_grows() -> None:
    with pytest.raises(Unsolvable, match="`pull` changes in time while `top` goes round"):
        solve(TOP.replace("LED", "acceleration: [0, 0, 0]").replace("states:", PULL + "states:"))


@pytest.mark.parametrize("led", ["acceleration: [0, 0, -a]", "velocity: [0, 0, v - a*time]"])
def test_a_lift_of_constant_acceleration(led: str) -> None:
    """I₁ cos θ P² − I₃ s P + M (g + a) l = 0, the smaller root."""
    assert solve(TOP.replace("LED", led).replace("time: 0 s, ", "")).answers["P"].float == pytest.approx(
        2.00512, rel=1e-5
    )
