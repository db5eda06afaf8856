"""Marking in space: of every problem the published answers are right, and the same turned round, scaled or in another order are wrong."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.text import to_text
from rotsolve.grading.course.sheet import from_answers, read_sheet
from rotsolve.grading.course.table import read_table
from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.marking.target import Target
from rotsolve.grading.verdict import RIGHT, WRONG, Paper
from rotsolve.language.problem import Published
from solutions import solved

PROBLEMS = sorted((Path(__file__).resolve().parents[2] / "problems" / "space").glob("*.yaml"))
PARTS = {"L_x": "L", "L_y": "L", "L_z": "L"}
APART = 0.05  # what numbers differ by that are surely not the same to a tolerance of 1 %


def shown(parts: Sequence[str], unit: str = "") -> str:
    """One value, or several as a vector or as a matrix of three rows."""
    if len(parts) == 1:
        return f"{parts[0]} {unit}".strip()
    rows = [", ".join(parts[first : first + 3]) for first in range(0, len(parts), 3)]
    whole = f"({rows[0]})" if len(rows) == 1 else f"[{', '.join(f'[{row}]' for row in rows)}]"
    return f"{whole} {unit}".strip()


def numbers_of(entry: Published) -> list[float]:
    """The published numbers in their unit."""
    values = entry.values or ((entry.value,) if entry.value is not None else ())
    factor = 1.0 if entry.unit is None else evaluate(entry.unit.factor, {}).float
    return [evaluate(value, {}).float / factor for value in values]


def formulas_of(entry: Published) -> tuple[Formula, ...]:
    return entry.formulas or ((entry.formula,) if entry.formula is not None else ())


def wrong_numbers(numbers: list[float], target: Target) -> Iterator[list[float]]:
    """The numbers turned round, half as large again, and with two that differ exchanged; not those that stay right."""
    if any(numbers):
        yield [1.5 * number for number in numbers]
        if not target.either:
            yield [-number for number in numbers]
    unordered = bool(target.labels) and all(label.isdigit() for label in target.labels)
    size = max(map(abs, numbers))
    for one in range(len(numbers)) if len(numbers) == 3 and not unordered else ():
        other = (one + 1) % 3
        if abs(numbers[one] - numbers[other]) > APART * size:
            order = list(numbers)
            order[one], order[other] = order[other], order[one]
            if not (target.either and [-number for number in order] == numbers):
                yield order


@pytest.mark.parametrize("file", PROBLEMS, ids=lambda file: file.stem)
def test_published_answers_are_right_and_their_likes_wrong(file: Path) -> None:
    solution = solved(file)
    judge = Judge(solution, lambda: ())  # type: ignore[arg-type, return-value]  # what mistakes give has tests of its own

    def outcome(name: str, text: str) -> str:
        marked = judge.mark(Paper("one", {name: text}))
        return next(part.verdict.outcome for part in marked.parts if part.name == name)

    for entry in solution.problem.answers:
        target, numbers, formulas = judge.targets[entry.name], numbers_of(entry), formulas_of(entry)
        unit = "" if entry.unit is None else entry.unit.text
        if target.word or not numbers + list(formulas):
            continue
        if formulas:
            assert outcome(entry.name, shown([to_text(formula) for formula in formulas])) == RIGHT, entry.name
            turned = shown([f"-({to_text(formula)})" for formula in formulas])
            assert outcome(entry.name, turned) != RIGHT or target.either or not any(numbers), turned
        if numbers:
            typed = shown([f"{number:.6g}" for number in numbers], unit)
            assert outcome(entry.name, typed) == RIGHT, typed
            for other in wrong_numbers(numbers, target):
                typed = shown([f"{number:.6g}" for number in other], unit)
                assert outcome(entry.name, typed) == WRONG, typed


def test_components_may_be_handed_in_one_by_one() -> None:
    """As lines of one sheet, as answers of the command line, and as columns of a table they are one answer."""
    told = "L_x = 1; L_y = 2; L_z = 3 N m s"
    lines = read_sheet("L_x = 1\nL_y = 2\nx = 7\nLz = 3 N m s\nK = 5 J\n", "ada.txt", ["L", "K"], PARTS)
    assert lines.answers == {"L": told, "K": "5 J"} and lines.working == ("x = 7",)
    assert from_answers(["L_x = 1", "L_{y} = 2", "L_z = 3 N m s"], ["L", "K"], PARTS).answers == {"L": told}
    yaml = read_sheet("L_x: 1\nL_y: 2\nL_z: 3 N m s\n", "ada.yaml", ["L", "K"], PARTS)
    assert yaml.answers == {"L": told}
    table = read_table("name,L_x,L_y,L_z (N m s),K\nAda,1,2,3,5 J\n", "class.csv", ["L", "K"], PARTS)
    assert table.entries[0].paper is not None and table.entries[0].paper.answers == {"L": told, "K": "5 J"}


def test_a_vector_as_a_whole_goes_before_its_components() -> None:
    sheet = read_sheet("L = (1, 2, 3) N m s\nL_x = 1\n", "ada.txt", ["L"], PARTS)
    assert sheet.answers == {"L": "(1, 2, 3) N m s"}


@pytest.mark.parametrize(("sign", "expected"), [("strict", WRONG), ("lenient", RIGHT)])
def test_a_vector_the_other_way_goes_by_the_sign_that_is_declared(sign: str, expected: str) -> None:
    from rotsolve.pipeline import solve

    text = PROBLEMS[[file.stem for file in PROBLEMS].index("turbine-of-a-ship")].read_text(encoding="utf-8")
    judge = Judge(solve(f"{text}marking: {{tau: {{sign: {sign}}}}}\n"))
    marked = judge.mark(Paper("one", {"tau": "(0, -785, 0) N m"}))
    assert marked.parts[0].verdict.outcome == expected
