"""In space: states that a motion comes to, what is driven, led and carried, proved bounds, reports; and what is refused by name."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from rotsolve import SceneError, Unsolvable, simulate, solve
from rotsolve.simulation.report import csv_lines, times_of
from scenes_in_space import BOOK, COIN, GATE, GYROSCOPE, TOP, WOBBLE

LATER = ", lowest: {top.tilt: largest}, half: {top.tilt: 21 deg}, again: {top.tilt: smallest}"
FAST = {"axial": "400 rad/s", "tilt": "20 deg", "precession": "0 rad/s", "nutation": "0 rad/s"}


def test_the_lowest_tilt_is_that_of_the_cubic() -> None:
    """`rotsolve solve` tells it by energy and angular momentum; half a nutation later it is as high as at first."""
    scene = TOP.format(**FAST, later=", lowest: {top.tilt: largest}")
    found = solve(scene.replace("find: {K: top.kinetic_energy at start}", "find: {T: top.tilt at lowest}"), digits=15)
    run = simulate(TOP.format(**FAST, later=LATER), 0.3)
    lowest, half, again = run.events
    assert [event.state for event in run.events] == ["lowest", "half", "again"] and not run.unreached
    value, bound = run.at(lowest.time)["top.tilt"]
    assert abs(value - float(found.answers["T"].value)) < bound + 1e-14
    assert abs(again.time - 2 * lowest.time) < 1e-13 and lowest.time < half.time < again.time
    assert abs(run.at(half.time)["top.tilt"][0] - math.radians(21)) < 1e-14


def test_a_tilt_that_is_not_reached_is_named() -> None:
    assert simulate(TOP.format(**FAST, later=", down: {top.tilt: 60 deg}"), 0.5).unreached == ("down",)


def test_a_motion_ends_at_a_blow_and_where_a_coin_that_falls_leaves_the_table_or_lies_flat() -> None:
    blow = "events: {hit: {impulse: 1 N s, on: book.cm, direction: x, from: later, to: last}}\nfind:"
    scene = BOOK.replace("find:", blow)
    scene = scene.replace("3 m/s]}}", "3 m/s]}, later: {time: 0.5 s}, last: {}}")
    run = simulate(scene, 2)
    assert run.end == 0.5 and run.ended.startswith("`hit` happens at `later`")
    at_rest = COIN.replace(
        "coin.spin: 30 rad/s, coin.precession: 3 rad/s, coin.nutation: 1 rad/s", "coin.spin: 0 rad/s"
    )
    assert simulate(at_rest.replace("70 deg", "50 deg"), 1).ended.startswith("coin falls flat on `table`")
    run = simulate(at_rest, 1)  # from beyond 60° N = m g (1/5 + 12/5 s² − 8/5 s₀ s) vanishes before, s = sin θ
    start, sine = math.sin(math.radians(70)), math.sin(run.at(run.end)["coin.tilt"][0])
    assert run.events[0].what == "coin leaves `table`" and abs(0.2 + 2.4 * sine**2 - 1.6 * start * sine) < 1e-13


def test_a_driven_rotor_on_a_ship_takes_the_couple_that_the_laws_tell() -> None:
    """At any time W × L; at first what `solve` answers."""
    scene = """title: Rotor of a ship that turns
up: z
gravity: none
given: {I: 40 kg m^2, W: 0.2 rad/s, s: 150 rad/s, m: 300 kg, k: 20 kg m^2}
bodies:
  ship:  {mass: 0, angular_velocity: [0, 0, W]}
  rotor: {mass: m, inertia: {principal: [k, k, I]}, axis: z}
connections: {shaft: {axle: [ship, rotor], along: x, angular_velocity: s}}
find: {tau: shaft.torque in ship axes}
"""
    run = simulate(scene, 3)
    found = run.at(2.0)
    assert found["rotor.angle"][0] == 300
    for name, exact in (("x", -1200 * math.sin(0.4)), ("y", 1200 * math.cos(0.4)), ("z", 0.0)):
        value, bound = found[f"shaft.torque.{name}"]
        assert abs(value - exact) <= bound + 1e-12
    asked = solve(scene).answers["tau"].components
    assert asked is not None and abs(run.at(0.0)["shaft.torque.y"][0] - 1200) < 1e-12


def test_the_work_of_drives_leads_and_couples_is_counted() -> None:
    shaken = TOP.format(axial="100 rad/s", tilt="20 deg", precession="0 rad/s", nutation="0 rad/s", later="")
    shaken = shaken.replace(
        "bodies: {top", "bodies: {lift: {mass: 0, velocity: [0, 0, (1 m/s)*sin(time*20 rad/s)]}, top"
    )
    shaken = shaken.replace("ball: top.tip", "ball: [lift, top.tip]")
    driven = GATE.replace("cos(beta)]}}", "cos(beta)], angular_velocity: (3 rad/s)*sin(time*2 rad/s)}}")
    driven = driven.replace("released: {bar.angle: 0 deg, at rest: all}", "released: {bar.angle: 0 deg}")
    twisted = WOBBLE.replace("states:", "actions: {twist: {couple: (0.2 N m/s)*time, on: plate}}\nstates:")
    for scene in (shaken, driven, twisted):
        drift = simulate(scene, 1).drift
        assert drift.energy is not None and drift.energy < 1e-13


@pytest.mark.parametrize("scene", [BOOK, WOBBLE, GATE, COIN, GYROSCOPE])
def test_proved_bounds_meet_the_estimated_ones(scene: str) -> None:
    proved, estimated = simulate(scene, 0.1, 1e-9, certified=True), simulate(scene, 0.1, 1e-9)
    there = estimated.balls(0.1)
    assert proved.regimes[0].proved and proved.end == 0.1
    assert all(there[name].overlaps(ball) and ball.rad() < 1e-8 for name, ball in proved.balls(0.1).items())


def test_what_is_told_of_each_kind_of_body() -> None:
    run = simulate(BOOK, 1)
    columns = next(csv_lines(run, times_of(run, 0.5))).split(",")
    assert "book.angular_velocity.y in body axes" in columns and "book.position.z bound" in columns
    assert "book.tilt" not in columns and "book.x_axis.z" in columns
    printed = str(run)
    assert "kg m²/s" in printed and "angular momentum along z of `book`" in printed
    assert {"bar.angle", "axis.force.z", "axis.torque.x", "bar.position.z"} <= {*simulate(GATE, 0.1).names}


def test_a_rate_that_has_no_value_upright_is_left_out_there_alone() -> None:
    run = simulate(TOP.format(axial="20 rad/s", tilt="0 deg", precession="0 rad/s", nutation="2 rad/s", later=""), 0.1)
    assert "top.spin" not in run.at(0.0) and "top.spin" in run.at(0.05) and "top.tilt" in run.at(0.0)
    assert next(line for line in csv_lines(run, [0.0]) if line.startswith("0.0")).count(",,") >= 2


REFUSED = {
    "steady state `start`": TOP.format(**FAST, later="").replace(
        "top.precession: 0 rad/s, top.nutation: 0 rad/s", "steady: true"
    ),
    "contradict each other": TOP.format(**{**FAST, "precession": "5 rad/s"}, later="").replace(
        "top.nutation: 0 rad/s", "steady: true"
    ),
    "the tilt of `top` at first is not told": TOP.format(**FAST, later="").replace("top.tilt: theta, ", ""),
    "how fast `top` spins at first is not told": TOP.format(**{**FAST, "precession": "5 rad/s"}, later="").replace(
        "top.axial_rate: w3, ", ""
    ),
    "`vertical` alone": WOBBLE.replace("{plate.ang", "{plate.vertical: [0.6, 0, 0.8], plate.ang"),
    "what slides": BOOK.replace(
        "states: {thrown: {", "connections: {rail: {slide: book, along: x}}\nstates: {thrown: {"
    ).replace(
        '"book.angular_velocity in body axes": [0.1 rad/s, 4 rad/s, -0.2 rad/s], book.velocity: [1 m/s, 0, 3 m/s]',
        "at rest: all",
    ),
    "led by an acceleration": TOP.format(**FAST, later="")
    .replace("bodies: {top", "bodies: {lift: {mass: 0, acceleration: [0, 0, 2 m/s^2]}, top")
    .replace("ball: top.tip", "ball: [lift, top.tip]"),
    "begins with the event `hit`": BOOK.replace("3 m/s]}}", "3 m/s]}, last: {}}").replace(
        "find:", "events: {hit: {impulse: 1 N s, on: book.cm, direction: x, from: thrown, to: last}}\nfind:"
    ),
    "`T` has no number": BOOK.replace("3 m/s]}}", "3 m/s]}, last: {time: T}}").replace(
        "given: {", "given: {T: unknown, "
    ),
    "lies flat at first": COIN.replace("70 deg", "0 deg"),
    "would have to pull": COIN.replace("coin.nutation: 1 rad/s", "coin.nutation: 0 rad/s").replace(
        "precession: 3", "precession: -200"
    ),
    "of `book` across its axis is not told": BOOK.replace("{principal: [I1, I2, I3]}", "I3"),
    "`coin` touches `table` along a line": COIN.replace(
        "shape: disc, mass: m, radius: R", "shape: cylinder, mass: m, radius: R, length: R"
    ),
}


@pytest.mark.parametrize("words", REFUSED)
def test_what_is_not_followed_is_refused_by_name(words: str) -> None:
    with pytest.raises((Unsolvable, SceneError)) as refused:
        simulate(REFUSED[words], 1)
    assert words in str(refused.value)


def test_every_problem_in_space_is_followed_or_refused() -> None:
    folder = Path(__file__).resolve().parents[2] / "problems" / "space"
    followed = 0
    for path in sorted(folder.glob("*.yaml")):
        try:
            run = simulate(path, 0.05, 1e-6)
        except Unsolvable as error:
            assert error.fault.message
            continue
        followed += 1
        assert run.drift.energy is None or run.drift.energy < 1e-12, path.name
    assert followed > 25


NODS = """title: Lump that nods
up: z
given: {{g: 9.8 m/s^2, A: 6e-4 kg m^2, B: 5.5e-4 kg m^2, C: 8e-5 kg m^2, l: 5 cm}}
bodies: {{top: {{mass: 0.2 kg, inertia: {{about: tip, principal: {principal}}}, axis: {axis}, points: {{tip: {tip}}}}}}}
connections: {{floor: {{ball: top.tip}}}}
states:
  start: {{top.tilt: 20 deg, top.precession_angle: 30 deg, top.spin_angle: 50 deg,
           top.spin: 40 rad/s, top.precession: 1 rad/s, top.nutation: 2 rad/s}}
find: {{K: top.kinetic_energy}}
"""


@pytest.mark.parametrize("moments", ["ABC", "AAC"])
def test_it_is_the_same_whichever_own_axis_is_the_axis(moments: str) -> None:
    """A body without symmetry goes by its own axes, a symmetric one by axes that do not spin with it."""
    a, b, c = moments
    runs = [
        simulate(NODS.format(principal=f"[{a}, {b}, {c}]", axis="z", tip="[0, 0, -l]"), 0.5),
        simulate(NODS.format(principal=f"[{b}, {c}, {a}]", axis="y", tip="[0, -l, 0]"), 0.5),
        simulate(NODS.format(principal=f"[{c}, {a}, {b}]", axis="x", tip="[-l, 0, 0]"), 0.5),
    ]
    words = ("tilt", "precession", "spin", "nutation", "angular_momentum.x", "position.y", "kinetic_energy")
    names = [f"top.{word}" for word in words]
    one, *others = [run.at(0.45) for run in runs]
    for found in others:
        assert all(abs(one[name][0] - found[name][0]) <= one[name][1] + found[name][1] for name in names)
    for turned, axes in zip(others, ("zxy", "yzx"), strict=True):
        pairs = [(f"top.{here}_axis.x", f"top.{there}_axis.x") for here, there in zip("xyz", axes, strict=True)]
        assert all(abs(one[here][0] - turned[there][0]) <= one[here][1] + turned[there][1] for here, there in pairs)


def test_what_is_clamped_together_moves_as_one_body() -> None:
    rod, box = "{shape: rod, mass: 1 kg, length: 1 m", "{shape: cuboid, mass: 1 kg, sides: [0.1 m, 0.2 m, 0.3 m]"
    frame = "title: Hammer\nup: z\nbodies: {{{}}}\nconnections: {{{}}}\nstates: {{s: {{arm.angular_velocity: [0, 1 rad/s, 2 rad/s]}}}}\n"
    frame += "find: {{K: arm.kinetic_energy}}\n"
    bodies = f"arm: {rod}, points: {{Q: [0.5 m, 0, 0]}}}}, head: {box}}}"
    two = simulate(frame.format(bodies, "pin: {ball: arm.start}, joint: {clamp: [arm.Q, head]}"), 1).at(1.0)
    parts = (
        f"arm: {{parts: {{r: {rod}, at: [0, 0, 0]}}, b: {box}, at: [0.5 m, 0, 0]}}}}, points: {{S: [-0.5 m, 0, 0]}}}}"
    )
    one = simulate(frame.format(parts, "pin: {ball: arm.S}"), 1).at(1.0)
    for axis in "xyz":
        (value, bound), (other, wide) = one[f"arm.x_axis.{axis}"], two[f"arm.x_axis.{axis}"]
        assert abs(value - other) <= bound + wide
    energies = one["arm.kinetic_energy"][0], two["arm.kinetic_energy"][0] + two["head.kinetic_energy"][0]
    assert abs(energies[0] - energies[1]) < 1e-13 and abs(two["head.position.z"][0]) > 0.01


HUNG = """title: Disc on a hinge
up: z
gravity: none
given: {{c: 0.5 N m s, k: 0.7 N m}}
bodies: {{disc: {{shape: disc, mass: 1 kg, radius: 1 m}}}}
connections: {{pin: {{hinge: disc.center, along: z}}}}
actions: {{brake: {{couple: {couple}, on: disc, direction: z}}}}
states: {{start: {{disc.angle: 0.3 rad, disc.angular_velocity: {rate}}}}}
find: {{K: disc.kinetic_energy}}
"""


def test_a_couple_may_vary_with_the_angle_and_the_rate_about_a_hinge() -> None:
    """J = ½ kg m²: ω₀ e^(−c t/J), and φ₀ cos(t √(k/J))."""
    value, bound = simulate(HUNG.format(couple="-c*disc.angular_velocity", rate="3 rad/s"), 2).at(1.5)[
        "disc.angular_velocity"
    ]
    assert abs(value - 3 * math.exp(-1.5)) <= bound + 1e-15
    value, bound = simulate(HUNG.format(couple="-k*disc.angle/(1 rad)", rate="0 rad/s"), 2).at(1.5)["disc.angle"]
    assert abs(value - 0.3 * math.cos(1.5 * math.sqrt(1.4))) <= bound + 1e-15


def test_bars_that_begin_at_nothing_have_the_sign_that_follows() -> None:
    """∫ |sin 3 t| dt = (1 − cos 3 t)/3 at first."""
    scene = HUNG.format(couple="(1 N m)*abs(sin(3*time*1 rad/s))", rate="0 rad/s")
    value, bound = simulate(scene, 1).at(0.7)["disc.angular_velocity"]
    assert abs(value - 2 * (1 - math.cos(2.1)) / 3) <= bound + 1e-15
