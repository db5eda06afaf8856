"""The last value with which a body is held as far as a state: `u where N at top = 0`, beside which it leaves on the way."""

from __future__ import annotations

import math

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

G = 9.8
ROUND = """
title: Only just held
given: {{{given}, u: unknown}}
surfaces: {{round: {{{surface}: R}}}}
bodies: {{b: {body}}}
connections: {{touch: {{{touch}: [b, round]}}}}
states: {{first: {{touch.angle: {first} deg, b.velocity: u}}, last: {{touch.angle: {last} deg}}{more}}}
find: {{u: u where touch.normal_force at last = 0{asked}}}
"""
BEAD, BALL = "{mass: 1 kg, moves: right}", "{shape: sphere, radius: 3 cm, mass: 1 kg, moves: right}"
CASES = [  # surface, body, touch, first and last angle, circle of the centre, 1 + I/(m r²)
    ("hollow", BEAD, "contact", -90, 90, 0.4, 1.0),
    ("hollow", BEAD, "contact", 270, 450, 0.4, 1.0),
    ("hollow", BEAD, "contact", 30, 90, 0.4, 1.0),
    ("hollow", BEAD, "contact", -90, 60, 0.4, 1.0),
    ("hollow", BALL, "rolls", -90, 90, 0.37, 1.4),
    ("dome", BEAD, "contact", 90, 60, 0.4, 1.0),
]


def scene(case: tuple[str, str, str, float, float, float, float], given: str = "R: 40 cm", more: str = "") -> str:
    surface, body, touch, first, last, _, _ = case
    states, _, asked = more.partition("|")
    return ROUND.format(
        surface=surface, body=body, touch=touch, first=first, last=last, given=given, more=states, asked=asked
    )


@pytest.mark.parametrize("case", CASES)
def test_what_leaves_just_at_a_state_is_held_up_to_there(
    case: tuple[str, str, str, float, float, float, float],
) -> None:
    """m v²/ρ = m g sin φ there, and κ (u² − v²)/2 = g ρ (sin φ − sin φ₁)."""
    _, _, _, first, last, radius, share = case
    high, low = math.sin(math.radians(last)), math.sin(math.radians(first))
    found = solve(scene(case))
    assert found.answers["u"].float == pytest.approx(math.sqrt(G * radius * (high + 2 * (high - low) / share)))
    assert all(item.holds for item in found.derivation.confirmed)


def test_in_letters_too() -> None:
    found = solve(scene(CASES[0], given="R: m"))
    assert all(item.holds for item in found.derivation.confirmed)


def test_it_goes_on_from_there() -> None:
    """Past the top it presses again: 3 m g on the other side."""
    found = solve(scene(CASES[0], more=", side: {touch.angle: 180 deg}|, N: touch.normal_force at side"))
    assert found.answers["N"].float == pytest.approx(3 * G)
    assert all(item.holds for item in found.derivation.confirmed)


@pytest.mark.parametrize("last", [110, 120, 150])
def test_what_has_left_before_is_refused(last: float) -> None:
    """Behind the top it presses less before, at the top itself: with the root of N = 0 there it would long have left."""
    with pytest.raises(Unsolvable, match=r"lets go|never reached"):
        solve(scene(("hollow", BEAD, "contact", -90, last, 0.4, 1.0)))


def test_a_ladder_that_leaves_its_wall_at_an_angle_that_is_sought() -> None:
    found = solve("""
title: Ladder on a smooth wall
given: {m: 10 kg, l: 4 m, q: unknown}
surfaces: {floor: level, side: {wall: right}}
bodies: {ladder: {shape: rod, mass: m, length: l}}
connections:
  foot: {contact: [ladder.start, floor], friction: none}
  top: {contact: [ladder.end, side], friction: none}
states: {up: {ladder.angle: 80 deg, at rest: all}, z: {ladder.angle: q}}
find: {q: q where top.normal_force at z = 0}
""")
    assert found.answers["q"].float == pytest.approx(math.asin(2 / 3 * math.sin(math.radians(80))))
    assert all(item.holds for item in found.derivation.confirmed)


STEP = """
title: Wheel that is about to be pulled over a step
given: {m: 10 kg, R: 30 cm, h: 10 cm, F: unknown}
surfaces: {floor: level, kerb: {corner: h, side: right}}
bodies: {w: {shape: cylinder, mass: m, radius: R, moves: right, turns: clockwise}}
connections: {base: {rolls: [w, floor]}, edge: {rolls: [w, kerb]}}
actions: {pull: PULL}
states: {rest: {base: leaves, balance: true}}
find: {F: F}
"""


@pytest.mark.parametrize(
    ("pull", "arm"),
    [
        ("{force: F, on: w.top, direction: right}", 0.5),
        ("{force: F, on: w.center, direction: right}", 0.2),
        ("{couple: F, on: w}", 1.0),
    ],
)
def test_what_leaves_in_balance_bears_nothing(pull: str, arm: float) -> None:
    """F a = m g √(h (2 R − h)) about the edge; two rough contacts alone would leave open what the floor bears."""
    found = solve(STEP.replace("PULL", pull))
    assert found.answers["F"].float * arm == pytest.approx(10 * G * math.sqrt(0.05))
    assert all(item.holds for item in found.derivation.confirmed)
