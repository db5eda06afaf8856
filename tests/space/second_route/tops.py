"""Tops and gyroscopes on a fixed point: steady ones as heavy points, those that nod as an axis e and L = I₁ e × ė + I₃ ω₃ e, followed."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, pi, sin, sqrt
from types import SimpleNamespace as Numbers
from typing import Any

import numpy as np

from second_route.following import cross, first_passage, followed
from second_route.particles import (
    Cloud,
    Motion,
    X,
    Y,
    Z,
    ring,
    root,
    tensor,
    top,
    turn,
    with_moments,
)

Answers = dict[str, Any]
SIZE = np.linalg.norm


def steady(cloud: Cloud, tilt: float, spin: float, round_: float, lift: float = 0.0) -> Motion:
    """A body about its tip, which precesses and spins steadily; the tip may be led upwards with an acceleration."""

    def places(t: Any) -> Any:
        attitude = turn(Z, round_ * t) @ turn(X, tilt) @ turn(Z, spin * t)
        return lift * t * t / 2 * Z + cloud.places @ attitude.T

    return Motion(cloud, places, abs(spin) + abs(round_))


def lacking(cloud: Cloud, tilt: float, spin: float, round_: float, gravity: float, lift: float = 0.0) -> float:
    """The torque along the line of nodes that a steady motion lacks, beside the weight's."""
    return float(steady(cloud, tilt, spin, round_, lift).torque(-gravity * Z)[0])


def precessions(lack: Callable[[float], float], scale: float) -> list[float]:
    """The rates for which nothing lacks: a polynomial of the second degree through three values, by rising size."""
    quadratic = np.polyfit([-scale, 0.0, scale], [lack(rate) for rate in (-scale, 0.0, scale)], 2)
    quadratic[np.abs(quadratic) * [scale**2, scale, 1] < 1e-12 * max(np.abs(quadratic) * [scale**2, scale, 1])] = 0
    return sorted(np.roots(np.trim_zeros(quadratic, "f")).tolist(), key=abs)


def whole_top(n: Numbers) -> Cloud:
    return top(n.M, n.l, n.I1, n.I3)


def leaning_top(n: Numbers) -> Answers:
    """The spin about the own axis is ω₃ − Ω cos θ."""
    body = whole_top(n)
    slow, fast = precessions(lambda rate: lacking(body, n.theta, n.w3 - rate * cos(n.theta), rate, n.g), n.w3 / 8)
    return {"slow": slow, "fast": fast}


def leaning_top_least_spin(n: Numbers) -> Answers:
    """The spin that a precession needs is least where its derivative is zero."""

    def needed(rate: Any) -> Any:
        axis = sin(n.theta) * -Y + cos(n.theta) * Z
        across = Z - cos(n.theta) * axis
        weight = np.cross(n.l * axis, -n.M * n.g * Z)[0]
        return (weight - np.cross(rate * Z, n.I1 * rate * across)[0]) / (np.cross(rate * Z, n.I3 * axis)[0])

    def slope(rate: float) -> float:
        return float(np.imag(needed(rate + 1e-30j)) * 1e30)

    guess = sqrt(n.M * n.g * n.l / n.I1)
    return {"w_s": needed(root(slope, guess / 5, guess * 5))}


def gyroscope_level(n: Numbers) -> Answers:
    body = ring(n.M, n.R).moved(n.l * Z)
    (rate,) = precessions(lambda rate: lacking(body, pi / 2, n.s, rate, n.g), 1.0)
    force = steady(body, pi / 2, n.s, rate).force(-n.g * Z)
    return {"Omega": rate, "N": force[2], "F": force[1]}


def gyroscope_in_a_lift(n: Numbers) -> Answers:
    body = ring(n.M, n.R).moved(n.l * Z)
    (rate,) = precessions(lambda rate: lacking(body, pi / 2, n.s, rate, n.g, n.a), 1.0)
    return {"Omega": rate, "N": steady(body, pi / 2, n.s, rate, n.a).force(-n.g * Z)[2]}


def wheel_on_a_string(n: Numbers) -> Answers:
    body = with_moments(n.M, n.I1, n.I1, n.I3).moved(n.d * Z)
    (rate,), (other,) = (
        precessions(lambda rate, spin=spin: lacking(body, pi / 2, spin, rate, n.g), 1.0) for spin in (n.s, -n.s)
    )
    motion = steady(body, pi / 2, n.s, rate)
    weight = motion.masses @ np.cross(motion.places, -n.g * Z)
    own = motion.angular_momentum() @ (turn(X, pi / 2) @ Z)
    return {"tau": SIZE(weight), "L": own, "Omega": rate, "Omega_2": other, "T": 2 * pi / rate}


def wheel_let_go(n: Numbers) -> Answers:
    body = with_moments(n.M, n.I1, n.I1, n.I3).moved(n.d * Z).turned(turn(X, pi / 2))
    weight = body.masses @ np.cross(body.places, -n.g * Z)
    return {"alpha": np.linalg.solve(tensor(body), weight)[0]}


def nods(n: Numbers) -> Callable[[float, Any], Any]:
    """ė = L × e/I₁, L̇ = l e × (−M g z): of the state (e, L)."""

    def slope(_: float, state: Any) -> Any:
        axis, momentum = state[:3], state[3:]
        return np.concatenate([cross(momentum, axis) / n.I1, cross(n.l * axis, -n.M * n.g * Z)])

    return slope


def let_go(n: Numbers, tilt: float, spin: float) -> Answers:
    """It has sunk as far as it does when its axis goes neither up nor down for the first time."""
    slope = nods(n)
    axis = sin(tilt) * -Y + cos(tilt) * Z
    start = np.concatenate([axis, n.I3 * spin * axis])
    step = n.I1 / (n.I3 * spin) / 2  # a twelfth of a nod
    _, end = first_passage(slope, start, lambda state: float(slope(0.0, state)[2]), step)
    axis, change = end[:3], slope(0.0, end)[:3]
    rate = np.cross(axis, change)[2] / (axis[0] ** 2 + axis[1] ** 2)
    return {"theta_1": np.degrees(np.arctan2(np.hypot(axis[0], axis[1]), axis[2])), "Omega": rate}


def top_let_go(n: Numbers) -> Answers:
    return let_go(n, n.theta, n.w3)


def gyroscope_let_go(n: Numbers) -> Answers:
    return let_go(n, pi / 2, n.s)


def gyroscope_in_time(n: Numbers) -> Answers:
    """Begun as the steady motion needs; N = M (a + g) from the second derivative of the axis."""
    (rate,) = precessions(lambda rate: lacking(whole_top(n), pi / 2, n.s, rate, n.g), 1.0)
    slope, start = nods(n), np.concatenate([-Y, n.I1 * rate * Z - n.I3 * n.s * Y])
    end = followed(slope, start, n.T, steps=30)
    axis, momentum, change = end[:3], end[3:], slope(0.0, end)
    second = (np.cross(change[3:], axis) + np.cross(momentum, change[:3])) / n.I1
    return {"phi": np.arctan2(axis[0], -axis[1]), "e": axis, "N": n.M * (n.l * second + n.g * Z)}


def gyroscope_by_fast_spin(n: Numbers) -> Answers:
    """Without L across the axis: I₃ ω₃ ė = l e × (−M g z) goes once round in a time that is followed."""

    def slope(_: float, axis: Any) -> Any:
        return cross(n.l * axis, -n.M * n.g * Z) / (n.I3 * n.w3)

    start = sin(n.theta) * -Y + cos(n.theta) * Z
    half, over = first_passage(slope, start, lambda axis: float(axis[0]), 0.1)
    rest, _ = first_passage(slope, over, lambda axis: float(axis[0]), 0.1)
    return {"Omega": 2 * pi / (half + rest)}


def least_sleeping_spin(n: Numbers) -> float:
    """Where the two frequencies of small circles meet: λ⁴ + p λ² + q of the linearized equations has p² = 4 q."""
    slope, step = nods(n), 1e-30

    def apart(spin: float) -> float:
        upright = np.concatenate([Z, n.I3 * spin * Z])
        columns = [np.imag(slope(0.0, upright + 1j * step * unit)) / step for unit in np.eye(6)]
        powers = np.poly(np.array(columns).T)  # λ² is a factor: the height of the axis, and L along it
        return float(powers[2] ** 2 - 4 * powers[4])

    guess = 2 * sqrt(n.M * n.g * n.l * n.I1) / n.I3
    return root(apart, 0.8 * guess, 1.3 * guess)


def sleeping_top(n: Numbers) -> Answers:
    return {"w_0": least_sleeping_spin(n)}


def kowalevskaya_top(n: Numbers) -> Answers:
    """All four a second later: ω and the vertical n in the body's axes, İ ω = I ω × ω + M g a x × (−n), ṅ = n × ω."""
    mass = n.W / (n.g * n.a)
    body = with_moments(mass, 2 * n.J, 2 * n.J - mass * n.a**2, n.J - mass * n.a**2).moved(n.a * X)
    inertia = tensor(body)

    def slope(_: float, state: Any) -> Any:
        omega, upward = state[:3], state[3:]
        twist = cross(inertia @ omega, omega) - cross(n.W * X, upward)
        return np.concatenate([np.linalg.solve(inertia, twist), cross(upward, omega)])

    end = followed(slope, np.array([n.w1, n.w2, n.w3, n.n1, n.n2, n.n3]), 1.0, steps=20)
    omega, upward = end[:3], end[3:]
    kinetic = float(body.masses @ (np.cross(omega, body.places) ** 2).sum(axis=1)) / 2
    whole = (omega[0] + 1j * omega[1]) ** 2 - n.W / n.J * (upward[0] + 1j * upward[1])
    height = body.masses @ body.places @ upward
    return {"E": kinetic + n.g * height, "L_z": upward @ inertia @ omega, "C": abs(whole) ** 2, "n": upward @ upward}


CALCULATIONS = {
    "gyroscope-by-fast-spin": gyroscope_by_fast_spin,
    "gyroscope-in-a-lift": gyroscope_in_a_lift,
    "gyroscope-in-time": gyroscope_in_time,
    "gyroscope-let-go": gyroscope_let_go,
    "gyroscope-level": gyroscope_level,
    "kowalevskaya-top": kowalevskaya_top,
    "leaning-top": leaning_top,
    "leaning-top-least-spin": leaning_top_least_spin,
    "sleeping-top": sleeping_top,
    "top-let-go": top_let_go,
    "wheel-let-go": wheel_let_go,
    "wheel-on-a-string": wheel_on_a_string,
}
