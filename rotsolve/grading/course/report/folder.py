"""Report: the folder of a class: a page a student, the summary, tables for gradebooks, and last the marks; each file is whole or not there.

What an earlier run has left is removed first, so that a folder with `marks.csv` in it is complete and of one run. What was handed in and
the marks by hand stay: the papers are written before anything is marked by them.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Callable, Sequence
from io import StringIO
from pathlib import Path

from rotsolve.grading.course.handed_in import MARK
from rotsolve.grading.course.marked import UNMARKED
from rotsolve.grading.course.overrides import OVERRIDES, empty_overrides
from rotsolve.grading.course.questions import SheetTask
from rotsolve.grading.course.report.gradebooks import CANVAS, MOODLE, canvas_table, moodle_table
from rotsolve.grading.course.report.results import MarkedClass, Result
from rotsolve.grading.course.report.student import StudentPage, marks_text
from rotsolve.grading.course.report.summary import SummaryPage
from rotsolve.page.formats import FORMATS, Format
from rotsolve.page.text import plain_text
from rotsolve.run.delivery import harmless, write_file

STUDENTS, SUMMARY, MARKS = "students", "summary", "marks.csv"
HEAD = ("line", "student", "number", "variant")  # the columns that a row of marks begins with
ENDINGS = "|".join(re.escape(item.suffixes[0]) for item in FORMATS.values())
# of students, and what was not written to its end
PAGES = re.compile(rf"\d{{4,}}(-.*)?({ENDINGS})|\.\d{{4,}}.*\.\d+\.new")
ABOVE = re.compile(
    rf"marks\.csv|summary({ENDINGS})|gradebook-(moodle|canvas)\.csv|\.(marks|summary|papers|overrides|gradebook-\w+)\.\w+\.\d+\.new"
)
POINT = {";": ","}  # the decimal point where semicolons separate
ASIDE = ("comma", UNMARKED)  # kinds of remarks: of a whole class that writes so, and of what is said of the row already
BYTES = 80  # of a student's name in the name of a file


def write_report(course: MarkedClass, folder: Path, format: Format, tell: Callable[[float], None]) -> int:
    """Write all files, telling which part is done; the exit code says whether it could be done."""
    remove_files(folder, ABOVE)
    (folder / STUDENTS).mkdir(parents=True, exist_ok=True)
    remove_files(folder / STUDENTS, PAGES)
    ending, targets = format.suffixes[0], []
    for number, result in enumerate(course.results, 1):
        target = f"{STUDENTS}/{file_name(number, result)}{ending}" if result.is_marked else ""
        if result.is_marked:
            page = StudentPage(course.task, result.sheet, result.student, result.variant, result.name)
            if code := write_file(str(folder / target), format.file([format.body(page)])):
                return code
        targets.append(target)
        tell(number / len(course.results))
    summary = format.file([format.body(SummaryPage(course, tuple(targets)))])
    tables = ((MOODLE, moodle_table), (CANVAS, canvas_table), (MARKS, marks_table))
    failed = write_file(str(folder / f"{SUMMARY}{ending}"), summary) or begin_overrides(course, folder)
    for name, table in tables:
        failed = failed or write_file(str(folder / name), table(course))
    return failed


def begin_overrides(course: MarkedClass, folder: Path) -> int:
    """An empty table for marks by hand, where there is none yet."""
    path = folder / OVERRIDES
    return 0 if path.exists() else write_file(str(path), empty_overrides(course.columns.separator, byte_order(course)))


def byte_order(course: MarkedClass) -> str:
    """What stands at the start of a table where it stood in the class's."""
    return MARK if course.byte_order_mark else ""


def remove_files(folder: Path, ours: re.Pattern[str]) -> None:
    """Remove the files that an earlier run has written."""
    if folder.is_dir():
        for path in folder.iterdir():
            if ours.fullmatch(path.name) and path.is_file():
                path.unlink()


def file_name(number: int, result: Result) -> str:
    """`0012-ada-lovelace-4711`: the place in the class makes it the only one of its name."""
    words = "-".join(re.findall(r"\w+", f"{result.student.called} {result.student.number}".lower()))
    kept = words.encode("utf-8")[:BYTES].decode("utf-8", errors="ignore")
    return f"{number:04d}-{kept}" if kept else f"{number:04d}"


def marks_table(course: MarkedClass) -> str:
    """A row a student, with the file that it is of where there are several."""
    text = StringIO()
    separator, several = course.columns.separator, len(course.files) > 1
    writer = csv.writer(text, delimiter=separator, lineterminator="\n")
    writer.writerow([*(["file"] if several else []), *marks_columns(course.task)])
    for result in course.results:
        file = [one_line(result.entry.file)] if several else []
        writer.writerow([*file, *spreadsheet_row(marks_row(course.task, result), separator)])
    return byte_order(course) + text.getvalue()


def marks_columns(task: SheetTask) -> list[str]:
    """What the columns of a table of marks are called."""
    answers = [cell for asked in task.asked() for cell in (f"{task.key(asked)} verdict", task.key(asked))]
    problems = [f"problem {one.number}" for one in task.tasks] if task.is_sheet else []
    return [*HEAD, *answers, *problems, "marks", "of", "remarks"]


def marks_row(task: SheetTask, result: Result) -> list[str]:
    """Whose row it is, outcome and marks of each answer, on a sheet the marks of each problem, the sum, and all that is said of them."""
    called = result.name if result.student.called else ""
    whose = [str(result.entry.line), called, result.student.number, result.variant]
    return [*whose, *outcomes_and_marks(task, result), all_remarks(task, result)]


def spreadsheet_row(row: Sequence[str], separator: str) -> list[str]:
    """A row of marks as a spreadsheet reads it whose cells are separated so."""
    point = POINT.get(separator, ".")
    numbers = (cell.replace(".", point) for cell in row[len(HEAD) : -1])
    return [*map(one_line, row[: len(HEAD)]), *numbers, one_line(row[-1])]


def outcomes_and_marks(task: SheetTask, result: Result) -> list[str]:
    """Outcome and marks of each answer, marks of each problem, the sum, and how many there are; no number where nothing was marked."""
    sheet = result.sheet
    numbers = [marks_text(one.marks) for one in sheet.problems] if task.is_sheet else []
    cells = [cell for part in sheet.parts for cell in (part.verdict.outcome, marks_text(part.marks))]
    if not result.is_marked:
        outcomes = [cell for part in sheet.parts for cell in (part.verdict.outcome, "")]
        return [*outcomes, *([""] * len(numbers)), "", ""]
    return [*cells, *numbers, marks_text(sheet.marks), marks_text(sheet.of)]


def all_remarks(task: SheetTask, result: Result) -> str:
    """What is to be said of the row, then of each answer."""
    sentences = [*result.entry.remarks, *map(plain_text, result.unmarked(task))]
    for asked, part in zip(task.asked(), result.sheet.parts, strict=True):
        told = [remark for remark in part.verdict.remarks if remark.kind not in ASIDE]
        sentences += [f"{task.key(asked)}: {plain_text(remark.words)}" for remark in told]
    return "; ".join(sentences)


def one_line(text: str) -> str:
    """A text in one line, with nothing in it that a spreadsheet would work out."""
    return harmless(" ".join(text.split()))
