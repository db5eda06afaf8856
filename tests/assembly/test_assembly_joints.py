"""What the laws say of bodies hinged at points of rims, held against the assembly: such a point turns with its body."""

from __future__ import annotations

import math

import msgspec
import pytest

from rotsolve.confirm.instant import moment, placed
from rotsolve.confirm.model import Model
from rotsolve.motion.complete import configured
from rotsolve.pipeline import solve
from rotsolve.scene.read import read_source

SCENE = """
title: joint at a rim
given: {{M: 3 kg, m: 2 kg, R: 50 cm, r: 30 cm}}
surfaces: {{ramp: {{slope: 30 deg, down: right}}}}
bodies:
  one: {{shape: disc, mass: M, radius: R{moves}}}
  two: {{shape: disc, mass: m, radius: r}}
connections: {{hold: {{{hold}}}, joint: {{hinge: [one.{one}, two.{two}]}}}}
states: {{start: {{{lines}}}}}
find: {{a: one.angular_acceleration at start, b: two.angular_acceleration at start, X: joint.force.x at start}}
"""
HOLDS = {
    "rolls": ("rolls: [one, ramp]", ", moves: down", "two.angle: 20 deg, at rest: all"),
    "axle": ("axle: one", "", "two.angle: 20 deg, one.angular_velocity: 2 rad/s, two.angular_velocity: -3 rad/s"),
    "hinge": (
        "hinge: one.top",
        "",
        "one.angle: -50 deg, two.angle: 20 deg, one.angular_velocity: 2 rad/s, two.angular_velocity: 4 rad/s",
    ),
}
PLACES = [("bottom", "top"), ("rim", "rim"), ("top", "bottom"), ("center", "rim")]


@pytest.mark.parametrize("held", HOLDS)
@pytest.mark.parametrize(("one", "two"), PLACES)
def test_joints_at_rims(held: str, one: str, two: str) -> None:
    hold, moves, lines = HOLDS[held]
    text = SCENE.format(hold=hold, moves=moves, lines=lines, one=one, two=two)
    answers = {answer.name: answer.value.float for answer in solve(text).derivation.answers if answer.value is not None}
    model = Model(configured(read_source(text)).problem, {}, "start")
    found = moment(model, placed(model))
    turning = {
        name: found.rates[model.seats[body].turn] * model.sense(body) for name, body in (("a", "one"), ("b", "two"))
    }
    for name, value in (*turning.items(), ("X", found.reactions["joint", "x"])):
        assert answers[name] == pytest.approx(value, rel=1e-9, abs=1e-9)


SPOOL = """
title: hinge off the axis
given: {{r: 36 cm, M: 5.6 kg, R: {wide}, m: 2.9 kg, F: 7.2 N, a: 0.58 rad/s}}
bodies:
  one: {{mass: M, inertia: M*r^2, radii: {{big: 2*r, small: r}}}}
  two: {{radius: R, parts: {{lump: {{mass: m, at: [R/2, 0]}}}}}}
connections: {{pin: {{hinge: one.big}}, bolt: {{weld: [one.small, two.center]}}}}
actions: {{pull: {{force: F, on: one.center, direction: left}}}}
states: {{start: {{one.angle: -40 deg, one.angular_velocity: -a}}}}
find: {{v: two.center.velocity.y at start, alpha: one.angular_acceleration at start, Y: pin.force.y at start}}
"""


@pytest.mark.parametrize("wide", ["30 cm", "130 cm", "500 cm"])
def test_the_numbers_tell_on_which_side_of_its_hinge_a_body_is(wide: str) -> None:
    text = SPOOL.format(wide=wide)
    answers = {answer.name: answer.value.float for answer in solve(text).derivation.answers if answer.value is not None}
    model = Model(configured(read_source(text)).problem, {}, "start")
    found = moment(model, placed(model))
    assert answers["alpha"] == pytest.approx(found.rates[model.seats["one"].turn], rel=1e-9)
    assert answers["Y"] == pytest.approx(found.reactions["pin", "y"], rel=1e-9)
    pose = found.placed.pose(model)
    assert answers["v"] == pytest.approx(pose.place("two", (0.0, 0.0))[1].rate, rel=1e-9)


@pytest.mark.parametrize("weld", ["[one.cm, two.rim]", "[one.start_, two.bottom]", "[two.top, one.cm]"])
def test_the_angle_of_what_hangs_is_that_of_the_whole_whatever_stands_for_it(weld: str) -> None:
    """On a truck, where the disc that is welded on may be the larger one of the two."""
    text = f"""
title: on a truck
given: {{L: 44 cm, m: 4.3 kg, M: 6 kg, R: 80 cm}}
surfaces: {{floor: level}}
bodies:
  one:
    parts: {{stick: {{shape: rod, mass: m, start: [0, 0], end: [L, 0]}}, head: {{shape: disc, mass: m, radius: L/4, at: [L, 0]}}}}
    points: {{start_: [0, 0]}}
  truck: {{mass: M, moves: right}}
  two: {{shape: disc, mass: M, radius: R}}
connections: {{under: {{contact: [truck, floor]}}, mount: {{hinge: [truck, one.cm]}}, bolt: {{weld: {weld}}}}}
states: {{start: {{one.angle: 50 deg, one.angular_velocity: 3 rad/s, truck.velocity: 2 m/s}}}}
find: {{a: truck.acceleration at start, alpha: one.angular_acceleration at start}}
"""
    answers = {answer.name: answer.value.float for answer in solve(text).derivation.answers if answer.value is not None}
    model = Model(configured(read_source(text)).problem, {}, "start")
    found = moment(model, placed(model))
    assert answers["a"] == pytest.approx(found.rates[model.seats["truck"].first], rel=1e-9)
    assert answers["alpha"] == pytest.approx(found.rates[model.seats["one"].turn], rel=1e-9)


@pytest.mark.parametrize("point", ["bottom", "rim", "center"])
def test_a_joint_goes_round_with_the_wheel_that_carries_it(point: str) -> None:
    """The forces at the end of a way are those of where the joint is then."""
    text = f"""
title: a plate hangs from a rolling wheel
given: {{M: 5 kg, m: 4 kg, R: 1 m, F: 40 N, d: 1.2 m}}
surfaces: {{floor: level}}
bodies:
  wheel: {{shape: disc, mass: M, radius: R, moves: right}}
  plate: {{shape: disc, mass: m, radius: R/3}}
connections: {{base: {{rolls: [wheel, floor]}}, joint: {{hinge: [wheel.{point}, plate.cm]}}}}
actions: {{pull: {{force: F, on: wheel.center, direction: right}}}}
states: {{start: {{plate.angle: 0, at rest: all}}, end: {{wheel.displacement: d}}}}
find: {{a: wheel.acceleration at end, f: base.friction_force at end, N: base.normal_force at end}}
"""
    turn = -1.2
    start = {"bottom": -math.pi / 2, "rim": 0.0, "center": 0.0}[point]
    model = Model(configured(read_source(text)).problem, {}, "end")
    at = placed(model)
    size = 0.0 if point == "center" else 1.0
    x, y = size * math.cos(start + turn), size * math.sin(start + turn)
    y0 = size * math.sin(start)
    # the plate's centre goes (1 + y, −x) per travel of the wheel
    kinetic = (7.5 + 4 * ((1 + y) ** 2 + x * x)) / 2
    speed = math.sqrt((40 * 1.2 - 4 * 9.8 * (y - y0)) / kinetic)
    q = list(at.q)
    q[2], q[3], q[4] = turn, q[0] + x, q[1] + y
    rates = [speed, 0.0, -speed, speed * (1 + y), -speed * x, 0.0]
    found = moment(model, msgspec.structs.replace(at, q=q, speed=rates))
    answers = {answer.name: answer.value.float for answer in solve(text).derivation.answers if answer.value is not None}
    assert answers["a"] == pytest.approx(found.rates[0], rel=1e-9)
    assert abs(answers["f"]) == pytest.approx(abs(found.reactions["base", "friction"]), rel=1e-9)
    assert answers["N"] == pytest.approx(found.reactions["base", "normal"], rel=1e-9)
