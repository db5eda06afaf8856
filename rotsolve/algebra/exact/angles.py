"""Angles: arguments of sin and cos as rational combinations of terms, and expansions by angle addition."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from fractions import Fraction
from math import comb
from typing import TypeVar

from rotsolve.algebra.exact.field import Field
from rotsolve.algebra.exact.shape import Shaper
from rotsolve.algebra.formula import (
    ONE,
    PI,
    ZERO,
    Call,
    Constant,
    Formula,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    Symbol,
    add,
    call,
    divide,
    multiply,
    negate,
    power,
    total,
)

Vector = dict[Formula, Fraction]  # term -> coefficient; PI stands for pure multiples of π
SinCos = tuple[Formula, Formula]
Held = TypeVar("Held")


def linear(node: Formula, order: Sequence[str]) -> Vector:
    """The formula as a rational combination of terms without number in front."""
    result: Vector = {}
    _collect(node, Fraction(1), result, order)
    return {term: value for term, value in result.items() if value}


def _collect(node: Formula, scale: Fraction, into: Vector, order: Sequence[str]) -> None:
    if isinstance(node, Number):
        into[ONE] = into.get(ONE, Fraction(0)) + scale * node.value
    elif isinstance(node, (Symbol, Constant, Call)):
        into[node] = into.get(node, Fraction(0)) + scale
    elif isinstance(node, Negative):
        _collect(node.operand, -scale, into, order)
    elif isinstance(node, Sum):
        for term in node.terms:
            _collect(term, scale, into, order)
    elif isinstance(node, Product) and len(node.factors) == 2 and isinstance(node.factors[0], Number):
        _collect(node.factors[1], scale * node.factors[0].value, into, order)
    elif isinstance(node, Quotient) and isinstance(node.denominator, Number) and node.denominator.value:
        _collect(node.numerator, scale / node.denominator.value, into, order)
    else:
        _collect_fraction(node, scale, into, order)


def _collect_fraction(node: Formula, scale: Fraction, into: Vector, order: Sequence[str]) -> None:
    """The general case: a fraction over a single term is split, any other is one term."""
    ring = Field([node])
    num, den = ring.convert(node)
    num, den = ring.cancel((ring.reduce(num), ring.reduce(den)))
    shaper = Shaper(ring, order)
    if len(den) == 1:
        below = int(den.leading_coefficient())
        base = den / below
        pieces = [(c, ring.poly({e: 1})) for e, c in ring.terms(num).items()]
    else:
        content, primitive = num.primitive()
        if primitive.leading_coefficient() < 0:
            content, primitive = -content, -primitive
        below, base, pieces = 1, den, [(int(content), primitive)]
    for coefficient, piece in pieces:
        term = shaper.ratio(ring.cancel((piece, base)))
        into[term] = into.get(term, Fraction(0)) + scale * Fraction(coefficient, below)


def combination(vector: Vector) -> Formula:
    """A vector written out, e.g. θ/2 + π/6."""
    terms = []
    for term, value in vector.items():
        sign, value = (-1, -value) if value < 0 else (1, value)
        top = multiply(Number(Fraction(value.numerator)), term)
        shown = divide(top, Number(Fraction(value.denominator)))
        terms.append(negate(shown) if sign < 0 else shown)
    return total(terms)


def rank(vectors: Sequence[Vector]) -> int:
    """The number of linearly independent vectors, over the rationals."""
    rows = [dict(vector) for vector in vectors]
    count = 0
    while rows:
        row = rows.pop()
        if not row:
            continue
        count += 1
        pivot = next(iter(row))
        rows = [_without(other, row, pivot) if pivot in other else other for other in rows]
    return count


def _without(row: Vector, pivot_row: Vector, pivot: Formula) -> Vector:
    scale = row[pivot] / pivot_row[pivot]
    keys = {**row, **pivot_row}
    zero = Fraction(0)
    result = {key: row.get(key, zero) - scale * pivot_row.get(key, zero) for key in keys}
    return {key: value for key, value in result.items() if value}


def coupled(items: Iterable[Held], names: Callable[[Held], Collection[object]]) -> list[list[Held]]:
    """The items in groups that share none of their names."""
    groups: list[tuple[set[object], list[Held]]] = []
    for item in items:
        own, members = set(names(item)), [item]
        for group in [group for group in groups if group[0] & own]:
            groups.remove(group)
            own |= group[0]
            members = [*group[1], *members]
        groups.append((own, members))
    return [members for _, members in groups]


def add_angles(first: SinCos, second: SinCos) -> SinCos:
    """sin and cos of a sum."""
    (s, c), (t, d) = first, second
    return add(multiply(s, d), multiply(c, t)), add(multiply(c, d), negate(multiply(s, t)))


def multiple(pair: SinCos, n: int) -> SinCos:
    """sin and cos of n times an angle, from (cos + i sin)ⁿ."""
    s, c = pair
    if n < 0:
        s, n = negate(s), -n
    if n == 1:
        return s, c
    parts: list[list[Formula]] = [[], []]
    for k in range(n + 1):
        sign = -1 if k % 4 >= 2 else 1
        parts[k % 2].append(multiply(Number(Fraction(sign * comb(n, k))), multiply(power(c, n - k), power(s, k))))
    return total(parts[1]), total(parts[0])


def _sum_of_roots(*terms: tuple[int, int, int]) -> Formula:
    """Σ p √n / q for (p, n, q) with n among 1, 2, 3, 6."""
    found: Formula = ZERO
    for p, n, q in terms:
        shown: Formula = Number(Fraction(p, q))
        for prime in (2, 3):
            if n % prime == 0:
                shown = multiply(shown, call("sqrt", Number(Fraction(prime))))
        found = add(found, shown)
    return found


_TWELFTHS: dict[int, SinCos] = {  # multiples of π/12 up to π/4
    0: (ZERO, ONE),
    1: (_sum_of_roots((1, 6, 4), (-1, 2, 4)), _sum_of_roots((1, 6, 4), (1, 2, 4))),
    2: (_sum_of_roots((1, 1, 2)), _sum_of_roots((1, 3, 2))),
    3: (_sum_of_roots((1, 2, 2)), _sum_of_roots((1, 2, 2))),
}


def exact_angle(turns: Fraction) -> SinCos | None:
    """sin and cos of turns · π, for multiples of π/12 between −π/4 and π/4."""
    twelfths = turns * 12
    found = _TWELFTHS.get(abs(int(twelfths))) if twelfths.denominator == 1 else None
    if found is None:
        return None
    return (negate(found[0]), found[1]) if turns < 0 else found


def turn(pair: SinCos, quarters: int) -> SinCos:
    """sin and cos after a shift by quarters · π/2."""
    s, c = pair
    return ((s, c), (c, negate(s)), (negate(s), negate(c)), (negate(c), s))[quarters % 4]


def split_pi(vector: Vector) -> tuple[Vector, Fraction, int]:
    """The vector without π, the rest of its multiple of π between −1/4 and 1/4, and the quarter turns taken off."""
    rest = {term: value for term, value in vector.items() if term != PI}
    turns = vector.get(PI, Fraction(0))
    quarters = round(2 * turns)
    return rest, turns - Fraction(quarters, 2), quarters
