"""Motion under forces that vary, confirmed by stepping the equations of motion, written by hand, with Runge and Kutta's method."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, pi, sin, sqrt
from pathlib import Path

import pytest

from rotsolve.pipeline import solve
from rotsolve.solution import Solution

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
G = 9.8
Moment = tuple[float, float, float]  # time, place, speed
Push = Callable[[float, float, float], float]  # acceleration at a time, place and speed


def step(push: Push, now: Moment, h: float) -> Moment:
    """One step of the fourth order."""
    t, x, v = now
    k1, l1 = v, push(t, x, v)
    k2, l2 = v + h * l1 / 2, push(t + h / 2, x + h * k1 / 2, v + h * l1 / 2)
    k3, l3 = v + h * l2 / 2, push(t + h / 2, x + h * k2 / 2, v + h * l2 / 2)
    k4, l4 = v + h * l3, push(t + h, x + h * k3, v + h * l3)
    return t + h, x + h * (k1 + 2 * k2 + 2 * k3 + k4) / 6, v + h * (l1 + 2 * l2 + 2 * l3 + l4) / 6


def until(push: Push, v: float, end: Callable[[Moment], float], h: float) -> Moment:
    """From the place 0 at the time 0 to where `end` changes its sign, the last step cut to fit."""
    now = (0.0, 0.0, v)
    first = end(step(push, now, h)) > 0
    while (end(step(push, now, h)) > 0) == first:
        now = step(push, now, h)
    low, high = 0.0, h
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if (end(step(push, now, middle)) > 0) == first else (low, middle)
    return step(push, now, high)


def answers(name: str) -> Solution:
    return solve(PROBLEMS / f"{name}.yaml")


def check(solution: Solution, **expected: float) -> None:
    for name, value in expected.items():
        assert solution.answers[name].float == pytest.approx(value, rel=1e-7), name


def test_viscous_drag() -> None:
    def drag(t: float, x: float, v: float) -> float:
        return -0.04 * v / 0.5

    half = until(drag, 30, lambda now: now[2] - 15, 0.01)
    late = until(drag, 30, lambda now: now[0] - 300, 0.02)
    check(answers("flywheel-viscous-drag"), t=half[0], n=late[1] / (2 * pi), W=-0.5 * 0.5 * 30**2)


def test_torque_and_viscous_drag() -> None:
    def push(t: float, x: float, v: float) -> float:
        return (2 - 0.04 * v) / 0.5

    then = until(push, 0, lambda now: now[0] - 20, 0.01)
    late = until(push, 0, lambda now: now[0] - 400, 0.05)
    check(answers("flywheel-drag-at-time"), omega=then[2], phi=then[1], omega_end=late[2])


def test_air_drag() -> None:
    def push(t: float, x: float, v: float) -> float:
        return (2 - 0.005 * v * v) / 0.5

    late = until(push, 0, lambda now: now[0] - 100, 0.02)
    near = until(push, 0, lambda now: now[2] - 18, 0.005)
    check(answers("wheel-air-drag"), omega_end=late[2], t=near[0], phi=near[1])


def test_constant_power() -> None:
    fast = until(lambda t, x, v: 200 / v / 0.5, 5, lambda now: now[2] - 50, 0.0005)
    check(answers("flywheel-constant-power"), t=fast[0], phi=fast[1], alpha=200 / 50 / 0.5)


def test_torque_that_falls_with_the_angle() -> None:
    def push(t: float, x: float, v: float) -> float:
        return (2 - 0.5 * x) / 0.5

    fastest = until(push, 0, lambda now: push(*now), 0.001)
    back = until(push, 0, lambda now: now[2], 0.001)
    check(answers("torque-falling-with-angle"), phi=fastest[1], omega=fastest[2], t=fastest[0], phi_back=back[1])


def test_torque_that_grows_with_the_angle() -> None:
    end = until(lambda t, x, v: (3 + 0.5 * x) / 0.8, 2, lambda now: now[1] - 4, 0.001)
    check(answers("torque-growing-with-angle"), omega1=end[2], power_end=(3 + 0.5 * 4) * end[2])


def test_fall_in_air() -> None:
    def push(t: float, x: float, v: float) -> float:
        return G - 0.25 * v * v / 80

    deep = until(push, 0, lambda now: now[1] - 200, 0.002)
    late = until(push, 0, lambda now: now[0] - 150, 0.05)
    check(answers("parachutist"), v=deep[2], t=deep[0], a=push(*deep), v_end=late[2])


def test_compass_needle() -> None:
    def push(t: float, x: float, v: float) -> float:
        return -0.05 * sin(x) / 0.002

    back = until(push, 5, lambda now: now[2], 0.0001)
    check(answers("compass-needle"), phi=back[1], t=back[0])
    assert cos(back[1]) == pytest.approx(1 - 0.002 * 25 / 0.1)


def test_pulley_driven_by_a_force_of_time() -> None:
    def push(t: float, x: float, v: float) -> float:
        return 2 * (20 * t - 5 * t * t) / 10

    fastest = until(push, 0, lambda now: now[0] - 4, 0.001)
    back = until(push, 0, lambda now: now[2], 0.001)
    check(answers("pulley-driven-force"), omega_max=fastest[2], t_reverse=back[0], theta_reverse=back[1])
    then = until(push, 0, lambda now: now[0] - 3, 0.001)
    check(solve(PROBLEMS / "pulley-driven-force.yaml", at="3 s"), omega=then[2], theta=then[1])


def test_string_between_blocks_goes_slack() -> None:
    """The tension is what the rear block needs beside its friction: m (a + mu1 g)."""

    def push(t: float, x: float, v: float) -> float:
        return (40 - 5 * t - (0.2 * 4 + 0.4 * 6) * G) / 10

    loose = until(push, 10, lambda now: 4 * (push(*now) + 0.2 * G), 0.001)
    check(answers("blocks-string-goes-slack"), T0=4 * (push(0, 0, 10) + 0.2 * G), t1=loose[0], v=loose[2])


def test_rope_from_the_drum_goes_slack() -> None:
    """The rope pulls while the load would fall faster than the drum lets it."""

    def push(t: float, x: float, v: float) -> float:
        return (5 * G + 3 * t / 0.2) / (5 + 0.5 / 0.2**2)

    loose = until(push, 0, lambda now: G - push(*now), 0.001)
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

    half = until(push, 0, lambda now: now[1] + 0.05, 0.0005)
    check(solve(text), v=half[2], t=half[0], whole=pi * sqrt(2 / 50))


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

    then = until(push, 0, lambda now: now[0] - 1, 0.001)
    check(solve(text), v=then[2], x=then[1], W=0.5 * mass * then[2] ** 2 - 2 * G * then[1])
