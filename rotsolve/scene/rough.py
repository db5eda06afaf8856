"""Rough numbers: floats that only decide whether a value lies within its limits. No answer is ever made from them."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from rotsolve.algebra.certified.ball import decided_by_size
from rotsolve.algebra.formula import Call, Constant, Formula, Negative, Number, Power, Product, Quotient, Sum, Symbol


def elliptic(m: float) -> float:
    """K(m) = π/(2 M(1, √(1 − m))) by the arithmetic-geometric mean M."""
    one, other = 1.0, math.sqrt(1 - m)
    while abs(one - other) > 1e-15 * one:
        one, other = (one + other) / 2, math.sqrt(one * other)
    return math.pi / (2 * one)


CALLS: dict[str, Callable[[float], float]] = {"log": math.log, "abs": math.fabs, "ellipk": elliptic}
CALLS |= {name: getattr(math, name) for name in ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "exp")}


def rough(formula: Formula, numbers: Mapping[str, float]) -> float | None:
    """The value of a formula as a float, by whose size something is decided; None where there is none."""
    if formula.symbols():
        decided_by_size()
    return size(formula, numbers)


def size(formula: Formula, numbers: Mapping[str, float]) -> float | None:
    """The value of a formula as a float; None where a letter has no value or the float range is left."""
    try:
        value = float_value(formula, numbers)
    except (ArithmeticError, ValueError, KeyError, TypeError):
        return None
    return value if math.isfinite(value) else None


def remember(numbers: dict[str, float], name: str, formula: Formula | None) -> None:
    value = None if formula is None else size(formula, numbers)
    if value is not None:
        numbers[name] = value


def float_value(formula: Formula, numbers: Mapping[str, float]) -> float:
    match formula:
        case Number(value):
            return float(value)
        case Symbol(name):
            return numbers[name]
        case Constant():
            return math.pi
        case Call("atan2", (y, x)):
            return math.atan2(float_value(y, numbers), float_value(x, numbers))
        case Call(function, (argument,)):
            return CALLS[function](float_value(argument, numbers))
        case Call(function, arguments):
            from rotsolve.algebra.certified.elliptic import elliptic_float

            return elliptic_float(function, *(float_value(argument, numbers) for argument in arguments))
    values = [float_value(child, numbers) for child in formula.children()]
    match formula:
        case Sum():
            return math.fsum(values)
        case Product():
            return math.prod(values)
        case Quotient():
            return values[0] / values[1]
        case Negative():
            return -values[0]
        case Power():
            return float(values[0] ** values[1])
    raise ValueError("no number")
