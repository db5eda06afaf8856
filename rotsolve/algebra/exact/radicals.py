"""Radicals: one form for each square root and absolute value, √(a/b) = √a √b/b where a factor can't be negative.

Only names in `positive` are taken to be positive; a factor of unknown sign stays under one root together with its like.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction

from rotsolve.algebra.exact.factors import Factorization
from rotsolve.algebra.exact.field import Field, Poly, PolynomialSigns
from rotsolve.algebra.exact.order import square_part
from rotsolve.algebra.exact.shape import Shaper
from rotsolve.algebra.formula import (
    ONE,
    PI,
    ZERO,
    Call,
    Formula,
    Negative,
    Number,
    Quotient,
    add,
    call,
    divide,
    multiply,
    negate,
    power,
)

Factor = tuple[Poly, int]
Monomials = frozenset[tuple[frozenset[tuple[Formula, int]], int]]


def monomials_of(ring: Field, poly: Poly) -> Monomials:
    """A polynomial whatever the order of the letters of its field."""
    atoms = ring.atoms
    return frozenset(
        (frozenset((atoms[i], e) for i, e in enumerate(powers) if e), c) for powers, c in ring.terms(poly).items()
    )


class Radicals:
    """Canonical roots and absolute values under one set of positive names."""

    def __init__(self, order: Sequence[str] = (), positive: Collection[str] = ()) -> None:
        self.order = order
        self.positive = positive
        # polynomials as they were written first: a field of its own has its letters in another order
        self.written: dict[Monomials, Formula] = {}

    def _shown(self, ring: Field, shaper: Shaper, poly: Poly) -> Formula:
        """A polynomial as it stands under a root, written alike wherever it stands."""
        return self.written.setdefault(monomials_of(ring, poly), shaper.poly(poly))

    def _factors(self, argument: Formula) -> tuple[Field, Fraction, list[Factor], PolynomialSigns]:
        ring = Field([argument])
        num, den = ring.convert(argument)
        num, den = ring.reduce(num), ring.reduce(den)
        num, den = ring.cancel(ring.rationalised((num, den)) or (num, den))
        num, den = ring.squares_united(num), ring.squares_united(den)
        signs = PolynomialSigns(ring, self.positive)
        if not len(num):
            return ring, Fraction(0), [], signs
        parts = Factorization(ring).of_ratio((num, den))
        factors = [(ring.gens[i], e) for i, e in parts.gens.items()]
        factors += [(ring.poly(terms), e) for terms, e in parts.sums]
        if parts.root != 1 or any(e.denominator != 1 for _, e in factors):  # roots under a root: keep them as they are
            top, above = ring.factor(num)
            bottom, below = ring.factor(den)
            return ring, Fraction(top, bottom), above + [(p, -e) for p, e in below], signs
        return ring, parts.number, [(p, int(e)) for p, e in factors if e], signs

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
            shown = self._shown(ring, shaper, poly)
            result = multiply(result, power(shown, e // 2))
            if e % 2:
                result = multiply(result, call("sqrt", shown))
        for poly, e in unknown:
            if e % 2:
                rest = rest * poly
            shown = shaper.poly(poly)
            result = multiply(result, power(call("abs", shown) if e // 2 % 2 else shown, e // 2))
        return result if rest.is_one() else multiply(result, call("sqrt", self._shown(ring, shaper, rest)))

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
            result = multiply(result, power(call("abs", shown) if e % 2 else shown, e))
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


# the square of the sine or tangent -> the angle, in units of π
_ASIN = {Fraction(n, 4): Fraction(turns) for n, turns in enumerate(("0", "1/6", "1/4", "1/3", "1/2"))}
_ATAN = {
    Fraction(square): Fraction(turns) for square, turns in (("0", "0"), ("1/3", "1/6"), ("1", "1/4"), ("3", "1/3"))
}


def _is_whole_root(node: Call) -> bool:
    """Whether a function is the root of a whole number."""
    inside = node.arguments[0] if node.function == "sqrt" else None
    return isinstance(inside, Number) and inside.value.denominator == 1


def _square(node: Formula) -> tuple[int, Fraction] | None:
    """Sign and exact square of a number such as √3/2; None where the formula is no such number."""
    if node.symbols() or not all(_is_whole_root(part) for part in node.walk(Call) if isinstance(part, Call)):
        return None
    sign = -1 if isinstance(node, Negative) or (isinstance(node, Number) and node.value < 0) else 1
    ring = Field([node])
    num, den = ring.convert(node)
    num, den = ring.reduce(num * num), ring.reduce(den * den)
    if not len(num):
        return 0, Fraction(0)
    if not (num.is_constant() and den.is_constant()) or len(node.children()) > 2:
        return None
    return sign, Fraction(int(num.leading_coefficient()), int(den.leading_coefficient()))


def _times_pi(turns: Fraction) -> Formula:
    if not turns:
        return ZERO
    shown = divide(multiply(Number(Fraction(abs(turns.numerator))), PI), Number(Fraction(turns.denominator)))
    return negate(shown) if turns < 0 else shown


def exact_inverse(function: str, arguments: tuple[Formula, ...]) -> Formula | None:
    """The angle as a multiple of π where the table knows it."""
    squares = [_square(argument) for argument in arguments]
    first = squares[0]
    if first is None or None in squares:
        return None
    sign, square = first
    if function in ("asin", "acos"):
        turns = _ASIN.get(square)
        if turns is None:
            return None
        return _times_pi(sign * turns if function == "asin" else Fraction(1, 2) - sign * turns)
    if function == "atan":
        turns = _ATAN.get(square)
        return None if turns is None else _times_pi(sign * turns)
    return _exact_atan2(first, squares[1])


def _exact_atan2(y: tuple[int, Fraction], x: tuple[int, Fraction] | None) -> Formula | None:
    if x is None or (not y[1] and not x[1]):
        return None
    if not x[1]:
        return _times_pi(Fraction(y[0], 2))
    turns = _ATAN.get(y[1] / x[1])
    if turns is None:
        return None
    if x[0] < 0:
        turns = 1 - turns
    return _times_pi(-turns if y[0] < 0 else turns)


def known_pair(node: Call, radicals: Radicals) -> tuple[Formula, Formula]:
    """sin and cos of an inverse function, as algebraic formulas."""
    value = node.arguments[0]
    other = radicals.sqrt(ONE - multiply(value, value)) if node.function in ("asin", "acos") else ONE
    if node.function == "asin":
        return value, other
    if node.function == "acos":
        return other, value
    x = ONE if node.function == "atan" else node.arguments[1]
    radius = radicals.sqrt(add(multiply(x, x), multiply(value, value)))
    return Quotient(value, radius), Quotient(x, radius)
