"""Every problem in problems/ is solved, gives its published answers by every law that applies, and prints as it did."""

from __future__ import annotations

import re
from fractions import Fraction
from functools import cache
from pathlib import Path

import jsonschema
import pytest
import yaml

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.equation import FAMILIES, LAGRANGE
from rotsolve.core.faults import Unsolvable
from rotsolve.language.problem import Published
from rotsolve.scene.schema import json_schema
from rotsolve.solution import Solution
from rotsolve.solution.answer import AnswerView
from solutions import solved

ACCURACY = Fraction(1, 10**9)
WIDTH = 100
RUNNING = {"time": Symbol("t")}  # as the running time is printed
RAW = re.compile(r"[a-z_]\|[a-z_]")  # the key of a quantity of the laws, which no reader should see


def letters(solution: Solution) -> frozenset[str]:
    """The letters that are known to be positive: those of the givens."""
    return frozenset({given.name for given in solution.problem.givens} | {"g"})


def published_formula(formula: Formula | None, solution: Solution) -> Formula | None:
    """The published formula over givens alone: what stands for another answer is put in."""
    others = {item.name: item.formula for item in solution.problem.answers if item.formula is not None}
    givens = {given.name for given in solution.problem.givens if not given.asked}
    for _ in others:
        used = (
            {}
            if formula is None
            else {name: others[name] for name in formula.symbols() if name in others and name not in givens}
        )
        if not used or formula is None:
            break
        formula = formula.substitute(used)
    return formula


def check_answers(solution: Solution, law: str | None = None, confirm: bool = True) -> list[str]:
    """Where the answers differ from the published ones."""
    wrong = []
    for entry in solution.problem.answers:
        if law is not None and entry.name in solution.refused:
            continue  # this law alone does not tell it
        if entry.name not in solution.answers:
            wrong.append(f"{entry.name}: there is no such answer")
            continue
        moment = (
            solution if entry.at is None else solved(Path(solution.problem.file), law, entry.at.text, confirm=confirm)
        )
        wrong += differences(entry, moment.answers[entry.name], solution)
    return wrong


def in_si(answer: AnswerView) -> float | None:
    """The number that is printed beside the unit, in SI units."""
    if answer.float is None or answer.answer.unit is None:
        return answer.float
    return answer.float * evaluate(answer.answer.unit.factor, {}, digits=20).float


def matrix_differences(entry: Published, answer: AnswerView, solution: Solution) -> list[str]:
    """Where the entries of a matrix or vector, row by row, differ from the published ones."""
    wrong = []
    parts = [AnswerView(part) for row in answer.answer.rows for part in row]
    for expected, part in zip(entry.formulas or [None] * len(parts), parts, strict=True):
        if expected is not None and (part.formula is None or not equal(part.formula, expected, letters(solution))):
            wrong.append(f"{entry.name}.{part.name} = {part.exact}; published {to_text(expected)}")
    for value, part in zip(entry.values or [None] * len(parts), parts, strict=True):
        number, found = (0.0 if value is None else evaluate(value, {}, digits=20).float), in_si(part)
        if value is not None and (found is None or abs(found - number) > ACCURACY * max(abs(number), abs(found))):
            wrong.append(f"{entry.name}.{part.name} = {part.value}; published {entry.text}")
    return wrong


def differences(entry: Published, answer: AnswerView, solution: Solution) -> list[str]:
    if answer.answer.rows:
        assert entry.formulas and entry.values, f"{entry.name} wants formulas and values entry by entry"
        return matrix_differences(entry, answer, solution)
    if entry.values or entry.formulas:
        return component_differences(entry, answer, solution)
    wrong = []
    expected = published_formula(entry.formula, solution)
    if expected is not None:
        if answer.formula is None:
            wrong.append(f"{entry.name}: no closed form; published {entry.text}")
        elif not equal(answer.formula, expected.substitute(RUNNING), letters(solution)):
            wrong.append(f"{entry.name} = {to_text(answer.formula)}; published {entry.text}")
    if entry.value is not None:
        value = evaluate(entry.value, {}, digits=20).float
        found = in_si(answer)
        if found is None:
            wrong.append(f"{entry.name}: no number; published {entry.text}")
        elif abs(found - value) > ACCURACY * max(abs(value), abs(found)):
            wrong.append(f"{entry.name} = {answer.value} {answer.unit}; published {entry.text}")
    if entry.formula is None and entry.value is None and entry.text not in (answer.word, answer.direction):
        wrong.append(f"{entry.name}: {answer.word or answer.direction!r}; published {entry.text!r}")
    return wrong


def component_differences(entry: Published, answer: AnswerView, solution: Solution) -> list[str]:
    """Where the components of a vector differ from the published list, each compared like an answer."""
    parts = list(answer.components.values())
    lists = [found for found in (entry.formulas, entry.values) if found]
    if any(len(found) != len(parts) for found in lists):
        return [f"{entry.name} has {len(parts)} components; published {entry.text}"]
    wrong = []
    for place, part in enumerate(parts):
        formula = entry.formulas[place] if entry.formulas else None
        value = entry.values[place] if entry.values else None
        wrong += differences(Published(part.name, entry.text, formula, value), part, solution)
    return wrong


def test_published_answers_are_reached(problem_file: Path) -> None:
    solution = solved(problem_file)
    wrong = check_answers(solution)
    assert not wrong, "\n".join(wrong)


def test_every_question_has_a_published_answer(problem_file: Path) -> None:
    problem = solved(problem_file).problem
    assert problem.source and problem.text
    assert {entry.name for entry in problem.answers} == {find.name for find in problem.finds}


@pytest.mark.sampled(7)
@pytest.mark.parametrize("law", FAMILIES)
def test_each_law_that_applies_gives_the_same_answers(problem_file: Path, law: str) -> None:
    """What is confirmed by the shortest way are the same answers; here what the assembly contradicts would not even be looked at."""
    confirm = law == LAGRANGE  # whose pages test_problem_lagrange looks at as they are printed
    try:
        solution = solved(problem_file, law, confirm=confirm)
    except Unsolvable:
        return
    wrong = check_answers(solution, law, confirm)
    assert not wrong, "\n".join(wrong)


def test_printed_formulas_read_back_as_the_answers(problem_file: Path) -> None:
    solution = solved(problem_file)
    answers = list(solution.answers.values())
    answers += [part for answer in answers for part in answer.components.values()]
    for answer in answers:
        if answer.formula is not None:
            printed = to_text(answer.formula)
            assert equal(parse(printed, answer.formula.symbols()), answer.formula), printed


@cache
def schema() -> jsonschema.Draft202012Validator:
    jsonschema.Draft202012Validator.check_schema(json_schema())
    return jsonschema.Draft202012Validator(json_schema())


def test_scene_fits_the_schema(problem_file: Path) -> None:
    schema().validate(yaml.load(problem_file.read_text(encoding="utf-8"), yaml.BaseLoader))


def test_nothing_objects_to_the_answers(problem_file: Path) -> None:
    assert [check for check in solved(problem_file).checks if check.holds is False] == []


def test_no_line_uses_what_is_found_further_down(problem_file: Path) -> None:
    seen: set[str] = set()
    for section in solved(problem_file).derivation.sections:
        seen |= {str(law.number) for law in section.laws}
        for move in section.moves:
            assert set(re.findall(r"\((\d+)\)", move.sources)) <= seen, move.sources
            seen |= {str(move.number)}


def test_golden_derivation_is_unchanged(problem_file: Path, regenerate: bool) -> None:
    golden = problem_file.parent / "golden" / f"{problem_file.stem}.txt"
    text = solved(problem_file).to("text", width=WIDTH)
    assert not RAW.search(text), "a letter of the laws has no printed name"
    if regenerate:
        assert not check_answers(solved(problem_file)), "wrong answers are not written as golden"
        golden.parent.mkdir(exist_ok=True)
        golden.write_text(text, encoding="utf-8")
        return
    assert golden.exists(), f"no {golden}: write it with `pytest tests/problems --regenerate`"
    assert text == golden.read_text(encoding="utf-8")
