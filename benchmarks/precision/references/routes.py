"""Two routes to each reference; the first is in mpmath, and is the one that is kept."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from flint import arb
from mpmath import mp

from ..peers.linear import newton
from ..problem import Problem
from ..problems.pulleys import HEAVY, LIGHT
from . import bodies, coins, extrapolation, series, slips
from .maths import maths, motion_of

Route = Callable[[Problem], list[Any]]
FIRST_STEP = "0.1"  # s


def extrapolated(problem: Problem) -> list[Any]:
    """The peers' own equations of motion by extrapolation."""
    motion = motion_of(problem)
    end = extrapolation.integrate(
        motion.rates(maths()), mp.mpf(0), motion.start(maths()), mp.mpf(problem.until), mp.mpf(FIRST_STEP)
    )
    return motion.read(end, +mp.pi)


def rod_by_elliptic_functions(problem: Problem) -> list[Any]:
    """sin(θ/2) = k sn(K + ω₀ t, k) and θ̇ = 2 k ω₀ cn(K + ω₀ t, k), with θ = π − φ from hanging and k = cos(φ₀/2)."""
    motion = motion_of(problem)
    half = motion.start(maths())[0] / 2
    square, pace = mp.cos(half) ** 2, mp.sqrt(mp.mpf("14.7"))
    quarter = mp.pi / (2 * mp.agm(1, mp.sin(half)))
    turn = mp.fmod(pace * mp.mpf(problem.until), 4 * quarter) + quarter
    modulus = mp.sqrt(square)
    theta = 2 * mp.asin(modulus * mp.ellipfun("sn", turn, m=square))
    return motion.read([mp.pi - theta, -2 * modulus * pace * mp.ellipfun("cn", turn, m=square)], +mp.pi)


def rod_within_a_period(problem: Problem) -> list[Any]:
    """By extrapolation over what is left of the time after whole periods, each 4 K/ω₀ by its integral."""
    motion = motion_of(problem)
    quarter = quarter_by_integral(mp.sin(motion.start(maths())[0] / 2)) / mp.sqrt(mp.mpf("14.7"))
    left = mp.fmod(mp.mpf(problem.until), 4 * quarter)
    return extrapolated(problem._replace(until=mp.nstr(left, mp.dps)))


def two_rods_by_hamilton(problem: Problem) -> list[Any]:
    """Hamilton's equations of the two rods by Taylor series: momenta p = ∂T/∂ȧ, q = ∂T/∂ḃ, of 1 kg and 1 m each."""

    def field(state: list[Any]) -> list[Any]:
        upper, lower, first, second = state
        between = upper - lower
        sine, cosine = between.sin(), between.cos()
        whole = arb(16) - arb(9) * cosine * cosine
        fast = (arb(12) * first - arb(18) * cosine * second) / whole
        faster = (arb(48) * second - arb(18) * cosine * first) / whole
        coupling = fast * faster * sine / arb(2)
        gravity = arb(49) / 5
        return [
            fast,
            faster,
            -coupling - gravity * upper.sin() * arb(3) / arb(2),
            coupling - gravity * lower.sin() / arb(2),
        ]

    def start() -> list[Any]:
        return [arb.pi() / 2, arb.pi() / 2, arb(0), arb(0)]

    upper, lower, first, second = series.integrate(field, start, int(problem.until), mp.dps)
    a, b, p, q = (mp.mpf(value.str(mp.dps, radius=False)) for value in (upper, lower, first, second))
    cosine = mp.cos(a - b)
    whole = 16 - 9 * cosine**2
    return [a - mp.pi / 2, b - mp.pi / 2, (12 * p - 18 * cosine * q) / whole, (48 * q - 18 * cosine * p) / whole]


def quarter_by_integral(complement: Any) -> Any:
    """K = ∫ dψ/√(sin² ψ + k′² cos² ψ) from 0 to π/2, in pieces that grow by 4 where it is steep."""
    steps = (complement * 4**power for power in range(100))
    places = [mp.mpf(0), *(place for place in steps if place < 1), mp.pi / 2]
    return mp.quad(lambda psi: 1 / mp.hypot(mp.sin(psi), complement * mp.cos(psi)), places)


def period_by_means(problem: Problem) -> list[Any]:
    """T = 2 π √(L/g)/agm(1, cos(θ₀/2))."""
    return [2 * mp.pi / mp.sqrt(mp.mpf("9.8")) / mp.agm(1, mp.sin(motion_of(problem).start(maths())[0] / 2))]


def period_by_integral(problem: Problem) -> list[Any]:
    """T = 4 √(L/g) K by quadrature."""
    return [4 / mp.sqrt(mp.mpf("9.8")) * quarter_by_integral(mp.sin(motion_of(problem).start(maths())[0] / 2))]


def way_by_fractions(problem: Problem) -> list[Any]:
    """x = ½ a t², a = (m₂ − m₁) g/(m₁ + m₂ + M/2), in fractions."""
    light, heavy, time = Fraction(LIGHT), Fraction(HEAVY), Fraction(problem.until)
    way = (heavy - light) * Fraction("9.8") / (light + heavy + 1) * time**2 / 2
    return [mp.mpf(way.numerator) / way.denominator]


def way_by_newton(problem: Problem) -> list[Any]:
    """Newton's laws of both blocks and the disc for a, T₁ and T₂, by elimination."""
    light, heavy, gravity = mp.mpf(LIGHT), mp.mpf(HEAVY), mp.mpf("9.8")
    rows = mp.matrix([[light, -1, 0], [heavy, 0, 1], [1, 1, -1]])  # the disc: T₂ − T₁ = ½ M a
    right = mp.matrix([-light * gravity, heavy * gravity, 0])
    return [mp.lu_solve(rows, right)[0] * mp.mpf(problem.until) ** 2 / 2]


def tension_by_fractions(problem: Problem) -> list[Any]:
    """T = m M g/(2 m + M), in fractions."""
    mass, disc = Fraction(10**6), Fraction(1, 10**6)
    tension = mass * disc * Fraction("9.8") / (2 * mass + disc)
    return [mp.mpf(tension.numerator) / tension.denominator]


def tension_by_newton(problem: Problem) -> list[Any]:
    """Newton's laws and the string, by elimination."""
    rows, right = newton(mp.mpf)
    return [mp.lu_solve(mp.matrix(rows), mp.matrix(right))[2]]


ROUTES: dict[str, tuple[Route, Route]] = {
    "rod-from-179.99-degrees": (rod_by_elliptic_functions, extrapolated),
    "rod-1e-8-from-upright": (rod_by_elliptic_functions, extrapolated),
    "two-hinged-rods": (extrapolated, two_rods_by_hamilton),
    "driven-pulley": (slips.in_closed_form, slips.by_extrapolation),
    "free-asymmetric-book": (extrapolated, bodies.book_by_its_momentum),
    "book-1e-10-off-its-middle-axis": (extrapolated, bodies.book_by_its_momentum),
    "heavy-top": (extrapolated, bodies.top_by_elliptic_functions),
    "rolling-coin": (extrapolated, coins.coin_by_its_tilt),
    "rod-for-2000-s": (rod_by_elliptic_functions, rod_within_a_period),
    "period-from-60-degrees": (period_by_means, period_by_integral),
    "period-from-170-degrees": (period_by_means, period_by_integral),
    "period-from-179.9999-degrees": (period_by_means, period_by_integral),
    "nearly-equal-masses": (way_by_fractions, way_by_newton),
    "mass-ratio-1e12": (tension_by_fractions, tension_by_newton),
}
