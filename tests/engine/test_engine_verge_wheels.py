"""Where something is on the point of slipping, wheels on rubbing axles or under brakes are on the point of turning with it."""

from __future__ import annotations

import pytest

from rotsolve.pipeline import solve

SLEDGE = """
title: Sledge that a sack draws against a pull, by a wheel that rubs
given: {M: 5 kg, n: 4 kg, mu: 0.2, r: 0.1 m, J: 1 kg m^2, LETTERS, m: unknown}
surfaces: {floor: level}
bodies: {sledge: {mass: M, moves: WAY}, wheel: {inertia: J, radius: r, turns: TURNS}, sack: {mass: m, moves: down}}
connections: {base: {contact: [sledge, floor], friction: mu}, axle: {axle: wheelAXLE}, cord: {string: [sledge, wheel, sack]}}
actions: {BRAKEpull: {force: n*g, on: sledge, direction: left}}
states: {now: STATE}
find: {FIND}
"""
RUBBING = {  # letters, axle and brake with the same torque of 0.49 N m
    "axle": ("tau: 0.49 N m", ", friction_torque: tau", ""),
    "brake": ("p: 9.8 N, nu: 0.5", "", "shoe: {press: p, on: wheel.rim, friction: nu}, "),
}
LEAST, MOST = "least: smallest m where base sticks", "most: largest m where base sticks"


def sledge(way: str, turns: str, rubbing: str, find: str, state: str = "at rest") -> str:
    letters, axle, brake = RUBBING[rubbing]
    put = {"STATE": state, "LETTERS": letters, "AXLE": axle, "BRAKE": brake, "WAY": way, "TURNS": turns, "FIND": find}
    text = SLEDGE
    for word, value in put.items():
        text = text.replace(word, value)
    return text


FINDS = [LEAST, MOST, f"{LEAST}, {MOST}", f"{MOST}, {LEAST}"]
SENSES = [(way, turns) for way in ("right", "left") for turns in ("clockwise", "counterclockwise")]
KINDS = [(rubbing, state) for rubbing in RUBBING for state in ("at rest", "{balance: true}")]
IN_TURN = [  # each question with each kind, and with each of the senses once; each kind with each of the senses once
    (*SENSES[(number + place) % len(SENSES)], rubbing, find, state)
    for number, find in enumerate(FINDS)
    for place, (rubbing, state) in enumerate(KINDS)
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("way", "turns", "rubbing", "find", "state"), IN_TURN)
def test_a_wheel_that_rubs_holds_against_both_ways_of_slipping(
    way: str, turns: str, rubbing: str, find: str, state: str
) -> None:
    """m g = n g ± (μ M g + τ/r): friction of wheel and sledge together hold less and more."""
    solution = solve(sledge(way, turns, rubbing, find, state))
    answers = solution.answers
    assert all(check.holds for check in solution.derivation.checks)
    true = {"least": 2.5, "most": 5.5}
    assert {name: answer.float for name, answer in answers.items()} == pytest.approx(
        {name: true[name] for name in answers}, rel=1e-8
    )


def test_nothing_is_so_small_that_it_slips_where_wheel_and_floor_hold_all() -> None:
    text = sledge("right", "clockwise", "axle", f"{LEAST}, {MOST}").replace("n: 4 kg", "n: 1 kg")
    solution = solve(text)
    assert [item.name for item in solution.derivation.refused] == ["least"]
    assert "sticks however small" in solution.derivation.refused[0].fault.message
