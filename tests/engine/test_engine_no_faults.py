"""Questions that led to an internal error: each is answered or refused by name now, and takes no other with it."""

from __future__ import annotations

import pytest

from rotsolve import solve
from rotsolve.algebra.notation.text import to_text

RUBBING = """
gravity: none
given: {I: kg m^2, J: kg m^2, tau: N m, w: rad/s, v: rad/s}
bodies: {plate: {inertia: I}, disc: {inertia: J}}
connections: {sh: {axle: [plate, disc]}, clutch: {clutch: [plate, disc], friction_torque: tau}}
states: {start: {plate.angular_velocity: w, disc.angular_velocity: -v}, one: {clutch: sticks}}
find: {r: ASKED, L: change of disc.angular_momentum from start to one}
"""
SLEDGE = """
given: {m: 10 kg, mu: 0.4, phi: 50 deg, f: 20 N, F: unknown}
surfaces: {floor: level}
bodies: {sledge: {mass: m, moves: right}}
connections: {touch: {contact: [sledge, floor], friction: mu}}
actions: {pull: {force: F, on: sledge, direction: phi}}
states: {start: at rest}
find: {F: smallest F where touch.friction_force = f at start, F2: largest F where touch.friction_force = f at start}
"""
TOPS = """
up: z
given: {M: kg, l: m, A: kg m^2, C: kg m^2, w: unknown, s: unknown, g: m/s^2}
bodies:
  top: {mass: M, inertia: {about: tip, principal: [A, A, C]}, axis: z, points: {tip: [0, 0, -l]}}
  two: {mass: M, inertia: {about: tip, principal: [A, A, C]}, axis: z, points: {tip: [0, 0, -l]}}
connections: {floor: {ball: top.tip}, f2: {ball: two.tip}}
states:
  up: {top.tilt: 0 deg, top.spin: w, top.precession: 0 rad/s, steady: true}
  lean: {two.tilt: 35 deg, two.spin: s, steady: true}
find: {w0: smallest w where up is stable}
"""


@pytest.mark.parametrize(
    "asked",
    ["total clutch.rotation from start to one", "clutch.rotation at any time", "total clutch.work from start to one"],
)
def test_what_two_discs_turn_against_each_other_is_not_summed_up(asked: str) -> None:
    found = solve(RUBBING.replace("ASKED", asked))
    assert list(found.refused) == ["r"]
    assert to_text(found.answers["L"].answer.closed) == "I J (w + v)/(I + J)"


def test_one_letter_sought_twice() -> None:
    """F cos φ = f while it stays: 31.1 N; where it slips, f = μ (m g − F sin φ) again, which is larger."""
    found = solve(SLEDGE)
    assert found.answers["F"].float == pytest.approx(31.1145, rel=1e-5)
    assert "F2" in found.refused


def test_two_letters_that_steady_motions_tell() -> None:
    """C² ω₃² ≥ 4 A M g l of an upright top, whatever is told of another one."""
    assert to_text(solve(TOPS).answers["w0"].answer.closed) == "2 √(M A g l)/C"
