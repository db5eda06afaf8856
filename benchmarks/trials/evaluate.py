"""Evaluate: formulas by mpmath, with a walk of its own that shares nothing with the balls of rotsolve."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mpmath
from mpmath import mp, mpf

from rotsolve.algebra.formula import (
    Call,
    Constant,
    Formula,
    Integral,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
)
from trials.draw import exactly

NEARLY = mpf(10) ** -60  # of the largest term: what 150 figures leave of what cancels


class Unknown(ValueError):
    """A letter without a value, or a place where the formula is not real."""


JACOBI = {"ellipsn": "sn", "ellipcn": "cn", "ellipdn": "dn"}


def value(formula: Formula, letters: Mapping[str, mpf]) -> mpf:
    """The number of a formula at the precision of mpmath; Unknown where it has none."""
    found = _value(formula, letters)
    if isinstance(found, mpmath.mpc) or not mp.isfinite(found):
        raise Unknown(f"{formula!r} is not real")
    return found


def _value(node: Formula, letters: Mapping[str, mpf]) -> Any:
    match node:
        case Number(number):
            return exactly(number)
        case Constant():
            return +mp.pi
        case Symbol(name):
            if name not in letters:
                raise Unknown(name)
            return letters[name]
        case Sum(terms):
            return total([value(term, letters) for term in terms])
        case Product(factors):
            return mp.fprod(value(factor, letters) for factor in factors)
        case Quotient(numerator, denominator):
            below = value(denominator, letters)
            if not below:
                raise Unknown("division by zero")
            return value(numerator, letters) / below
        case Negative(operand):
            return -value(operand, letters)
        case Power(base, exponent):
            return _power(value(base, letters), value(exponent, letters))
        case Call("abs", (argument,)):
            return abs(value(argument, letters))
        case Call(function, arguments):
            try:
                numbers = [value(argument, letters) for argument in arguments]
                if function in JACOBI:
                    return mp.ellipfun(JACOBI[function], numbers[0], m=numbers[1])
                return getattr(mp, function)(*numbers)
            except (ValueError, ZeroDivisionError) as error:
                raise Unknown(str(error)) from None
        case Integral():
            raise Unknown("an integral")
    raise TypeError(f"no value for {node!r}")


def total(terms: list[mpf]) -> mpf:
    """The sum of the terms; nothing where they cancel so far that only their roundings are left."""
    found = mp.fsum(terms)
    return found if abs(found) > NEARLY * max(map(abs, terms)) else mpf(0)


def _power(base: mpf, exponent: mpf) -> Any:
    if not base and exponent < 0:
        raise Unknown("division by zero")
    return base**exponent
