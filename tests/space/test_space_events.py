"""Events in space that hold points or make bodies one: their motion and their impulses against numbers by hand, and what they can't mean.

The numbers come of Σ m (v′ − v)² over all motions that are allowed after the event, of heavy points (second_route.events), and of vectors.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from rotsolve import solve
from rotsolve.core.faults import SceneError, Unsolvable
from second_route.events import as_one, nearest
from second_route.particles import X, Y, Z, cuboid, points, rectangle, rod, together, turn

BOX = """up: z
gravity: none
bodies:
  box:
    shape: cuboid
    mass: 2 kg
    sides: [1 m, 2 m, 3 m]
    turned: {{about: x, by: 30 deg}}
    points: {{A: [0.5 m, -1 m, -1.5 m], B: [-0.5 m, 1 m, 1 m]}}
  dart: {{shape: particle, mass: 0.5 kg}}
states:
  before:
    box.angular_velocity: [1 rad/s, -2 rad/s, 3 rad/s]
    box.velocity: [0.5 m/s, 0.2 m/s, -1 m/s]
    dart.velocity: [4 m/s, 0 m/s, 1 m/s]
  after: {{}}
events: {{e: {{{event}, from: before, to: after}}}}
find: {find}
"""
ASKED = "{W: box.angular_velocity at after, J: e.impulse during e, N: e.angular_impulse during e}"
A, B = np.array([0.5, -1, -1.5]), np.array([-0.5, 1, 1])
TURNED = turn(X, np.pi / 6)
BODY = cuboid(2, 1, 2, 3).turned(TURNED)
SPIN, SPEED = np.array([1.0, -2, 3]), np.array([0.5, 0.2, -1])


def answers(text: str) -> dict[str, Any]:
    """All answers as numbers, each confirmed."""
    derivation = solve(text).complete().derivation
    assert derivation.answers and all(item.holds for item in derivation.confirmed), derivation.confirmed
    return {item.name: numbers_of(item) for item in derivation.answers}


def numbers_of(answer: Any) -> Any:
    found = [part.value.float for part in answer.components or (answer,)]
    return found if answer.components else found[0]


def caught(*ways: Any) -> dict[str, Any]:
    """The box with the point A held, by its turns about these ways through it."""
    before = SPEED + np.cross(SPIN, BODY.places)
    held = BODY.places - TURNED @ A
    allowed = [np.cross(way, held) for way in ways]
    shares = nearest(BODY, before, allowed)
    changes = BODY.masses[:, None] * (np.tensordot(shares, allowed, 1) - before)
    return {"W": shares @ np.array(ways), "J": changes.sum(axis=0), "N": np.cross(held, changes).sum(axis=0)}


@pytest.mark.parametrize(
    ("event", "ways"),
    [
        ("fixes: [box.A, box.B]", [TURNED @ (B - A)]),
        ("fixes: [box.B, box.A]", None),
        ("fixes: box.A, along: [-1, 2, 2.5]", [TURNED @ (B - A)]),
        ("fixes: box.A", [X, Y, Z]),
    ],
)
def test_held_points_let_a_body_turn_about_what_is_left(event: str, ways: Any) -> None:
    found = answers(BOX.format(event=event, find=ASKED))
    expected = caught(*(ways or [TURNED @ (B - A)]))
    for name in ("W",) if ways is None else expected:
        assert found[name] == pytest.approx(expected[name], rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(("event", "sense"), [("joins: [dart, box.A]", 1), ("joins: [box.A, dart]", -1)])
def test_the_impulse_of_what_sticks_together_is_that_on_the_last_named(event: str, sense: int) -> None:
    found = answers(BOX.format(event=event, find="{W: box.angular_velocity at after, J: e.impulse during e}"))
    whole = together(BODY, points((0.5, TURNED @ A)))
    before = np.vstack([SPEED + np.cross(SPIN, BODY.places), [[4, 0, 1]]])
    motions = as_one(whole.places)
    shares = nearest(whole, before, motions)
    after = np.tensordot(shares, motions, 1)
    assert found["W"] == pytest.approx(shares[3:], rel=1e-9)
    assert found["J"] == pytest.approx(sense * 0.5 * (before[-1] - after[-1]), rel=1e-9)


RODS = """up: z
gravity: none
given: {m: 2 kg, L: 0.6 m, J: 3 N s}
bodies: {one: {shape: rod, mass: m, length: L}, two: {shape: rod, mass: m, length: L}}
connections: {pin: {ball: [one.end, two.start]}}
states: {before: at rest, after: {}}
events: {hit: {impulse: J, on: one.start, direction: [0, 1, 2], from: before, to: after}}
find: {w: size of (one.angular_velocity - two.angular_velocity) at after, P: pin.impulse during hit}
"""


def test_rods_on_a_ball_that_float_are_struck() -> None:
    """In line and struck at an end: ω₁ = 9 J/2 m L, ω₂ = −3 J/2 m L, and ¼ J at the ball."""
    found = answers(RODS)
    assert found["w"] == pytest.approx(6 * 3 / (2 * 0.6))
    assert found["P"] == pytest.approx(-3 / 4 * np.array([0, 1, 2]) / 5**0.5)


def test_bodies_stay_turned_as_they_met_and_later_events_keep_them_so() -> None:
    """A bar sticks askew to a plate, which then is caught at a corner."""
    found = answers("""up: z
gravity: none
bodies:
  plate: {shape: rectangle, mass: 3 kg, sides: [0.4 m, 0.2 m], points: {C: [-0.2 m, 0.1 m, 0 m]}}
  bar: {shape: rod, mass: 1 kg, length: 0.5 m, turned: {about: y, by: 40 deg}}
states:
  before: {at rest: plate, bar.velocity: [0 m/s, 2 m/s, -3 m/s], bar.angular_velocity: [0 rad/s, 4 rad/s, 0 rad/s]}
  stuck: {}
  caught: {}
events:
  stick: {joins: [plate.center, bar.end], from: before, to: stuck}
  catch: {fixes: plate.C, from: stuck, to: caught}
find: {w: plate.angular_velocity at stuck, W: bar.angular_velocity at caught, J: catch.impulse during catch}
""")
    bar = rod(1, 0.5).turned(turn(Y, np.radians(40)))
    middle = -turn(Y, np.radians(40)) @ (0.25 * X)
    plate = rectangle(3, 0.4, 0.2)
    whole = together(plate, bar.moved(middle))
    moving = np.array([0, 2, -3]) + np.cross(4 * Y, bar.places)
    before = np.vstack([np.zeros_like(plate.places), moving])
    motions = as_one(whole.places)
    shares = nearest(whole, before, motions)
    stuck = np.tensordot(shares, motions, 1)
    turns = [np.cross(axis, whole.places - np.array([-0.2, 0.1, 0])) for axis in (X, Y, Z)]
    rates = nearest(whole, stuck, turns)
    assert found["w"] == pytest.approx(shares[3:], rel=1e-9)
    assert found["W"] == pytest.approx(rates, rel=1e-9)
    assert found["J"] == pytest.approx(whole.masses @ (np.tensordot(rates, turns, 1) - stuck), rel=1e-9)


LEANING = """up: z
gravity: none
bodies:
  plate:
    shape: rectangle
    mass: 2 kg
    sides: [0.4 m, 0.3 m]
    axis: z
    points: {{A: [0.2 m, 0.15 m, 0 m], B: [-0.2 m, 0.1 m, 0 m]}}
states:
  before:
    plate.tilt: 40 deg
    plate.precession_angle: 25 deg
    plate.spin_angle: 60 deg
    plate.precession: 2 rad/s
    plate.nutation: 1 rad/s
    plate.spin: 5 rad/s
    plate.velocity: [0 m/s, 0 m/s, 2 m/s]
  after: {{}}
events: {{catch: {{fixes: {points}, from: before, to: after}}}}
find: {{W: plate.angular_velocity at after, J: catch.impulse during catch}}
"""


@pytest.mark.parametrize("points_held", ["plate.A", "[plate.A, plate.B]"])
def test_what_leans_is_held_as_it_stood(points_held: str) -> None:
    found = answers(LEANING.format(points=points_held))
    first = turn(Z, np.radians(25))
    attitude = first @ turn(X, np.radians(40)) @ turn(Z, np.radians(60))
    plate = rectangle(2, 0.4, 0.3).turned(attitude)
    before = 2 * Z + np.cross(2 * Z + first @ X + 5 * attitude @ Z, plate.places)
    corner, other = attitude @ np.array([0.2, 0.15, 0]), attitude @ np.array([-0.2, 0.1, 0])
    ways = np.array([X, Y, Z] if points_held == "plate.A" else [other - corner])
    allowed = [np.cross(way, plate.places - corner) for way in ways]
    shares = nearest(plate, before, allowed)
    assert found["W"] == pytest.approx(shares @ ways, rel=1e-9)
    assert found["J"] == pytest.approx(plate.masses @ (np.tensordot(shares, allowed, 1) - before), rel=1e-9)


REFUSED = {
    "fixes: [box.A, box.A]": "holds the same point of `box` twice",
    "fixes: [box.A, dart]": "holds points of two bodies",
    "fixes: [box.A, box.B], along: x": "has two points and an axis",
    "fixes: [box.A, [0 m, 0 m, 1 m]]": "`a place` is none",
    "joins: [box.A, box.B]": "names `box` twice",
    "grips: box": "`grips` is for scenes in the plane",
}


@pytest.mark.parametrize("event", REFUSED)
def test_what_an_event_can_not_mean_is_refused_by_name(event: str) -> None:
    with pytest.raises((SceneError, Unsolvable)) as caught_fault:
        solve(BOX.format(event=event, find="{W: box.angular_velocity at after}"))
    assert REFUSED[event] in str(caught_fault.value)


def test_two_points_that_are_held_are_for_space() -> None:
    """In the plane a body of which two points are held is at rest."""
    text = """gravity: none
given: {m: 2 kg}
bodies: {plate: {shape: rectangle, mass: m, sides: [1 m, 2 m]}}
states: {before: {plate.angular_velocity: 3 rad/s, plate.velocity: [0, 0]}, after: {}}
events: {catch: {fixes: [plate.corner1, plate.corner2], from: before, to: after}}
find: {w: plate.angular_velocity at after}
"""
    with pytest.raises(Unsolvable, match="two points"):
        solve(text)


DISC = """up: z
gravity: none
given: {{m: 1 kg, R: 0.2 m, w: 30 rad/s, u: 4 m/s}}
bodies: {{disc: {{shape: disc, mass: m, radius: R, axis: z, points: {{P: {point}}}}}}}
states:
  before: {{disc.tilt: 30 deg, {told}disc.axial_rate: w, disc.precession: 0 rad/s, disc.nutation: 0 rad/s, disc.velocity: [0, 0, u]}}
  after: {{}}
events: {{catch: {{fixes: disc.P, from: before, to: after}}}}
find: {{W: size of disc.angular_velocity at after}}
"""


@pytest.mark.parametrize(
    ("point", "told", "said"),
    [
        ("[R, 0 m, 0 m]", "", True),
        ("[R, 0 m, 0 m]", "disc.spin_angle: 90 deg, ", False),
        ("[0 m, 0 m, R]", "", False),
    ],
)
def test_a_page_says_how_far_a_body_has_spun_where_that_is_seen(point: str, told: str, said: bool) -> None:
    page = solve(DISC.format(point=point, told=told)).to("text")
    assert ("as nothing tells its spin angle" in " ".join(page.split())) is said
