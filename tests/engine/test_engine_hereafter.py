"""What is asked of the state at which something sticks or stops is what holds from then on, whether another state follows or not."""

from __future__ import annotations

import pytest

from rotsolve.pipeline import solve

BALL = """
title: A ball thrown up a slope without spin
given: {m: 2 kg, R: 10 cm, u: 3 m/s, beta: 20 deg, mu: 0.3}
surfaces: {ramp: {slope: beta, down: SIDE}}
bodies: {ball: {shape: sphere, mass: m, radius: R, moves: up}}
connections: {touch: {contact: [ball, ramp], friction: mu}}
states: {start: {ball.velocity: u, ball.angular_velocity: 0}, then: {touch: rolls}MORE}
find: {a: ball.acceleration at then, f: touch.friction_force at then}
"""
CLUTCH = """
title: Two discs that stick
given: {I: 1 kg m^2, J: 2 kg m^2, w: 30 rad/s, tau: 4 N m, Q: 1 N m}
bodies: {one: {inertia: I}, two: {inertia: J}}
connections: {stud: {axle: [one, two]}, plates: {clutch: [one, two], friction_torque: tau}}
actions: {motor: {couple: Q, on: one}}
states: {start: {one.angular_velocity: w, two.angular_velocity: 0}, then: {plates: sticks}MORE}
find: {a: one.angular_acceleration at then, T: plates.torque at then}
"""
BLOCK = """
title: A block thrown up a rough slope
given: {m: 2 kg, u: 3 m/s, beta: 20 deg, mu: SIZE}
surfaces: {ramp: {slope: beta, down: left}}
bodies: {box: {mass: m, moves: up}}
connections: {touch: {contact: [box, ramp], friction: mu}}
states: {start: {box.velocity: u}, then: {box.velocity: 0}MORE}
find: {a: box.acceleration at then}
"""
SINE, COSINE = 0.3420201433256687, 0.9396926207859084


@pytest.mark.parametrize(
    ("text", "true"),
    [
        (BALL.replace("SIDE", "left"), {"a": -5 * 9.8 * SINE / 7, "f": 2 * 2 * 9.8 * SINE / 7}),
        (BALL.replace("SIDE", "right"), {"a": -5 * 9.8 * SINE / 7, "f": 2 * 2 * 9.8 * SINE / 7}),
        (CLUTCH, {"a": 1 / 3, "T": 2 / 3}),
        (BLOCK.replace("SIZE", "0.5"), {"a": 0.0}),
        (BLOCK.replace("SIZE", "0.1"), {"a": 9.8 * (0.1 * COSINE - SINE)}),
    ],
    ids=["ball", "mirrored", "clutch", "held", "slides back"],
)
def test_what_follows_is_asked(text: str, true: dict[str, float]) -> None:
    """By hand: a = −5/7 g sin β as it rolls on; both discs at Q/(I + J); g sin β less friction, or nothing, after the turn."""
    for more in ("", ", later: {time: 0.05 s}"):
        found = solve(text.replace("MORE", more))
        numbers = {name: found.answers[name].float for name in true}
        assert numbers == {name: pytest.approx(value, abs=1e-12) for name, value in true.items()}


def test_a_motion_is_asked_as_before() -> None:
    """A speed, a way or a time are the same on both sides, and no state is added for them."""
    text = BLOCK.replace("SIZE", "0.5").replace("MORE", "")
    found = solve(text.replace("a: box.acceleration at then", "d: box.displacement from start to then"))
    assert found.answers["d"].float == pytest.approx(9 / (2 * 9.8 * (SINE + 0.5 * COSINE)))
    assert "after that" not in str(found)


@pytest.mark.parametrize("size", ["0.5", "0.1"])
def test_the_farthest_place_is_where_it_comes_to_rest(size: str) -> None:
    """`largest` says of a way what a speed of 0 says: a and f are those from then on."""
    told = solve(BLOCK.replace("SIZE", size).replace("MORE", ""))
    farthest = solve(
        BLOCK.replace("SIZE", size).replace("MORE", "").replace("box.velocity: 0", "box.displacement: largest")
    )
    assert farthest.answers["a"].float == pytest.approx(told.answers["a"].float, abs=1e-12)
