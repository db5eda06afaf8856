"""Scenes that were once answered wrongly are right, or are refused by the name that their heads ask for."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path

import pytest

from heads import G, Head, head_of
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import Formula, formula
from rotsolve.arrays import NotForMany
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.pipeline import solve
from rotsolve.scene.read import read_file
from rotsolve.solution import Solution
from rotsolve.solution.answer import AnswerView

SCENES = sorted((Path(__file__).parent / "scenes").glob("*.yaml"))
RELATIVE = 1e-6
STILL_WRONG = "known, and still to be mended"


def marked(file: Path) -> object:
    """A scene as a case; one that is still wrong has to fail."""
    marks = [pytest.mark.xfail(reason=STILL_WRONG, strict=True)] if head_of(file).open else []
    return pytest.param(file, id=file.stem, marks=marks)


@pytest.mark.parametrize("file", [marked(file) for file in SCENES])
def test_scene_is_right_or_refused(file: Path) -> None:
    """Right by every route that a user has: as it stands, by its closed form at other numbers, and with these put in."""
    head = head_of(file)
    try:
        solution = solve(file)
    except (Unsolvable, SceneError) as error:
        hold_refusal(head, error.render())
        return
    if head.flagged:
        assert objections(solution), "answered without a warning"
        return
    assert head.true, "answered, though it has to be refused"
    numbers = numberless(file)
    if not numbers:
        hold_values(head, solution, {})
        return
    sets = head.sets(numbers)
    claims = [hold_closed_form(head, solution, values) for values in sets]
    assert any(claims), "what is printed holds for none of the sets"
    for values in sets:
        hold_values(head, solve(file, settings=written(numbers, values)), values)


def test_heads_say_all() -> None:
    """Each head says what was wrong, what is true and why; what is true, or how it is refused, can be read."""
    for file in SCENES:
        head = head_of(file)
        assert {"bug", "printed", "true", "why"} <= head.lines.keys(), file.name
        assert head.true or head.refused or head.flagged, file.name
        assert all(f"{name}:" in file.read_text(encoding="utf-8") for name in head.true), file.name


def hold_refusal(head: Head, message: str) -> None:
    """A refusal is allowed, and names what the head asks for."""
    assert head.refused or head.flagged, f"refused:\n{message}"
    for name in head.refused:
        assert name in message, f"does not name {name}:\n{message}"


def hold_values(head: Head, solution: Solution, numbers: Mapping[str, float]) -> None:
    """The answers are the true values, and no check objects."""
    for name in head.true:
        found = in_si(solution.answers[name])
        assert found is not None, f"{name} has no number"
        assert close(found, head.value(name, numbers)), (
            f"{name} = {found}, not {head.value(name, numbers)}, at {numbers}"
        )
    assert not objections(solution)


def hold_closed_form(head: Head, solution: Solution, numbers: Mapping[str, float]) -> bool:
    """What is printed in letters holds at these numbers, if its own conditions do; whether they do for all questions."""
    branch = claimed(solution, numbers)
    found = {name: branch[name] for name in head.true if branch[name] is not None}
    for name, value in found.items():
        true = head.value(name, numbers)
        assert close(value, true), f"{name} = {value}, not {true}, at {numbers}"
    return len(found) == len(head.true)


def claimed(solution: Solution, numbers: Mapping[str, float]) -> dict[str, float | None]:
    """The values that the printed forms claim at some numbers, in SI units; None where they claim nothing."""
    try:
        rows = solution.evaluate_many(dict(numbers))
    except NotForMany:
        return {name: by_formula(answer, numbers) for name, answer in solution.answers.items()}
    factors = {name: factor(answer) for name, answer in solution.answers.items()}
    return {name: None if math.isnan(row) else float(row) * factors[name] for name, row in rows.items()}


def by_formula(answer: AnswerView, numbers: Mapping[str, float]) -> float:
    """The closed form of an answer at some numbers."""
    assert answer.formula is not None, f"{answer.name} has no closed form"
    values: dict[str, Formula] = {
        name: formula(Fraction(str(value))) for name, value in ({"g": G} | dict(numbers)).items()
    }
    return evaluate(answer.formula, values, digits=12).float


def numberless(file: Path) -> dict[str, str]:
    """The letters of a scene that have a dimension and no number, with its unit in the SI."""
    letters = [given for given in read_file(file).givens if given.value is None and not given.asked]
    return {given.name: "" if given.unit is None else given.unit.text for given in letters}


def written(units: Mapping[str, str], values: Mapping[str, float]) -> dict[str, str]:
    """Numbers as `--set` takes them."""
    return {name: f"{value} {units[name]}".strip() for name, value in values.items()}


def in_si(answer: AnswerView) -> float | None:
    """The number of an answer in SI units, finer than it is printed."""
    return None if answer.float is None else answer.float * factor(answer)


def factor(answer: AnswerView) -> float:
    """The unit of an answer in SI units."""
    return 1.0 if answer.answer.unit is None else evaluate(answer.answer.unit.factor, {}, digits=20).float


def objections(solution: Solution) -> list[str]:
    """What the checks hold against the answers."""
    return ["".join(map(str, check.words)) for check in solution.checks if check.holds is False]


def close(found: float, true: float) -> bool:
    return math.isclose(found, true, rel_tol=RELATIVE, abs_tol=RELATIVE)
