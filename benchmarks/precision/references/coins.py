"""The second route to the rolling coin: ω₃ as Legendre functions of its tilt, the tilt from the energy, time by a Fourier series.

With θ for a variable the equations of a disc that rolls are linear: ω₃″ + cot θ ω₃′ − 4/3 ω₃ = 0, and φ̇ sin θ = 3/2 ω₃′
(P. Appell, S. Korteweg, 1900; E. J. Routh, Dynamics of a System of Rigid Bodies, Advanced Part, §244).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from mpmath import mp

from ..problem import Problem
from ..problems.rolling_coin import STIFFNESS
from .maths import maths, motion_of

TERMS = 96  # of the series, whose terms shrink by more than a digit each
NEAR_LOWEST = ("0.998", "0.999")  # rad, near the tilt at which it turns round


def axial_rates(theta: Any, axial: Any, slope: Any) -> Callable[[Any], tuple[Any, Any]]:
    """ω₃ and ω₃′ as functions of the tilt, from both at one tilt: of F(−ν, ν + 1; 1; z), z = sin² θ/2 and cos² θ/2."""
    nu = mp.mpc(-0.5, mp.sqrt(mp.mpf(13) / 12))

    def both(tilt: Any) -> Any:
        rows = []
        for z, rate in ((mp.sin(tilt / 2) ** 2, mp.sin(tilt) / 2), (mp.cos(tilt / 2) ** 2, -mp.sin(tilt) / 2)):
            grown = mp.mpf(4) / 3 * mp.hyp2f1(1 - nu, nu + 2, 2, z)
            rows.append([mp.re(mp.hyp2f1(-nu, nu + 1, 1, z)), mp.re(grown) * rate])
        return mp.matrix(rows).T

    share = mp.lu_solve(both(theta), mp.matrix([axial, slope]))
    return lambda tilt: tuple(both(tilt) * share)


def cosine_series(function: Callable[[Any], Any]) -> list[Any]:
    """Σ aₙ cos(n χ) of an even function of period 2 π, from its values in the midst of equal parts."""
    nodes = [mp.pi * (2 * number + 1) / (2 * TERMS) for number in range(TERMS)]
    values = [function(node) for node in nodes]
    parts = [2 * mp.fdot(values, [mp.cos(order * node) for node in nodes]) / TERMS for order in range(TERMS)]
    return [parts[0] / 2, *parts[1:]]


def coin_by_its_tilt(problem: Problem) -> list[Any]:
    """θ = c + d cos χ between the tilts at which it turns round, t = a₀ χ + Σ aₙ sin(n χ)/n."""
    first, _, precession, axial = motion_of(problem).start(maths())
    rates = axial_rates(first, axial, 2 * precession * mp.sin(first) / 3)

    def bound(tilt: Any) -> Any:
        rate, slope = rates(tilt)
        return 3 * (rate**2 + 3 * slope**2 / 8) / 4 + mp.mpf(STIFFNESS) * mp.sin(tilt)

    def square(tilt: Any) -> Any:
        return 8 * (whole - bound(tilt)) / 5  # θ̇², of the energy that is left

    whole = bound(first)
    last = mp.findroot(lambda tilt: square(tilt) / (first - tilt), tuple(map(mp.mpf, NEAR_LOWEST)))
    middle, half = (first + last) / 2, (first - last) / 2
    series = cosine_series(lambda chi: half * mp.sin(chi) / mp.sqrt(square(middle + half * mp.cos(chi))))  # of dt/dχ

    def late(chi: Any) -> Any:
        parts = (part * mp.sin(order * chi) / order for order, part in enumerate(series[1:], 1))
        return series[0] * chi + mp.fsum(parts) - mp.mpf(problem.until)

    chi = mp.findroot(late, mp.mpf(problem.until) / series[0])
    tilt = middle + half * mp.cos(chi)
    rate, slope = rates(tilt)
    return [tilt, -mp.sign(mp.sin(chi)) * mp.sqrt(square(tilt)), 3 * slope / (2 * mp.sin(tilt)), rate]
