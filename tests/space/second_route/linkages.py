"""Closed linkages: by linear equations for the rates of bars, and for forces and their torques, and by Lagrange's equation."""

from __future__ import annotations

from math import cos, degrees
from types import SimpleNamespace as Numbers
from typing import Any

import numpy as np

from second_route.particles import X, Y, Z, derivatives

Answers = dict[str, Any]
SIZE = np.linalg.norm


def crossing(vector: Any) -> Any:
    """The matrix of v ×."""
    return np.cross(np.eye(3), vector)


def sign_held_by_two_cables(n: Numbers) -> Answers:
    """Σ F = 0 and Σ r × F = 0 about the ball: five equations, and one that holds anyhow."""
    places = n.b * X, n.c * X
    ways = [end - place for place, end in zip(places, (n.p * Y + n.q * Z, -n.r * Y + n.s * Z), strict=True)]
    units = [way / SIZE(way) for way in ways]
    weight, middle = -n.W * Z, n.b / 2 * X - n.h / 2 * Z
    table = np.zeros((6, 5))
    for column, (place, unit) in enumerate(zip(places, units, strict=True)):
        table[:3, column], table[3:, column] = unit, np.cross(place, unit)
    table[:3, 2:] = np.eye(3)
    right = -np.concatenate([weight, np.cross(middle, weight)])
    found = np.linalg.lstsq(table, right, rcond=None)[0] / 4.4482216152605
    return {"T_BD": found[0], "T_EC": found[1], "F_A": found[2:]}


def hookes_joint(n: Numbers) -> Answers:
    """By how the second shaft's arm goes in its own plane, and by power."""

    def turned(step: Any) -> Any:
        return np.arctan(cos(n.b) * np.tan(n.q + step))

    _, slope, bend = derivatives(turned, 0.1)
    return {"w_2": slope * n.w, "alpha_2": bend * n.w**2, "phi": degrees(turned(0.0)), "M": n.T * slope}


def turning_of_bar(way: Any, columns: list[Any], right: Any, along: float) -> Any:
    """ω, or α, of a bar and the rates that go with it: v₂ − v₁ = ω × r, of which the part along r is `along`; ω · r = 0."""
    table = np.zeros((4, 3 + len(columns)))
    table[:3, :3], table[3, :3] = -crossing(way), way
    for number, column in enumerate(columns):
        table[:3, 3 + number] = -column
    return np.linalg.solve(table, np.append(right, along))


def link_between_two_cranks(n: Numbers) -> Answers:
    way, driving, driven = n.a * X + n.b * (Y + Z), -Y, -Z
    inner, outer = -n.b * Z, -n.a * X
    speed = np.cross(n.w * driving, inner)
    first = turning_of_bar(way, [np.cross(driven, outer)], -speed, 0.0)
    omega, rate = first[:3], first[3]
    faster = np.cross(n.w * driving, speed)
    inward = np.cross(rate * driven, np.cross(rate * driven, outer)) - faster - np.cross(omega, np.cross(omega, way))
    second = turning_of_bar(way, [np.cross(driven, outer)], inward, 0.0)
    return {"w_2": abs(rate), "w_n": omega, "s_n": SIZE(omega), "alpha_2": -second[3], "alpha_n": second[:3]}


def bar_on_two_skew_rods(n: Numbers) -> Answers:
    """d/dt(∂T/∂u) − ∂T/∂y = −P with T = M f(y) u²/6, f = 1 + y²/x²; then forces and torques about the centre of mass."""
    square = n.x**2 + n.y**2

    def share(step: Any) -> Any:
        return square / (square - (n.y + step) ** 2)

    slope = derivatives(share, n.x / 10)[1]
    faster = -(n.P + n.M * n.u**2 * slope / 6) / (n.M * share(0.0) / 3)
    speed = -n.u * n.y / n.x
    other = -(n.u**2 + n.y * faster + speed**2) / n.x
    way = n.x * X - n.y * Y - n.z * Z
    omega = np.cross(way, speed * X - n.u * Y) / (way @ way)
    alpha = np.cross(way, other * X - faster * Y) / (way @ way)
    inertia, moved = n.M * (way @ way) / 12, n.M * (faster * Y + other * X) / 2
    table = np.zeros((6, 4))
    for column, (arm, push) in enumerate(((-way / 2, X), (-way / 2, Z), (way / 2, Y), (way / 2, Z))):
        table[:3, column], table[3:, column] = push, np.cross(arm, push)
    pushed = -n.P * Y
    right = np.concatenate([moved + n.M * n.g * Z - pushed, inertia * alpha - np.cross(-way / 2, pushed)])
    found = np.linalg.lstsq(table, right, rcond=None)[0]
    return {"v_B": speed, "w": omega, "a_A": faster, "a_B": other, "N_A": found[0] * X + found[1] * Z}


def rod_on_two_cords(n: Numbers) -> Answers:
    """(I + M z′²) φ̈ = −M g z′ from rest, z̈ = z′ φ̈, and each cord carries half of M (g + z̈) upright."""
    high = n.h**2 - 4 * n.a**2 * np.sin(n.phi / 2) ** 2
    slope = derivatives(lambda step: -np.sqrt(n.h**2 - 4 * n.a**2 * np.sin((n.phi + step) / 2) ** 2), 0.1)[1]
    faster = -n.g * slope / (n.a**2 / 3 + slope**2)
    sinking = slope * faster
    return {"alpha": faster, "a_z": sinking, "T": n.M * (n.g + sinking) / 2 * n.h / np.sqrt(high)}


def hookes_joint_fast_and_slow(n: Numbers) -> Answers:
    """Where the first arm lies in the plane of both shafts, and where it is square to it."""
    return {"fastest": n.w / cos(n.b), "slowest": n.w * cos(n.b)}


CALCULATIONS = {
    "hookes-joint-fast-and-slow": hookes_joint_fast_and_slow,
    "rod-on-two-cords": rod_on_two_cords,
    "sign-held-by-two-cables": sign_held_by_two_cables,
    "hookes-joint": hookes_joint,
    "link-between-two-cranks": link_between_two_cranks,
    "bar-on-two-skew-rods": bar_on_two_skew_rods,
}
