"""A judge that is made up, so that reading and showing are tested by themselves: what a text holds says what is thought of it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import pytest

from rotsolve import cli
from rotsolve.algebra.notation.parse import parse
from rotsolve.grading.course import examiner
from rotsolve.grading.verdict import (
    NO_ANSWER,
    RIGHT,
    UNDECIDED,
    WRONG,
    JudgedLine,
    JudgedPart,
    Marked,
    Paper,
    Remark,
    Verdict,
)
from rotsolve.solution import Solution

SCENE = """\
title: Block on a disc
given: {m: 2 kg, M: 5 kg, R: 20 cm}
bodies:
  block: {mass: m, moves: down}
  disc: {shape: disc, mass: M, radius: R, turns: clockwise}
connections: {axle: {axle: disc}, cord: {string: [disc, block]}}
find: {a: block.acceleration, alpha: disc.angular_acceleration, T: cord.tension}
"""
MISTAKE = Remark("mistake", ("It looks as if ", parse("1/2*M*R^2"), " was left out."))


class MadeUp:
    """`bad` is wrong by a mistake, `odd` can't be read there, `?` can't be decided; all else is right."""

    def __init__(self, solution: Solution, wrong: object = None) -> None:
        self.names = [answer.name for answer in solution.derivation.answers]

    def mark(self, paper: Paper) -> Marked:
        assert paper.student != "Mallory", "a failure of ours"
        parts = tuple(self.part(name, paper.answers.get(name, "")) for name in self.names)
        wrong = [number for number, text in enumerate(paper.working) if "bad" in text]
        lines = tuple(
            JudgedLine(text, Verdict(WRONG, "", (MISTAKE,)) if number in wrong else Verdict(RIGHT), number in wrong[:1])
            for number, text in enumerate(paper.working)
        )
        return Marked(paper.student, parts, lines, sum((part.marks for part in parts), Fraction(0)), Fraction(6))

    def part(self, name: str, text: str) -> JudgedPart:
        verdict = self.verdict(text)
        marks = {RIGHT: Fraction(2), UNDECIDED: Fraction(1, 3)}.get(verdict.outcome, Fraction(0))
        return JudgedPart(name, text, verdict, marks, Fraction(2), "own" in text)

    def verdict(self, text: str) -> Verdict:
        remarks = [MISTAKE] if "bad" in text else []
        for start in (place for place in range(len(text)) if text.startswith("odd", place)):
            remarks.append(Remark("reading", (f"unexpected `odd` in column {start + 1}",), start, start + 3))
        if not text:
            return Verdict(NO_ANSWER)
        if remarks:
            return Verdict(WRONG, "", tuple(remarks))
        return Verdict(UNDECIDED, "x + y") if "?" in text else Verdict(RIGHT)


@dataclass(frozen=True)
class Ran:
    """What a command did."""

    code: int
    out: str
    err: str


Command = Callable[..., Ran]


@pytest.fixture
def command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Command:
    """Run `rotsolve check scene.yaml` with these arguments in a folder of its own."""
    monkeypatch.chdir(tmp_path)
    Path("scene.yaml").write_text(SCENE, encoding="utf-8")

    def run(*arguments: str) -> Ran:
        with pytest.raises(SystemExit) as left:
            cli.main(["check", "scene.yaml", *arguments])
        captured = capsys.readouterr()
        return Ran(int(left.value.code or 0), captured.out, captured.err)

    return run


@pytest.fixture
def made_up(command: Command, monkeypatch: pytest.MonkeyPatch) -> Command:
    """The same with the judge that is made up."""
    monkeypatch.setattr(examiner, "marker_of", MadeUp)
    return command
