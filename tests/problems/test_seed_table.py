"""The records of known answers beside the repository, where they are: each problem that names one by `# id:` agrees with it.

Comments at the top of a problem file tie it to its record:
`# id: NAME`, `# ask: name in the record = expression of names under find`, `# given: letter here = letter in the record`.
A name that is the same on both sides needs no comment. A component of a vector is `v.x`; `[a, b, c]` puts a vector together.
"""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import pytest
import yaml

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.formula import Call, Formula, Number, Symbol
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.quantities import parse_quantity
from rotsolve.core.derivation import Answer
from rotsolve.language.problem import Given
from rotsolve.pipeline import solve
from rotsolve.scene.read import read_file
from rotsolve.solution import Solution
from rotsolve.solution.answer import AnswerView

ROOT = Path(__file__).resolve().parents[2]
RECORDS = Path(os.environ.get("SEED_ANSWERS", ROOT.parent / "shared" / "seed-answers.yaml"))
ACCURACY = Fraction(1, 10**9)
COMMENT = re.compile(r"^# (id|ask|given): *(.+?) *$", re.MULTILINE)
PAIR = re.compile(r"(\w+) *= *(.+)")
DOTTED = re.compile(r"([A-Za-z]\w*)\.(\w+)")

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
    asks = {ask["name"]: ask for ask in record["asks"]}
    answered, wrong = [], []
    for name, text in expressions(item, set(solution.answers), list(asks)).items():
        answered.append(name)
        differing = choice_differences if asks[name]["unit"] == "choice" else number_differences
        wrong += [f"{item.file.name}: {name}{said}" for said in differing(text, asks[name], record, item, solution)]
    return answered, wrong


def choice_differences(
    text: str, ask: dict[str, Any], record: dict[str, Any], item: Tied, solution: Solution
) -> Iterator[str]:
    """Whether a choice has the recorded label."""
    word = solution.answers[text].word
    if word.lower() != str(ask["value"]).lower():
        yield f" is {word!r}; the record has {ask['value']!r}"


def number_differences(
    text: str, ask: dict[str, Any], record: dict[str, Any], item: Tied, solution: Solution
) -> Iterator[str]:
    """How an answer differs from the recorded number, vector or tensor, entry by entry; at the record's time where it has one."""
    found = with_components(solution)
    values = flat(ask["value"])
    symbolic = recorded_formulas(ask, record, len(values))
    texts = flat(arranged(text, ask["value"], found))
    assert len(texts) == len(values) == len(symbolic), f"{ask['name']}: {texts} for {values}"
    for entry, recorded, expected in zip(texts, values, symbolic, strict=True):
        expression = parse(DOTTED.sub(r"\1__\2", str(entry)), set(found))
        formula = formula_of(expression, found)
        if expected is not None and formula is not None:
            wanted = renamed(expected, item)
            given = {given.name for given in solution.problem.givens} | {"g", "t"}
            if not same(formula.substitute({"time": Symbol("t")}), wanted, given):
                yield f" = {to_text(formula)}; the record has {to_text(expected)}"
        value, number = number_of(expression, found, solution, time_of(ask)), recorded_value(recorded, ask)
        if abs(value - number) > ACCURACY * max(abs(value), abs(number)):
            yield f" = {value!r} in SI units; the record has {number!r}"


def same(formula: Formula, wanted: Formula, given: Collection[str]) -> bool:
    """Whether two closed forms are equal; of angles and roots, which have many forms, at some numbers for their letters."""
    if equal(formula, wanted, given):
        return True
    if not any(
        node.function[0] in "as" for side in (formula, wanted) for node in side.walk(Call) if isinstance(node, Call)
    ):
        return False
    letters = sorted(formula.symbols() | wanted.symbols())
    for turn in (1, 2, 3):
        values = {name: Number(Fraction(7 * turn + 3 * place, 5 + turn)) for place, name in enumerate(letters, 1)}
        one, other = (evaluate(side, values, digits=15).float for side in (formula, wanted))
        if abs(one - other) > ACCURACY * max(abs(one), abs(other)):
            return False
    return True


def with_components(solution: Solution) -> dict[str, AnswerView]:
    """All answers by name, and their components: `v__x` of the vector `v`, `I__xy` of the tensor `I`."""
    parts = {
        f"{name}__{part.removeprefix(f'{name}_')}": view
        for name, answer in solution.answers.items()
        for part, view in answer.components.items()
    }
    return {**solution.answers, **parts}


def arranged(text: str, recorded: Any, found: dict[str, AnswerView]) -> Any:
    """The expressions for the entries of a record: written as a list, or those of a vector or tensor that is named.

    A vector of the plane has nothing along z; a turn is a vector along z.
    """
    if not isinstance(recorded, list):
        return text
    if text.startswith("["):
        return yaml.safe_load(text)
    if isinstance(recorded[0], list):
        names = [[f"{text}__{row}{column}" for column in "xyz"] for row in "xyz"]
        return [[name if name in found else f"{name[:-2]}{name[:-3:-1]}" for name in row] for row in names]
    if f"{text}__x" in found:
        third = f"{text}__z" if f"{text}__z" in found else "0"
        return [f"{text}__x", f"{text}__y", third][: len(recorded)]
    return ["0"] * (len(recorded) - 1) + [text]


def flat(value: Any) -> list[Any]:
    """The entries of a number, vector or tensor, row by row."""
    return [entry for item in value for entry in flat(item)] if isinstance(value, list) else [value]


def recorded_formulas(ask: dict[str, Any], record: dict[str, Any], count: int) -> list[Formula | None]:
    """The closed forms of a record's entries; those of a matrix are worked out by SymPy."""
    text = ask.get("symbolic")
    if text is None:
        return [None] * count
    names = {*record["givens"], "t"}
    texts = [str(text)]
    if "Matrix" in str(text) or "Rational" in str(text):
        import sympy

        matrix = sympy.sympify(str(text), locals={name: sympy.Symbol(name, real=True) for name in names})
        texts = [str(entry) for entry in matrix] if "Matrix" in str(text) else [str(matrix)]
    return [parse(entry.replace("**", "^"), names) for entry in texts]


def formula_of(expression: Formula, found: dict[str, AnswerView]) -> Formula | None:
    formulas = {name: found[name].formula for name in expression.symbols()}
    if None in formulas.values():
        return None
    return expression.substitute({name: formula for name, formula in formulas.items() if formula is not None})


def number_of(expression: Formula, found: dict[str, AnswerView], solution: Solution, time: Formula | None) -> float:
    """The value of an expression of answers, in SI units; that of a function of time at the record's time."""
    values: dict[str, Formula] = {}
    for name in expression.symbols():
        answer = found[name].answer
        if answer.value is not None:
            number: Formula = Number(Fraction(answer.value.float))
            values[name] = number if answer.unit is None else number * answer.unit.factor
        else:
            assert answer.formula is not None and time is not None, f"{name} has no number"
            values[name] = answer.formula.substitute({"time": time, "t": time})
    givens = {given.name: given.value for given in solution.problem.givens if given.value is not None}
    return evaluate(expression.substitute(values), givens, digits=15).float


def time_of(ask: dict[str, Any]) -> Formula | None:
    at = (ask.get("at") or {}).get("t")
    return None if at is None else parse_quantity(str(at)).value


def recorded_value(number: Any, ask: dict[str, Any]) -> float:
    """A recorded number in SI units."""
    unit = "" if str(ask["unit"]) == "1" else f" {ask['unit']}"
    inverse = re.fullmatch(r" 1/(\w+?)(?:\^(\d))?", unit)
    unit = unit if inverse is None else f" {inverse[1]}^-{inverse[2] or 1}"
    return evaluate(parse_quantity(f"{number!r}{unit}").value, {}, digits=15).float


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


def test_a_wrong_record_is_noticed() -> None:
    item = next(item for item in tied() if item.id == "k-lbar-P")
    record = next(record for record in records() if record["id"] == item.id)
    turned = {**record["asks"][0], "symbolic": "Matrix([y*omega, x*omega, 0])", "value": [0.4, 1.0, 0.0]}
    _, wrong = wrong_asks(item, {**record, "asks": [turned]})
    assert len(wrong) == 2
    choice = {"name": "v", "symbolic": None, "value": "c", "unit": "choice"}
    assert len(wrong_asks(item, {**record, "asks": [choice]})[1]) == 1


def test_entries_of_vectors_turns_and_tensors() -> None:
    plane = {"v": None, "v__x": None, "v__y": None, "I__xx": None, "I__yy": None, "I__zz": None, "I__xy": None}
    found: dict[str, Any] = {**plane, "I__xz": None, "I__yz": None}
    assert arranged("v", [1.0, 2.0, 0.0], found) == ["v__x", "v__y", "0"]
    assert arranged("v", [1.0, 2.0], found) == ["v__x", "v__y"]
    assert arranged("w", [0.0, 0.0, 3.0], found) == ["0", "0", "w"]
    assert arranged("[F.x, 0, F.y]", [0.0, 0.0, 3.0], found) == ["F.x", 0, "F.y"]
    rows = [["I__xx", "I__xy", "I__xz"], ["I__xy", "I__yy", "I__yz"], ["I__xz", "I__yz", "I__zz"]]
    assert arranged("I", [[1.0] * 3] * 3, found) == rows
    assert flat(rows)[5] == "I__yz"


def test_a_function_of_time_is_compared_at_the_time_of_the_record() -> None:
    formula = parse("a*time^2/2", {"a", "time"})
    answer = Answer("x", Symbol("x"), formula, None, None, None)
    problem = SimpleNamespace(givens=(Given("a", Number(Fraction(3)), None),))
    found, solution = {"x": AnswerView(answer)}, cast("Solution", SimpleNamespace(problem=problem))
    ask = {"at": {"t": "2 s"}}
    assert number_of(Symbol("x"), found, solution, time_of(ask)) == pytest.approx(6)


def test_table_of_what_is_done_and_missing() -> None:
    """Prints the table (`pytest -s`); nothing may be missing."""
    rows, incomplete = [], set()
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
        if missing:
            incomplete.add(record["id"])
        rows.append(f"{record['id']:28} {len(done):3} of {len(asks):3}   {state}")
    print("\n".join(["", *rows, f"{len(rows) - len(incomplete)} of {len(rows)} complete"]))
    assert len(rows) == 98
    assert not incomplete
