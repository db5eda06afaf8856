"""Rotations, what they leave free, and the work of a force in a small turn."""

from __future__ import annotations

from math import acos, cos, degrees, pi, sin
from types import SimpleNamespace as Numbers
from typing import Any

import numpy as np

from second_route.particles import Motion, X, Y, Z, derivatives, turn, with_moments

Answers = dict[str, Any]
SIZE = np.linalg.norm


def product(one: Any, other: Any) -> Any:
    """Of quaternions."""
    real = one[0] * other[0] - one[1:] @ other[1:]
    return np.array([real, *(one[0] * other[1:] + other[0] * one[1:] + np.cross(one[1:], other[1:]))])


def quaternion(axis: Any, angle: float) -> Any:
    return np.array([cos(angle / 2), *(sin(angle / 2) * axis)])


def carried_along(one: Any, vector: Any) -> Any:
    """q v q*."""
    return product(product(one, np.array([0, *vector])), one * [1, -1, -1, -1])[1:]


def finite_rotations(n: Numbers) -> Answers:
    about_x, about_y = quaternion(X, n.phi), quaternion(Y, n.phi)
    both = {"a": product(about_y, about_x), "b": product(about_x, about_y)}
    return {name: carried_along(one, Z) for name, one in both.items()}


def two_turns_are_one(n: Numbers) -> Answers:
    whole, quarters = (product(quaternion(Z, angle), quaternion(X, angle)) for angle in (n.phi, pi / 2))
    return {"beta": degrees(2 * acos(whole[0])), "n": quarters[1:] / SIZE(quarters[1:])}


def euler_angles(n: Numbers) -> Answers:
    """The matrix of three turns, and its derivative: Rᵀ Ṙ has ω in the body's axes."""

    def attitude(t: Any) -> Any:
        return turn(Z, n.phid * t) @ turn(X, n.theta + n.thetad * t) @ turn(Z, n.psi + n.psid * t)

    rate = abs(n.phid) + abs(n.thetad) + abs(n.psid)
    now, change, _ = derivatives(attitude, 1 / rate)
    own = now.T @ change
    body = with_moments(1.0, n.I1, n.I2, n.I3)
    energy = Motion.about_origin(body, attitude, rate).kinetic_energy()
    return {"w": np.array([own[2, 1], own[0, 2], own[1, 0]]), "T": energy}


def torque_of_a_force(n: Numbers) -> Answers:
    """The work of the force in a small turn, by the angle."""
    force, at = np.array([n.P, -n.Q, n.S]), np.array([n.a, n.b, -n.c])
    torque = np.array([derivatives(lambda t, axis=axis: force @ turn(axis, t) @ at, 1.0)[1] for axis in (X, Y, Z)])
    return {"tau": torque, "tau_0": SIZE(torque)}


def held(*items: tuple[Any, str]) -> list[Any]:
    """For each place the directions in which its velocity v + ω × r is zero, as rows for (v, ω)."""
    axes = dict(zip("xyz", np.eye(3), strict=True))
    return [np.array([*axes[word], *np.cross(place, axes[word])]) for place, words in items for word in words]


def left_free(rows: list[Any]) -> int:
    return 6 - (int(np.linalg.matrix_rank(np.array(rows))) if rows else 0)


def kinematic_pairs(n: Numbers) -> Answers:
    """Each pair by the places that it holds: a screw is a sleeve whose nut gets on by the pitch p in a turn."""
    sleeve, hinge, ball = held((0 * Z, "xy"), (Z, "xy")), held((0 * Z, "xyz"), (Y, "xyz")), held((0 * Z, "xyz"))
    seat, slide = held((0 * Z, "z"), (X, "z"), (Y, "z")), [*sleeve, *held((X, "y"))]
    screw = [*sleeve, np.array([0, 0, 1, 0, 0, -0.002 / (2 * pi)])]
    no_turn, no_shift = list(np.eye(6)[3:]), list(np.eye(6)[:3])
    found = {"free_f": [], "b_f": ball, "h_f": hinge, "rev": hinge, "pri": slide, "scr": screw, "cyl": sleeve}
    more = {"sph": ball, "pla": seat, "pla_t": seat + no_turn, "pla_r": seat + no_shift}
    return {name: left_free(rows) for name, rows in (found | more).items()}


CALCULATIONS = {
    "euler-angles": euler_angles,
    "finite-rotations": finite_rotations,
    "kinematic-pairs": kinematic_pairs,
    "torque-of-a-force": torque_of_a_force,
    "two-turns-are-one": two_turns_are_one,
}
