"""A couple that is a plain size turns a body about the axis of its hinge, whichever way its own axis lies; else about that of its symmetry.

α = 3 τ/(M b²) of a rod on a hinge across its end, by hand.
"""

from __future__ import annotations

import pytest

from rotsolve import Unsolvable, solve

DOOR = """up: z
gravity: none
given: {M: 20 kg, b: 1 m, tau: 8 N m, k: 5 N m, w: 3 rad/s, T: 1 s}
bodies: {door: {shape: rod, mass: M, length: b}}
connections: {post: {hinge: door.start, along: ALONG}}
actions: {push: {couple: COUPLE, on: door}}
states: {start: {door.angle: 0 deg, door.angular_velocity: w}, later: {time: T}}
find: {w1: door.angular_velocity.PART at later, al: door.angular_acceleration.PART at start}
"""


@pytest.mark.parametrize(("along", "part", "sense"), [("z", "z", 1), ("-z", "z", -1), ("y", "y", 1)])
def test_a_plain_couple_is_about_the_hinge(along: str, part: str, sense: int) -> None:
    found = solve(DOOR.replace("ALONG", along).replace("PART", part).replace("COUPLE", "tau"))
    assert all(item.holds for item in found.derivation.confirmed)
    assert found.answers["al"].float == pytest.approx(sense * 1.2)
    assert found.answers["w1"].float == pytest.approx(sense * 4.2)


def test_the_same_with_its_direction_told() -> None:
    plain, told = (
        solve(DOOR.replace("ALONG", "z").replace("PART", "z").replace("COUPLE", way)) for way in ("tau", "[0, 0, tau]")
    )
    assert plain.answers["w1"].float == pytest.approx(told.answers["w1"].float)


@pytest.mark.parametrize("couple", ["-k*door.angle", "-tau*door.angular_velocity/w"])
def test_a_couple_that_goes_by_the_motion_is_refused_by_name(couple: str) -> None:
    scene = DOOR.replace("ALONG", "z").replace("PART", "z").replace("COUPLE", f'"{couple}"')
    with pytest.raises(Unsolvable, match="`push` goes by how a body stands or moves"):
        solve(scene)
