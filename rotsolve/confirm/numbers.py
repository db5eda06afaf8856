"""Numbers: what a formula is, with floats or jets put in for its letters."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import partial
from operator import ge, gt, le, lt, ne
from typing import Any

from rotsolve.algebra.formula import (
    ELLIPTIC,
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
from rotsolve.confirm import NotConfirmed, jet
from rotsolve.confirm.jet import Jet
from rotsolve.language.problem import Find, WhichOf


def by_elliptic(function: str, *arguments: float) -> float:
    """An elliptic function, loaded where one occurs."""
    from rotsolve.algebra.certified.elliptic import elliptic_float

    return elliptic_float(function, *arguments)


FLOATS: dict[str, Any] = {
    **{
        name: getattr(math, name)
        for name in ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "atan2")
    },
    "abs": abs,
    **{name: partial(by_elliptic, name) for name in ELLIPTIC},
}
JETS: dict[str, Any] = {
    "sqrt": jet.root,
    "sin": jet.sine,
    "cos": jet.cosine,
    "tan": lambda x: jet.sine(x) / jet.cosine(x),
    "exp": jet.exponential,
    "log": jet.logarithm,
    "abs": lambda x: x if x.value >= 0 else -x,
    "asin": lambda x: jet.arctangent(x, jet.root(1.0 - x * x)),
    "acos": lambda x: jet.arctangent(jet.root(1.0 - x * x), x),
    "atan": lambda x: jet.arctangent(x, Jet(1.0)),
    "atan2": lambda y, x: jet.arctangent(as_jet(y), as_jet(x)),
}
PANELS = 64
CLOSE = 2e-6  # within which two quantities count as equal
BOUNDS = {"above": ">", "below": "<"}
SIGNS: dict[str, Callable[[float, float], bool]] = {"<": lt, ">": gt, "≤": le, "≥": ge, "<=": le, ">=": ge, "≠": ne}


def as_jet(value: Jet | float) -> Jet:
    return value if isinstance(value, Jet) else Jet(value)


def value_of(formula: Formula, letters: Mapping[str, Any]) -> Any:
    """The number, or the jet, of a formula; NotConfirmed where a letter has none."""
    match formula:
        case Number(value):
            return float(value)
        case Symbol(name):
            found = letters.get(name)
            if found is None:
                raise NotConfirmed(f"`{name}` has no number")
            return value_of(found, letters) if isinstance(found, Formula) else found
        case Constant():
            return math.pi
        case Sum(terms):
            return sum([value_of(term, letters) for term in terms])
        case Product(factors):
            return math.prod([value_of(factor, letters) for factor in factors])
        case Quotient(numerator, denominator):
            return value_of(numerator, letters) / value_of(denominator, letters)
        case Power(base, exponent):
            return powered(value_of(base, letters), value_of(exponent, letters))
        case Negative(operand):
            return -value_of(operand, letters)
        case Call():
            return called(formula, letters)
        case Integral():
            return integrated(formula, letters)
    raise NotConfirmed(f"a formula of the kind {type(formula).__name__}")


def powered(base: Any, exponent: Any) -> Any:
    """base ^ exponent; a root of a negative number is no number."""
    if isinstance(exponent, Jet):
        return jet.exponential(exponent * value_of_log(base))
    result = base**exponent
    if isinstance(result, complex):
        raise NotConfirmed("a root of a negative number")
    return result


def value_of_log(base: Any) -> Any:
    return jet.logarithm(base) if isinstance(base, Jet) else math.log(base)


def called(formula: Call, letters: Mapping[str, Any]) -> Any:
    arguments = [value_of(item, letters) for item in formula.arguments]
    table = JETS if any(isinstance(item, Jet) for item in arguments) else FLOATS
    function = table.get(formula.function)
    if function is None:
        raise NotConfirmed(f"the function {formula.function}")
    try:
        return function(*arguments)
    except ValueError:
        raise NotConfirmed(f"{formula.function} of a number that has none") from None


def integrated(formula: Integral, letters: Mapping[str, Any]) -> float:
    """By Gauss's rule of three points on equal panels of s, x = m + h (3 s − s³)/2: what grows like 1/√ at an end is finite in s."""
    lower, upper = (float(value_of(end, letters)) for end in (formula.lower, formula.upper))
    middle_of, half = (lower + upper) / 2, (upper - lower) / 2
    width, total = 2.0 / PANELS, 0.0
    inside = dict(letters)
    for panel in range(PANELS):
        middle = -1.0 + (panel + 0.5) * width
        for offset, weight in ((-0.7745966692414834, 5.0), (0.0, 8.0), (0.7745966692414834, 5.0)):
            s = middle + 0.5 * width * offset
            inside[formula.variable] = middle_of + half * (3.0 - s * s) * s / 2.0
            total += weight * 1.5 * (1.0 - s * s) * float(value_of(formula.integrand, inside))
    return total * half * width / 18.0


def related(left: float, sign: str, right: float) -> bool:
    """Whether a comparison holds; numbers that are the same but for rounding are equal."""
    same = abs(left - right) <= CLOSE * max(abs(left), abs(right), 1e-9)
    if sign == "=":
        return same
    return SIGNS[sign](left, right) if not same else sign not in ("<", ">")


def options_that_hold(choice: WhichOf, valued: Callable[[Find], float]) -> str:
    """The labels of the options of a choice that hold, by the numbers of what they compare."""
    sides = [[valued(side) for side in option.sides] for option in choice.options]
    labels = [option.label for option in choice.options]
    if choice.test in ("largest", "smallest"):
        best = (max if choice.test == "largest" else min)(values[0] for values in sides)
        held = [abs(values[0] - best) <= CLOSE * max(abs(best), 1e-9) for values in sides]
    elif choice.bound is not None:
        bound = valued(choice.bound)
        held = [related(values[0], BOUNDS[choice.test], bound) for values in sides]
    else:
        signs = [option.signs for option in choice.options]
        held = [
            all(related(a, sign, b) for a, sign, b in zip(values, marks, values[1:], strict=False))
            for values, marks in zip(sides, signs, strict=True)
        ]
    return ", ".join(label for label, holds in zip(labels, held, strict=True) if holds) or "none"
