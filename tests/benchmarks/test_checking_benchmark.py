"""The benchmark of checking: its lines are what they are called, and a short run prints its table."""

from __future__ import annotations

import sys
from pathlib import Path
from random import Random

import pytest

sys.path.append(str(Path(__file__).resolve().parents[2] / "benchmarks"))

import checking
from costs import streams
from rotsolve.grading.reading.answers import read_line
from rotsolve.grading.verdict import RIGHT, WRONG


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("kind", "outcome"), [("right formula", RIGHT), ("wrong formula", WRONG)])
def test_lines_are_right_and_wrong(kind: str, outcome: str) -> None:
    random = Random(5)
    for subject in checking.subjects():
        for _ in range(3):
            line = checking.KINDS[kind](subject, random)
            assert subject.judge.texts.judged(subject.target, line).finding.outcome == outcome, line


def test_some_lines_have_two_readings() -> None:
    random = Random(5)
    for subject in checking.subjects():
        line = checking.two_ways(subject, random)
        assert len(read_line(line, subject.judge.texts.names(subject.target))) > 1, line


def test_papers_in_a_stream_are_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr(streams, "WORKERS", (1,))
    rows = checking.stream_page(20, 60).splitlines()
    for by in ("this process", "1 worker"):
        found = [[float(cell) for cell in row.split("|")[2:-1]] for row in rows if row.startswith(f"| {by} ")]
        assert [row[0] for row in found] == [20, 60] and all(min(row) > 0 for row in found)


def test_the_table_has_a_row_for_each_kind() -> None:
    text = checking.page(3, 1)
    assert all(f"| {kind}" in text for kind in (*checking.KINDS, "all of them"))
