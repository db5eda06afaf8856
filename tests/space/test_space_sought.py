"""Letters that are sought in space: an angle once round, no mass that is none, and each question its own value.

The angles are held against numpy, the rest is arithmetic.
"""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import pytest

import rotsolve.search.search as search
import rotsolve.solver.isolation as isolation
from rotsolve import Unsolvable, solve
from second_route.particles import X, Y, Z, turn

TURNED = "up: z\ngiven: {{x: unknown}}\nbodies: {{b: {{turned: [{turns}]}}}}\nfind: {{{find}}}\n"
TWICE = "{about: x, by: x}, {about: y, by: 2*x}, {about: z, by: 20 deg}"
ASLANT = "{about: x, by: x}, {about: [1, 1, 0], by: -60 deg}"
PARTS = """up: z
gravity: none
given: {{q: unknown, a: 0.3 m}}
bodies: {{f: {{parts: {{one: {{mass: 2 kg, at: [a, 0, 0]}}, two: {{{part}, at: [0, 0, 2*a]}}}}, points: {{O: [0, 0, 0]}}}}}}
find:
  q: q where {condition}
"""
NONE = {
    "a mass": ("mass: q", "f.cm.z = -0.1 m"),
    "the length of a cone": ("shape: cone, mass: 1 kg, radius: a, length: q", "f.cm.z = 0.1 m"),
    "a density": ("shape: sphere, density: q, radius: a", "f.cm.z = -0.1 m"),
}


def angle_of(rows: Any) -> float:
    return float(np.arccos((np.trace(rows) - 1) / 2))


def turned_twice(x: float) -> float:
    return angle_of(turn(Z, pi / 9) @ turn(Y, 2 * x) @ turn(X, x))


def turned_aslant(x: float) -> float:
    return angle_of(turn((X + Y) / np.sqrt(2), -pi / 3) @ turn(X, x))


def roots_once_round(function: Any, value: float) -> list[float]:
    places = np.linspace(-pi, pi, 20001)
    gaps = np.array([function(place) - value for place in places])
    changes = np.nonzero(gaps[:-1] * gaps[1:] < 0)[0]
    return [float(places[k] - gaps[k] * (places[k + 1] - places[k]) / (gaps[k + 1] - gaps[k])) for k in changes]


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("turns", "function"), [(TWICE, turned_twice), (ASLANT, turned_aslant)])
@pytest.mark.parametrize("degrees", [70, 90, 100])
def test_of_an_angle_the_least_and_the_largest_once_round_are_meant(turns: str, function: Any, degrees: int) -> None:
    find = f"p: smallest x where b.rotation_angle = {degrees} deg, q: largest x where b.rotation_angle = {degrees} deg"
    derivation = solve(TURNED.format(turns=turns, find=find)).derivation
    found = {answer.name: answer.value.float for answer in derivation.answers if answer.value is not None}
    known = roots_once_round(function, np.radians(degrees))
    assert found == pytest.approx({"p": min(known), "q": max(known)}, rel=1e-6)
    assert all(item.holds for item in derivation.confirmed)


def test_an_angle_beyond_half_a_turn_is_not_confirmed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(isolation, "TURN", ((-100, -4),))
    monkeypatch.setattr(search, "whole_turns", lambda root, _: 0)
    scene = TURNED.format(turns=ASLANT, find="p: smallest x where b.rotation_angle = 90 deg")
    (verdict,) = solve(scene).derivation.confirmed
    assert verdict.holds is not True
    assert "within half a turn" in verdict.why


@pytest.mark.parametrize("name", NONE)
def test_no_size_of_a_part_is_negative(name: str) -> None:
    part, condition = NONE[name]
    with pytest.raises(Unsolvable, match="no `q` that it can be makes it so: in `f`"):
        solve(PARTS.format(part=part, condition=condition))


def test_in_letters_the_mass_of_a_part_is_positive_under_a_condition() -> None:
    scene = PARTS.format(part="mass: q", condition="f.cm.z = h").replace("a: 0.3 m", "a: m, h: m")
    (answer,) = solve(scene).derivation.answers
    assert answer.conditions  # h < 2 a


def test_each_question_for_an_unknown_letter_has_its_own_value() -> None:
    """q a and −q a² from arithmetic; what names an answer has that one's value."""
    scene = PARTS.format(part="mass: q", condition="f.cm.z = 0.2 m").replace(
        "find:", "find:\n  m: q where f.inertia along [1, 0, 0] about f.O = 0.72 kg m^2\n  n: 2*m"
    )
    derivation = solve(scene).derivation
    found = {answer.name: answer.value.float for answer in derivation.answers if answer.value is not None}
    assert found == pytest.approx({"m": 2.0, "n": 4.0, "q": 1.0})


def test_half_an_angle_is_sought_once_round_first() -> None:
    """x/2 comes round after two turns; all is right within one."""
    scene = TURNED.format(
        turns="{about: x, by: x/2}, {about: y, by: 40 deg}", find="p: smallest x where b.rotation_angle = 70 deg"
    )
    (answer,) = solve(scene).derivation.answers

    def turned(x: float) -> float:
        return angle_of(turn(Y, np.radians(40)) @ turn(X, x / 2))

    assert answer.value is not None
    assert answer.value.float == pytest.approx(min(roots_once_round(turned, np.radians(70))), rel=1e-6)


def test_a_rate_that_is_sought_has_its_sign() -> None:
    """|L| = 5 kg m²/s of (W + 1) 2 kg m²: W = 1.5 or −3.5 rad/s."""
    scene = """up: z
gravity: none
given: {W: unknown, s: 1 rad/s, I: 2 kg m^2}
bodies: {b: {inertia: {principal: [I, I, I]}}}
states: {now: {b.angular_velocity: [0, 0, W + s]}}
find: {p: smallest W where size of b.angular_momentum = 5 kg m^2/s, q: largest W where size of b.angular_momentum = 5 kg m^2/s}
"""
    derivation = solve(scene).derivation
    found = {answer.name: answer.value.float for answer in derivation.answers if answer.value is not None}
    assert found == pytest.approx({"p": -3.5, "q": 1.5})
    assert all(item.holds for item in derivation.confirmed)


def test_the_change_of_a_tilt_beyond_180_degrees_is_refused() -> None:
    scene = """up: z
given: {M: 0.2 kg, l: 0.05 m, I1: 6e-4 kg m^2, I3: 8e-5 kg m^2, w3: 400 rad/s}
bodies: {top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}}
connections: {floor: {ball: top.tip}}
states:
  start: {top.tilt: -20 deg, top.axial_rate: w3, top.precession: 0 rad/s, top.nutation: 0 rad/s}
  lowest: {top.tilt: largest}
find: {d: change of top.tilt from start to lowest}
"""
    with pytest.raises(Unsolvable, match="is told beyond 0 to 180°"):
        solve(scene)


def test_the_reason_of_a_missing_confirmation_names_the_body_that_it_is_about() -> None:
    scene = """up: z
given: {w: unknown}
bodies:
  top: {mass: 0.4 kg, inertia: {about: tip, principal: [2 g m^2, 2 g m^2, 0.6 g m^2]}, axis: z, points: {tip: [0, 0, -6 cm]}}
  wh: {shape: annulus, mass: 0.5 kg, radii: {inner: 12 cm, outer: 20 cm}}
surfaces: {fl: level}
connections: {p: {ball: top.tip}, g: {rolls: [wh, fl]}}
states: {a: {top.tilt: 0 deg, top.axial_rate: w, steady: true}, b: {wh.tilt: 90 deg, wh.spin: 5 rad/s, steady: true}}
find: {w0: smallest w where a is stable}
"""
    reasons = [item.why for item in solve(scene).complete().derivation.confirmed]
    assert reasons == ["`wh` lies flat there, and touches along its whole rim"]


def test_a_leaning_wheel_that_is_not_the_same_all_round_is_refused_for_that() -> None:
    scene = """up: z
bodies:
  w: {parts: {rim: {shape: ring, mass: 0.5 kg, radius: 20 cm, at: [0, 0, 0]}, e: {mass: 0.1 kg, at: [10 cm, 0, 0]}}, axis: z}
surfaces: {r: level}
connections: {grip: {rolls: [w.rim, r]}}
states: {now: {w.tilt: 70 deg, w.precession: 2 rad/s, w.spin: 4 rad/s, w.nutation: 0 rad/s}}
find: {v: w.velocity}
"""
    with pytest.raises(Unsolvable, match="its mass is not the same all round its axis"):
        solve(scene)
