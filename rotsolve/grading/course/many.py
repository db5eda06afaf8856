"""Many: a class, marked row by row, and its report in a folder or its summary on the page."""

from __future__ import annotations

import sys
from pathlib import Path

from msgspec.structs import replace

from rotsolve.grading.course.command import ALL_RIGHT, BAD, NOT_ALL_RIGHT, CheckRequest, all_right, show_page
from rotsolve.grading.course.examiner import Judges, mark_papers
from rotsolve.grading.course.report.folder import MARKS, SUMMARY, write_report
from rotsolve.grading.course.report.summary import (
    MarkedClass,
    Result,
    SummaryPage,
    doubtful_variants,
    overview,
    without_column,
)
from rotsolve.grading.course.sheet import content_of
from rotsolve.grading.course.table import Entry, read_table
from rotsolve.grading.verdict import Marked, Paper
from rotsolve.page.formats import FORMATS, PAGES, format_named
from rotsolve.page.text import plain_text
from rotsolve.run import advancing, same_file

HTML = "html"  # the pages of a report, where nothing else is asked for


def check_class(request: CheckRequest, judges: Judges) -> int:
    """Mark a class; the exit code says whether all of it is right."""
    fault = report_objection(request)
    if fault:
        print(f"error: {fault}", file=sys.stderr)
        return BAD
    course = marked_course(request, judges)
    failed = report_class(course, request) if request.output else show_page(SummaryPage(course), request, None)
    right = all(result.marked is not None and all_right(result.marked) for result in course.results)
    return failed or (ALL_RIGHT if right else NOT_ALL_RIGHT)


def report_objection(request: CheckRequest) -> str:
    """Why the report can't be where or as it is asked for, '' where it can."""
    if request.output is None:
        return ""
    if Path(request.output).exists() and not Path(request.output).is_dir():
        return f"{request.output} is a file; the report of a class is a folder"
    if request.format is not None and format_named(request.format).use != PAGES:
        *pages, last = (item.name for item in FORMATS.values() if item.use == PAGES)
        return f"the pages of a report are {', '.join(pages)} or {last}; leave out -f {request.format}, or -o"
    for name in (request.answers, request.problem):
        if same_file(str(Path(request.output, MARKS)), name):
            return f"{name} would be overwritten"
    return ""


def marked_course(request: CheckRequest, judges: Judges) -> MarkedClass:
    """All rows of the table, marked."""
    task = judges.task
    handed = read_table(content_of(request.answers), request.answers, tuple(task.letters), task.parts)
    papers = [entry.paper for entry in handed.entries]
    if request.variant is not None:
        own = str(request.variant)
        papers = [replace(paper, variant=own) if paper and not paper.variant else paper for paper in papers]
    found: list[Marked | str] = ["" for _ in papers]
    with advancing("marking") as tell:
        for done, (place, marked) in enumerate(mark_papers(papers, judges.judge), 1):
            found[place] = marked
            tell(done / len(papers))
    results = tuple(map(result_of_row, handed.entries, papers, found))
    seed = judges.seed if judges.problem.vary is not None else None
    return MarkedClass(task, handed.columns, results, handed.byte_order_mark, seed)


def result_of_row(entry: Entry, paper: Paper | None, marked: Marked | str) -> Result:
    """A row with its marks, or with the reason why it has none."""
    if isinstance(marked, Marked):
        return Result(replace(entry, paper=paper), marked)
    return Result(replace(entry, paper=paper, remarks=(*entry.remarks, *((marked,) if marked else ()))), None)


def report_class(course: MarkedClass, request: CheckRequest) -> int:
    """The folder, and on standard output what is in it."""
    folder, pages = Path(request.output or "."), format_named(request.format or HTML)
    with advancing("writing") as tell:
        failed = write_report(course, folder, pages, tell)
    if not failed:
        for paragraph in (*overview(course), *without_column(course), *doubtful_variants(course)):
            print(plain_text(paragraph.words))
        print(f"The summary is {folder / f'{SUMMARY}{pages.suffixes[0]}'}, the marks are in {folder / MARKS}.")
    return failed
