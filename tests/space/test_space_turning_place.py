"""Where a rod on a hinge, let go at an angle a, turns back: as far beyond the lowest place as it began above it, −π − a.

Where it falls the other way, that is 3 π − a.
"""

from __future__ import annotations

from math import asin, pi, radians

import pytest

from rotsolve import Unsolvable, solve
from rotsolve.algebra.notation.text import to_text

ROD = """up: z
given: {m: kg, L: m, a: ANGLE, g: m/s^2, q: unknown}
bodies: {rod: {shape: rod, mass: m, length: L}}
connections: {pin: {hinge: rod.start, along: -y}}
states:
  up: {rod.angle: a, rod.angular_velocity: 0 rad/s}
  turn: {rod.angle: q, rod.angular_velocity: 0 rad/s}
find: {th: q}
"""


def test_the_place_is_told_by_the_angle_itself() -> None:
    """arcsin(sin a) is a between −90° and 90°, so that the answer hangs on no sign: of letters that is meant, and said."""
    derivation = solve(ROD.replace("ANGLE", "rad")).derivation
    (answer,) = derivation.answers
    assert answer.formula is not None
    assert to_text(answer.formula) == "−π − a"
    assert not answer.conditions and not answer.otherwise
    assert any("0 < a < 90°" in "".join(map(str, said)) for said in derivation.conventions)
    assert all(item.holds for item in derivation.confirmed)


def test_it_falls_the_other_way_from_beyond_the_top() -> None:
    found = solve(ROD.replace("ANGLE", "130 deg"))
    assert found.answers["th"].float == pytest.approx(3 * pi - radians(130))
    assert all(item.holds for item in found.derivation.confirmed)


SET_GOING = ROD.replace("rod.angle: a, rod.angular_velocity: 0 rad/s", "rod.angle: -90 deg, rod.angular_velocity: w")
SET_GOING = SET_GOING.replace("a: ANGLE", "w: RATE")


def test_it_does_not_turn_back_where_it_would_rest_in_balance() -> None:
    """With ½ I w² = m g L exactly it comes ever nearer to its highest place: the condition for turning back is strict."""
    derivation = solve(SET_GOING.replace("RATE", "rad/s")).derivation
    (answer,) = derivation.answers
    (condition,) = answer.conditions
    assert condition.relation == ">"
    assert any("never reached" in "".join(map(str, check.words)) for check in derivation.checks)


@pytest.mark.parametrize("plane", [False, True])
@pytest.mark.parametrize("rate", ["6 rad/s", "sqrt(6*g/L)"])
def test_the_edge_itself_is_never_reached(rate: str, plane: bool) -> None:
    scene = SET_GOING.replace("w: RATE", "w: 6 rad/s").replace("angular_velocity: w", f"angular_velocity: {rate}")
    scene = scene.replace("m: kg, L: m", "m: 1 kg, L: 1.5 m").replace("g: m/s^2", "g: 9 m/s^2")
    scene = scene.replace("w: 6 rad/s, ", "") if "sqrt" in rate else scene
    scene = scene.replace("up: z\n", "").replace(", along: -y", "") if plane else scene
    with pytest.raises(Unsolvable, match="never reached"):
        solve(scene)


def test_just_below_the_edge_it_turns_back() -> None:
    scene = SET_GOING.replace("RATE", "5.999 rad/s").replace("m: kg, L: m", "m: 1 kg, L: 1.5 m")
    found = solve(scene.replace("g: m/s^2", "g: 9 m/s^2"))
    assert found.answers["th"].float == pytest.approx(asin(1.5 * 5.999**2 / 27 - 1))
    assert all(item.holds for item in found.derivation.confirmed)


def test_a_told_place_of_balance_is_reached_only_by_more_than_the_edge() -> None:
    scene = SET_GOING.replace("RATE", "rad/s").replace("q: unknown", "n: rad/s").replace(", n: rad/s", "")
    scene = scene.replace("rod.angle: q, rod.angular_velocity: 0 rad/s", "rod.angle: 90 deg")
    answer = solve(scene.replace("th: q", "u: rod.angular_velocity.y at turn")).derivation.answers[0]
    assert [condition.relation for condition in answer.conditions] == ["<"]
