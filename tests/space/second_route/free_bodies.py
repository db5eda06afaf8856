"""Free bodies: blows and pushes on heavy points, small wobbles by eigenvalues, and rotations followed in time."""

from __future__ import annotations

from math import pi, sqrt
from types import SimpleNamespace as Numbers
from typing import Any

import numpy as np

from second_route.following import FreeRotation, cross, first_passage, followed
from second_route.particles import (
    Cloud,
    X,
    Y,
    Z,
    cuboid,
    degrees_between,
    disc,
    momenta,
    rectangle,
    tensor,
    with_moments,
)

Answers = dict[str, Any]
SIZE = np.linalg.norm
DAY = 86400.0


def spin_change(inertia: Any, omega: Any) -> Any:
    """ω̇ in the body's axes of a body whose angular momentum stays in space."""
    return np.linalg.solve(inertia, cross(inertia @ omega, omega))


def growth(inertia: Any, omega: Any) -> float:
    """λ² of a small wobble: eigenvalues of the derivative of `spin_change`, taken by imaginary steps."""
    step = 1e-30
    slopes = np.array([np.imag(spin_change(inertia, omega + 1j * step * axis)) / step for axis in (X, Y, Z)]).T
    values = np.linalg.eigvals(slopes)
    return float(np.real(values[np.argmax(np.abs(values))] ** 2))


def blow(body: Cloud, impulse: Any, at: Any) -> tuple[Any, Any]:
    """Velocity of the origin and angular velocity that a blow gives a free body at rest."""
    after = np.linalg.solve(momenta(body), [*impulse, *np.cross(at, impulse)])
    return after[:3], after[3:]


def energy(body: Cloud, velocity: Any, omega: Any) -> float:
    return float(body.masses @ ((velocity + np.cross(omega, body.places)) ** 2).sum(axis=1)) / 2


def blow_on_a_box(n: Numbers) -> Answers:
    body = cuboid(n.m, n.w, n.h, n.d)
    velocity, omega = blow(body, -n.J * Z, np.array([n.w, n.h, n.d]) / 2)
    return {"v": velocity, "om": omega, "K": energy(body, velocity, omega)}


def disc_struck_at_its_rim(n: Numbers) -> Answers:
    body, rim = disc(n.m, n.R), n.R * X
    velocity, omega = blow(body, n.J * Z, rim)
    return {"w": omega, "u": velocity, "v": velocity + np.cross(omega, rim), "K": energy(body, velocity, omega)}


def blow_on_a_plate_at_a_corner(n: Numbers) -> Answers:
    """About the corner that is held; with what the blow lacks of the momentum the joint pushes."""
    plate = rectangle(n.m, n.a, n.a).moved(-n.a / 2 * (X + Y))
    omega = np.linalg.solve(tensor(plate), np.cross(-n.a * Y, n.J * Z))
    momentum = plate.masses @ np.cross(omega, plate.places)
    return {"omega": omega, "P": momentum - n.J * Z}


def plate_struck_where_its_hinges_feel_nothing(n: Numbers) -> Answers:
    """Strips of a triangle that turns about its leg: the blow alone gives it its momentum and its angular momentum."""
    nodes, weights = np.polynomial.legendre.leggauss(8)
    across, along = (1 + nodes) / 2, (1 + nodes) / 2
    masses = np.array([n.M * w * v * (1 - s) / 2 for s, w in zip(across, weights, strict=True) for v in weights])
    places = np.array([[n.b * s, n.a * (1 - s) * t, 0] for s in across for t in along])
    once = np.cross(Y, places)
    omega = n.J / float(masses @ once[:, 2])
    turning = masses @ np.cross(places, omega * once)  # = r × J ẑ
    return {"x": -turning[1] / n.J, "y": turning[0] / n.J, "omega": omega}


def satellite_with_a_reaction_wheel(n: Numbers) -> Answers:
    """Both as heavy points about their common centre, and the wheel's own turn beside that."""
    shift = n.k * n.d / (n.m + n.k) * X
    wheel = with_moments(n.k, n.C / 2, n.C, n.C / 2)
    whole = tensor(cuboid(n.m, n.a, n.b, n.c).moved(-shift)) + tensor(wheel.moved(n.d * X - shift))
    omega = np.linalg.solve(whole, -tensor(wheel) @ (n.w * Y))
    return {"W": omega[1], "w_3": omega[1] + n.w}


def force_off_the_centre(n: Numbers) -> Answers:
    """At rest accelerations go by forces as velocities go by blows."""
    force, at = n.F * Z, np.array([n.rx, n.ry, n.rz])
    acceleration, alpha = blow(cuboid(n.m, n.w, n.h, n.d), force, at)
    return {"a": acceleration, "alpha": alpha, "tau": np.cross(at, force)}


def spherical_top(n: Numbers) -> Answers:
    """Σ r × m (α × r + ω × (ω × r)) = 0."""
    body, omega = with_moments(1.0, n.I0, n.I0, n.I0), np.array([n.wx, n.wy, n.wz])
    inward = np.cross(omega, np.cross(omega, body.places))
    alpha = np.linalg.solve(tensor(body), -body.masses @ np.cross(body.places, inward))
    momentum = body.masses @ np.cross(body.places, np.cross(omega, body.places))
    return {"L": momentum, "alpha": alpha, "T": energy(body, 0 * X, omega)}


def book_about_its_middle_axis(n: Numbers) -> Answers:
    inertia = tensor(cuboid(n.m, n.a, n.b, n.c))
    rates = {name: growth(inertia, n.w * axis) for name, axis in (("lambda", Y), ("l_x", X), ("l_z", Z))}
    return {**rates, "lambda": sqrt(rates["lambda"])}


def stability_of_three_axes(n: Numbers) -> Answers:
    inertia = np.diag([n.I1, n.I2, n.I3])
    rates = [growth(inertia, n.w * axis) for axis in (X, Y, Z)]
    named = {f"l_{k + 1}": rate for k, rate in enumerate(rates)}
    return {
        **named,
        **{f"f_{k + 1}": sqrt(abs(rate)) for k, rate in enumerate(rates)},
        "unstable": " ".join(str(k + 1) for k, rate in enumerate(rates) if rate > 0),
    }


def two_rotations(body: Cloud, omega: Any) -> tuple[float, float, Any]:
    """Of a symmetric body about z: the rates about L and about its own axis that make up ω together, and L."""
    momentum = body.masses @ np.cross(body.places, np.cross(omega, body.places))
    axes = np.array([momentum / SIZE(momentum), Z]).T
    rates, *_ = np.linalg.lstsq(axes, omega, rcond=None)
    assert np.allclose(axes @ rates, omega)
    return float(rates[0]), float(rates[1]), momentum


def free_symmetric_top(n: Numbers) -> Answers:
    body, omega = with_moments(1.0, n.I1, n.I1, n.I3), np.array([n.wp, 0, n.w3])
    round_, own, momentum = two_rotations(body, omega)
    angles = {"theta": degrees_between(momentum, Z), "beta": degrees_between(omega, Z)}
    rates = {"phi_t": round_, "psi_t": own, "Omega_b": -own}
    return {"L": SIZE(momentum), **rates, **angles, "T": energy(body, 0 * X, omega)}


def thrown_plate(n: Numbers) -> Answers:
    round_, own, momentum = two_rotations(disc(n.M, n.R), np.array([n.wp, 0, n.w3]))
    return {"phi_t": round_, "psi_t": own, "theta": degrees_between(momentum, Z)}


def turned_on(inertia: Any, momentum: Any, time: float, steps: int) -> Any:
    """R by Ṙ = [ω]× R, ω = R I⁻¹ Rᵀ L, from R = 1."""

    def slope(_: float, state: Any) -> Any:
        return np.cross(state @ np.linalg.solve(inertia, state.T @ momentum), state, axisb=0, axisc=0)

    return followed(slope, np.eye(3), time, steps=steps)


def plate_that_wobbles_in_time(n: Numbers) -> Answers:
    """How it is turned, and the throw of its centre."""
    body, omega = disc(n.M, n.R), np.array([n.wp, 0, n.w3])
    inertia = tensor(body)
    momentum = inertia @ omega
    end = turned_on(inertia, momentum, n.T, steps=40)
    own = np.linalg.solve(inertia, end.T @ momentum)
    turned = body.turned(end)
    found = turned.masses @ np.cross(turned.places, np.cross(end @ own, turned.places))
    angle = degrees_between(end @ Z, momentum)
    return {"e": end @ Z, "w": own, "L": found, "theta": angle, "v_c": (n.v - n.g * n.T) * Z}


def wobble(moments: list[float], omega: Any, name: str, time: float) -> Answers:
    later = FreeRotation(moments, list(omega)).after(time)
    return {f"{name}_{k + 1}T": later[k] for k in range(3)}


def between_both_cases(n: Numbers) -> Answers:
    return wobble([n.I1, n.I2, n.I3], [sqrt(3) * n.w, 0.0, n.w], "w", n.T)


def between_both_cases_in_space(n: Numbers) -> Answers:
    inertia = np.diag([n.I1, n.I2, n.I3])
    momentum = inertia @ np.array([sqrt(3) * n.w, 0.0, n.w])
    axis = turned_on(inertia, momentum, n.T, steps=60) @ Y
    return {"e_x": axis[0], "e_y": axis[1], "e_z": axis[2], "theta": degrees_between(axis, momentum)}


def tennis_racket_in_the_hand(n: Numbers) -> Answers:
    inertia = np.diag([n.I1, n.I2, n.I3])
    end = turned_on(inertia, inertia @ np.array([n.w1, n.w2, 0.0]), n.T, steps=200)
    return {"h": end[0, 0], "f": end[2, 2]}


def tennis_racket(n: Numbers) -> Answers:
    """ω₃ is zero at first, then when it has turned over, then when it is as it was."""
    moments, start = [n.I1, n.I2, n.I3], [n.w1, n.w2, 0.0]
    found = wobble(moments, start, "w", n.T)
    (half, over), (whole, back) = FreeRotation(moments, start).passages(2, count=2)
    assert np.allclose(over, [n.w1, -n.w2, 0]) and np.allclose(back, start)
    return {"w_1T": found["w_1T"], "w_3T": found["w_3T"], "T_r": whole, "flip": half}


def wing_nut(n: Numbers) -> Answers:
    """ω₁ is zero at first, and when it has turned over."""
    moments, start = [n.I1, n.I2, n.I3], [0.0, n.w2, n.w3]
    ((half, over),) = FreeRotation(moments, start).passages(0, count=1)
    assert np.allclose(over, [0, -n.w2, n.w3])
    return {**wobble(moments, start, "w", n.T), "flip": half}


def earth_wobble(n: Numbers) -> Answers:
    """How fast the part of ω across the axis turns in the body."""
    omega = np.array([n.w, 0, 2 * pi / n.T_day])
    rate = np.cross(omega, spin_change(np.diag([n.I1, n.I1, n.I1 * (1 + n.e)]), omega))[2] / n.w**2
    period = 2 * pi / rate
    return {"Omega": rate, "T_w": period / DAY, "n": period / n.T_day}


def pole_of_the_earth_in_time(n: Numbers) -> Answers:
    """Followed in units of the rotation; the pole is back when ω₂ passes zero upwards: for the second time."""
    inertia, start = np.diag([1.0, 1.0, 1 + n.e]), np.array([n.w1 / n.w3, 0, 1.0])

    def slope(_: float, omega: Any) -> Any:
        return spin_change(inertia, omega)

    later = n.w3 * followed(slope, start, n.T * n.w3, steps=10)
    half, over = first_passage(slope, start, lambda omega: float(omega[1]), 0.3 / n.e)
    rest, _ = first_passage(slope, over, lambda omega: float(omega[1]), 0.3 / n.e)
    return {"w": later, "T_w": (half + rest) / n.w3 / DAY}


CALCULATIONS = {
    "between-both-cases": between_both_cases,
    "between-both-cases-in-space": between_both_cases_in_space,
    "blow-on-a-box": blow_on_a_box,
    "blow-on-a-plate-at-a-corner": blow_on_a_plate_at_a_corner,
    "book-about-its-middle-axis": book_about_its_middle_axis,
    "disc-struck-at-its-rim": disc_struck_at_its_rim,
    "earth-wobble": earth_wobble,
    "force-off-the-centre": force_off_the_centre,
    "free-symmetric-top": free_symmetric_top,
    "plate-struck-where-its-hinges-feel-nothing": plate_struck_where_its_hinges_feel_nothing,
    "plate-that-wobbles-in-time": plate_that_wobbles_in_time,
    "pole-of-the-earth-in-time": pole_of_the_earth_in_time,
    "satellite-with-a-reaction-wheel": satellite_with_a_reaction_wheel,
    "spherical-top": spherical_top,
    "stability-of-three-axes": stability_of_three_axes,
    "tennis-racket": tennis_racket,
    "tennis-racket-in-the-hand": tennis_racket_in_the_hand,
    "thrown-plate": thrown_plate,
    "wing-nut": wing_nut,
}
