"""Chains of rods at random against Lagrange's equations, and what always balances: energy, momentum, angular momentum."""

from __future__ import annotations

import math
import random

import numpy
import pytest

from rotsolve.confirm.instant import Dynamics, moment, placed
from rotsolve.confirm.model import Model
from rotsolve.motion.complete import configured
from rotsolve.scene.read import read_source

G = 9.8
Rod = tuple[float, float, float, float]  # mass, length, angle, angular velocity


def chain(rods: list[Rod]) -> str:
    """A scene of rods, each hinged to the end of the one before."""
    bodies = [
        f"  rod{k}: {{shape: rod, mass: {m!r} kg, length: {length!r} m}}" for k, (m, length, _, _) in enumerate(rods)
    ]
    pins = [f"  pin{k}: {{hinge: [rod{k - 1}.end, rod{k}.start]}}" for k in range(1, len(rods))]
    lines = [
        f"rod{k}.angle: {angle!r} rad, rod{k}.angular_velocity: {rate!r} rad/s"
        for k, (*_, angle, rate) in enumerate(rods)
    ]
    tail = [f"states: {{now: {{{', '.join(lines)}}}}}", "find: {t: 1 s}"]
    head = ["title: chain", "bodies:", *bodies, "connections:", "  pin0: {hinge: rod0.start}"]
    return "\n".join([*head, *pins, *tail])


def by_lagrange(rods: list[Rod]) -> numpy.ndarray:
    """Σ A_ij (cos(θ_i − θ_j) θ̈_j + sin(θ_i − θ_j) θ̇_j²) + g B_i cos θ_i = 0."""
    n = len(rods)
    mass, length, angle, rate = (numpy.array(column) for column in zip(*rods, strict=True))
    beyond = [sum(mass[k + 1 :]) for k in range(n)]
    a, right = numpy.zeros((n, n)), numpy.zeros(n)
    for i in range(n):
        right[i] = -G * length[i] * (mass[i] / 2 + beyond[i]) * math.cos(angle[i])
        for j in range(n):
            far = max(i, j)
            size = (mass[far] / (3 if i == j else 2) + beyond[far]) * length[i] * length[j]
            a[i, j] = size * math.cos(angle[i] - angle[j])
            right[i] -= size * math.sin(angle[i] - angle[j]) * rate[j] ** 2
    return numpy.linalg.solve(a, right)


def dynamics(text: str) -> tuple[Model, Dynamics]:
    model = Model(configured(read_source(text)).problem, {}, "now")
    at = placed(model)
    assert at.clash == 0.0
    return model, moment(model, at)


@pytest.mark.parametrize("seed", range(8))
def test_chains_of_rods_move_by_lagranges_equations(seed: int) -> None:
    draw = random.Random(seed)
    rods = [
        (
            round(draw.uniform(0.1, 5), 3),
            round(draw.uniform(0.2, 2), 3),
            round(draw.uniform(-3, 3), 3),
            round(draw.uniform(-6, 6), 3),
        )
        for _ in range(draw.randint(1, 6))
    ]
    model, found = dynamics(chain(rods))
    turning = [found.rates[model.seats[f"rod{k}"].turn] for k in range(len(rods))]
    assert turning == pytest.approx(by_lagrange(rods), rel=1e-9, abs=1e-9)
    balances(model, found)


def balances(model: Model, found: Dynamics) -> None:
    """The power of all forces is the rate of the kinetic energy; forces from outside are the rate of momentum."""
    speed, masses = found.placed.speed, model.masses
    kinetic = sum(m * v * a for m, v, a in zip(masses, speed, found.rates, strict=True))
    power = sum(part * speed[index] for load in found.loads.values() for index, part in load.items())
    assert kinetic == pytest.approx(power, rel=1e-9, abs=1e-9)
    weight = sum(seat.rigid.mass for seat in model.seats.values()) * G
    for axis, outside in ((0, 0.0), (1, -weight)):
        change = sum(masses[seat.first + axis] * found.rates[seat.first + axis] for seat in model.seats.values())
        assert change == pytest.approx(outside + found.reactions["pin0", "xy"[axis]], rel=1e-9, abs=1e-9)


def test_a_double_pendulum_let_go() -> None:
    """Two rods in line and level: θ̈₁ = −9 g/(7 L), θ̈₂ = 3 g/(7 L)."""
    model, found = dynamics(chain([(2.0, 0.5, 0.0, 0.0), (2.0, 0.5, 0.0, 0.0)]))
    assert found.rates[model.seats["rod0"].turn] == pytest.approx(-9 * G / 3.5)
    assert found.rates[model.seats["rod1"].turn] == pytest.approx(3 * G / 3.5)


def test_a_body_cut_in_two_and_welded_is_whole() -> None:
    """Accelerations as of one rod; the weld holds what the far half needs."""
    scene = """
title: halves
bodies: {{{bodies}}}
connections: {{pin: {{hinge: near.start}}{weld}}}
states: {{now: {{near.angle: 20 deg, near.angular_velocity: 3 rad/s}}}}
find: {{t: 1 s}}"""
    whole, found = dynamics(scene.format(bodies="near: {shape: rod, mass: 4 kg, length: 1 m}", weld=""))
    halves = "near: {shape: rod, mass: 2 kg, length: 0.5 m}, far: {shape: rod, mass: 2 kg, length: 0.5 m}"
    model, parts = dynamics(scene.format(bodies=halves, weld=", joint: {weld: [near.end, far.start]}"))
    assert parts.rates[model.seats["far"].turn] == pytest.approx(found.rates[whole.seats["near"].turn])
    for axis in "xy":
        assert parts.reactions["pin", axis] == pytest.approx(found.reactions["pin", axis])


def test_a_braced_rod_is_told_to_be_held_twice() -> None:
    """Of two hinges in line only the sum of the forces along them is known; the others are."""
    text = """
title: twice
bodies: {rod: {shape: rod, mass: 2 kg, length: 1 m}}
connections: {left: {hinge: rod.start}, right: {hinge: rod.end}}
states: {now: {rod.angle: 0, at rest: all}}
find: {t: 1 s}"""
    model = Model(read_source(text), {}, "now")  # the laws refuse it
    found = moment(model, placed(model))
    assert found.open_reactions == {("left", "x"), ("right", "x")}
    assert found.reactions["left", "y"] == pytest.approx(G)
    assert found.rates == pytest.approx([0.0] * model.size, abs=1e-12)
