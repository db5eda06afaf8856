"""What holds for every answer: other units of the same kind are as good, nothing outside the tolerance is right, order does not matter."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import Integral, Number
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.notation.typeset import to_latex
from rotsolve.algebra.units.quantities import parse_unit
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.core.derivation import Answer
from rotsolve.grading.comparing.numbers import Typed, is_near, within_tolerance
from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.verdict import PARTLY, RIGHT, UNDECIDED, WRONG, JudgedPart, Paper
from rotsolve.language.marks import Tolerance
from rotsolve.page.blocks import Amount
from rotsolve.page.text import PRINTER
from rotsolve.page.values import certified_digits
from rotsolve.pipeline import solve
from solutions import solved

PROBLEMS = Path(__file__).parent.parent.parent / "problems"
FILES = sorted(PROBLEMS.glob("*/*.yaml"))
SCENES = ("pulleys/block-on-disc", "hinged/rod-30", "angular-momentum/man-walks-round", "varying-forces/parachutist")
OTHERS = {  # for each unit of an answer others that measure the same
    "m/s²": ("m/s^2", "cm/s²", "km/h^2", "ft/s^2", "N/kg"),
    "rad/s²": ("rad/s^2", "rev/s²", "°/s²", "1/s²"),
    "rad/s": ("rpm", "rev/min", "rev/s", "°/s", "1/s", "rad/min"),
    "N": ("kN", "mN", "kg m/s²", "J/m", "lbf", "dyn"),
    "N m": ("J", "kN m", "N cm", "kg m²/s²"),
    "J": ("kJ", "N m", "mJ", "Wh", "kg m²/s²"),
    "kg m²": ("kg cm²", "g m²", "N m s²"),
    "°": ("rad", "rev", "deg", "arcmin"),
    "m/s": ("km/h", "cm/s", "mph"),
    "s": ("ms", "min", "h"),
}
SHARE = Fraction(1, 100)  # the usual tolerance


@cache
def judge(problem: str) -> Judge:
    return Judge(solve(PROBLEMS / f"{problem}.yaml"))


def part(problem: str, name: str, text: str) -> JudgedPart:
    return next(item for item in judge(problem).mark(Paper("one", {name: text})).parts if item.name == name)


def answers(problem: str) -> list[Answer]:
    return [one for one in judge(problem).letters.solution.derivation.answers if one.value is not None]


def drawn(data: st.DataObject, problem: str) -> Answer:
    """One answer by its number: balls can not be hashed."""
    known = answers(problem)
    return known[data.draw(st.integers(0, len(known) - 1))]


def in_other(answer: Answer, unit: Unit) -> Fraction:
    """The value of an answer before another unit, to 12 figures."""
    assert answer.value is not None and answer.unit is not None
    ratio = evaluate(answer.unit.factor / unit.factor, {}, digits=30)
    return Fraction(f"{float((answer.value.refine(30) * ratio.ball).mid()):.12g}")


def decimal(number: Fraction) -> str:
    return f"{float(number):.12g}"


@given(st.data())
@settings(max_examples=150, deadline=None)
def test_a_right_number_in_another_unit_of_the_same_kind_is_right(data: st.DataObject) -> None:
    problem = data.draw(st.sampled_from(SCENES))
    answer = drawn(data, problem)
    assert answer.unit is not None
    unit = parse_unit(data.draw(st.sampled_from(OTHERS.get(answer.unit.text, (answer.unit.text,)))))
    off = data.draw(st.fractions(-SHARE * Fraction(9, 10), SHARE * Fraction(9, 10), max_denominator=10**6))
    found = part(problem, answer.name, unit.after(decimal(in_other(answer, unit) * (1 + off))))
    assert (found.verdict.outcome, found.marks) == (RIGHT, found.of)


@given(st.data())
@settings(max_examples=150, deadline=None)
def test_no_number_outside_the_tolerance_is_right(data: st.DataObject) -> None:
    problem = data.draw(st.sampled_from(SCENES))
    answer = drawn(data, problem)
    assert answer.unit is not None
    unit = parse_unit(data.draw(st.sampled_from(OTHERS.get(answer.unit.text, (answer.unit.text,)))))
    size = data.draw(st.fractions(SHARE * Fraction(11, 10), 1000, max_denominator=10**6))
    off = data.draw(st.sampled_from((size, -size)))
    found = part(problem, answer.name, unit.after(decimal(in_other(answer, unit) * (1 + off))))
    assert found.verdict.outcome in (WRONG, PARTLY) and found.marks < found.of


@pytest.mark.exhaustive
@given(st.data())
@settings(max_examples=20, deadline=None)
def test_the_order_of_the_answers_changes_nothing(data: st.DataObject) -> None:
    problem = data.draw(st.sampled_from(SCENES))
    asked = answers(problem)
    factors = data.draw(st.lists(st.sampled_from((1, 2, Fraction(1, 2), -1)), min_size=len(asked), max_size=len(asked)))
    written = [
        (one.name, one.unit.after(decimal(in_other(one, one.unit) * factor)))
        for one, factor in zip(asked, factors, strict=True)
        if one.unit is not None
    ]
    shuffled = data.draw(st.permutations(written))
    fresh = Judge(judge(problem).letters.solution)
    assert fresh.mark(Paper("one", dict(shuffled))) == judge(problem).mark(Paper("one", dict(written)))


@given(st.fractions(Fraction(1, 10**4), 10**4, max_denominator=10**4), st.integers(1, 200), st.sampled_from((1, -1)))
@settings(max_examples=200, deadline=None)
def test_the_edge_of_a_tolerance_is_within_and_what_is_beyond_is_not(value: Fraction, percent: int, side: int) -> None:
    share = Fraction(percent, 1000)
    sought = evaluate(Typed(Number(value)).value, {})
    edge = value * (1 + side * share)
    assert is_near(Typed(Number(edge)), sought, share=share) is True
    beyond = edge + side * value / 10**40
    assert is_near(Typed(Number(beyond)), sought, share=share) is False


@pytest.mark.parametrize(
    ("number", "sought", "figures", "holds"),
    [
        ("4.355", "4.3555555", 3, True),
        ("4.36", "4.3555555", 3, True),
        ("4.35", "4.3555555", 3, False),
        ("4.3505555", "4.3555555", 3, True),
        ("10.04", "9.996", 3, True),
        ("9.95", "9.996", 3, True),
        ("10.06", "10.0", 3, False),
        ("10.05", "10.0", 3, True),
        ("0.000123", "0.0001234", 3, True),
        ("0.000124", "0.0001234", 3, False),
    ],
)
def test_figures(number: str, sought: str, figures: int, holds: bool) -> None:
    """Half a unit of the last figure of the answer."""
    typed, value = Typed(Number(Fraction(number))), evaluate(Number(Fraction(sought)), {})
    assert within_tolerance(typed, value, Tolerance("", figures=figures), parse_unit("m")) is holds


def number_text(answer: Answer) -> str:
    """The number of an answer with its unit."""
    return PRINTER.part(Amount(certified_digits(answer.value, 6)[0], answer.unit))


def printed(answer: Answer) -> list[str]:
    """An answer as the program prints it: its exact form in three notations, its number with its unit, its word."""
    found = [answer.word] if answer.word else []
    if answer.formula is not None:
        found += [to_text(answer.formula), to_text(answer.formula, unicode=False)]
        found += (
            [] if answer.formula.holds(Integral) else [to_latex(answer.formula)]
        )  # an integral sign of LaTeX is not read
    if answer.value is not None:
        found.append(number_text(answer))
        found += [f"{number_text(answer)}, {answer.direction}"] if answer.direction else []
    if len(answer.rows) == 1:
        (row,) = answer.rows
        found += [f"({', '.join(number_text(part) for part in row)})"]
        found += [f"({', '.join(to_text(part.formula) for part in row if part.formula is not None)})"]
    elif answer.rows:
        numbers = [", ".join(number_text(part) for part in row) for row in answer.rows]
        forms = [", ".join(to_text(part.formula) for part in row if part.formula is not None) for row in answer.rows]
        found += [f"[[{'], ['.join(rows)}]]" for rows in (numbers, forms)]
    return found


@pytest.mark.sampled(3)
@pytest.mark.parametrize("file", FILES, ids=lambda file: f"{file.parent.name}/{file.stem}")
def test_every_answer_as_it_is_printed_is_right(file: Path) -> None:
    solution = solved(file)
    own = Judge(solution)
    scene = (
        {given.name for given in solution.problem.givens}
        | {find.name for find in solution.problem.finds}
        | {"g", "time"}
    )
    for answer in solution.derivation.answers:
        of_the_page = answer.formula is not None and bool(
            answer.formula.symbols() - scene
        )  # cn(u₀ + p t, m), defined above it
        for text in printed(replace(answer, formula=None) if of_the_page else answer):
            found = next(item for item in own.mark(Paper("one", {answer.name: text})).parts if item.name == answer.name)
            assert (found.verdict.outcome, found.marks) == (RIGHT, found.of), f"{answer.name} = {text}: {found.verdict}"


def test_what_can_not_be_read_is_not_called_wrong() -> None:
    for text in ("2 m g/(", "foo(bar)", "__import__('os')", "9**9**9**9", "(" * 10_000, "a = b = c", "💥"):
        found = part("pulleys/block-on-disc", "a", text)
        assert found.verdict.outcome == UNDECIDED and found.marks == 0
