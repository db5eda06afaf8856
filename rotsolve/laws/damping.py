"""Damping: q̈ + 2 γ q̇ + ω₀² q = 0 in its three cases: it swings while γ < ω₀, else it creeps back (Kleppner & Kolenkow, §11.2)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from rotsolve.algebra.formula import ONE, PI, Formula, Number, sqrt
from rotsolve.core.equation import DAMPED_SWINGS, Equation

TWO = Number(Fraction(2))


def damped_frequency(rate: Formula, free: Formula) -> Formula:
    """ω = √(ω₀² − γ²)."""
    return sqrt(free**2 - rate**2)


def damped_swings(
    rate: Formula, free: Formula, letters: Mapping[str, Formula], section: str, case: int | None
) -> Iterator[Equation]:
    """What is asked of damped swings, by γ and ω₀; `case` is the sign of ω₀ − γ: only while it is positive there is a period."""
    yield DAMPED_SWINGS.equation(letters["damping_ratio"], rate / free, section, words="damping ratio")
    if case == 1:
        omega, period = letters["angular_frequency"], letters["swing_period"]
        words = "angular frequency of the damped swings, γ < ω₀"
        yield DAMPED_SWINGS.equation(omega, damped_frequency(rate, free), section, words=words)
        yield DAMPED_SWINGS.equation(period, TWO * PI / omega, section, words="period of the damped swings")
        yield DAMPED_SWINGS.equation(letters["frequency"], omega / (TWO * PI), section, words="frequency")
        words = "logarithmic decrement, of two swings that follow one another"
        yield DAMPED_SWINGS.equation(letters["logarithmic_decrement"], rate * period, section, words=words)
    slow = ONE / rate if case != -1 else ONE / (rate - sqrt(rate**2 - free**2))
    words = {
        1: "time constant of the amplitude, as e^(−γ t)",
        0: "time constant, critically damped: as (A + B t) e^(−γ t)",
        -1: "time constant of the slower part, overdamped",
    }[1 if case is None else case]
    yield DAMPED_SWINGS.equation(letters["time_constant"], slow, section, words=words)
