"""Verdicts on answers that were written for this: right forms, near misses, units, figures, notations, directions, words, vectors."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.verdict import OUTCOMES, JudgedPart, Paper
from rotsolve.pipeline import solve

HERE = Path(__file__).parent
PROBLEMS = HERE.parent.parent / "problems"
SECTIONS = re.findall(r"^## (\S+)\n((?:(?!## ).*\n?)*)", (HERE / "verdicts.txt").read_text("utf-8"), re.MULTILINE)
ROWS = [
    (problem, *(part.strip() for part in line.split(" | ")))
    for problem, lines in SECTIONS
    for line in lines.splitlines()
    if line.strip()
]


@cache
def judge(problem: str) -> Judge:
    return Judge(solve(PROBLEMS / f"{problem}.yaml"))


def part(problem: str, name: str, text: str) -> JudgedPart:
    marked = judge(problem).mark(Paper("one", {name: text}))
    return next(item for item in marked.parts if item.name == name)


def test_there_are_enough_of_them() -> None:
    assert len(ROWS) >= 150 and len(SECTIONS) >= 15


@pytest.mark.parametrize(("problem", "name", "text", "expected"), ROWS, ids=[" ".join(row[:3]) for row in ROWS])
def test_verdict(problem: str, name: str, text: str, expected: str) -> None:
    found = part(problem, name, text)
    kinds = sorted({remark.kind for remark in found.verdict.remarks})
    said = " ".join([found.verdict.outcome, str(found.marks), *kinds])
    outcome = next(word for word in OUTCOMES if expected.startswith(word))
    rest = expected.removeprefix(outcome).split()
    assert said == " ".join([outcome, rest[0], *sorted(rest[1:])])
