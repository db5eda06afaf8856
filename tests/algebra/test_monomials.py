"""Sums as monomials in whole numbers: they factor as FLINT factors them, and long sums are written no longer than term by term."""

from __future__ import annotations

import random
from math import prod

import pytest

from rotsolve.algebra.exact.field import Field, Poly
from rotsolve.algebra.exact.grouping import HALF, Monomials
from rotsolve.algebra.exact.normal import equal, simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import Symbol
from rotsolve.algebra.notation.text import to_text

LETTERS = [Symbol(letter) for letter in "abcdef"]


def made(ring: Field, random_: random.Random) -> Poly:
    """A product of one to three sums of two or three terms, in all powers up to the second."""

    def one() -> Poly:
        letters, highest = random_.sample(range(6), 3), random_.choice([1, 2])
        terms = (
            random_.choice([1, 1, -1, 2, -3])
            * prod((ring.gens[i] ** random_.choice([0, 1, highest]) for i in letters[:2]), start=ring.one)
            for _ in range(random_.choice([2, 3]))
        )
        return sum(terms, start=ring.zero)

    return prod((one() for _ in range(random_.choice([1, 1, 2, 3]))), start=ring.one)


@pytest.mark.parametrize("seed", range(5))
def test_sums_factor_as_flint_factors_them(seed: int) -> None:
    random_ = random.Random(seed)
    ring = Field(LETTERS)
    monomials = Monomials(ring)
    seen = 0
    for _ in range(300):
        poly = made(ring, random_)
        if len(poly) < 2:
            continue
        number, monomial, sums = monomials.factored(monomials.packed(ring.terms(poly)))
        whole = ring.poly({monomials.exponents(monomial): number})
        for packed, e in sums:
            whole = whole * ring.poly(monomials.terms(packed)) ** e
        assert whole == poly
        _, factors = poly.factor()
        expected = sorted((len(factor), e) for factor, e in factors if len(factor) > 1)
        assert sorted((len(packed), e) for packed, e in sums) == expected
        assert sorted((len(factor), e) for factor, e in ring.factor(poly)[1] if len(factor) > 1) == expected
        seen += 1
    assert seen > 200


def test_exponents_beyond_a_byte_are_not_packed() -> None:
    ring = Field(LETTERS)
    monomials = Monomials(ring)
    assert monomials.packed(ring.terms(ring.gens[0] ** (HALF + 1) + ring.gens[1])) == ()
    packed = monomials.packed(ring.terms(ring.gens[0] ** HALF + ring.gens[1]))
    assert monomials.terms(packed) == ring.terms(ring.gens[0] ** HALF + ring.gens[1])


@pytest.mark.parametrize("seed", range(3))
def test_a_long_sum_is_written_no_longer_than_term_by_term_and_is_equal(seed: int) -> None:
    random_ = random.Random(100 + seed)
    ring = Field(LETTERS)
    for _ in range(40):
        poly = made(ring, random_) + made(ring, random_)
        if not len(poly):
            continue
        plain = sum(
            (
                c * prod((letter**e for letter, e in zip(ring.atoms, exponents, strict=True) if e), start=Symbol("one"))
                for exponents, c in ring.terms(poly).items()
            ),
            start=Symbol("zero"),
        ).substitute({"one": simplify(Symbol("a") / Symbol("a")), "zero": simplify(Symbol("a") - Symbol("a"))})
        shown = simplify(plain)
        assert equal(shown, plain), to_text(shown)
        assert length(shown) <= length(plain), to_text(shown)
