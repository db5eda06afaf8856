"""How far a top that nods has gone round and spun by a later state: what hangs on it is refused, and nothing else is."""

from __future__ import annotations

import pytest

from rotsolve import Unsolvable, solve

TOP = """title: T
up: z
given: {M: 0.2 kg, l: 0.05 m, A: 6e-4 kg m^2, C: 8e-5 kg m^2, w: 400 rad/s, theta: 20 deg, g: 9.8 m/s^2}
bodies: {top: {mass: M, inertia: {about: tip, principal: [A, A, C]}, axis: z, points: {tip: [0, 0, -l], P: [l, 0, 0]}}}
connections: {floor: {ball: top.tip}}
states:
  start: {top.tilt: theta, top.axial_rate: w, top.precession: 0 rad/s, top.nutation: 0 rad/s}
  then: {top.tilt: WHERE}
"""
ROUND, SPUN = "has gone round by `then`", "has spun about its axis by `then`"
REFUSED = {
    "top.x_axis at then": ROUND,
    "top.angular_momentum at then": ROUND,
    "floor.force.x at then": ROUND,
    "top.torque.gravity at then": ROUND,
    "top.precession_angle at then": ROUND,
    "top.angular_momentum at then in body axes": SPUN,
    "size of top.P.velocity at then": SPUN,
}
ANSWERED = (
    "top.angular_momentum at then in node axes",
    "floor.force at then in node axes",
    "size of floor.force at then",
    "floor.force.z at then",
    "top.angular_momentum.z at then",
    "size of top.angular_velocity at then",
    "top.z_axis.z at then",
    "top.angular_velocity.z at then in body axes",
    "top.kinetic_energy at then",
)


@pytest.mark.parametrize("asked", REFUSED)
def test_what_hangs_on_it_is_refused(asked: str) -> None:
    with pytest.raises(Unsolvable, match=REFUSED[asked]):
        solve(f"{TOP.replace('WHERE', 'largest')}find: {{Q: {asked}}}\n")


@pytest.mark.parametrize("where", ["21 deg", "largest"])
def test_what_does_not_is_answered(where: str) -> None:
    finds = ", ".join(f"Q_{number}: {asked}" for number, asked in enumerate(ANSWERED))
    derivation = solve(f"{TOP.replace('WHERE', where)}find: {{{finds}}}\n").complete().derivation
    assert len(derivation.answers) == len(ANSWERED)
    assert all(item.holds for item in derivation.confirmed), derivation.confirmed
