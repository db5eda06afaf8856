"""Shape: polynomials and fractions of a field written as a textbook would, e.g. `2 m g/(2 m + M)`.

Factors go: number, root of a number, symbols in the given order, brackets, functions, roots.
The last are gathered into one: √a √b/√c is √(a b/c).
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction
from functools import partial
from math import prod

from rotsolve.algebra.exact.field import Field, Poly, Ratio
from rotsolve.algebra.exact.writing.factors import Exponent, Factors, Parts
from rotsolve.algebra.exact.writing.grouping import FEWEST, groupings, shortest, singles, taken_apart
from rotsolve.algebra.exact.writing.order import Order, late
from rotsolve.algebra.exact.writing.products import Item, assembled, one_exponential, written_fraction
from rotsolve.algebra.formula import PI, ZERO, Call, Formula, Negative, Sum, negate, total
from rotsolve.algebra.notation.letters import GLYPHS

# ways to group a long sum that are written out, and a sum in it; the ways to nest deeper grow without bounds
TRIED = (4, 1)
GATHERED = ("sqrt", "exp")  # functions of which a product has one at most


class Shaper:
    """Writes the polynomials of one field, symbols in the given order."""

    def __init__(self, ring: Field, order: Sequence[str] = (), positive: Collection[str] = ()) -> None:
        self.field = ring
        self.factors = Factors(ring, positive)
        self.order = Order(ring, order, self.factors.radicands)
        self.grouped: dict[object, Formula] = {}  # long sums as they have been written, by terms and depth
        self.depth = 0  # how many long sums stand round the one that is written

    # polynomials

    def poly(self, poly: Poly, below: int = 1) -> Formula:
        """An expanded polynomial (over a number), its terms in textbook order, a positive one first, roots last."""
        terms = sorted(self.field.terms(poly), key=lambda term: self.order.key(term[1]))
        if not terms:
            return ZERO
        first = next(
            (k for k, (coefficient, e) in enumerate(terms) if coefficient > 0 and not self.order.has_root(e)), 0
        )
        terms.insert(0, terms.pop(first))
        plain = total([self._term(*term, below) for term in terms])
        if below != 1 or len(terms) < FEWEST or self.depth == len(TRIED):
            return plain
        key = (self.depth, frozenset(poly.to_dict().items()))
        if key not in self.grouped:
            self.depth += 1
            self.grouped[key] = self._grouped(poly, plain)
            self.depth -= 1
        return self.grouped[key]

    def _term(self, coefficient: int, exponents: tuple[int, ...], below: int) -> Formula:
        """One term (over a number)."""
        items = [(self.order.ranks[i], self.field.atoms[i], e) for i, e in enumerate(exponents) if e]
        if any(isinstance(atom, Call) and atom.function in GATHERED for _, atom, _ in items):
            return self._build(self.factors.of_term(coefficient, exponents, below))
        shown = written_fraction(Fraction(abs(coefficient), below), items)
        return shown if coefficient > 0 else negate(shown)

    def _grouped(self, poly: Poly, plain: Formula) -> Formula:
        """A long sum by the powers of one letter, where that is much shorter, or two brackets: m₂ (u − v) − m₁ (u + v)."""
        best, least = plain, length(plain)
        for groups in shortest(self.field, groupings(self.field, poly), TRIED[self.depth - 1]):
            groups.sort(key=lambda group: min(self.order.key(e) for _, e in self.field.terms(group)))
            shown = [(group, self.ratio((group, self.field.one))) for group in groups]
            whole = self._sum(shown)
            pair = len(groups) == 2 and all(len(group) > 1 and not isinstance(one, Sum) for group, one in shown)
            size = length(whole)
            if size < least and (pair or 5 * size <= 4 * length(plain)):
                best, least = self._sum(self._merged(shown)), size
        return best

    @staticmethod
    def _sum(shown: Sequence[tuple[Poly, Formula]]) -> Formula:
        return total(sorted((one for _, one in shown), key=late))

    def _merged(self, shown: list[tuple[Poly, Formula]]) -> list[tuple[Poly, Formula]]:
        """Terms of a grouped sum with two of them put together where that makes a product: 2 m u − 2 m v is 2 m (u − v)."""
        for k, (first, one) in enumerate(shown if len(shown) > 2 else ()):
            for other, another in shown[k + 1 :]:
                both = self.ratio((first + other, self.field.one))
                if not isinstance(both, Sum) and length(both) <= length(one) + length(another):
                    rest = [(poly, text) for poly, text in shown if text is not another]
                    return self._merged([(first + other, both) if text is one else (poly, text) for poly, text in rest])
        return shown

    def ratio(self, ratio: Ratio) -> Formula:
        """A fraction in factors; common factors are cancelled first."""
        parts = self.factors.of_ratio(ratio)
        apart = self._apart(parts)
        if apart is not None:
            return apart
        if len(parts.sums) == 1 and not parts.gens and parts.root == 1 and self._spreads(parts):
            return self.poly(parts.sums[0][0] * parts.number.numerator, parts.number.denominator)
        return self._build(parts)

    def _apart(self, parts: Parts) -> Formula | None:
        """A sum over letters with what is whole in front: ω² − 6 g/L; None where all of it is a fraction, or it is not the only factor."""
        above = [poly for poly, e in parts.sums if e > 0]
        powers = [*parts.gens.values(), *(e for _, e in parts.sums)]
        if len(above) != 1 or parts.root != 1 or len(powers) == 1 or any(e.denominator != 1 for e in powers):
            return None
        below = [(self.field.gens[i], -int(e)) for i, e in parts.gens.items()]
        below += [(poly, -int(e)) for poly, e in parts.sums if e < 0]
        if any(e < 0 for _, e in below) or (above[0], 1) not in parts.sums:
            return None
        split = taken_apart(self.field, above[0], below, parts.number)
        if len(split) == 1 or abs(parts.number.numerator) != 1:
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
        poly, power = parts.sums[0]
        q = parts.number.denominator
        if power != 1 or q == 1:
            return False
        terms = list(self.field.terms(poly))
        pi = self.field.index.get(PI)
        if any(c % q == 0 and any(e) for c, e in terms) or (pi is not None and poly.degrees()[pi] == 1):
            return True
        return self._fractions(terms, q) < 2 + sum(abs(c) != 1 for c, _ in terms)

    def _shared(self, parts: Parts) -> int:
        """The number below a product that goes into its bracket: M (g + ½ L α), but ¼ M g (1 + 3 sin² θ)."""
        q = parts.number.denominator
        if q == 1 or parts.root != 1 or len(parts.sums) != 1 or parts.sums[0][1] != 1:
            return 1
        if any(e < 0 or e.denominator != 1 for e in parts.gens.values()):
            return 1
        terms = list(self.field.terms(parts.sums[0][0]))
        lettered = all(any(e) for _, e in terms)  # 1 + 3 sin² θ has a term without a letter
        cancels = any(c % q == 0 for c, _ in terms)
        return q if lettered and cancels and self._fractions(terms, q) <= sum(abs(c) != 1 for c, _ in terms) else 1

    @staticmethod
    def _fractions(terms: list[tuple[int, tuple[int, ...]]], q: int) -> int:
        """How much there is to read of the coefficients over q: none for 1, one for ½ and 3, two for 5/12."""
        values = [abs(Fraction(c, q)) for c, _ in terms]
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
        for poly, e in self._turned(parts):
            shown, sign = self._oriented(poly, e, flip * parts.number < 0, shared)
            flip *= sign
            items.append(((2, 0, repr(shown) if len(parts.sums) > 1 else "", ""), shown, e))
        for rank, base, e in items:
            whole = int(e)
            if whole:
                outer.append((rank, base, whole))
            if e != whole:
                inner.append((rank, base, 1 if e > 0 else -1))
        return assembled(parts.number * flip * shared, parts.root, one_exponential(outer), inner)

    def _turned(self, parts: Parts) -> list[tuple[Poly, Exponent]]:
        """The brackets of a product, two that both lead with a minus turned round: (v − u) (y − x) is (u − v) (x − y)."""
        backward = [poly for poly, e in parts.sums if e.denominator == 1 and e % 2 and self.order.leads_negative(poly)]
        turned = backward[: len(backward) // 2 * 2] if parts.number > 0 else []
        return [(-poly if poly in turned else poly, e) for poly, e in parts.sums]

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

    def _oriented(self, poly: Poly, power: Exponent, negative: bool, below: int = 1) -> tuple[Formula, int]:
        """A bracket (over a number) with its sign: leading term positive, but turned to absorb a minus before the product."""
        if power.denominator != 1:
            return self._radicand(poly), 1
        odd = power % 2 == 1
        turn = self.order.leads_negative(poly)
        mixed = len({coefficient > 0 for coefficient, _ in self.field.terms(poly)}) == 2
        if odd and mixed and (negative != turn):
            turn = not turn
        shown = self.poly(-poly if turn else poly, below)
        if odd and isinstance(shown, Sum) and all(isinstance(term, Negative) for term in shown.terms):
            shown, turn = negate(shown), not turn
        return shown, -1 if turn and odd else 1

    def _radicand(self, poly: Poly) -> Formula:
        """What stands under a root, in factors where it has any."""
        content, factors = self.field.factor(poly)
        if len(factors) == 1 and factors[0][1] == 1 and content == 1:
            return self.poly(poly)
        parts = Parts(Fraction(content))
        for factor, e in factors:
            i = self.field.generator_of(factor)
            if i is None:
                parts.add_sum(factor, e)
            else:
                parts.gens[i] = parts.gens.get(i, 0) + e
        return self._build(parts)


def length(node: Formula) -> int:
    """How long a formula is to read: its number of nodes."""
    count, waiting = 0, [node]
    while waiting:
        count += 1
        waiting.extend(waiting.pop().children())
    return count
