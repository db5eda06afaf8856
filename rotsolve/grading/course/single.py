"""Single: the answers of one student, marked and shown."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from msgspec.structs import replace

from rotsolve.core.faults import Fault
from rotsolve.grading.course.examiner import NotMarked, variant_of
from rotsolve.grading.course.handing.content import HandedInError, content_of
from rotsolve.grading.course.handing.sheet import from_answers, read_sheet
from rotsolve.grading.course.judges import Judges
from rotsolve.grading.course.report.page import Task
from rotsolve.grading.course.report.student import student_page
from rotsolve.grading.course.request import ALL_RIGHT, NOT_ALL_RIGHT, Request
from rotsolve.grading.verdict import RIGHT, WRONG, Marked, Paper
from rotsolve.run import coloured
from rotsolve.run.attempt import name_of


def check(request: Request, judges: Judges) -> int:
    """Mark one paper; the exit code says whether all of it is right."""
    paper = handed_in(request, tuple(judges.task.letters))
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
    failed = show(request, judges.task, marked, paper.variant)
    return failed or (ALL_RIGHT if all_right(marked) else NOT_ALL_RIGHT)


def handed_in(request: Request, asked: Sequence[str]) -> Paper:
    """The paper: as typed on the command line, or in a file."""
    if request.typed:
        return from_answers(request.typed, asked)
    return read_sheet(content_of(request.answers), name_of(request.answers), asked)


def answered(marked: Marked) -> Marked:
    """The paper without what was not answered."""
    parts = tuple(part for part in marked.parts if part.text)
    return replace(marked, parts=parts, marks=sum(part.marks for part in parts), of=sum(part.of for part in parts))


def all_right(marked: Marked) -> bool:
    """Whether every answer is right, and no line of working wrong."""
    answers = all(part.verdict.outcome == RIGHT for part in marked.parts)
    return answers and not any(line.verdict.outcome == WRONG for line in marked.lines)


def show(request: Request, task: Task, marked: Marked, variant: str) -> int:
    """Write the page to the file or to standard output; the exit code of a failure, else 0."""
    if request.shown_as == "json":
        from rotsolve.grading.course.showing.json import paper

        return written(paper(task.title, marked, variant), request.output)
    page = student_page(task, marked, variant)
    if request.shown_as != "text":
        from rotsolve.grading.course.showing import layout_named

        return written(layout_named(request.shown_as).document(page), request.output)
    from rotsolve.grading.course.showing.text import lines
    from rotsolve.render import layout

    found = lines(page, request.width)
    if request.output is None and coloured():
        from rotsolve.render.terminal import show as show_coloured

        show_coloured(found, sys.stdout)
        return ALL_RIGHT
    return written(layout.page(found), request.output)


def written(text: str, output: str | None) -> int:
    """Write the text to a file, whole or not at all, or to standard output."""
    if output is not None:
        from rotsolve.run.delivery import write_file

        return write_file(output, text)
    sys.stdout.write(text)
    return ALL_RIGHT
