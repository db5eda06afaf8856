"""The benchmark of checking: its lines are what they are called, and a short run prints its table."""

from __future__ import annotations

import sys
from pathlib import Path
from random import Random

import pytest

sys.path.append(str(Path(__file__).resolve().parents[2] / "benchmarks"))

import checking
from rotsolve.grading.comparing.equality import same
from rotsolve.grading.reading import read_answer


@pytest.mark.parametrize(("kind", "verdict"), [("right formula", True), ("wrong formula", False)])
def test_lines_are_right_and_wrong(kind: str, verdict: bool) -> None:
    random = Random(5)
    for subject in checking.subjects():
        for _ in range(3):
            line = checking.KINDS[kind](subject, random)
            formula = read_answer(line, subject.names)[0].formula
            assert formula is not None
            assert same(formula, subject.closed, subject.domain) is verdict, line


def test_some_lines_have_two_readings() -> None:
    random = Random(5)
    lines = [(checking.two_ways(subject, random), subject.names) for subject in checking.subjects()]
    assert all(len(read_answer(line, names)) > 1 for line, names in lines)


def test_the_table_has_a_row_for_each_kind() -> None:
    text = checking.page(3, 1)
    assert all(f"| {kind}" in text for kind in (*checking.KINDS, "all of them"))
