"""Answers in letters are held against the assembly on both sides of what sizes decide, and where the motion goes astray."""

from __future__ import annotations

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

BALLS = """
title: A faster ball behind a slower one, both with a blow between them
given: {{m: kg, M: {heavier}, u: m/s, T: s, e: {e}}}
surfaces: {{ice: level}}
bodies: {{one: {{mass: m, moves: right}}, two: {{mass: M, moves: right}}}}
connections: {{a: {{contact: [one, ice]}}, b: {{contact: [two, ice]}}}}
states: {{before: {{one.velocity: u, at rest: two}}, after: {{}}, late: {{time: T}}}}
events: {{hit: {{collides: [one, two], restitution: e, from: before, to: after}}}}
actions: {{pull: {{force: {pull}, on: {pulled}, direction: right}}}}
find: {{s: one.displacement from after to late}}
"""
PLANK = """
title: Block on a plank that swings on a spring
given: {m: 1 kg, M: 2 kg, k: N/m, mu: 0.3, u: m/s}
surfaces: {ice: level}
bodies: {plank: {mass: M, moves: right}, block: {mass: m, moves: right}}
connections: {below: {contact: [plank, ice]}, grip: {contact: [block, plank], friction: mu}, coil: {spring: [ground, plank], stiffness: k}}
states: {start: {coil.elongation: 0, plank.velocity: u, block.velocity: u}, back: {coil.elongation: 0}}
find: {v: block.velocity at back}
"""


def reasons(found: Solution) -> list[str]:
    return [item.why for item in found.derivation.confirmed if item.holds is None]


@pytest.mark.parametrize(("pull", "pulled", "meet"), [("4 N", "one", True), ("4 N", "two", False)])
def test_bodies_that_may_meet_again_are_not_confirmed(pull: str, pulled: str, meet: bool) -> None:
    """The one behind is pulled after the other and passes it if time is long enough; the other way round it never does."""
    found = solve(BALLS.format(heavier="2 kg", e="0.5", pull=pull, pulled=pulled))
    said = reasons(found)
    assert bool(said) == meet
    assert all("meet again on the way from `after` to `late`" in why and "T = " in why for why in said)


def test_a_grip_that_a_stiff_spring_overcomes_is_not_taken_to_hold() -> None:
    """Both swing together only if u √(k/(m + M)) ≤ μ g: without that condition an answer is none."""
    try:
        found = solve(PLANK)
    except Unsolvable as error:
        assert "not confirmed" in str(error)
        return
    assert found.derivation.answers[0].conditions or reasons(found)
