"""Sheets as the command makes them, with the judge of each problem, for the tests of platforms."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from rotsolve.grading.course.examiner import Judges
from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.verdict import JudgedPart, Paper
from rotsolve.keys.command import KeyRequest, Problems, asked_set
from rotsolve.keys.files import SheetFiles
from rotsolve.keys.sheets import Sheet, SheetProblem

ROOT = Path(__file__).resolve().parents[2]


@cache
def sheets_of(*files: str, variants: int = 0) -> tuple[Sheet, ...]:
    request = KeyRequest(files, "", variants=variants)
    return tuple(Problems(asked_set(request), request).sheets(lambda done: None))


def made(writer: SheetFiles, sheets: tuple[Sheet, ...]) -> dict[str, bytes]:
    """The files of a format."""
    files = [file for sheet in sheets for file in writer.add(sheet)]
    return dict([*files, *writer.close()])  # type: ignore[arg-type]


def judge_of(one: SheetProblem) -> Judge:
    """A judge as `rotsolve check` has it."""
    return Judges(one.marked, 0, None).judge_worked(one.worked)


def judged(judge: Judge, name: str, text: str) -> JudgedPart:
    return next(part for part in judge.mark(Paper("", {name: text})).parts if part.name == name)
