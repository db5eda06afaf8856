"""Second ways: an answer written out by a law that its plan did not use comes to the same; where there is none, none is told."""

from __future__ import annotations

from pathlib import Path

import pytest

import rotsolve
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.notation.text import to_text

PROBLEMS = Path(__file__).parents[2] / "problems"

WITH = (
    "hinged/rod-loses-a-support",
    "rolling/cylinder-on-incline",
    "rolling/hoop-on-incline",
    "rolling/marble-in-bowl",
)
BENCH = """title: t
given: {m: 3 kg, r: 0.4 m, d: 0.1 m}
surfaces: {bench: level}
bodies: {rod: {shape: rod, mass: m, length: 2*r, turns: clockwise}}
connections: {left: {contact: [rod.at(r - d), bench]}, right: {contact: [rod.at(r + d), bench]}}
states: {before: {rod.angle: 0, balance: true}, after: {}}
events: {removal: {removes: right, from: before, to: after}}
find: {F: left.normal_force at after}
"""
INCLINE = """title: t
given: {M: 3 kg, R: 0.4 m, theta: 30 deg}
surfaces: {ramp: {slope: theta, down: right}}
bodies: {disc: {shape: disc, mass: M, radius: R, moves: down}}
connections: {touch: {rolls: [disc, ramp]}}
find: {alpha: disc.angular_acceleration}
"""
SLIDE = """title: t
given: {m: 3 kg, R: 0.4 m, u: 2 m/s}
surfaces: {floor: level}
bodies: {ball: {shape: sphere, mass: m, radius: R, moves: right, turns: clockwise}}
connections: {contact: {rolls: [ball, floor]}}
states: {start: {ball.velocity: u, ball.angular_velocity: 0}, rolling: {}}
events: {slide: {grips: contact, from: start, to: rolling}}
find: {v: ball.velocity at rolling}
"""


def lines(text: str) -> list[str]:
    """All equations of the second way, in their order."""
    (section,) = rotsolve.solve(text).derivation.second
    laws = [law.equation for law in section.laws]
    return [
        f"{to_text(one.left)} = {to_text(one.right)}" for one in (*laws, *(x for m in section.moves for x in m.chain))
    ]


def test_a_force_by_newtons_second_law() -> None:
    """F = m g r²/(r² + 3 d²), of two laws for rotation."""
    assert lines(BENCH) == [
        "m g − F = m d α",
        "α = 3 g d/(r² + 3 d²)",
        "m g − F = m d (3 g d/(r² + 3 d²))",
        "m g − F = 3 m g d²/(r² + 3 d²)",
        "F = m g r²/(r² + 3 d²)",
    ]


def test_a_rate_about_the_point_of_contact() -> None:
    """α = 2 g sin θ/(3 R), where the plan has the friction as well."""
    assert lines(INCLINE) == [
        "M g R sin θ = (I + M R²) (a/R)",
        "M g R sin θ = (½ M R² + M R²) α",
        "M g R sin θ = (3 M R²/2) α",
        "α = 2 g sin θ/(3 R)",
    ]


def test_a_velocity_by_the_impulse() -> None:
    """v = 5 u/7, where the plan has the angular momentum about the point of contact."""
    told = lines(SLIDE)
    assert told[-1] == "v = 5 u/7" and sum("J" in line for line in told) == 3


def test_no_second_way_where_the_plan_has_that_law() -> None:
    """The block's own second law gives the tension at once."""
    scene = """title: t
given: {m: 2 kg, M: 5 kg, R: 0.2 m}
bodies: {block: {mass: m, moves: down}, disc: {shape: disc, mass: M, radius: R, turns: clockwise}}
connections: {axle: {axle: disc}, string: {string: [disc, block]}}
find: {a: block.acceleration, T: string.tension}
"""
    assert rotsolve.solve(scene).derivation.second == ()


@pytest.mark.parametrize("problem", [PROBLEMS / f"{name}.yaml" for name in WITH])
def test_each_line_holds_with_the_numbers_of_the_scene(problem: Path) -> None:
    """Lines in givens and in the answer alone are true of it."""
    solution = rotsolve.solve(problem, confirm=False)
    values = {given.name: given.value for given in solution.problem.givens if given.value is not None}
    numbers = {name: evaluate(value, {}).float for name, value in values.items() if not value.symbols()}
    assert solution.derivation.second
    for section in solution.derivation.second:
        told = {answer.name: answer.closed or answer.formula for answer in solution.derivation.answers}
        for one in (equality for move in section.moves for equality in move.chain):
            names = one.left.symbols() | one.right.symbols()
            if names <= numbers.keys() | told.keys():
                closed = {name: form for name, form in told.items() if form is not None}
                left, right = (side.substitute(closed).substitute(values) for side in (one.left, one.right))
                if not (left.symbols() | right.symbols()):
                    gap = evaluate(left - right, {}, digits=6).float
                    assert abs(gap) < 1e-9 * max(1.0, abs(evaluate(right, {}, digits=6).float)), to_text(one.left)
