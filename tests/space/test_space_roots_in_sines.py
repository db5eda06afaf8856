"""The root in a sine is written as one, √(2 h/g), as it is outside; and of letters that are tried, those that the scene does not write are
not told."""

from __future__ import annotations

from rotsolve import solve
from rotsolve.algebra.formula import Call
from rotsolve.algebra.notation.text import to_text

THROWN = """up: z
gravity: {size: g, in: earth}
given: {h: 100 m, w: 7.292e-5 rad/s, g: 9.8 m/s^2, lambda: 45 deg}
bodies: {earth: {mass: 0, points: {P: [0, 0, 0]}}, stone: {shape: particle, mass: 1 kg}}
connections: {pole: {hinge: earth.P, along: [0, cos(lambda), sin(lambda)], angular_velocity: w}}
states:
  up: {stone.position relative to earth: [0 m, 0 m, 0 m], stone.velocity relative to earth: [0, 0, sqrt(2*g*h)]}
  down: {time: 2*sqrt(2*h/g)}
find: {x: stone.position.x in earth axes at down in cm}
"""
COCKROACH = """up: z
gravity: none
given: {m: kg, b: m, w: rad/s, mu: number, g: m/s^2, v: unknown}
bodies: {table: {shape: disc, mass: 0}, roach: {shape: particle, mass: m}}
connections: {axis: {hinge: table.center, along: z, angular_velocity: w}}
actions: {grip: {force: any, on: roach}}
states:
  now:
    roach.position relative to table: [b, 0, 0]
    roach.velocity relative to table: [0, v, 0]
    roach.acceleration relative to table: [-v^2/b, 0, 0]
find: {v: v where size of grip.force = mu*m*g}
"""


def test_the_angle_of_a_sine_has_one_root() -> None:
    found = solve(THROWN).answers["x"].formula
    assert found is not None
    assert {to_text(node) for node in found.walk(Call) if isinstance(node, Call) and node.function != "sqrt"} == {
        "sin(2 w √(2 h/g))",
        "cos(2 w √(2 h/g))",
        "cos λ",
    }


def test_letters_that_nobody_wrote_are_not_told() -> None:
    """The disc has no radius in the scene, and none stands on the page."""
    (doubt,) = [item.why for item in solve(COCKROACH).derivation.confirmed if item.holds is None]
    assert "m = " in doubt and "R_table" not in doubt
