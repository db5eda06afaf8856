"""Checked: answers of a student marked from Python: `rotsolve.check(problem, answers)`, and what it gives."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.grading.course.by_problem import papers_of_answers, read_map_of_student, read_papers_of_student
from rotsolve.grading.course.command import SEED
from rotsolve.grading.course.examination import Examination
from rotsolve.grading.course.handed_in import content_of
from rotsolve.grading.course.marked import MarkedSheet
from rotsolve.grading.course.questions import SheetTask
from rotsolve.grading.course.report.student import StudentPage
from rotsolve.grading.course.students import Student
from rotsolve.grading.verdict import RIGHT, JudgedLine, JudgedPart, Paper
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
    """Mark the answers of one student to a problem or a sheet of problems, as `rotsolve check` does.

    `problem` is as for `rotsolve.solve`, a solution, or the path of a sheet file. `answers` are a dict by the names under `find`,
    {"a": "2mg/(2m+M)"}, with `working` if there is some; a text with a line for each, "a = 4.36 m/s^2"; or the path of a file, a
    `pathlib.Path`. Those to a sheet are named as on the command line: {"1.a": …, "roll.a": …}, {"roll": {"a": …, "working": …}}.
    `variant` is the number of the student's own numbers, `variants` how many there are, `seed` that of the key. Raises HandedInError for
    answers that can't be read, NotMarked for a variant that is none, SceneError and Unsolvable as `solve` does.
    """
    if isinstance(problem, (str, os.PathLike)):
        examination = Examination.of_file(problem, seed, variants)
    else:
        scene = problem.problem if isinstance(problem, Solution) else problem
        examination = Examination.of_scene(scene, seed, variants)
    papers = papers_of(answers, examination.task)
    told = papers[0].variant or ("" if variant is None else str(variant))
    marked = examination.mark_one([replace(paper, variant=told) for paper in papers])
    return CheckedPaper(examination.task, marked, papers[0].student, told)


def papers_of(answers: Answers, task: SheetTask) -> tuple[Paper, ...]:
    """What is handed in to each problem, whatever form it has."""
    if isinstance(answers, Mapping):
        return read_map_of_student(written_yaml(as_typed(answers)), "<dict>", task)
    if isinstance(answers, os.PathLike):
        file = os.fspath(answers)
        return read_papers_of_student(content_of(file), file, task)
    if not isinstance(answers, str):
        raise TypeError(f"answers are a dict, a text or a path, not {answers!r}")
    if "\n" not in answers.strip():
        return papers_of_answers((answers.strip(),), task, "<text>")
    return read_papers_of_student(answers, "<text>", task)


def as_typed(answers: Mapping[str, object]) -> dict[str, object]:
    """Answers as texts, numbers, lists and maps, without those that are None."""
    typed = {name: as_typed(told) if isinstance(told, Mapping) else told for name, told in answers.items()}
    return {name: str(told) if is_expression(told) else told for name, told in typed.items() if told is not None}


def is_expression(value: object) -> bool:
    """Whether a value is an expression of SymPy, whose text is that of a formula."""
    return type(value).__module__.partition(".")[0] == "sympy"


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
    """A paper that has been marked: verdicts by the names under `find`, `checked["a"].outcome`, of a sheet `checked["1.a"]`; printed, it is
    the student's page."""

    task: SheetTask
    marked: MarkedSheet
    student: str = ""
    variant: str = ""

    @property
    def verdicts(self) -> dict[str, VerdictView]:
        """The verdicts by the names under `find`, of a sheet behind the number of their problem; what has no answer is among them."""
        keys = map(self.task.key, self.task.asked())
        return {key: VerdictView(part) for key, part in zip(keys, self.marked.parts, strict=True)}

    @property
    def working(self) -> tuple[VerdictView, ...]:
        """The verdicts on the lines of working, in the order of the problems."""
        return tuple(VerdictView(line) for one in self.marked.problems for line in one.lines)

    @property
    def problems(self) -> tuple[CheckedPaper, ...]:
        """The paper to each problem of a sheet by itself."""
        return tuple(
            CheckedPaper(SheetTask(task.title, (task,)), MarkedSheet((marked,)), self.student, self.variant)
            for task, marked in zip(self.task.tasks, self.marked.problems, strict=True)
        )

    @property
    def right(self) -> bool:
        """Whether every answer is right, and no line of working wrong."""
        return self.marked.all_right

    @property
    def marks(self) -> float:
        """The sum of the marks."""
        return float(self.marked.marks)

    @property
    def of(self) -> float:
        """How many marks there are."""
        return float(self.marked.of)

    def __getitem__(self, name: str) -> VerdictView:
        """The verdict on an answer, by its name in any spelling; of a sheet `1.a`, `roll.a`, or `a` where one problem alone asks it."""
        meant, verdicts = self.task.meant(name), self.verdicts
        if meant is None or self.task.key(meant) not in verdicts:
            raise KeyError(f"nothing is asked by the name `{name}`: {hint(name, verdicts, 'asked')}")
        return verdicts[self.task.key(meant)]

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
        return StudentPage(self.task, self.marked, Student(self.student), self.variant)

    def __str__(self) -> str:
        return self.to("text").rstrip("\n")

    def __repr__(self) -> str:
        outcomes = ", ".join(f"{name}: {one.outcome}" for name, one in self.verdicts.items())
        return f"<CheckedPaper {outcomes}; {self.marks:g} of {self.of:g}>"

    def _repr_html_(self) -> str:
        from rotsolve.page.html_rows import notebook_piece

        return notebook_piece(format_named("html").body(self._page, WIDTH))
