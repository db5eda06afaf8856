"""Many: a class, marked row by row, and its report in a folder or its summary on the page."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from rotsolve.grading.course.command import ALL_RIGHT, NOT_ALL_RIGHT, CheckRequest, refuse_check, show_page
from rotsolve.grading.course.examiner import Judges, mark_papers
from rotsolve.grading.course.report.folder import MARKS, SUMMARY, write_report
from rotsolve.grading.course.report.summary import MarkedClass, SummaryPage, head_of_class, result_of_row
from rotsolve.grading.course.sheet import Parts, content_of
from rotsolve.grading.course.stream.assignment import BATCH, numbered_batches
from rotsolve.grading.course.stream.cluster import Cluster
from rotsolve.grading.course.stream.marker import assignment_of, papers_of_worker
from rotsolve.grading.course.stream.papers import is_parquet, open_papers
from rotsolve.grading.course.table import Entry, Handed, gathered_class, read_table, varied_entry
from rotsolve.grading.verdict import Marked
from rotsolve.page.formats import FORMATS, PAGES, format_named
from rotsolve.run import advancing, same_file

HTML = "html"  # the pages of a report, where nothing else is asked for


def check_class(request: CheckRequest, judges: Judges) -> int:
    """Mark a class; the exit code says whether all of it is right."""
    fault = report_objection(request)
    if fault:
        return refuse_check(f"error: {fault}")
    course = marked_course(request, judges)
    failed = report_class(course, request) if request.output else show_page(SummaryPage(course), request, None)
    tally = course.tally
    return failed or (ALL_RIGHT if tally.faultless == tally.papers else NOT_ALL_RIGHT)


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
    handed = handed_in(request.answers, tuple(task.letters), task.parts)
    entries = [varied_entry(entry, request.variant) for entry in handed.entries]
    found: list[Marked | str] = ["" for _ in entries]
    with advancing("marking") as tell:
        for done, (place, marked) in enumerate(marked_in_turn(entries, judges, request.cluster), 1):
            found[place] = marked
            tell(done / len(entries))
    results = tuple(map(result_of_row, entries, found))
    seed = judges.seed if judges.problem.vary is not None else None
    return MarkedClass(task, handed.columns, results, handed.byte_order_mark, seed)


def handed_in(file: str, asked: tuple[str, ...], parts: Parts) -> Handed:
    """The class in a file."""
    if not is_parquet(file):
        return read_table(content_of(file), file, asked, parts)
    papers = open_papers(file, asked, parts)
    return gathered_class(papers.columns, papers.entries, file)


def marked_in_turn(entries: Sequence[Entry], judges: Judges, cluster: str | None) -> Iterator[tuple[int, Marked | str]]:
    """The place of each paper with its marks, or why it has none, as they come: by the judges here, or by a cluster."""
    papers = [entry.paper for entry in entries]
    if cluster is None:
        yield from mark_papers(papers, judges.judge)
        return
    with Cluster(cluster) as workers:
        batches = numbered_batches(papers)
        for number, marks in workers.each(papers_of_worker, assignment_of(judges), batches):
            yield from enumerate(marks, number * BATCH)


def report_class(course: MarkedClass, request: CheckRequest) -> int:
    """The folder, and on standard output what is in it."""
    folder, pages = Path(request.output or "."), format_named(request.format or HTML)
    with advancing("writing") as tell:
        failed = write_report(course, folder, pages, tell)
    if not failed:
        print("\n".join(head_of_class(course.task, course.columns, course.tally, course.seed)))
        print(f"The summary is {folder / f'{SUMMARY}{pages.suffixes[0]}'}, the marks are in {folder / MARKS}.")
    return failed
