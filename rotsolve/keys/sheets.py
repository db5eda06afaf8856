"""Sheets: the pages of one variant: the statements without answers, the answers, the derivations."""

from __future__ import annotations

import os
from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.keys.names import names_told
from rotsolve.keys.parts import SheetPart, exact_points, parts_of
from rotsolve.keys.problem_set import ProblemSet, SetProblem
from rotsolve.keys.statement import Statement, by_author, filler, statement
from rotsolve.language.marks import marking_of
from rotsolve.page.blocks import (
    LABEL,
    Answers,
    FixedPage,
    Labelled,
    Labels,
    Page,
    PageBlock,
    Paragraph,
    Phrase,
    Picture,
    Styled,
    Title,
    authored,
)
from rotsolve.page.derivation import DerivationPage
from rotsolve.page.statement_blocks import HeadField, Image, PageBreak, Question, SheetHead
from rotsolve.page.text import PRINTER, plain_text
from rotsolve.page.values import answer_row, given_equation
from rotsolve.scene.statement import statement_blocks

if TYPE_CHECKING:
    from rotsolve.core.derivation import Answer
    from rotsolve.keys.working import Worked
    from rotsolve.language.problem import Problem


class SheetProblem(Struct, frozen=True):
    """A problem on a sheet: its place there, the problem with the points of the sheet, and it with the values of the variant, solved."""

    listed: SetProblem
    marked: Problem
    worked: Worked

    @property
    def parts(self) -> tuple[SheetPart, ...]:
        return parts_of(self.marked)

    @property
    def points(self) -> Fraction:
        return sum((part.points for part in self.parts), Fraction(0))

    @property
    def statement(self) -> Statement:
        return statement(self.worked, self.marked)

    @property
    def heading(self) -> Phrase:
        """Its number, title and points."""
        return (authored(f"{self.listed.number}. {self.marked.title}"), f" [{points_in_words(self.points)}]")

    def answers(self) -> Iterator[tuple[SheetPart, Answer]]:
        """The answers in the order of the parts."""
        for part in self.parts:
            yield from ((part, answer) for answer in self.worked.answers if answer.name == part.name)


class Sheet(Struct, frozen=True):
    """The problems of one variant; its number is 0 where there are no variants, which are drawn by the seed."""

    variant: int
    problems: tuple[SheetProblem, ...]
    seed: int = 0
    set: ProblemSet = ProblemSet("", ())

    @property
    def mark(self) -> str:
        """What tells the variant behind a title."""
        return f", variant {self.variant} (seed {self.seed})" if self.variant else ""

    @property
    def title(self) -> Phrase:
        """The title that the set has, if any, and the variant."""
        return (authored(self.set.title), self.mark) if self.set.title else (f"Problems{self.mark}",)

    def names(self) -> frozenset[str]:
        """Words that somebody gave to things of its scenes."""
        return frozenset().union(*(names_told(one.worked.problem) for one in self.problems))

    def images(self) -> Iterator[Image]:
        """The images in its texts."""
        blocks = [*instructions(self.set)]
        blocks += [block for one in self.problems for block in one.statement.text]
        yield from (block for block in blocks if isinstance(block, Image))


def instructions(set: ProblemSet) -> Iterator[PageBlock]:
    """What is to be known before the first problem."""
    if set.instructions:
        yield from map(by_author, statement_blocks(set.instructions, filler({}, ()), os.path.dirname(set.file)))


def points_in_words(points: Fraction) -> str:
    """1 point, 8/3 points."""
    return f"{exact_points(points)} {'point' if points == 1 else 'points'}"


class SheetPage(Page, frozen=True):
    """The statements of one variant, without answers."""

    sheet: Sheet

    def blocks(self) -> Iterator[PageBlock]:
        set = self.sheet.set
        fields = (HeadField("Name", wide=True), HeadField("Number"), HeadField("Date", set.date))
        yield SheetHead(self.sheet.title, set.course, fields)
        yield from instructions(set)
        for place, one in enumerate(self.sheet.problems):
            if one.listed.layout.new_page and place:
                yield PageBreak()
            yield Title(2, one.heading)
            yield from told_blocks(one, one.statement, room=True)

    def names(self) -> frozenset[str]:
        return self.sheet.names()

    def data(self) -> dict[str, Any]:
        return with_variant(self.sheet, [*map(statement_data, self.sheet.problems)])


def told_blocks(one: SheetProblem, said: Statement, *, room: bool = False) -> Iterator[PageBlock]:
    """What a problem says, below its title, with room for the answers where it is wanted."""
    yield from said.text
    if one.listed.layout.picture:
        yield Picture(one.worked.problem)
    alone = len(said.parts) == 1
    find = Labelled("Find", (said.parts[0].words,) if alone and not said.parts[0].worded else ())
    rows = (Labelled("Given", said.givens, ", "), Labelled("Positive", said.positive), find)
    yield Labels(tuple(row for row in rows if row.items))
    if not alone and not all(asked.worded for asked in said.parts):
        yield Paragraph((Styled(LABEL, "Find"),))
    layout = one.listed.layout
    for asked in said.parts:
        words = () if find.items else asked.words
        space = layout.room if room else Fraction(0)
        points = "" if alone else points_in_words(asked.part.points)
        yield Question("" if alone else asked.part.label, words, points, space, layout.ruled)


def statement_data(one: SheetProblem) -> dict[str, Any]:
    """What a problem says, as plain text."""
    said = one.statement
    parts = [
        {
            "part": asked.part.label,
            "name": asked.part.name,
            "points": exact_points(asked.part.points),
            "asked": plain_text(asked.words),
        }
        for asked in said.parts
    ]
    return {
        "number": one.listed.number,
        "problem": one.listed.name,
        "title": plain_text((said.title,)),
        "points": exact_points(one.points),
        "text": text_alone(said.text),
        "given": [*map(plain_text, said.givens)],
        "positive": [*map(plain_text, said.positive)],
        "parts": parts,
    }


def text_alone(blocks: tuple[PageBlock, ...]) -> str:
    """Blocks as plain text, a line each paragraph."""
    return PRINTER.body(FixedPage(blocks), 10**6).strip() if blocks else ""


def with_variant(sheet: Sheet, problems: list[dict[str, Any]]) -> dict[str, Any]:
    """The data of problems with the number of their variant, and what stands at the head of the sheet."""
    variant = {"variant": sheet.variant, "seed": sheet.seed} if sheet.variant else {}
    head = {word: getattr(sheet.set, word) for word in ("title", "course", "date", "instructions")}
    return {**variant, **{word: said for word, said in head.items() if said}, "problems": problems}


def key_blocks(sheet: Sheet, digits: int) -> Iterator[PageBlock]:
    """The answers of one variant."""
    if sheet.variant:
        yield Title(2, (f"Variant {sheet.variant}",))
    for one in sheet.problems:
        yield Title(3 if sheet.variant else 2, one.heading)
        givens = tuple((given_equation(given),) for given in one.worked.shown())
        yield Labels((Labelled("Given", givens, ", "),) if givens else ())
        rows = []
        for part, answer in one.answers():
            row = answer_row(answer, digits)
            label = part.label if len(one.parts) > 1 else ""
            notes = (*row.notes, (f"{points_in_words(part.points)}{told_tolerance(one, answer)}",))
            rows.append(replace(row, label=label, notes=notes))
        yield Answers(tuple(rows))


def told_tolerance(one: SheetProblem, answer: Answer) -> str:
    """How far a number may be off, behind the points; nothing of an answer in words or letters alone."""
    numbers = answer.value is not None or any(part.value is not None for part in answer.components)
    tolerance = marking_of(one.marked.marking, answer.name).tolerance
    if not numbers:
        return ""
    return f", {tolerance.text}" if tolerance.figures is not None else f", ±{tolerance.text}"


def key_data(sheet: Sheet, digits: int) -> dict[str, Any]:
    """The answers of one variant, as `rotsolve solve --format json` gives them, with their parts and points."""
    from rotsolve.page.data import answer_data, given_data

    problems = [
        {
            "number": one.listed.number,
            "problem": one.listed.name,
            "title": one.marked.title,
            "points": exact_points(one.points),
            "given": [given_data(given) for given in one.worked.shown()],
            "answers": [
                {
                    "part": part.label,
                    "points": exact_points(part.points),
                    "tolerance": marking_of(one.marked.marking, part.name).tolerance.text,
                    **answer_data(answer, digits),
                }
                for part, answer in one.answers()
            ],
        }
        for one in sheet.problems
    ]
    return with_variant(sheet, problems)


class SolutionPage(Page, frozen=True):
    """A problem as its sheet states it, and its derivation."""

    sheet: Sheet
    one: SheetProblem
    digits: int

    def derivation(self) -> DerivationPage:
        return DerivationPage(
            self.one.worked.derivation(), self.digits, self.one.listed.name, scene=self.one.worked.problem
        )

    def blocks(self) -> Iterator[PageBlock]:
        number, points = self.one.heading
        yield Title(1, (number, f"{points}{self.sheet.mark}"))
        yield from told_blocks(self.one, self.one.statement)
        yield Title(2, ("Solution",))
        derivation = self.derivation()
        yield from replace(derivation, derivation=replace(derivation.derivation, title="")).blocks()

    def names(self) -> frozenset[str]:
        return self.sheet.names()

    def data(self) -> dict[str, Any]:
        return {**self.derivation().data(), "statement": statement_data(self.one)}


def solution_pages(sheet: Sheet, digits: int) -> Iterator[SolutionPage]:
    """The derivations, one after the other, each below its statement."""
    return (SolutionPage(sheet, one, digits) for one in sheet.problems)
