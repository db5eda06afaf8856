"""Roots: closed forms for quadratic equations and for equations in the sine and cosine of one angle."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from math import isqrt

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.exact.field import Poly, PolynomialSigns
from rotsolve.algebra.exact.linear import solve_linear
from rotsolve.algebra.exact.normal import Fractions, concerning, expanded, simplify
from rotsolve.algebra.formula import (
    PI,
    ZERO,
    Call,
    Formula,
    Quotient,
    Symbol,
    add,
    call,
    divide,
    multiply,
    negate,
    sqrt,
)


def solve_polynomial(
    f: Formula, unknown: str, *, order: Sequence[str] = (), positive: Collection[str] = ()
) -> list[Formula]:
    """The roots of f = 0 as a linear or quadratic equation in the unknown, or one with such factors only (of the fourth
    degree too, in the square of the unknown); else empty."""
    problem, parts = expanded(f, unknown, *concerning(f, order, positive, unknown))
    if parts is None or len(parts) < 2:
        return []
    if len(parts) <= 3:
        return _quadratic_roots(problem, parts, order, positive)
    place = problem.field.index[Symbol(unknown)]
    _, factors = problem.field.factor(problem.numerator())
    split = [problem.field.coefficients(factor, place) for factor, _ in factors]
    found: list[Formula] = []
    for factor in split:
        if len(factor) == 5 and not any(len(part) for part in factor[1::2]):
            squares = _quadratic_roots(problem, factor[::2], order, positive)
            roots = [simplify(sqrt(square), order=order, positive=positive) for square in squares]
            found += [root for size in roots for root in (size, negate(size))]
        elif len(factor) > 3:
            return []
        elif len(factor) > 1:
            found += _quadratic_roots(problem, factor, order, positive)
    return found


def _quadratic_roots(
    problem: Fractions, parts: Sequence[Poly], order: Sequence[str], positive: Collection[str]
) -> list[Formula]:
    """The roots of c₀ + c₁ x + c₂ x²."""
    if len(parts) == 2:
        return [problem.shortest((-parts[0], parts[1]))]
    c, b, a = parts
    ring = problem.field
    if not len(b):
        square = problem.shortest((-c, a))
        if square == ZERO:
            return [ZERO]
        root = simplify(sqrt(square), order=order, positive=positive)
        return [root, negate(root)]
    if not len(c):
        return [ZERO, problem.shortest((-b, a))]
    inside = ring.reduce(b * b - 4 * a * c)
    if not len(inside):
        return [problem.shortest((-b, 2 * a))]
    exact = _square_root(problem, inside)
    if exact is not None:
        return [problem.shortest((-b + exact, 2 * a)), problem.shortest((-b - exact, 2 * a))]
    root = sqrt(problem.shaper.ratio((inside, ring.one)))
    top, bottom = problem.shaper.poly(-b), problem.shaper.poly(2 * a)
    values = [divide(add(top, side), bottom) for side in (root, negate(root))]
    return [simplify(value, order=order, positive=positive) for value in values]


def _square_root(problem: Fractions, poly: Poly) -> Poly | None:
    """The root of a polynomial that is a perfect square, None of any other."""
    content, factors = problem.field.factor(poly)
    if content < 0 or isqrt(content) ** 2 != content or any(e % 2 for _, e in factors):
        return None
    result = problem.field.one * isqrt(content)
    for factor, e in factors:
        result = result * factor ** (e // 2)
    return result


def solve_trig(f: Formula, unknown: str, *, order: Sequence[str] = (), positive: Collection[str] = ()) -> list[Formula]:
    """Roots of f = 0 where the unknown stands only in sin and cos of one linear argument; empty where it does not.

    Handles A sin + B cos + C = 0, quadratics in the sine alone or the cosine alone, and products of these.
    """
    problem = Fractions([f], order, positive)
    ring = problem.field
    num = problem.numerator()
    degrees = num.degrees()
    inside = [i for i in range(len(ring.atoms)) if degrees[i] and ring.mentions(i, unknown)]
    at = ring.index.get(Symbol(unknown))
    if not inside or (at is not None and degrees[at]):
        return []
    arguments = {ring.atoms[i].children() for i in inside}
    pair = next((p for p in ring.pairs if p[0] in inside or p[1] in inside), None)
    if len(arguments) != 1 or pair is None or not set(inside) <= set(pair[:2]):
        return []
    atom = ring.atoms[pair[0]]
    assert isinstance(atom, Call)
    found = _angle_roots(problem, num, pair, order, positive)
    return [
        simplify(shown, order=order, positive=positive)
        for value in found or ()
        for shown in _unwrap(atom.arguments[0], unknown, value)
    ]


def _unwrap(argument: Formula, unknown: str, value: Formula) -> list[Formula]:
    """The unknown from argument = value."""
    if argument == Symbol(unknown):
        return [value]
    return solve_polynomial(add(argument, negate(value)), unknown)[:1]


def _angle_roots(
    problem: Fractions, num: Poly, pair: tuple[int, int, Poly], order: Sequence[str], positive: Collection[str]
) -> list[Formula] | None:
    """All angles; None where one of the factors has no closed form, since its roots may be those that are meant."""
    ring = problem.field
    s, c, _ = pair
    degrees = num.degrees()
    if degrees[c] and degrees[s]:
        turned = ring.reduce_to_cos(num, pair)
        num = turned if not turned.degrees()[s] else num
        degrees = num.degrees()
    if degrees[c] and degrees[s]:  # sin x (A cos x + B) = 0: each factor by itself
        factors = [factor for factor, _ in ring.factor(num)[1] if factor.degrees()[s] or factor.degrees()[c]]
        if len(factors) > 1:
            found = [_angle_roots(problem, factor, pair, order, positive) for factor in factors]
            return None if None in found else [root for roots in found for root in roots or ()]
    for i, name in ((s, "asin"), (c, "acos")):
        if not degrees[s + c - i] and degrees[i] <= 2:
            values = _quadratic_roots(problem, ring.coefficients(num, i), order, positive)
            return [root for value in values for root in _inverse(name, value)]
    if degrees[c] > 1 or degrees[s] > 1:
        return None
    free, slope = ring.coefficients(num, c)
    if slope.degrees()[s]:
        return None
    lines = ring.coefficients(free, s)
    a, k = lines[1], -lines[0]
    if not len(k):
        root = call("atan", problem.shortest((-slope, a)))
        return [root, add(root, PI)]
    # with the cosine's coefficient positive an angle from 0 to 90° is one of the two, and not a turn off
    if PolynomialSigns(ring, positive).nonnegative(-slope):
        a, slope, k = -a, -slope, -k
    shown_a, shown_b = problem.shaper.ratio((a, ring.one)), problem.shaper.ratio((slope, ring.one))
    radius = sqrt(add(multiply(shown_a, shown_a), multiply(shown_b, shown_b)))
    phase = call("atan2", shown_a, shown_b)
    swing = call("acos", divide(problem.shaper.ratio((k, ring.one)), radius))
    return [add(phase, swing), add(phase, negate(swing))]


def _inverse(name: str, value: Formula) -> list[Formula]:
    """Both angles of one turn with this sine or cosine; none where a plain number is beyond 1."""
    if not value.symbols() and abs(evaluate(value, {}).ball) > 1:
        return []
    root = call(name, value)
    return [root, add(PI, negate(root)) if name == "asin" else negate(root)]


INVERSE = {"log": "exp", "exp": "log", "asin": "sin", "acos": "cos", "atan": "tan"}
STAND_IN = "function value"


def solve_unwrapped(
    f: Formula, unknown: str, *, order: Sequence[str] = (), positive: Collection[str] = ()
) -> list[Formula]:
    """The roots of f = 0 where the unknown occurs within one function only, and linearly or as a square within that."""
    calls = {node for node in f.walk(*INVERSE, "abs") if isinstance(node, Call) and unknown in node.symbols()}
    wraps = {node for node in calls if node.function in INVERSE or node.function == "abs"}
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
    if wrap.function == "abs":  # |x| = c is x = c or x = −c
        sides = (
            solve_polynomial(add(argument, side), unknown, order=order, positive=positive)
            for side in (negate(value), value)
        )
        return [root for roots in sides for root in roots]
    if wrap.function == "log" and isinstance(argument, Quotient) and unknown not in argument.numerator.symbols():
        argument, value = argument.denominator / argument.numerator, negate(value)  # so that 1 − exp(−y) comes out
    inner = simplify(call(INVERSE[wrap.function], value), order=order, positive=positive)
    gap = add(argument, negate(inner))
    roots = solve_polynomial(gap, unknown, order=order, positive=positive)
    return roots or solve_unwrapped(gap, unknown, order=order, positive=positive)


def solve_under_root(
    f: Formula, unknown: str, *, order: Sequence[str] = (), positive: Collection[str] = ()
) -> list[Formula]:
    """The roots of f = 0 where the unknown stands under one square root only: √g = v gives g = v², to be tried, since v may be negative."""
    whole = simplify(f, order=order, positive=positive)
    nodes = {node for node in whole.walk(Call) if isinstance(node, Call) and unknown in node.symbols()}
    if len(nodes) != 1 or (node := nodes.pop()).function != "sqrt":
        return []
    opened = whole.transform(lambda part: Symbol(STAND_IN) if part == node else part, "sqrt")
    value = None if unknown in opened.symbols() else solve_linear(opened, STAND_IN, order=order, positive=positive)
    if value is None:
        return []
    return solve_polynomial(node.arguments[0] - value**2, unknown, order=order, positive=positive)
