"""Field: rational functions over ℚ in the symbols and atoms of some formulas, on flint polynomials.

The generators are ordered (roots from the outside in, cosines, other atoms, sines, symbols) so that each relation
r² = radicand and cos² = 1 − sin² has its square as the leading monomial: reducing is one polynomial division.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from math import gcd
from typing import Any

from rotsolve.algebra.flints import fmpz_mpoly_ctx
from rotsolve.algebra.formula import Call, Constant, Formula, Negative, Number, Power, Product, Quotient, Sum, Symbol

Poly = Any
Ratio = tuple[Poly, Poly]
Terms = dict[tuple[int, ...], int]  # a polynomial in plain Python: exponents -> coefficient, leading term first
RADICALS = ("sqrt", "abs")
TRIG = ("sin", "cos")


def is_integer_power(node: Formula) -> bool:
    """Whether the node is a power with a whole number as exponent."""
    return isinstance(node, Power) and isinstance(node.exponent, Number) and node.exponent.value.denominator == 1


def generators(formulas: Iterable[Formula]) -> dict[Formula, int]:
    """Symbols and atoms of the formulas with their level: the depth of nested radicals, 0 for all others."""
    found: dict[Formula, int] = {}

    def visit(node: Formula) -> int:
        if isinstance(node, Number):
            return 0
        if node in found:
            return found[node]
        if isinstance(node, Symbol):
            return found.setdefault(node, 0)
        if isinstance(node, (Sum, Product, Quotient, Negative)):
            return max(map(visit, node.children()))
        if isinstance(node, Power) and is_integer_power(node):
            return visit(node.base)
        if isinstance(node, Call) and node.function in RADICALS:
            level = 1 + visit(node.arguments[0])
            found[node] = level
            return level
        if isinstance(node, Call) and node.function in TRIG:
            for function in TRIG:
                found.setdefault(Call(function, node.arguments), 0)
        found.setdefault(node, 0)
        return 0

    for formula in formulas:
        visit(formula)
    return found


def _place(item: tuple[Formula, int]) -> tuple[int, int]:
    node, level = item
    if level:
        return (0, -level)
    if isinstance(node, Call):
        return ({"cos": 1, "sin": 3}.get(node.function, 2), 0)
    return (4, 0)


class Field:
    """The ring of polynomials in which some formulas live, with the relations between its generators."""

    def __init__(self, formulas: Iterable[Formula]) -> None:
        found = sorted(generators(formulas).items(), key=_place)
        self.atoms: tuple[Formula, ...] = tuple(node for node, _ in found)
        self.index: dict[Formula, int] = {node: i for i, node in enumerate(self.atoms)}
        self.context = fmpz_mpoly_ctx.get([f"x{i}" for i in range(len(found))], "lex")
        self.gens: tuple[Poly, ...] = self.context.gens()
        self.zero: Poly = self.context.constant(0)
        self.one: Poly = self.context.constant(1)
        self.roots: list[tuple[int, Poly, Poly]] = []  # (index, modulus, radicand)
        self.pairs: list[tuple[int, int, Poly]] = []  # (index of sin, index of cos, modulus)
        for node, level in reversed(found):
            if level:
                self._relate_root(node)
            elif isinstance(node, Call) and node.function == "sin":
                s, c = self.index[node], self.index[Call("cos", node.arguments)]
                self.pairs.append((s, c, self.gens[c] ** 2 + self.gens[s] ** 2 - 1))
        self.roots.reverse()

    def _relate_root(self, node: Formula) -> None:
        """Record r² = radicand for √radicand, or r² = argument² for |argument|."""
        assert isinstance(node, Call)
        i = self.index[node]
        num, den = self.convert(node.arguments[0])
        if not den.is_one():
            raise ValueError("a radicand must be a polynomial with whole coefficients")
        square = num if node.function == "sqrt" else self.reduce_roots(num * num)
        self.roots.append((i, self.gens[i] ** 2 - square, square))

    # reducing

    def reduce_roots(self, poly: Poly) -> Poly:
        """The polynomial with every square of a root replaced by its radicand."""
        if self.roots and len(poly):
            for i, modulus, _ in self.roots:
                if poly.degrees()[i] > 1:
                    poly = poly % modulus
        return poly

    def reduce(self, poly: Poly) -> Poly:
        """The normal form: linear in every root and every cosine; zero only if the polynomial vanishes everywhere."""
        poly = self.reduce_roots(poly)
        for _, c, modulus in self.pairs:
            if len(poly) and poly.degrees()[c] > 1:
                poly = poly % modulus
        return poly

    def reduce_to_cos(self, poly: Poly, pair: tuple[int, int, Poly]) -> Poly:
        """The polynomial with sin² replaced by 1 − cos² for this pair."""
        s, c, modulus = pair
        if not len(poly) or poly.degrees()[s] < 2:
            return poly
        return self._swapped(self._swapped(poly, s, c) % modulus, s, c)

    def squares_united(self, poly: Poly) -> Poly:
        """The polynomial in normal form with a − a sin² written a cos², term by term, where both stand in it: alike whatever the order of
        its letters."""
        for s, c, _ in sorted(self.pairs, key=lambda pair: repr(self.atoms[pair[0]])):
            if not len(poly) or poly.degrees()[s] < 2:
                continue
            terms = self.terms(poly)
            for place in sorted((one for one in terms if one[s] > 1), key=lambda one: -one[s]):
                lower, higher = list(place), list(place)
                lower[s], higher[s], higher[c] = place[s] - 2, place[s] - 2, place[c] + 2
                size = terms.get(tuple(lower), 0)
                if size and size == -terms.get(place, 0):
                    del terms[place], terms[tuple(lower)]
                    terms[tuple(higher)] = terms.get(tuple(higher), 0) + size
            poly = self.context.from_dict({place: number for place, number in terms.items() if number})
        return poly

    def _swapped(self, poly: Poly, i: int, j: int) -> Poly:
        """The polynomial with generators i and j exchanged."""
        terms = {}
        for exponents, coefficient in self.terms(poly).items():
            place = list(exponents)
            place[i], place[j] = place[j], place[i]
            terms[tuple(place)] = coefficient
        return self.context.from_dict(terms)

    def rationalised(self, ratio: Ratio) -> Ratio | None:
        """The fraction without roots in its denominator, None where it has none in a sum there."""
        num, den = ratio
        start = den
        for i, _, _ in self.roots:
            if len(den) > 1 and den.degrees()[i] == 1:
                conjugate = den - 2 * self.gens[i] * den.derivative(i)
                num, den = self.reduce(num * conjugate), self.reduce(den * conjugate)
        return None if den == start else (num, den)

    def cancel(self, ratio: Ratio) -> Ratio:
        """The fraction without common factor, the leading coefficient of its denominator positive."""
        num, den = ratio
        if not len(num):
            return self.zero, self.one
        if den.is_one():
            return ratio
        if not den.is_constant():
            common = num.gcd(den)
            if not common.is_one():
                num, den = num / common, den / common
        if den.is_constant():
            common = gcd(int(den.leading_coefficient()), *(int(c) for c in num.coeffs()))
            if common != 1:
                num, den = num / common, den / common
        return (-num, -den) if den.leading_coefficient() < 0 else (num, den)

    # arithmetic

    def convert(self, node: Formula) -> Ratio:
        """A formula of this field as numerator and denominator, roots reduced, otherwise as it comes."""
        if isinstance(node, Number):
            value = node.value
            return self.context.constant(value.numerator), self.context.constant(value.denominator)
        i = self.index.get(node)
        if i is not None:
            return self.gens[i], self.one
        if isinstance(node, Sum):
            return self._sum(node.terms)
        if isinstance(node, Product):
            num, den = self.convert(node.factors[0])
            for factor in node.factors[1:]:
                n, d = self.convert(factor)
                num, den = num * n, den if d.is_one() else den * d
            return self.reduce_roots(num), self.reduce_roots(den)
        if isinstance(node, Negative):
            num, den = self.convert(node.operand)
            return -num, den
        if isinstance(node, Quotient):
            num, den = self.convert(node.numerator)
            n, d = self.convert(node.denominator)
            self.check_divisor(n)
            num = num if d.is_one() else self.reduce_roots(num * d)
            return num, n if den.is_one() else self.reduce_roots(den * n)
        if isinstance(node, Power) and isinstance(node.exponent, Number):
            return self._power(self.convert(node.base), int(node.exponent.value))
        raise ValueError(f"not of this field: {node!r}")

    def check_divisor(self, poly: Poly) -> None:
        """Raise where a divisor is zero, also one that is zero only by sin² + cos² = 1."""
        if not len(poly) or ((self.pairs or self.roots) and not len(self.reduce(poly))):
            raise ZeroDivisionError("division by zero")

    def _power(self, base: Ratio, exponent: int) -> Ratio:
        num, den = base
        if exponent < 0:
            self.check_divisor(num)
            num, den, exponent = den, num, -exponent
        return self.reduce_roots(num**exponent), self.reduce_roots(den**exponent)

    def _sum(self, terms: Sequence[Formula]) -> Ratio:
        num, den = self.convert(terms[0])
        for term in terms[1:]:
            n, d = self.convert(term)
            if (d.is_one() and den.is_one()) or d == den:
                num = num + n
            else:
                common = d.gcd(den)
                left, right = d / common, den / common
                num, den = self.reduce_roots(num * left + n * right), self.reduce_roots(den * left)
        return num, den

    # looking inside

    def terms(self, poly: Poly) -> Terms:
        """The coefficient of each monomial, leading one first."""
        return {tuple(map(int, e)): int(c) for e, c in zip(poly.monoms(), poly.coeffs(), strict=True)}

    def poly(self, terms: Terms) -> Poly:
        """The polynomial with these terms."""
        return self.context.from_dict(terms)

    def coefficients(self, poly: Poly, i: int) -> list[Poly]:
        """The coefficients of the polynomial by powers of generator i, from the constant on."""
        parts: dict[int, Terms] = {}
        for exponents, coefficient in self.terms(poly).items():
            rest = (*exponents[:i], 0, *exponents[i + 1 :])
            parts.setdefault(exponents[i], {})[rest] = coefficient
        return [self.context.from_dict(parts.get(k, {})) for k in range(max(parts, default=0) + 1)]

    def mentions(self, i: int, name: str) -> bool:
        """Whether generator i is an atom that holds the symbol inside."""
        atom = self.atoms[i]
        return not isinstance(atom, (Symbol, Constant)) and name in atom.symbols()

    # factoring

    def factor(self, poly: Poly) -> tuple[int, list[tuple[Poly, int]]]:
        """Number and irreducible factors with their multiplicity; leading coefficients positive."""
        content, parts = 1, []
        monomial = poly.term_content()
        if not monomial.is_one():
            poly = poly / monomial
            content = int(monomial.leading_coefficient())
            exponents = monomial.monomial(0)
            parts = [(self.gens[i], int(e)) for i, e in enumerate(exponents) if e]
        if poly.leading_coefficient() < 0:
            content, poly = -content, -poly
        if poly.is_one():
            return content, parts
        return content, parts + self._split(poly)

    def _split(self, poly: Poly) -> list[tuple[Poly, int]]:
        """Factors of a primitive polynomial: where it is linear in a variable, one gcd splits it."""
        if len(poly) > 2:
            degrees = poly.degrees()
            lines = [i for i, degree in enumerate(degrees) if degree == 1]
            flat = max(degrees) == 1
            slopes = [poly.derivative(i) for i in lines]
            if any(proves_prime(len(slope), len(poly) - len(slope), flat=flat) for slope in slopes):
                return [(poly, 1)]
            if slopes:
                common = slopes[0].gcd(poly - slopes[0] * self.gens[lines[0]])
                if common.is_constant():
                    return [(poly, 1)]
                first = poly / common
                if common.leading_coefficient() < 0:
                    first, common = -first, -common
                return [(first, 1), *self._split(common)]
        elif poly.total_degree() == 1:
            return [(poly, 1)]
        try:
            _, parts = poly.factor()
        except OverflowError:  # FLINT's binding sorts the factors by coefficients, and can not compare huge ones
            return [(poly, 1)]
        return [(-p if p.leading_coefficient() < 0 else p, int(e)) for p, e in parts]


def proves_prime(slope: int, rest: int, *, flat: bool) -> bool:
    """Whether a sum without a common factor of its terms, x · slope + rest, has no factors, told from how many terms each of them has.

    A factor without x divides both. It is more than one term, so neither can be a single one; in a `flat` sum, which holds no
    letter twice, its factors share no letter, so that its number of terms divides both numbers.
    """
    return slope == 1 or rest == 1 or (flat and gcd(slope, rest) == 1)


def generator_of(terms: Terms) -> int | None:
    """The index of the generator that a sum is, None where it is more."""
    if len(terms) != 1:
        return None
    ((exponents, c),) = terms.items()
    return exponents.index(1) if c == 1 and sum(exponents) == 1 else None


class PolynomialSigns:
    """What is known of the signs of a field's polynomials."""

    def __init__(self, ring: Field, positive: Collection[str], acute: Collection[str] = ()) -> None:
        self.field = ring
        self.kinds = [self._kind(atom, positive, acute) for atom in ring.atoms]

    @staticmethod
    def _kind(atom: Formula, positive: Collection[str], acute: Collection[str]) -> str:
        """plus: never negative; bounded: between −1 and 1; any."""
        if isinstance(atom, Constant) or (isinstance(atom, Symbol) and atom.name in positive):
            return "plus"
        if isinstance(atom, Call) and atom.function in ("sqrt", "abs", "exp"):
            return "plus"
        if isinstance(atom, Call) and atom.function in ("sin", "cos"):
            angle = atom.arguments[0]
            return "plus" if isinstance(angle, Symbol) and angle.name in acute else "bounded"
        return "any"

    def nonnegative(self, poly: Poly) -> bool:
        """Whether the polynomial is certainly never negative (a no means: not known)."""
        lows: dict[tuple[int, ...], int] = {}
        for exponents, coefficient in self.field.terms(poly).items():
            split = self._split(exponents)
            if split is None:
                return False
            key, varies, odd = split
            low = min(coefficient, 0) if varies and not odd else -abs(coefficient) if odd else coefficient
            lows[key] = lows.get(key, 0) + low
        return all(low >= 0 for low in lows.values())

    def _split(self, exponents: tuple[int, ...]) -> tuple[tuple[int, ...], bool, bool] | None:
        """The part of a monomial that is never negative, whether a bounded part varies, whether it changes sign."""
        key, varies, odd = list(exponents), False, False
        for i, e in enumerate(exponents):
            if e and self.kinds[i] == "bounded":
                key[i], varies, odd = 0, True, odd or e % 2 == 1
            elif e % 2 and self.kinds[i] == "any":
                return None
        return tuple(key), varies, odd
