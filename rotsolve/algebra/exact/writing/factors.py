"""Factors: what a fraction is a product of: a number, generators of the field, brackets, and one root for all that is under roots."""

from __future__ import annotations

from collections.abc import Collection
from fractions import Fraction

from msgspec import Struct, field

from rotsolve.algebra.exact.field import Field, Poly, Ratio
from rotsolve.algebra.exact.signs import Signs
from rotsolve.algebra.formula import Call

Exponent = int | Fraction  # a fraction where it is a root


class Parts(Struct):
    """A product being gathered: number · √root · gens^powers · sums^powers (half powers are roots)."""

    number: Fraction = Fraction(1)
    root: int = 1
    gens: dict[int, Exponent] = field(default_factory=dict)
    unsure: int | None = None  # the root of unknown sign that has joined
    sums: list[tuple[Poly, Exponent]] = field(default_factory=list)

    def add_sum(self, poly: Poly, power: Exponent) -> None:
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


class Factors:
    """Takes the fractions of one field into factors; only names in `positive` are taken to be positive."""

    def __init__(self, ring: Field, positive: Collection[str] = ()) -> None:
        self.field = ring
        self.radicands = {i: square for i, _, square in ring.roots if self._is_sqrt(i)}
        signs = Signs(ring, positive)
        self.unsure = {i for i, square in self.radicands.items() if not signs.nonnegative(square)}

    def _is_sqrt(self, i: int) -> bool:
        atom = self.field.atoms[i]
        return isinstance(atom, Call) and atom.function == "sqrt"

    def of_ratio(self, ratio: Ratio) -> Parts:
        """The factors of a fraction, gathered."""
        num, den = ratio
        if not len(num):
            return Parts(Fraction(0))
        top, above = self.field.factor(num)
        bottom, below = self.field.factor(den)
        parts = Parts(Fraction(top, bottom))
        factors = [(p, e) for p, e in above] + [(p, -e) for p, e in below]
        for poly, e in self._squares_of_trig(factors, parts):
            i = self.field.generator_of(poly)
            if i is None:
                parts.add_sum(poly, e)
            else:
                self.put(parts, i, e)
        return parts

    def _squares_of_trig(self, factors: list[tuple[Poly, int]], parts: Parts) -> list[tuple[Poly, int]]:
        """(1 − sin)(1 + sin) as cos², and the like for cos."""
        if not self.field.pairs or len(factors) < 2:
            return factors
        gens = self.field.gens
        for s, c, _ in self.field.pairs:
            for a, b in ((s, c), (c, s)):
                plus, minus = gens[a] + 1, gens[a] - 1
                powers = [next((e for p, e in factors if p == q), 0) for q in (plus, minus)]
                k = min(powers, key=abs) if powers[0] * powers[1] > 0 else 0
                if k:
                    factors = [(p, e - k if p in (plus, minus) else e) for p, e in factors] + [(gens[b], 2 * k)]
                    factors = [(p, e) for p, e in factors if e]
                    parts.number *= -1 if k % 2 else 1
        return factors

    def of_term(self, coefficient: int, exponents: tuple[int, ...], below: int = 1) -> Parts:
        """The factors of a term (over a number)."""
        parts = Parts(Fraction(coefficient, below))
        for i, e in enumerate(exponents):
            if e:
                self.put(parts, i, e)
        return parts

    def put(self, parts: Parts, i: int, power: Exponent) -> None:
        """Multiply by a generator; a root becomes a half power of what stands under it."""
        radicand = self.radicands.get(i)
        if i in self.unsure:  # of these only one may join the common root: √p √q is √(p q) only for p, q ≥ 0
            parts.unsure = i if parts.unsure is None else parts.unsure
        if radicand is None or power.denominator != 1 or (i in self.unsure and parts.unsure != i):  # √√x stays as it is
            parts.gens[i] = parts.gens.get(i, 0) + power
            return
        if radicand.is_constant():
            n = int(radicand.leading_coefficient())
            if n < 0:
                parts.gens[i] = parts.gens.get(i, 0) + power
                return
            parts.number *= Fraction(n) ** int(power // 2)
            parts.root *= n if power % 2 else 1
            return
        inner = self.field.generator_of(radicand)
        if inner is None:
            parts.add_sum(radicand, Fraction(power) / 2)
        else:
            self.put(parts, inner, Fraction(power) / 2)
