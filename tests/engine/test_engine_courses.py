"""Quantities that run in time: functions, whole ways, extremes within a phase and at its ends, and what is refused."""

from __future__ import annotations

import math

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

WHEEL = """title: Driven wheel
given: {{b: 6 rad/s^2, c: 1 rad/s^3, T: {time} s, R: 2 m, V: 6 rad/s, n: 72 deg/s}}
bodies: {{wheel: {{shape: disc, radius: R, turns: {turns}, points: {{P: [R/2, 0]}}}}}}
connections: {{axle: {{axle: wheel, {drive}}}}}
states: {{start: {{{start}}}, end: {{time: T}}}}
find: {{x: {find}}}
"""
BACK_AND_FORTH = "angle: b*time^2 - c*time^3"  # up to 32 rad at 4 s, fastest at 2 s


def value(
    find: str, drive: str = BACK_AND_FORTH, time: float = 5, start: str = "", turns: str = "counterclockwise"
) -> float:
    scene = WHEEL.format(find=find, drive=drive, time=time, start=start, turns=turns)
    found = solve(scene).answers["x"].float
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("find", "time", "expected"),
    [
        ("wheel.rotation from start to end", 5, 25),
        ("total wheel.rotation from start to end", 5, 39),
        ("total wheel.rotation from start to end", 3, 27),  # before it reverses there is nothing to split
        ("wheel.rim.distance from start to end", 5, 78),
        ("wheel.P.distance from start to end", 5, 39),
        ("mean wheel.P.speed from start to end", 5, 7.8),
        ("largest wheel.angular_velocity from start to end", 5, 12),
        ("largest wheel.angular_velocity from start to end", 1, 9),  # still growing: the end decides
        ("smallest wheel.angular_velocity from start to end", 5, -15),
        ("smallest wheel.angular_velocity from start to end", 3, 0),  # the start decides
        ("largest wheel.angle from start to end", 5, 32),
        ("largest wheel.angular_acceleration from start to end", 5, 12),
        ("mean wheel.angular_acceleration from start to end", 5, -3),
    ],
)
def test_courses(find: str, time: float, expected: float) -> None:
    assert value(find, time=time) == pytest.approx(expected, rel=1e-9)


def test_a_clockwise_sense_counts_the_rates_but_not_the_angle() -> None:
    assert value("wheel.angular_velocity at end", time=5, turns="clockwise") == pytest.approx(15)
    assert value("wheel.angular_acceleration at end", time=5, turns="clockwise") == pytest.approx(18)
    assert value("wheel.angle at end", time=5, turns="clockwise") == pytest.approx(25)
    assert value("wheel.rotation from start to end", time=5, turns="clockwise") == pytest.approx(-25)


def test_two_reversals_are_split_twice() -> None:
    whole = value("total wheel.rotation from start to end", drive="angular_velocity: V*cos(n*time)", time=5)
    assert whole == pytest.approx(4 * 6 / math.radians(72), rel=1e-9)


@pytest.mark.parametrize("moment", [0.0, 1.5, 4.0])
def test_a_function_has_its_values_at_any_time(moment: float) -> None:
    finds = {"angle": 6 * moment**2 - moment**3, "angular_velocity": 12 * moment - 3 * moment**2}
    for word, expected in finds.items():
        scene = WHEEL.format(
            find=f"wheel.{word} at any time", drive=BACK_AND_FORTH, time=5, start="", turns="counterclockwise"
        )
        answer = solve(scene, at=f"{moment} s").answers["x"]
        assert answer.float == pytest.approx(expected, abs=1e-9)
        assert solve(scene).answers["x"].float is None
        assert answer.formula is not None and "t" in answer.formula.symbols()


@pytest.mark.parametrize(
    ("word", "expected"), [("angular_velocity", 63), ("rotation", 49), ("turns", 49 / (2 * math.pi))]
)
def test_the_size_of_a_function_is_positive(word: str, expected: float) -> None:
    scene = WHEEL.format(
        find=f"size of wheel.{word} at any time", drive=BACK_AND_FORTH, time=8, start="", turns="counterclockwise"
    )
    assert solve(scene, at="7 s").answers["x"].float == pytest.approx(expected)


def test_a_moment_wants_a_function() -> None:
    scene = WHEEL.format(find="wheel.angle at end", drive=BACK_AND_FORTH, time=5, start="", turns="counterclockwise")
    with pytest.raises(Unsolvable, match="nothing that is asked is a function of time"):
        solve(scene, at="2 s")
    with pytest.raises(ValueError, match="is no time"):
        solve(scene.replace("at end", "at any time"), at="2 kg")


@pytest.mark.parametrize(
    ("drive", "start", "message"),
    [
        (BACK_AND_FORTH, "wheel.angular_velocity: 1 rad/s", "contradict"),
        ("angular_velocity: 3 rad/s", "at rest: wheel", "contradict"),
        ("angular_velocity: -(2 s^-1)*wheel.rotation", "", "formula of `time` alone"),
    ],
)
def test_what_a_drive_can_not_do_is_told(drive: str, start: str, message: str) -> None:
    with pytest.raises(Unsolvable, match=message):
        value("wheel.angular_velocity at end", drive=drive, start=start)


def test_what_a_driven_wheel_takes_along_turns_by_the_same_rule() -> None:
    """A rate that is given has no letter, yet the rule between angles turned is that between the rates."""
    belt = """title: Belt
given: {w: 5 rad/s, a: 2 rad/s^2, T: 3 s}
bodies: {motor: {radius: 8 cm}, drum: {radius: 20 cm}}
connections: {shaft: {axle: motor, angular_velocity: DRIVE}, spindle: {axle: drum}, strap: {belt: [motor, drum]}}
states: {start: {}, end: {time: T}}
find: {x: drum.rotation from start to end}
"""
    for drive, turned in (("w", 15.0), ("w + a*time", 24.0), ("w + a*time^2*(1 s^-1)", 33.0)):
        found = solve(belt.replace("DRIVE", drive)).answers["x"].float
        assert found == pytest.approx(turned * 8 / 20)


def test_a_function_is_not_evaluated_outside_its_phase() -> None:
    pushed = """title: Wheel pushed for a while
bodies: {wheel: {inertia: 2 kg m^2}}
connections: {axle: {axle: wheel}}
actions: {push: {couple: 3 N m, on: wheel, from: start, to: pushed}}
states: {start: at rest, pushed: {time: 1 s}, end: {time: 2 s}}
find:
  early: wheel.angular_velocity at any time from start to pushed
  late: wheel.rotation at any time from pushed to end
"""
    assert [solve(pushed, at="0.5 s").answers[name].float for name in ("early", "late")] == [pytest.approx(0.75), None]
    assert [solve(pushed, at="3 s").answers[name].float for name in ("early", "late")] == [None, pytest.approx(3)]


@pytest.mark.parametrize(
    ("find", "expected"),
    [
        ("size of brake.work from start to end", 0.25 * 60 * 0.4**2 * 25),
        ("size of (brake.work) from start to end", 0.25 * 60 * 0.4**2 * 25),
        ("size of brake.work during braking", 0.25 * 60 * 0.4**2 * 25),
        ("brake.work from start to end", -0.25 * 60 * 0.4**2 * 25),
        ("size of wheel.rotation from start to end", 8),
        ("size of axle.power at start", 0),
    ],
)
def test_the_size_of_what_belongs_to_a_phase_is_positive(find: str, expected: float) -> None:
    scene = f"""title: Wheel braked to rest while it turns clockwise
bodies: {{wheel: {{shape: disc, mass: 60 kg, radius: 40 cm}}}}
connections: {{axle: {{axle: wheel}}}}
actions: {{brake: {{press: unknown, on: wheel.rim, friction: 0.35}}}}
states: {{start: {{wheel.angular_velocity: -5 rad/s}}, end: {{wheel.rotation: -8 rad, wheel.angular_velocity: 0}}}}
phases: {{braking: {{from: start, to: end}}}}
find: {{x: {find}}}
"""
    assert solve(scene).answers["x"].float == pytest.approx(expected)


def test_the_time_under_a_torque_that_drives_back_is_an_arc_sine() -> None:
    scene = """title: Door that winds up a spring
given: {I: 0.8 kg m^2, k: 3 N m/rad, w: 5 rad/s, phi: 1 rad}
bodies: {door: {inertia: I}}
connections: {axle: {axle: door}}
actions: {spring: {couple: -k*door.rotation, on: door}}
states: {start: {door.angular_velocity: w}, turned: {door.rotation: phi}}
find: {t: time from start to turned}
"""
    swing = math.sqrt(3 / 0.8)
    assert solve(scene).answers["t"].float == pytest.approx(math.asin(swing / 5) / swing)


def test_a_body_turns_back_at_another_moment_than_it_runs_back() -> None:
    """A ball set rolling up a slope that is too smooth: dv/dt = −g (sin β − μ cos β), dω/dt = −5 μ g cos β/(2 R), by small steps."""
    found = solve("""title: Ball rolling up that begins to slip
given: {m: 1 kg, R: 0.2 m, u: 2 m/s, mu: 0.1, beta: 30 deg, T: 3 s, g: 9.8 m/s^2}
surfaces: {ramp: {slope: beta, down: left}}
bodies: {ball: {shape: sphere, mass: m, radius: R, moves: up}}
connections: {grip: {contact: [ball, ramp], friction: mu}}
states: {start: {ball.velocity: u, ball.angular_velocity: u/R}, late: {time: T}}
find: {n: total ball.rotation from start to late, s: total ball.displacement from start to late}
""")
    friction, pull, step = 0.1 * math.cos(math.pi / 6) * 9.8, math.sin(math.pi / 6) * 9.8, 1e-5
    velocity, spin, way, turn = 2.0, 10.0, 0.0, 0.0
    for _ in range(300_000):
        velocity -= (pull - friction) * step
        spin -= friction / (0.4 * 0.2) * step
        way, turn = way + abs(velocity) * step, turn + abs(spin) * step
    assert found.answers["n"].float == pytest.approx(turn, rel=1e-3)
    assert found.answers["s"].float == pytest.approx(way, rel=1e-3)
