"""Ranges: what becomes of an answer at the ends of what the scene lets a letter be, d → 0 and d = r of d ≤ r."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rotsolve.algebra.exact.normal import is_zero, simplify, without_direction
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ZERO, Formula, Quotient, Symbol
from rotsolve.core.derivation import Answer, Check, Words
from rotsolve.core.symbols import has_quantities
from rotsolve.search.letterspace import LetterSpace

LONGEST, SHORT = 60, 14  # nodes of a formula that is looked at, and of what it comes to


def at_ends_of_ranges(answers: Sequence[Answer], space: LetterSpace) -> Iterator[Check]:
    """The first answer in which a letter stands that goes from nothing up to another one, at both ends."""
    for letter, most in ranges(space):
        for answer in answers:
            formula = answer.formula
            if formula is None or letter not in formula.symbols() or length(formula) > LONGEST:
                continue
            ends = [(Symbol(letter), " → 0", ZERO), (Symbol(letter), " = ", Symbol(most))]
            for name, way, value in ends:
                found = put_at(formula, letter, value, space)
                if found is not None:
                    words: Words = (
                        name,
                        way,
                        *((value,) if value != ZERO else ()),
                        " gives ",
                        answer.symbol,
                        " = ",
                        found,
                    )
                    yield Check(words)
            break


def ranges(space: LetterSpace) -> Iterator[tuple[str, str]]:
    """Letters that may be anything up to another one, and as large as that: d and r of d ≤ r."""
    for one in space.limited:
        names = sorted(one.gap.symbols())
        if one.strict or len(names) != 2:
            continue
        for letter, most in (names, names[::-1]):
            if is_zero(one.gap - (Symbol(most) - Symbol(letter))):
                yield letter, most


def put_at(formula: Formula, letter: str, value: Formula, space: LetterSpace) -> Formula | None:
    """A formula at a value of a letter, where that is short; None where it has no value there."""
    there = formula.substitute({letter: value})
    if any(is_zero(node.denominator) for node in there.walk(Quotient) if isinstance(node, Quotient)):
        return None
    if without_direction(there) or has_quantities(there):
        return None
    found = simplify(there, order=space.order, positive=space.positive)
    return found if length(found) <= SHORT else None
