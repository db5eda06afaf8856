"""What rolls, and what turns about one axis only: heavy points on their cycloids, equations of one speed followed in time."""

from __future__ import annotations

from math import atan2, cos, pi, sin, sqrt
from types import SimpleNamespace as Numbers
from typing import Any

import numpy as np

from second_route.following import first_passage, followed
from second_route.particles import Cloud, Motion, X, Y, Z, cone, derivatives, disc, ring, root, tensor, turn
from second_route.tops import least_sleeping_spin, steady

Answers = dict[str, Any]
SIZE = np.linalg.norm


def cycloids(body: Cloud, radius: float, speed: float) -> Motion:
    """A wheel in the plane x-y that rolls along x: it turns clockwise."""
    rate = speed / radius
    return Motion(body, lambda t: speed * t * X + body.places @ turn(-Z, rate * t).T, rate)


def disc_about_a_point_of_its_line(n: Numbers) -> Answers:
    """Clockwise is positive."""
    motion = cycloids(disc(n.M, n.R), n.R, n.v)
    about_floor, about_centre = (-motion.angular_momentum(place)[2] for place in (-n.R * Y, 0 * X))
    return {"L_0": about_floor, "L_r": about_centre, "L_t": about_floor - about_centre}


def rolling_energies(n: Numbers) -> Answers:
    def point(angle: Any) -> Any:
        return derivatives(lambda t: n.v * t * X + turn(-Z, n.v / n.R * t) @ angle, n.R / n.v)

    _, top, _ = point(n.R * Y)
    _, _, inward = point(-n.R * Y)
    wheels = {"K_d": disc(n.M, n.R), "K_h": ring(n.M, n.R)}
    energies = {name: cycloids(body, n.R, n.v).kinetic_energy() for name, body in wheels.items()}
    return {**energies, "v_t": SIZE(top), "a_c": SIZE(inward)}


def rolls(body: Cloud, radius: float, gravity: float, state: Any) -> Any:
    """ė and ω̇ of a wheel with the axis e that rolls on a table: L̇ = c × M (v̇ + g z), v = −ω × c; c from the centre to the contact."""
    axis, omega = state[:3], state[3:]
    moments = tensor(body)
    more = moments[2, 2] - moments[0, 0]
    change = np.cross(omega, axis)
    steep = Z - axis[2] * axis
    up, length = steep / np.sqrt(steep @ steep), np.sqrt(steep @ steep)
    tipped = -change[2] * axis - axis[2] * change
    contact, moved = -radius * up, -radius * (tipped - (up @ tipped) * up) / length
    inertia = moments[0, 0] * np.eye(3) + more * np.outer(axis, axis)
    inertia = inertia + body.mass * (contact @ contact * np.eye(3) - np.outer(contact, contact))
    carried = more * ((omega @ change) * axis + (omega @ axis) * change)
    push = np.cross(contact, body.mass * (gravity * Z - np.cross(omega, moved)))
    return np.concatenate([change, np.linalg.solve(inertia, push - carried)])


def least_upright_speed(n: Numbers, body: Cloud) -> float:
    """λ² = tr J²/2 of the linearized equations of what rolls upright: all other eigenvalues are zero."""

    def growth(speed: float) -> float:
        upright, step = np.concatenate([Y, speed / n.R * Y]), 1e-30
        columns = [np.imag(rolls(body, n.R, n.g, upright + 1j * step * unit)) / step for unit in np.eye(6)]
        slopes = np.array(columns).T
        return float(np.trace(slopes @ slopes)) / 2

    guess = sqrt(n.g * n.R)
    return root(growth, guess / 5, guess)


def hoop_that_stays_upright(n: Numbers) -> Answers:
    return {"v_h": least_upright_speed(n, ring(n.M, n.R))}


def wheel_that_stays_upright(n: Numbers) -> Answers:
    return {"v_d": least_upright_speed(n, disc(n.M, n.R))}


def skater_pulls_in(n: Numbers) -> Answers:
    """ω̇ = −İ ω/I, and the work −½ ω² İ that pulls inwards; d(I ω₀)/dt = İ ω₀ of the one that is held."""
    fall = -(n.I0 - n.If) / n.T

    def slope(time: float, state: Any) -> Any:
        return np.array([-fall * state[0] / (n.I0 + fall * time), -fall * state[0] ** 2 / 2])

    start = np.array([n.w0, 0.0])
    (omega, _), (last, work) = (followed(slope, start, time, steps=10) for time in (n.t, n.T))
    return {"w": omega, "w_f": last, "W": work, "tau": fall * n.w0}


def rolls_round(body: Cloud, tilt: float, touching: Any, round_: float) -> tuple[Motion, Any]:
    """A body about its tip, with the spin for which a point of it is at rest: how it moves, and where that point is."""

    point = Cloud(np.ones(1), np.array([touching]))
    slow, fast = (steady(point, tilt, spin, round_).velocities[0] for spin in (0.0, 1.0))
    spin = float(-(slow @ (fast - slow)) / ((fast - slow) @ (fast - slow)))
    return steady(body, tilt, spin, round_), steady(point, tilt, spin, round_).places[0]


def pushed_up(motion: Motion, place: Any, gravity: float) -> float:
    """The force upwards at a place that makes up the torque about the tip."""
    return float(motion.torque(-gravity * Z)[0] / place[1])


def turning_of(motion: Motion) -> Any:
    """ω of a body about its tip, from L."""
    return np.linalg.solve(tensor(Cloud(motion.masses, motion.places)), motion.angular_momentum())


def lying_cone(n: Numbers, round_: float) -> tuple[Motion, Any]:
    """Its axis is as high above the table as its half angle."""
    body = cone(n.M, n.R, n.h).turned(turn(X, pi))
    return rolls_round(body, pi / 2 - atan2(n.R, n.h), n.h * Z - n.R * Y, round_)


def cone_that_rolls_round(n: Numbers) -> Answers:
    motion, place = lying_cone(n, n.W)
    up = pushed_up(motion, place, n.g)
    moves = {"K": motion.kinetic_energy(), "omega": SIZE(turning_of(motion)), "L_z": motion.angular_momentum()[2]}
    return {**moves, "N": up, "x": up * SIZE(place) / (n.M * n.g)}


def cone_that_tips(n: Numbers) -> Answers:
    """The weight is carried at the rim."""

    def lacking(round_: float) -> float:
        motion, place = lying_cone(n, round_)
        return pushed_up(motion, place, n.g) - n.M * n.g

    rate = root(lacking, 0.1 * sqrt(n.g / n.R), 10 * sqrt(n.g / n.R))
    return {"W_t": rate, "F": SIZE(lying_cone(n, rate)[0].force(-n.g * Z) - n.M * n.g * Z)}


def mill_stone(n: Numbers) -> Answers:
    motion, place = rolls_round(disc(n.M, n.R).moved(n.d * Z), pi / 2, n.d * Z - n.R * Y, n.W)
    up = pushed_up(motion, place, n.g)
    _, along, lift = motion.force(-n.g * Z) - up * Z
    return {"N": up, "F_z": lift, "F_r": along, "omega": SIZE(turning_of(motion)), "K": motion.kinetic_energy()}


def coin_in_a_circle(n: Numbers) -> Answers:
    """Its angular velocity goes round with it: ω̇ = W z × ω of what rolls."""
    body, axis = disc(n.m, n.R), sin(n.theta) * -Y + cos(n.theta) * Z
    inner = n.rho - n.R * cos(n.theta)  # the circle of its centre

    def omega(rate: float) -> Any:
        return rate * Z - n.rho / n.R * rate * axis

    def lacking(rate: float) -> float:
        change = rolls(body, n.R, n.g, np.concatenate([axis, omega(rate)]))[3:]
        return float((change - np.cross(rate * Z, omega(rate)))[0])

    rate = root(lacking, 0.1 * sqrt(n.g / n.rho), 10 * sqrt(n.g / n.rho))
    return {"Omega": rate, "F": n.m * rate**2 * inner, "N": n.m * n.g}


def growth_going_round(body: Cloud, n: Numbers, axis: Any, omega: Any, round_: float) -> float:
    """λ² = tr J²/2 of the linearized equations in axes that go round with what rolls: all other eigenvalues are zero."""

    def rate(state: Any) -> Any:
        swept = [np.cross(round_ * Z, part) for part in (state[:3], state[3:])]
        return rolls(body, n.R, n.g, state) - np.concatenate(swept)

    steady_state, step = np.concatenate([axis, omega]), 1e-30
    slopes = np.array([np.imag(rate(steady_state + 1j * step * unit)) / step for unit in np.eye(6)]).T
    return float(np.trace(slopes @ slopes)) / 2


def coin_spun_on_its_edge(n: Numbers) -> Answers:
    def growth(rate: float) -> float:
        return growth_going_round(disc(n.m, n.R), n, Y, rate * Z, rate)

    guess = sqrt(n.g / n.R)
    return {"W_0": root(growth, guess / 5, 5 * guess)}


def coin_that_trembles(n: Numbers) -> Answers:
    """ω̇ = W z × ω tells its spin s, of ω = W z + s e."""
    body, axis = disc(n.m, n.R), sin(n.theta) * -Y + cos(n.theta) * Z

    def lacking(spin: float) -> float:
        omega = n.W * Z + spin * axis
        change = rolls(body, n.R, n.g, np.concatenate([axis, omega]))[3:]
        return float((change - np.cross(n.W * Z, omega))[0])

    slow, fast = lacking(0.0), lacking(1.0)
    spin = -slow / (fast - slow)
    return {"s": spin, "T": 2 * pi / sqrt(-growth_going_round(body, n, axis, n.W * Z + spin * axis, n.W))}


def slows(n: Numbers) -> Any:
    return lambda _, state: -n.c / n.I3 * state


def top_that_slows_down(n: Numbers) -> Answers:
    omega = float(followed(slows(n), np.array([n.w3]), n.t, steps=4)[0])
    return {"w": omega, "Omega": n.M * n.g * n.l / (n.I3 * omega)}


def top_that_wakes_up(n: Numbers) -> Answers:
    """Down to the spin at which the linearized equations of a sleeping top lose it."""
    least = least_sleeping_spin(n)
    time, _ = first_passage(slows(n), np.array([n.w3]), lambda state: float(state[0]) - least, 5.0)
    return {"t_s": time}


CALCULATIONS = {
    "coin-in-a-circle": coin_in_a_circle,
    "coin-spun-on-its-edge": coin_spun_on_its_edge,
    "coin-that-trembles": coin_that_trembles,
    "cone-that-rolls-round": cone_that_rolls_round,
    "cone-that-tips": cone_that_tips,
    "disc-about-a-point-of-its-line": disc_about_a_point_of_its_line,
    "hoop-that-stays-upright": hoop_that_stays_upright,
    "mill-stone": mill_stone,
    "rolling-energies": rolling_energies,
    "skater-pulls-in": skater_pulls_in,
    "top-that-slows-down": top_that_slows_down,
    "top-that-wakes-up": top_that_wakes_up,
    "wheel-that-stays-upright": wheel_that_stays_upright,
}
