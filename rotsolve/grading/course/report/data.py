"""Data: what was marked as plain values for programs: every text as it was handed in, marks as fractions and as numbers."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from rotsolve.grading.verdict import JudgedLine, JudgedPart, Marked, Verdict
from rotsolve.page.text import plain_text

if TYPE_CHECKING:
    from rotsolve.grading.course.report.summary import MarkedClass, Result


def class_data(found: MarkedClass) -> dict[str, Any]:
    """A class with all its papers."""
    return {"problem": found.task.title, "papers": [result_data(result) for result in found.results]}


def result_data(result: Result) -> dict[str, Any]:
    """A row of a class: its line, its remarks, and, where it was marked, its paper."""
    row = {"line": result.entry.line, "remarks": list(result.entry.remarks)}
    if result.marked is None:
        return {"student": result.entry.student, "variant": result.variant, "marked": False, **row}
    return {**marked_data(result.marked, result.variant), "marked": True, **row}


def marked_data(marked: Marked, variant: str) -> dict[str, Any]:
    return {
        "student": marked.student,
        "variant": variant,
        "answers": [part_data(part) for part in marked.parts],
        "working": [line_data(line) for line in marked.lines],
        "marks": marks_data(marked.marks),
        "of": marks_data(marked.of),
    }


def part_data(part: JudgedPart) -> dict[str, Any]:
    marks = {"marks": marks_data(part.marks), "of": marks_data(part.of), "followed": part.followed}
    return {"name": part.name, "text": part.text, **verdict_data(part.verdict), **marks}


def line_data(line: JudgedLine) -> dict[str, Any]:
    return {"text": line.text, **verdict_data(line.verdict), "first_wrong": line.first_wrong}


def verdict_data(verdict: Verdict) -> dict[str, Any]:
    """Outcome, reading and remarks; columns count from 0, the end is the one behind the last."""
    remarks = [
        {"kind": remark.kind, "text": plain_text(remark.words), "start": remark.start, "end": remark.end}
        for remark in verdict.remarks
    ]
    return {"outcome": verdict.outcome, "read_as": verdict.read_as, "remarks": remarks}


def marks_data(marks: Fraction) -> dict[str, Any]:
    return {"exact": str(marks), "number": float(marks)}
