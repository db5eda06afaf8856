"""Unwrap: an unknown that stands in one function alone: log(u) = y gives u = exp(y), and so on inwards."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.exact.solving.linear import solve_linear
from rotsolve.algebra.exact.solving.roots import solve_polynomial
from rotsolve.algebra.formula import Call, Formula, Quotient, Symbol, add, call, negate

INVERSE = {"log": "exp", "exp": "log", "asin": "sin", "acos": "cos", "atan": "tan"}
STAND_IN = "function value"


def solve_unwrapped(
    f: Formula, unknown: str, *, order: Sequence[str] = (), positive: Collection[str] = ()
) -> list[Formula]:
    """The roots of f = 0 where the unknown occurs within one function only, and linearly or as a square within that."""
    wraps = {
        node
        for node in f.walk(*INVERSE)
        if isinstance(node, Call) and unknown in node.symbols() and node.function in INVERSE
    }
    outer = [node for node in wraps if not any(node is not other and node in set(other.walk()) for other in wraps)]
    if len(outer) != 1:
        return []
    wrap = outer[0]
    opened = f.transform(lambda node: Symbol(STAND_IN) if node == wrap else node, wrap.function)
    if unknown in opened.symbols():
        return []
    value = solve_linear(opened, STAND_IN, order=order, positive=positive)
    if value is None:
        return []
    argument = wrap.arguments[0]
    if wrap.function == "log" and isinstance(argument, Quotient) and unknown not in argument.numerator.symbols():
        argument, value = argument.denominator / argument.numerator, negate(value)  # so that 1 − exp(−y) comes out
    inner = simplify(call(INVERSE[wrap.function], value), order=order, positive=positive)
    gap = add(argument, negate(inner))
    roots = solve_polynomial(gap, unknown, order=order, positive=positive)
    return roots or solve_unwrapped(gap, unknown, order=order, positive=positive)
