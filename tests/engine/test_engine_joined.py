"""Bodies that turn as one: a turn is never told along the sense of another body without a word."""

from __future__ import annotations

import pytest

from rotsolve import Unsolvable, solve

WELD = """
title: Two discs that are welded to each other
given: {{I: 2 kg m^2, J: 3 kg m^2, W: 4 rad/s}}
bodies: {{A: {{inertia: I{first}}}, B: {{inertia: J{second}}}}}
connections: {{axle: {{axle: [A, B]}}, pin: {{weld: [A, B]}}}}
states: {{now: {{A.angular_velocity: W}}}}
find: {{v: B.angular_velocity at now, L: A.angular_momentum at now}}
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


@pytest.mark.parametrize("first", SENSES)
@pytest.mark.parametrize("second", SENSES)
def test_welded_bodies_count_turns_alike_or_are_refused(first: str, second: str) -> None:
    scene = WELD.format(first=first, second=second)
    if ("clockwise" in first.split()) != ("clockwise" in second.split()):
        with pytest.raises(Unsolvable, match="positive turn is the other way round"):
            solve(scene)
    else:
        answers = solve(scene).answers
        assert (answers["v"].exact, answers["L"].exact) == ("W", "I W")


@pytest.mark.parametrize("order", ["A, B", "B, A"])
@pytest.mark.parametrize("asked", ["A.angular_velocity", "B.angular_velocity"])
@pytest.mark.parametrize("second", SENSES)
def test_the_order_of_names_decides_nothing(order: str, asked: str, second: str) -> None:
    """I w = (I + J) W where both count alike; along B's own sense the other way round, or refused by name."""
    scene = JOIN.format(first="", second=second, order=order, asked=asked)
    try:
        found = solve(scene).answers["W"].float
    except Unsolvable as refused:
        assert "positive turn is the other way round" in str(refused) and second == SENSES[2]
    else:
        assert found == pytest.approx(-4 if second == SENSES[2] and asked.startswith("B") else 4)
