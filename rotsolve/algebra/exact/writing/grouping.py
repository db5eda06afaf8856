"""Grouping: how a long sum is taken apart as a textbook does, by the powers of one letter: told from its monomials before it is written."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import Struct

from rotsolve.algebra.exact.field import Field, Terms
from rotsolve.algebra.exact.writing.length import length
from rotsolve.algebra.exact.writing.monomials import BYTE, FULL, Monomials, Packed
from rotsolve.algebra.exact.writing.order import Order

FEWEST, MOST = 4, 24  # terms of a sum that is worth grouping
TRIED = (4, 1)  # ways to group a long sum that are measured, and a sum in it; to nest deeper has no end

Group = list[tuple[int, int]]  # some terms of a sum


class Piece(Struct, frozen=True):
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


class Plan(Struct, frozen=True):
    """How a sum is written: with so many nodes, in these groups; none where term by term."""

    nodes: int
    pieces: Sequence[Piece] = ()


class Grouping:
    """Takes the long sums of one field apart, and remembers what it has found."""

    def __init__(self, ring: Field, order: Order) -> None:
        self.monomials = Monomials(ring)
        self.order = order
        self.nodes = [length(atom) for atom in ring.atoms]
        self.terms: dict[int, tuple[int, int, int]] = {}
        self.pieces: dict[Packed, Piece] = {}
        self.plans: dict[tuple[int, Packed], Plan] = {}

    def groups(self, terms: Terms, depth: int) -> Sequence[Piece]:
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

    def _size(self, piece: Piece, depth: int) -> int:
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

    def _sizes(self, pieces: Sequence[Piece], depth: int) -> int:
        return 1 + sum([self._size(piece, depth) for piece in pieces])

    # which groups

    def _plan(self, packed: Packed, depth: int) -> Plan:
        """In groups where that is much shorter than term by term, or two brackets: m₂ (u − v) − m₁ (u + v)."""
        key = depth, packed
        plan = self.plans.get(key)
        if plan is None:
            plan = self.plans[key] = self._planned(packed, depth)
        return plan

    def _planned(self, packed: Packed, depth: int) -> Plan:
        plain = least = self._plain(packed)
        if depth == len(TRIED) or not FEWEST <= len(packed) <= MOST:
            return Plan(plain)
        best = list[Piece]()
        for groups in sorted(self._ways(packed), key=self._reading)[: TRIED[depth]]:
            pieces = [self._piece(tuple(group)) for group in groups]
            size = self._sizes(pieces, depth + 1)
            pair = len(pieces) == 2 and all(len(piece.group) > 1 and not piece.is_sum for piece in pieces)
            if size < least and (pair or 5 * size <= 4 * plain):
                least, best = size, pieces
        if not best:
            return Plan(plain)
        best = self._merged(sorted(best, key=self._place), packed, depth + 1)
        return Plan(self._sizes(best, depth + 1), best)

    def _place(self, piece: Piece) -> tuple[object, ...]:
        """Where a group stands: with the first of its terms."""
        return min(self.order.key(self.monomials.exponents(m)) for m, _ in piece.group)

    def _merged(self, pieces: list[Piece], packed: Packed, depth: int) -> list[Piece]:
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
        every = 0
        for mask in masks:
            every |= mask
        for k, _ in self.monomials.held(every):
            for groups in (_by_powers(packed, BYTE * k), _components(packed, masks, ~(FULL << BYTE * k))):
                if 1 < len(groups) < len(packed):
                    yield groups

    def _reading(self, groups: list[Group]) -> int:
        """How many letters there are to read in some groups once they are factored."""
        return sum([self._letters(group) for group in groups])

    def _letters(self, group: Group) -> int:
        """The letters of a group, which is factored only where it may have more factors than what its terms have in common."""
        if len(group) == 1:
            return 2 * self._term(group[0][0])[1]
        monomials = [m for m, _ in group]
        if not self.monomials.is_prime(monomials):
            return self._piece(tuple(group)).letters
        _, count, degree = self._term(self.monomials.common(monomials))
        return 2 * count + sum([self._term(m)[2] for m in monomials]) + (1 - degree) * len(group)

    def _piece(self, packed: Packed) -> Piece:
        """A group in factors."""
        if packed not in self.pieces:
            number, monomial, sums = self.monomials.factored(packed)
            degrees = [1 + self._term(m)[2] for one, _ in sums for m, _ in one]
            self.pieces[packed] = Piece(packed, number, monomial, sums, 2 * self._term(monomial)[1] + sum(degrees))
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
