"""Turning points: certified integrals of 1/√r whose radicand vanishes at an end, as the time up to a point of rest.

With x = e + d u², e the end and d the way to the other, r(x) = d u² q(x) and dx/√r = 2 d du/√(d q), which is smooth. The quotient
q = r/(x − e) is enclosed by the derivative of r between x and e (mean value theorem), where dividing would lose all digits.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any, Protocol

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.flints import acb, arb, context
from rotsolve.algebra.formula import Call, Formula, Integral, Number, Symbol

HALF = Number(Fraction(1, 2))
Ball = Any  # flint's arb or acb


class BallOf(Protocol):
    """What tells the ball of a formula, whether one vanishes exactly, and the ball over a complex one of one letter."""

    def __call__(self, node: Formula) -> Ball: ...
    def vanishes(self, value: Formula) -> bool: ...
    def over(self, letter: str, place: Ball, node: Formula) -> Ball: ...


def radicand(node: Integral) -> Formula | None:
    """r where the integrand is ±1/√r; None for any other."""
    inside = [part for part in node.integrand.walk(Call) if isinstance(part, Call) and node.variable in part.symbols()]
    if not any(part.function == "sqrt" for part in inside):
        return None
    found = simplify(1 / (node.integrand * node.integrand))
    roots = (part for part in found.walk("sqrt") if isinstance(part, Call) and part.function == "sqrt")
    return None if any(node.variable in part.symbols() for part in roots) else found


def in_half_angles(inside: Formula, variable: str) -> Formula:
    """The formula with 1 − 2 sin²(x/2) for cos x: of a small swing, cos x − 1 + ½ φ² would be as wide as x, not as its square."""
    calls = {part for part in inside.walk(Call) if isinstance(part, Call) and variable in part.symbols()}
    cosine = Call("cos", (Symbol(variable),))
    if calls != {cosine}:
        return inside
    half = Symbol(f"{variable}/2")
    known = simplify(inside.transform(lambda node: 1 - 2 * half * half if node == cosine else node))
    return known.substitute({half.name: Call("sin", (HALF * Symbol(variable),))})


def integral_to_rest(node: Integral, balls: BallOf) -> Ball | None:
    """The integral where its radicand vanishes exactly at one end or both; None where it does at neither."""
    inside = radicand(node)
    if inside is None:
        return None
    ends = (node.lower, node.upper)
    rest = [balls.vanishes(inside.substitute({node.variable: end})) for end in ends]
    if not any(rest):
        return None
    middle = HALF * (node.lower + node.upper)
    between = balls(node.integrand.substitute({node.variable: middle}))
    if not (between > 0 or between < 0):
        return arb.nan()  # the precision does not tell its sign yet
    sign = 1 if between > 0 else -1
    inside = in_half_angles(inside, node.variable)
    if all(rest):
        first, last = (_from_end(node, inside, end, middle, balls) for end in ends)
        return sign * (first - last)
    if rest[0]:
        return sign * _from_end(node, inside, *ends, balls)
    return -sign * _from_end(node, inside, ends[1], ends[0], balls)


def _from_end(node: Integral, inside: Formula, end: Formula, other: Formula, balls: BallOf) -> Ball:
    """∫ dx/√r from the end where r vanishes to another place."""
    slope = differentiate(inside, node.variable)
    start, way = acb(balls(end)), acb(balls(other) - balls(end))

    def integrand(u: Ball, analytic: bool) -> Ball:
        x = start + way * u * u
        between = acb(x.real.union(start.real), x.imag.union(start.imag))
        quotient = balls.over(node.variable, between, slope)
        if not (x - start).contains(0):
            divided = balls.over(node.variable, x, inside) / (x - start)
            if divided.rad() < quotient.rad():
                quotient = divided
        return 2 * way / (way * quotient).sqrt(analytic=analytic)

    return integrated(integrand, acb(0), acb(1), work_limit())


def integrated(integrand: Callable[[Ball, bool], Ball], lower: Ball, upper: Ball, limit: int) -> Ball:
    """The certified integral of a function of a complex ball, which is asked no more than so often; raises what that raises first."""
    raised: list[Exception] = []

    def guarded(place: Ball, analytic: bool) -> Ball:  # the integration goes on after an exception, and loses it
        if not raised:
            try:
                return integrand(place, analytic)
            except Exception as error:
                raised.append(error)
        return acb(arb.nan())

    found = acb.integral(guarded, lower, upper, eval_limit=limit).real
    if raised:
        raise raised[0]
    return found


def work_limit() -> int:
    """How often an integrand is evaluated at most: many times what a smooth one takes; then the ball stays wide, and is said to be so."""
    return 2000 + 40 * int(context.prec)
