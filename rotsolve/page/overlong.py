"""Overlong: formulas that no page can hold, as how a body is turned after a time in components in space: dots stand for them, and what they
come to is certified all the same."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec.structs import replace

from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.letters import DOTS
from rotsolve.core.derivation import Answer, Derivation, Equality, LawLine, Move, Section, Words

LONGEST = 320  # nodes of a formula, a dozen lines of a page
UNWRITTEN = Symbol(DOTS)
TOO_LONG: Words = ("too long to print",)


def within_a_page(derivation: Derivation) -> Derivation:
    """A derivation with dots for formulas that no page can hold."""
    if not any(map(is_overlong, formulas_of(derivation))):
        return derivation
    sections = tuple(map(short_section, derivation.sections))
    return replace(derivation, sections=sections, answers=tuple(map(short_answer, derivation.answers)))


def is_overlong(value: Formula | None) -> bool:
    """Whether no page can hold a formula."""
    return value is not None and length(value) > LONGEST


def formulas_of(derivation: Derivation) -> Iterable[Formula | None]:
    """The formulas of laws, steps and answers."""
    for section in derivation.sections:
        lines = [law.equation for law in section.laws] + [one for move in section.moves for one in move.chain]
        yield from (side for one in lines for side in (one.left, one.right))
    waiting = list(derivation.answers)
    while waiting:
        answer = waiting.pop()
        yield answer.formula
        waiting += (*answer.components, *answer.otherwise)


def short_section(section: Section) -> Section:
    """A section with dots in its laws and steps."""
    return replace(section, laws=tuple(map(short_law, section.laws)), moves=tuple(map(short_move, section.moves)))


def short_law(law: LawLine) -> LawLine:
    """A law with dots, and that it is too long."""
    equation = with_dots(law.equation)
    return law if equation is law.equation else replace(law, equation=equation, remark=law.remark or TOO_LONG)


def short_move(move: Move) -> Move:
    """A step with the lines that a page can hold; with dots for one where it has no other."""
    kept = tuple(line for line in move.chain if not (is_overlong(line.left) or is_overlong(line.right)))
    if len(kept) == len(move.chain):
        return move
    return replace(move, chain=kept or (with_dots(move.chain[-1]),), reason=move.reason or (() if kept else TOO_LONG))


def with_dots(line: Equality) -> Equality:
    """An equality with dots for a side that is too long."""
    left, right = (UNWRITTEN if is_overlong(side) else side for side in (line.left, line.right))
    return line if left is line.left and right is line.right else replace(line, left=left, right=right)


def short_answer(answer: Answer) -> Answer:
    """An answer by its number alone where its closed form is too long; of letters with dots."""
    parts = (tuple(map(short_answer, answers)) for answers in (answer.components, answer.otherwise))
    components, otherwise = parts
    own = replace(answer, components=components, otherwise=otherwise)
    if not is_overlong(answer.formula):
        return replace(own, remark=TOO_LONG) if any(part.formula is UNWRITTEN for part in components) else own
    return replace(own, formula=None) if answer.value is not None else replace(own, formula=UNWRITTEN, remark=TOO_LONG)
