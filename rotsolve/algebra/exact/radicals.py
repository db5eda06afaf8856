"""Radicals: one form for each square root and absolute value, √(a/b) = √a √b/b where a factor can't be negative.

Only names in `positive` are taken to be positive; a factor of unknown sign stays under one root together with its like.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction

from rotsolve.algebra.exact.field import Field, Poly
from rotsolve.algebra.exact.signs import PolynomialSigns
from rotsolve.algebra.exact.writing.factors import Factors
from rotsolve.algebra.exact.writing.products import square_part
from rotsolve.algebra.exact.writing.shape import Shaper
from rotsolve.algebra.formula import ZERO, Formula, Number, add, call, multiply, power

Factor = tuple[Poly, int]


class Radicals:
    """Canonical roots and absolute values under one set of positive names."""

    def __init__(self, order: Sequence[str] = (), positive: Collection[str] = ()) -> None:
        self.order = order
        self.positive = positive

    def _factors(self, argument: Formula) -> tuple[Field, Fraction, list[Factor], PolynomialSigns]:
        ring = Field([argument])
        num, den = ring.convert(argument)
        num, den = ring.reduce(num), ring.reduce(den)
        num, den = ring.cancel(ring.rationalised((num, den)) or (num, den))
        if not len(num):
            return ring, Fraction(0), [], PolynomialSigns(ring, self.positive)
        parts = Factors(ring).of_ratio((num, den))
        factors = [(ring.gens[i], e) for i, e in parts.gens.items()]
        factors += [(ring.poly(terms), e) for terms, e in parts.sums]
        if parts.root != 1 or any(e.denominator != 1 for _, e in factors):  # roots under a root: keep them as they are
            top, above = ring.factor(num)
            bottom, below = ring.factor(den)
            return (
                ring,
                Fraction(top, bottom),
                above + [(p, -e) for p, e in below],
                PolynomialSigns(ring, self.positive),
            )
        return ring, parts.number, [(p, int(e)) for p, e in factors if e], PolynomialSigns(ring, self.positive)

    def _settled(
        self, ring: Field, signs: PolynomialSigns, number: Fraction, factors: list[Factor]
    ) -> tuple[Fraction, list[Factor], list[Factor]]:
        """Number, factors that are never negative, factors of unknown sign."""
        known: list[Factor] = []
        unknown: list[Factor] = []
        for poly, e in factors:
            if signs.nonnegative(poly):
                known.append((poly, e))
            elif signs.nonnegative(-poly):
                known.append((-poly, e))
                number *= -1 if e % 2 else 1
            else:
                unknown.append((poly, e))
        return number, known, unknown

    def sqrt(self, argument: Formula) -> Formula:
        """√argument as a product of canonical roots."""
        ring, number, factors, signs = self._factors(argument)
        if not number:
            return Number(number)
        number, known, unknown = self._settled(ring, signs, number, factors)
        odd = [(poly, e) for poly, e in unknown if e % 2]
        if len(odd) == 1:  # the root exists only where this factor has the sign of the number
            poly, e = odd[0]
            known.append((poly if number > 0 else -poly, e))
            number, unknown, odd = abs(number), [item for item in unknown if item[1] % 2 == 0], []
        shaper = Shaper(ring, self.order)
        result = _numeric_root(abs(number))
        rest = ring.one if number > 0 else -ring.one
        for poly, e in known:
            shown = shaper.poly(poly)
            result = multiply(result, power(shown, e // 2))
            if e % 2:
                result = multiply(result, call("sqrt", shown))
        for poly, e in unknown:
            if e % 2:
                rest = rest * poly
            result = multiply(result, power(self._abs(shaper.poly(poly)) if e // 2 % 2 else shaper.poly(poly), e // 2))
        return result if rest.is_one() else multiply(result, call("sqrt", shaper.poly(rest)))

    def abs(self, argument: Formula) -> Formula:
        """|argument| with the factors outside whose sign is known."""
        ring, number, factors, signs = self._factors(argument)
        number, known, unknown = self._settled(ring, signs, number, factors)
        shaper = Shaper(ring, self.order)
        result: Formula = Number(abs(number))
        for poly, e in known:
            result = multiply(result, power(shaper.poly(poly), e))
        for poly, e in unknown:
            shown = shaper.poly(poly)
            result = multiply(result, power(self._abs(shown) if e % 2 else shown, e))
        return result

    def log(self, argument: Formula) -> Formula:
        """log(argument) as a sum over the factors that are never negative."""
        ring, number, factors, signs = self._factors(argument)
        number, known, unknown = self._settled(ring, signs, number, factors)
        shaper = Shaper(ring, self.order)
        rest: Formula = Number(number)
        result: Formula = ZERO
        for poly, e in unknown:
            rest = multiply(rest, power(shaper.poly(poly), e))
        for poly, e in known:
            result = add(result, multiply(Number(Fraction(e)), call("log", shaper.poly(poly))))
        if unknown or number < 0:
            return add(result, call("log", rest))
        for n, sign in ((number.numerator, 1), (number.denominator, -1)):
            for p, e in prime_powers(n):
                result = add(result, multiply(Number(Fraction(sign * e)), call("log", Number(Fraction(p)))))
        return result

    @staticmethod
    def _abs(shown: Formula) -> Formula:
        return call("abs", shown)


def prime_powers(n: int) -> list[tuple[int, int]]:
    """The prime factors of n below 2000 with their exponents, and what is left as one factor."""
    found, p = [], 2
    while p * p <= n and p < 2000:
        e = 0
        while n % p == 0:
            n, e = n // p, e + 1
        if e:
            found.append((p, e))
        p += 1 if p == 2 else 2
    return [*found, (n, 1)] if n > 1 else found


def _numeric_root(value: Fraction) -> Formula:
    """√value with squares outside and a root for every small prime."""
    outside, rest = square_part(value.numerator * value.denominator)
    result: Formula = Number(Fraction(outside, value.denominator))
    for p, _ in prime_powers(rest):
        result = multiply(result, call("sqrt", Number(Fraction(p))))
    return result
