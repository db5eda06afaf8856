"""Ranges: what becomes of an answer at the ends of what the scene lets a letter be, d → 0 and d = r of d ≤ r."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.exact.normal import is_zero, simplify, without_direction
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ONE, ZERO, Formula, Number, Quotient, Symbol
from rotsolve.algebra.units.dimension import NONE
from rotsolve.core.derivation import Answer, Check, Words
from rotsolve.core.symbols import has_quantities

if TYPE_CHECKING:
    from rotsolve.search.letterspace import LetterSpace

LONGEST, SHORT = 60, 14  # nodes of a formula that is looked at, and of what it comes to


class LettersAt(Struct, frozen=True):
    """Values of letters, with how they are told: d → 0, β = ⅓ (uniform rod)."""

    values: dict[str, Formula]
    words: Words


def at_ends_of_ranges(answers: Sequence[Answer], space: LetterSpace) -> Iterator[Check]:
    """What the first answer in which such letters stand comes to at the ends of their ranges, and for what is uniform."""
    uniform, most = list(uniform_shapes(space)), list(ranges(space))
    for letter, bound in most:
        yield from told_at(LettersAt({letter: ZERO}, (Symbol(letter), " → 0")), answers, space)
        yield from told_at(at_bound(letter, bound), answers, space)
    for one in uniform:
        yield from told_at(one, answers, space)
        for letter, bound in most:
            edge = at_bound(letter, bound)
            yield from told_at(LettersAt(one.values | edge.values, (*one.words, ", ", *edge.words)), answers, space)


def at_bound(letter: str, bound: str) -> LettersAt:
    """A letter as large as it may be."""
    return LettersAt({letter: Symbol(bound)}, (Symbol(letter), " = ", Symbol(bound)))


def told_at(put: LettersAt, answers: Sequence[Answer], space: LetterSpace) -> Iterator[Check]:
    """ "d = r gives F = …", of the first answer that holds all its letters, where that is short."""
    for answer in answers:
        formula = answer.formula
        if formula is not None and put.values.keys() <= formula.symbols() and length(formula) <= LONGEST:
            found = put_at(formula, put.values, space)
            if found is not None:
                yield Check((*put.words, " gives ", answer.symbol, " = ", found), limit=True)
            return


def uniform_shapes(space: LetterSpace) -> Iterator[LettersAt]:
    """The pure numbers of moments of inertia that the shapes of bodies would have if they were uniform: β = ⅓ of a rod of length 2 r."""
    for body in space.problem.bodies:
        if body.inertia is None or body.shape is None or body.mass is None or body.parts or body.holes:
            continue
        own = body.shape.moment(body.mass)
        for name in sorted(body.inertia.symbols() & space.letters.keys()):
            if space.letters[name].dimension == NONE and in_proportion(body.inertia, name):
                value = simplify(own / body.inertia.substitute({name: ONE}), positive=space.positive)
                if isinstance(value, Number) and value != ZERO:
                    yield LettersAt({name: value}, (Symbol(name), " = ", value, f" (uniform {body.shape.word})"))


def in_proportion(inertia: Formula, name: str) -> bool:
    """Whether a moment of inertia is a letter times what does not hold it: β m R², and neither β² m R² nor m R²/β."""
    return is_zero(inertia - Symbol(name) * inertia.substitute({name: ONE}))


def ranges(space: LetterSpace) -> Iterator[tuple[str, str]]:
    """Letters that may be anything up to another one, and as large as that: d and r of d ≤ r."""
    for one in space.limited:
        names = sorted(one.gap.symbols())
        if one.strict or len(names) != 2:
            continue
        for letter, most in (names, names[::-1]):
            if is_zero(one.gap - (Symbol(most) - Symbol(letter))):
                yield letter, most


def put_at(formula: Formula, values: Mapping[str, Formula], space: LetterSpace) -> Formula | None:
    """A formula at values of letters, where that is short; None where it has no value there."""
    there = formula.substitute(values)
    if any(is_zero(node.denominator) for node in there.walk(Quotient) if isinstance(node, Quotient)):
        return None
    if without_direction(there) or has_quantities(there):
        return None
    found = simplify(there, order=space.order, positive=space.positive)
    return found if length(found) <= SHORT else None
