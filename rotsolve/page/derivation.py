"""Derivation: the page of a solved scene: what is given and asked, forces, laws and algebra state by state, answers and checks."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from rotsolve.algebra.formula import Symbol
from rotsolve.core.derivation import Derivation, Move, Refusal, Section
from rotsolve.page.blocks import (
    Answers,
    Bullet,
    Bullets,
    Checks,
    FormulaRow,
    Formulas,
    Labelled,
    Labels,
    Listed,
    Listing,
    Page,
    PageBlock,
    Picture,
    Title,
)
from rotsolve.page.values import answer_rows, given_equation, only_letters, shown_givens

if TYPE_CHECKING:
    from rotsolve.language.problem import Problem


class DerivationPage(Page, frozen=True):
    """A derivation, with so many significant digits, of the scene in a file."""

    derivation: Derivation
    digits: int = 4
    file: str = ""
    pictured: Problem | None = None  # the scene of which it has a picture
    spaced: ClassVar[bool] = False

    def blocks(self) -> Iterator[PageBlock]:
        derivation = self.derivation
        if derivation.title:
            yield Title(1, (derivation.title,))
        if self.pictured is not None:
            yield Picture(self.pictured)
        yield Labels(tuple(row for row in opening_rows(derivation) if row.items))
        for section in derivation.sections:
            if section.title:
                yield Title(2, (section.title,))
            yield from section_blocks(section)
        if derivation.answers:
            yield Title(2, ("Answers",))
            yield Answers(tuple(row for answer in derivation.answers for row in answer_rows(answer, self.digits)))
        if derivation.refused:
            yield Title(2, ("Not answered",))
            yield Bullets(tuple(map(refusal_bullet, derivation.refused)))
        if derivation.checks:
            yield Title(2, ("Checks",))
            yield Checks(derivation.checks)

    def data(self) -> dict[str, Any]:
        from rotsolve.page.data import derivation_data

        return {"file": self.file, **derivation_data(self.derivation, self.digits)}


def refusal_bullet(refusal: Refusal) -> Bullet:
    """Why a question has no answer, with its line in the file, and what may help."""
    fault = refusal.fault
    line = f" (line {fault.span.line})" if fault.span is not None else ""
    help = (Bullet((f"help: {fault.help}",)),) if fault.help else ()
    return Bullet((Symbol(refusal.name), f": {fault.message}{line}"), help)


def opening_rows(derivation: Derivation) -> Iterator[Labelled]:
    """Source, givens, conventions, what is asked, and the states."""
    yield Labelled("Source", ((derivation.source,),) if derivation.source else ())
    givens = tuple((given_equation(given),) for given in shown_givens(derivation.givens))
    yield Labelled("Given", givens, ", ")
    yield Labelled("Signs", derivation.conventions, beside=bool(givens))
    yield Labelled("Find", derivation.finds, ", " if only_letters(derivation.finds) else "; ")
    yield Labelled("States", derivation.states, wide=True)


def section_blocks(section: Section) -> Iterator[PageBlock]:
    """Forces, laws and algebra of one instant, phase or event."""
    level = 3 if section.title else 2
    if section.forces:
        positive = [f"positive: {line.positive}" if line.positive else "" for line in section.forces]
        rows = zip(section.forces, positive, strict=True)
        yield Listing("Forces", level, tuple(Listed(line.body, line.forces, said, line.remarks) for line, said in rows))
    if section.remarks or section.laws:
        law_rows = (FormulaRow((law.law,), (law.equation,), law.number, law.remark, True) for law in section.laws)
        yield Formulas("Laws", level, section.remarks, tuple(law_rows))
    if section.moves:
        yield Formulas("Solve", level, (), tuple(map(step_row, section.moves)))


def step_row(move: Move) -> FormulaRow:
    """A step of algebra: where it comes from, else why it is made."""
    if move.sources:
        return FormulaRow((move.sources,), move.chain, move.number, move.reason)
    return FormulaRow(move.reason, move.chain, move.number)
