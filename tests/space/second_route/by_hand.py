"""Answers that the assembly does not confirm, with the reason, and a closed form of each, worked out by hand from conserved quantities."""

from __future__ import annotations

from math import cos, pi, sqrt
from types import SimpleNamespace as Numbers

DAY = 86400.0
TOO_LONG = "the way to its state is too long to be followed"
CHANGES = "`skater` changes on the way"
UNCONFIRMED = {  # by problem and answer, in the words of the assembly
    "gyroscope-by-fast-spin": {"Omega": "the scene asks for an approximation"},
    "pole-of-the-earth-in-time": {"T_w": TOO_LONG},
    "skater-pulls-in": dict.fromkeys(("w", "w_f", "W", "tau"), CHANGES),
    "tennis-racket": dict.fromkeys(("T_r", "flip"), TOO_LONG),
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


def wing_nut(n: Numbers) -> dict[str, float]:
    """Its first and third axes change places."""
    return {"flip": there_and_back((n.I3, n.I2, n.I1), n.w2, n.w3) / 2}


CLOSED_FORMS = {
    "gyroscope-by-fast-spin": gyroscope_by_fast_spin,
    "pole-of-the-earth-in-time": pole_of_the_earth_in_time,
    "skater-pulls-in": skater_pulls_in,
    "tennis-racket": tennis_racket,
    "wing-nut": wing_nut,
}
