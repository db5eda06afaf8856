"""Impulses of hinges and of their bearings in a blow: by hand or by the balance of both bodies' momenta, and by the assembly."""

from __future__ import annotations

import numpy as np
import pytest

from rotsolve import SceneError, Solution, Unsolvable, solve

PLATE = """up: z
gravity: none
given: {M: 3 kg, a: 0.6 m, b: 0.4 m, J: 2 N s, x: 0.1 m, y: 0.15 m, W: 4 rad/s}
bodies: {t: {shape: triangle, mass: M, corners: [[0, 0], [b, 0], [0, a]], points: {P: [x, y, 0], H: [0, 0, 0]}}}
connections: {pin: {hinge: t.H, along: y, bearings: [0 m, a]DRIVE}}
states: {before: {START}, after: {}}
events: {hit: {impulse: J, on: t.P, direction: z, from: before, to: after}}
find: {FIND}
"""
BOX = """up: z
gravity: none
given: {M: 3 kg, a: 0.6 m, b: 0.4 m, c: 0.1 m, J: 2 N s, p: 0.1 m, q: -0.2 m, h: 0.05 m}
bodies: {t: {shape: cuboid, mass: M, sides: [a, b, c], points: {H: [p, h, 0 m], P: [-q, p, h]}}}
connections: {pin: {hinge: t.H, along: ALONG, bearings: [p, q]}}
states: {before: {at rest: t}, after: {}}
events: {hit: {impulse: J, on: t.P, direction: [1, -1, 3], from: before, to: after}}
find: {F: pin.bearing1.impulse during hit, G: pin.bearing2.impulse during hit, P: pin.impulse during hit,
  H: pin.angular_impulse during hit, w: t.angular_velocity at after}
"""
BOTH = "F: pin.bearing1.impulse.z during hit, G: pin.bearing2.impulse.z during hit"


def known(scene: str) -> list[list[float]]:
    """The answers, all confirmed."""
    solution: Solution = solve(scene).complete()
    assert {item.holds for item in solution.derivation.confirmed} == {True}
    return [
        [part.value.float for part in answer.components or (answer,) if part.value is not None]
        for answer in solution.derivation.answers
    ]


def test_what_both_hinges_of_a_plate_give() -> None:
    """I_y = M b²/6, I_xy = −M a b/12: ω = −J x/I_y, G a + J y = I_xy ω, F + G + J = −⅓ M b ω."""
    plain = PLATE.replace("DRIVE", "").replace("START", "at rest: t")
    assert known(plain.replace("FIND", BOTH)) == [pytest.approx([-0.75]), pytest.approx([-0.25])]
    found = known(plain.replace("FIND", "P: pin.impulse during hit, H: pin.angular_impulse during hit"))
    assert found == [pytest.approx([0, 0, -1], abs=1e-12), pytest.approx([-0.15, 0, 0], abs=1e-12)]


def test_what_a_driven_shaft_gives() -> None:
    """It goes on as it did: F + G = −J, G a = −J y, and what drives it gives J x about the axis."""
    driven = PLATE.replace("DRIVE", ", angular_velocity: W").replace("START", "")
    found = known(
        driven.replace("FIND", f"{BOTH}, H: pin.angular_impulse.y during hit, w: t.angular_velocity.y at after")
    )
    assert found == [pytest.approx([value]) for value in (-1.5, -0.5, 0.2, 4)]
    alone = driven.replace(", bearings: [0 m, a]", "")
    assert known(alone.replace("FIND", "H: pin.angular_impulse.y during hit")) == [pytest.approx([0.2])]


def test_where_neither_feels_it() -> None:
    sought = PLATE.replace("x: 0.1 m, y: 0.15 m", "x: unknown, y: unknown").replace("DRIVE", "")
    told = "after: {pin.bearing1.impulse.z: 0 N s, pin.bearing2.impulse.z: 0 N s}"
    scene = sought.replace("after: {}", told).replace("START", "at rest: t").replace("FIND", "x: x, y: y")
    assert known(scene) == [pytest.approx([0.2]), pytest.approx([0.15])]
    told = "after: {pin.impulse.z: 0 N s, pin.angular_impulse.x: 0 N m s}"
    scene = sought.replace("after: {}", told).replace("START", "at rest: t").replace("FIND", "x: x, y: y")
    assert known(scene) == [pytest.approx([0.2]), pytest.approx([0.15])]


@pytest.mark.parametrize("way", [(0, 1, 0), (1, 2, 2), (-3, 0, 4)])
def test_bearings_of_a_box_on_any_axis(way: tuple[int, int, int]) -> None:
    """M v = J + F + G and I ω = Σ r × J about the centre, v = −ω × H, with G · n = 0: seven equations."""
    axis = np.array(way) / np.linalg.norm(way)
    hold, at, blow = np.array([0.1, 0.05, 0]), np.array([0.2, 0.1, 0.05]), 2 * np.array([1, -1, 3]) / np.sqrt(11)
    first, last = hold + 0.1 * axis, hold - 0.2 * axis
    tensor = 3 / 12 * np.diag([0.17, 0.37, 0.52])
    cross = [np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]) for x, y, z in (first, last)]
    left, right = np.zeros((7, 7)), np.zeros(7)  # of the rate, F and G
    left[:3, 0], left[:3, 1:4], left[:3, 4:], right[:3] = 3 * np.cross(axis, -hold), -np.eye(3), -np.eye(3), blow
    left[3:6, 0], left[3:6, 1:4], left[3:6, 4:], right[3:6] = tensor @ axis, -cross[0], -cross[1], np.cross(at, blow)
    left[6, 4:] = axis
    rate, *both = np.linalg.solve(left, right)
    one, two = np.array(both[:3]), np.array(both[3:])
    couple = np.cross(first - hold, one) + np.cross(last - hold, two)
    wanted = [one, two, one + two, couple, rate * axis]
    found = known(BOX.replace("ALONG", str(list(way))))
    assert found == [pytest.approx(list(part), rel=1e-9, abs=1e-9) for part in wanted]


def test_what_no_bearing_has_is_refused() -> None:
    plain = PLATE.replace("DRIVE", "").replace("START", "at rest: t")
    for asked, words in (
        ("H: pin.bearing1.angular_impulse during hit", "`pin.bearing1` has no quantity `angular_impulse`"),
        ("F: pin.bearing1.impulse at before", "is that of a blow: ask for it at the state after one"),
    ):
        with pytest.raises((SceneError, Unsolvable)) as caught:
            solve(plain.replace("FIND", asked))
        assert words in str(caught.value)
