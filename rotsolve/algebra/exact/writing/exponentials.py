"""Exponentials: 1 − exp(−x) as a textbook writes it, rather than (exp(x) − 1) exp(−x)."""

from __future__ import annotations

from collections.abc import Callable

from rotsolve.algebra.formula import ONE, ZERO, Call, Formula, Negative, Product, Sum, add, multiply, negate, total

Tidy = Callable[[Formula], Formula]


def spread(node: Formula, tidy: Tidy) -> Formula:
    """A product of a sum and an exponential multiplied out where that makes an exponential of the sum go away."""
    if not isinstance(node, Product):
        return node
    outer = next((part for part in node.factors if isinstance(part, Call) and part.function == "exp"), None)
    inner = next((part for part in node.factors if isinstance(part, Sum)), None)
    if outer is None or inner is None:
        return node
    terms = [times(term, outer, tidy) for term in inner.terms]
    if not any(gone for _, gone in terms):
        return node
    written = [term for term, _ in terms]
    written.sort(key=lambda term: isinstance(term, Negative))
    result: Formula = ONE
    for part in node.factors:
        if part is inner:
            part = total(written)
        result = multiply(result, part) if part is not outer else result
    return result


def times(term: Formula, outer: Call, tidy: Tidy) -> tuple[Formula, bool]:
    """term · exp(u), and whether an exp(−u) in the term went away."""
    if isinstance(term, Negative):
        inside, gone = times(term.operand, outer, tidy)
        return negate(inside), gone
    factors = term.factors if isinstance(term, Product) else (term,)
    result: Formula = ONE
    exponent = outer.arguments[0]
    gone = False
    for factor in factors:
        if isinstance(factor, Call) and factor.function == "exp":
            exponent, gone = tidy(add(exponent, factor.arguments[0])), True
        else:
            result = multiply(result, factor)
    last = ONE if exponent == ZERO else Call("exp", (exponent,))
    return multiply(result, last), gone and exponent == ZERO
