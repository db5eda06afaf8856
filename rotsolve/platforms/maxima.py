"""Maxima: a formula as Maxima reads it, `2*m*g/(2*m+M)`, in letters that STACK leaves free.

Brackets stand wherever a reader could doubt, so that nothing hangs on which sign binds first.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from rotsolve.algebra.formula import (
    ELLIPTIC,
    FUNCTIONS,
    Call,
    Constant,
    Decimal,
    Formula,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
)

CONSTANTS = {"pi": "%pi"}
KNOWN = FUNCTIONS.keys() - ELLIPTIC.keys()  # Maxima has these by the same names
TAKEN = frozenset(
    (
        "e",
        "i",
        "j",
        "pi",
        "inf",
        "gamma",
        "beta",
        "zeta",
        "psi",
        "lambda",
        "Gamma",
        "Beta",
        "Psi",
        "del",
        "is",
        "in",
        "if",
    )
)
NO_NAME = re.compile(r"[^A-Za-z0-9_]")


class NoMaxima(ValueError):
    """A formula that Maxima has no words for."""


def letters_in_maxima(names: Iterable[str]) -> dict[str, str]:
    """A name for each letter: its own, but for what Maxima or STACK takes for something else; no two alike."""
    found: dict[str, str] = {}
    for name in sorted(names):
        plain = NO_NAME.sub("", name) or "x"
        plain = f"x{plain}" if plain[0].isdigit() or plain[0] == "_" else plain
        while plain in TAKEN or plain in found.values():
            plain += "0"
        found[name] = plain
    return found


def to_maxima(formula: Formula, letters: Mapping[str, str]) -> str:
    """The formula as text; NoMaxima where it holds what Maxima does not know by these names."""
    match formula:
        case Decimal(text):
            return f"({text})"
        case Number(value):
            return str(value) if value >= 0 and value.denominator == 1 else f"({value})"
        case Constant(name) if name in CONSTANTS:
            return CONSTANTS[name]
        case Symbol(name) if name in letters:
            return letters[name]
        case Sum(terms):
            return f"({'+'.join(to_maxima(term, letters) for term in terms) or '0'})"
        case Product(factors):
            return f"({'*'.join(to_maxima(factor, letters) for factor in factors) or '1'})"
        case Quotient(above, below):
            return f"({to_maxima(above, letters)}/{to_maxima(below, letters)})"
        case Power(base, exponent):
            return f"({to_maxima(base, letters)}^{to_maxima(exponent, letters)})"
        case Negative(operand):
            return f"(-{to_maxima(operand, letters)})"
        case Call(function, arguments) if function in KNOWN:
            return f"{function}({','.join(to_maxima(argument, letters) for argument in arguments)})"
    raise NoMaxima(f"no word of Maxima for {type(formula).__name__}")
