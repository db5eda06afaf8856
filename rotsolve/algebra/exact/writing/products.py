"""Products: number, roots and factors put together to one written product or fraction."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt
from operator import itemgetter

from rotsolve.algebra.exact.writing.order import Rank
from rotsolve.algebra.formula import (
    ONE,
    PI,
    Call,
    Formula,
    Number,
    Power,
    Product,
    Sum,
    call,
    divide,
    multiply,
    negate,
    total,
)
from rotsolve.algebra.notation.letters import GLYPHS

Item = tuple[Rank, Formula, int]  # base ^ exponent and where it stands
_RANK = itemgetter(0)


def square_part(n: int) -> tuple[int, int]:
    """(s, r) with n = s² r; r is free of small squares."""
    outside, p = 1, 2
    while p * p <= n and p < 2000:
        while n % (p * p) == 0:
            n, outside = n // (p * p), outside * p
        p += 1 if p == 2 else 2
    whole = isqrt(n)
    return (outside * whole, 1) if whole * whole == n else (outside, n)


def share_number(number: Fraction, root: int, symbols: bool) -> tuple[Fraction, Fraction]:
    """number · √root split into what stands before the root and what stands under it."""
    if root != 1 or symbols:
        out, root = square_part(root)
        number *= out
    if not symbols:
        return number, Fraction(root)
    if number.denominator == 1:
        return number, Fraction(root)
    under = Fraction(root, number.denominator**2)
    out, rest = square_part(under.denominator)
    return Fraction(number.numerator, out), Fraction(under.numerator, rest)


def assembled(number: Fraction, root: int, outer: list[Item], inner: list[Item]) -> Formula:
    """number · √root · outer · √inner."""
    sign, number = (-1, -number) if number < 0 else (1, number)
    number, under = share_number(number, root, bool(inner))
    turns = next((e for _, base, e in outer if base == PI), 0)
    if inner and number == 1 and under != 1 and abs(turns) == 1:  # a period is 2 π √(…), a frequency √(…)/(2 π)
        number, under = number * Fraction(2) ** turns, under / Fraction(4) ** turns
    inside = written_fraction(under, inner, rooted=True) if inner or under != 1 else ONE
    above = [(rank, base, e) for rank, base, e in outer if e > 0]
    below = [(rank, base, -e) for rank, base, e in outer if e < 0]
    if inner and all(e < 0 for _, _, e in inner) and under == 1:
        upright = written_fraction(under, [(r, b, -e) for r, b, e in inner], rooted=True)
        below.append(((5, 0, "", ""), call("sqrt", upright), 1))
    elif inside != ONE:
        above.append(((5 if inner else -1, 0, "", ""), call("sqrt", inside), 1))
    result = written_fraction(number, above + [(r, b, -e) for r, b, e in below])
    return negate(result) if sign < 0 else result


def written_term(number: int, items: list[Item]) -> Formula:
    """A whole number times powers of letters."""
    whole = Number(Fraction(number)) if number != 1 else ONE
    return _times(whole, _product(items))


def written_fraction(number: Fraction, items: list[Item], *, rooted: bool = False) -> Formula:
    """number · base^power · …, negative powers below the line; ½, ⅖, 1/12 in front if nothing else is below (no root)."""
    above = _product([item for item in items if item[2] > 0])
    below = _product([(rank, base, -e) for rank, base, e in items if e < 0])
    p, q = number.numerator, number.denominator
    leads = not rooted and (p == 1 or number in GLYPHS)
    if below == ONE and above != ONE and leads and (isinstance(above, Sum) or above.symbols()):
        return _times(Number(number), above)
    return divide(_times(Number(Fraction(p)), above), _times(Number(Fraction(q)), below))


def _times(number: Number, rest: Formula) -> Formula:
    """number · rest, a bracket kept as a bracket."""
    if number.value == 1 or isinstance(rest, Number):
        return multiply(number, rest)
    return Product((number, *(rest.factors if isinstance(rest, Product) else (rest,))))


def _product(items: list[Item]) -> Formula:
    if len(items) > 1:
        items = sorted(items, key=_RANK)
    factors = tuple([base if e == 1 else Power(base, Number(Fraction(e))) for _, base, e in items])
    if not factors:
        return ONE
    return factors[0] if len(factors) == 1 else Product(factors)


def one_exponential(items: list[Item]) -> list[Item]:
    """All exponentials of a product as one."""
    found = [(rank, base, e) for rank, base, e in items if isinstance(base, Call) and base.function == "exp"]
    if not found or (len(found) == 1 and found[0][2] == 1):
        return items
    exponent = total([multiply(Number(Fraction(e)), base.children()[0]) for _, base, e in found])
    return [item for item in items if item not in found] + [(found[0][0], call("exp", exponent), 1)]
