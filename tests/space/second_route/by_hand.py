"""Answers that the assembly does not confirm, with the reason, and a closed form of each, and of some more, worked out by hand."""

from __future__ import annotations

from collections.abc import Callable
from math import acos, atan2, cos, cosh, degrees, pi, sin, sqrt, tanh
from types import SimpleNamespace as Numbers
from typing import Any

import numpy as np

DAY = 86400.0
TOO_LONG = "the way to its state is too long to be followed"
CHANGES = "`skater` changes on the way"
TENSOR = "inertia tensor of a body"
IN_SPACE = "an angular momentum in space, or that of a part"
ABOUT_CENTRES = ["box", "cube", "cylinder", "ellipsoid", "hollow-sphere", "lamina", "solid-sphere", "tube"]
UNCONFIRMED = {  # by problem and answer, in the words of the assembly
    **{f"tensor-{name}": {"I_tensor": TENSOR} for name in ABOUT_CENTRES},  # of scenes in the plane
    "box-about-a-point": {"I_A": TENSOR},
    "two-spheres-tensor": {"x_com": "cm of a body", "I_tensor": TENSOR},
    "particle-off-the-plane": {
        "L": "its parts are not known to the assembly",
        **dict.fromkeys(("L_perp", "angle_to_omega"), IN_SPACE),
    },
    "gyroscope-by-fast-spin": {"Omega": "the scene asks for an approximation"},
    "pole-of-the-earth-in-time": {"T_w": TOO_LONG},
    "skater-pulls-in": dict.fromkeys(("w", "w_f", "W", "tau"), CHANGES),
    "wing-nut": {"flip": TOO_LONG},
}


def gyroscope_by_fast_spin(n: Numbers) -> dict[str, float]:
    """What k Ω of the slow steady precession with the spin k ω₃, I₁ cos θ Ω² − I₃ ω₃ Ω + M g l = 0, comes to."""
    weight, fast = n.M * n.g * n.l, 1e6
    spin = n.I3 * n.w3 * fast
    return {"Omega": fast * 2 * weight / (spin + sqrt(spin**2 - 4 * n.I1 * weight * cos(n.theta)))}


def pole_of_the_earth_in_time(n: Numbers) -> dict[str, float]:
    """I₁ (ω₁ + i ω₂)˙ = i (I₃ − I₁) ω₃ (ω₁ + i ω₂)."""
    difference = n.I1 * (1 + n.e) - n.I1
    return {"T_w": 2 * pi * n.I1 / (difference * n.w3) / DAY}


def skater_pulls_in(n: Numbers) -> dict[str, float]:
    """I ω = L; the energy is L²/(2 I). What holds ω gives L at an even rate."""
    momentum, midway = n.I0 * n.w0, n.I0 - (n.I0 - n.If) * n.t / n.T
    energies = [momentum**2 / (2 * inertia) for inertia in (n.I0, n.If)]
    rates = {"w": momentum / midway, "w_f": momentum / n.If}
    return {**rates, "W": energies[1] - energies[0], "tau": (n.If * n.w0 - momentum) / n.T}


def mean(one: float, other: float) -> float:
    """The arithmetic-geometric mean."""
    while abs(one - other) > 1e-15 * one:
        one, other = (one + other) / 2, sqrt(one * other)
    return one


def there_and_back(inertia: tuple[float, float, float], middle: float, kept: float) -> float:
    """The period of a free body that turns with `middle` about its second axis, and with `kept` about its first, but not about its third.

    ω₃ = W sin u, ω₂ = ω₂₀ cos u, ω₁² = ω₁₀² + κ sin² u by energy and angular momentum; then ω̇₃ = (I₁ − I₂) ω₁ ω₂/I₃ is one of u, and
    ∫ du/√(a² cos² u + b² sin² u) over a quarter turn is π/2 over the mean of a and b.
    """
    first, second, third = inertia
    growths = (second - third) / first, (third - first) / second, (first - second) / third
    widest = -growths[2] / growths[1] * middle**2
    most = sqrt(kept**2 + growths[0] / growths[2] * widest)
    return 2 * pi / (sqrt(-growths[1] * growths[2]) * mean(kept, most))


def tennis_racket(n: Numbers) -> dict[str, float]:
    period = there_and_back((n.I1, n.I2, n.I3), n.w2, n.w1)
    return {"T_r": period, "flip": period / 2}


def between_both_cases_in_space(n: Numbers) -> dict[str, Any]:
    """The middle axis goes evenly round L at L/I₂ and comes ever nearer to it, cos θ = tanh τ (Landau & Lifshitz, §37, problem 1)."""
    momentum = np.array([n.I1 * sqrt(3) * n.w, 0.0, n.I3 * n.w])
    size = float(np.linalg.norm(momentum))
    along, level = momentum / size, np.array([0.0, 1.0, 0.0])
    tau, gone = n.w * sqrt((n.I3 - n.I2) * (n.I3 - n.I1) / (n.I1 * n.I2)) * n.T, size / n.I2 * n.T
    across = cos(gone) * level + sin(gone) * np.cross(along, level)
    axis = across / cosh(tau) + along * tanh(tau)
    return {"e_x": axis[0], "e_y": axis[1], "e_z": axis[2], "theta": degrees(acos(tanh(tau)))}


def wing_nut(n: Numbers) -> dict[str, float]:
    """Its first and third axes change places."""
    return {"flip": there_and_back((n.I3, n.I2, n.I1), n.w2, n.w3) / 2}


def box(mass: float, a: float, b: float, c: float) -> Any:
    return np.diag([b * b + c * c, a * a + c * c, a * a + b * b]) * mass / 12


def round_(mass: float, across: float, along: float, radius: float, length: float) -> Any:
    """Of what is round about z: m (share R² + h²/12) across, m share R² along."""
    level = across * radius**2 + length**2 / 12
    return np.diag([level, level, along * radius**2]) * mass


def parallel(mass: float, at: list[float]) -> Any:
    """What the theorem of parallel axes adds."""
    return mass * (np.dot(at, at) * np.eye(3) - np.outer(at, at))


def box_about_a_point(n: Numbers) -> dict[str, Any]:
    return {"I_A": box(n.m, n.w, n.h, n.d) + parallel(n.m, [n.xs, n.ys, n.zs])}


def two_spheres_tensor(n: Numbers) -> dict[str, Any]:
    """By the reduced mass."""
    own, reduced = 0.4 * (n.m1 * n.r1**2 + n.m2 * n.r2**2), n.m1 * n.m2 / (n.m1 + n.m2)
    tensor = own * np.eye(3) + parallel(reduced, [n.x2 - n.x1, 0, 0])
    return {"x_com": n.x1 + n.m2 / (n.m1 + n.m2) * (n.x2 - n.x1), "I_tensor": tensor}


def particle_off_the_plane(n: Numbers) -> dict[str, Any]:
    """p = m r ω along y."""
    momentum = n.m * n.r * n.omega
    parts = np.array([-n.z * momentum, 0, n.r * momentum])
    return {"L": parts, "L_perp": n.z * momentum, "angle_to_omega": atan2(n.z, n.r)}


def of_centre(tensor: Callable[[Numbers], Any]) -> Callable[[Numbers], dict[str, Any]]:
    return lambda n: {"I_tensor": tensor(n)}


CLOSED_FORMS: dict[str, Callable[[Numbers], dict[str, Any]]] = {
    "box-about-a-point": box_about_a_point,
    "gyroscope-by-fast-spin": gyroscope_by_fast_spin,
    "pole-of-the-earth-in-time": pole_of_the_earth_in_time,
    "particle-off-the-plane": particle_off_the_plane,
    "skater-pulls-in": skater_pulls_in,
    "tennis-racket": tennis_racket,
    "between-both-cases-in-space": between_both_cases_in_space,
    "tensor-box": of_centre(lambda n: box(n.m, n.w, n.h, n.d)),
    "tensor-cube": of_centre(lambda n: box(n.M, n.a, n.a, n.a)),
    "tensor-cylinder": of_centre(lambda n: round_(n.m, 1 / 4, 1 / 2, n.r, n.h)),
    "tensor-ellipsoid": of_centre(lambda n: box(12 / 5 * n.m, n.a, n.b, n.c)),  # ⟨x²⟩ = a²/5 instead of a²/12
    "tensor-hollow-sphere": of_centre(lambda n: round_(n.m, 2 / 3, 2 / 3, n.r, 0)),
    "tensor-lamina": of_centre(lambda n: box(n.M, n.a, n.b, 0)),
    "tensor-solid-sphere": of_centre(lambda n: round_(n.m, 2 / 5, 2 / 5, n.r, 0)),
    "tensor-tube": of_centre(lambda n: round_(n.m, 1 / 2, 1, n.r, n.h)),
    "two-spheres-tensor": two_spheres_tensor,
    "wing-nut": wing_nut,
}
