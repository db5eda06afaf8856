"""Many: a class, marked row by row, and its report in a folder or its summary on the page."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from msgspec.structs import replace

from rotsolve.grading.course.command import ALL_RIGHT, NOT_ALL_RIGHT, CheckRequest, refuse_check, show_page
from rotsolve.grading.course.examination import Examination
from rotsolve.grading.course.handed_in import content_of
from rotsolve.grading.course.overrides import OVERRIDES, read_overrides, with_overrides
from rotsolve.grading.course.papers import PAPERS, KnownStudents, papers_table, read_papers, with_file
from rotsolve.grading.course.questions import SheetTask
from rotsolve.grading.course.report.folder import MARKS, SUMMARY, byte_order, write_report
from rotsolve.grading.course.report.gradebooks import CANVAS, MOODLE, known_to_canvas, known_to_moodle, with_all_marks
from rotsolve.grading.course.report.results import MarkedClass, Result
from rotsolve.grading.course.report.summary import SummaryPage
from rotsolve.grading.course.report.tally import NAMED, head_of_class
from rotsolve.grading.course.stream.cluster import joined_cluster
from rotsolve.grading.course.stream.elsewhere import size_and_way
from rotsolve.grading.course.stream.papers import is_parquet, open_papers
from rotsolve.grading.course.students import names_apart
from rotsolve.grading.course.table import Entry, Handed, gathered_class, read_table, varied_entry
from rotsolve.page.formats import FORMATS, PAGES, format_named
from rotsolve.run import advancing, same_file
from rotsolve.run.delivery import write_file

TOLD = {
    MOODLE: "Moodle finds students by their number, email address or user name, which the class does not tell",
    CANVAS: "Canvas finds students by their number, user name or name, which the class does not tell",
}
HTML = "html"  # the pages of a report, where nothing else is asked for


def check_class(request: CheckRequest, examination: Examination) -> int:
    """Mark a class; the exit code says whether all of it is right."""
    fault = report_objection(request)
    if fault:
        return refuse_check(f"error: {fault}")
    handed = handed_in(request.answers, examination.task)
    rows, merged = handed.entries, tuple[str, ...]()
    if request.output is not None:
        earlier, separator = ([], "") if request.anew else read_papers(Path(request.output), examination.task)
        same = separator or handed.columns.separator  # tables of a report stay as they are
        handed = replace(handed, columns=replace(handed.columns, separator=same))
        rows = tuple(with_file(earlier, rows))
        merged = tuple(what_was_merged(earlier, rows, handed.entries)) if earlier else ()
    course = marked_course(request, examination, handed, rows)
    course = replace(course, merged=merged)
    failed = report_class(course, request, rows) if request.output else show_page(SummaryPage(course), request, None)
    return failed or (ALL_RIGHT if course.tally.all_faultless else NOT_ALL_RIGHT)


def handed_in(file: str, task: SheetTask) -> Handed:
    """The class in a file."""
    if not is_parquet(file):
        return read_table(content_of(file), Path(file).name, task)
    papers = open_papers(file, task)
    return gathered_class(papers.columns, papers.entries, file)


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
        for own in (MARKS, PAPERS, OVERRIDES, MOODLE, CANVAS):
            if same_file(str(Path(request.output, own)), name):
                return f"{name} would be overwritten"
    return ""


def what_was_merged(earlier: Sequence[Entry], rows: Sequence[Entry], fresh: Sequence[Entry]) -> Iterator[str]:
    """What came of papers of earlier runs and those of this one."""
    file, holders = fresh[0].file, KnownStudents(rows).all
    known = {entry.file for entry in earlier}
    own = [holder for holder in holders if any(entry.file == file for entry in holder.rows)]
    new = [holder for holder in own if all(entry.file == file for entry in holder.rows)]
    if file not in known:
        again = f"{len(own) - len(new)} of students who had handed in before"
        yield f"{papers_in_words(len(own))} from {file}, {again}."
    kept = [holder for holder in holders if holder not in own]
    told = {(entry.line, entry.student) for entry in fresh}  # what can't be told whose it is has lost its papers
    left = [holder for holder in own if not any((entry.line, entry.student) in told for entry in holder.rows)]
    if left:
        names = ", ".join(holder.student.called for holder in left[:NAMED])
        yield f"Not in {file} any more, but kept from an earlier run: {names}{', …' if len(left) > NAMED else ''}. --anew forgets them."
    if kept:
        yield f"{papers_in_words(len(kept))} of earlier runs, from {', '.join(sorted({one.rows[-1].file for one in kept}))}, kept."


def papers_in_words(number: int) -> str:
    return f"{number} {'paper' if number == 1 else 'papers'}"


def marked_course(
    request: CheckRequest, examination: Examination, handed: Handed, rows: Sequence[Entry]
) -> MarkedClass:
    """All students of a class, marked, with the marks by hand that the report has."""
    entries = [varied_entry(holder.counting, request.variant) for holder in KnownStudents(rows).all]
    names = names_apart([(entry.student, entry.place) for entry in entries])
    known = [(entry.student, name) for entry, name in zip(entries, names, strict=True)]
    by_hand = {} if request.output is None else read_overrides(Path(request.output), examination.task, known)
    with joined_cluster(request.cluster) as cluster, advancing("marking") as tell:
        elsewhere = size_and_way(examination, len(entries), request.jobs, cluster)
        marked = examination.mark([entry.papers for entry in entries], tell, *elsewhere)
    results = []
    for place, (entry, name, sheet) in enumerate(zip(entries, names, marked, strict=True)):
        own = tuple(by_hand.get(place, ()))
        results.append(Result(entry, name, with_overrides(sheet, own), own))
    return MarkedClass(examination.task, handed.columns, tuple(results), handed.byte_order_mark, examination.seed)


def report_class(course: MarkedClass, request: CheckRequest, rows: Sequence[Entry]) -> int:
    """The folder, and on standard output what is in it."""
    folder, pages = Path(request.output or "."), format_named(request.format or HTML)
    folder.mkdir(parents=True, exist_ok=True)
    table = papers_table(rows, course.task, course.columns.separator, byte_order(course))
    if failed := write_file(str(folder / PAPERS), table):
        return failed
    with advancing("writing") as tell:
        failed = write_report(course, folder, pages, tell)
    if not failed:
        head = head_of_class(course.task, course.columns, course.held, course.tally, course.seed)
        for said in (*head, *course.merged, *absent_from_gradebooks(course)):
            print(said)
        print(f"The summary is {folder / f'{SUMMARY}{pages.suffixes[0]}'}, the marks are in {folder / MARKS}.")
    return failed


def absent_from_gradebooks(course: MarkedClass) -> Iterator[str]:
    """How many are not in the tables for gradebooks, and why."""
    for name, kept in ((MOODLE, known_to_moodle(course)), (CANVAS, known_to_canvas(course))):
        left = len(course.results) - len(kept)
        if not kept and with_all_marks(course):
            yield f"{name} is empty: {TOLD[name]}."
        elif left:
            waiting = len(course.results) - len(with_all_marks(course))
            reasons = [f"{waiting} with marks still to be given"] if waiting else []
            reasons += [f"{left - waiting} whom nothing tells from others there"] if left > waiting else []
            yield f"Left out of {name}: {' and '.join(reasons)}."
