"""Letters that are sought in space: an angle once round, no mass that is none, and each question its own value.

The angles are held against numpy, the rest is arithmetic.
"""

from __future__ import annotations

import math
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


def test_a_body_that_is_not_looked_at_in_another_state_spoils_no_verge() -> None:
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
    solution = solve(scene).complete()
    assert [item.holds for item in solution.derivation.confirmed] == [True]
    least = 2 * math.sqrt(2e-3 * 0.4 * 9.8 * 0.06) / 6e-4  # I₃ w = 2 √(I₁ M g l)
    assert float(solution.answers["w0"].value) == pytest.approx(least, rel=5e-4)


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


ROD = """up: z
given: {m: 2 kg, L: 0.6 m, W: 8 rad/s, q: unknown, g: 9.81 m/s^2}
bodies: {rod: {shape: rod, mass: m, length: L}}
connections: {hook: {ball: rod.start}}
states: {now: {rod.tilt: q, rod.precession: W, steady: true}}
find: {FIND}
"""
ASKED = ("b: 180 deg - q in deg", "q: q in deg", "F: hook.force.z")


@pytest.mark.parametrize("order", [(0, 1, 2), (2, 0, 1), (0, 2), (1, 0, 2)])
def test_what_is_made_of_a_letter_is_that_of_the_letter(order: tuple[int, ...]) -> None:
    """Beer and Johnston, problem 18.79: cos β = 3 g/(2 L ω²), whatever is asked first; upright is an answer where there is no other."""
    beta = np.arccos(3 * 9.81 / (2 * 0.6 * 64))
    found = solve(ROD.replace("FIND", ", ".join(ASKED[k] for k in order)))
    assert found.answers["b"].float == pytest.approx(np.degrees(beta))
    assert found.answers["F"].float == pytest.approx(2 * 9.81)
    assert all(item.holds for item in found.derivation.confirmed)


ARM = """up: z
given: {m: 2 kg, L: 0.6 m, d: 0.2 m, W: 8 rad/s, q: unknown, g: 9.81 m/s^2}
bodies:
  arm: {mass: 0, points: {O: [0, 0, 0], P: [PLACE, 0, 0]}}
  rod: {shape: rod, mass: m, length: L}
connections:
  post: {hinge: arm.O, along: z, angular_velocity: W}
  pin: {hinge: [arm.P, rod.start], along: y}
states: {now: {rod.angle: q, steady: true}}
find: {FIND}
"""


@pytest.mark.parametrize("place", ["0", "d"])
@pytest.mark.parametrize(
    "find",
    ["q: q", "c: 90 deg - q, q: q", "c: cos(q)", "v: rod.end.speed", "F: pin.force.z", "K: rod.kinetic_energy, q: q"],
)
def test_one_of_several_motions_is_not_chosen_by_what_is_asked(find: str, place: str) -> None:
    scene = ARM.replace("PLACE", place).replace("FIND", find)
    with pytest.raises(Unsolvable, match="several motions are possible"):
        solve(scene if place == "d" else scene.replace("d: 0.2 m, ", ""))


PUSHED = """up: z
given: {M: 1 kg, l: 0.1 m, I1: 0.02 kg m^2, I3: 0.004 kg m^2, s: 50 rad/s, W: unknown, g: 9.81 m/s^2}
bodies: {top: {mass: M, inertia: {about: O, principal: [I1, I1, I3]}, axis: z, points: {O: [0, 0, -l]}}}
connections: {pin: {ball: top.O}}
states:
  start: {top.tilt: 60 deg, top.axial_rate: s, top.precession: W, top.nutation: 0 rad/s}
  low: {top.tilt: 75 deg, top.nutation: 0 rad/s}
find: {FIND}
"""


def pushes() -> list[float]:
    """The precessions at 60° with which the tilt comes to rest at 75°: energy with φ̇ = (L_z − L₃ cos θ)/(I₁ sin² θ)."""
    one, two = np.radians(60), np.radians(75)
    spin, fall = 0.004 * 50, 2 * 0.981 * (np.cos(one) - np.cos(two)) / 0.02
    share, gain = np.sin(one) ** 2 / np.sin(two) ** 2, spin * (np.cos(one) - np.cos(two)) / (0.02 * np.sin(two) ** 2)
    a, b, c = np.sin(two) ** 2 * np.array([share**2, 2 * share * gain, gain**2])
    return sorted(np.roots([a - np.sin(one) ** 2, b, c - fall]).real)


def test_a_letter_has_one_value_in_a_scene() -> None:
    small, large = pushes()
    for word, value in (("smallest", small), ("largest", large)):
        assert solve(PUSHED.replace("FIND", f"W: {word} W")).answers["W"].float == pytest.approx(value)
    both = solve(PUSHED.replace("FIND", "W: smallest W, V: largest W"))
    assert both.answers["W"].float == pytest.approx(small)
    assert [(item.name, "has one value in a scene" in item.fault.message) for item in both.derivation.refused] == [
        ("V", True)
    ]


@pytest.mark.parametrize("find", ["W: W", "W: W, P: top.precession at low"])
def test_one_of_two_values_that_no_equation_tests_is_not_chosen(find: str) -> None:
    with pytest.raises(Unsolvable, match=r"20\.6095 in SI units makes it so too: ask for `smallest W` or `largest W`"):
        solve(PUSHED.replace("FIND", find))


def test_a_letter_is_told_by_another_that_has_no_closed_form() -> None:
    """A mass that balances two others, beside the angle at which it lies: m r = |m₁ r₁ + m₂ r₂|."""
    scene = """up: z
gravity: none
given: {m1: 2 kg, m2: 3 kg, r1: 80 mm, r2: 70 mm, r: 100 mm, m: unknown, q: unknown, w: 10 rad/s}
bodies:
  disc:
    parts: {A: {mass: m1, at: [r1, 0, 0]}, B: {mass: m2, at: [0, r2, 0]}, X: {mass: m, at: ["r*cos(q)", "r*sin(q)", 0]}}
    points: {O: [0, 0, 0]}
connections: {axis: {hinge: disc.O, along: z, angular_velocity: w}}
states: {now: {disc.angle: 0 deg, axis.force.x: 0 N, axis.force.y: 0 N}}
find: {m: m}
"""
    assert solve(scene).answers["m"].float == pytest.approx(np.hypot(0.16, 0.21) / 0.1)
