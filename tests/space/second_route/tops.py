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
    points,
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

    return Motion(cloud, places, abs(spin) + abs(round_) or 1.0)


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


def top_on_a_smooth_table(n: Numbers) -> Answers:
    """About the centre of mass, at rest, the push M g at the tip turns as the weight there does about the tip."""
    body = with_moments(n.M, n.A, n.A, n.C)
    push = lacking(points((n.M, n.l * Z)), n.theta, 0.0, 0.0, n.g)
    slow, fast = precessions(
        lambda rate: lacking(body, n.theta, n.w3 - rate * cos(n.theta), rate, 0.0) + push, n.w3 / 8
    )
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


def gyroscope_on_a_string(n: Numbers) -> Answers:
    """The string pulls along itself with M g upwards and M Ω² r inwards, r = l + L sin β; its pull at the end of the axle turns L."""
    wheel = with_moments(n.M, n.I1, n.I1, n.I0)

    def missing(rate: float) -> float:
        momentum = steady(wheel, pi / 2, n.w, rate).angular_momentum()
        return float(np.cross(rate * Z, momentum)[0] - n.l * n.M * n.g)

    rate = root(missing, 0.0, 100.0)
    lean = root(lambda angle: n.g * sin(angle) - rate**2 * (n.l + n.L * sin(angle)) * cos(angle), 0.0, 1.0)
    pull = n.M * np.array([rate**2 * (n.l + n.L * sin(lean)), n.g])
    return {"W": rate, "beta": lean * 180 / pi, "T": SIZE(pull)}


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


def goes_round(n: Numbers) -> Callable[[float, Any], Any]:
    """How a top nods, with φ̇ = (e × ė)_z/(e_x² + e_y²) beside it: of the state (e, L, φ)."""
    slope = nods(n)

    def with_azimuth(time: float, state: Any) -> Any:
        change = slope(time, state[:6])
        turned = (state[0] * change[1] - state[1] * change[0]) / (state[0] ** 2 + state[1] ** 2)
        return np.concatenate([change, [turned]])

    return with_azimuth


def how_long_a_top_nods(n: Numbers) -> Answers:
    """Down until its axis sinks no more, and up again until it rises no more."""
    slope = goes_round(n)
    axis = sin(n.theta) * -Y + cos(n.theta) * Z
    start, step = np.concatenate([axis, n.I3 * n.w3 * axis, [0.0]]), n.I1 / (n.I3 * n.w3) / 2
    down, low = first_passage(slope, start, lambda state: float(slope(0.0, state)[2]), step)
    up, back = first_passage(slope, low, lambda state: float(slope(0.0, state)[2]), step)
    tilt = np.arctan2(np.hypot(low[0], low[1]), low[2])
    return {"theta_1": np.degrees(tilt), "t": down, "T": down + up, "phi": np.degrees(back[6])}


def top_that_creeps_to_the_vertical(n: Numbers) -> Answers:
    """ω₃ keeps L along the vertical as it is when upright, L = I₃ ω₃, with the energy of that; followed down to the second tilt."""
    axis = sin(n.theta) * -Y + cos(n.theta) * Z
    turning = sqrt(2 * n.M * n.g * n.l / n.I1 / (1 + cos(n.theta)))
    axial = n.I1 * turning * (1 + cos(n.theta)) / n.I3
    momentum = n.I3 * axial * axis + n.I1 * turning * (Z - cos(n.theta) * axis)
    slope, step = nods(n), 0.05 * sqrt(n.I1 / (n.M * n.g * n.l))
    far = cos(n.theta_1)
    time, _ = first_passage(slope, np.concatenate([axis, momentum]), lambda state: float(state[2]) - far, step)
    return {"w3": axial, "t": time}


def linearized(n: Numbers, axis: Any, momentum: Any, turning: float) -> Any:
    """The derivative of the rates of (e, L) by (e, L), in axes that turn about the vertical."""
    slope, step = nods(n), 1e-30
    state = np.concatenate([axis, momentum])
    columns = []
    for unit in np.eye(6):
        near = state + 1j * step * unit
        carried = np.concatenate([cross(turning * Z, near[:3]), cross(turning * Z, near[3:])])
        columns.append(np.imag(slope(0.0, near) - carried) / step)
    return np.array(columns).T


def nodding_rate(n: Numbers, tilt: float, axial: float, round_: float) -> float:
    """Of small swings about a steady precession, in axes that go round with it: e², e · L, L_z and φ give four eigenvalues 0, so that
    tr J² = −2 ω²."""
    axis = sin(tilt) * -Y + cos(tilt) * Z
    momentum = n.I3 * axial * axis + n.I1 * round_ * (Z - cos(tilt) * axis)
    slopes = linearized(n, axis, momentum, round_)
    return sqrt(-float(np.trace(slopes @ slopes)) / 2)


def top_that_trembles(n: Numbers) -> Answers:
    """What lacks goes by the spin in a straight line."""
    body = whole_top(n)
    low, high = (lacking(body, n.theta, spin, n.W, n.g) for spin in (0.0, 1.0))
    axial = low / (low - high) + n.W * cos(n.theta)
    return {"w_3": axial, "T": 2 * pi / nodding_rate(n, n.theta, axial, n.W)}


def spherical_pendulum_nods(n: Numbers) -> Answers:
    """A heavy point on its circle, then as a top that has no moment about its axis."""
    tilt = pi - n.alpha
    *_, rate = sorted(precessions(lambda rate: lacking(points((n.m, n.L * Z)), tilt, 0.0, rate, n.g), sqrt(n.g / n.L)))
    bob = Numbers(M=n.m, l=n.L, I1=n.m * n.L**2, I3=0.0, g=n.g)
    nodding = nodding_rate(bob, tilt, 0.0, rate)
    return {"Omega": rate, "T": 2 * pi / nodding, "nods": nodding / rate}


def sleeping_top_touched(n: Numbers) -> Answers:
    """Upright, in axes that turn at half of I₃ ω₃/I₁: twice ± λ and twice 0, so that tr J² = 4 λ²."""

    def growth(spin: float) -> float:
        slopes = linearized(n, Z, n.I3 * spin * Z, n.I3 * spin / n.I1 / 2)
        return float(np.trace(slopes @ slopes)) / 4

    return {"omega": sqrt(-growth(n.w3)), "lambda": sqrt(growth(n.w4))}


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
    "how-long-a-top-nods": how_long_a_top_nods,
    "kowalevskaya-top": kowalevskaya_top,
    "leaning-top": leaning_top,
    "leaning-top-least-spin": leaning_top_least_spin,
    "sleeping-top": sleeping_top,
    "sleeping-top-touched": sleeping_top_touched,
    "spherical-pendulum-nods": spherical_pendulum_nods,
    "top-let-go": top_let_go,
    "top-on-a-smooth-table": top_on_a_smooth_table,
    "top-that-creeps-to-the-vertical": top_that_creeps_to_the_vertical,
    "top-that-trembles": top_that_trembles,
    "wheel-let-go": wheel_let_go,
    "wheel-on-a-string": wheel_on_a_string,
    "gyroscope-on-a-string": gyroscope_on_a_string,
}
