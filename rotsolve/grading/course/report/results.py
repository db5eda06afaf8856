"""Results: a class as it is marked: each student with the row that counts and its marks, and what the whole of it says of variants."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from msgspec import Struct

from rotsolve.core.derivation import Words
from rotsolve.grading.course.columns import Columns
from rotsolve.grading.course.marked import UNMARKED, MarkedSheet
from rotsolve.grading.course.overrides import Override
from rotsolve.grading.course.questions import Asked, SheetTask
from rotsolve.grading.course.report.tally import Tally
from rotsolve.grading.course.students import Student
from rotsolve.grading.course.table import Entry
from rotsolve.grading.verdict import NOT_MARKED, JudgedPart


class Result(Struct, frozen=True):
    """A student's row, what the student is called so that no two are called alike, and the marks, with those by hand."""

    entry: Entry
    name: str
    sheet: MarkedSheet
    by_hand: tuple[Override, ...] = ()

    @property
    def student(self) -> Student:
        return self.entry.student

    @property
    def is_marked(self) -> bool:
        """Whether there is anything that could be marked, or was by hand."""
        return self.sheet.outcomes() != {NOT_MARKED}

    @property
    def variant(self) -> str:
        return self.entry.variant

    def unmarked(self, task: SheetTask) -> list[Words]:
        """Why papers of the student could not be marked, with the problem unless it is the same for all."""
        found: dict[Words, list[int]] = {}
        for one, marked in zip(task.tasks, self.sheet.problems, strict=True):
            for remark in dict.fromkeys(remark for part in marked.parts for remark in part.verdict.remarks):
                if remark.kind == UNMARKED:
                    found.setdefault(remark.words, []).append(one.number)
        everywhere = len(task.tasks)
        heads = ("" if len(own) == everywhere else f"problem {', '.join(map(str, own))} " for own in found.values())
        return [(f"{head}{NOT_MARKED}: ", *words) for head, words in zip(heads, found, strict=True)]

    def part(self, place: int) -> JudgedPart:
        """An answer, by its place among all of the sheet."""
        return self.sheet.parts[place]


def tally_of(results: Iterable[Result]) -> Tally:
    """What the head of a summary says of students."""
    tally = Tally()
    for result in results:
        tally.count(result.name, result.variant, result.sheet if result.is_marked else None)
    return tally


class MarkedClass(Struct, frozen=True):
    """A class: what was asked, the columns of its table, and its students; the seed of the variants where there are such."""

    task: SheetTask
    columns: Columns
    results: tuple[Result, ...]
    byte_order_mark: bool = False
    seed: int | None = None
    merged: tuple[str, ...] = ()  # what is to be said of papers of earlier runs

    @property
    def papers(self) -> list[MarkedSheet]:
        """The papers that could be marked."""
        return [result.sheet for result in self.results if result.is_marked]

    @property
    def held(self) -> set[Asked]:
        """The answers that this table, or one before, has columns of."""
        papers = (paper for result in self.results for paper in enumerate(result.entry.papers or ()))
        return self.columns.held(self.task) | {(place, name) for place, paper in papers for name in paper.answers}

    @property
    def tally(self) -> Tally:
        """How many papers there are of which kind."""
        return tally_of(self.results)

    @property
    def parts(self) -> Sequence[JudgedPart]:
        """Answers of any student, for their names and how many marks there are."""
        return self.results[0].sheet.parts

    @property
    def of(self) -> Fraction:
        """All marks that there are."""
        return self.results[0].sheet.of

    @property
    def files(self) -> frozenset[str]:
        """The files that rows come of."""
        return frozenset(result.entry.file for result in self.results)

    @property
    def numbered(self) -> bool:
        """Whether any student has a number."""
        return any(result.student.number for result in self.results)

    def row(self, result: Result) -> str:
        """Which row it is: its line, with the file where there are several."""
        return f"{result.entry.line}" if len(self.files) == 1 else f"{result.entry.file}:{result.entry.line}"
