"""Rotors and particles on what turns: their places in a frame at rest as functions of time, and Newton's second law there."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, pi, sin, sqrt
from types import SimpleNamespace as Numbers
from typing import Any

import numpy as np

from second_route.following import cross, followed
from second_route.numbers import UNITS
from second_route.particles import (
    Cloud,
    Motion,
    X,
    Y,
    Z,
    derivatives,
    disc,
    ring,
    rod,
    turn,
    two_bearings,
    with_moments,
)

Answers = dict[str, Any]
Attitude = Callable[[Any], Any]
SIZE = np.linalg.norm


def turns(attitude: Attitude, rate: float) -> tuple[Any, Any]:
    """Angular velocity and angular acceleration: the antisymmetric matrices Ṙ Rᵀ and its derivative."""
    value, first, second = derivatives(attitude, 1 / rate)
    once, twice = first @ value.T, second @ value.T + first @ first.T
    return tuple(np.array([item[2, 1], item[0, 2], item[1, 0]]) for item in (once, twice))  # type: ignore[return-value]


def carried(cloud: Cloud, carrier: Any, rate: float, axis: Any, spin: float) -> Motion:
    """A rotor about an axis through the origin of a frame that turns steadily itself."""
    return Motion.about_origin(cloud, lambda t: turn(carrier, rate * t) @ turn(axis, spin * t), abs(rate) + abs(spin))


def wheel(inertia: float, axis: Any) -> Cloud:
    """A ring of this moment about an axis that lies along x or y."""
    return ring(inertia, 1.0).turned(turn(Y, pi / 2) if axis is X else turn(X, pi / 2))


def disc_askew_on_a_fork(n: Numbers) -> Answers:
    axle = (cos(n.beta), 0, sin(n.beta))
    omega, alpha = turns(lambda t: turn(Z, n.W * t) @ turn(axle, n.p * t), n.p)
    return {"om": omega, "al": alpha}


def fan_with_two_blades(n: Numbers) -> Answers:
    motion = Motion.about_origin(rod(n.m, n.L), lambda t: turn(Z, n.W * t) @ turn(Y, n.psi + n.s * t), n.s)
    return {"tau": motion.torque()}


def propeller(n: Numbers) -> Answers:
    return {"tau": carried(wheel(n.m * n.k**2, X), Z, n.v / n.r, X, n.n).torque()}


def propeller_that_turns_two_ways(n: Numbers) -> Answers:
    screw = wheel(n.I, X)
    return {"tau_1": carried(screw, Z, n.W, X, n.s).torque(), "tau_2": carried(screw, -Y, n.Q, X, n.s).torque()}


def rod_held_by_a_wire(n: Numbers) -> Answers:
    """The wire has the whole torque about the pin, which it pulls against at the upper end."""
    cloud = rod(n.W / n.g, n.L).moved(n.L / 2 * X).turned(turn(Y, -n.beta))
    motion = Motion.about_origin(cloud, lambda t: turn(Z, n.w * t), n.w)
    gravity = -n.g * Z
    pull = -motion.torque(gravity)[1] / (n.L * sin(n.beta))
    pound_force = 4.4482216152605  # N
    return {"T": pull / pound_force, "F": (motion.force(gravity) + pull * X) / pound_force}


def turbine_of_a_ship(n: Numbers) -> Answers:
    motion = carried(wheel(n.m * n.k**2, X), Z, n.W, X, n.n)
    _, fore = two_bearings(motion.force(), motion.torque(), X, -n.b / 2, n.b / 2)
    return {"tau": motion.torque(), "F": SIZE(fore)}


def train_on_a_curve(n: Numbers) -> Answers:
    """To the left of x lies y: what rolls along x turns about it."""
    motion = carried(wheel(n.I, Y), Z, n.v / n.r, Y, n.v / n.R)
    left, right = two_bearings(0 * X, motion.torque(), Y, n.b / 2, -n.b / 2)
    assert np.allclose(left, -right)
    return {"tau": motion.torque(), "N": SIZE(left)}


def rotor_in_a_turning_frame(n: Numbers) -> Answers:
    body, end, field = disc(n.m, n.r).turned(turn(Y, pi / 2)), n.b * X, -n.g * Z

    def places(t: Any) -> Any:
        fork = turn(Z, n.W * t)
        return (end + body.places @ turn(X, n.p * t).T) @ fork.T

    motion = Motion(body, places, n.p)
    return {"M": motion.torque(field, about=end), "F": motion.force(field)}


def axis_brought_level(n: Numbers) -> Answers:
    """L = J ω e, and the axis e goes evenly from z to x."""
    rate = pi / 2 / n.T

    def axis(t: Any) -> Any:
        return np.sin(rate * t) * X + np.cos(rate * t) * Z

    change = n.J * n.omega * (axis(n.T) - axis(0.0))
    _, swing, _ = derivatives(lambda t: axis(n.theta / rate + t), 1 / rate)
    sizes = {"dL": SIZE(change), "tau": SIZE(change) / n.T, "Omega": SIZE(swing), "tau_t": n.J * n.omega * SIZE(swing)}
    return {"tau_m": change / n.T, **sizes}


def wheel_in_body_axes(n: Numbers) -> Answers:
    def attitude(t: Any) -> Any:
        return turn(Z, n.Omega * t) @ turn(X, pi / 2) @ turn(Z, n.psi + n.s * t)

    body, now = with_moments(1.0, n.I1, n.I1, n.I3), attitude(0.0)
    torque = Motion.about_origin(body, attitude, n.s).torque()
    return {"w": now.T @ turns(attitude, n.s)[0], "tau": now.T @ torque, "tau_0": SIZE(torque)}


def particle_on_a_turntable(n: Numbers) -> Answers:
    """Real forces of four particles: on it, at rest on it, at rest while it turns steadily, and while it starts."""

    def force(speed: float, rate: float, growth: float) -> Any:
        def place(t: Any) -> Any:
            return turn(Z, rate * t + growth * t * t / 2) @ ((n.r + speed * t) * X)

        return n.m * derivatives(place, 1 / n.w)[2]

    whole, rest = force(n.vr, n.w, n.alpha), force(0, n.w, n.alpha)
    parts = {"F_c": force(0, n.w, 0), "F_e": force(0, 0, n.alpha), "F_cor": whole - rest, "F_0": rest}
    return {"F": whole, **{name: SIZE(part) for name, part in parts.items()}}


def sleeve_up_a_turning_rod(n: Numbers) -> Answers:
    """Newton's law in the middle of small parts of the way, d(u²)/ds = 2 d²s/dt²; then the real force of a particle that moves so."""
    places = np.linspace(n.a, n.s, 101)
    middle, parts = (places[1:] + places[:-1]) / 2, np.diff(places)
    along, level = np.cos(n.beta) * X + np.sin(n.beta) * Z, np.cos(n.beta)

    def growth(s: Any) -> Any:
        return n.w**2 * s * level**2 - n.g * np.sin(n.beta)

    speed = float(np.sqrt(n.u0**2 + 2 * (growth(middle) * parts).sum()))

    def place(t: Any) -> Any:
        return turn(Z, n.w * t) @ ((n.s + speed * t + growth(n.s) * t * t / 2) * along)

    at_rest = turn(Z, 0.0) @ along
    _, velocity, acceleration = derivatives(place, 1 / n.w)
    swept = n.w * np.cross(Z, speed * at_rest)
    return {"u": speed, "v": SIZE(velocity), "F_c": SIZE(2 * n.m * swept), "F": SIZE(n.m * (acceleration + n.g * Z))}


def rod_swung_out_by_a_shaft(n: Numbers) -> Answers:
    """The torque of weights and centrifugal forces on many points about the hinge, summed over the way up: d(θ̇²)/dθ = 2 θ̈."""
    nodes, shares = np.polynomial.legendre.leggauss(12)
    places, masses = n.l * (1 + nodes) / 2, n.m * shares / 2
    angles = (np.pi / 2 + n.theta) / 2 + (n.theta - np.pi / 2) / 2 * nodes
    weights = (n.theta - np.pi / 2) / 2 * shares
    total = 0.0
    for angle, weight in zip(angles, weights, strict=True):
        away = n.R + places * np.cos(angle)
        torque = (masses * places * (n.g * np.cos(angle) - n.w**2 * away * np.sin(angle))).sum()
        total += 2 * weight * torque / (masses * places**2).sum()
    return {"n": -np.sqrt(total)}


def train_that_runs_north(n: Numbers) -> Answers:
    """What is left of the acceleration when that of the train on an earth at rest, and that of a house, are taken off."""

    def acceleration(rate: float, speed: float) -> Any:
        def place(t: Any) -> Any:
            latitude = getattr(n, "lambda") + speed * t / n.R
            return turn(Z, rate * t) @ (n.R * (np.cos(latitude) * X + np.sin(latitude) * Z))

        return derivatives(place, 1 / n.W)[2]

    whole = acceleration(n.W, n.v)
    coriolis = -n.m * (whole - acceleration(0, n.v) - acceleration(n.W, 0))
    return {"F": coriolis, "S": n.m * whole[1]}


def fallen_on_the_earth(start: Any, axis: Any, n: Numbers, time: float) -> Any:
    """The place on the earth, followed there: r̈ = −g ẑ − 2 ω × v − ω × (ω × r)."""
    omega = n.w * axis

    def slope(_: float, state: Any) -> Any:
        place, velocity = state[:3], state[3:]
        felt = 2 * cross(omega, velocity) + cross(omega, cross(omega, place))
        return np.concatenate([velocity, -n.g * Z - felt])

    return followed(slope, start, time, 20)[:3]


def stone_from_a_tower(n: Numbers) -> Answers:
    start = np.concatenate([n.h * Z, 0 * Z])
    return {"x": 1000 * fallen_on_the_earth(start, Y, n, np.sqrt(2 * n.h / n.g))[0]}  # in mm


def shell_fired_east(n: Numbers) -> Answers:
    latitude = getattr(n, "lambda")
    start = np.concatenate([0 * Z, n.V * (cos(n.a) * X + sin(n.a) * Z)])
    axis = cos(latitude) * Y + sin(latitude) * Z
    return {"y": fallen_on_the_earth(start, axis, n, 2 * n.V * sin(n.a) / n.g)[1]}


def disc_in_a_fork_spun_up(n: Numbers) -> Answers:
    """Many points of a disc: the rate at which the shaft spins up from the torque that one of 1 rad/s² takes, then the bearings' forces."""

    def pushes(rate: float, faster: float) -> tuple[Any, Any]:
        def round_shaft(t: Any) -> Any:
            return turn(Z, rate * t + faster * t * t / 2)

        body = disc(n.W, n.r).turned(turn(X, pi / 2))
        motion = Motion(body, lambda t: (round_shaft(t) @ (n.d * X + body.places @ turn(Y, n.s * t).T).T).T, n.s)
        return motion.force(), motion.torque()

    faster = n.M0 / pushes(0.0, 1.0)[1][2]
    force, torque = pushes(faster * n.T, faster)
    lower, upper = two_bearings(force, torque, Z, -n.c, n.c)
    return {"w": faster * n.T, "D": lower / UNITS["lbf"], "C": upper / UNITS["lbf"]}


def disc_on_an_axle_that_sways(n: Numbers) -> Answers:
    """The bearings' couple is dL/dt, L = I w e + I′ φ̇ x; forces ±F along x at ∓½ l e give the couple l F x × e."""
    across, along = n.m * n.r**2 / 4, n.m * n.r**2 / 2

    def momentum(time: Any) -> Any:
        phase = 2 * pi * time / n.T
        angle, rate = n.phi * np.sin(phase), n.phi * 2 * pi / n.T * np.cos(phase)
        return along * n.w * np.array([0.0 * angle, np.cos(angle), np.sin(angle)]) + across * rate * X

    def force(time: float) -> float:
        angle = n.phi * sin(2 * pi * time / n.T)
        change = derivatives(lambda more: momentum(time + more), n.T / 10)[1]
        return float(change @ np.array([0.0, -sin(angle), cos(angle)])) / n.l

    return {"F": max(force(n.T * part / 24) for part in range(24))}


def gyrocompass_that_swings(n: Numbers) -> Answers:
    """L = A e × ė + C ω₃ e with ω₃ = s + Ω · e kept as it was in the north: no part of dL/dt along the hinge, the axle let go beside it."""
    earth, beside = n.W * np.array([0.0, cos(n.phi), sin(n.phi)]), 1e-4
    axial = n.s + earth[1]
    axle = turn(Z, beside) @ Y
    carried = cross(earth, axle)
    back = n.A * cross(axle, cross(earth, carried))[2] + n.C * axial * carried[2]
    return {"T": 2 * pi * sqrt(n.A * sin(beside) / back)}


def rod_on_a_shaft_that_turns_freely(n: Numbers) -> Answers:
    """α̈ = Ω² sin α cos α − 3 g sin α/2 l by slices of the rod, with Ω as the angular momentum about the shaft has it."""
    rate = sqrt(1.5 * n.g / (n.l * cos(n.alpha)))
    kept = (n.J + n.m * n.l**2 / 3 * sin(n.alpha) ** 2) * rate

    def faster(angle: float) -> float:
        turned = kept / (n.J + n.m * n.l**2 / 3 * sin(angle) ** 2)
        return turned**2 * sin(angle) * cos(angle) - 1.5 * n.g / n.l * sin(angle)

    return {"W": rate, "p": sqrt((faster(n.alpha - 1e-4) - faster(n.alpha + 1e-4)) / 2e-4)}


def gyroscope_in_gimbals_trembles(n: Numbers) -> Answers:
    """θ̈ = φ̇ sin θ (φ̇ cos θ − C ω₃/I) + m g h sin θ/I with both momenta kept, let go beside θ = 90°."""

    def nodding(across: float, lift: float) -> float:
        axial = n.C * n.s

        def faster(tilt: complex) -> Any:
            rate = (across * lift / axial - axial * np.cos(tilt)) / (across * np.sin(tilt) ** 2)
            return np.sin(tilt) * (rate * (rate * np.cos(tilt) - axial / across) + lift / across)

        return sqrt(-faster(pi / 2 + 1e-20j).imag / 1e-20)

    lift, across = n.m * n.g * n.h, n.A + n.m * n.h**2
    return {"W": lift / (n.C * n.s), "w": nodding(across, -lift), "w_0": nodding(n.A, 0.0)}


CALCULATIONS = {
    "gyroscope-in-gimbals-trembles": gyroscope_in_gimbals_trembles,
    "gyrocompass-that-swings": gyrocompass_that_swings,
    "rod-on-a-shaft-that-turns-freely": rod_on_a_shaft_that_turns_freely,
    "disc-on-an-axle-that-sways": disc_on_an_axle_that_sways,
    "disc-in-a-fork-spun-up": disc_in_a_fork_spun_up,
    "shell-fired-east": shell_fired_east,
    "stone-from-a-tower": stone_from_a_tower,
    "axis-brought-level": axis_brought_level,
    "disc-askew-on-a-fork": disc_askew_on_a_fork,
    "fan-with-two-blades": fan_with_two_blades,
    "particle-on-a-turntable": particle_on_a_turntable,
    "propeller": propeller,
    "propeller-that-turns-two-ways": propeller_that_turns_two_ways,
    "rod-swung-out-by-a-shaft": rod_swung_out_by_a_shaft,
    "rotor-in-a-turning-frame": rotor_in_a_turning_frame,
    "sleeve-up-a-turning-rod": sleeve_up_a_turning_rod,
    "train-on-a-curve": train_on_a_curve,
    "rod-held-by-a-wire-in-pounds": rod_held_by_a_wire,
    "train-that-runs-north": train_that_runs_north,
    "turbine-of-a-ship": turbine_of_a_ship,
    "wheel-in-body-axes": wheel_in_body_axes,
}
