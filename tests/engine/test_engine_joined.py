"""Bodies that turn as one: each counts turns along its own sense."""

from __future__ import annotations

import pytest

from rotsolve import solve

WELD = """
title: Two discs that are welded to each other
given: {{I: 2 kg m^2, J: 3 kg m^2, W: 4 rad/s}}
bodies: {{A: {{inertia: I{first}}}, B: {{inertia: J{second}}}}}
connections: {{axle: {{axle: [A, B]}}, pin: {{weld: [A, B]}}}}
actions: {{motor: {{couple: 5 N m, on: A}}}}
states: {{now: {{A.angular_velocity: W}}, later: {{time: 4 s}}}}
find:
  v: B.angular_velocity at now
  L: A.angular_momentum at now
  M: B.angular_momentum at now
  r: A.rotation from now to later
  s: B.rotation from now to later
  Q: B.torque at now
"""
JOIN = """
title: A disc at rest is joined to one that turns
given: {{I: 2 kg m^2, J: 3 kg m^2, w: 10 rad/s}}
bodies: {{A: {{inertia: I{first}}}, B: {{inertia: J{second}}}}}
connections: {{axle: {{axle: [A, B]}}}}
states: {{before: {{A.angular_velocity: w, B.angular_velocity: 0}}, after: {{}}}}
events: {{pin: {{joins: [{order}], from: before, to: after}}}}
find: {{W: {asked} at after}}
"""
SENSES = ("", ", turns: counterclockwise", ", turns: clockwise")


def along(sense: str) -> int:
    return -1 if "clockwise" in sense.replace(",", "").split() else 1


@pytest.mark.parametrize("first", SENSES)
@pytest.mark.parametrize("second", SENSES)
def test_welded_bodies_count_turns_each_along_its_own_sense(first: str, second: str) -> None:
    answers = solve(WELD.format(first=first, second=second)).answers
    way = along(first) * along(second)
    found = {name: answer.float for name, answer in answers.items()}
    # 4 rad/s and 1 rad/s² along A's sense, for 4 s
    assert found == pytest.approx({"v": 4 * way, "L": 8, "M": 12 * way, "r": 24, "s": 24 * way, "Q": 3 * way})


@pytest.mark.parametrize("order", ["A, B", "B, A"])
@pytest.mark.parametrize("asked", ["A.angular_velocity", "B.angular_velocity"])
@pytest.mark.parametrize("second", SENSES)
def test_the_order_of_names_decides_nothing(order: str, asked: str, second: str) -> None:
    """I w = (I + J) W; along B's own sense the other way round."""
    scene = JOIN.format(first="", second=second, order=order, asked=asked)
    found = solve(scene).answers["W"].float
    assert found == pytest.approx(-4 if second == SENSES[2] and asked.startswith("B") else 4)
