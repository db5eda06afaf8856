"""Derivation: the page of a solved scene: what is given and asked, forces, laws and algebra state by state, answers and checks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import Formula, Sum, Symbol
from rotsolve.core.derivation import Answer, Check, Derivation, Equality, Move, Refusal, Section, in_lines
from rotsolve.page.blocks import (
    WITH,
    AnswerRow,
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
    Math,
    Page,
    PageBlock,
    Paragraph,
    Phrase,
    Picture,
    Title,
    authored,
)
from rotsolve.page.depth import BRIEF, FEWEST_TERMS, FULL, LONG, NONE, NORMAL, STEPS
from rotsolve.page.inserted import CoherentUnits, InsertedNumbers, coherent_units
from rotsolve.page.overlong import within_a_page
from rotsolve.page.plan import plan_of, planned_once
from rotsolve.page.values import answer_rows, given_equation, only_letters, shown_givens
from rotsolve.page.wording import said_of_step

if TYPE_CHECKING:
    from rotsolve.language.problem import Given, Problem
    from rotsolve.page.abbreviations import Abbreviation

PLAN = "Plan"


class DerivationPage(Page, frozen=True):
    """A derivation, with so many significant digits, of the scene in a file."""

    derivation: Derivation
    digits: int = 4
    file: str = ""
    pictured: Problem | None = None  # the scene of which it has a picture
    detail: str = NORMAL
    numbers: str = STEPS
    others: tuple[tuple[str, Derivation], ...] = ()  # ways by other laws, with what these are called
    scene: Problem | None = None  # whose names stand on it

    @property
    def spaced(self) -> bool:
        return False

    def blocks(self) -> Iterator[PageBlock]:
        derivation, shorts = with_abbreviations(within_a_page(self.derivation))
        numbers = InsertedNumbers(derivation, shorts, self.digits)
        if derivation.title:
            yield Title(1, (authored(derivation.title),))
        if self.pictured is not None:
            yield Picture(self.pictured)
        shown = self.digits if self.numbers == STEPS and self.detail != BRIEF else None
        opening = [row for row in opening_rows(derivation, shown) if row.items]
        yield Labels(tuple(row for row in opening if row.label != PLAN or self.detail != BRIEF))
        yield from self.section_blocks(derivation, numbers)
        if derivation.answers:
            yield Title(2, ("Answers",))
            yield Answers(self.answer_rows(derivation))
            used = names_in_answers(derivation) if shorts else set()
            yield from (Paragraph(("with ", *numbers.meaning(one))) for one in shorts if one.letter.name in used)
        for section in derivation.second if self.detail != BRIEF else ():
            yield Title(2, ("Second solution",))
            yield from section_blocks(replace(section, title="Second solution"), None, set())
        if derivation.insights and self.detail != BRIEF:
            yield Title(2, ("Remarks",))
            yield Bullets(tuple(map(Bullet, derivation.insights)))
        for law, other in self.others if self.detail != BRIEF else ():
            if laws_told(other) <= laws_told(derivation):
                continue  # no other way
            yield Title(2, (f"The same by {law}",))
            other = within_a_page(other)
            yield from self.section_blocks(other, InsertedNumbers(other, (), self.digits))
        if derivation.refused:
            yield Title(2, ("Not answered",))
            yield Bullets(tuple(map(refusal_bullet, derivation.refused)))
        yield from limit_blocks(derivation.checks)
        rest = [check for check in derivation.checks if not check.limit]
        checks = tuple(rest if self.detail == FULL else in_short(rest))
        if checks:
            yield Title(2, ("Checks",))
            yield Checks(checks)

    def section_blocks(self, derivation: Derivation, numbers: InsertedNumbers) -> Iterator[PageBlock]:
        """All sections of a derivation, with as much as is to be told."""
        printed: set[Equality] = set()
        for section in derivation.sections:
            if section.title:
                yield Title(2, (section.title,))
            if self.detail == BRIEF:
                yield from law_blocks(section, None)
            else:
                yield from section_blocks(section, numbers if self.numbers == STEPS else None, printed)

    def answer_rows(self, derivation: Derivation) -> tuple[AnswerRow, ...]:
        """The answers in all cases; without their values where formulas are all that is wanted, and there are any."""
        answers = derivation.answers if self.numbers != NONE else map(without_value, derivation.answers)
        return tuple(row for answer in answers for row in answer_rows(answer, self.digits))

    def names(self) -> frozenset[str]:
        from rotsolve.page.languages.names import names_of_scene

        if self.scene is not None:
            return names_of_scene(self.scene)
        return frozenset(line.body for section in self.derivation.sections for line in section.forces)

    def data(self) -> dict[str, Any]:
        from rotsolve.page.data import derivation_data

        return {"file": self.file, **derivation_data(self.derivation, self.digits)}


def limit_blocks(checks: Iterable[Check]) -> Iterator[PageBlock]:
    """What answers come to at the ends of what a letter may be, one a line."""
    limits = tuple(Bullet(check.words) for check in checks if check.limit)
    if limits:
        yield Title(2, ("Limits",))
        yield Bullets(limits)


def in_short(checks: Iterable[Check]) -> Iterator[Check]:
    """The checks that a reader can follow, and in two words that all answers agree with a computation with numbers."""
    told = False
    for check in checks:
        if not check.bare:
            yield check
        elif not check.law and not told:
            told = True
            yield replace(check, words=("confirmed with numbers",))


def with_abbreviations(derivation: Derivation) -> tuple[Derivation, tuple[Abbreviation, ...]]:
    """The derivation with letters for long sums that come back, and for long answers in others; what looks for these is loaded where there
    are long ones at all."""
    if sum(form is not None and length(form) >= LONG for form in all_forms(derivation.answers)) > 1:
        from rotsolve.page.by_answers import told_by_answers

        derivation = told_by_answers(derivation)
    moves = (move for section in derivation.sections for move in section.moves)
    sides = (side for move in moves for one in move.chain for side in (one.left, one.right))
    if not any(isinstance(node, Sum) and len(node.terms) >= FEWEST_TERMS for side in sides for node in side.walk(Sum)):
        return derivation, ()
    from rotsolve.page.abbreviations import abbreviated

    return abbreviated(derivation)


def all_forms(answers: Iterable[Answer]) -> Iterator[Formula | None]:
    """The forms of answers and of their components."""
    for answer in answers:
        yield answer.formula
        yield from all_forms(answer.components)


def names_in_answers(derivation: Derivation) -> set[str]:
    """The letters in the forms of the answers."""
    from rotsolve.page.abbreviations import printed_forms

    return {name for answer in derivation.answers for form in printed_forms(answer) for name in form.symbols()}


def laws_told(derivation: Derivation) -> set[Equality]:
    """The equations that a derivation goes by."""
    return {law.equation for section in derivation.sections for law in section.laws}


def refusal_bullet(refusal: Refusal) -> Bullet:
    """Why a question has no answer, with its line in the file, and what may help."""
    fault = refusal.fault
    line = f" (line {fault.span.line})" if fault.span is not None else ""
    help = (Bullet(("help: ", authored(fault.help))),) if fault.help else ()
    return Bullet((Symbol(refusal.name), ": ", authored(fault.message), line), help)


def given_with_number(given: Given, units: CoherentUnits, digits: int | None) -> Phrase:
    """A given as the scene writes it, and in the unit with which is calculated where numbers are put in."""
    said = given_equation(given)
    coherent = None if digits is None else units.value(given, digits)
    return (said if coherent is None else Math((*said.parts, "=", coherent)),)


def opening_rows(derivation: Derivation, digits: int | None) -> Iterator[Labelled]:
    """Source, givens, conventions, what is asked, and the states."""
    yield Labelled("Source", ((authored(derivation.source),),) if derivation.source else ())
    units = coherent_units(derivation.givens)
    asked = {answer.dimension: answer.unit for answer in derivation.answers}
    givens = tuple(
        given_with_number(given, units, digits if asked.get(given.dimension) != given.unit else None)
        for given in shown_givens(derivation.givens)
    )
    yield Labelled("Given", givens, ", ")
    yield Labelled("Signs", derivation.conventions, beside=bool(givens))
    yield Labelled("Places", derivation.places)
    yield Labelled("Find", derivation.finds, ", " if only_letters(derivation.finds) else "; ")
    yield Labelled("States", derivation.states, wide=True)
    yield Labelled("Events", derivation.events)
    yield Labelled(PLAN, plan_of(derivation), " ", wide=len(planned_once(derivation.sections)) > 1)


def without_value(answer: Answer) -> Answer:
    """An answer, its components and what it is in other cases without numbers, as far as they have formulas."""
    value = None if answer.formula is not None else answer.value
    components = tuple(map(without_value, answer.components))
    return replace(answer, value=value, components=components, otherwise=tuple(map(without_value, answer.otherwise)))


def section_blocks(section: Section, numbers: InsertedNumbers | None, printed: set[Equality]) -> Iterator[PageBlock]:
    """Forces, laws and algebra of one instant, phase or event; `printed` are the lines before."""
    level = section_level(section)
    if section.forces:
        positive = [f"positive: {line.positive}" if line.positive else "" for line in section.forces]
        rows = zip(section.forces, positive, strict=True)
        yield Listing("Forces", level, tuple(Listed(line.body, line.forces, said, line.remarks) for line, said in rows))
    known = None if section.supposed else numbers
    yield from law_blocks(section, known)
    if section.moves:
        printed.update(law.equation for law in section.laws)
        yield Formulas("Solve", level, (), tuple(step_row(move, known, printed) for move in section.moves))


def section_level(section: Section) -> int:
    """How deep the headings within a section are."""
    return 3 if section.title else 2


def law_blocks(section: Section, numbers: InsertedNumbers | None) -> Iterator[PageBlock]:
    """The laws of a section, with why what is conserved is; and what those come to that are told with their `numbers`."""
    if section.remarks or section.laws:
        rows, told = [], {move.chain[-1].left for move in section.moves}  # by steps, which say what that comes to
        for law in section.laws:
            again = numbers is None or law.equation.left in told
            values = () if numbers is None or again else numbers.valued(law.name, law.equation)
            rows.append(FormulaRow((law.law,), (law.equation,), law.number, law.remark, True, values=values))
        remarks = tuple(line for remark in section.remarks for line in in_lines(remark))
        yield Formulas("Laws", section_level(section), remarks, tuple(rows))


def step_row(move: Move, numbers: InsertedNumbers | None, printed: set[Equality]) -> FormulaRow:
    """A step of algebra: where it comes from, else why it is made; and what it comes to where there are `numbers`.

    An equation that it begins with and that stands above is not printed again, unless numbers are put into it.
    """
    said, (place, values) = said_of_step(move), (-1, ()) if numbers is None else numbers.values(move)
    remark = move.reason if said else ()
    begins, chain = move.sources == WITH, move.chain
    if len(chain) > 1 and chain[0] in printed and not (values and place == 0):
        chain, place = chain[1:], place - (place > 0)
    printed.update(chain)
    return FormulaRow(said or move.reason, chain, move.number, remark, begins=begins, values=values, valued=place)
