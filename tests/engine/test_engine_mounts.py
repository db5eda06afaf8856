"""Axles on bodies that move: trucks on rails and slopes, swinging rods, blocks on strings; also from one state to another."""

from __future__ import annotations

from math import sqrt

import pytest

from rotsolve.pipeline import solve

G = 9.8
GIVEN = (
    "title: x\ngiven: {M: 20 kg, m: 10 kg, R: 25 cm, F: 45 N, Q: 2 N m, L: 1 m, b: 30 deg, d: 200 cm, w0: 4 rad/s}\n"
)
WHEEL = "wheel: {shape: disc, mass: m, radius: R}"
TRUCK = GIVEN + f"surfaces: {{rails: level}}\nbodies: {{truck: {{mass: M, moves: right}}, {WHEEL}}}\n"
PUSHED = "actions: {push: {force: F, on: truck, direction: right}, turn: {couple: Q, on: wheel}}\n"
ROD = (
    GIVEN
    + f"bodies: {{rod: {{shape: rod, mass: M, length: L}}, {WHEEL}}}\nconnections: {{pin: {{hinge: rod.start}}, axle: {{axle: ORDER}}}}\n"
)
FALLS = "states: {start: {rod.angle: 0, at rest: all}, end: {rod.angle: -90 deg}}\n"

I_WHEEL = 10 * 0.25**2 / 2
SPIN = 2 / I_WHEEL * sqrt(6) / 1.5  # Q t/I
HEAVY = 20 / 3 + 10  # (M/3 + m) L²
ARM = 20 / 2 + 10  # (M/2 + m) L

CASES = {
    "truck": (
        TRUCK + "connections: {under: {contact: [truck, rails]}, axle: {axle: ORDER}}\n" + PUSHED
        + "states: {start: at rest, end: {truck.displacement: d}}\n",
        "truck, wheel",
        {
            "a: truck.acceleration at start": 1.5,
            "N: under.normal_force at start": 30 * G,
            "Fx: axle.force.x at start": 15,
            "v: truck.velocity at end": sqrt(6),
            "p: momentum at end": 30 * sqrt(6),
            "w: wheel.angular_velocity at end": SPIN,
            "K: kinetic_energy at end": 90 + I_WHEEL * SPIN**2 / 2,
            "W: push.work from start to end": 90,
        },
    ),
    "truck on a slope": (
        TRUCK.replace("rails: level", "rails: {slope: b, down: right}")
        + "connections: {under: {contact: [truck, rails]}, axle: {axle: ORDER}}\nstates: {start: at rest, end: {time: 2 s}}\n",
        "truck, wheel",
        {
            "a: truck.acceleration at start": G / 2,
            "N: under.normal_force at start": 30 * G * sqrt(3) / 2,
            "alpha: wheel.angular_acceleration at start": 0,
            "v: truck.velocity at end": G,
        },
    ),
    "truck on its own wheel": (
        TRUCK + "connections: {under: {rolls: [wheel, rails]}, axle: {axle: ORDER}}\n"
        "actions: {push: {force: F, on: truck, direction: right}}\nstates: {start: at rest, end: {truck.displacement: d}}\n",
        "truck, wheel",
        {
            "a: truck.acceleration at start": 45 / 35,
            "f: under.friction_force at start": 5 * 45 / 35,
            "w: wheel.angular_velocity at end": sqrt(2 * 90 / 35) / 0.25,
        },
    ),
    "block on a string": (
        GIVEN + f"bodies: {{block: {{mass: M, moves: up}}, {WHEEL}}}\n"
        "connections: {rope: {string: [ceiling, block]}, axle: {axle: ORDER}}\nstates: {rest: {balance: true}}\n",
        "block, wheel",
        {"T: rope.tension": 30 * G, "Fy: axle.force.y": 10 * G},
    ),
    "swinging rod": (
        ROD + FALLS,
        "rod.end, wheel",
        {
            "alpha: rod.angular_acceleration at start": -ARM * G / HEAVY,
            "w: rod.angular_velocity at end": -sqrt(2 * ARM * G / HEAVY),
            "spin: wheel.angular_velocity at end": 0,
            "v: wheel.cm.speed at end": sqrt(2 * ARM * G / HEAVY),
        },
    ),
    "turning rod": (
        ROD.replace("bodies", "gravity: none\nbodies", 1)
        + "actions: {turn: {couple: Q, on: rod}}\nstates: {start: {rod.angular_velocity: w0, wheel.angular_velocity: 0}}\n",
        "rod.end, wheel",
        {
            "alpha: rod.angular_acceleration": 2 / HEAVY,
            "K: kinetic_energy": HEAVY * 16 / 2,
            "a: wheel.cm.acceleration.normal": 16,
            "Kw: wheel.kinetic_energy": 80,
            "p: wheel.momentum": 40,
        },
    ),
}  # fmt: skip


@pytest.mark.parametrize("turned_round", [False, True], ids=["mount first", "wheel first"])
@pytest.mark.parametrize(("moved", "order", "true"), CASES.values(), ids=CASES)
def test_a_mount_moves_with_what_it_carries(moved: str, order: str, true: dict[str, float], turned_round: bool) -> None:
    first, second = order.split(", ")
    named = f"[{second}, {first}]" if turned_round else f"[{first}, {second}]"
    answers = solve(moved.replace("ORDER", named) + f"find: {{{', '.join(true)}}}\n").answers
    for question, value in true.items():
        found = answers[question.partition(":")[0]].float
        sign = -1 if turned_round and question.startswith("F") else 1  # the force is that on the last-named body
        assert found == pytest.approx(value * sign, rel=1e-6, abs=1e-9), question


def test_bodies_on_one_fixed_axle_stay_there() -> None:
    """What no other connection moves is held by the axle, also where another axle holds it at the same point."""
    scene = GIVEN + f"bodies: {{table: {{inertia: 3 kg m^2}}, {WHEEL}, other: {{inertia: 1 kg m^2}}}}\n"
    scene += "connections: {one: {axle: [table, wheel]}, two: {axle: [table, other]}}\n"
    scene += "actions: {turn: {couple: Q, on: table}}\nfind: {alpha: table.angular_acceleration, beta: other.angular_acceleration}\n"
    answers = solve(scene).answers
    assert answers["alpha"].float == pytest.approx(2 / 3)
    assert answers["beta"].float == 0


def test_a_tile_hung_from_a_truck_is_told_by_the_angle_of_its_centre() -> None:
    """`angle` is that of the direction from the hinge to the centre of mass, on a truck as on the ground."""
    for point in ("P: [R/2, 0]", "P: [-R/2, 0]", "P: [0, R/2]"):
        scene = TRUCK.replace("radius: R", f"radius: R, points: {{{point}}}")
        scene += "connections: {under: {contact: [truck, rails]}, axle: {axle: [truck, wheel.P]}}\n"
        scene += "states: {start: {at rest: all, wheel.angle: 0}}\nfind: {alpha: wheel.angular_acceleration}\n"
        assert solve(scene).answers["alpha"].float == pytest.approx(-2 * G / (3 * 0.25))


HAMMER = "{parts: {stick: {shape: rod, mass: m, start: [0, 0], end: [L, 0]}, head: {mass: 2*m, at: [L, 0]}}, points: {grip: [0, 0]}}"
PLATE = "{shape: rectangle, mass: m, sides: [L, L/2]}"


@pytest.mark.parametrize("order", ["mount, wheel", "wheel, mount"])
@pytest.mark.parametrize(
    ("body", "hinge", "named", "arm"),
    [
        (HAMMER, "grip", "mount", 2.5 / 3),
        (HAMMER, "grip", "mount.head", 1.0),
        (PLATE, "corner1", "mount", (1 / 4 + 1 / 16) ** 0.5),
        ("{shape: rod, mass: m, length: L}", "start", "mount", 0.5),
    ],
)
def test_a_mount_named_alone_carries_at_its_centre(body: str, hinge: str, named: str, arm: float, order: str) -> None:
    """The wheel goes round the hinge with the mount, as far from it as the mount's centre of mass is."""
    axle = order.replace("mount", named)
    scene = f"""
given: {{L: 1 m, m: 3 kg, R: 0.5 m, a: 2 rad/s}}
bodies: {{mount: {body}, wheel: {{shape: ring, mass: m, radius: R}}}}
connections: {{pin: {{hinge: mount.{hinge}}}, spindle: {{axle: [{axle}]}}}}
states: {{now: {{mount.angle: 0, mount.angular_velocity: a, wheel.angular_velocity: 0}}}}
find: {{K: wheel.kinetic_energy, p: wheel.momentum.y}}
"""
    answers = solve(scene, digits=9).answers
    assert answers["K"].float == pytest.approx(0.5 * 3 * (2 * arm) ** 2, rel=1e-8)
    assert answers["p"].float == pytest.approx(3 * 2 * arm, rel=1e-8)
