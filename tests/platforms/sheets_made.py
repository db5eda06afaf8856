"""Sheets as the command makes them, with the judge of each problem, for the tests of platforms."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from platform_rules import read_package
from qti_schemas import VERSIONS, package_faults
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
    """The files of a format; packages of QTI keep the grammar of their version."""
    files = dict([*(file for sheet in sheets for file in writer.add(sheet)), *writer.close()])
    for name in VERSIONS.keys() & files:
        assert package_faults(name, read_package(files[name])) == []  # type: ignore[arg-type]
    return files  # type: ignore[return-value]


def judge_of(one: SheetProblem) -> Judge:
    """A judge as `rotsolve check` has it."""
    return Judges(one.marked, 0, None).judge_worked(one.worked)


def judged(judge: Judge, name: str, text: str) -> JudgedPart:
    return next(part for part in judge.mark(Paper("", {name: text})).parts if part.name == name)
