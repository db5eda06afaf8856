"""Marks: the table of a class for a spreadsheet, separated as the class's own table is, with nothing that a spreadsheet would run."""

from __future__ import annotations

import csv
from io import StringIO

from rotsolve.grading.course.report.page import amount
from rotsolve.grading.course.report.results import Course, Result
from rotsolve.grading.course.sheet import MARK
from rotsolve.grading.verdict import Marked
from rotsolve.render.layout import release
from rotsolve.render.voice import TEXT
from rotsolve.run.delivery import harmless

POINT = {";": ","}  # the decimal point where semicolons separate


def marks_table(course: Course) -> str:
    """A row a student: the answers' verdicts and marks, the sum, and all that is said of them."""
    text = StringIO()
    separator = course.columns.separator
    writer = csv.writer(text, delimiter=separator, lineterminator="\n")
    names = tuple(course.task.letters)
    writer.writerow(
        [
            "line",
            "student",
            "variant",
            *(cell for name in names for cell in (f"{name} verdict", name)),
            "marks",
            "of",
            "remarks",
        ]
    )
    for result in course.results:
        numbers, remarks = figures(result.marked, names), said(result)
        row = [str(result.entry.line), kept(result.entry.student), kept(result.variant)]
        writer.writerow([*row, *(cell.replace(".", POINT.get(separator, ".")) for cell in numbers), kept(remarks)])
    return (MARK if course.byte_order_mark else "") + text.getvalue()


def figures(marked: Marked | None, names: tuple[str, ...]) -> list[str]:
    """Verdict and marks of each answer, the sum, and how many there are; nothing where a row was not marked."""
    if marked is None:
        return [""] * (2 * len(names) + 2)
    parts = {part.name: part for part in marked.parts}
    cells = []
    for name in names:
        part = parts[name]
        cells += [part.verdict.outcome if part.text else "no answer", amount(part.marks)]
    return [*cells, amount(marked.marks), amount(marked.of)]


def said(result: Result) -> str:
    """What is to be said of the row, then of each answer."""
    sentences = list(result.entry.remarks)
    for part in result.marked.parts if result.marked is not None else ():
        told = [remark for remark in part.verdict.remarks if remark.kind != "comma"]  # of a whole class that writes so
        sentences += [f"{part.name}: {release(TEXT.words(remark.words))}" for remark in told]
    return "; ".join(sentences)


def kept(text: str) -> str:
    """A text in one line, with nothing in it that a spreadsheet would work out."""
    return harmless(" ".join(text.split()))
