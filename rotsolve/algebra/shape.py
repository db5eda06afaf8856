"""Shape: polynomials and fractions of a field written as a textbook would, e.g. `2 m g/(2 m + M)`.

Factors go: number, symbols in the given order, brackets, functions, roots. Roots are gathered into one: √a √b/√c is √(a b/c).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import isqrt

from rotsolve.algebra.field import Field, Poly, Ratio
from rotsolve.algebra.formula import (
    ONE,
    ZERO,
    Call,
    Constant,
    Formula,
    Number,
    Power,
    Product,
    Symbol,
    call,
    divide,
    multiply,
    negate,
    total,
)

HALF = Fraction(1, 2)
Rank = tuple[int, int, str, str]


@dataclass
class Parts:
    """A product being gathered: number · √root · gens^powers · sums^powers (half powers are roots)."""

    number: Fraction = Fraction(1)
    root: int = 1
    gens: dict[int, Fraction] = field(default_factory=dict)
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


def square_part(n: int) -> tuple[int, int]:
    """(s, r) with n = s² r; r is free of small squares."""
    outside, p = 1, 2
    while p * p <= n and p < 2000:
        while n % (p * p) == 0:
            n, outside = n // (p * p), outside * p
        p += 1 if p == 2 else 2
    whole = isqrt(n)
    return (outside * whole, 1) if whole * whole == n else (outside, n)


class Shaper:
    """Writes the polynomials of one field, symbols in the given order."""

    def __init__(self, ring: Field, order: Sequence[str] = ()) -> None:
        self.field = ring
        places = {name: k for k, name in enumerate(order)}
        self.ranks: list[Rank] = [self._rank(atom, places) for atom in ring.atoms]
        self.radicands = {i: square for i, _, square in ring.roots if self._is_sqrt(i)}

    def _is_sqrt(self, i: int) -> bool:
        atom = self.field.atoms[i]
        return isinstance(atom, Call) and atom.function == "sqrt"

    @staticmethod
    def _rank(atom: Formula, places: dict[str, int]) -> Rank:
        """Where an atom stands within a product: symbols, then functions, then roots."""
        if isinstance(atom, Constant):
            return (0, 0, "", "")
        if isinstance(atom, Symbol):
            return (1, places.get(atom.name, len(places)), atom.name.lower(), atom.name.swapcase())
        if isinstance(atom, Call):
            kind = {"sqrt": 5, "exp": 4}.get(atom.function, 3)
            names = sorted(atom.symbols(), key=lambda name: (places.get(name, len(places)), name))
            first = places.get(names[0], len(places)) if names else 0
            return (kind, first, " ".join(names), atom.function)
        return (2, 0, "", repr(atom))

    # polynomials

    def poly(self, poly: Poly) -> Formula:
        """An expanded polynomial, its terms in textbook order, a positive one first."""
        terms = sorted(self.field.terms(poly), key=lambda term: self._term_key(term[1]))
        if not terms:
            return ZERO
        first = next((k for k, (coefficient, _) in enumerate(terms) if coefficient > 0), 0)
        terms.insert(0, terms.pop(first))
        return total([self._monomial(*term) for term in terms])

    def _term_key(self, exponents: tuple[int, ...]) -> tuple[object, ...]:
        symbols = calls = 0
        ranks: list[Rank] = []
        for i, e in enumerate(exponents):
            if e:
                rank = self.ranks[i]
                ranks += [rank] * e
                if rank[0] == 1:
                    symbols += e
                elif rank[0] > 1:
                    calls += e
        return (symbols, calls, sorted(ranks))

    def leads_negative(self, poly: Poly) -> bool:
        """Whether the term that stands first by order has a minus."""
        return bool(min(self.field.terms(poly), key=lambda term: self._term_key(term[1]))[0] < 0)

    def _monomial(self, coefficient: int, exponents: tuple[int, ...]) -> Formula:
        parts = Parts(Fraction(coefficient))
        for i, e in enumerate(exponents):
            if e:
                self._put_gen(parts, i, Fraction(e))
        return self._build(parts)

    def ratio(self, ratio: Ratio) -> Formula:
        """A fraction in factors; common factors are cancelled first."""
        return self._build(self.parts(ratio))

    def parts(self, ratio: Ratio) -> Parts:
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
                parts.add_sum(poly, Fraction(e))
            else:
                self._put_gen(parts, i, Fraction(e))
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
                    parts.number *= (-1) ** k
        return factors

    # products

    def _put_gen(self, parts: Parts, i: int, power: Fraction) -> None:
        """Multiply by a generator; a root becomes a half power of what stands under it."""
        radicand = self.radicands.get(i)
        if radicand is None:
            parts.gens[i] = parts.gens.get(i, Fraction(0)) + power
            return
        if radicand.is_constant():
            n = int(radicand.leading_coefficient())
            if n < 0:
                parts.gens[i] = parts.gens.get(i, Fraction(0)) + power
                return
            parts.number *= Fraction(n) ** int(power // 2)
            parts.root *= n if power % 2 else 1
            return
        inner = self.field.generator_of(radicand)
        if inner is None:
            parts.add_sum(radicand, power / 2)
        else:
            self._put_gen(parts, inner, power / 2)

    def _build(self, parts: Parts) -> Formula:
        if not parts.number:
            return ZERO
        outer: list[tuple[Rank, Formula, int]] = []
        inner: list[tuple[Rank, Formula, int]] = []
        flip = 1
        items = [(self.ranks[i], self.field.atoms[i], e) for i, e in self._with_tan(parts, outer).items()]
        for poly, e in parts.sums:
            shown, sign = self._oriented(poly, e, flip * parts.number < 0)
            flip *= sign
            items.append(((2, 0, "", ""), shown, e))
        for rank, base, e in items:
            whole = int(e)
            if whole:
                outer.append((rank, base, whole))
            if e != whole:
                inner.append((rank, base, 1 if e > 0 else -1))
        return self._assemble(parts.number * flip, parts.root, self._with_exp(outer), inner)

    def _with_tan(self, parts: Parts, outer: list[tuple[Rank, Formula, int]]) -> dict[int, Fraction]:
        """The powers of generators with sin/cos taken out as tan."""
        powers = parts.gens
        for s, c, _ in self.field.pairs:
            k = min(int(powers.get(s, 0)), -int(powers.get(c, 0)))
            if k > 0:
                powers = {**powers, s: powers[s] - k, c: powers[c] + k}
                atom = self.field.atoms[s]
                assert isinstance(atom, Call)
                outer.append((self.ranks[s], Call("tan", atom.arguments), k))
        return powers

    @staticmethod
    def _with_exp(items: list[tuple[Rank, Formula, int]]) -> list[tuple[Rank, Formula, int]]:
        """All exponentials of a product as one."""
        found = [(rank, base, e) for rank, base, e in items if isinstance(base, Call) and base.function == "exp"]
        if not found or (len(found) == 1 and found[0][2] == 1):
            return items
        exponent = total([multiply(Number(Fraction(e)), base.children()[0]) for _, base, e in found])
        return [item for item in items if item not in found] + [(found[0][0], call("exp", exponent), 1)]

    def _oriented(self, poly: Poly, power: Fraction, negative: bool) -> tuple[Formula, int]:
        """A bracket with its sign chosen: leading term positive, but turned round to absorb a minus before the product."""
        if power.denominator != 1:
            return self._radicand(poly), 1
        odd = power % 2 == 1
        turn = self.leads_negative(poly)
        mixed = len({coefficient > 0 for coefficient, _ in self.field.terms(poly)}) == 2
        if odd and mixed and (negative != turn):
            turn = not turn
        return self.poly(-poly if turn else poly), -1 if turn and odd else 1

    def _radicand(self, poly: Poly) -> Formula:
        """What stands under a root, in factors where it has any."""
        content, factors = self.field.factor(poly)
        if len(factors) == 1 and factors[0][1] == 1 and content == 1:
            return self.poly(poly)
        parts = Parts(Fraction(content))
        for factor, e in factors:
            i = self.field.generator_of(factor)
            if i is None:
                parts.add_sum(factor, Fraction(e))
            else:
                parts.gens[i] = parts.gens.get(i, Fraction(0)) + e
        return self._build(parts)

    def _assemble(
        self,
        number: Fraction,
        root: int,
        outer: list[tuple[Rank, Formula, int]],
        inner: list[tuple[Rank, Formula, int]],
    ) -> Formula:
        sign, number = (-1, -number) if number < 0 else (1, number)
        number, under = _share_number(number, root, bool(inner))
        inside = _fraction(under, inner) if inner or under != 1 else ONE
        above = [(rank, base, e) for rank, base, e in outer if e > 0]
        below = [(rank, base, -e) for rank, base, e in outer if e < 0]
        if inner and all(e < 0 for _, _, e in inner) and under == 1:
            below.append(((5, 0, "", ""), call("sqrt", _fraction(under, [(r, b, -e) for r, b, e in inner])), 1))
        elif inside != ONE:
            above.append(((5, 0, "", ""), call("sqrt", inside), 1))
        result = _fraction(number, above + [(r, b, -e) for r, b, e in below])
        return negate(result) if sign < 0 else result


def _share_number(number: Fraction, root: int, symbols: bool) -> tuple[Fraction, Fraction]:
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


def _fraction(number: Fraction, items: list[tuple[Rank, Formula, int]]) -> Formula:
    """number · base^power · …, negative powers below the line; ½ goes in front where nothing else is below."""
    above = _product([item for item in items if item[2] > 0])
    below = _product([(rank, base, -e) for rank, base, e in items if e < 0])
    p, q = number.numerator, number.denominator
    if below == ONE and above != ONE and p == 1:
        return _times(Number(number), above)
    return divide(_times(Number(Fraction(p)), above), _times(Number(Fraction(q)), below))


def _times(number: Number, rest: Formula) -> Formula:
    """number · rest, a bracket kept as a bracket."""
    if number == ONE or rest == ONE:
        return multiply(number, rest)
    return Product((number, *(rest.factors if isinstance(rest, Product) else (rest,))))


def _product(items: list[tuple[Rank, Formula, int]]) -> Formula:
    factors = tuple(
        base if e == 1 else Power(base, Number(Fraction(e)))
        for _, base, e in sorted(items, key=lambda item: item[0])
    )
    if not factors:
        return ONE
    return factors[0] if len(factors) == 1 else Product(factors)
