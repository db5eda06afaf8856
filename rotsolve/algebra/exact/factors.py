"""Factors: what a fraction is a product of: a number, generators of the field, brackets, and one root for all that is under roots;
and what is whole, split off from it: (M a + 2 b)/M is a + 2 b/M.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction

from msgspec import Struct, field

from rotsolve.algebra.exact.field import Field, Poly, PolynomialSigns, Ratio, Terms, generator_of
from rotsolve.algebra.formula import Call

Exponent = int | Fraction  # a fraction where it is a root


class Parts(Struct):
    """A product being gathered: number · √root · gens^powers · sums^powers (half powers are roots)."""

    number: Fraction = Fraction(1)
    root: int = 1
    gens: dict[int, Exponent] = field(default_factory=dict)
    unsure: int | None = None  # the root of unknown sign that has joined
    sums: list[tuple[Terms, Exponent]] = field(default_factory=list)

    def add_sum(self, terms: Terms, power: Exponent) -> None:
        for k, (other, old) in enumerate(self.sums):
            if other == terms or (len(other) == len(terms) and other == negative(terms)):
                if other != terms and power % 2 == 1:
                    self.number = -self.number
                if other == terms or power.denominator == 1:
                    self.sums[k] = (other, old + power)
                    return
        self.sums.append((terms, power))

    def unite_squares(self) -> None:
        """(a + b) (a − b) as a² − b²; but a⁴ − b⁴ stays in factors."""
        for k, (first, power) in enumerate(self.sums):
            for other, e in self.sums[k + 1 :]:
                if e == power and (squares := _squares(first, other)):
                    rest = [item for item in self.sums if item[0] not in (first, other)]
                    self.sums = [*rest, (squares, power)]
                    return self.unite_squares()
        return None


def negative(terms: Terms) -> Terms:
    """The sum with the opposite sign."""
    return {exponents: -c for exponents, c in terms.items()}


def _squares(first: Terms, other: Terms) -> Terms | None:
    """a² − b² for the brackets a + b and ±(a − b); None where they are something else, or both a and b squares."""
    if len(first) != 2 or first.keys() != other.keys():
        return None
    (one, a), (two, b) = first.items()
    c, d = other[one], other[two]
    if (c, d) not in ((a, -b), (-a, b)) or not any(e % 2 for e in (*one, *two)):
        return None
    return {tuple(2 * e for e in one): a * c, tuple(2 * e for e in two): b * d}


class Factorization:
    """Takes the fractions of one field into factors; only names in `positive` are taken to be positive."""

    def __init__(self, ring: Field, positive: Collection[str] = ()) -> None:
        self.field = ring
        self.known: dict[int, list[tuple[Poly, tuple[int, list[tuple[Terms, int]]]]]] = {}  # by number of terms
        self.radicands = {i: square for i, _, square in ring.roots if getattr(ring.atoms[i], "function", "") == "sqrt"}
        signs = PolynomialSigns(ring, positive) if self.radicands else None
        self.unsure = {i for i, square in self.radicands.items() if signs and not signs.nonnegative(square)}

    def of_ratio(self, ratio: Ratio) -> Parts:
        """The factors of a fraction, gathered."""
        num, den = ratio
        if not len(num):
            return Parts(Fraction(0))
        top, above = self._of_poly(num)
        bottom, below = self._of_poly(den)
        return self.gathered(Fraction(top, bottom), [*above, *((terms, -e) for terms, e in below)])

    def _of_poly(self, poly: Poly) -> tuple[int, list[tuple[Terms, int]]]:
        """Number and irreducible factors; all answers of a scene have one denominator."""
        known = self.known.setdefault(len(poly), [])
        for other, factors in known:
            if other == poly:
                return factors
        number, found = self.field.factor(poly)
        known.append((poly, (number, [(self.field.terms(factor), e) for factor, e in found])))
        return known[-1][1]

    def gathered(self, number: Fraction, factors: list[tuple[Terms, int]]) -> Parts:
        """The parts of a product of powers."""
        parts = Parts(number)
        for terms, e in self._squares_of_trig(factors, parts):
            i = generator_of(terms)
            if i is None:
                parts.add_sum(terms, e)
            else:
                self.put(parts, i, e)
        return parts

    def _squares_of_trig(self, factors: list[tuple[Terms, int]], parts: Parts) -> list[tuple[Terms, int]]:
        """(1 − sin)(1 + sin) as cos², and the like for cos."""
        if not self.field.pairs or len(factors) < 2:
            return factors
        gens = self.field.gens
        for s, c, _ in self.field.pairs:
            for a, b in ((s, c), (c, s)):
                plus, minus = self.field.terms(gens[a] + 1), self.field.terms(gens[a] - 1)
                powers = [next((e for p, e in factors if p == q), 0) for q in (plus, minus)]
                k = min(powers, key=abs) if powers[0] * powers[1] > 0 else 0
                if k:
                    factors = [(p, e - k if p in (plus, minus) else e) for p, e in factors]
                    factors = [(p, e) for p, e in [*factors, (self.field.terms(gens[b]), 2 * k)] if e]
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
        terms = self.field.terms(radicand)
        inner = generator_of(terms)
        if inner is None:
            parts.add_sum(terms, Fraction(power) / 2)
        else:
            self.put(parts, inner, Fraction(power) / 2)


def absorb_sizes(ring: Field, parts: Parts) -> None:
    """Let a size join a root that holds what it is the size of: √(q r)/|q| is √(r/q), and |q| √(r/q) is √(q r), since |q| = √(q²)."""
    for i, e in list(parts.gens.items()):
        atom = ring.atoms[i]
        if isinstance(atom, Call) and atom.function == "abs" and e in (1, -1):
            inside = ring.convert(atom.arguments[0])[0]
            if _under_root(ring, parts, inside, e) or _within_root(ring, parts, inside, e):
                del parts.gens[i]


def _under_root(ring: Field, parts: Parts, inside: Poly, e: Exponent) -> bool:
    """Multiply by |q|^e where q stands alone under a root, so that it is not negative; whether it does."""
    terms = ring.terms(inside)
    j = generator_of(terms)
    if j is not None and Fraction(parts.gens.get(j, 0)).denominator == 2:
        parts.gens[j] += e
        return True
    for k, (other, power) in enumerate(parts.sums):
        if power.denominator == 2 and other in (terms, negative(terms)):
            parts.sums[k] = (other, power + e)
            return True
    return False


def _within_root(ring: Field, parts: Parts, inside: Poly, e: Exponent) -> bool:
    """Multiply by |q|^e where q is a factor under a root on the other side of the line, and nowhere else; whether it is."""
    terms = ring.terms(inside)
    j = generator_of(terms)
    if (j in parts.gens) or any(other in (terms, negative(terms)) for other, _ in parts.sums):
        return False
    for k, (other, power) in enumerate(parts.sums):
        if power != Fraction(-e, 2):
            continue
        rest, over = divmod(ring.poly(other), inside)
        if len(over) or len(rest) == 0 or rest.is_constant():
            continue
        if all(c < 0 for c in rest.coeffs()):
            rest, inside = -rest, -inside
        parts.sums[k] = (ring.terms(rest), power)
        j = generator_of(ring.terms(inside))
        if j is None:
            parts.sums.append((ring.terms(inside), Fraction(e, 2)))
        else:
            parts.gens[j] = Fraction(e, 2)
        return True
    return False


MOST = 4  # terms of a sum that is split one by one


def taken_apart(field: Field, top: Poly, below: Sequence[tuple[Poly, int]], number: Fraction) -> list[Poly]:
    """A sum over a product of `below` in parts, of which some cancel all of that product: (M a + 2 b)/M is a + 2 b/M.

    It stays one part where nothing does, or where, times `number`, a bare number would be split off that is not 1.
    """

    def cancels(part: Poly) -> Poly | None:
        rest = divided(part, below)
        alone = rest is not None and rest.is_constant() and abs(number * int(rest.leading_coefficient())) != 1
        return None if alone else rest

    if any(len(poly) > 1 for poly, _ in below):
        groups = [group for i, degree in enumerate(top.degrees()) if degree for group in by_powers(field, top, i)]
        whole = [group for group in groups if len(group) < len(top) and (rest := cancels(group)) and len(rest) == 1]
        return [whole[0], *taken_apart(field, top - whole[0], below, number)] if whole else [top]
    single = singles(field, top)
    whole = [term for term in single if cancels(term) is not None]
    if not whole or len(whole) == len(single) or len(single) > MOST:
        return [top]
    return [*whole, top - sum(whole[1:], whole[0])]


def by_powers(field: Field, poly: Poly, i: int) -> list[Poly]:
    """The parts of a sum with each power of generator i."""
    return [part * field.gens[i] ** k for k, part in enumerate(field.coefficients(poly, i)) if len(part)]


def singles(field: Field, poly: Poly) -> list[Poly]:
    """The terms of a sum."""
    return [field.poly({exponents: c}) for exponents, c in field.terms(poly).items()]


def divided(poly: Poly, below: Sequence[tuple[Poly, int]]) -> Poly | None:
    """A polynomial divided by a product, None where that leaves a rest."""
    for factor, e in below:
        for _ in range(e):
            poly, rest = divmod(poly, factor)
            if len(rest):
                return None
    return poly
