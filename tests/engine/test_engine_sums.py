"""Small things that can be asked: the momentum of all along an axis, what a wire or spring stores, and turns that a wire counts."""

from __future__ import annotations

import pytest

from rotsolve.core.faults import SceneError
from rotsolve.pipeline import solve

MACHINE = """
given: {p: 3 kg, q: 1 kg, J: 2 kg m^2, r: 0.5 m, t1: 2 s}
bodies: {one: {mass: p, moves: down}, wheel: {inertia: J, mass: 1 kg, radius: r, turns: counterclockwise}, two: {mass: q, moves: up}}
connections: {axle: {axle: wheel}, rope: {string: [one, wheel, two]}}
states: {start: at rest, end: {time: t1}}
find: {y: momentum.y at end, x: momentum.x at end, own: one.momentum.y at end, ASKED}
"""
STORING = """
given: {J: 2 kg m^2, m: 2 kg, c: 5 N m/rad, k: 8 N/m, w: 3 rad/s, v: 3 m/s, b: 0.4 rad, e: 0.5 m}
surfaces: {ice: level}
bodies: {disc: {inertia: J}, puck: {mass: m, moves: right}}
connections: {axle: {axle: disc}, wire: {torsion: disc, stiffness: c}, base: {contact: [puck, ice]},
  coil: {spring: [ground, puck], stiffness: k}}
states: {start: {disc.angle: 0, disc.angular_velocity: w, coil.elongation: e, puck.velocity: 0}}
find: {U: wire.potential_energy at start, V: coil.potential_energy at start}
"""
WOUND = """
given: {I: 1 kg m^2, J: 2 kg m^2, c: 2 N m/rad, d: 0.5 N m/rad, Q: 30 N m}
bodies: {near: {inertia: I}, far: {inertia: J}}
connections: {shaft_: {axle: [near, far]}, one: {torsion: near, stiffness: c}, two: {torsion: [near, far], stiffness: d}}
actions: {hand: {couple: Q, on: far}}
states: {held: {balance: true}}
find: {a: near.angle at held, b: far.angle at held, U: two.potential_energy at held}
"""


def test_momentum_of_all_along_an_axis() -> None:
    """v = (p − q) g t/(p + q + J/r²) down on one side and up on the other."""
    speed = 2 * 9.8 * 2 / (4 + 8)
    answers = {name: answer.float for name, answer in solve(MACHINE.replace(", ASKED", "")).answers.items()}
    assert answers == pytest.approx({"y": -2 * speed, "x": 0, "own": -3 * speed}, rel=1e-3)


def test_other_sums_have_no_component() -> None:
    with pytest.raises(SceneError, match="unknown name"):
        solve(MACHINE.replace("ASKED", "K: kinetic_energy.y at end"))
    with pytest.raises(SceneError, match="no component"):
        solve(MACHINE.replace("ASKED", "u: momentum.net at end"))


def test_what_springs_and_wires_store_at_a_state() -> None:
    text = STORING.replace("disc.angle: 0", "disc.angle: b")
    answers = {name: answer.float for name, answer in solve(text).answers.items()}
    assert answers == pytest.approx({"U": 0.4, "V": 1.0}, rel=1e-8)


def test_a_wire_counts_turns() -> None:
    """Q/c and Q/c + Q/d: several turns, which the assembly counts as well."""
    answers = {name: answer.float for name, answer in solve(WOUND).answers.items()}
    assert answers == pytest.approx({"a": 15.0, "b": 75.0, "U": 900.0}, rel=1e-8)
