"""Bodies on hinges that are pushed on their way, or carried along: ω by the work done, by hand and by the assembly, which follows them."""

from __future__ import annotations

import math

import pytest

from rotsolve import Unsolvable, solve
from rotsolve.core.faults import NeverReached

DOOR = """
up: z
given: {M: kg, b: m, h: m, a: m/s^2}
bodies:
  truck: {mass: 0, acceleration: [a, 0, 0]}
  door: {shape: rectangle, mass: M, sides: [b, h], turned: {about: x, by: 90 deg}, points: {A: [-b/2, 0, 0]}}
connections: {post: {hinge: [truck, door.A], along: y}}
states: {start: {door.angle: 90 deg, door.angular_velocity: 0 rad/s}, shut: {door.angle: 180 deg}}
find: {w: size of door.angular_velocity at shut}
"""
ROD = """
up: z
given: {M: 2 kg, L: 1 m, g: 9.8 m/s^2}
bodies: {CARRIERrod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: HELD, along: y}}
actions: ACTIONS
states: {start: {rod.angle: 90 deg, rod.angular_velocity: 0 rad/s}, far: {rod.angle: FAR deg}}
find: {FIND}
"""
INERTIA = 2 / 3  # M L²/3
CASES = {  # carrier, actions, where to, and the work that everything does on the way
    "a truck": (
        "truck: {mass: 0, acceleration: [3 m/s^2, 0, 0]}, ",
        "{}",
        110,
        3.0 * math.sin(math.radians(20)) - 9.8 * (1 - math.cos(math.radians(20))),
    ),
    "a lift": (
        "lift: {mass: 0, acceleration: [0, 0, -12 m/s^2]}, ",
        "{c: {couple: [0, 0.1 N m, 0], on: rod}}",
        200,
        2.2 * (1 + math.sin(math.radians(20))) + 0.1 * math.radians(110),
    ),
    "a couple": ("", "{q: {couple: [0, -30 N m, 0], on: rod}}", 0, 30 * math.pi / 2 - 9.8),
    "a force": ("", "{q: {force: [30 N, 0, 0], on: rod.end}}", 30, 30 * math.cos(math.radians(30)) - 9.8 * 0.5),
    "a force on a truck": (
        "truck: {mass: 0, acceleration: [3 m/s^2, 0, 0]}, ",
        "{q: {force: [-8 N, 0, 0], on: rod.end}}",
        150,
        11 * math.cos(math.radians(30)) - 9.8 * 0.5,
    ),
}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("case", CASES)
def test_the_work_on_the_way_tells_the_rate(case: str) -> None:
    carrier, actions, far, work = CASES[case]
    held = f"[{carrier.split(':')[0]}, rod.start]" if carrier else "rod.start"
    scene = ROD.replace("CARRIER", carrier).replace("HELD", held).replace("ACTIONS", actions).replace("FAR", str(far))
    solution = solve(scene.replace("FIND", "w: size of rod.angular_velocity at far, F: pin.force at far"))
    assert float(solution.answers["w"].value) == pytest.approx(math.sqrt(2 * work / INERTIA), rel=5e-4)
    assert [item.holds for item in solution.derivation.confirmed] == [True, True]


def test_a_door_on_a_truck_that_starts() -> None:
    solution = solve(DOOR)
    assert str(solution.answers["w"]) == "w = √(3 a/b)"
    assert [item.holds for item in solution.derivation.confirmed] == [True]


def test_what_hangs_in_a_truck_does_not_swing_farther_than_twice() -> None:
    """tan(½ swing) = a/g."""
    scene = ROD.replace("CARRIER", "truck: {mass: 0, acceleration: [3 m/s^2, 0, 0]}, ").replace(
        "HELD", "[truck, rod.start]"
    )
    scene = scene.replace("ACTIONS", "{}").replace("FIND", "K: pin.force at far")
    most = 90 + 2 * math.degrees(math.atan2(3, 9.8))
    with pytest.raises(NeverReached):
        solve(scene.replace("FAR", f"{most + 0.5:.2f}"))
    assert solve(scene.replace("FAR", f"{most - 0.5:.2f}")).answers


def test_how_fast_a_truck_goes_is_not_told_by_its_acceleration() -> None:
    with pytest.raises(Unsolvable, match="how fast `truck`, which is led with an acceleration"):
        solve(DOOR.replace("size of door.angular_velocity", "door.kinetic_energy"))
