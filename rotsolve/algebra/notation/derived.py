"""Derived functions: what is written by the functions that formulas know: cot x = 1/tan x, tanh x, lg x = ln x/ln 10."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from rotsolve.algebra.formula import ONE, Call, Formula, Number, Quotient, sqrt

TEN, HALF = Number(Fraction(10)), Number(Fraction(1, 2))


def reciprocal(function: str) -> Callable[[Formula], Formula]:
    """1/function(x)."""
    return lambda x: Quotient(ONE, Call(function, (x,)))


def _exp(x: Formula) -> Formula:
    return Call("exp", (x,))


def _log(x: Formula) -> Formula:
    return Call("log", (x,))


def sinh(x: Formula) -> Formula:
    """(eˣ − e⁻ˣ)/2."""
    return HALF * (_exp(x) - _exp(-x))


def cosh(x: Formula) -> Formula:
    """(eˣ + e⁻ˣ)/2."""
    return HALF * (_exp(x) + _exp(-x))


def tanh(x: Formula) -> Formula:
    """(e²ˣ − 1)/(e²ˣ + 1)."""
    twice = _exp(2 * x)
    return Quotient(twice - ONE, twice + ONE)


def asinh(x: Formula) -> Formula:
    """ln(x + √(x² + 1))."""
    return _log(x + sqrt(x**2 + ONE))


def acosh(x: Formula) -> Formula:
    """ln(x + √(x² − 1)), for x ≥ 1."""
    return _log(x + sqrt(x**2 - ONE))


def atanh(x: Formula) -> Formula:
    """½ ln((1 + x)/(1 − x)), for |x| < 1."""
    return HALF * _log(Quotient(ONE + x, ONE - x))


DERIVED: dict[str, Callable[[Formula], Formula]] = {
    "cot": reciprocal("tan"),
    "sec": reciprocal("cos"),
    "csc": reciprocal("sin"),
    "sinh": sinh,
    "cosh": cosh,
    "tanh": tanh,
    "coth": lambda x: Quotient(ONE, tanh(x)),
    "asinh": asinh,
    "acosh": acosh,
    "atanh": atanh,
    "acoth": lambda x: atanh(Quotient(ONE, x)),
    "log10": lambda x: Quotient(_log(x), _log(TEN)),
}
OTHER_NAMES = {
    "cosec": "csc",
    "lg": "log10",
    "log_10": "log10",
    **{f"{prefix}{name}": f"a{name}" for prefix in ("ar", "arc") for name in ("sinh", "cosh", "tanh", "coth")},
}
DERIVED_NAMES = {name: name for name in DERIVED} | OTHER_NAMES
