"""Second routes for bodies in space: other variables than the peers', by Taylor series on FLINT."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from flint import arb
from mpmath import mp

from ..problem import Problem
from ..problems.in_space import ACROSS, ALONG, AXIAL, WEIGHT
from . import series
from .maths import maths, motion_of


def numbers(state: Sequence[arb]) -> list[Any]:
    return [mp.mpf(value.str(mp.dps, radius=False)) for value in state]


def rows(q: Sequence[Any]) -> list[list[Any]]:
    """The rotation of a quaternion of length 1."""
    w, x, y, z = q
    return [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]


def book_by_its_momentum(problem: Problem) -> list[Any]:
    """A quaternion alone: L stays in space, and ω = I⁻¹ Rᵀ L."""
    rates = [text.partition("=")[2].removesuffix(" rad/s") for text in problem.sets]

    def turning(q: Sequence[Any], held: Sequence[Any]) -> list[Any]:
        columns = zip(*rows(q), strict=True)
        return [sum(a * b for a, b in zip(column, held, strict=True)) / (k + 1) for k, column in enumerate(columns)]

    def field(q: list[Any]) -> list[Any]:
        (w, x, y, z), (a, b, c) = q, turning(q, [(k + 1) * arb(rate) for k, rate in enumerate(rates)])
        doubled = (-x * a - y * b - z * c, w * a + y * c - z * b, w * b + z * a - x * c, w * c + x * b - y * a)
        return [rate / 2 for rate in doubled]

    q = numbers(series.integrate(field, lambda: [arb(1), arb(0), arb(0), arb(0)], int(problem.until), mp.dps, 80))
    held = [(k + 1) * value for k, value in enumerate(motion_of(problem).start(maths())[:3])]
    return [*turning(q, held), *rows(q)[0]]


def top_by_elliptic_functions(problem: Problem) -> list[Any]:
    """u = cos θ from u̇² = b (u − u₁)(u₀ − u)(u₂ − u): u₁ + (u₀ − u₁) cd²(λ t), and φ̇ = a (u₀ − u)/(1 − u²) by its integral.

    a = I₃ ω₃/I₁ and b = 2 M g l/I₁; u₁ and u₂ solve b (1 − u²) = a² (u₀ − u) (Goldstein, Poole & Safko, Classical Mechanics, §5.7).
    """
    time, across, axial = mp.mpf(problem.until), mp.mpf(ACROSS), mp.mpf(ALONG) * mp.mpf(AXIAL)
    a, b, first = axial / across, 2 * mp.mpf(WEIGHT) / across, mp.cos(mp.pi / 9)
    root = mp.sqrt(a**4 - 4 * b * (a**2 * first - b))
    least, most = (a**2 - root) / (2 * b), (a**2 + root) / (2 * b)
    square, pace = (first - least) / (most - least), mp.sqrt(b * (most - least)) / 2

    def height(moment: Any) -> Any:
        return least + (first - least) * mp.ellipfun("cd", pace * moment, m=square) ** 2

    def precession(moment: Any) -> Any:
        return a * (first - height(moment)) / (1 - height(moment) ** 2)

    period = 2 * mp.ellipk(square) / pace
    whole, left = mp.floor(time / period), mp.fmod(time, period)
    phi = whole * 2 * mp.quad(precession, [0, period / 4, period / 2]) + mp.quad(precession, mp.linspace(0, left, 5))
    u, (sn, cn, dn) = height(time), (mp.ellipfun(name, pace * time, m=square) for name in ("sn", "cn", "dn"))
    sine, faster = mp.sqrt(1 - u * u), -2 * (first - least) * (1 - square) * pace * sn * cn / dn**3
    axis = [sine * mp.sin(phi), -sine * mp.cos(phi), u]
    node, beside = [mp.cos(phi), mp.sin(phi)], [-u * mp.sin(phi), u * mp.cos(phi)]
    turning = precession(time) * sine
    # L = I₁ (θ̇ e₁ + φ̇ sin θ e₂) + I₃ ω₃ e₃
    level = [across * (-faster / sine * node[k] + turning * beside[k]) + axial * axis[k] for k in range(2)]
    return [*axis, *level]
