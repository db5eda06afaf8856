"""Means of any quantity over a time, a turn or a way, against integrals by hand; what they can not be is refused by name."""

from __future__ import annotations

import math

import pytest

from rotsolve import solve
from rotsolve.core.faults import SceneError, Unsolvable

GIVEN = "gravity: none\ngiven: {I: 2 kg m^2, k: 3 N m, w: 4 rad/s, t: 2 s, b: 0.5 N m s, c: 8 N m/rad}\n"
WHEEL = (
    GIVEN
    + "bodies: {wheel: {inertia: I}}\nconnections: {axle: {axle: wheel}}\nactions: {motor: {couple: TORQUE, on: wheel}}\n"
)
TIMED = WHEEL + "states: {A: {wheel.angular_velocity: w}, B: {time: t}}\n"
TURNED = WHEEL + "states: {A: {wheel.angular_velocity: w}, B: {wheel.rotation: 2 rad}}\n"
HUNG = (
    GIVEN + "bodies: {wheel: {inertia: I}}\nconnections: {axle: {axle: wheel}, wire: {torsion: wheel, stiffness: c}}\n"
    "states: {A: {wheel.angle: 0.2 rad, at rest: all}, B: {wheel.angle: 0}}\n"
)
SLIDES = (
    "given: {m: 2 kg, u: 3 m/s, mu: 0.3, t: 2 s}\nsurfaces: {floor: level}\nbodies: {block: {mass: m, moves: right}}\n"
    "connections: {base: {contact: [block, floor], friction: mu}}\nstates: {A: {block.velocity: u}, B: {time: t}}\n"
)
OIL = "-b*wheel.angular_velocity"
W_END = 4 * math.exp(-0.5)


@pytest.mark.parametrize(
    ("of", "torque", "find", "number"),
    [
        (TIMED, "k", "mean wheel.kinetic_energy from A to B", (7**3 - 4**3) / (3 * 1.5 * 2)),
        (TIMED, "k", "mean wheel.angular_momentum from A to B", 2 * 5.5),
        (TIMED, "k", "mean wheel.kinetic_energy by wheel.rotation from A to B", (16 + 49) / 2),
        (TIMED, "k*time/t", "mean motor.torque by wheel.rotation from A to B", (3 * 4 + 1.5**2 * 2 * 4 / 8) / (8 + 1)),
        (TURNED, "k*sin(wheel.rotation)", "mean motor.torque by wheel.rotation from A to B", 1.5 * (1 - math.cos(2))),
        (
            TURNED,
            "k*sin(wheel.rotation)",
            "mean wheel.kinetic_energy by wheel.rotation from A to B",
            19 - 1.5 * math.sin(2),
        ),
        (TIMED, OIL, "mean wheel.kinetic_energy from A to B", (16 - W_END**2) * 2 / (4 * 0.5) * 2 / 2),
        (TIMED, OIL, "mean motor.torque from A to B", 2 * (W_END - 4) / 2),
        (TIMED, OIL, "mean motor.torque by wheel.rotation from A to B", -0.5 * (4 + W_END) / 2),
        (HUNG, "", "mean wheel.kinetic_energy from A to B", 8 * 0.04 / 4),
        (HUNG, "", "mean wire.potential_energy from A to B", 8 * 0.04 / 4),
        (HUNG, "", "mean wire.torque by wheel.rotation from A to B", -0.8),
        (SLIDES, "", "mean base.friction_force from A to B", 3.0),
        (SLIDES, "", "mean block.kinetic_energy from A to B", 2 * 27 / (6 * 0.3 * 9.8 * 2)),
    ],
)
def test_a_mean_is_an_integral(of: str, torque: str, find: str, number: float) -> None:
    solution = solve(f"title: t\n{of.replace('TORQUE', torque)}find: {{x: {find}}}\n")
    assert float(solution.answers["x"].value) == pytest.approx(number, rel=1e-3)
    assert "confirmed with numbers" in solution.to("text")


@pytest.mark.parametrize(
    ("find", "message"),
    [
        ("mean wheel.rotation from A to B", "is that of a whole phase, and has no mean"),
        ("wheel.kinetic_energy by wheel.rotation at B", "is of a mean, and none is asked"),
        ("mean wheel.kinetic_energy by wheel.angular_velocity from A to B", "no mean is taken by `angular_velocity`"),
        ("mean wheel.kinetic_energy at B", "is asked over a time, and no two states are named"),
    ],
)
def test_what_is_no_mean_is_refused(find: str, message: str) -> None:
    with pytest.raises((SceneError, Unsolvable), match=message):
        solve(f"title: t\n{TIMED.replace('TORQUE', 'k')}find: {{x: {find}}}\n")


def test_in_an_event_no_time_passes() -> None:
    scene = (
        "title: t\nsurfaces: {floor: level}\nbodies: {ball: {mass: 1 kg}}\n"
        "states: {A: {ball.velocity: [0 m/s, -2 m/s]}, B: {}}\n"
        "events: {hit: {collides: [ball, floor], restitution: 0.5, from: A, to: B}}\n"
    )
    with pytest.raises(Unsolvable, match="no time passes"):
        solve(scene + "find: {x: mean ball.kinetic_energy from A to B}\n")
