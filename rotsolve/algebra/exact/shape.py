"""Shape: polynomials and fractions of a field written as a textbook would, e.g. `2 m g/(2 m + M)`.

Factors go: number, root of a number, symbols in the given order, brackets, functions, roots.
The last are gathered into one: √a √b/√c is √(a b/c).
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction
from functools import cached_property, partial
from math import prod
from typing import TYPE_CHECKING

from rotsolve.algebra.effort import exert
from rotsolve.algebra.exact.factors import Exponent, Factorization, Parts, absorb_sizes, negative, singles, taken_apart
from rotsolve.algebra.exact.field import Field, Poly, Ratio, Terms, generator_of
from rotsolve.algebra.exact.order import (
    FEWEST,
    MOST,
    TRIED,
    Item,
    Order,
    Rank,
    assembled,
    late,
    length,
    one_exponential,
    written_fraction,
    written_term,
)
from rotsolve.algebra.formula import PI, ZERO, Call, Formula, Negative, Number, Product, Sum, Symbol, negate, total
from rotsolve.algebra.notation.letters import GLYPHS

if TYPE_CHECKING:
    from rotsolve.algebra.exact.grouping import FactoredGroup, Grouping

TERMS_A_STEP = 4  # that are written
GATHERED = ("sqrt", "exp")  # functions of which a product has one at most


class Shaper:
    """Writes the polynomials of one field, symbols in the given order."""

    def __init__(self, ring: Field, order: Sequence[str] = (), positive: Collection[str] = ()) -> None:
        self.field = ring
        self.factors = Factorization(ring, positive)
        self.order = Order(ring, order, self.factors.radicands)
        self.written: dict[object, Formula] = {}  # long sums, by depth and terms
        self.depth = 0  # how many long sums stand round the one that is written

    @cached_property
    def grouping(self) -> Grouping:
        """Made where a sum is long."""
        from rotsolve.algebra.exact.grouping import Grouping

        return Grouping(self.field, self.order)

    # polynomials

    def poly(self, poly: Poly) -> Formula:
        """An expanded polynomial as a textbook writes it."""
        return self.sum(self.field.terms(poly))

    def sum(self, terms: Terms, below: int = 1) -> Formula:
        """A sum (over a number), its terms in textbook order, a positive one first, roots last; a long one in groups."""
        if not terms:
            return ZERO
        if below != 1 or not FEWEST <= len(terms) <= MOST or self.depth == len(TRIED):
            return self._plain(terms, below)
        key = (self.depth, frozenset(terms.items()))
        if key not in self.written:
            pieces = self.grouping.groups(terms, self.depth)
            self.depth += 1
            shown = [self._in_factors(piece) for piece in pieces]
            self.depth -= 1
            self.written[key] = total(sorted(shown, key=late)) if shown else self._plain(terms, below)
        return self.written[key]

    def _plain(self, terms: Terms, below: int) -> Formula:
        """A sum (over a number) term by term."""
        exert(len(terms) // TERMS_A_STEP)
        places = sorted(terms, key=self.order.key)
        first = next((k for k, e in enumerate(places) if terms[e] > 0 and not self.order.has_root(e)), 0)
        places.insert(0, places.pop(first))
        return total([self._term(terms[e], e, below) for e in places])

    def _term(self, coefficient: int, exponents: tuple[int, ...], below: int) -> Formula:
        """One term (over a number)."""
        items = [(self.order.ranks[i], self.field.atoms[i], e) for i, e in enumerate(exponents) if e]
        if any(isinstance(atom, Call) and atom.function in GATHERED for _, atom, _ in items):
            return self._build(self.factors.of_term(coefficient, exponents, below))
        number = abs(coefficient)
        shown = written_term(number, items) if below == 1 else written_fraction(Fraction(number, below), items)
        return shown if coefficient > 0 else negate(shown)

    def _in_factors(self, piece: FactoredGroup) -> Formula:
        """A group of a long sum."""
        terms = self.grouping.monomials.terms
        parts = self.factors.gathered(Fraction(piece.number), [(terms(packed), e) for packed, e in piece.sums])
        for i, e in enumerate(self.grouping.monomials.exponents(piece.monomial)):
            if e:
                self.factors.put(parts, i, e)
        return self._build(parts)

    def ratio(self, ratio: Ratio) -> Formula:
        """A fraction in factors; common factors are cancelled first."""
        parts = self.factors.of_ratio(ratio)
        absorb_sizes(self.field, parts)
        apart = self._apart(parts)
        if apart is not None:
            return apart
        if len(parts.sums) == 1 and not parts.gens and parts.root == 1 and self._spreads(parts):
            number = parts.number.numerator
            return self.sum({e: number * c for e, c in parts.sums[0][0].items()}, parts.number.denominator)
        return self._build(parts)

    def _apart(self, parts: Parts) -> Formula | None:
        """A sum over letters with what is whole in front: ω² − 6 g/L; None where all of it is a fraction, or it is not the only factor."""
        above = [(terms, e) for terms, e in parts.sums if e > 0]
        powers = [*parts.gens.values(), *(e for _, e in parts.sums)]
        if len(above) != 1 or parts.root != 1 or len(powers) == 1 or any(e.denominator != 1 for e in powers):
            return None
        below = [(self.field.gens[i], -int(e)) for i, e in parts.gens.items()]
        if any(e < 0 for _, e in below) or above[0][1] != 1 or abs(parts.number.numerator) != 1:
            return None
        below += [(self.field.poly(terms), -int(e)) for terms, e in parts.sums if e < 0]
        split = taken_apart(self.field, self.field.poly(above[0][0]), below, parts.number)
        if len(split) == 1:
            return None
        under = prod((poly**e for poly, e in below), start=self.field.one) * parts.number.denominator
        over = partial(self._over, under, parts.number.numerator)
        ways = [over(split[:-1], split[-1:])]
        if len(split[-1]) < FEWEST:
            ways.append(over(split[:-1], singles(self.field, split[-1])))
        return min(ways, key=length)

    def _over(self, under: Poly, number: int, whole: list[Poly], rest: list[Poly]) -> Formula:
        """Sums of fractions over one thing, what is whole first unless all of it is negative, roots last."""
        terms = [
            sorted([self.ratio(self.field.cancel((part * number, under))) for part in group], key=late)
            for group in (whole, rest)
        ]
        if isinstance(terms[0][0], Negative):
            terms = [sorted([*terms[0], *terms[1]], key=late)]
        return total([term for group in terms for term in group])

    def _spreads(self, parts: Parts) -> bool:
        """Whether a sum over a number reads better term by term: m + ½ M, π − ½ φ, but ½ (u + v)."""
        terms, power = parts.sums[0]
        q = parts.number.denominator
        if power != 1 or q == 1:
            return False
        pi = self.field.index.get(PI)
        if any(c % q == 0 and any(e) for e, c in terms.items()) or (pi is not None and max(e[pi] for e in terms) == 1):
            return True
        return self._fractions(terms, q) < 2 + sum(abs(c) != 1 for c in terms.values())

    def _shared(self, parts: Parts) -> int:
        """The number below a product that goes into its bracket: M (g + ½ L α), but ¼ M g (1 + 3 sin² θ)."""
        q = parts.number.denominator
        if q == 1 or parts.root != 1 or len(parts.sums) != 1 or parts.sums[0][1] != 1:
            return 1
        if any(e < 0 or e.denominator != 1 for e in parts.gens.values()):
            return 1
        terms = parts.sums[0][0]
        lettered = all(map(any, terms))  # 1 + 3 sin² θ has a term without a letter
        cancels = any(c % q == 0 for c in terms.values())
        short = self._fractions(terms, q) <= sum(abs(c) != 1 for c in terms.values())
        return q if lettered and cancels and short else 1

    @staticmethod
    def _fractions(terms: Terms, q: int) -> int:
        """How much there is to read of the coefficients over q: none for 1, one for ½ and 3, two for 5/12."""
        values = [abs(Fraction(c, q)) for c in terms.values()]
        return sum(0 if v == 1 else 1 if v.denominator == 1 or v.numerator == 1 or v in GLYPHS else 2 for v in values)

    # products

    def _build(self, parts: Parts) -> Formula:
        if not parts.number:
            return ZERO
        outer: list[Item] = []
        inner: list[Item] = []
        flip = 1
        items = [(self.order.ranks[i], self.field.atoms[i], e) for i, e in self._with_tan(parts, outer).items()]
        parts.unite_squares()
        shared = self._shared(parts)
        turned = self._turned(parts)
        for terms, e in turned:
            shown, sign = self._oriented(terms, e, flip * parts.number < 0, shared)
            flip *= sign
            alone = sum((other > 0) == (e > 0) for _, other in turned) == 1
            items.append(((2, 0, "" if alone else repr(shown), ""), shown, e))
        for rank, base, e in items:
            whole = int(e)
            if whole:
                outer.append((rank, base, whole))
            if e != whole:
                factors = base.factors if isinstance(base, Product) else (base,)
                inner += [(self._rank(factor, rank), factor, 1 if e > 0 else -1) for factor in factors]
        return assembled(parts.number * flip * shared, parts.root, one_exponential(outer), inner)

    def _rank(self, factor: Formula, other: Rank) -> Rank:
        """Where a letter stands in a product, behind the numbers; what is none stands elsewhere."""
        if isinstance(factor, Number):
            return (-1, 0, "", "")
        return self.order.ranks[self.field.index[factor]] if isinstance(factor, Symbol) else other

    def _turned(self, parts: Parts) -> list[tuple[Terms, Exponent]]:
        """The brackets of a product, two that both lead with a minus turned round: (v − u) (y − x) is (u − v) (x − y)."""
        if len(parts.sums) < 2 or parts.number < 0:
            return parts.sums
        backward = [
            terms for terms, e in parts.sums if e.denominator == 1 and e % 2 and self.order.leads_negative(terms)
        ]
        turned = backward[: len(backward) // 2 * 2]
        return [(negative(terms) if terms in turned else terms, e) for terms, e in parts.sums]

    def _with_tan(self, parts: Parts, outer: list[Item]) -> dict[int, Exponent]:
        """The powers of generators with sin/cos taken out as tan."""
        powers = parts.gens
        for s, c, _ in self.field.pairs:
            k = min(int(powers.get(s, 0)), -int(powers.get(c, 0)))
            if k > 0:
                powers = {**powers, s: powers[s] - k, c: powers[c] + k}
                atom = self.field.atoms[s]
                assert isinstance(atom, Call)
                outer.append((self.order.ranks[s], Call("tan", atom.arguments), k))
        return powers

    def _oriented(self, terms: Terms, power: Exponent, minus: bool, below: int = 1) -> tuple[Formula, int]:
        """A bracket (over a number) with its sign: leading term positive, but turned to absorb a minus before the product."""
        if power.denominator != 1:
            return self._radicand(terms), 1
        odd = power % 2 == 1
        turn = self.order.leads_negative(terms)
        mixed = len({c > 0 for c in terms.values()}) == 2
        if odd and mixed and (minus != turn):
            turn = not turn
        shown = self.sum(negative(terms) if turn else terms, below)
        if odd and isinstance(shown, Sum) and all(isinstance(term, Negative) for term in shown.terms):
            shown, turn = negate(shown), not turn
        return shown, -1 if turn and odd else 1

    def _radicand(self, terms: Terms) -> Formula:
        """What stands under a root, in factors where it has any."""
        content, factors = self.field.factor(self.field.poly(terms))
        mixed = len({c > 0 for c in terms.values()}) == 2
        if len(factors) == 1 and factors[0][1] == 1 and (content == 1 or (content == -1 and mixed)):
            return self.sum(terms)
        parts = Parts(Fraction(content))
        for factor, e in factors:
            inner = self.field.terms(factor)
            i = generator_of(inner)
            if i is None:
                parts.add_sum(inner, e)
            else:
                parts.gens[i] = parts.gens.get(i, 0) + e
        return self._build(parts)
