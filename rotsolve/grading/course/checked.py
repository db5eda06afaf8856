"""Checked: answers of a student marked from Python: `rotsolve.check(problem, answers)`, and what it gives."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.core.faults import Unsolvable
from rotsolve.grading.course.command import SEED
from rotsolve.grading.course.examiner import Judges, variant_of
from rotsolve.grading.course.marked import MarkedSheet
from rotsolve.grading.course.questions import SheetTask, Task
from rotsolve.grading.course.report.student import StudentPage
from rotsolve.grading.course.sheet import content_of, from_answers, from_yaml, meant_answer, read_sheet
from rotsolve.grading.course.students import Student
from rotsolve.grading.verdict import RIGHT, JudgedLine, JudgedPart, Marked, Paper
from rotsolve.language.words import hint
from rotsolve.page.formats import WIDTH, format_named
from rotsolve.page.text import plain_text
from rotsolve.scene.read import Source, written_yaml
from rotsolve.solution import Solution

Answers = Mapping[str, object] | str | os.PathLike[str]


def check_answers(
    problem: Source | Solution,
    answers: Answers,
    *,
    variant: int | None = None,
    variants: int | None = None,
    seed: int = SEED,
) -> CheckedPaper:
    """Mark the answers of one student to a problem, as `rotsolve check` does.

    `problem` is as for `rotsolve.solve`, or a solution. `answers` are a dict by the names under `find`, {"a": "2mg/(2m+M)"}, with `working`
    if there is some; a text with a line for each, "a = 4.36 m/s^2"; or the path of a file, a `pathlib.Path`. `variant` is the number of
    the student's own numbers, `variants` how many there are, `seed` that of the key. Raises HandedInError for answers that can't be read,
    NotMarked for a variant that is none, SceneError and Unsolvable as `solve` does.
    """
    judges = Judges(problem.problem if isinstance(problem, Solution) else problem, seed, variants)
    for found in judges.solution.checks:
        if found.holds is False:
            raise Unsolvable(f"its answers do not hold: {plain_text(found.words)}", file=judges.problem.file)
    paper = paper_of(answers, tuple(judges.task.letters), judges.task.parts)
    if not paper.variant and variant is not None:
        paper = replace(paper, variant=str(variant))
    return CheckedPaper(judges.task, judges.judge(variant_of(paper)).mark(paper), paper.variant)


def paper_of(answers: Answers, asked: tuple[str, ...], parts: Mapping[str, str]) -> Paper:
    """What is handed in, whatever form it has."""
    if isinstance(answers, Mapping):
        return from_yaml(written_yaml(answers), "<dict>", asked, parts)
    if isinstance(answers, os.PathLike):
        file = os.fspath(answers)
        return read_sheet(content_of(file), file, asked, parts)
    if "\n" not in answers.strip():
        return from_answers((answers.strip(),), asked, parts, "<text>")
    return read_sheet(answers, "<text>", asked, parts)


class VerdictView(Struct, frozen=True):
    """What is said of one answer, or of one line of working."""

    judged: JudgedPart | JudgedLine

    @property
    def text(self) -> str:
        """What the student wrote, '' for no answer."""
        return self.judged.text

    @property
    def outcome(self) -> str:
        """ "right", "partly right", "wrong" or "can't decide"."""
        return self.judged.verdict.outcome

    @property
    def right(self) -> bool:
        """Whether it is right."""
        return self.outcome == RIGHT

    @property
    def read_as(self) -> str:
        """How it was read, '' where that is plain."""
        return self.judged.verdict.read_as

    @property
    def remarks(self) -> tuple[str, ...]:
        """What there is to say of it: which mistake gives it, which unit it lacks, …"""
        return tuple(plain_text(remark.words) for remark in self.judged.verdict.remarks)

    @property
    def marks(self) -> float:
        """Its marks, 0 for a line of working."""
        return float(self.judged.marks) if isinstance(self.judged, JudgedPart) else 0.0

    @property
    def of(self) -> float:
        """How many marks there are for it."""
        return float(self.judged.of) if isinstance(self.judged, JudgedPart) else 0.0

    def __repr__(self) -> str:
        return f"<VerdictView {self.text!r}: {'; '.join((self.outcome, *self.remarks))}>"


class CheckedPaper(Struct, frozen=True):
    """A paper that has been marked: verdicts by the names under `find`, `checked["a"].outcome`; printed, it is the student's page."""

    task: Task
    marked: Marked
    variant: str = ""

    @property
    def verdicts(self) -> dict[str, VerdictView]:
        """The verdicts by the names under `find`; what has no answer is among them."""
        return {part.name: VerdictView(part) for part in self.marked.parts}

    @property
    def working(self) -> tuple[VerdictView, ...]:
        """The verdicts on the lines of working."""
        return tuple(map(VerdictView, self.marked.lines))

    @property
    def right(self) -> bool:
        """Whether every answer is right, and no line of working wrong."""
        return MarkedSheet((self.marked,)).all_right

    @property
    def marks(self) -> float:
        """The sum of the marks."""
        return float(self.marked.marks)

    @property
    def of(self) -> float:
        """How many marks there are."""
        return float(self.marked.of)

    def __getitem__(self, name: str) -> VerdictView:
        """The verdict on an answer, by its name in any spelling."""
        meant = meant_answer(name, self.verdicts)
        if meant is None:
            raise KeyError(f"nothing is asked by the name `{name}`: {hint(name, self.verdicts, 'asked')}")
        return self.verdicts[meant]

    def __iter__(self) -> Iterator[str]:
        return iter(self.verdicts)

    def __len__(self) -> int:
        return len(self.verdicts)

    def to(self, format: str = "text") -> str:
        """The student's page: 'text', 'markdown', 'latex', 'typst', 'html' or 'json'."""
        chosen = format_named(format)
        return chosen.document([chosen.body(self._page, WIDTH)])

    def to_frame(self) -> Any:
        """The verdicts as a table of pandas, a row for each answer."""
        from rotsolve.solution.frames import pandas

        names = ("text", "outcome", "marks", "of", "remarks")
        rows = [(one.text, one.outcome, one.marks, one.of, "; ".join(one.remarks)) for one in self.verdicts.values()]
        return pandas().DataFrame(rows, columns=list(names), index=pandas().Index(list(self), name="answer"))

    @property
    def _page(self) -> StudentPage:
        task = SheetTask(self.task.title, (self.task,))
        return StudentPage(task, MarkedSheet((self.marked,)), Student(self.marked.student), self.variant)

    def __str__(self) -> str:
        return self.to("text").rstrip("\n")

    def __repr__(self) -> str:
        outcomes = ", ".join(f"{name}: {one.outcome}" for name, one in self.verdicts.items())
        return f"<CheckedPaper {outcomes}; {self.marks:g} of {self.of:g}>"

    def _repr_html_(self) -> str:
        from rotsolve.page.html_rows import notebook_piece

        return notebook_piece(format_named("html").body(self._page, WIDTH))
