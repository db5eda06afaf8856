"""A body on a ball joint that rolls on the floor besides: along the line from the joint to the touching point only a sum of forces is told.

By hand, about the joint O at the height of the floor: N R = … of a lollipop (sphere r on a light stick) that goes round with W:
N = m (g + 7 r W²/5) (D. Morin, Introduction to Classical Mechanics, ch. 9); every answer by the assembly too.
"""

from __future__ import annotations

import pytest

from rotsolve import Unsolvable, solve

LOLLY = """up: z
given: {m: 0.4 kg, r: 0.1 m, R: 0.5 m, W: 3 rad/s, g: 9.8 m/s^2, c: 0.2 N m}
bodies: {lolly: {shape: SHAPE, mass: m, radius: r, axis: z, points: {O: [0, 0, -REACH]}}}
surfaces: {floor: level}
connections: {pivot: {ball: lolly.O}, grip: {rolls: [lolly, floor]}}
ACTIONSstates: {now: {lolly.tilt: TILT, lolly.precession: W, MORE}}
find: {FIND}
"""
LOW = {"REACH": "sqrt(R^2 + r^2)", "TILT": "'90 deg - atan(r/R)'", "SHAPE": "sphere"}


def scene(find: str, more: str, actions: str = "", **how: str) -> str:
    text = LOLLY.replace("ACTIONS", actions).replace("MORE", more).replace("FIND", find)
    for word, value in (LOW | how).items():
        text = text.replace(word, value)
    return text


@pytest.mark.parametrize("more", ["steady: true", "lolly.nutation: 0 rad/s", "lolly.precession_angle: 0 deg"])
def test_across_the_line_from_the_joint_to_the_floor_forces_are_told(more: str) -> None:
    derivation = solve(scene("N: grip.force.z, s: pivot.force.z, t: grip.force.x", more)).complete().derivation
    found = [answer.value.float for answer in derivation.answers if answer.value is not None]
    pushed = 0.4 * (9.8 + 1.4 * 0.1 * 9)
    assert found == pytest.approx([pushed, 0.4 * 9.8 - pushed, 0], abs=1e-12)
    assert [item.holds for item in derivation.confirmed] == [True] * 3


def test_a_couple_makes_it_go_round_faster() -> None:
    """ω lies level from O to the touching point: it is W R/r, and N is that without the couple, which stands square to it."""
    acted = "actions: {push: {couple: [0, 0, c], on: lolly}}\n"
    asked = (
        "al: size of lolly.angular_acceleration, F: grip.force.x, N: grip.force.z, w: size of lolly.angular_velocity"
    )
    derivation = solve(scene(asked, "lolly.precession_angle: 0 deg", acted)).complete().derivation
    assert [item.holds for item in derivation.confirmed] == [True] * 4
    found = [answer.value.float for answer in derivation.answers if answer.value is not None]
    assert found[3] == pytest.approx(3 * 0.5 / 0.1)
    assert found[2] == pytest.approx(0.4 * (9.8 + 1.4 * 0.1 * 9))


@pytest.mark.parametrize("shape", ["sphere", "disc"])
@pytest.mark.parametrize(
    "asked", ["grip.force.z", "grip.force.y", "pivot.force.z", "grip.force", "size of pivot.force"]
)
def test_along_an_oblique_line_only_the_sum_is_told(shape: str, asked: str) -> None:
    text = scene(
        f"F: {asked}", "steady: true", SHAPE=shape, REACH="R", TILT="100 deg" if shape == "sphere" else "90 deg"
    )
    with pytest.raises(
        Unsolvable, match="along the line through `pivot` and `grip` only the sum of their forces is told"
    ):
        solve(text)


@pytest.mark.parametrize("more", ["steady: true", "lolly.precession_angle: 0 deg"])
def test_a_wheel_on_a_level_stick_is_told_across_the_line(more: str) -> None:
    """Nothing pushes it round: no friction across; it turns with ω = W d/r about its stick."""
    text = scene("t: grip.force.x, s: lolly.spin", more, SHAPE="disc", REACH="R", TILT="90 deg")
    derivation = solve(text).complete().derivation
    found = [answer.value.float for answer in derivation.answers if answer.value is not None]
    assert found == pytest.approx([0, -3 * 0.5 / 0.1], abs=1e-12)
    assert all(item.holds is True for item in derivation.confirmed)
