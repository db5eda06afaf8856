"""Grouping: how a long sum is taken apart as a textbook does, by the powers of one letter: told from its monomials before it is written."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import reduce
from math import gcd
from operator import or_

from msgspec import Struct

from rotsolve.algebra.effort import exert
from rotsolve.algebra.exact.field import Field, Terms
from rotsolve.algebra.exact.order import FEWEST, MOST, TRIED, Order, length

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
        every = reduce(or_, monomials)
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
                common &= self.mask(reduce(or_, [m for m, _ in part]))
            if common | outside == FULL * self.ones:
                return {m: tuple(part) for m, part in found.items()}
            outside = FULL * self.ones & ~common


Group = list[tuple[int, int]]  # some terms of a sum


class FactoredGroup(Struct, frozen=True):
    """A group in factors: number · monomial · sums^powers, and how many letters there are to read in them."""

    group: Packed
    number: int
    monomial: int
    sums: tuple[tuple[Packed, int], ...]
    letters: int

    @property
    def is_sum(self) -> bool:
        """Whether it is one bare sum, which runs on in the sum that it is a group of."""
        return abs(self.number) == 1 and not self.monomial and len(self.sums) == 1 and self.sums[0][1] == 1


class SumPlan(Struct, frozen=True):
    """How a sum is written: with so many nodes, in these groups; none where term by term."""

    nodes: int
    pieces: Sequence[FactoredGroup] = ()


class Grouping:
    """Takes the long sums of one field apart, and remembers what it has found."""

    def __init__(self, ring: Field, order: Order) -> None:
        self.monomials = Monomials(ring)
        self.order = order
        self.nodes = [length(atom) for atom in ring.atoms]
        self.terms: dict[int, tuple[int, int, int]] = {}
        self.pieces: dict[Packed, FactoredGroup] = {}
        self.plans: dict[tuple[int, Packed], SumPlan] = {}

    def groups(self, terms: Terms, depth: int) -> Sequence[FactoredGroup]:
        """The groups of a long sum, in factors and in their order; none where it reads as well term by term."""
        if not FEWEST <= len(terms) <= MOST or depth >= len(TRIED):
            return ()
        packed = self.monomials.packed(terms)
        return self._plan(packed, depth).pieces if packed else ()

    # how many nodes `Shaper` writes

    def _term(self, monomial: int) -> tuple[int, int, int]:
        """Of a monomial: the nodes of its factors, how many factors they are, and its degree."""
        found = self.terms.get(monomial)
        if found is None:
            held = self.monomials.held(monomial)
            nodes = sum([self.nodes[self.monomials.letters[k]] + 2 * (e > 1) for k, e in held])
            found = self.terms[monomial] = nodes, len(held), sum([e for _, e in held])
        return found

    def _plain(self, packed: Packed) -> int:
        """The nodes of a sum written term by term."""
        whole = 1 if len(packed) > 1 else 0
        for monomial, c in packed:
            nodes, factors, _ = self._term(monomial)
            number = c not in (1, -1) or not factors
            whole += nodes + number + (factors + number > 1) + (c < 0 < factors)
        return whole

    def _size(self, piece: FactoredGroup, depth: int) -> int:
        """The nodes of a group, whose brackets stand so deep; those of its terms where it runs on in the sum round it."""
        nodes, factors, _ = self._term(piece.monomial)
        if piece.number not in (1, -1):
            nodes, factors = nodes + 1, factors + 1
        minus = piece.number < 0
        for packed, e in piece.sums:
            if minus and e % 2 and len({c > 0 for _, c in packed}) == 2:
                packed, minus = tuple([(m, -c) for m, c in packed]), False
            nodes += self._plan(packed, depth).nodes + 2 * (e > 1)
            factors += 1
        return nodes - 1 if piece.is_sum else nodes + (factors > 1) + minus

    def _sizes(self, pieces: Sequence[FactoredGroup], depth: int) -> int:
        return 1 + sum([self._size(piece, depth) for piece in pieces])

    # which groups

    def _plan(self, packed: Packed, depth: int) -> SumPlan:
        """In groups where that is much shorter than term by term, or two brackets: m₂ (u − v) − m₁ (u + v)."""
        key = depth, packed
        plan = self.plans.get(key)
        if plan is None:
            plan = self.plans[key] = self._planned(packed, depth)
        return plan

    def _planned(self, packed: Packed, depth: int) -> SumPlan:
        plain = least = self._plain(packed)
        if depth == len(TRIED) or not FEWEST <= len(packed) <= MOST:
            return SumPlan(plain)
        exert(1)
        best = list[FactoredGroup]()
        for groups in sorted(self._ways(packed), key=lambda groups: sum(map(self._letters, groups)))[: TRIED[depth]]:
            pieces = [self._piece(tuple(group)) for group in groups]
            size = self._sizes(pieces, depth + 1)
            pair = len(pieces) == 2 and all(len(piece.group) > 1 and not piece.is_sum for piece in pieces)
            if size < least and (pair or 5 * size <= 4 * plain):
                least, best = size, pieces
        if not best:
            return SumPlan(plain)
        best = self._merged(sorted(best, key=self._place), packed, depth + 1)
        return SumPlan(self._sizes(best, depth + 1), best)

    def _place(self, piece: FactoredGroup) -> tuple[object, ...]:
        """Where a group stands: with the first of its terms."""
        return min(self.order.key(self.monomials.exponents(m)) for m, _ in piece.group)

    def _merged(self, pieces: list[FactoredGroup], packed: Packed, depth: int) -> list[FactoredGroup]:
        """The groups with two of them put together where that makes a product: 2 m u − 2 m v is 2 m (u − v)."""
        for k, one in enumerate(pieces if len(pieces) > 2 else ()):
            for other in pieces[k + 1 :]:
                both = self._piece(tuple([term for term in packed if term in one.group or term in other.group]))
                if not both.is_sum and self._size(both, depth) <= self._size(one, depth) + self._size(other, depth):
                    rest = [both if piece is one else piece for piece in pieces if piece is not other]
                    return self._merged(rest, packed, depth)
        return pieces

    def _ways(self, packed: Packed) -> Iterator[list[Group]]:
        """The ways to take a sum apart by the powers of one of its letters, or into parts that share no letter but that one."""
        masks = [self.monomials.mask(m) for m, _ in packed]
        every = reduce(or_, masks)
        for k, _ in self.monomials.held(every):
            for groups in (_by_powers(packed, BYTE * k), _components(packed, masks, ~(FULL << BYTE * k))):
                if 1 < len(groups) < len(packed):
                    yield groups

    def _letters(self, group: Group) -> int:
        """The letters of a group, which is factored only where it may have more factors than what its terms have in common."""
        if len(group) == 1:
            return 2 * self._term(group[0][0])[1]
        monomials = [m for m, _ in group]
        if not self.monomials.is_prime(monomials):
            return self._piece(tuple(group)).letters
        _, count, degree = self._term(self.monomials.common(monomials))
        return 2 * count + sum([self._term(m)[2] for m in monomials]) + (1 - degree) * len(group)

    def _piece(self, packed: Packed) -> FactoredGroup:
        """A group in factors."""
        if packed not in self.pieces:
            number, monomial, sums = self.monomials.factored(packed)
            degrees = [1 + self._term(m)[2] for one, _ in sums for m, _ in one]
            self.pieces[packed] = FactoredGroup(
                packed, number, monomial, sums, 2 * self._term(monomial)[1] + sum(degrees)
            )
        return self.pieces[packed]


def _by_powers(packed: Packed, shift: int) -> list[Group]:
    """The terms with each power of a letter."""
    found: dict[int, list[tuple[int, int]]] = {}
    for term in packed:
        found.setdefault((term[0] >> shift) & FULL, []).append(term)
    return list(found.values())


def _components(packed: Packed, masks: Sequence[int], others: int) -> list[Group]:
    """The terms in parts that share none of the `others`, which are all letters but one: u² − 2 u v x + v² x² apart from w²."""
    unions = list[int]()
    for mask in masks:
        union, apart = mask & others, list[int]()
        for one in unions:
            if one & union:
                union |= one
            else:
                apart.append(one)
        unions = [*apart, union]
    if len(unions) == 1:
        return [list(packed)]
    found: dict[int, list[tuple[int, int]]] = {}
    for term, mask in zip(packed, masks, strict=True):
        held = mask & others
        found.setdefault(next((k for k, union in enumerate(unions) if held & union), -1), []).append(term)
    return list(found.values())
