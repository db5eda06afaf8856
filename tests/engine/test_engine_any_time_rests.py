"""Functions of time of a last phase hold as long as what rubs goes on: up to where it comes to rest, or that is said not to be told."""

from __future__ import annotations

import pytest

from rotsolve import solve
from rotsolve.confirm.course.samples import holding

BLOCK = """
title: Block that slides against a force that varies
given: {m: 1 kg, u: 4 m/s, P: 2 N, c: 3 N/s, mu: 0.1, w: 3 rad/s}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: WAY}}
connections: {base: {contact: [block, floor], friction: mu}}
actions: {pull: {force: "FORCE", on: block, direction: WAY}}
states: {start: {block.velocity: u}}
find: {v: block.velocity at any time}
"""
FORCES = {  # whether the block comes to rest some time, by hand: v = 4 − (0.98 − F₀) t + ½ F′ t²
    "-c*time": True,
    "c*time": False,  # 0.98² < 2 · 3 · 4
    "-P - c*time": True,
    "P - c*time": True,
    "P + c*time": False,
    "-2.5*P + c*time": True,  # 5.98² > 24
    "P": False,
    "-P": True,
}
DRUM = """
title: A motor that grows, a drum on a stiff axle and a load
given: {m: kg, I: kg m^2, R: m, c: N m/s, tau: N m}
bodies: {drum: {inertia: I, radius: R, turns: counterclockwise}, load: {mass: m, moves: up}}
connections: {ax: {axle: drum, friction_torque: tau}, rope: {string: [drum, load]}}
actions: {motor: {couple: c*time, on: drum}}
states: {start: at rest}
find: {w: drum.angular_velocity at any time}
"""


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("force", "way"), [*zip(FORCES, ("right", "left") * 4, strict=True)])
def test_it_holds_up_to_where_it_comes_to_rest(force: str, way: str) -> None:
    solution = solve(BLOCK.replace("FORCE", force).replace("WAY", way), confirm=False)
    (answer,) = solution.derivation.answers
    assert (answer.until == "rest") == FORCES[force]
    assert not [check for check in solution.checks if check.holds is None and "comes to rest" in str(check.words)]


def test_where_it_is_not_told_it_is_said() -> None:
    solution = solve(BLOCK.replace("FORCE", "c*sin(w*time)").replace("c: 3 N/s", "c: 3 N").replace("WAY", "right"))
    said = [str(check.words) for check in solution.checks if check.holds is None]
    assert any("whether block comes to rest at some time after start" in words for words in said)


@pytest.mark.exhaustive
def test_in_letters_a_load_that_falls_at_first_comes_to_rest() -> None:
    """The motor turns the drum back where m g R > τ: ω = (t (τ − m g R) + ½ c t²)/(I + m R²) up to t = 2 (m g R − τ)/c."""
    answer = solve(DRUM, confirm=False).answers["w"].answer
    known = {"m": 1.0, "I": 0.5, "R": 0.1, "c": 0.2, "g": 9.8}
    for tau, until in ((0.5, "rest"), (1.5, "go")):
        case = holding(answer, {**known, "tau": tau})
        assert case is not None and case.until == until
