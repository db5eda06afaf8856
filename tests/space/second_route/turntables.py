"""Balls and wheels on slopes and on tables that turn: Newton and Euler in numbers, the motion of the table differentiated in time."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, pi, sin
from types import SimpleNamespace as Numbers
from typing import Any, NamedTuple

import numpy as np

from second_route.particles import X, Y, Z, derivatives, disc, root, tensor, turn

Answers = dict[str, Any]
SIZE = np.linalg.norm


class Table:
    """A table, `rows` turning its own axes into those of space at a time; its face is square to its own z."""

    def __init__(self, rows: Callable[[Any], Any], scale: float = 1.0) -> None:
        self.stands, self.turns, self.faster = derivatives(rows, scale)

    def velocity(self, place: Any) -> Any:
        """The velocity of the point of the table that is at a place."""
        return self.turns @ self.stands.T @ place

    def gained(self, place: Any, going: Any) -> Any:
        """How fast that changes where the place goes along."""
        inside, along = self.stands.T @ place, self.stands.T @ going + self.turns.T @ place
        return self.faster @ inside + self.turns @ along

    def out(self) -> Any:
        return self.stands @ Z


class Rolled(NamedTuple):
    """How a ball moves: accelerations of its centre and of its turning, the force of the table, its angular velocity."""

    acceleration: Any
    faster: Any
    force: Any
    omega: Any


def ball_on(
    table: Table, mass: float, inertia: float, radius: float, gravity: float, place: Any, velocity: Any, axial: float
) -> Rolled:
    """m a = F − m g ẑ and I α = r × F; v + ω × r is the velocity of the table there, now and a little later; `axial` is ω · ẑ."""
    arm, arm_rate = -radius * table.out(), -radius * table.turns @ Z
    touched = place + arm
    cross = np.array([[0, -arm[2], arm[1]], [arm[2], 0, -arm[0]], [-arm[1], arm[0], 0]])
    omega = np.linalg.lstsq(np.vstack([-cross, Z]), np.append(table.velocity(touched) - velocity, axial), rcond=None)[0]
    left, right = np.zeros((9, 9)), np.zeros(9)
    left[:3, :3], left[:3, 6:], right[:3] = mass * np.eye(3), -np.eye(3), -mass * gravity * Z
    left[3:6, 3:6], left[3:6, 6:] = inertia * np.eye(3), -cross
    left[6:, :3], left[6:, 3:6] = np.eye(3), -cross
    right[6:] = table.gained(touched, velocity + arm_rate) - np.cross(omega, arm_rate)
    found = np.linalg.solve(left, right)
    return Rolled(found[:3], found[3:6], found[6:], omega)


def turntable(rate: float, tilt: float = 0.0) -> Table:
    """It turns about its own z axis, which leans towards x."""
    return Table(lambda time: turn(Y, tilt) @ turn(Z, rate * time), 1 / rate)


def ball_on_a_turntable(n: Numbers) -> Answers:
    place, velocity = n.r * X + n.R * Z, n.u * Y
    moves = ball_on(turntable(n.W), n.m, 0.4 * n.m * n.R**2, n.R, n.g, place, velocity, 0.0)
    size = SIZE(moves.acceleration)
    seen = velocity - np.cross(n.W * Z, place)
    told = {"n": size, "a": moves.acceleration[0], "Omega": size / n.u, "rho": n.u**2 / size}
    return {**told, "omega": moves.omega[0], "v": seen[1], "F": moves.force[0], "N": moves.force[2]}


def ball_on_a_tilted_turntable(n: Numbers) -> Answers:
    table = turntable(n.W, n.beta)
    place = turn(Y, n.beta) @ (n.r * X + n.R * Z)

    def moves(speed: float) -> Rolled:
        return ball_on(table, n.m, 0.4 * n.m * n.R**2, n.R, n.g, place, speed * Y, 0.0)

    guess = n.g * sin(n.beta) / n.W
    speed = root(lambda u: float(moves(u).acceleration[0]), guess / 10, 10 * guess)
    return {"u": speed, "F": SIZE(moves(speed).force), "a": 0.0}


def ball_across_a_slope(n: Numbers) -> Answers:
    slope = Table(lambda time: turn(Y, n.beta + 0 * time))
    moves = ball_on(slope, n.m, 0.4 * n.m * n.R**2, n.R, n.g, 0 * X, n.u * Y, 0.0)
    down = SIZE(moves.acceleration)
    return {"a": down, "alpha": moves.faster[1], "N": moves.force[2], "s": down * (n.d / n.u) ** 2 / 2}


def wheel_held_on_a_turntable(n: Numbers) -> Answers:
    """Its lowest point goes with the table, its centre stays."""
    below = turntable(n.W).velocity(n.r * X)[1]
    spin = root(lambda s: float(np.cross(s * X, -n.R * Z)[1] - below), 0.1 * below / n.R, 10 * below / n.R)
    moment = tensor(disc(n.m, n.R).turned(turn(Y, pi / 2)))[0, 0]
    return {"s": spin, "L": moment * spin}


def rod_falls_on_a_turning_shaft(n: Numbers) -> Answers:
    """J θ̈ = −½ M g L cos θ − J W² sin θ cos θ with W by the angular momentum, summed over the way: ½ ω² = −∫ θ̈ dθ."""
    moment = n.M * n.L**2 / 3
    momentum = (n.I0 + moment * cos(n.theta) ** 2) * n.w0
    nodes, weights = np.polynomial.legendre.leggauss(60)
    angles = n.theta * (1 + nodes) / 2
    rates = momentum / (n.I0 + moment * np.cos(angles) ** 2)
    faster = 3 * n.g / (2 * n.L) * np.cos(angles) + rates**2 * np.sin(angles) * np.cos(angles)
    round_, falls = momentum / (n.I0 + moment), float(np.sqrt(n.theta * weights @ faster))
    inward, down = n.L / 2 * (round_**2 + falls**2), n.L / 2 * 3 * n.g / (2 * n.L)
    return {"W": round_, "w": falls, "F": n.M * SIZE([inward, n.g - down])}


def bead_slides_down_a_hoop(n: Numbers) -> Answers:
    """θ̈ = −(g/R + W² sin θ) cos θ with W by the angular momentum, summed over the way: ½ ω² = −∫ θ̈ dθ."""
    moment, spread = n.M * n.R**2 / 2, n.m * n.R**2
    momentum = (moment + spread * cos(n.theta) ** 2) * n.w0
    nodes, weights = np.polynomial.legendre.leggauss(60)
    angles = n.theta * (1 + nodes) / 2
    rates = momentum / (moment + spread * np.cos(angles) ** 2)
    faster = (n.g / n.R + rates**2 * np.sin(angles)) * np.cos(angles)
    round_, falls = momentum / (moment + spread), float(np.sqrt(n.theta * weights @ faster))
    return {"W": round_, "w": falls, "v": n.R * SIZE([round_, falls])}


CALCULATIONS = {
    "ball-across-a-slope": ball_across_a_slope,
    "ball-on-a-tilted-turntable": ball_on_a_tilted_turntable,
    "ball-on-a-turntable": ball_on_a_turntable,
    "bead-on-a-hoop-that-turns-freely": bead_slides_down_a_hoop,
    "rod-falls-on-a-turning-shaft": rod_falls_on_a_turning_shaft,
    "wheel-held-on-a-turntable": wheel_held_on_a_turntable,
}
