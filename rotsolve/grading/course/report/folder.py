"""Report: the folder of a class: a page a student, the summary, and last the marks; each file is whole or not there.

What an earlier run has left is removed first, so that a folder with `marks.csv` in it is complete and of one run.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Callable
from io import StringIO
from pathlib import Path

from rotsolve.grading.course.report.student import StudentPage, marks_text
from rotsolve.grading.course.report.summary import MarkedClass, Result, SummaryPage
from rotsolve.grading.course.sheet import MARK
from rotsolve.grading.verdict import Marked
from rotsolve.page.formats import FORMATS, Format
from rotsolve.page.text import plain_text
from rotsolve.run.delivery import harmless, write_file

STUDENTS, SUMMARY, MARKS = "students", "summary", "marks.csv"
ENDINGS = "|".join(re.escape(item.suffixes[0]) for item in FORMATS.values())
# of students, and what was not written to its end
PAGES = re.compile(rf"\d{{4,}}(-.*)?({ENDINGS})|\.\d{{4,}}.*\.\d+\.new")
ABOVE = re.compile(rf"marks\.csv|summary({ENDINGS})|\.(marks|summary)\.\w+\.\d+\.new")
POINT = {";": ","}  # the decimal point where semicolons separate
BYTES = 80  # of a student's name in the name of a file


def write_report(course: MarkedClass, folder: Path, format: Format, tell: Callable[[float], None]) -> int:
    """Write all files, telling which part is done; the exit code says whether it could be done."""
    remove_files(folder, ABOVE)
    (folder / STUDENTS).mkdir(parents=True, exist_ok=True)
    remove_files(folder / STUDENTS, PAGES)
    ending, targets = format.suffixes[0], []
    for number, result in enumerate(course.results, 1):
        target = "" if result.marked is None else f"{STUDENTS}/{file_name(number, result)}{ending}"
        if result.marked is not None:
            page = StudentPage(course.task, result.marked, result.variant)
            if code := write_file(str(folder / target), format.file([format.body(page)])):
                return code
        targets.append(target)
        tell(number / len(course.results))
    summary = format.file([format.body(SummaryPage(course, tuple(targets)))])
    failed = write_file(str(folder / f"{SUMMARY}{ending}"), summary)
    return failed or write_file(str(folder / MARKS), marks_table(course))


def remove_files(folder: Path, ours: re.Pattern[str]) -> None:
    """Remove the files that an earlier run has written."""
    if folder.is_dir():
        for path in folder.iterdir():
            if ours.fullmatch(path.name) and path.is_file():
                path.unlink()


def file_name(number: int, result: Result) -> str:
    """`0012-ada-lovelace`: the number of the row makes it the only one of its name."""
    words = "-".join(re.findall(r"\w+", result.entry.student.lower()))
    kept = words.encode("utf-8")[:BYTES].decode("utf-8", errors="ignore")
    return f"{number:04d}-{kept}" if kept else f"{number:04d}"


def marks_table(course: MarkedClass) -> str:
    """A row a student: the answers' verdicts and marks, the sum, and all that is said of them."""
    text = StringIO()
    separator = course.columns.separator
    writer = csv.writer(text, delimiter=separator, lineterminator="\n")
    names = tuple(course.task.letters)
    writer.writerow(marks_columns(names))
    writer.writerows(spreadsheet_row(marks_row(result, names), separator) for result in course.results)
    return (MARK if course.byte_order_mark else "") + text.getvalue()


def marks_columns(names: tuple[str, ...]) -> list[str]:
    """What the columns of the marks are called, by the names of the answers."""
    columns = [cell for name in names for cell in (f"{name} verdict", name)]
    return ["line", "student", "variant", *columns, "marks", "of", "remarks"]


def marks_row(result: Result, names: tuple[str, ...]) -> list[str]:
    """The row of a student: line, name and variant, the answers' verdicts and marks, the sum, and all that is said of them."""
    told = [str(result.entry.line), result.entry.student, result.variant]
    return [*told, *verdicts_and_marks(result.marked, names), all_remarks(result)]


def spreadsheet_row(row: list[str], separator: str) -> list[str]:
    """The row as a spreadsheet reads it whose cells are separated so."""
    line, student, variant, *numbers, remarks = row
    point = POINT.get(separator, ".")
    return [
        line,
        one_line(student),
        one_line(variant),
        *(cell.replace(".", point) for cell in numbers),
        one_line(remarks),
    ]


def verdicts_and_marks(marked: Marked | None, names: tuple[str, ...]) -> list[str]:
    """Verdict and marks of each answer, the sum, and how many there are; nothing where a row was not marked."""
    if marked is None:
        return [""] * (2 * len(names) + 2)
    parts = {part.name: part for part in marked.parts}
    cells = []
    for name in names:
        part = parts[name]
        cells += [part.verdict.outcome if part.text else "no answer", marks_text(part.marks)]
    return [*cells, marks_text(marked.marks), marks_text(marked.of)]


def all_remarks(result: Result) -> str:
    """What is to be said of the row, then of each answer."""
    sentences = list(result.entry.remarks)
    for part in result.marked.parts if result.marked is not None else ():
        told = [remark for remark in part.verdict.remarks if remark.kind != "comma"]  # of a whole class that writes so
        sentences += [f"{part.name}: {plain_text(remark.words)}" for remark in told]
    return "; ".join(sentences)


def one_line(text: str) -> str:
    """A text in one line, with nothing in it that a spreadsheet would work out."""
    return harmless(" ".join(text.split()))
