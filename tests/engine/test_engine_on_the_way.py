"""On the way: what presses least between two states is a condition there; where letters do not tell it, the page says so."""

from __future__ import annotations

import math

import pytest

import rotsolve
from rotsolve.confirm.course.samples import holding
from rotsolve.core.derivation import Answer

ROD = """
title: Rod with a lump tips on a rough floor
given: {M: kg, m: kg, L: m, x: m, theta: deg, phi: deg}
surfaces: {floor: level}
bodies: {rod: {shape: rod, mass: M, length: L, turns: clockwise}, lump: {mass: m}}
connections: {foot: {contact: [rod.start, floor], friction: any}, knot: {weld: [rod.at(x), lump]}}
states: {up: {rod.angle: theta, at rest: all}, there: {rod.angle: phi}}
find: {w: rod.angular_velocity at there}
"""


def pressed(m: float, x: float, theta: float, at: float) -> float:
    """N at an angle of a rod of 1 kg and 1 m let go at θ that turns about its foot: N = Σ m (g + a_y), from α and ω² by energy."""
    g, inertia, moment = 9.8, 1 / 3 + m * x**2, 0.5 + m * x
    alpha = moment * g * math.cos(at) / inertia
    square = 2 * moment * g * (math.sin(theta) - math.sin(at)) / inertia
    return (1 + m) * g - moment * (alpha * math.cos(at) + square * math.sin(at))


@pytest.fixture(scope="module")
def answer() -> Answer:
    return rotsolve.solve(ROD, confirm=False).answers["w"].answer


@pytest.mark.sampled(4)
@pytest.mark.parametrize("x", [0.4, 0.7, 1.0])
@pytest.mark.parametrize("m", [0.2, 1.0, 4.0])
def test_a_rod_presses_on_its_floor_where_it_does_so_least(answer: Answer, m: float, x: float) -> None:
    """The printed conditions hold where N > 0 all the way, found by looking at a thousand places, and only there."""
    told = set()
    for theta in (40, 60, 80, 89):
        for phi in (2, 10, 25, 38):
            numbers = {
                "M": 1.0,
                "m": m,
                "L": 1.0,
                "x": x,
                "theta": math.radians(theta),
                "phi": math.radians(phi),
                "g": 9.8,
            }
            way = (math.radians(phi + part * (theta - phi) / 1000) for part in range(1001))
            stays = min(pressed(m, x, numbers["theta"], at) for at in way) > 0
            assert (holding(answer, numbers) is not None) == stays
            told.add(stays)
    assert True in told


def test_some_rods_lift_only_on_the_way() -> None:
    angles = [math.radians(angle) for angle in range(5, 86)]
    sizes = [pressed(1.0, 1.0, angles[-1], angle) for angle in angles]
    assert min(sizes[0], sizes[-1]) > 0 > min(sizes)


@pytest.mark.exhaustive
def test_what_letters_do_not_tell_of_the_way_is_said() -> None:
    scene = """
title: Rod let go upright on a rough floor
given: {m: 2 kg, L: 1 m, theta: deg, phi: deg, mu: number}
surfaces: {floor: level}
bodies: {rod: {shape: rod, mass: m, length: L, turns: clockwise}}
connections: {foot: {contact: [rod.start, floor], friction: mu}}
states: {up: {rod.angle: theta, at rest: all}, there: {rod.angle: phi}}
find: {w: rod.angular_velocity at there}
"""
    checks = [str(check.words) for check in rotsolve.solve(scene, confirm=False).checks if check.holds is None]
    assert any("whether foot slips on the way from up to there" in words for words in checks)


@pytest.mark.exhaustive
def test_a_string_is_taut_up_to_a_stop_that_the_scene_does_not_name() -> None:
    """A couple Q − c t lifts a load and fades: just before it stops T = m (g − R (c t + τ + m g R − Q)/(I + m R²)) is least."""
    scene = """
title: Couple that fades lifts a load on a drum with a rubbing axle
given: {I: kg m^2, R: m, m: kg, Q: N m, c: N m/s, tau: N m, T1: s}
bodies: {drum: {inertia: I, radius: R, turns: counterclockwise}, load: {mass: m, moves: up}}
connections: {axle: {axle: drum, friction_torque: tau}, rope: {string: [drum, load]}}
actions: {motor: {couple: Q - c*time, on: drum}}
states: {start: {at rest: all}, end: {time: T1}}
find: {v: load.velocity at end}
"""
    answer = rotsolve.solve(scene, confirm=False).answers["v"].answer
    numbers = {"R": 1.0, "m": 1.0, "tau": 5.0, "T1": 1.0, "g": 9.8}
    assert holding(answer, {**numbers, "I": 0.01, "Q": 30.0, "c": 33.0}) is None
    assert holding(answer, {**numbers, "I": 2.0, "Q": 30.0, "c": 33.0}) is not None
