"""Exponentials: 1 − exp(−x) as a textbook writes it, rather than (exp(x) − 1) exp(−x); ln a + ln b as ln(a b), where that is shorter."""

from __future__ import annotations

from collections.abc import Callable

from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import (
    ONE,
    ZERO,
    Call,
    Formula,
    Negative,
    Product,
    Sum,
    add,
    divide,
    multiply,
    negate,
    total,
)

Tidy = Callable[[Formula], Formula]


def with_fewest_exponentials(node: Formula, tidy: Tidy) -> Formula:
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
    written = sorted([term for term, _ in terms], key=lambda term: isinstance(term, Negative))
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


def one_logarithm(node: Formula, tidy: Tidy) -> Formula:
    """A sum with its logarithms, each of something positive, put together; as it is where that makes it no shorter."""
    if not isinstance(node, Sum):
        return node
    inside: Formula = ONE
    others, found = list[Formula](), 0
    for term in node.terms:
        bare = term.operand if isinstance(term, Negative) else term
        if not (isinstance(bare, Call) and bare.function == "log"):
            others.append(term)
            continue
        put_in = divide if isinstance(term, Negative) else multiply
        inside, found = put_in(inside, bare.arguments[0]), found + 1
    if found < 2:
        return node
    whole = add(Call("log", (tidy(inside),)), total(others))
    return whole if length(whole) < length(node) else node
