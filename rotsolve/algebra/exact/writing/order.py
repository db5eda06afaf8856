"""Order: where factors stand in a product and terms in a sum, as a textbook has them."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import lru_cache

from rotsolve.algebra.exact.field import Field, Poly, Terms
from rotsolve.algebra.formula import Call, Constant, Formula, Negative, Symbol

Rank = tuple[int, int, str, str]
SPELT = 4096  # letters whose place is remembered
LAST = {"sin": 1, "cos": 2, "tan": 3}  # the order of functions of one argument


class Order:
    """The order of one field's atoms and terms, symbols in the given order; `radicands` are what stands under its roots."""

    def __init__(self, ring: Field, names: Sequence[str], radicands: Mapping[int, Poly]) -> None:
        self.field = ring
        self.radicands = radicands
        places = {name: k for k, name in enumerate(names)}
        self.ranks: list[Rank] = [rank_of(atom, places) for atom in ring.atoms]
        order = {rank: place for place, rank in enumerate(sorted(set(self.ranks)))}
        self.places = [order[rank] for rank in self.ranks]
        self.keys: dict[tuple[int, ...], tuple[object, ...]] = {}

    def has_root(self, exponents: tuple[int, ...]) -> bool:
        """Whether a term holds the root of a letter."""
        return any(exponents[i] for i, radicand in self.radicands.items() if not radicand.is_constant())

    def key(self, exponents: tuple[int, ...]) -> tuple[object, ...]:
        """Where a term stands in a sum: roots last, few letters before many."""
        if exponents not in self.keys:
            self.keys[exponents] = self._key(exponents)
        return self.keys[exponents]

    def _key(self, exponents: tuple[int, ...]) -> tuple[object, ...]:
        symbols = calls = 0
        places: list[int] = []
        for i, e in enumerate(exponents):
            if e:
                places += [self.places[i]] * e
                kind = self.ranks[i][0]
                if kind == 1:
                    symbols += e
                elif kind > 1:
                    calls += e
        return (self.has_root(exponents), symbols, calls, sorted(places))

    def leads_negative(self, terms: Terms) -> bool:
        """Whether the term that stands first by order has a minus."""
        return terms[min(terms, key=self.key)] < 0


def rank_of(atom: Formula, places: dict[str, int]) -> Rank:
    """Where an atom stands in a product: symbols, then functions, then roots."""
    if isinstance(atom, Constant):
        return (0, 0, "", "")
    if isinstance(atom, Symbol):
        return (1, places.get(atom.name, len(places)), *spelt(atom.name))
    if isinstance(atom, Call):
        kind = {"ellipk": 6, "log": 6, "sqrt": 5, "exp": 4}.get(atom.function, 3)
        names = sorted(atom.symbols(), key=lambda name: (places.get(name, len(places)), name))
        first = places.get(names[0], len(places)) if names else 0
        return (kind, first, " ".join(names), f"{atom.arguments}{LAST.get(atom.function, '')}")
    return (2, 0, "", repr(atom))


@lru_cache(SPELT)
def spelt(name: str) -> tuple[str, str]:
    """The places of a letter in the alphabet, small letters and large ones together: m10 after m9."""
    filled = re.sub(r"\d+", lambda found: found[0].zfill(4), name)
    return filled.lower(), filled.swapcase()


def late(term: Formula) -> tuple[bool, bool]:
    """Where a written term stands in a sum: minus signs behind plus, and among these roots behind the others."""
    return isinstance(term, Negative), term.holds("sqrt")
