"""Up to the end: where forces go by speeds, what grips in a phase grips up to its end, and what slips is told to slip up to there."""

from __future__ import annotations

import math
from random import Random

import pytest

from rotsolve.confirm.course.samples import holding
from rotsolve.confirm.verdicts import number_of
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

SLEDGE = """
title: A sledge with a crate on ice, in the wind
given: {{m: kg, M: kg, F: N, mu: number, c: kg/s, T: s, S: s}}
surfaces: {{ice: level}}
bodies: {{sledge: {{mass: M, moves: right}}, crate: {{mass: m, moves: right}}}}
connections: {{below: {{contact: [sledge, ice]}}, grip: {{contact: [crate, sledge], friction: mu}}}}
actions: {{pull: {{force: F, on: sledge, direction: right}}, air: {{force: -c*crate.velocity, on: crate, direction: right}}}}
states: {{start: at rest, mid: {{time: T}}, {later}}}
find: {{v: crate.velocity at mid}}
"""
LATER = ["end: {time: S}", "end: {crate.velocity: largest}"]
ROLLER = """
title: A sphere that is pulled at its top, in the wind
given: {m: kg, R: m, F: N, mu: number, c: kg/s, T: s, S: s}
surfaces: {floor: level}
bodies: {ball: {shape: sphere, mass: m, radius: R, moves: right}}
connections: {touch: {contact: [ball, floor], friction: mu}}
actions: {pull: {force: F, on: ball.top, direction: right}, air: {force: -c*ball.velocity, on: ball.center, direction: right}}
states: {start: at rest, mid: {time: T}, end: {time: S}}
find: {v: ball.velocity at mid}
"""
WATER = """
title: A sledge with a crate runs into water
given: {m: kg, M: kg, mu: number, u: m/s, c: kg/m, d: m}
surfaces: {ice: level}
bodies: {sledge: {mass: M, moves: right}, crate: {mass: m, moves: right}}
connections: {below: {contact: [sledge, ice]}, grip: {contact: [crate, sledge], friction: mu}}
actions: {water: {force: -c*sledge.velocity^2, on: sledge, direction: right}}
states: {start: {sledge.velocity: u, crate.velocity: u}, mid: {sledge.displacement: d}}
find: {v: sledge.velocity at mid}
"""


def left_open(found: Solution) -> str:
    return "\n".join("".join(map(str, check.words)) for check in found.checks if check.holds is None)


def followed(m: float, M: float, F: float, mu: float, c: float, T: float) -> float:
    """Speed of the crate at T, by short steps: it sticks while |F − M a| ≤ μ m g, with a of both."""
    v = w = 0.0  # of crate and sledge
    h, g = T / 4000, 9.8
    for _ in range(4000):
        common = (F - c * v) / (m + M)
        if abs(v - w) < 1e-9 and abs(F - M * common) <= mu * m * g:
            v = w = v + h * common
        else:
            v, w = v + h * (mu * m * g - c * v) / m, w + h * (F - mu * m * g) / M
    return v


@pytest.mark.parametrize("later", LATER)
def test_a_grip_that_gives_way_before_a_state_is_not_held_up_to_it(later: str) -> None:
    """What is answered of numbers is what following the motion gives, wherever an answer is."""
    found = solve(SLEDGE.format(later=later))
    (answer,), random, told = found.derivation.answers, Random(7), 0
    for _ in range(60):
        of = {name: random.uniform(0.5, 3.0) for name in ("m", "M", "F", "c", "T", "S")}
        of |= {"mu": random.uniform(0.02, 0.3), "g": 9.8}
        case = holding(answer, of)
        value = None if case is None else number_of(case, of)
        if value is None:
            continue
        told += 1
        true = followed(**{name: of[name] for name in ("m", "M", "F", "mu", "c", "T")})
        assert math.isclose(value, true, rel_tol=3e-3), of
    assert told


@pytest.mark.parametrize("text", [ROLLER, WATER])
def test_what_may_stop_slipping_is_said(text: str) -> None:
    assert "stops slipping on the way from start to mid" in left_open(solve(text))
