"""Report: the folder of a class: a page a student, the summary, and last the marks; each file is whole or not there.

What an earlier run has left is removed first, so that a folder with `marks.csv` in it is complete and of one run.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

from rotsolve.grading.course.report.marks import marks_table
from rotsolve.grading.course.report.results import Course, Result
from rotsolve.grading.course.report.student import student_page
from rotsolve.grading.course.report.summary import summary_page
from rotsolve.grading.course.showing import Layout
from rotsolve.run.delivery import write_file

STUDENTS, SUMMARY, MARKS = "students", "summary", "marks.csv"
PAGES = re.compile(r"\d{4,}(-.*)?\.(html|md)|\.\d{4,}.*\.\d+\.new")  # of students, and what was not written to its end
ABOVE = re.compile(r"marks\.csv|summary\.(html|md)|\.(marks|summary)\.\w+\.\d+\.new")
BYTES = 80  # of a student's name in the name of a file


def write_report(course: Course, folder: Path, layout: Layout, tell: Callable[[float], None]) -> int:
    """Write all files, telling which part is done; the exit code says whether it could be done."""
    clear(folder, ABOVE)
    (folder / STUDENTS).mkdir(parents=True, exist_ok=True)
    clear(folder / STUDENTS, PAGES)
    targets = tuple(
        f"{STUDENTS}/{file_name(number, result)}{layout.suffix}" for number, result in enumerate(course.results, 1)
    )
    for number, (result, target) in enumerate(zip(course.results, targets, strict=True), 1):
        if result.marked is not None:
            page = student_page(course.task, result.marked, result.variant)
            if code := write_file(str(folder / target), layout.document(page)):
                return code
        tell(number / len(targets))
    linked = tuple(
        target if result.marked is not None else "" for result, target in zip(course.results, targets, strict=True)
    )
    summary = layout.document(summary_page(course, linked))
    return write_file(str(folder / f"{SUMMARY}{layout.suffix}"), summary) or write_file(
        str(folder / MARKS), marks_table(course)
    )


def clear(folder: Path, ours: re.Pattern[str]) -> None:
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
