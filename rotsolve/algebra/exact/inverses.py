"""Inverses: exact values of asin, acos, atan, atan2, and sin and cos of them."""

from __future__ import annotations

from fractions import Fraction

from rotsolve.algebra.exact.field import Field
from rotsolve.algebra.exact.radicals import Radicals
from rotsolve.algebra.formula import (
    ONE,
    PI,
    ZERO,
    Call,
    Formula,
    Negative,
    Number,
    Quotient,
    add,
    divide,
    multiply,
    negate,
)

_ASIN = {
    Fraction(0): Fraction(0),
    Fraction(1, 4): Fraction(1, 6),
    Fraction(1, 2): Fraction(1, 4),
    Fraction(3, 4): Fraction(1, 3),
    Fraction(1): Fraction(1, 2),
}
_ATAN = {
    Fraction(0): Fraction(0),
    Fraction(1, 3): Fraction(1, 6),
    Fraction(1): Fraction(1, 4),
    Fraction(3): Fraction(1, 3),
}


def _square(node: Formula) -> tuple[int, Fraction] | None:
    """Sign and exact square of a number such as √3/2; None where the formula is no such number."""
    if node.symbols() or any(isinstance(n, Call) and n.function != "sqrt" for n in node.walk(Call)):
        return None
    sign = -1 if isinstance(node, Negative) or (isinstance(node, Number) and node.value < 0) else 1
    ring = Field([node])
    num, den = ring.convert(node)
    num, den = ring.reduce(num * num), ring.reduce(den * den)
    if not len(num):
        return 0, Fraction(0)
    if not (num.is_constant() and den.is_constant()) or len(node.children()) > 2:
        return None
    return sign, Fraction(int(num.leading_coefficient()), int(den.leading_coefficient()))


def _times_pi(turns: Fraction) -> Formula:
    if not turns:
        return ZERO
    shown = divide(multiply(Number(Fraction(abs(turns.numerator))), PI), Number(Fraction(turns.denominator)))
    return negate(shown) if turns < 0 else shown


def exact_inverse(function: str, arguments: tuple[Formula, ...]) -> Formula | None:
    """The angle as a multiple of π where the table knows it."""
    squares = [_square(argument) for argument in arguments]
    first = squares[0]
    if first is None or None in squares:
        return None
    sign, square = first
    if function in ("asin", "acos"):
        turns = _ASIN.get(square)
        if turns is None:
            return None
        return _times_pi(sign * turns if function == "asin" else Fraction(1, 2) - sign * turns)
    if function == "atan":
        turns = _ATAN.get(square)
        return None if turns is None else _times_pi(sign * turns)
    return _exact_atan2(first, squares[1])


def _exact_atan2(y: tuple[int, Fraction], x: tuple[int, Fraction] | None) -> Formula | None:
    if x is None or (not y[1] and not x[1]):
        return None
    if not x[1]:
        return _times_pi(Fraction(y[0], 2))
    turns = _ATAN.get(y[1] / x[1])
    if turns is None:
        return None
    if x[0] < 0:
        turns = 1 - turns
    return _times_pi(-turns if y[0] < 0 else turns)


def known_pair(node: Call, radicals: Radicals) -> tuple[Formula, Formula]:
    """sin and cos of an inverse function, as algebraic formulas."""
    value = node.arguments[0]
    other = radicals.sqrt(ONE - multiply(value, value)) if node.function in ("asin", "acos") else ONE
    if node.function == "asin":
        return value, other
    if node.function == "acos":
        return other, value
    x = ONE if node.function == "atan" else node.arguments[1]
    radius = radicals.sqrt(add(multiply(x, x), multiply(value, value)))
    return Quotient(value, radius), Quotient(x, radius)
