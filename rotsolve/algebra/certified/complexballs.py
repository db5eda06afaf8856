"""Complex balls: integrands, over the complex balls (acb) by which certified integration asks for them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce
from operator import add, mul

from rotsolve.algebra.certified.balls import Ball, RealBalls, Steady, Undefined
from rotsolve.algebra.certified.turning import integrated, work_limit
from rotsolve.algebra.flints import acb, arb
from rotsolve.algebra.formula import (
    ELLIPTIC,
    Call,
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

SHARP = 20  # bits to which both ends of an integral are known where it is worth its work
ROUGHLY = 300  # evaluations of one between other ends


class ComplexBalls:
    """Evaluates an integrand over acb; where analyticity is asked for and not certain, the result is not finite.

    `steady` keeps the parts that hold no bound letter, for all places of one integral.
    """

    def __init__(self, outer: RealBalls, bound: Mapping[str, Ball], analytic: bool, steady: Steady) -> None:
        self.outer = outer
        outer.work(len(steady))
        self.bound = bound
        self.analytic = analytic
        self.steady = steady

    def __call__(self, node: Formula) -> Ball:
        kept = self.steady.get(id(node))
        if kept is None:
            moves = bool(node.symbols() & self.bound.keys())
            kept = self.steady[id(node)] = node, None if moves else acb(self.outer(node))
        if kept[1] is not None:
            return kept[1]
        if isinstance(node, Symbol):
            return self.bound[node.name]
        parts = [self(child) for child in node.children()]
        if isinstance(node, Sum):
            return reduce(add, parts)
        if isinstance(node, Product):
            return reduce(mul, parts)
        if isinstance(node, Quotient):
            return parts[0] / parts[1]
        if isinstance(node, Negative):
            return -parts[0]
        if isinstance(node, Power):
            return self._power(node, parts)
        if isinstance(node, Call):
            return self._call(node.function, parts)
        raise Undefined("an integral within an integral")

    def _power(self, node: Power, parts: list[Ball]) -> Ball:
        if isinstance(node.exponent, Number) and node.exponent.value.denominator == 1:
            return parts[0] ** int(node.exponent.value)
        return (parts[1] * parts[0].log(analytic=self.analytic)).exp()

    def _call(self, function: str, parts: list[Ball]) -> Ball:
        z = parts[0]
        if function in ("sqrt", "log"):
            return getattr(z, function)(analytic=self.analytic)
        if function in ("sin", "cos", "tan", "exp"):
            return getattr(z, function)()
        if function == "ellipk":
            return z.elliptic_k() if z.real < 1 or not self.analytic else acb(arb.nan())
        if function in ELLIPTIC:
            raise Undefined("an elliptic function within an integral")
        if function == "abs":
            if z.real > 0:
                return z
            if z.real < 0:
                return -z
            return acb(arb.nan()) if self.analytic else acb(abs(z.real))
        if function in ("asin", "acos"):
            inside = abs(z.real) < 1
            return getattr(z, function)() if inside or not self.analytic else acb(arb.nan())
        if function == "atan":
            return z.atan() if abs(z.imag) < 1 or not self.analytic else acb(arb.nan())
        if parts[1].real > 0 and (not self.analytic or abs((z / parts[1]).imag) < 1):
            return (z / parts[1]).atan()
        return acb(arb.nan()) if self.analytic else acb(arb.atan2(z.real, parts[1].real))


def certified_integral(node: Integral, lower: Ball, upper: Ball, outer: RealBalls) -> Ball:
    """The integral between two ends, certified; a rough one where an end is rough."""
    steady = Steady()

    def integrand(z: Ball, analytic: bool) -> Ball:
        return ComplexBalls(outer, {node.variable: z}, analytic, steady)(node.integrand)

    sharp = all(end.is_exact() or end.rel_accuracy_bits() >= SHARP for end in (lower, upper))
    return integrated(integrand, acb(lower), acb(upper), work_limit() if sharp else ROUGHLY)
