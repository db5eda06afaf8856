"""Damping: q̈ + 2 γ q̇ + ω₀² q = 0 in its three cases: it swings while γ < ω₀, else it creeps back (Taylor, Classical Mechanics, §5.4)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from rotsolve.algebra.formula import ONE, PI, Formula, Number, sqrt
from rotsolve.core.equation import DAMPED_SWINGS, Equation

ALONE, TURNING = (
    ("damping_ratio", "time_constant"),
    "turning",
)  # what is asked whether or not it swings, and what only where it does
DIES_DOWN = {
    1: "of the amplitude, as e^(−γ t)",
    0: "where it is critically damped, as (A + B t) e^(−γ t)",
    -1: "of the slower part, where it is overdamped",
}
TWO = Number(Fraction(2))


def damped_frequency(rate: Formula, free: Formula) -> Formula:
    """ω = √(ω₀² − γ²)."""
    return sqrt(free**2 - rate**2)


def damped_swings(
    rate: Formula, free: Formula, letters: Mapping[str, Formula], section: str, case: int, kind: str
) -> Iterator[Equation]:
    """One of what is asked alone, or all that hangs on a period, by γ and ω₀; `case` is the sign of ω₀ − γ."""
    if kind == "damping_ratio":
        yield DAMPED_SWINGS.equation(letters[kind], rate / free, section, words="damping ratio")
    elif kind == "time_constant":
        slow = ONE / rate if case != -1 else ONE / (rate - sqrt(rate**2 - free**2))
        yield DAMPED_SWINGS.equation(letters[kind], slow, section, words=f"time constant {DIES_DOWN[case]}")
    else:
        omega, period = letters["angular_frequency"], letters["swing_period"]
        words = "angular frequency of the damped swings, γ < ω₀"
        yield DAMPED_SWINGS.equation(omega, damped_frequency(rate, free), section, words=words)
        yield DAMPED_SWINGS.equation(period, TWO * PI / omega, section, words="period of the damped swings")
        yield DAMPED_SWINGS.equation(letters["frequency"], omega / (TWO * PI), section, words="frequency")
        words = "logarithmic decrement, of two swings that follow one another"
        yield DAMPED_SWINGS.equation(letters["logarithmic_decrement"], rate * period, section, words=words)
