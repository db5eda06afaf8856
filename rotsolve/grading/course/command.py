"""Command: `rotsolve check`: mark the answers of one student or of a class, show what came out, and work out the exit code."""

from __future__ import annotations

import os
import sys

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.core.faults import Fault, RotsolveError, SceneError
from rotsolve.grading.course.examiner import Judges, NotMarked, variant_of
from rotsolve.grading.course.report.student import StudentPage
from rotsolve.grading.course.sheet import HandedInError, content_of, from_answers, read_sheet
from rotsolve.grading.verdict import Marked
from rotsolve.page.blocks import Page
from rotsolve.page.formats import TERMINAL, format_named, format_of_file
from rotsolve.page.text import PRINTER, plain_text
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
        judges = Judges(scene, request.seed, request.variants)
    except Exception as error:
        return refuse_check(failure_outcome(request.problem, error).message)
    for found in judges.solution.checks:
        if found.holds is False:
            said = plain_text(found.words)
            return refuse_check(f"error: the answers of {name_of(request.problem)} do not hold: {said}")
    try:
        if request.marks_alone:
            from rotsolve.grading.course.stream.run import mark_stream

            return mark_stream(request, judges)
        if request.of_class:
            from rotsolve.grading.course.many import check_class

            return check_class(request, judges)
        return check_one(request, judges)
    except SceneError as error:
        return refuse_check(error.render())
    except RotsolveError as error:
        return refuse_check(f"error: {error}")
    except OSError as error:
        return refuse_check(f"error: cannot write {request.output or name_of('')}: {error.strerror or error}")


def refuse_check(message: str) -> int:
    print(message, file=sys.stderr)
    return BAD


def check_one(request: CheckRequest, judges: Judges) -> int:
    """Mark one paper; the exit code says whether all of it is right."""
    asked = tuple(judges.task.letters)
    if request.typed:
        paper = from_answers(request.typed, asked, judges.task.parts)
    else:
        paper = read_sheet(content_of(request.answers), name_of(request.answers), asked, judges.task.parts)
    if not paper.variant and request.variant is not None:
        paper = replace(paper, variant=str(request.variant))
    try:
        marked = judges.judge(variant_of(paper)).mark(paper)
    except NotMarked as reason:
        raise HandedInError([Fault(str(reason), None, "", "variant")], (), name_of(request.answers)) from None
    if request.typed:
        marked = answered(marked)
    elif judges.problem.vary is not None and not paper.variant:
        print("note: no variant is told: marked with the numbers of the problem itself", file=sys.stderr)
    failed = show_page(StudentPage(judges.task, marked, paper.variant), request, request.output)
    return failed or (ALL_RIGHT if marked.all_right else NOT_ALL_RIGHT)


def answered(marked: Marked) -> Marked:
    """The paper without what was not answered."""
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
