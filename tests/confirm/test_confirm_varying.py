"""Motion under forces that vary, confirmed by stepping the equations of motion, written by hand, with Runge and Kutta's method."""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, pi, sin, sqrt

import pytest

from rotsolve.pipeline import solve
from stepping import G, answers, numbers, reach, run


def check(found: Mapping[str, float], **expected: float) -> None:
    for name, value in expected.items():
        assert found[name] == pytest.approx(value, rel=1e-7), name


def test_viscous_drag() -> None:
    def drag(t: float, x: float, v: float) -> float:
        return -0.04 * v / 0.5

    half = reach(drag, 0, 30, lambda t, x, v: v - 15, 0.01)
    late = reach(drag, 0, 30, lambda t, x, v: t - 300, 0.02)
    check(answers("flywheel-viscous-drag"), t=half[0], n=late[1] / (2 * pi), W=-0.5 * 0.5 * 30**2)


def test_torque_and_viscous_drag() -> None:
    def push(t: float, x: float, v: float) -> float:
        return (2 - 0.04 * v) / 0.5

    then = reach(push, 0, 0, lambda t, x, v: t - 20, 0.01)
    late = reach(push, 0, 0, lambda t, x, v: t - 400, 0.05)
    check(answers("flywheel-drag-at-time"), omega=then[2], phi=then[1], omega_end=late[2])


def test_air_drag() -> None:
    def push(t: float, x: float, v: float) -> float:
        return (2 - 0.005 * v * v) / 0.5

    late = reach(push, 0, 0, lambda t, x, v: t - 100, 0.02)
    near = reach(push, 0, 0, lambda t, x, v: v - 18, 0.005)
    check(answers("wheel-air-drag"), omega_end=late[2], t=near[0], phi=near[1])


def test_constant_power() -> None:
    fast = reach(lambda t, x, v: 200 / v / 0.5, 0, 5, lambda t, x, v: v - 50, 0.0005)
    check(answers("flywheel-constant-power"), t=fast[0], phi=fast[1], alpha=200 / 50 / 0.5)


def test_torque_that_falls_with_the_angle() -> None:
    def push(t: float, x: float, v: float) -> float:
        return (2 - 0.5 * x) / 0.5

    fastest = reach(push, 0, 0, push, 0.001)
    back = reach(push, 0, 0, lambda t, x, v: v, 0.001)
    check(answers("torque-falling-with-angle"), phi=fastest[1], omega=fastest[2], t=fastest[0], phi_back=back[1])


def test_torque_that_grows_with_the_angle() -> None:
    end = reach(lambda t, x, v: (3 + 0.5 * x) / 0.8, 0, 2, lambda t, x, v: x - 4, 0.001)
    check(answers("torque-growing-with-angle"), omega1=end[2], power_end=(3 + 0.5 * 4) * end[2])


def test_fall_in_air() -> None:
    def push(t: float, x: float, v: float) -> float:
        return G - 0.25 * v * v / 80

    deep = reach(push, 0, 0, lambda t, x, v: x - 200, 0.002)
    late = reach(push, 0, 0, lambda t, x, v: t - 150, 0.05)
    check(answers("parachutist"), v=deep[2], t=deep[0], a=push(*deep), v_end=late[2])


def test_compass_needle() -> None:
    def push(t: float, x: float, v: float) -> float:
        return -0.05 * sin(x) / 0.002

    back = reach(push, 0, 5, lambda t, x, v: v, 0.0001)
    check(answers("compass-needle"), phi=back[1], t=back[0])
    assert cos(back[1]) == pytest.approx(1 - 0.002 * 25 / 0.1)


def test_pulley_driven_by_a_force_of_time() -> None:
    def push(t: float, x: float, v: float) -> float:
        return 2 * (20 * t - 5 * t * t) / 10

    fastest = reach(push, 0, 0, lambda t, x, v: t - 4, 0.001)
    back = reach(push, 0, 0, lambda t, x, v: v, 0.001)
    check(answers("pulley-driven-force"), omega_max=fastest[2], t_reverse=back[0], theta_reverse=back[1])
    then = reach(push, 0, 0, lambda t, x, v: t - 3, 0.001)
    check(answers("pulley-driven-force", at="3 s"), omega=then[2], theta=then[1])


def test_flywheel_under_a_torque_that_grows_with_time() -> None:
    inertia = 40 * 0.5**2 / 2
    omega, phi, work = run(lambda t, s: (6 * t / inertia, s[0], 6 * t * s[0]), (0.0, 0.0, 0.0), 5)
    check(answers("flywheel-growing-torque"), omega=omega, phi=phi, W=work, P=6 * 5 * omega)


def test_string_between_blocks_goes_slack() -> None:
    """The tension is what the rear block needs beside its friction: m (a + mu1 g)."""

    def push(t: float, x: float, v: float) -> float:
        return (40 - 5 * t - (0.2 * 4 + 0.4 * 6) * G) / 10

    loose = reach(push, 0, 10, lambda t, x, v: 4 * (push(t, x, v) + 0.2 * G), 0.001)
    check(answers("blocks-string-goes-slack"), T0=4 * (push(0, 0, 10) + 0.2 * G), t1=loose[0], v=loose[2])


def test_rope_from_the_drum_goes_slack() -> None:
    """The rope pulls while the load would fall faster than the drum lets it."""

    def push(t: float, x: float, v: float) -> float:
        return (5 * G + 3 * t / 0.2) / (5 + 0.5 / 0.2**2)

    loose = reach(push, 0, 0, lambda t, x, v: G - push(t, x, v), 0.001)
    check(answers("drum-rope-goes-slack"), t1=loose[0], v=loose[2])


def test_spring_force_by_the_displacement() -> None:
    """A scene of its own: a block drawn back by −k x, pushed by F: half a swing about −F/k."""
    text = """
title: Pushed block on a law of force
gravity: none
given: {m: 2 kg, k: 50 N/m, F: 3 N, d: 5 cm}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}}
connections: {base: {contact: [block, floor], friction: none}}
actions: {pull: {force: -k*block.displacement - F, on: block, direction: right}}
states: {start: at rest, half: {block.displacement: -d}, far: {block.displacement: smallest}}
find: {v: block.velocity at half, t: time from start to half, whole: time from start to far}
"""

    def push(t: float, x: float, v: float) -> float:
        return (-50 * x - 3) / 2

    half = reach(push, 0, 0, lambda t, x, v: x + 0.05, 0.0005)
    check(numbers(solve(text)), v=half[2], t=half[0], whole=pi * sqrt(2 / 50))


def test_drag_on_the_second_of_two_geared_wheels() -> None:
    """The load and both wheels move as one; all masses reduced to the load."""
    text = """
title: Load on geared wheels in oil
given: {I1: 0.5 kg m^2, I2: 0.1 kg m^2, R: 20 cm, r: 10 cm, m: 2 kg, c: 0.1 N m s, T: 1 s}
bodies: {big: {inertia: I1, radius: R, turns: clockwise}, small: {inertia: I2, radius: r}, load: {mass: m, moves: down}}
connections: {a1: {axle: big}, a2: {axle: small}, teeth: {gear: [big, small]}, rope: {string: [big.rim, load]}}
actions: {drag: {couple: -c*small.angular_velocity, on: small}}
states: {start: at rest, then: {time: T}}
find: {v: load.velocity at then, x: load.displacement from start to then, W: drag.work from start to then}
"""
    mass = 2 + 0.5 / 0.2**2 + 0.1 / 0.1**2

    def push(t: float, x: float, v: float) -> float:
        return (2 * G - 0.1 * v / 0.1**2) / mass

    then = reach(push, 0, 0, lambda t, x, v: t - 1, 0.001)
    check(numbers(solve(text)), v=then[2], x=then[1], W=0.5 * mass * then[2] ** 2 - 2 * G * then[1])


def test_time_in_which_a_chain_slides_off_a_table() -> None:
    """Links of a chain on a smooth table, pulled by the weight of those that hang."""
    length, hanging = 5.0, 1.0
    time, _, speed = reach(lambda _, x, v: G * x / length, hanging, 0.0, lambda _, x, v: x - length)
    found = answers("chain-off-table")
    assert (found["t"], found["v"]) == pytest.approx((time, speed), rel=1e-9)
