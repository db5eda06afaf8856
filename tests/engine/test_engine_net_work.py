"""The net work on a body is that of all that acts on it: its weight, strings, belts, gears, springs and friction."""

from __future__ import annotations

import pytest

from rotsolve.pipeline import solve

HOIST = """
title: Hoist whose motor drives its drum
given: {I: 1 kg m^2, J: 3 kg m^2, a: 0.2 m, b: 0.5 m, c: 0.4 m, m: 2 kg, Q: 9 N m, tau: 1 N m, h: 1.5 m}
bodies:
  motor: {inertia: I, radius: a, turns: MOTOR}
  drum: {inertia: J, radii: {big: b, small: c}, turns: counterclockwise}
  load: {mass: m, moves: up}
connections:
  s1: {axle: motor}
  s2: {axle: drum, friction_torque: tau}
  link: {LINK: [motor, drum.big]}
  rope: {string: [drum.small, load]}
actions: {drive: {couple: Q, on: motor}}
states: {start: at rest, up_: {load.displacement: h}}
find: {Wm: motor.work.net from start to up_, Wd: drum.work.net from start to up_, Wl: load.work.net from start to up_,
  W: load.work from start to up_, G: load.work.gravity from start to up_}
"""


@pytest.mark.parametrize(("link", "motor"), [("belt", "counterclockwise"), ("gear", "clockwise")])
def test_net_works_are_what_bodies_gain_of_kinetic_energy(link: str, motor: str) -> None:
    """½ (I (b/a)² + J + m c²) ω² = (Q b/a − τ − m g c) h/c with ω of the drum."""
    answers = solve(HOIST.replace("LINK", link).replace("MOTOR", motor)).answers
    square = 2 * (9 * 2.5 - 1 - 2 * 9.8 * 0.4) * 1.5 / 0.4 / (1 * 2.5**2 + 3 + 2 * 0.4**2)
    true = {"Wm": 0.5 * 2.5**2 * square, "Wd": 1.5 * square, "Wl": 0.16 * square, "W": 0.16 * square, "G": -29.4}
    assert {name: answer.float for name, answer in answers.items()} == pytest.approx(true, rel=1e-3)


DRIVEN = """
title: Drum that an axle turns as given against its friction
given: {w: 3 rad/s, J: 2 kg m^2, c: 0.5 rad/s^2, tau: 1.5 N m, t1: 4 s}
bodies: {drum: {inertia: J, turns: SENSE}}
connections: {pin: {KIND: drumPOINT, angular_velocity: w + c*time, friction_torque: tau}}
states: {start: {}, end: {time: t1}}
find: {Q: pin.torque at end, P: pin.power at end, W: pin.work from start to end, N: drum.torque.net at end}
"""


@pytest.mark.parametrize("sense", ["clockwise", "counterclockwise"])
def test_an_axle_that_drives_and_rubs_does_both_together(sense: str) -> None:
    """Q = J c, P = Q ω, W = ½ J (ω² − ω₀²): what the drum gets of its axle in all."""
    text = DRIVEN.replace("KIND", "axle").replace("POINT", "").replace("SENSE", sense)
    answers = {name: answer.float for name, answer in solve(text).answers.items()}
    assert answers == pytest.approx({"Q": 1.0, "P": 5.0, "W": 16.0, "N": 1.0}, rel=1e-8)
