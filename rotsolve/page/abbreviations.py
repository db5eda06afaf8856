"""Abbreviations: a long sum of givens that comes back from step to step gets a letter where it first stands, as a book would give it one.

They are those of the page: what a solution holds for programs stays in the letters of the scene.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import (
    ONE,
    Formula,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    Symbol,
    multiply,
    negate,
)
from rotsolve.core.derivation import Answer, Derivation, Equality, Move, Section, Words
from rotsolve.page.blocks import WITH
from rotsolve.page.depth import FEWEST_TERMS

LETTERS = ("D", "S", "Q", "H", "B", "U", "V", "W")

Key = frozenset[tuple[Formula, Fraction]]  # the terms of a sum, each with its coefficient beside that of the first
Swap = Callable[[Formula], Formula]


class Abbreviation(Struct, frozen=True):
    """A letter, and the sum for which it stands."""

    letter: Symbol
    meaning: Sum

    @property
    def equality(self) -> Equality:
        """D = m + M + …"""
        return Equality(self.letter, self.meaning)


def abbreviated(derivation: Derivation) -> tuple[Derivation, tuple[Abbreviation, ...]]:
    """The derivation with letters for the sums that come back, each told behind the step in which it first stands; and these letters."""
    sums = repeated_sums(derivation)
    if not sums:
        return derivation, ()
    taken = {name for one in all_equalities(derivation) for side in (one.left, one.right) for name in side.symbols()}
    free = [name for name in LETTERS if name not in taken]
    found = [Abbreviation(Symbol(name), one) for name, one in zip(free, sums, strict=False)]
    swap = swapping({terms_in_common(one.meaning)[0]: one for one in found})
    introducing = Introducing(found, swap)
    sections = tuple([introducing.section(section) for section in derivation.sections])
    answers = tuple([by_letters(answer, swap) for answer in derivation.answers])
    return replace(derivation, sections=sections, answers=answers), tuple(found)


def all_equalities(derivation: Derivation) -> Iterator[Equality]:
    """All that stands on the page."""
    for section in derivation.sections:
        yield from (law.equation for law in section.laws)
        yield from (one for move in section.moves for one in move.chain)
    for answer in derivation.answers:
        yield from (Equality(answer.symbol, form) for form in printed_forms(answer))


def printed_forms(answer: Answer) -> Iterator[Formula]:
    """The closed forms of an answer, of its components, and of what it is in other cases."""
    yield from () if answer.formula is None else (answer.formula,)
    for one in (*answer.components, *answer.otherwise):
        yield from printed_forms(one)


def repeated_sums(derivation: Derivation) -> list[Sum]:
    """Sums of several terms in givens alone that stand in more than one step, the longest first."""
    moves = [move for section in derivation.sections for move in section.moves]
    unknown = {name for move in moves for one in move.chain for name in one.left.symbols() if one.left == Symbol(name)}
    unknown |= {name for answer in derivation.answers for name in answer.symbol.symbols()}
    first: dict[Key, Sum] = {}
    count: dict[Key, int] = {}
    for move in moves:
        here: dict[Key, Sum] = {}
        for one in move.chain:
            for node in (node for side in (one.left, one.right) for node in inner_sums(side)):
                if not node.symbols() & unknown:
                    here.setdefault(terms_in_common(node)[0], node)
        for key, node in here.items():
            first.setdefault(key, node)
            count[key] = count.get(key, 0) + 1
    return sorted((first[key] for key, times in count.items() if times > 1), key=length, reverse=True)


def inner_sums(side: Formula) -> Iterator[Sum]:
    """Sums of so many terms within a side of an equation; the side itself is none."""
    for node in side.walk(Sum):
        if node is not side and isinstance(node, Sum) and len(node.terms) >= FEWEST_TERMS:
            yield node


def terms_in_common(one: Sum) -> tuple[Key, Fraction]:
    """What a sum and its multiples have in common, and the coefficient of its first term: 2 a + 2 b like a + b, and 2."""
    parts = [coefficient_of(term) for term in one.terms]
    lead = min(parts, key=lambda part: hash(part[1]))[0]  # any one that is the same for all multiples
    return frozenset((rest, coefficient / lead) for coefficient, rest in parts), lead


def coefficient_of(term: Formula) -> tuple[Fraction, Formula]:
    """The number before a term, and what is behind it: −2 and x of −2 x."""
    match term:
        case Negative(operand):
            number, rest = coefficient_of(operand)
            return -number, rest
        case Number(value):
            return value, ONE
        case Product((Number(value), *others)):
            return value, others[0] if len(others) == 1 else Product(tuple(others))
        case Quotient(numerator, Number(value)):
            number, rest = coefficient_of(numerator)
            return number / value, rest
    return Fraction(1), term


def swapping(letters: Mapping[Key, Abbreviation]) -> Swap:
    """What puts letters for sums, outer sums first."""

    def swap(node: Formula) -> Formula:
        if not node.holds(Sum):
            return node
        if isinstance(node, Sum) and len(node.terms) >= FEWEST_TERMS:
            key, lead = terms_in_common(node)
            if (known := letters.get(key)) is not None:
                times = lead / terms_in_common(known.meaning)[1]
                return negate(known.letter) if times == -1 else multiply(Number(times), known.letter)
        old = node.children()
        new = tuple([swap(child) for child in old])
        same = all(before is after for before, after in zip(old, new, strict=True))
        return node if same else node.with_children(new)

    return swap


class Introducing:
    """Puts the letters into steps, and tells of each behind the step in which it first stands."""

    def __init__(self, letters: Iterable[Abbreviation], swap: Swap) -> None:
        self.waiting, self.swap = {one.letter.name: one for one in letters}, swap

    def section(self, section: Section) -> Section:
        moves: list[Move] = []
        for move in map(self.move, section.moves):
            moves += [move, *self.news(move)]
        return replace(section, moves=tuple(moves))

    def move(self, move: Move) -> Move:
        swap = self.swap
        chain = tuple([Equality(inside(one.left, swap), inside(one.right, swap), one.relation) for one in move.chain])
        return replace(move, chain=chain, reason=self.words(move.reason))

    def words(self, words: Words) -> Words:
        return tuple([self.swap(part) if isinstance(part, Formula) else part for part in words])

    def news(self, move: Move) -> Iterator[Move]:
        """The letters that stand in a step, as it is told by them, for the first time."""
        names = {name for one in move.chain for side in (one.left, one.right) for name in side.symbols()}
        for name in [name for name in self.waiting if name in names]:
            yield Move(WITH, (self.waiting.pop(name).equality,))


def inside(side: Formula, swap: Swap) -> Formula:
    """A side of an equation by the letters; a sum that is the whole side stays written out."""
    return side.with_children(tuple(map(swap, side.children()))) if isinstance(side, Sum) else swap(side)


def by_letters(answer: Answer, swap: Swap) -> Answer:
    """An answer by the letters."""
    return replace(
        answer,
        formula=None if answer.formula is None else inside(answer.formula, swap),
        components=tuple([by_letters(one, swap) for one in answer.components]),
        otherwise=tuple([by_letters(one, swap) for one in answer.otherwise]),
        conditions=tuple([Equality(swap(one.left), swap(one.right), one.relation) for one in answer.conditions]),
    )
