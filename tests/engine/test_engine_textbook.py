"""Scenes as they stand in textbooks, against answers that were worked out by hand."""

from __future__ import annotations

import math
from dataclasses import dataclass

import pytest

from rotsolve.pipeline import solve

G = 9.8


@dataclass(frozen=True)
class Case:
    name: str
    scene: str
    answers: dict[str, float]


SLOPE = math.radians(50)
SLIDES = 2 / 3 * G * (math.sin(SLOPE) - 2 * 0.15 * math.cos(SLOPE))
CASES = [
    Case(
        "spool that unwinds from a thread along a rough slope, tied above",
        """
title: Spool
given: {M: 5 kg, R: 20 cm, beta: 50 deg, mu: 0.15}
surfaces: {ramp: {slope: beta, down: right}}
bodies: {roll: {shape: cylinder, mass: M, radius: R, moves: down}}
connections:
  touch: {contact: [roll, ramp], friction: mu}
  thread: {string: [ceiling, roll.rim], along: ramp}
find: {a: roll.acceleration, T: thread.tension}
""",
        {"a": SLIDES, "T": 5 * G * (math.sin(SLOPE) + 0.15 * math.cos(SLOPE)) / 3},
    ),
    Case(
        "yo-yo held in place by a pull that is asked for first",
        """
title: Yo-yo
given: {M: 200 g, r: 1 cm, I: 1e-4 kg m^2}
bodies: {yoyo: {mass: M, inertia: I, radius: r, moves: down}}
actions: {pull: {force: unknown, on: yoyo.rim, direction: up}}
states: {now: {yoyo.acceleration: 0}}
find: {T: pull.force, alpha: yoyo.angular_acceleration}
""",
        {"T": 0.2 * G, "alpha": 0.2 * G * 0.01 / 1e-4},
    ),
]


@pytest.mark.parametrize("case", CASES, ids=[case.name for case in CASES])
def test_a_textbook_scene(case: Case) -> None:
    found = solve(case.scene).answers
    for name, value in case.answers.items():
        number = found[name].float
        assert number is not None and math.isclose(number, value, rel_tol=1e-9, abs_tol=1e-12), name


def test_a_loss_of_energy_does_not_tell_how_fast_something_turns() -> None:
    solution = solve(
        """
title: Clutch
plane: horizontal
given: {I: 2 kg m^2, J: 3 kg m^2, w: 50 rad/s, tau: 15 N m}
bodies: {a: {inertia: I}, b: {inertia: J}}
connections: {axis: {axle: [a, b]}, c: {clutch: [a, b], friction_torque: tau}}
states: {start: {a.angular_velocity: w, b.angular_velocity: 0}, even: {c: sticks}}
find: {Q: lost kinetic_energy from start to even, n: c.rotation from start to even in rev}
"""
    )
    steps = str(solution).partition("Answers")[0]
    assert "√" not in steps
