"""Monomials: sums whose monomials are whole numbers, a byte for each letter's exponent, and their factors.

To take a letter out of a term is one subtraction then, and what two terms share one `&`.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import gcd

from rotsolve.algebra.exact.field import Field, Terms

BYTE, FULL = 8, 255  # bits, and the number that has them all
HALF = 127  # the highest exponent that is packed, so that a byte plus this does not run over

Packed = tuple[tuple[int, int], ...]  # monomials and coefficients
Factors = tuple[tuple[Packed, int], ...]


class Monomials:
    """The letters of one field that occur in its long sums, each with its byte."""

    def __init__(self, ring: Field) -> None:
        self.field = ring
        self.letters: list[int] = []  # their generators, in the order of their bytes
        self.ones = 0  # a 1 in every byte
        self.masks: dict[int, int] = {}

    def packed(self, terms: Terms) -> Packed:
        """A sum; empty where an exponent is too high."""
        monomials = [0] * len(terms)
        for i, column in enumerate(zip(*terms, strict=True)):
            if any(column):
                if max(column) > HALF:
                    return ()
                if i not in self.letters:
                    self.ones |= 1 << BYTE * len(self.letters)
                    self.letters.append(i)
                shift = BYTE * self.letters.index(i)
                monomials = [m | e << shift for m, e in zip(monomials, column, strict=True)]
        return tuple(zip(monomials, terms.values(), strict=True))

    def terms(self, packed: Packed) -> Terms:
        """A sum with the exponents of all generators of the field."""
        return {self.exponents(m): c for m, c in packed}

    def exponents(self, monomial: int) -> tuple[int, ...]:
        """The exponents of all generators of the field."""
        found = [0] * len(self.field.atoms)
        for k, e in self.held(monomial):
            found[self.letters[k]] = e
        return tuple(found)

    @staticmethod
    def held(monomial: int) -> list[tuple[int, int]]:
        """The letters of a monomial, each by the place of its byte, with its exponent."""
        return [(k, e) for k, e in enumerate(monomial.to_bytes((monomial.bit_length() + 7) // BYTE, "little")) if e]

    def mask(self, monomial: int) -> int:
        """All bits of the bytes of a monomial's letters."""
        found = self.masks.get(monomial)
        if found is None:
            found = self.masks[monomial] = (((monomial + HALF * self.ones) >> (BYTE - 1)) & self.ones) * FULL
        return found

    def common(self, monomials: Sequence[int]) -> int:
        """The greatest monomial that goes into all of some."""
        held = FULL * self.ones
        for m in monomials:
            held &= self.mask(m)
        found = 0
        for k, _ in self.held(held) if held else ():
            found |= min([(m >> BYTE * k) & FULL for m in monomials]) << BYTE * k
        return found

    def factored(self, packed: Packed) -> tuple[int, int, Factors]:
        """Number, monomial and irreducible sums of which a sum is the product."""
        number, monomial, rest = self._primitive(packed)
        sign, sums = self._split(rest) if len(rest) > 1 else (1, ())
        return sign * number, monomial, sums

    def _split(self, rest: Packed) -> tuple[int, Factors]:
        """The sign and the irreducible factors of a sum whose terms have nothing in common.

        A factor that does not hold the letter x of x a + b divides a and b, hence what each monomial of the other letters is
        multiplied by. Where all these agree they are that factor; where one is a single term, or two are different primes,
        there is none.
        """
        monomials = [m for m, _ in rest]
        if self.is_prime(monomials):
            return 1, ((rest, 1),)
        every = 0
        for m in monomials:
            every |= m
        for k, _ in self.held(self._linear(every)):
            parts = [(m, *self._primitive(part)) for m, part in self._parts(rest, FULL << BYTE * k).items()]
            found = {part for *_, part in parts}
            if len(found) == 1 and len(parts[0][-1]) > 1:
                sign, others = self._split(found.pop())
                return sign, ((tuple([(m + common, number) for m, number, common, _ in parts]), 1), *others)
            primes = [part for part in found if len(part) == 1 or self.is_prime([m for m, _ in part])]
            if len(primes) > 1 or any(len(part) == 1 for part in primes):
                return 1, ((rest, 1),)
        number, factors = self.field.factor(self.field.poly(self.terms(rest)))
        return number, tuple([(self.packed(self.field.terms(poly)), e) for poly, e in factors])

    def _primitive(self, packed: Packed) -> tuple[int, int, Packed]:
        """The number and the monomial that go into all terms of a sum, and the rest."""
        common = self.common([m for m, _ in packed])
        number = gcd(*[c for _, c in packed]) * (1 if packed[0][1] > 0 else -1)
        return number, common, tuple([(m - common, c // number) for m, c in packed])

    def _linear(self, every: int) -> int:
        """A 1 in the byte of each letter of a union of monomials that none of them holds to a higher power."""
        return every & self.ones & ~self.mask(every & ~self.ones)

    def is_prime(self, monomials: Sequence[int]) -> bool:
        """Whether a sum shows at once to have no factors but what its terms have in common: x a + b where a or b is a single term.

        Of all letters x at once: those that one term alone holds, and those that one term alone does not hold.
        """
        held = held_twice = bare = bare_twice = 0
        for m in monomials:
            held_twice |= held & m
            held |= m
            bare_twice |= bare & ~m
            bare |= ~m
        return (held & ~held_twice | bare & ~bare_twice) & self._linear(held) != 0

    def _parts(self, rest: Packed, outside: int) -> dict[int, Packed]:
        """What each monomial of letters outside a factor is multiplied by; more and more letters turn out to stand outside."""
        while True:
            found: dict[int, list[tuple[int, int]]] = {}
            for m, c in rest:
                found.setdefault(m & outside, []).append((m & ~outside, c))
            common = FULL * self.ones
            for part in found.values():
                held = 0
                for m, _ in part:
                    held |= m
                common &= self.mask(held)
            if common | outside == FULL * self.ones:
                return {m: tuple(part) for m, part in found.items()}
            outside = FULL * self.ones & ~common
