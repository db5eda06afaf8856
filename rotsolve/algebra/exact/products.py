"""Products: the factors of a product while it is gathered, and how number, roots and factors are put together."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from math import isqrt

from rotsolve.algebra.exact.field import Poly
from rotsolve.algebra.formula import (
    ONE,
    Formula,
    Number,
    Power,
    Product,
    Sum,
    divide,
    multiply,
)
from rotsolve.algebra.notation.letters import GLYPHS

Rank = tuple[int, int, str, str]


@dataclass
class Parts:
    """A product being gathered: number · √root · gens^powers · sums^powers (half powers are roots)."""

    number: Fraction = Fraction(1)
    root: int = 1
    gens: dict[int, Fraction] = field(default_factory=dict)
    unsure: int | None = None  # the root of unknown sign that has joined
    sums: list[tuple[Poly, Fraction]] = field(default_factory=list)

    def add_sum(self, poly: Poly, power: Fraction) -> None:
        for k, (other, old) in enumerate(self.sums):
            if other == poly or other == -poly:
                if other != poly and power % 2 == 1:
                    self.number = -self.number
                if other == poly or power.denominator == 1:
                    self.sums[k] = (other, old + power)
                    return
        self.sums.append((poly, power))

    def unite_squares(self) -> None:
        """(a + b) (a − b) as a² − b²; but a⁴ − b⁴ stays in factors."""
        for k, (first, power) in enumerate(self.sums):
            for other, e in self.sums[k + 1 :]:
                if e == power and _conjugate(first, other):
                    rest = [item for item in self.sums if item[0] not in (first, other)]
                    self.sums = [*rest, (first * other, power)]
                    return self.unite_squares()
        return None


def _conjugate(first: Poly, other: Poly) -> bool:
    """Whether two brackets are a + b and a − b, one of a and b no square itself."""
    if len(first) != 2 or len(other) != 2:
        return False
    halves = first + other, first - other
    return all(len(half) == 1 for half in halves) and any(e % 2 for half in halves for e in half.monomial(0))


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


def written_fraction(number: Fraction, items: list[tuple[Rank, Formula, int]], *, rooted: bool = False) -> Formula:
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
    if number == ONE or rest == ONE:
        return multiply(number, rest)
    return Product((number, *(rest.factors if isinstance(rest, Product) else (rest,))))


def _product(items: list[tuple[Rank, Formula, int]]) -> Formula:
    factors = tuple(
        base if e == 1 else Power(base, Number(Fraction(e))) for _, base, e in sorted(items, key=lambda item: item[0])
    )
    if not factors:
        return ONE
    return factors[0] if len(factors) == 1 else Product(factors)
