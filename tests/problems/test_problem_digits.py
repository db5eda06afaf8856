"""Every printed digit of every problem: 4, 50 and 100 of them agree, with each other and with the published formula by mpmath."""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

import pytest
from mpmath import mpf

from rotsolve.core.derivation import Answer
from rotsolve.page.values import certified_digits, machine_number
from rotsolve.pipeline import solve
from rotsolve.solution import Solution
from solutions import solved
from trials.evaluate import Unknown, value
from trials.figures import wrong
from trials.held import givens
from trials.outcome import Printed

FORMATS = ("text", "markdown", "latex", "html", "json")
MOMENT = "t=0.5s"


def numbers(solution: Solution) -> Iterator[Answer]:
    pending = list(solution.derivation.answers)
    while pending:
        answer = pending.pop()
        pending += answer.components
        if answer.value is not None:
            yield answer


def moments(file: Path) -> tuple[Solution, ...]:
    """The problem, and where it asks for functions of time, those at a moment."""
    solution = solved(file)
    runs = any(find.runs for find in solution.problem.finds)
    return (solution, solved(file, at=MOMENT)) if runs else (solution,)


def rounded(text: str, digits: int) -> Fraction:
    """A printed number to fewer figures, a half away from zero."""
    number = Fraction(text)
    if not number:
        return number
    place = Fraction(10) ** (len(str(int(abs(number)))) - digits if abs(number) >= 1 else 0)
    while abs(number) / place < 10 ** (digits - 1):
        place /= 10
    whole = (abs(number) / place + Fraction(1, 2)).__floor__()
    return (whole if number > 0 else -whole) * place


def test_fewer_digits_are_the_rounded_ones_of_more(problem_file: Path) -> None:
    for solution in moments(problem_file):
        for answer in numbers(solution):
            printed = {digits: certified_digits(answer.value, digits) for digits in (4, 50, 100)}
            assert all(note == "" for _, note in printed.values()), printed
            long = machine_number(printed[100][0])
            for digits in (4, 50):
                assert Fraction(machine_number(printed[digits][0])) == rounded(long, digits), printed


def test_fifty_digits_are_those_of_the_formula_by_another_arithmetic(problem_file: Path) -> None:
    solution = solved(problem_file)
    letters = givens(solution)
    for entry in solution.problem.answers:
        answer = solution.answers.get(entry.name)
        if entry.formula is None or entry.at is not None or answer is None or answer.answer.value is None:
            continue
        try:
            true = value(entry.formula, letters) / value(answer.answer.unit.factor, {}) if answer.answer.unit else None
        except Unknown:
            continue
        if true is not None:
            printed = Printed(machine_number(certified_digits(answer.answer.value, 50)[0]))
            assert not wrong(printed, mpf(true), 50), f"{entry.name}: {wrong(printed, mpf(true), 50)}"


@pytest.mark.parametrize(
    "name", ["pulleys/atwood.yaml", "hinged/compass-needle.yaml", "swings/swing-from-60-degrees.yaml"]
)
def test_all_formats_print_the_same_digits(name: str) -> None:
    file = Path(__file__).resolve().parents[2] / "problems" / name
    solution = solve(file, digits=50)
    texts = {form: re.sub(r"\s", "", solution.to(form, width=400)) for form in FORMATS}
    for answer in numbers(solution):
        figures = max(re.findall(r"\d+", machine_number(certified_digits(answer.value, 50)[0]).split("e")[0]), key=len)
        assert all(figures in text for text in texts.values()), figures


def test_digits_beyond_all_measure_are_refused() -> None:
    file = Path(__file__).resolve().parents[2] / "problems" / "pulleys" / "atwood.yaml"
    with pytest.raises(ValueError, match="from 1 to 1000 digits"):
        solve(file, digits=10**6)
