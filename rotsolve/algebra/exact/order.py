"""Order: where factors stand in a product and terms in a sum, as a textbook has them; products put together, and their length."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from math import isqrt
from operator import itemgetter

from rotsolve.algebra.exact.field import Field, Poly, Terms
from rotsolve.algebra.formula import (
    ELLIPTIC,
    ONE,
    PI,
    Call,
    Constant,
    Formula,
    Negative,
    Number,
    Power,
    Product,
    Sum,
    Symbol,
    call,
    divide,
    multiply,
    negate,
    total,
)
from rotsolve.algebra.notation.letters import GLYPHS

LENGTH = "length"  # under this name a formula keeps its length


FEWEST, MOST = 4, 24  # terms of a sum that is worth grouping
TRIED = (4, 1)  # ways to group a long sum that are measured, and a sum in it; to nest deeper has no end
LINE = 45  # nodes of a formula that is about a line long


def length(node: Formula) -> int:
    """How long a formula is to read: its number of nodes."""
    known: int | None = node.__dict__.get(LENGTH)
    if known is not None:
        return known
    count, waiting = 0, [node]
    while waiting:
        count += 1
        waiting.extend(waiting.pop().children())
    node.__dict__[LENGTH] = count
    return count


Rank = tuple[int, int, str, str]
SPELT = 4096  # letters whose place is remembered
LAST = {"sin": 1, "cos": 2, "tan": 3}  # the order of functions of one argument


class Order:
    """The order of one field's atoms and terms, symbols in the given order; `roots` are its atoms that are roots of letters."""

    def __init__(self, ring: Field, names: Sequence[str], radicands: Mapping[int, Poly]) -> None:
        self.field = ring
        self.roots = [i for i, radicand in radicands.items() if not radicand.is_constant()]
        places = {name: k for k, name in enumerate(names)}
        self.ranks: list[Rank] = [rank_of(atom, places) for atom in ring.atoms]
        order = {rank: place for place, rank in enumerate(sorted(set(self.ranks)))}
        self.places = [order[rank] for rank in self.ranks]
        self.keys: dict[tuple[int, ...], tuple[object, ...]] = {}

    def has_root(self, exponents: tuple[int, ...]) -> bool:
        """Whether a term holds the root of a letter."""
        return any(exponents[i] for i in self.roots)

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
        kind = {"log": 6, "sqrt": 5, "exp": 4, **dict.fromkeys(ELLIPTIC, 6)}.get(atom.function, 3)
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


Item = tuple[Rank, Formula, int]  # base ^ exponent and where it stands
_RANK = itemgetter(0)


def square_part(n: int) -> tuple[int, int]:
    """(s, r) with n = s² r; r is free of small squares."""
    outside, p = 1, 2
    while p * p <= n and p < 2000:
        while n % (p * p) == 0:
            n, outside = n // (p * p), outside * p
        p += 1 if p == 2 else 2
    whole = isqrt(n)
    return (outside * whole, 1) if whole * whole == n else (outside, n)


def share_number(number: Fraction, root: int, symbols: bool) -> tuple[Fraction, Fraction]:
    """number · √root split into what stands before the root and what stands under it."""
    if root != 1 or symbols:
        out, root = square_part(root)
        number *= out
    if not symbols:
        return number, Fraction(root)
    if number.denominator == 1:
        return number, Fraction(root)
    under = Fraction(root, number.denominator**2)
    out, rest = square_part(under.denominator)
    return Fraction(number.numerator, out), Fraction(under.numerator, rest)


def assembled(number: Fraction, root: int, outer: list[Item], inner: list[Item]) -> Formula:
    """number · √root · outer · √inner."""
    sign, number = (-1, -number) if number < 0 else (1, number)
    number, under = share_number(number, root, bool(inner))
    turns = next((e for _, base, e in outer if base == PI), 0)
    if inner and number == 1 and under != 1 and abs(turns) == 1:  # a period is 2 π √(…), a frequency √(…)/(2 π)
        number, under = number * Fraction(2) ** turns, under / Fraction(4) ** turns
    inside = written_fraction(under, inner, rooted=True) if inner or under != 1 else ONE
    above = [(rank, base, e) for rank, base, e in outer if e > 0]
    below = [(rank, base, -e) for rank, base, e in outer if e < 0]
    if inner and all(e < 0 for _, _, e in inner) and under == 1:
        upright = written_fraction(under, [(r, b, -e) for r, b, e in inner], rooted=True)
        below.append(((5, 0, "", ""), call("sqrt", upright), 1))
    elif inside != ONE:
        above.append(((5 if inner else -1, 0, "", ""), call("sqrt", inside), 1))
    result = written_fraction(number, above + [(r, b, -e) for r, b, e in below])
    return negate(result) if sign < 0 else result


def written_term(number: int, items: list[Item]) -> Formula:
    """A whole number times powers of letters."""
    whole = Number(Fraction(number)) if number != 1 else ONE
    return _times(whole, _assembled_product(items))


def written_fraction(number: Fraction, items: list[Item], *, rooted: bool = False) -> Formula:
    """number · base^power · …, negative powers below the line; ½, ⅖, 1/12 in front if nothing else is below (no root)."""
    above = _assembled_product([item for item in items if item[2] > 0])
    below = _assembled_product([(rank, base, -e) for rank, base, e in items if e < 0])
    p, q = number.numerator, number.denominator
    leads = not rooted and (p == 1 or number in GLYPHS)
    if below == ONE and above != ONE and leads and (isinstance(above, Sum) or above.symbols()):
        return _times(Number(number), above)
    return divide(_times(Number(Fraction(p)), above), _times(Number(Fraction(q)), below))


def _times(number: Number, rest: Formula) -> Formula:
    """number · rest, a bracket kept as a bracket."""
    if number.value == 1 or isinstance(rest, Number):
        return multiply(number, rest)
    return Product((number, *(rest.factors if isinstance(rest, Product) else (rest,))))


def _assembled_product(items: list[Item]) -> Formula:
    if len(items) > 1:
        items = sorted(items, key=_RANK)
    factors = tuple([base if e == 1 else Power(base, Number(Fraction(e))) for _, base, e in items])
    if not factors:
        return ONE
    return factors[0] if len(factors) == 1 else Product(factors)


def one_exponential(items: list[Item]) -> list[Item]:
    """All exponentials of a product as one."""
    found = [(rank, base, e) for rank, base, e in items if isinstance(base, Call) and base.function == "exp"]
    if not found or (len(found) == 1 and found[0][2] == 1):
        return items
    exponent = total([multiply(Number(Fraction(e)), base.children()[0]) for _, base, e in found])
    return [item for item in items if item not in found] + [(found[0][0], call("exp", exponent), 1)]
