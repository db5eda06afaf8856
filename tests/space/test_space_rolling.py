"""Rolling in space: balls and wheels on slopes, on bodies that turn and on such as they turn themselves.

The second route is that of `second_route.turntables`. On a turntable a ball goes round at 2/7 of its rate (Weltner, Am. J. Phys. 47, 984).
"""

from __future__ import annotations

import random
from math import cos, sin
from typing import Any

import numpy as np
import pytest

from rotsolve import Solution, Unsolvable, simulate, solve
from second_route.particles import X, Y, Z, turn
from second_route.turntables import Rolled, Table, ball_on

G = 9.81
TABLE = """up: z
gravity: 9.81 m/s^2
given:
  {{m: {m} kg, R: {R} m, x: {x} m, y: {y} m, b: {b} rad, c: {c} rad, W: {W} rad/s, A: {A} rad/s^2, u: {u} m/s, v: {v} m/s, k: {k} rad/s}}
bodies:
  table: {{shape: disc, mass: 0, turned: [{{about: y, by: b}}, {{about: z, by: c}}]}}
  ball: {{shape: SHAPE, mass: m, radius: R}}
connections:
  axis: {{hinge: table.center, along: {along}, angular_velocity: W, angular_acceleration: A}}
  grip: {{rolls: [ball, table]}}
states: {{now: {{"ball.position relative to table": [x, y, R], "ball.velocity relative to table": [u, v, 0], ball.angular_velocity.z: k}}}}
find: {{a: ball.acceleration, w: ball.angular_velocity, al: ball.angular_acceleration, F: grip.force, T: axis.torque in space axes}}
"""
SHARE = {"sphere": 0.4, "spherical shell": 2.0 / 3.0}
CIRCLE = """up: z
gravity: 9.81 m/s^2
given: {m: 0.2 kg, R: 3 cm, r: 40 cm, W: 5 rad/s, u: 0.6 m/s}
bodies: {table: {shape: disc, mass: 0}, ball: {shape: sphere, mass: m, radius: R}}
connections: {axis: {hinge: table.center, along: z, angular_velocity: W}, grip: {rolls: [ball, table]}}
states: {now: {"ball.position relative to table": [r, 0, R], ball.velocity: [0, u, 0]}}
find: {a: ball.acceleration.x}
"""
FLOOR = """up: z
gravity: 9.81 m/s^2
given: {{m: 0.2 kg, R: 3 cm, P: {push} N, u: 0.6 m/s}}
bodies: {{ball: {{shape: {shape}, mass: m, radius: R{more}}}}}
surfaces: {{floor: {floor}}}
connections: {{grip: {{rolls: [ball, floor]}}}}
actions: {{push: {{force: P, on: ball.center, direction: z}}}}
states: {{now: {{ball.velocity: [0, u, 0]{state}}}}}
find: {{a: ball.acceleration}}
"""


def drawn(seed: int) -> dict[str, Any]:
    """Numbers for a table that turns about its own z, or rocks about its own x."""
    rng = random.Random(seed)
    numbers: dict[str, Any] = {
        "m": rng.uniform(0.1, 2),
        "R": rng.uniform(0.02, 0.2),
        "x": rng.uniform(-0.5, 0.5),
        "y": rng.uniform(-0.5, 0.5),
        "W": rng.uniform(-2, 2),
        "A": rng.uniform(-2, 2),
        "u": rng.uniform(-1, 1),
        "v": rng.uniform(-1, 1),
        "k": rng.uniform(-9, 9),
        "b": rng.uniform(-0.4, 0.4),
        "c": rng.uniform(-3, 3),
    }
    numbers = {name: round(value, 3) for name, value in numbers.items()}
    return {**numbers, "along": rng.choice(("z", "x")), "shape": rng.choice(sorted(SHARE))}


def by_hand(n: dict[str, Any]) -> tuple[Rolled, Any]:
    """How the ball moves, and where the table is touched."""
    start = turn(Z, n["c"]) @ turn(Y, n["b"])
    way = {"x": X, "z": Z}[n["along"]]
    table = Table(lambda time: start @ turn(way, n["W"] * time + n["A"] * time * time / 2))
    place = start @ np.array([n["x"], n["y"], n["R"]])
    velocity = start @ np.array([n["u"], n["v"], 0]) + table.velocity(place)
    inertia = SHARE[n["shape"]] * n["m"] * n["R"] ** 2
    moves = ball_on(table, n["m"], inertia, n["R"], G, place, velocity, n["k"])
    return moves, place - n["R"] * table.out()


def vector(solution: Solution, name: str) -> Any:
    answer = next(answer for answer in solution.derivation.answers if answer.name == name)
    return np.array([part.value.float for part in answer.components])


@pytest.mark.sampled(4)
@pytest.mark.parametrize("seed", range(8))
def test_a_ball_on_a_table_that_turns_or_rocks_moves_as_newton_and_euler_say(seed: int) -> None:
    numbers = drawn(seed)
    solution = solve(TABLE.format(**numbers).replace("SHAPE", numbers["shape"]))
    hand, _ = by_hand(numbers)
    for name, known in {"a": hand.acceleration, "w": hand.omega, "al": hand.faster, "F": hand.force}.items():
        assert vector(solution, name) == pytest.approx(known, rel=1e-9, abs=1e-9), name


def test_what_holds_a_massless_table_bears_the_ball() -> None:
    numbers = drawn(1)
    scene = TABLE.format(**numbers).replace("SHAPE", numbers["shape"])
    hand, touched = by_hand(numbers)
    assert vector(solve(scene), "T") == pytest.approx(np.cross(touched, hand.force), rel=1e-9, abs=1e-9)


def test_the_circle_of_a_ball_on_a_turntable_is_followed() -> None:
    run = simulate(CIRCLE, until="2 s")
    rate, speed = 2 / 7 * 5, 0.6
    for time in (0.4, 1.1, 2.0):
        angle = rate * time
        told = run.at(time)
        expected = {"x": speed / rate * (cos(angle) - 1), "y": speed / rate * sin(angle), "z": 0}
        for axis, value in expected.items():
            number, bound = told[f"ball.position.{axis}"]
            assert abs(number - value) <= bound + 1e-15
            assert bound < 1e-8


def test_a_table_that_is_free_to_turn_is_turned_by_the_ball() -> None:
    """Its angular momentum and that of the ball about the axis stay together."""
    scene = CIRCLE.replace("mass: 0", "mass: m, radius: r").replace(", angular_velocity: W", "")
    scene = scene.replace("{now: {", "{now: {table.angular_velocity: W, ball.angular_velocity.z: 2 rad/s, ")
    run = simulate(scene, until="1 s")

    def about_axis(time: float) -> float:
        told = {name: value for name, (value, _) in run.at(time).items()}
        x, y = 0.4 + told["ball.position.x"], told["ball.position.y"]
        spin = 0.4 * 0.2 * 0.03**2 * 2.0
        orbit = 0.2 * (x * told["ball.velocity.y"] - y * told["ball.velocity.x"])
        return float(0.5 * 0.2 * 0.4**2 * told["table.angular_velocity"] + orbit + spin)

    assert about_axis(1.0) == pytest.approx(about_axis(0.0), rel=1e-9)
    assert run.at(1.0)["table.angular_velocity"][0] != pytest.approx(5, rel=1e-3)


def test_simulate_starts_with_the_velocity_that_is_told() -> None:
    floor = FLOOR.format(push="0.1", shape="sphere", more="", floor="{slope: 20 deg}", state="")
    told = simulate(floor, until="1 s").at(0.0)
    assert told["ball.velocity.y"][0] == pytest.approx(0.6, rel=1e-12)


REFUSED = {
    "beside the face": (
        CIRCLE.replace("[r, 0, R]", "[r, 0, 0]"),
        "`ball` does not touch `table` at that place",
    ),
    "a ball with a lump, of which the centre of mass stands lower than that of the ball": (
        CIRCLE.replace("[r, 0, R]", "[r, 0, R - 1 mm]"),
        "how high the centre of mass of `ball` stands above it",
    ),
    "no place": (
        CIRCLE.replace('"ball.position relative to table": [r, 0, R], ', ""),
        "where `ball` is in `table` nothing tells",
    ),
    "no face": (CIRCLE.replace("shape: disc, mass: 0", "shape: rod, length: r, mass: m"), "`table` has no flat face"),
    "a wheel on a slope": (
        FLOOR.format(
            push="0.1", shape="disc", more="", floor="{slope: 20 deg}", state=", ball.tilt: 80 deg, ball.spin: 2 rad/s"
        ),
        "which is not level, is solved for balls alone",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_does_not_roll_there_is_refused_by_name(name: str) -> None:
    scene, words = REFUSED[name]
    with pytest.raises(Unsolvable) as refused:
        solve(scene)
    assert words in str(refused.value)


@pytest.mark.parametrize(("push", "stays"), [("1", True), ("3", False)])
@pytest.mark.parametrize("floor", ["level", "{slope: 20 deg}"])
def test_a_surface_pushes_and_does_not_pull(floor: str, push: str, stays: bool) -> None:
    """m g cos β − P cos β is what it presses with."""
    solution = solve(FLOOR.format(push=push, shape="sphere", more="", floor=floor, state=""))
    failed = [check for check in solution.derivation.checks if check.holds is False]
    assert bool(failed) is not stays
    if failed:
        assert "leaves the surface" in "".join(map(str, failed[0].words))


def test_in_letters_it_is_a_condition_that_the_surface_presses() -> None:
    floor = FLOOR.format(push="0.1", shape="sphere", more="", floor="level", state="")
    solution = solve(floor.replace("P: 0.1 N", "P: N").replace("m: 0.2 kg", "m: kg"))
    (answer,) = solution.derivation.answers
    assert [str(condition) for condition in answer.conditions] or answer.otherwise


def test_a_wheel_held_on_a_turntable_is_turned_by_it() -> None:
    """W r = s R; seen from the table it runs round the other way."""
    scene = CIRCLE.replace("ball: {shape: sphere, mass: m, radius: R}", "ball: {shape: disc, mass: m, radius: R}")
    state = (
        "ball.tilt: 90 deg, ball.precession_angle: 90 deg, ball.precession: 0 rad/s, ball.spin: W*r/R, steady: true}"
    )
    scene = scene.replace("ball.velocity: [0, u, 0]}", state)
    scene = scene.replace(
        "find: {a: ball.acceleration.x}", "find: {v: ball.velocity, u_r: ball.velocity relative to table}"
    )
    solution = solve(scene)
    assert vector(solution, "v") == pytest.approx([0, 0, 0])
    assert vector(solution, "u_r") == pytest.approx([0, -2, 0])


COIN = """up: z
gravity: 9.81 m/s^2
given: {{m: 2 kg, R: 0.3 m, t: {tilt} deg, f: {phi} deg, s: -2 rad/s, p: 1.5 rad/s, n: {nutation} rad/s}}
bodies: {{coin: {{shape: disc, mass: m, radius: R}}}}
surfaces: {{floor: level}}
connections: {{grip: {{rolls: [coin, floor]}}}}
states: {{now: {{coin.tilt: t, coin.precession_angle: f, coin.precession: p, coin.nutation: n, coin.spin: s}}}}
find: {{a: coin.acceleration, F: grip.force, v: coin.velocity}}
"""


def test_a_tilt_beyond_0_to_180_degrees_is_the_same_coin_seen_from_behind() -> None:
    """θ to −θ with φ half a turn on is the same direction of the axis; it nods the other way."""
    scenes = [COIN.format(tilt=tilt, phi=phi, nutation=rate) for tilt, phi, rate in ((70, 20, 0.8), (-70, 200, -0.8))]
    one, other = (solve(scene) for scene in scenes)
    for name in ("a", "F", "v"):
        assert vector(one, name) == pytest.approx(vector(other, name), rel=1e-12)
    runs = [simulate(scene, until="0.3 s").at(0.3) for scene in scenes]
    for axis in "xyz":
        places = [run[f"coin.position.{axis}"][0] for run in runs]
        assert places[0] == pytest.approx(places[1], rel=1e-8)


def test_a_velocity_is_seen_from_any_body() -> None:
    """b moves at (1, 0, 0) at (1, 2, 0); the table turns at 3 rad/s about the origin."""
    scene = """up: z
gravity: none
given: {w: 3 rad/s}
bodies: {t: {shape: disc, mass: 1 kg, radius: 1 m}, b: {shape: particle, mass: 2 kg}}
connections: {h: {hinge: t.center, along: z, angular_velocity: w}}
actions: {push: {force: any, on: b}}
states: {now: {b.position: [1 m, 2 m, 0], b.velocity: [1 m/s, 0, 0], b.acceleration: [0, 0, 0]}}
find: {v: b.velocity relative to t, a: b.acceleration relative to t, F: b.force.coriolis relative to t}
"""
    solution = solve(scene)
    assert all(item.holds for item in solution.derivation.confirmed)
    assert vector(solution, "v") == pytest.approx([7, -3, 0])
    assert vector(solution, "a") == pytest.approx([-9, -24, 0])
    assert vector(solution, "F") == pytest.approx([-36, -84, 0])


LUMPY = """up: z
gravity: 9.81 m/s^2
given: {{m: {m} kg, n: {n} kg, R: {R} m, x: {x} m, y: {y} m, z: {z} m, p: {p} rad/s, q: {q} rad/s, r: {r} rad/s}}
bodies: {{b: {BODY}}}
surfaces: {{floor: level}}
connections: {{grip: {{rolls: [{ON}, floor]}}}}
states: {{now: {{b.angular_velocity: [p, q, r]}}}}
find: {{a: b.acceleration, F: grip.force, al: b.angular_acceleration}}
"""
LUMP = "{shape: particle, mass: n, at: [x, y, z]}"
UPRIGHT = "turned: {about: x, by: 90 deg}"  # a wheel with its axis along −y
LUMPED = {  # what rolls on what, whether it is a ball, and its moments of inertia across and along, in m R²
    "a ball among parts": (
        f"{{parts: {{s: {{shape: sphere, mass: m, radius: R, at: [0, 0, 0]}}, l: {LUMP}}}}}",
        "b.s",
        True,
        (0.4, 0.4),
    ),
    "a shell with a part": (
        f"{{shape: spherical shell, mass: m, radius: R, parts: {{l: {LUMP}}}}}",
        "b",
        True,
        (2 / 3, 2 / 3),
    ),
    "a wheel": (f"{{shape: disc, mass: m, radius: R, {UPRIGHT}}}", "b", False, (0.25, 0.5)),
    "a hoop": (f"{{shape: ring, mass: m, radius: R, {UPRIGHT}}}", "b", False, (0.5, 1.0)),
}


@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("case", LUMPED)
def test_what_is_told_by_its_angular_velocity_rolls(case: str, seed: int) -> None:
    """M a = F + M g and τ = I α + ω × I ω about the centre of mass c; the middle goes with v = ω × R u, and u, square to the axis,
    points up as far as it can: u̇ by differences.
    """
    body, on, ball, (across, along) = LUMPED[case]
    rng = random.Random(seed)
    names = {name: rng.uniform(0.1, 0.5) for name in ("m", "n", "R")} | {name: rng.uniform(-4, 4) for name in "pqr"}
    names |= {name: rng.uniform(-0.4, 0.4) * names["R"] for name in "xyz"}
    solution = solve(LUMPY.format(BODY=body, ON=on, **names))
    assert all(item.holds for item in solution.derivation.confirmed)
    lump, radius = names["n"] if ball else 0.0, names["R"]
    mass, omega, place = names["m"] + lump, np.array([names[k] for k in "pqr"]), np.array([names[k] for k in "xyz"])
    centre = lump / mass * place
    tensor = names["m"] * radius**2 * np.diag([across, along, across])
    for part, spot in ((names["m"], -centre), (lump, place - centre)):
        tensor = tensor + part * (spot @ spot * np.eye(3) - np.outer(spot, spot))
    up = np.array([0.0, 0.0, 1.0])

    def rim(time: float) -> np.ndarray:
        if ball:
            return up
        axis = np.array([0.0, 1.0, 0.0]) + time * np.cross(omega, [0.0, 1.0, 0.0])
        axis = axis / np.linalg.norm(axis)
        flat = up - axis[2] * axis
        return np.asarray(flat / np.linalg.norm(flat))

    swings = np.cross(omega, radius * (rim(1e-5) - rim(-1e-5)) / 2e-5) + np.cross(omega, np.cross(omega, centre))
    arm = -centre - radius * up

    def torque_left(alpha: np.ndarray) -> np.ndarray:
        force = mass * (np.cross(alpha, -arm) + swings + 9.81 * up)
        return np.asarray(np.cross(arm, force) - tensor @ alpha - np.cross(omega, tensor @ omega))

    rows = np.column_stack([torque_left(column) - torque_left(np.zeros(3)) for column in np.eye(3)])
    alpha = np.linalg.solve(rows, -torque_left(np.zeros(3)))
    acceleration = np.cross(alpha, -arm) + swings
    assert vector(solution, "al") == pytest.approx(alpha, rel=1e-6, abs=1e-6)
    assert vector(solution, "a") == pytest.approx(acceleration, rel=1e-6, abs=1e-6)
    assert vector(solution, "F") == pytest.approx(mass * (acceleration + 9.81 * up), rel=1e-6, abs=1e-6)


UNTOLD = {
    "parts with a radius": ("{radius: R, parts: {s: {shape: sphere, mass: m, radius: R, at: [0, 0, 0]}}}", "b.s"),
    "a sphere among parts with an axis": (
        "{radius: R, axis: x, parts: {s: {shape: sphere, mass: m, radius: R, at: [0, 0, 0]}}}",
        "b.s",
    ),
    "a told moment of inertia": ("{mass: m, radius: R, inertia: {principal: [n*R^2, n*R^2, n*R^2]}}", "a shape"),
    "a cylinder": (f"{{shape: cylinder, mass: m, radius: R, length: R, {UPRIGHT}}}", "along a line"),
}


@pytest.mark.parametrize("case", UNTOLD)
def test_what_may_be_a_wheel_or_a_ball_is_refused(case: str) -> None:
    body, said = UNTOLD[case]
    names = dict.fromkeys(("m", "n", "R", "x", "y", "z", "p", "q", "r"), 1)
    with pytest.raises(Unsolvable, match=f"(?s)(nothing tells).*{said}|{said}.*(nothing tells)"):
        solve(LUMPY.format(BODY=body, ON="b", **names))
