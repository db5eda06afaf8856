"""By answers: a long product or fraction that is an answer told before stands in later lines by that answer's letter.

As the abbreviations it is of the page alone: what a solution holds for programs stays in the letters of the scene.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from msgspec.structs import replace

from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import Formula, Product, Quotient, Symbol
from rotsolve.core.derivation import Answer, Derivation, Equality, Move
from rotsolve.page.depth import LONG

Told = Mapping[Formula, Symbol]


def told_by_answers(derivation: Derivation) -> Derivation:
    """The derivation with the letters of answers for what these are, in all that stands below them."""
    letters = {form: letter for answer in derivation.answers for form, letter in long_forms(answer)}
    told: dict[Formula, Symbol] = {}
    sections = []
    for section in derivation.sections:
        moves = []
        for move in section.moves:
            moves.append(told_in_step(move, told))
            last = move.chain[-1] if move.chain else None
            if last is not None and last.relation == "=" and letters.get(last.right) == last.left:
                told[last.right] = letters[last.right]
        sections.append(replace(section, moves=tuple(moves)))
    answers, above = [], dict[Formula, Symbol]()
    for answer in derivation.answers:
        answers.append(told_in_answer(answer, above))
        above.update(long_forms(answer))
    return replace(derivation, sections=tuple(sections), answers=tuple(answers))


def long_forms(answer: Answer) -> Iterator[tuple[Formula, Symbol]]:
    """The long forms of an answer, or of its components, each with its letter; none of one that is another in other cases."""
    if answer.conditions or answer.otherwise or answer.until:
        return
    form, letter = answer.formula, answer.symbol
    if isinstance(form, (Product, Quotient)) and length(form) >= LONG and isinstance(letter, Symbol):
        yield form, letter
    for part in answer.components:
        yield from long_forms(part)


def told_in_step(move: Move, told: Told) -> Move:
    """A step with what is told before by letters; a line that so says what the one above it says is left out."""
    if not told:
        return move
    chain = [Equality(one.left, letters_inside(one.right, told), one.relation) for one in move.chain]
    return replace(move, chain=tuple(dict.fromkeys(chain)))


def told_in_answer(answer: Answer, told: Told) -> Answer:
    """An answer by the letters of those above it."""
    if not told:
        return answer
    form = None if answer.formula is None else letters_inside(answer.formula, told)
    parts = tuple([told_in_answer(part, told) for part in answer.components])
    others = tuple([told_in_answer(other, told) for other in answer.otherwise])
    return replace(answer, formula=form, components=parts, otherwise=others)


def letters_inside(side: Formula, told: Told) -> Formula:
    """A formula with letters for what is told inside it, outer brackets first."""
    old = side.children()
    new = tuple([told.get(child) or letters_inside(child, told) for child in old])
    same = all(before is after for before, after in zip(old, new, strict=True))
    return side if same else side.with_children(new)
