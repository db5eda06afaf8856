"""A given that is made of letters without a number hides nothing of them: a scene says with it what it says with the formula in place."""

from __future__ import annotations

import re

import pytest

from rotsolve.pipeline import solve

GIVENS = "given: {{M: kg, m: kg, I: kg m^2, L: m, R: m, a: {unit}, b: {unit}, F: N, u: m/s, w: rad/s, k: N/m, J: N s, mu: number{made}}}"
DRUM = """
bodies: {drum: {inertia: I, radius: R}, load: {mass: m, moves: up}}
connections: {ax: {axle: drum}, rope: {string: [drum, load]}}
"""
BRAKED = """
plane: horizontal
bodies: {{wheel: {{inertia: I, radius: R}}}}
connections: {{ax: {{axle: wheel}}}}
actions: {{brake: {{press: {press}, on: wheel.rim, friction: {friction}}}}}
states: {{start: {{wheel.angular_velocity: w}}, stop: {{at rest: all}}}}
find: {{t: time from start to stop}}
"""
KINDS = {  # by what stands there: the unit of a and b, the rest of the scene, and what it asks of them
    "a place on a rod": (
        "m",
        """
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.at(L/2 + d)}}
states: {start: {rod.angle: 0, at rest: all}}
find: {al: rod.angular_acceleration at start, Y: pin.force.y at start}
""",
        "b ≤ ½ L + a; a ≤ ½ L + b",
    ),
    "where it is struck": (
        "m",
        """
plane: horizontal
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.center}}
states: {still: {rod.angle: 0, at rest: all}, go: {}}
events: {blow: {impulse: J, on: rod.at(L/2 + d), direction: up, from: still, to: go}}
find: {w2: rod.angular_velocity at go}
""",
        "b ≤ ½ L + a; a ≤ ½ L + b",
    ),
    "a mass": (
        "kg",
        """
bodies: {one: {mass: M + d, moves: down}, two: {mass: M, moves: up}, wheel: {inertia: I, radius: R}}
connections: {ax: {axle: wheel}, rope: {string: [one, wheel, two]}}
states: {start: at rest}
find: {acc: one.acceleration at start, T: rope.one.tension at start}
""",
        "b < M + a",
    ),
    "a coefficient of friction": (
        "number",
        BRAKED.format(press="F", friction="d"),
        "a ≥ b",
    ),
    "a press": (
        "N",
        BRAKED.format(press="d", friction="mu"),
        "a ≥ b",
    ),
    "a restitution": (
        "number",
        """
plane: horizontal
bodies: {one: {mass: m, moves: right}, two: {mass: M, moves: right}}
states: {before: {one.velocity: u, two.velocity: 0}, after: {}}
events: {hit: {collides: [one, two], restitution: d, from: before, to: after}}
find: {v: two.velocity at after}
""",
        "a ≥ b; a ≤ 1 + b",
    ),
    "a speed at first": (
        "m/s",
        DRUM
        + "states: {start: {load.velocity: d}, top: {load.displacement: largest}}\nfind: {s: load.displacement at top}\n",
        "",
    ),
    "a height that is reached": (
        "m",
        DRUM
        + "states: {start: {load.velocity: u}, there: {load.displacement: d}}\nfind: {v: load.velocity at there}\n",
        "",
    ),
    "an elongation": (
        "m",
        """
gravity: none
bodies: {block: {mass: m, moves: right}}
connections: {coil: {spring: [ground, block], stiffness: k}}
states: {start: {coil.elongation: d, at rest: all}, mid: {coil.elongation: 0}}
find: {v: block.velocity at mid, t: time from start to mid}
""",
        "",
    ),
}


def page(unit: str, rest: str, made: str) -> str:
    """The answers of a scene, and its signs."""
    text = str(solve(f"title: made\n{GIVENS.format(unit=unit, made=made)}{rest}"))
    return " ".join(text.replace("d = a − b", "").split())


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("unit", "rest", "asked"), KINDS.values(), ids=list(KINDS))
def test_a_letter_says_what_its_formula_says(unit: str, rest: str, asked: str) -> None:
    """The same answers under the same conditions; what the scene asks of the letter reaches those of which it is made."""
    told, written = (
        page(unit, text, made) for text, made in ((rest, ", d: a - b"), (re.sub(r"\bd\b", "(a - b)", rest), ""))
    )
    assert told.partition("Answers")[2] == written.partition("Answers")[2]
    assert asked in told
