"""The records of known answers beside the repository, where they are: each problem that names one by `# id:` agrees with it.

Comments at the top of a problem file tie it to its record:
`# id: NAME`, `# ask: name in the record = expression of names under find`, `# given: letter here = letter in the record`.
A name that is the same on both sides needs no comment. A vector of the record is asked as `[v_x, v_y]`; components left out are zero.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import yaml

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.formula import Formula, Number, Symbol
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.quantities import parse_quantity
from rotsolve.pipeline import solve
from rotsolve.scene.read import read_file
from rotsolve.solution import Solution

ROOT = Path(__file__).resolve().parents[2]
RECORDS = ROOT.parent / "shared" / "seed-answers.yaml"
ACCURACY = Fraction(1, 10**9)
COMMENT = re.compile(r"^# (id|ask|given): *(.+?) *$", re.MULTILINE)
PAIR = re.compile(r"(\w+) *= *(.+)")

pytestmark = pytest.mark.skipif(not RECORDS.exists(), reason="the records are not beside the repository")


@dataclass(frozen=True)
class Tied:
    """A problem file with what its comments say."""

    file: Path
    id: str
    asks: dict[str, str]  # name in the record -> expression of the file's names under find
    givens: dict[str, str]  # letter of the file -> letter of the record


@cache
def tied() -> tuple[Tied, ...]:
    found = []
    for file in sorted((ROOT / "problems").rglob("*.yaml")):
        said: dict[str, list[str]] = {"id": [], "ask": [], "given": []}
        for word, text in COMMENT.findall(file.read_text(encoding="utf-8")):
            said[word].append(text)
        pairs = {
            word: dict(match.groups() for text in said[word] if (match := PAIR.fullmatch(text)))
            for word in ("ask", "given")
        }
        found += [Tied(file, name, pairs["ask"], pairs["given"]) for name in said["id"]]
    return tuple(found)


@cache
def records() -> tuple[dict[str, Any], ...]:
    return tuple(yaml.safe_load(RECORDS.read_text(encoding="utf-8"))["records"])


def expressions(item: Tied, names: set[str], asks: list[str]) -> dict[str, str]:
    """The asks of the record that this file answers, as expressions of its names under find."""
    used = {name for text in item.asks.values() for name in re.findall(r"\w+", text)}
    same = {name: name for name in asks if name in names and name not in used and name not in item.asks}
    return {**same, **{name: text for name, text in item.asks.items() if name in asks}}


def solved_as(item: Tied, record: dict[str, Any], at: str | None = None) -> Solution:
    """The problem with the numbers of the record, functions of time evaluated where it says."""
    own = {given.name for given in read_file(item.file).givens if not given.asked and not given.automatic}
    values = {name: str(value) for name, value in record["givens"].items()}
    settings = {name: values[item.givens.get(name, name)] for name in own if item.givens.get(name, name) in values}
    return solve(item.file, settings=settings, at=at)


def wrong_asks(item: Tied, record: dict[str, Any]) -> tuple[list[str], list[str]]:
    """The asks that this file answers, and how its answers differ from the record's."""
    solution = solved_as(item, record)
    letters = {*record["givens"], "t"}  # t is the running time
    asks = {ask["name"]: ask for ask in record["asks"]}
    answered, wrong = [], []
    for name, text in expressions(item, set(solution.answers), list(asks)).items():
        answered.append(name)
        place = f"{item.file.name}: {name}"
        if text.startswith("["):
            wrong += wrong_components(place, text, asks[name], solution, item, letters)
            continue
        expression = parse(text, set(solution.answers))
        found = formula_of(expression, solution)
        expected = asks[name].get("symbolic")
        if expected is not None and found is not None:
            formula = renamed(parse(str(expected).replace("**", "^"), letters), item)
            if not equal(found, formula, {given.name for given in solution.problem.givens} | {"g"}):
                wrong.append(f"{place} = {to_text(found)}; the record has {expected}")
        moment = asks[name].get("at", {}).get("t")
        value = number_of(expression, solution if moment is None else solved_as(item, record, str(moment)))
        recorded = recorded_value(asks[name])
        if abs(value - recorded) > ACCURACY * max(abs(value), abs(recorded)):
            wrong.append(f"{place} = {value!r} in SI units; the record has {recorded!r}")
    return answered, wrong


def wrong_components(
    place: str, text: str, ask: dict[str, Any], solution: Solution, item: Tied, letters: set[str]
) -> list[str]:
    """How the components `[a, b]` of an answer differ from a vector of the record."""
    expected = str(ask["symbolic"]).replace("**", "^").removeprefix("Matrix([").removesuffix("])").split(",")
    names, wrong = text.strip("[]").split(","), []
    for index, (one, value) in enumerate(zip(expected, ask["value"], strict=True)):
        expression = parse(names[index] if index < len(names) else "0", set(solution.answers))
        found = formula_of(expression, solution)
        formula = renamed(parse(one, letters), item)
        if found is None or not equal(found, formula, {given.name for given in solution.problem.givens}):
            wrong.append(f"{place}: component {index + 1} is not {one}")
        recorded = recorded_value({"value": value, "unit": ask["unit"]})
        if abs(number_of(expression, solution) - recorded) > ACCURACY * max(abs(recorded), 1):
            wrong.append(f"{place}: component {index + 1} is not {value}")
    return wrong


def formula_of(expression: Formula, solution: Solution) -> Formula | None:
    formulas = {name: solution.answers[name].formula for name in expression.symbols()}
    if None in formulas.values():
        return None
    return expression.substitute({name: formula for name, formula in formulas.items() if formula is not None})


def number_of(expression: Formula, solution: Solution) -> float:
    """The value of an expression of answers, in SI units."""
    values = {}
    for name in expression.symbols():
        answer = solution.answers[name]
        number: Formula = Number(Fraction(answer.answer.value.float))  # type: ignore[union-attr]
        values[name] = number if answer.answer.unit is None else number * answer.answer.unit.factor
    return evaluate(expression.substitute(values), {}, digits=15).float


def recorded_value(ask: dict[str, Any]) -> float:
    """The recorded number in SI units."""
    unit = "" if str(ask["unit"]) == "1" else f" {ask['unit']}"
    return evaluate(parse_quantity(f"{ask['value']!r}{unit}").value, {}, digits=15).float


def renamed(formula: Formula, item: Tied) -> Formula:
    """A formula of the record in the letters of the file."""
    return formula.substitute({theirs: Symbol(own) for own, theirs in item.givens.items()})


def test_every_id_in_the_problems_is_in_the_records() -> None:
    known = {record["id"] for record in records()}
    assert [item.file.name for item in tied() if item.id not in known] == []
    for item in tied():
        record = next(record for record in records() if record["id"] == item.id)
        unknown = set(item.asks) - {ask["name"] for ask in record["asks"]}
        assert not unknown, f"{item.file.name}: the record {item.id} does not ask for {', '.join(sorted(unknown))}"


@pytest.mark.parametrize("item", tied(), ids=lambda item: f"{item.id}:{item.file.stem}")
def test_answers_are_those_of_the_record(item: Tied) -> None:
    record = next(record for record in records() if record["id"] == item.id)
    answered, wrong = wrong_asks(item, record)
    assert answered, "the file answers nothing of what the record asks"
    assert not wrong, "\n".join(wrong)


def test_table_of_what_is_done_and_missing() -> None:
    """Prints the table (`pytest -s`); what is missing is no failure."""
    rows = []
    for record in records():
        asks = [ask["name"] for ask in record["asks"]]
        files = [item for item in tied() if item.id == record["id"]]
        done = {
            name
            for item in files
            for name in expressions(item, {find.name for find in read_file(item.file).finds}, asks)
        }
        missing = [name for name in asks if name not in done]
        state = "missing" if not done else "done" if not missing else f"without {', '.join(missing)}"
        rows.append(f"{record['id']:28} {len(done):3} of {len(asks):3}   {state}")
    complete = sum(row.endswith("done") for row in rows)
    print("\n".join(["", *rows, f"{complete} of {len(rows)} complete"]))
    assert len(rows) == 98
