"""Whole papers: answers that follow from earlier ones, marks by what the scene says, and lines of working."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.verdict import JudgedLine, JudgedPart, Paper
from rotsolve.pipeline import solve

HERE = Path(__file__).parent
PROBLEMS = HERE.parent.parent / "problems"
PAPERS = re.findall(r"^== (\S+)\n((?:(?!== ).*\n?)*)", (HERE / "papers.txt").read_text("utf-8"), re.MULTILINE)


def judge(problem: str, marking: str) -> Judge:
    text = (PROBLEMS / f"{problem}.yaml").read_text("utf-8")
    return Judge(solve(f"{text}\nmarking: {marking}\n" if marking else text))


def said_of_part(part: JudgedPart) -> str:
    kinds = sorted({remark.kind for remark in part.verdict.remarks})
    assert part.followed == ("followed" in kinds)
    return " ".join([part.verdict.outcome, str(part.marks), *kinds])


def said_of_line(line: JudgedLine) -> str:
    kinds = sorted({remark.kind for remark in line.verdict.remarks})
    return " ".join([line.verdict.outcome, *(["first"] if line.first_wrong else []), *kinds])


def test_there_are_enough_of_them() -> None:
    assert len(PAPERS) >= 30


@pytest.mark.parametrize(
    ("problem", "content"), PAPERS, ids=[f"{number} {name}" for number, (name, _) in enumerate(PAPERS)]
)
def test_paper(problem: str, content: str) -> None:
    lines = [line for line in content.splitlines() if line.strip() and not line.startswith("#")]
    marking = lines.pop(0).removeprefix("marking: ") if lines[0].startswith("marking: ") else ""
    rows = [[part.strip() for part in line.split(" | ")] for line in lines]
    answers = {name: text for name, _, text in (row[0].partition(": ") for row in rows if not row[0].startswith("- "))}
    working = tuple(row[0].removeprefix("- ") for row in rows if row[0].startswith("- "))
    marked = judge(problem, marking).mark(Paper("one", answers, working))
    found = [f"{part.name}: {part.text} | {said_of_part(part)}" for part in marked.parts if part.name in answers]
    found += [f"- {line.text} | {said_of_line(line)}" for line in marked.lines]
    assert "\n".join(found) == "\n".join(" | ".join(row) for row in rows)
    assert marked.marks == sum(part.marks for part in marked.parts)


NO_CLOSED_FORM = """title: Wheel that is driven by an odd law
given: {c: 2 rad/s^5, b: 3 rad/s, q: 7 rad}
bodies: {wheel: {shape: disc, mass: 2 kg, radius: 20 cm}}
connections: {axle: {axle: wheel, angle: b*time + c*time^5}}
states: {start: {}, end: {wheel.angle: q}}
find: {t: time from start to end, omega: wheel.angular_velocity at end}
"""


def test_where_there_is_no_closed_form() -> None:
    """Numbers are compared, formulas of a letter that has only a number are told apart by it, and laws are right by themselves."""
    own = Judge(solve(NO_CLOSED_FORM))
    lines = ("q = b t + c t^5", "t = 1.126 s", "omega = b + 5 c t^4", "omega = b + 4 c t^4", "q = b t")
    marked = own.mark(Paper("one", {"t": "1126 ms", "omega": "b + 5 c t^4"}, lines))
    assert [said_of_part(part) for part in marked.parts] == ["right 1", "right 1"]
    assert [said_of_line(line) for line in marked.lines] == ["right", "right", "right", "wrong first", "wrong"]
    late = own.mark(Paper("two", {"t": "1.239 s", "omega": "26.57 rad/s"}))
    assert [said_of_part(part) for part in late.parts] == ["wrong 0", "partly right 3/4 followed"]
    assert said_of_part(own.mark(Paper("three", {"t": "q/b"})).parts[0]) == "wrong 0"
