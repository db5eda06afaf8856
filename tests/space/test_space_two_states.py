"""The angle of a vector at one state from one at another: both are read where they are asked, in the derivation and in the assembly."""

from __future__ import annotations

from math import atan2, degrees, sqrt

import pytest

from rotsolve import Unsolvable, solve

GATE = """up: z
gravity: none
given: {w: 2 rad/s, T: 0.4 s}
bodies: {one: {shape: cuboid, mass: 3 kg, sides: [60 cm, 40 cm, 20 cm]}}
connections: {joint: {hinge: one.center, along: z}}
states: {now: {one.angle: 20 deg, one.angular_velocity: w}, later: {time: T}}
find: {d: FIND}
"""
BLOW = """up: z
gravity: none
given: {m: 2 kg, u: 3 m/s, J: 4 N s}
bodies: {ball: {shape: sphere, mass: m, radius: 10 cm}}
states: {before: {ball.velocity: [u, 0, 0], ball.angular_velocity: [0, 0, 1 rad/s]}, after: {}}
events: {hit: {impulse: J, on: ball.center, direction: y, from: before, to: after}}
find: {d: angle of ball.velocity at after from ball.velocity at before in deg}
"""
SPEED = "size of change of ball.speed from before to after"
PART = "size of change of ball.velocity.y from before to after"
ENERGY = "size of change of ball.kinetic_energy from before to after"
CASES = {
    "an axis from itself": (
        GATE.replace("FIND", "angle of one.x_axis at later from one.x_axis at now in deg"),
        degrees(0.8),
    ),
    "the other way round": (
        GATE.replace("FIND", "angle of one.x_axis at now from one.x_axis at later in deg"),
        degrees(0.8),
    ),
    "another axis": (
        GATE.replace("FIND", "angle of one.y_axis at later from one.x_axis at now in deg"),
        90 + degrees(0.8),
    ),
    "at one state": (GATE.replace("FIND", "angle of one.y_axis from one.x_axis at later in deg"), 90),
    "the size of the change of an angle": (
        GATE.replace("FIND", "size of change of one.angle from now to later in deg"),
        degrees(0.8),
    ),
    "the size of the change of a speed": (
        BLOW.replace("angle of ball.velocity at after from ball.velocity at before in deg", SPEED),
        sqrt(13) - 3,
    ),
    "the size of the change of a component": (
        BLOW.replace("angle of ball.velocity at after from ball.velocity at before in deg", PART),
        2,
    ),
    "the size of the change of an energy": (
        BLOW.replace("angle of ball.velocity at after from ball.velocity at before in deg", ENERGY),
        4,
    ),
    "after a blow": (BLOW, degrees(atan2(4, 6))),
}


@pytest.mark.parametrize("name", CASES)
def test_vectors_are_read_at_their_own_states(name: str) -> None:
    scene, known = CASES[name]
    derivation = solve(scene).derivation
    (answer,) = derivation.answers
    assert answer.value is not None
    assert answer.value.float == pytest.approx(known)
    assert all(item.holds is not False for item in derivation.confirmed)


THROWN = """up: z
gravity: 9.81 m/s^2
given: {M: 2 kg, v: 3 m/s}
bodies: {ball: {shape: sphere, mass: M, radius: 10 cm, points: {P: [10 cm, 0 m, 0 m]}}}
states: {start: {ball.velocity: [1 m/s, 0, v], ball.angular_velocity: [0, 0, 0]PLACE}, later: LATER}
find: {FIND}
"""


@pytest.mark.parametrize("quantity", ["energy", "potential_energy"])
def test_how_high_a_free_body_is_is_not_guessed(quantity: str) -> None:
    find = f"d: change of ball.{quantity} from start to later"
    scene = THROWN.replace("PLACE", "").replace("LATER", "{ball.angular_velocity: [0, 0, 0]}").replace("FIND", find)
    with pytest.raises(Unsolvable, match="where `ball` is at"):
        solve(scene)


@pytest.mark.parametrize(("place", "start"), [("", (0, 0, 0)), (", ball.position: [1 m, 2 m, 3 m]", (1, 2, 3))])
def test_a_thrown_body_flies_as_by_hand(place: str, start: tuple[float, float, float]) -> None:
    find = (
        "r: ball.P.position at later, U: change of ball.potential_energy from start to later, "
        "E: change of ball.energy from start to later"
    )
    scene = THROWN.replace("PLACE", place).replace("LATER", "{time: 2 s}").replace("FIND", find)
    derivation = solve(scene).derivation
    assert all(item.holds for item in derivation.confirmed)
    fallen = 2 * 3 - 9.81 * 2
    places, change, energy = derivation.answers
    assert [part.value.float for part in places.components if part.value is not None] == pytest.approx(
        [start[0] + 2 + 0.1, start[1], start[2] + fallen]
    )
    assert change.value is not None
    assert change.value.float == pytest.approx(2 * 9.81 * fallen)
    assert energy.value is not None
    assert energy.value.float == pytest.approx(0)


def test_where_the_state_tells_its_place_it_has_a_height() -> None:
    scene = """up: z
gravity: 9.81 m/s^2
bodies: {ball: {shape: sphere, mass: 2 kg, radius: 10 cm}}
states: {now: {ball.position: [1 m, 2 m, 3 m], ball.velocity: [0, 0, 3 m/s], ball.angular_velocity: [0, 0, 0]}}
find: {U: ball.potential_energy, E: ball.energy}
"""
    derivation = solve(scene).derivation
    found = {answer.name: answer.value.float for answer in derivation.answers if answer.value is not None}
    assert found == pytest.approx({"U": 58.86, "E": 67.86})
    assert all(item.holds for item in derivation.confirmed)
