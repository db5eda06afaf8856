"""Marking in space: of every problem the published answers are right, and the same turned round, scaled or in another order are wrong."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.grading.course.handed_in import from_answers, read_sheet
from rotsolve.grading.course.questions import SheetTask, Task
from rotsolve.grading.course.table import read_table
from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.marking.target import Target
from rotsolve.grading.mistakes.wrong_answers import WrongAnswers
from rotsolve.grading.reading.answers import read_line
from rotsolve.grading.reading.matrices import read_matrix
from rotsolve.grading.reading.records import AnswerError, Names
from rotsolve.grading.verdict import RIGHT, WRONG, Paper
from rotsolve.language.problem import Published
from solutions import solved

PROBLEMS = sorted((Path(__file__).resolve().parents[2] / "problems" / "space").glob("*.yaml"))
PARTS = {"L_x": "L", "L_y": "L", "L_z": "L"}
COMMAS = (", ", ",")  # how components are parted
APART = 0.05  # what numbers differ by that are surely not the same to a tolerance of 1 %


def shown(parts: Sequence[str], unit: str = "", comma: str = ", ") -> str:
    """One value, or several as a vector or as a matrix of three rows."""
    if len(parts) == 1:
        return f"{parts[0]} {unit}".strip()
    rows = [comma.join(parts[first : first + 3]) for first in range(0, len(parts), 3)]
    whole = f"({rows[0]})" if len(rows) == 1 else f"[{comma.join(f'[{row}]' for row in rows)}]"
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
    judge = Judge(solution, lambda: WrongAnswers(iter(())))  # what mistakes give has tests of its own

    def outcome(name: str, text: str) -> str:
        marked = judge.mark(Paper("one", {name: text}))
        return next(part.verdict.outcome for part in marked.parts if part.name == name)

    for entry in solution.problem.answers:
        target, numbers, formulas = judge.targets[entry.name], numbers_of(entry), formulas_of(entry)
        unit = "" if entry.unit is None else entry.unit.text
        if target.word or not numbers + list(formulas):
            continue
        if formulas:
            for comma in COMMAS:
                typed = shown([to_text(formula) for formula in formulas], comma=comma)
                assert outcome(entry.name, typed) == RIGHT, typed
            turned = shown([f"-({to_text(formula)})" for formula in formulas])
            assert outcome(entry.name, turned) != RIGHT or target.either or not any(numbers), turned
        if numbers:
            for comma in COMMAS:
                typed = shown([f"{number:.6g}" for number in numbers], unit, comma)
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
    task = SheetTask("", (Task("", {name: Symbol(name) for name in ("L", "K")}, PARTS),))
    table = read_table("name,L_x,L_y,L_z (N m s),K\nAda,1,2,3,5 J\n", "class.csv", task)
    assert table.entries[0].papers is not None and table.entries[0].papers[0].answers == {"L": told, "K": "5 J"}


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


@pytest.mark.parametrize(
    ("text", "components", "expected"),
    [
        ("(1,0,-1)", 3, ["(1, 0, −1)"]),
        ("m a (1,0,2)", 3, ["m a (1, 0, 2)"]),
        ("(m a/12,0,-m a/12)", 3, ["(m a/12, 0, −m a/12)"]),
        ("(18.3,0,0) N", 3, ["(18.3, 0, 0) N"]),
        ("(0,3.6,0) N m", 3, ["(0, 3.6, 0) N m"]),
        ("(1,5, 2,5, 3) N", 3, ["(1.5, 2.5, 3) N"]),
        ("(1,5; 2; 3) N", 3, ["(1.5, 2, 3) N"]),
        ("(1,200,000, 0, 3) N", 3, ["(1200000, 0, 3) N"]),
        ("[0,5,1,2] N", 3, ["(0.5, 1, 2) N", "(0, 5.1, 2) N", "(0, 5, 1.2) N"]),
        ("(3,4) N", 2, ["(3, 4) N", "3.4 N"]),
        ("m a (3,4)", 2, ["m a (3, 4)", "m a (17/5)"]),
        ("m a (3,4)", 0, ["m a (17/5)"]),
        ("(3,5; 4) N", 2, ["(3.5, 4) N"]),
        ("(1,5, 2) m/s", 2, ["(1.5, 2) m/s"]),
        ("(1,5,2) m/s", 2, ["(1, 5, 2) m/s", "(1.5, 2) m/s", "(1, 5.2) m/s"]),
        ("(1,5,2) m/s", 0, ["(1, 5, 2) m/s"]),
    ],
)
def test_commas_between_digits_go_by_how_many_components_are_asked(
    text: str, components: int, expected: list[str]
) -> None:
    """By hand: n commas of which k are decimal part n + 1 − k components."""
    readings = read_line(text, Names(frozenset("ma"), asked="F", components=components))
    assert [reading.text for reading in readings] == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("[[10,0,0],[0,6,-1],[0,-1,6]]", ["[(10, 0, 0), (0, 6, −1), (0, −1, 6)]"]),
        ("diag(1,2,3)", ["[(1, 2, 3)]"]),
        ("\\begin{pmatrix}1,5&0&0\\\\0&2&0\\\\0&0&3\\end{pmatrix}", ["[(1.5, 0, 0), (0, 2, 0), (0, 0, 3)]"]),
        ("[[1,5,0], [0, 2, 0], [0, 0, 3]]", ["[(1, 5, 0), (0, 2, 0), (0, 0, 3)]"]),
        (
            "[[-1,5,0,-2],[0,2,0],[0,0,3]]",
            ["[(−1.5, 0, −2), (0, 2, 0), (0, 0, 3)]", "[(−1, 5.0, −2), (0, 2, 0), (0, 0, 3)]"],
        ),
    ],
)
def test_rows_of_a_matrix_are_read_in_all_ways_that_fit(text: str, expected: list[str]) -> None:
    readings = read_matrix(text, Names(frozenset("ma"), asked="F", components=3))
    assert [reading.text for reading in readings] == expected


def test_what_has_no_direction_is_told_the_axes_there_are() -> None:
    """In space a third component is said back though nothing is written of it."""
    three = Names(frozenset("ma"), asked="F", components=3)
    assert read_line("3 i + 4 j", three)[0].text == "(3, 4, 0)"
    with pytest.raises(AnswerError, match="write i, j or k behind it"):
        read_line("3 i + 4", three)
    with pytest.raises(AnswerError, match="write i or j behind it"):
        read_line("3 i + 4", Names(frozenset("ma"), asked="F", components=2))


@pytest.mark.parametrize(
    ("text", "read"),
    {
        "3 i + 4 k": "(3, 0, 4)",
        "3 q i − 4 k": "(3 q, 0, −4)",
        "(3 i + 4 k) N": "(3, 0, 4) N",
        "k i + 3 k": "(k, 0, 3)",
        "2 k j + 3 q k": "(0, 2 k, 3 q)",
        "(q + k) i + 3 k": "(q + k, 0, 3)",
    }.items(),
)
def test_a_letter_of_the_scene_is_the_unit_vector_in_a_term_that_has_no_other(text: str, read: str) -> None:
    """A stiffness k, and k̂: `3 i + 4 k` could mean nothing else. In the plane, where no third component is asked, k stays the letter."""
    assert read_line(text, Names(frozenset("qks"), asked="F", components=3))[0].text == read
    with pytest.raises(AnswerError, match="write i or j behind it"):
        read_line("3 i + 4 k", Names(frozenset("mks"), asked="F", components=2))
