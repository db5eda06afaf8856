"""Raised: formulas with letters in exponents, x^(n + 1) and e^(−k t), and logarithms, made rational in letters for powers and logarithms.

What is raised to letters is positive where it has a value, so that (x y)^n is x^n y^n, ln xⁿ is n ln x, and x^(n + 1) is x xⁿ. Every base
is cut into primes and irreducible polynomials and every exponent into its terms, so that each power of one by the other is one letter.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from math import lcm
from typing import Any

from msgspec import Struct

from rotsolve.algebra.exact.field import Field
from rotsolve.algebra.formula import ONE, ZERO, Call, Formula, Number, Power, Product, Sum, Symbol, total

LARGEST_PRIME = 1000  # that is looked for in a number
MOST_TERMS = 60  # of an exponent, and of what is raised
EULER = Call("exp", (ONE,))
Key = tuple[Any, ...]


class Summand(Struct, frozen=True):
    """A rational number times a product: `key` is the same for equal products, however they were written."""

    number: Fraction
    product: Formula
    key: Key


class Raised:
    """The letters for powers, shared by all formulas that are compared; whole powers of them stand in these."""

    def __init__(self) -> None:
        self.letters: dict[Key, Symbol] = {}
        self.meaning: dict[str, tuple[Formula, Formula]] = {}  # base and exponent of each
        self.parts: dict[str, int] = {}  # of so many equal parts of its exponent each letter has one

    def plain(self, node: Formula) -> Formula:
        """A formula with letters for its powers; ValueError where it is too large for that."""
        children = node.children()
        if children:
            node = node.with_children(tuple(map(self.plain, children)))
        if isinstance(node, Power) and not isinstance(node.exponent, Number):
            return self.raised(node.base, node.exponent)
        if isinstance(node, Call) and node.function == "exp":
            return self.raised(EULER, node.arguments[0])
        if isinstance(node, Call) and node.function == "log":
            return self.logarithm(node.arguments[0])
        return node

    def raised(self, base: Formula, exponent: Formula) -> Formula:
        """A base to a power, as a product of letters and of powers with numbers."""
        result: Formula = ONE
        for term in summands_of(exponent):
            own = self.split(base) if base != EULER else [(EULER, Fraction(1))]
            logarithm = next((one for one in factors_in(term.product) if is_logarithm(one)), None)
            rest = term
            if base == EULER and isinstance(logarithm, Call):  # e^(n ln x) is x^n
                own = self.split(logarithm.arguments[0])
                (rest,) = summands_of(term.product / logarithm)
                rest = Summand(term.number * rest.number, rest.product, rest.key)
            for part, times in own:
                result = result * self.power(part, times, rest)
        return result

    def power(self, base: Formula, times: Fraction, term: Summand) -> Formula:
        """A base that is not split any more, to so many times a term."""
        size = times * term.number
        if term.product == ONE:
            return base ** Number(size) if base != EULER else Call("exp", (Number(size),))
        key = (base_key(base), term.key)
        letter = self.letters.setdefault(key, Symbol(f"#p{len(self.letters)}"))
        self.meaning[letter.name] = (base, term.product)
        parts = self.parts[letter.name] = lcm(self.parts.get(letter.name, 1), size.denominator)
        return letter ** Number(size * parts)

    def split(self, base: Formula) -> list[tuple[Formula, Fraction]]:
        """What a positive base is a product of, with the powers: primes, irreducible polynomials, and what roots and letters stand for."""
        found: list[tuple[Formula, Fraction]] = []
        for factor, times in irreducible(base):
            if isinstance(factor, Call) and factor.function == "sqrt":
                found += [(inner, power * times / 2) for inner, power in self.split(factor.arguments[0])]
            else:
                found.append((factor, times))
        return found

    def logarithm(self, argument: Formula) -> Formula:
        """A logarithm as the sum of those of what its argument is a product of."""
        terms = []
        for factor, times in self.split(argument):
            if isinstance(factor, Symbol) and factor.name in self.meaning:
                base, exponent = self.meaning[factor.name]
                inner = ONE if base == EULER else self.logarithm(base)
                terms.append(Number(times / self.parts[factor.name]) * exponent * inner)
            elif factor == EULER:
                terms.append(Number(times))
            else:
                terms.append(Number(times) * Call("log", (canonical(factor),)))
        return total(terms) if terms else ZERO


def in_letters_for_powers(left: Formula, right: Formula) -> tuple[Formula, Formula, frozenset[str]] | None:
    """Both formulas with letters for powers, and these, all of which are positive; None where nothing is raised to letters in them.

    They are rewritten twice, since it is seen in the first run into how many parts an exponent falls: x^(n/2) and x^n.
    """
    if not any(is_raised(node) for side in (left, right) for node in side.walk(Power, Call)):
        return None
    powers = Raised()
    for _ in range(2):
        sides = [powers.plain(side) for side in (left, right)]
    return sides[0], sides[1], frozenset(powers.meaning)


def is_raised(node: Formula) -> bool:
    return (isinstance(node, Power) and not isinstance(node.exponent, Number)) or (
        isinstance(node, Call) and node.function in ("exp", "log")
    )


def is_logarithm(node: Formula) -> bool:
    return isinstance(node, Call) and node.function == "log"


def factors_in(product: Formula) -> tuple[Formula, ...]:
    return product.factors if isinstance(product, Product) else (product,)


def summands_of(formula: Formula) -> Iterator[Summand]:
    """The terms of a formula, each a number times a product over one denominator."""
    field = Field([formula])
    above, below = field.cancel(field.convert(formula))
    if len(above) + len(below) > MOST_TERMS:
        raise ValueError("too many terms")
    under = field.terms(below)
    size, low = normalised(field, under)
    under_key = tuple(sorted((monomial_key(field, place), number / size) for place, number in under.items()))
    for place, number in field.terms(above).items():
        product = at_powers(field, place)
        yield Summand(
            Fraction(number) / size, product / low if low != ONE else product, (monomial_key(field, place), under_key)
        )


def normalised(field: Field, terms: Mapping[tuple[int, ...], int]) -> tuple[Fraction, Formula]:
    """A number and a polynomial: the terms are so many times the polynomial, whose first term (in an order of its own) has no factor."""
    first = min(terms, key=lambda place: monomial_key(field, place))
    size = Fraction(terms[first])
    parts = [Number(Fraction(number) / size) * at_powers(field, place) for place, number in terms.items()]
    return size, parts[0] if len(parts) == 1 else Sum(tuple(parts))


def at_powers(field: Field, place: tuple[int, ...]) -> Formula:
    result: Formula = ONE
    for atom, power in zip(field.atoms, place, strict=True):
        if power:
            result = result * atom**power
    return result


def monomial_key(field: Field, place: tuple[int, ...]) -> Key:
    return tuple(sorted((repr(atom), power) for atom, power in zip(field.atoms, place, strict=True) if power))


def irreducible(base: Formula) -> Iterator[tuple[Formula, Fraction]]:
    """The primes and irreducible polynomials of a rational formula, all taken as positive, with their powers."""
    field = Field([base])
    for poly, sign in zip(field.cancel(field.convert(base)), (1, -1), strict=True):
        if len(poly) > MOST_TERMS:
            raise ValueError("too many terms")
        number, parts = field.factor(poly)
        yield from ((Number(Fraction(prime)), Fraction(sign * times)) for prime, times in primes(abs(number)))
        for part, times in parts:
            size, formula = normalised(field, field.terms(part))
            yield formula, Fraction(sign * times)
            for whole, direction in ((abs(size.numerator), 1), (size.denominator, -1)):
                found = ((Number(Fraction(prime)), more) for prime, more in primes(whole))
                yield from ((prime, Fraction(sign * direction * times * more)) for prime, more in found)


def primes(number: int) -> Iterator[tuple[int, int]]:
    """The primes of a number with their powers; what is left of large ones as it is."""
    prime = 2
    while number > 1 and prime <= LARGEST_PRIME:
        times = 0
        while number % prime == 0:
            number, times = number // prime, times + 1
        if times:
            yield prime, times
        prime += 1
    if number > 1:
        yield number, 1


def canonical(factor: Formula) -> Formula:
    """A factor in an order that hangs on nothing but itself."""
    return Sum(tuple(sorted(factor.terms, key=repr))) if isinstance(factor, Sum) else factor


def base_key(base: Formula) -> Key:
    return (repr(canonical(base)),)
