"""The angular momentum of a whole scene by the assembly: about one point, whichever turn is positive, and never where senses differ."""

from __future__ import annotations

import pytest

import rotsolve

STRUCK = """
plane: horizontal
bodies:
  rod: {{shape: rod, mass: 2 kg, length: 1 m, turns: {sense}}}
  ball: {{mass: 0.5 kg, moves: up}}
connections: {{pin: {{hinge: rod.start}}}}
states:
  before: {{rod.angle: 0 deg, rod.angular_velocity: 1 rad/s, ball.velocity: 3 m/s}}
  after: {{}}
events: {{hit: {{{how}, from: before, to: after}}}}
find:
  L1: angular_momentum about pin at before
  L2: angular_momentum about pin at after
"""
WHEELS = """
plane: horizontal
bodies:
  one: {{shape: disc, mass: 2 kg, radius: 20 cm, turns: clockwise}}
  two: {{shape: disc, mass: 1 kg, radius: 10 cm, turns: {sense}}}
connections: {{left: {{axle: one}}, right: {{axle: two}}}}
states: {{now: {{one.angular_velocity: 3 rad/s, two.angular_velocity: 5 rad/s}}}}
find: {{L: angular_momentum at now}}
"""


@pytest.mark.parametrize(("sense", "sign"), [("clockwise", -1), ("counterclockwise", 1)])
@pytest.mark.parametrize("how", ["joins: [rod.end, ball]", "collides: [ball, rod.end], restitution: 0.5"])
def test_it_is_kept_through_a_hit_on_a_hinged_rod(sense: str, sign: int, how: str) -> None:
    """m v L + ⅓ M L² ω, with ω the way in which the rod is counted."""
    solution = rotsolve.solve(STRUCK.format(sense=sense, how=how))
    by_hand = sign * 0.5 * 3 * 1 + 2 / 3 * 1
    for name in ("L1", "L2"):
        assert solution.answers[name].float == pytest.approx(by_hand, rel=1e-12)
    assert "confirmed with numbers" in solution.to().replace("\n", " ")


def test_wheels_that_turn_the_same_way_add_up() -> None:
    solution = rotsolve.solve(WHEELS.format(sense="clockwise"))
    assert solution.answers["L"].float == pytest.approx(0.04 * 3 + 0.005 * 5, rel=1e-12)
    assert "confirmed with numbers" in solution.to()


def test_turns_that_are_counted_differently_are_not_confirmed() -> None:
    page = rotsolve.solve(WHEELS.format(sense="counterclockwise")).to()
    assert "count their turns differently" in page.replace("\n", " ") and "confirmed with numbers" not in page


@pytest.mark.parametrize("clockwise", ["a", "b"])
def test_bodies_that_count_their_turns_differently_have_one_sum(clockwise: str) -> None:
    """2·1 one way and 3·0.5 the other: it counts along the first body's turn before and after they are joined."""
    turns = {name: ", turns: clockwise" if name == clockwise else "" for name in "ab"}
    found = rotsolve.solve(
        "title: Coupled\nplane: horizontal\n"
        f"bodies: {{a: {{inertia: 2 kg m^2{turns['a']}}}, b: {{inertia: 3 kg m^2{turns['b']}}}}}\nconnections: {{ax: {{axle: [a, b]}}}}\n"
        "states: {s: {a.angular_velocity: 1 rad/s, b.angular_velocity: 0.5 rad/s}, e: {}}\n"
        "events: {cpl: {joins: [a, b], from: s, to: e}}\n"
        "find: {L: angular_momentum at s, L2: angular_momentum at e, dL: change of angular_momentum from s to e}\n"
    )
    assert [found[name].float for name in ("L", "L2", "dL")] == pytest.approx([0.5, 0.5, 0])
