"""A class of ten thousand, generated with the marks that it should get: right answers in many notations, planted mistakes, and rows
that are missing, hostile or malformed."""

from __future__ import annotations

import csv
import random
import sys
from collections import Counter
from collections.abc import Iterator
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path
from time import process_time
from typing import NamedTuple

import pytest

from rotsolve.grading.course.command import CheckRequest, run_check

ROWS = 10_000
SCENE = """\
title: Block on a disc
given: {m: 2 kg, M: 5 kg, R: 20 cm, g: 9.8 m/s^2}
gravity: g
bodies:
  block: {mass: m, moves: down}
  disc: {shape: disc, mass: M, radius: R, turns: clockwise}
connections: {axle: {axle: disc}, cord: {string: [disc, block]}}
find: {a: block.acceleration, alpha: disc.angular_acceleration, T: cord.tension}
marking: {a: 2, alpha: 3, T: {points: 1, tolerance: 2 %}}
"""
POINTS = {"a": 2, "alpha": 3, "T": 1}
VALUES = {"a": 196 / 45, "alpha": 196 / 9, "T": 98 / 9}
UNITS = {"a": ("m/s²", "m/s^2", "m s^-2"), "alpha": ("rad/s²", "1/s^2", "rad s^-2"), "T": ("N", "kg m/s^2")}
RIGHT = {
    "a": (
        *("2mg/(2m+M)", "2·m·g/(2·m+M)", "2 m g/(M + 2 m)", "\\frac{2mg}{2m+M}", "a = 2mg/(2m+M)", "mg/(m+M/2)", "g/(1+M/(2m))"),
        *("mg/(m + ½M)", "(m g)/(m + 0.5 M)", "2*m*g*(2*m+M)^-1", "g - M g/(2m+M)", "g·(1 + M/(2·m))^{-1}", "$\\frac{2 m g}{2 m + M}$"),
    ),
    "alpha": (
        *("2mg/(R(2m+M))", "2mg/((2m+M)R)", "a/R", "α = 2mg/(R(2m+M))", "\\frac{2mg}{R(2m+M)}", "m g/(R m + ½ M R)"),
        *("g/(R(1+M/(2m)))", "\\alpha = \\frac{2 m g}{(2m+M) R}", "mg R/(½ M R² + m R²)"),
    ),
    "T": (
        *("mMg/(2m+M)", "½ M a", "m(g - a)", "M g m/(2m + M)", "\\frac{mMg}{2m+M}", "T = mMg/(M+2m)", "mg - ma", "mg/(1+2m/M)"),
        *("g/(2/M + 1/m)", "m·M·g/(2·m + M)"),
    ),
}  # fmt: skip
PLANTED = {  # a wrong answer, what has to be said of it ('' where nobody can know), and the mistake that later answers may share
    "a": {
        "g": ("inertia of the disc was left out", "light"),
        "mg/(m+M)": ("ring", "ring"),
        "2mg/(2m-M)": ("wrong sign", "sign"),
        "-2mg/(2m+M)": ("sign", ""),
        "mg/M": ("", ""),
        "4.36 m/s": ("velocity", ""),
        "4.36 rad/s²": ("angular acceleration", ""),
    },
    "alpha": {
        "g/R": ("inertia of the disc was left out", "light"),
        "mg/(R(m+M))": ("ring", "ring"),
        "2mg/(2m+M)": ("measures an acceleration", ""),
        "10.89 rad/s^2": ("diameter", ""),
        "21.78 m/s": ("velocity", ""),
        "25 rad/s^2": ("", ""),
    },
    "T": {"mMg/(m+M)": ("ring", "ring"), "2mg": ("", ""), "10.89 m": ("length", ""), "50 N": ("", "")},
}
REFUSED = (
    "9**9**9**9",
    "(" * 9000,
    "__import__('os').system('ls')",
    "=cmd|' /C calc'!A0",
    "2mg/(2m+M",
    "%%%",
    "²²²",
    "x y z w q",
)


class Cell(NamedTuple):
    """An answer, the verdict and the marks that it should get, and a word that has to be said of it."""

    text: str
    verdict: str
    marks: float
    said: str = ""


def cell(name: str, chance: random.Random, mistakes: dict[str, str]) -> Cell:
    """One generated answer; one with the mistake that the acceleration has already follows from that."""
    points = POINTS[name]
    kind = chance.random()
    if kind < 0.4:
        return Cell(chance.choice(RIGHT[name]), "right", points)
    if kind < 0.7:
        number = VALUES[name] * (1 + chance.uniform(-0.008, 0.008))
        return Cell(f"{number:.{chance.choice((4, 5, 6))}g} {chance.choice(UNITS[name])}", "right", points)
    if kind < 0.85:
        text, (said, mistake) = chance.choice(list(PLANTED[name].items()))
        if mistake and mistake == mistakes.get("a"):
            return Cell(text, "partly right", points * 3 / 4, "right with your own")
        if mistake and mistake in mistakes.values():  # whether it follows from α alone is a matter of taste
            return Cell("", "no answer", 0)
        mistakes[name] = mistake
        return Cell(text, "wrong", 0, said)
    if kind < 0.92:
        return Cell("", "no answer", 0)
    return Cell(chance.choice(REFUSED), "can't decide", 0)


def rows(chance: random.Random) -> Iterator[tuple[str, dict[str, Cell]]]:
    """Every student with the answers."""
    for number in range(ROWS):
        mistakes: dict[str, str] = {}
        yield f"Student {number}", {name: cell(name, chance, mistakes) for name in POINTS}


class Marked(NamedTuple):
    """The class with what came out: the cells that it was made of, the rows of marks.csv, the folder, and the processor time."""

    planted: dict[str, dict[str, Cell]]
    found: dict[str, dict[str, str]]
    folder: Path
    spent: float
    printed: str


@pytest.fixture(scope="module")
def marked(tmp_path_factory: pytest.TempPathFactory) -> Marked:
    """The whole class, marked once."""
    folder = tmp_path_factory.mktemp("class")
    (folder / "scene.yaml").write_text(SCENE, encoding="utf-8")
    planted = dict(rows(random.Random(5)))
    with (folder / "class.csv").open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(["name", *POINTS])
        for number, (student, cells) in enumerate(planted.items()):
            if number % 1000 == 500:
                stream.write(f'Broken {number},"2mg/(2m+M),1,2\nShifted {number},1,2,3,4,5\n')
            writer.writerow([student, *(cell.text for cell in cells.values())])
    start, before = process_time(), sys.stdout
    printed = StringIO()
    with redirect_stdout(printed):
        code = run_check(
            CheckRequest(str(folder / "scene.yaml"), str(folder / "class.csv"), output=str(folder / "report"))
        )
    assert code == 1 and sys.stdout is before
    with (folder / "report" / "marks.csv").open(encoding="utf-8", newline="") as stream:
        found = {row["student"]: row for row in csv.DictReader(stream)}
    return Marked(planted, found, folder / "report", process_time() - start, printed.getvalue())


def test_every_answer_gets_its_verdict_and_its_marks(marked: Marked) -> None:
    wrong = [
        (student, name, cell, marked.found[student][f"{name} verdict"], marked.found[student][name])
        for student, cells in marked.planted.items()
        for name, cell in cells.items()
        if (marked.found[student][f"{name} verdict"], float(marked.found[student][name])) != (cell.verdict, cell.marks)
    ]
    assert not wrong, wrong[:10]


def test_the_sums_are_those_of_the_answers(marked: Marked) -> None:
    for student, cells in marked.planted.items():
        row = marked.found[student]
        assert (float(row["marks"]), row["of"]) == (sum(cell.marks for cell in cells.values()), "6")


def test_what_was_planted_is_named(marked: Marked) -> None:
    for student, cells in marked.planted.items():
        for name, cell in cells.items():
            said = [part for part in marked.found[student]["remarks"].split("; ") if part.startswith(f"{name}: ")]
            assert cell.said in " ".join(said), (student, name, cell, said)
            if cell.verdict == "right":
                assert not said, (cell, said)


def test_rows_that_can_not_be_read_lose_nobody_elses_marks(marked: Marked) -> None:
    bad = {name for name in marked.found if not name.startswith("Student")}
    assert bad == {f"{word} {number}" for word in ("Broken", "Shifted") for number in range(500, ROWS, 1000)}
    assert all(marked.found[name]["marks"] == "" and marked.found[name]["remarks"] for name in bad)
    assert len(marked.found) == ROWS + len(bad)


def test_there_is_a_page_for_everyone(marked: Marked) -> None:
    pages = {path.name.partition("-")[2]: path for path in (marked.folder / "students").iterdir()}
    assert set(pages) == {f"student-{number}.html" for number in range(ROWS)}
    for number in range(0, ROWS, 997):
        text = pages[f"student-{number}.html"].read_text(encoding="utf-8")
        sum_of = sum(cell.marks for cell in marked.planted[f"Student {number}"].values())
        assert f"<p>{sum_of:g} of 6" in text and text.endswith("</html>\n")


def test_the_summary_counts_what_was_planted(marked: Marked) -> None:
    text = (marked.folder / "summary.html").read_text(encoding="utf-8")
    counts = Counter((name, cell.verdict) for cells in marked.planted.values() for name, cell in cells.items())
    for name in POINTS:
        numbers = "".join(
            f"<td>{counts[name, word]}</td>" for word in ("right", "partly right", "wrong", "can't decide", "no answer")
        )
        assert numbers in text
    mean = sum(cell.marks for cells in marked.planted.values() for cell in cells.values()) / ROWS
    assert f"mean {mean:.2f}".rstrip("0").rstrip(".") + "," in text
    full = sum(all(cell.verdict == "right" for cell in cells.values()) for cells in marked.planted.values())
    assert f"{full} with full marks" in text and f"{full} with full marks" in marked.printed


def test_it_takes_seconds(marked: Marked) -> None:
    """Ten thousand papers of three answers each, with a page for every student: about 7 s of processor time."""
    assert marked.spent < 30
