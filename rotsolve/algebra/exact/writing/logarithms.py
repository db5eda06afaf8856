"""Logarithms: ln a + ln b as ln(a b), where that is shorter."""

from __future__ import annotations

from collections.abc import Callable

from rotsolve.algebra.exact.writing.length import length
from rotsolve.algebra.formula import ONE, Call, Formula, Negative, Sum, add, divide, multiply, total


def one_logarithm(node: Formula, tidy: Callable[[Formula], Formula]) -> Formula:
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
    whole = add(Call("log", (tidy(inside),)), total(others)) if others else Call("log", (tidy(inside),))
    return whole if length(whole) < length(node) else node
