"""Shape: polynomials and fractions of a field written as a textbook would, e.g. `2 m g/(2 m + M)`.

Factors go: number, root of a number, symbols in the given order, brackets, functions, roots.
The last are gathered into one: √a √b/√c is √(a b/c).
"""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from fractions import Fraction
from functools import partial
from math import prod

from rotsolve.algebra.exact.field import Field, Poly, Ratio
from rotsolve.algebra.exact.grouping import FEWEST, groupings, shortest, singles, taken_apart
from rotsolve.algebra.exact.products import Parts, Rank, share_number, written_fraction
from rotsolve.algebra.exact.signs import Signs
from rotsolve.algebra.formula import (
    ONE,
    PI,
    ZERO,
    Call,
    Constant,
    Formula,
    Negative,
    Number,
    Sum,
    Symbol,
    call,
    multiply,
    negate,
    total,
)
from rotsolve.algebra.notation.letters import GLYPHS

TRIED = (
    4,
    1,
)  # ways to group a long sum that are written out, and a sum in it; the ways to nest deeper grow without bounds
LAST = {"sin": 1, "cos": 2, "tan": 3}  # the order of functions of one argument


class Shaper:
    """Writes the polynomials of one field, symbols in the given order."""

    def __init__(self, ring: Field, order: Sequence[str] = (), positive: Collection[str] = ()) -> None:
        self.field = ring
        places = {name: k for k, name in enumerate(order)}
        self.ranks: list[Rank] = [self._rank(atom, places) for atom in ring.atoms]
        self.radicands = {i: square for i, _, square in ring.roots if self._is_sqrt(i)}
        signs = Signs(ring, positive)
        self.unsure = {i for i, square in self.radicands.items() if not signs.nonnegative(square)}
        self.grouped: dict[object, Formula] = {}  # long sums as they have been written, by terms and depth
        self.depth = 0  # how many long sums stand round the one that is written

    def _is_sqrt(self, i: int) -> bool:
        atom = self.field.atoms[i]
        return isinstance(atom, Call) and atom.function == "sqrt"

    @staticmethod
    def _rank(atom: Formula, places: dict[str, int]) -> Rank:
        """Where an atom stands within a product: symbols, then functions, then roots."""
        if isinstance(atom, Constant):
            return (0, 0, "", "")
        if isinstance(atom, Symbol):
            name = re.sub(r"\d+", lambda found: found[0].zfill(4), atom.name)  # m10 after m9
            return (1, places.get(atom.name, len(places)), name.lower(), name.swapcase())
        if isinstance(atom, Call):
            kind = {"ellipk": 6, "sqrt": 5, "exp": 4}.get(atom.function, 3)
            names = sorted(atom.symbols(), key=lambda name: (places.get(name, len(places)), name))
            first = places.get(names[0], len(places)) if names else 0
            return (kind, first, " ".join(names), f"{atom.arguments}{LAST.get(atom.function, '')}")
        return (2, 0, "", repr(atom))

    # polynomials

    def poly(self, poly: Poly, below: int = 1) -> Formula:
        """An expanded polynomial (over a number), its terms in textbook order, a positive one first, roots last."""
        terms = sorted(self.field.terms(poly), key=lambda term: self._term_key(term[1]))
        if not terms:
            return ZERO
        first = next((k for k, (coefficient, e) in enumerate(terms) if coefficient > 0 and not self._has_root(e)), 0)
        terms.insert(0, terms.pop(first))
        plain = total([self._monomial(*term, below) for term in terms])
        if below != 1 or len(terms) < FEWEST or self.depth == len(TRIED):
            return plain
        key = (self.depth, frozenset(poly.to_dict().items()))
        if key not in self.grouped:
            self.depth += 1
            self.grouped[key] = self._grouped(poly, plain)
            self.depth -= 1
        return self.grouped[key]

    def _grouped(self, poly: Poly, plain: Formula) -> Formula:
        """A long sum by the powers of one letter, where that is much shorter, or two brackets: m₂ (u − v) − m₁ (u + v)."""
        best, least = plain, extent(plain)
        for groups in shortest(self.field, groupings(self.field, poly), TRIED[self.depth - 1]):
            groups.sort(key=lambda group: min(self._term_key(e) for _, e in self.field.terms(group)))
            shown = [self.ratio((group, self.field.one)) for group in groups]
            whole = total(sorted(shown, key=self._late))
            pair = len(groups) == 2 and all(
                len(group) > 1 and not isinstance(one, Sum) for group, one in zip(groups, shown, strict=True)
            )
            size = extent(whole)
            if size < least and (pair or 5 * size <= 4 * extent(plain)):
                best, least = whole, size
        return total(self._merged(list(best.terms))) if best is not plain and isinstance(best, Sum) else best

    def _merged(self, terms: list[Formula]) -> list[Formula]:
        """Terms of a grouped sum with two of them put together where that makes a product: 2 m u − 2 m v is 2 m (u − v)."""
        for k, first in enumerate(terms if len(terms) > 2 else ()):
            for other in terms[k + 1 :]:
                pair = self.field.convert(first)[0] + self.field.convert(other)[0]
                shown = self.ratio((pair, self.field.one))
                if not isinstance(shown, Sum) and extent(shown) <= extent(first) + extent(other):
                    rest = [term for term in terms if term is not other]
                    return self._merged([shown if term is first else term for term in rest])
        return terms

    def _has_root(self, exponents: tuple[int, ...]) -> bool:
        return any(exponents[i] for i, radicand in self.radicands.items() if not radicand.is_constant())

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
        return (self._has_root(exponents), symbols, calls, sorted(ranks))

    def leads_negative(self, poly: Poly) -> bool:
        """Whether the term that stands first by order has a minus."""
        return bool(min(self.field.terms(poly), key=lambda term: self._term_key(term[1]))[0] < 0)

    def _monomial(self, coefficient: int, exponents: tuple[int, ...], below: int = 1) -> Formula:
        parts = Parts(Fraction(coefficient, below))
        for i, e in enumerate(exponents):
            if e:
                self._put_gen(parts, i, Fraction(e))
        return self._build(parts)

    def ratio(self, ratio: Ratio) -> Formula:
        """A fraction in factors; common factors are cancelled first."""
        parts = self.parts(ratio)
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
        if any(e < 0 for _, e in below) or (above[0], Fraction(1)) not in parts.sums:
            return None
        split = taken_apart(self.field, above[0], below, parts.number)
        if len(split) == 1 or abs(parts.number.numerator) != 1:
            return None
        under = prod((poly**e for poly, e in below), start=self.field.one) * parts.number.denominator
        over = partial(self._over, under, parts.number.numerator)
        ways = [over(split[:-1], split[-1:])]
        if len(split[-1]) < FEWEST:
            ways.append(over(split[:-1], singles(self.field, split[-1])))
        return min(ways, key=extent)

    def _over(self, under: Poly, number: int, whole: list[Poly], rest: list[Poly]) -> Formula:
        """Sums of fractions over one thing, what is whole first unless all of it is negative, roots last."""
        terms = [
            sorted([self.ratio(self.field.cancel((part * number, under))) for part in group], key=self._late)
            for group in (whole, rest)
        ]
        if isinstance(terms[0][0], Negative):
            terms = [sorted([*terms[0], *terms[1]], key=self._late)]
        return total([term for group in terms for term in group])

    @staticmethod
    def _late(term: Formula) -> tuple[bool, bool]:
        """Where a term stands in a sum: roots behind the others, minus signs behind plus."""
        return isinstance(term, Negative), any(
            isinstance(node, Call) and node.function == "sqrt" for node in term.walk()
        )

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
                    parts.number *= -1 if k % 2 else 1
        return factors

    # products

    def _put_gen(self, parts: Parts, i: int, power: Fraction) -> None:
        """Multiply by a generator; a root becomes a half power of what stands under it."""
        radicand = self.radicands.get(i)
        if i in self.unsure:  # of these only one may join the common root: √p √q is √(p q) only for p, q ≥ 0
            parts.unsure = i if parts.unsure is None else parts.unsure
        if radicand is None or power.denominator != 1 or (i in self.unsure and parts.unsure != i):  # √√x stays as it is
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
        return self._assemble(parts.number * flip * shared, parts.root, self._with_exp(outer), inner)

    def _turned(self, parts: Parts) -> list[tuple[Poly, Fraction]]:
        """The brackets of a product, two that both lead with a minus turned round: (v − u) (y − x) is (u − v) (x − y)."""
        backward = [poly for poly, e in parts.sums if e.denominator == 1 and e % 2 and self.leads_negative(poly)]
        turned = backward[: len(backward) // 2 * 2] if parts.number > 0 else []
        return [(-poly if poly in turned else poly, e) for poly, e in parts.sums]

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

    def _oriented(self, poly: Poly, power: Fraction, negative: bool, below: int = 1) -> tuple[Formula, int]:
        """A bracket (over a number) with its sign: leading term positive, but turned to absorb a minus before the product."""
        if power.denominator != 1:
            return self._radicand(poly), 1
        odd = power % 2 == 1
        turn = self.leads_negative(poly)
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
        number, under = share_number(number, root, bool(inner))
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


def extent(node: Formula) -> int:
    """How long a formula is to read: its number of nodes."""
    return sum(1 for _ in node.walk())
