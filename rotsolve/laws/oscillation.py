"""Oscillation: simple harmonic motion, q̈ = −ω₀² q with T = 2π/ω₀, from an acceleration that drives back to the equilibrium."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, PI, ZERO, Call, Formula, Integral, Number, Symbol, call, negate, sqrt
from rotsolve.core.derivation import Words
from rotsolve.core.equation import HARMONIC, PENDULUM, SMALL_SWINGS, SWINGS, Equation

TWO = Number(Fraction(2))


def harmonic(acceleration: Formula, coordinate: Formula, omega: Formula, section: str) -> Equation:
    """q̈ = −ω₀² q."""
    return HARMONIC.equation(acceleration, negate(omega**2 * coordinate), section)


def pendulum(acceleration: Formula, angle: Formula, omega: Formula, section: str) -> Equation:
    """α = −ω₀² sin θ: ω₀ is the angular frequency of small swings."""
    right = negate(omega**2 * call("sin", angle))
    return PENDULUM.equation(acceleration, right, section)


def periods(omega: Formula, letters: Mapping[str, Formula], section: str, words: str) -> Iterator[Equation]:
    """T = 2π/ω₀ and f = ω₀/(2π)."""
    yield SWINGS.equation(letters["swing_period"], TWO * PI / omega, section, words=words)
    yield SWINGS.equation(letters["frequency"], omega / (TWO * PI), section, words="frequency")


def large(
    angle: Symbol, amplitude: Formula, omega: Formula, letters: Mapping[str, Formula], section: str
) -> Iterator[Equation]:
    """T = (4/ω₀) K(sin²(θ₀/2)): four times the quarter swing ∫ dθ/θ̇, with θ̇² = 2 ω₀² (cos θ − cos θ₀) by energy."""
    period = letters["swing_period"]
    gap = TWO * (call("cos", angle) - call("cos", amplitude))
    quarter = Integral(ONE / (omega * sqrt(gap)), angle.name, ZERO, amplitude)
    remark: Words = (
        4 * quarter,
        ": four quarter swings with ω² = ",
        omega**2 * gap,
        " by energy; K is the complete elliptic integral",
    )
    half = amplitude / 2 if isinstance(amplitude, Symbol) else simplify(amplitude / 2)
    exact = 4 / omega * call("ellipk", call("sin", half) ** 2)
    yield SWINGS.equation(period, exact, section, (), remark, words="period of large swings")
    yield SWINGS.equation(letters["frequency"], ONE / period, section, words="frequency")
    yield SWINGS.equation(letters["angular_frequency"], TWO * PI / period, section, words="angular frequency")


def restoring(acceleration: Formula, coordinate: Symbol) -> Formula:
    """Slope of the acceleration at the equilibrium: q̈ ≈ slope · q; negative where it drives back."""
    return differentiate(acceleration, coordinate.name).substitute({coordinate.name: ZERO})


def holds_at_any_size(acceleration: Formula, coordinate: Symbol) -> bool:
    """Whether an acceleration is proportional to the displacement, however large that is."""
    return coordinate.name not in differentiate(acceleration, coordinate.name).symbols()


def linearised(
    acceleration: Symbol, exact: Formula, first_order: Formula, coordinate: Symbol, section: str
) -> Equation:
    """q̈ ≈ slope · q for small q, with the approximations that make it so."""
    remark = approximations(exact, coordinate)
    return SMALL_SWINGS.equation(acceleration, first_order, section, (), remark, relation="≈")


def approximations(exact: Formula, coordinate: Symbol) -> Words:
    """sin θ ≈ θ and cos θ ≈ 1, as far as they occur; θ may be a multiple of the coordinate."""
    calls = dict.fromkeys(
        node for node in exact.walk(Call) if isinstance(node, Call) and coordinate.name in node.symbols()
    )
    if not calls or not all(of_small_angle(node, coordinate) for node in calls):
        return ("to first order in ", coordinate)
    used: list[str | Formula] = []
    for node in sorted(calls, key=lambda node: ("sin", "cos").index(node.function)):
        value = node.arguments[0] if node.function == "sin" else ONE
        used += [", ", node, " ≈ ", value] if used else [node, " ≈ ", value]
    return tuple(used)


def of_small_angle(node: Call, coordinate: Symbol) -> bool:
    """Whether a formula is the sine or cosine of an angle that is proportional to the coordinate."""
    angle = node.arguments[0]
    at_rest = simplify(angle.substitute({coordinate.name: ZERO}))
    return node.function in ("sin", "cos") and at_rest == ZERO and holds_at_any_size(angle, coordinate)
