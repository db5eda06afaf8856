"""How pages tell what goes together: one letter for what moves alike, energy from rest, angular momentum past a surface, slips, ranges."""

from __future__ import annotations

import re

import pytest

import rotsolve

ATWOOD = """
given: {m: kg, M: kg, R: m, d: m, g: m/s^2, q: number}
bodies:
  light: {mass: m, moves: up}
  heavy: {mass: 3*m, moves: down}
  wheel: {inertia: q*M*R^2, radius: R, turns: clockwise}
connections: {axle: {axle: wheel}, rope: {string: [light, wheel, heavy]}}
states: {start: at rest, end: {heavy.displacement: d}}
find: {a: heavy.acceleration, w: wheel.angular_velocity at end}
"""
SLIDER = """
given: {m: kg, R: m, b: number, u: m/s, w: rad/s, mu: number, g: m/s^2}
surfaces: {floor: level}
bodies: {ball: {mass: m, inertia: b*m*R^2, radius: R, moves: right, turns: clockwise}}
connections: {grip: {contact: [ball, floor], friction: mu}}
states:
  start: {ball.velocity: START, ball.angular_velocity: SPIN}
  rolling: {grip: rolls}
find: {v: ball.velocity at rolling, W: grip.work from start to rolling, t: time from start to rolling}
"""
PROPPED = """
given: {m: kg, r: m, d: m, b: number, g: m/s^2}
surfaces: {posts: level}
bodies: {rod: {turns: clockwise, shape: rod, mass: m, length: 2*r, inertia: b*m*r^2}}
connections:
  left: {contact: [rod.at(r - d), posts]}
  right: {contact: [rod.at(r + d), posts]}
states: {before: {rod.angle: 0, balance: true}, after: {}}
events: {removal: {removes: right, from: before, to: after}}
find: {F: left.normal_force at after}
"""
JOINED = """
given: {I: kg m^2, w: rad/s}
plane: horizontal
bodies: {lower: {inertia: I}, upper: {inertia: 3*I}}
connections: {shaft: {axle: [lower, upper]}}
states: {before: {lower.angular_velocity: w, upper.angular_velocity: 0}, after: {}}
events: {coupling: {joins: [upper, lower], from: before, to: after}}
find: {v: lower.angular_velocity at after, K: kinetic_energy at after}
"""


UNITS = {"u": "m/s", "w": "rad/s", "R": "m", "b": "number", "m": "kg", "mu": "number", "g": "m/s^2"}
SIZES = {"u": 4.0, "w": 6.0, "R": 0.5, "b": 0.4, "m": 2.0, "mu": 0.3, "g": 9.8}


def page(scene: str, law: str | None = None) -> str:
    return " ".join(rotsolve.solve(scene, law=law).to("text").split())


def in_numbers(scene: str) -> str:
    """The scene with its letters told."""
    for name, size in SIZES.items():
        told = f"{name}: {size} {UNITS[name].replace('number', '')}"
        scene = re.sub(rf"(?<=[ {{]){name}: {re.escape(UNITS[name])}(?=[,}}])", told, scene, count=1)
    return scene


def test_both_ends_of_a_string_go_by_one_letter() -> None:
    told = page(ATWOOD, "energy")
    assert "Both ends of the string move alike: the same d, v for light and heavy" in told
    assert "heavy falls by d, light rises by d" in told
    assert "3 m g d − m g d = ½ m v² + ½ (3 m) v² + ½ q M R² w²" in told
    assert "v_light" not in told
    assert "v_heavy" not in told
    assert "Forces" not in told  # energy alone asks for none


def test_where_both_are_asked_both_keep_their_names() -> None:
    told = page(ATWOOD.replace("find: {", "find: {b: light.acceleration, "))
    assert "both ends of the string move alike b = a" in told


def test_newtons_laws_help_out_a_law_that_is_asked_for() -> None:
    """Energy tells the acceleration, with the friction that Newton's laws give."""
    rough = ATWOOD.replace("moves: up}", "moves: right}").replace(
        "rope:", "base: {contact: [light, table], friction: 0.2}, rope:"
    )
    told = page(
        f"surfaces: {{table: level}}{rough}".replace("start: at rest", "start: {base: slips, at rest: all}"), "energy"
    )
    assert "Newton's laws were used as well" in told
    assert "work and energy" in told


@pytest.mark.parametrize(("start", "spin"), [("u", "0"), ("0", "w"), ("u", "-w")])
def test_angular_momentum_about_a_point_of_the_surface(start: str, spin: str) -> None:
    """m u R + I w = (I + m R²) v/R, and the work is what is lost, by how far the touching point slides."""
    scene = SLIDER.replace("START", start).replace("SPIN", spin)
    assert "angular momentum about a point of the surface is conserved" in page(scene)
    told = dict(SIZES) | {"0": 0.0, "-w": -SIZES["w"]}
    u, w, inertia = told[start], told[spin], 0.4 * 2.0 * 0.25
    after = (2.0 * u * 0.5 + inertia * w) / (inertia + 2.0 * 0.25) * 0.5
    lost = 0.5 * (2.0 * u * u + inertia * w * w - (2.0 + inertia / 0.25) * after * after)
    answers = rotsolve.solve(in_numbers(scene)).answers
    assert answers["v"].float == pytest.approx(after, rel=1e-9)
    assert answers["W"].float == pytest.approx(-lost, rel=1e-9)


def test_it_is_not_said_where_something_has_an_arm() -> None:
    """A push at the top, or a slope, changes the angular momentum about a point of the surface."""
    scene = SLIDER.replace("START", "u").replace("SPIN", "0")
    pushed = scene + "actions: {push: {force: m*g/9, on: ball.top, direction: right}}\n"
    slope = scene.replace("floor: level", "floor: {slope: 20 deg}").replace("moves: right", "moves: down")
    for other in (pushed, slope):
        assert "about a point of the surface" not in page(other)


def test_a_work_by_the_way_by_which_the_touching_point_slides() -> None:
    told = page(SLIDER.replace("START", "u").replace("SPIN", "0"))
    assert "W = −μ N s" in told
    assert "s = ½ u t" in told
    assert "falls from u to 0 at a constant rate" in told


def test_ends_of_ranges_and_what_is_uniform() -> None:
    """Morin, Introduction to Classical Mechanics, 8.10: F = m g/(1 + d²/β r²), and ¼ m g of a uniform rod that is held at its ends."""
    told = page(PROPPED)
    for line in (
        "b → 0 (all mass at the centre) gives F = 0",
        "b → ∞ (all mass far out) gives F = m g",
        "d → 0 gives F = m g",
    ):
        assert line in told
    assert "d = r gives F = b m g/(1 + b)" in told
    assert "b = ⅓ (uniform rod), d = r gives F = ¼ m g" in told


def test_inertias_that_are_given_are_summed_where_they_stand() -> None:
    told = page(JOINED)
    assert "I w = (I + 3 I) v" in told
    assert "K = ½ (I + 3 I) v²" in told
    assert "I_total" not in told


def test_a_string_over_several_pegs_of_which_no_place_is_told() -> None:
    """Two pegs of the ground are no body with a point."""
    scene = """
bodies: {block: {mass: 2 kg, moves: down}}
surfaces: {ramp: {slope: 20 deg, down: right}}
connections: {base: {contact: [block, ramp], friction: none}, rope: {string: [block, ground, ground, ground]}}
states: {now: {at rest: all}}
find: {a: block.acceleration}
"""
    try:
        assert rotsolve.solve(scene).answers["a"].float == 0
    except rotsolve.core.faults.Unsolvable as error:
        assert "`rope`" in str(error)


@pytest.mark.parametrize("inertia", ["b^2*m*r^2", "m*r^2/b", "m*r^2*(1 + b)"])
def test_what_is_uniform_is_told_of_a_letter_in_proportion_alone(inertia: str) -> None:
    told = page(PROPPED.replace("b*m*r^2", inertia))
    assert "uniform" not in told
    assert "all mass" not in told
