"""Grouping: sums taken apart as a textbook does: by the powers of one letter, and what is whole split off from a fraction."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction

from rotsolve.algebra.exact.field import Field, Poly

FEWEST, MOST = 4, 24  # terms of a sum that is worth grouping


def groupings(field: Field, poly: Poly) -> Iterator[list[Poly]]:
    """The ways to take a sum apart by the powers of one of its letters, or into parts that share no letter but that one."""
    if not FEWEST <= len(poly) <= MOST:
        return
    for i, degree in enumerate(poly.degrees()):
        if degree:
            for groups in (by_powers(field, poly, i), components(field, poly, i)):
                if 1 < len(groups) < len(poly):
                    yield groups


def shortest(field: Field, ways: Iterable[list[Poly]], number: int) -> list[list[Poly]]:
    """Those few of many groupings that have the fewest letters once their groups are factored."""

    def letters(poly: Poly) -> int:
        return sum(1 + sum(exponents) for _, exponents in field.terms(poly))

    def size(groups: list[Poly]) -> int:
        return sum(letters(factor) for group in groups for factor, _ in field.factor(group)[1])

    return sorted(ways, key=size)[:number]


def components(field: Field, poly: Poly, i: int) -> list[Poly]:
    """The parts of a sum that share no letter but generator i: u² − 2 u v x + v² x² apart from w²."""
    found: list[tuple[set[int], Poly]] = []
    for term in singles(field, poly):
        letters = {k for k, e in enumerate(term.degrees()) if e and k != i}
        apart = []
        for others, part in found:
            if letters & others:
                letters, term = letters | others, term + part
            else:
                apart.append((others, part))
        found = [*apart, (letters, term)]
    return [part for _, part in found]


def by_powers(field: Field, poly: Poly, i: int) -> list[Poly]:
    """The parts of a sum with each power of generator i."""
    return [part * field.gens[i] ** k for k, part in enumerate(field.coefficients(poly, i)) if len(part)]


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
    if not whole or len(whole) == len(single) or len(single) > FEWEST:
        return [top]
    return [*whole, top - sum(whole[1:], whole[0])]


def singles(field: Field, poly: Poly) -> list[Poly]:
    """The terms of a sum."""
    return [field.context.from_dict({exponents: coefficient}) for exponents, coefficient in poly.to_dict().items()]


def divided(poly: Poly, below: Sequence[tuple[Poly, int]]) -> Poly | None:
    """A polynomial divided by a product, None where that leaves a rest."""
    for factor, e in below:
        for _ in range(e):
            poly, rest = divmod(poly, factor)
            if len(rest):
                return None
    return poly
