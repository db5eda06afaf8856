"""Splitting: what is whole split off from a fraction: (M a + 2 b)/M is a + 2 b/M."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from rotsolve.algebra.exact.field import Field, Poly

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
