"""Command: `rotsolve check`: mark the answers of one student or of a class, show what came out, and work out the exit code."""

from __future__ import annotations

import os
import sys

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.core.faults import Fault, RotsolveError, SceneError
from rotsolve.grading.course.by_problem import papers_of_answers, read_papers_of_student
from rotsolve.grading.course.examination import Examination
from rotsolve.grading.course.examiner import NotMarked
from rotsolve.grading.course.handed_in import HandedInError, content_of
from rotsolve.grading.course.marked import MarkedSheet
from rotsolve.grading.course.questions import SheetTask
from rotsolve.grading.course.report.student import StudentPage
from rotsolve.grading.course.students import Student
from rotsolve.grading.verdict import Marked
from rotsolve.page.blocks import Page
from rotsolve.page.formats import TERMINAL, format_named, format_of_file
from rotsolve.page.text import PRINTER
from rotsolve.run import coloured
from rotsolve.run.attempt import PIPED, failure_outcome, name_of, piped, scene_source

ALL_RIGHT, NOT_ALL_RIGHT, BAD = 0, 1, 2
TABLES = (".csv", ".tsv", ".tab", ".parquet")
SEED = 1


class CheckRequest(Struct, frozen=True):
    """The problem, the answers in a file (`-` for standard input) or as typed, and how they are marked and shown."""

    problem: str
    answers: str = ""
    typed: tuple[str, ...] = ()
    output: str | None = None
    format: str | None = None
    variant: int | None = None
    variants: int | None = None
    seed: int = SEED
    width: int = 120
    jobs: int = 1
    shows_right: bool = False
    anew: bool = False
    cluster: str | None = None  # the address of a scheduler, whose workers mark

    @property
    def of_class(self) -> bool:
        """Whether the answers are a table."""
        return self.answers.lower().endswith(TABLES)

    @property
    def marks_alone(self) -> bool:
        """Whether a class is marked into a table of marks; else into a folder, or its summary is shown."""
        named_so = self.output is not None and self.output.lower().endswith(TABLES)
        return self.of_class and named_so and not os.path.isdir(self.output or "")

    @property
    def shown_as(self) -> str:
        """The format that was asked for, else that of the output file's name, else text."""
        by_name = format_of_file(self.output) if self.output and not self.of_class else None
        return self.format or (by_name.name if by_name else "text")


def run_check(request: CheckRequest) -> int:
    """Mark what is handed in, and write what was asked for."""
    if request.problem == request.answers == PIPED:
        return refuse_check("error: either the problem or the answers can come from standard input")
    try:
        scene = scene_source(request.problem, piped((request.problem,)))
        examination = Examination.of_file(scene, request.seed, request.variants)
    except Exception as error:
        return refuse_check(failure_outcome(request.problem, error).message)
    examination.shows_right = request.shows_right
    if request.of_class:
        examination.label_answers()
    try:
        if request.marks_alone:
            from rotsolve.grading.course.stream.run import mark_stream

            return mark_stream(request, examination)
        if request.of_class:
            from rotsolve.grading.course.many import check_class

            return check_class(request, examination)
        return check_one(request, examination)
    except SceneError as error:
        return refuse_check(error.render())
    except RotsolveError as error:
        return refuse_check(f"error: {error}")
    except OSError as error:
        return refuse_check(f"error: cannot write {request.output or name_of('')}: {error.strerror or error}")


def refuse_check(message: str) -> int:
    print(message, file=sys.stderr)
    return BAD


def check_one(request: CheckRequest, examination: Examination) -> int:
    """Mark the papers of one student; the exit code says whether all of them are right."""
    task = examination.task
    if request.typed:
        papers = papers_of_answers(request.typed, task)
    else:
        papers = read_papers_of_student(content_of(request.answers), name_of(request.answers), task)
    variant = papers[0].variant or ("" if request.variant is None else str(request.variant))
    papers = tuple(replace(paper, variant=variant) for paper in papers)
    try:
        marked = examination.mark_one(papers)
    except NotMarked as reason:
        raise HandedInError([Fault(str(reason), None, "", "variant")], (), name_of(request.answers)) from None
    if request.typed:
        task, marked = only_answered(task, marked)
    elif examination.varies and not variant:
        print("note: no variant is told: marked with the numbers of the problem itself", file=sys.stderr)
    page = StudentPage(task, marked, Student(papers[0].student), variant)
    failed = show_page(page, request, request.output)
    return failed or (ALL_RIGHT if marked.all_right else NOT_ALL_RIGHT)


def only_answered(task: SheetTask, marked: MarkedSheet) -> tuple[SheetTask, MarkedSheet]:
    """The papers without what was not answered, and what was asked of them."""
    kept = [place for place, one in enumerate(marked.problems) if any(part.text for part in one.parts)]
    problems = tuple(answered_problem(marked.problems[place]) for place in kept)
    right = tuple(
        tuple(answer for answer in marked.right[place] if answer.name in {part.name for part in one.parts})
        for place, one in zip(kept, problems, strict=True)
    )
    return replace(task, tasks=tuple(task.tasks[place] for place in kept)), MarkedSheet(problems, right)


def answered_problem(marked: Marked) -> Marked:
    """The paper of one problem without what was not answered."""
    parts = tuple(part for part in marked.parts if part.text)
    return replace(marked, parts=parts, marks=sum(part.marks for part in parts), of=sum(part.of for part in parts))


def show_page(page: Page, request: CheckRequest, output: str | None) -> int:
    """Write a page to a file, whole or not at all, or to standard output; the exit code of a failure, else 0."""
    chosen = format_named(request.shown_as)
    if output is None and chosen.use == TERMINAL and coloured():
        from rotsolve.page.terminal import show

        show(PRINTER.lines(page, request.width), sys.stdout)
        return ALL_RIGHT
    from rotsolve.run.delivery import put_content

    return put_content(output, chosen.file([chosen.body(page, request.width)]))
