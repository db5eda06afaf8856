"""Numbers put in for some letters, and fractions of numbers in front: what holds for the answers of all problems."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from itertools import permutations
from pathlib import Path

import pytest

from rotsolve.algebra.formula import Formula, Integral, Number, Symbol
from rotsolve.algebra.notation.limits import rational
from rotsolve.algebra.notation.text import to_text
from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.verdict import RIGHT, UNDECIDED, WRONG, JudgedPart, Paper
from rotsolve.pipeline import solve
from solutions import solved

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
FILES = sorted(PROBLEMS.glob("*/*.yaml"))
FALLING, CLUTCH = "pulleys/block-on-disc-falling", "axles/clutch-of-two-discs"
SHORT = 120  # characters of an answer that a student would write
PART = Number(Fraction(3, 7))


@cache
def judge(problem: str) -> Judge:
    return Judge(solve(PROBLEMS / f"{problem}.yaml"))


def part(by: Judge, name: str, text: str) -> JudgedPart:
    return next(one for one in by.mark(Paper("one", {name: text})).parts if one.name == name)


def plain_answers(file: Path) -> Iterator[tuple[str, Formula]]:
    """The answers of a scene in letters with numbers, of a length that is written by hand."""
    solution = solved(file)
    for answer in solution.derivation.answers:
        closed, values = answer.closed, solution.problem.values
        if answer.value is None or answer.value.sign in (0, None) or closed is None or closed.holds(Integral):
            continue
        if closed.symbols() and closed.symbols() <= values.keys() and len(to_text(closed)) <= SHORT:
            yield answer.name, closed


@pytest.mark.sampled(10)
@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_one_letter_as_so_many_times_another(file: Path) -> None:
    """Where M is twice m, each answer with 2 m for M is right, and half as much again is not."""
    problem = solved(file).problem
    numbers = {given.name: rational(given.value) for given in problem.givens if given.value is not None}
    known = {name: number for name, number in numbers.items() if number}
    measured = {given.name: given.dimension for given in problem.givens}
    by = Judge(solved(file))
    for name, closed in plain_answers(file):
        letters = sorted(closed.symbols() & known.keys())
        pairs = [pair for pair in permutations(letters, 2) if measured[pair[0]] == measured[pair[1]]]
        for one, other in pairs[:2]:
            put = closed.substitute({one: Number(known[one] / known[other]) * Symbol(other)})
            if not put.symbols():
                continue
            found = part(by, name, to_text(put))
            assert found.verdict.outcome == RIGHT, (name, to_text(put), found.verdict)
            half_more = part(by, name, f"1.5 ({to_text(put)})")
            assert half_more.verdict.outcome != RIGHT, (name, to_text(put), half_more.verdict)


@pytest.mark.sampled(10)
@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_nothing_behind_a_fraction_of_numbers_is_its_denominator(file: Path) -> None:
    by = Judge(solved(file))
    for name, closed in plain_answers(file):
        rest, below = closed / PART, PART / closed
        for gap in (" ", ""):
            right, wrong = (part(by, name, f"3/7{gap}({to_text(side)})").verdict for side in (rest, below))
            assert right.outcome == RIGHT, (name, to_text(closed), right)
            assert wrong.outcome == WRONG, (name, to_text(closed), wrong)


@pytest.mark.parametrize(
    ("problem", "name", "text", "outcome"),
    [
        (FALLING, "F", "M g + m g/2", RIGHT),
        (FALLING, "F", "5/4 M g", RIGHT),
        (FALLING, "F", "2.5 m g", RIGHT),
        (FALLING, "F", "2 m g", WRONG),
        (FALLING, "F", "5/4 M", WRONG),
        (CLUTCH, "Q", "3/8 I1 w²", RIGHT),
        (CLUTCH, "Q", "½ I1 w² (1 - 1/4)", RIGHT),
        (CLUTCH, "Q", "I2 w²/8", RIGHT),
        (CLUTCH, "Q", "I2 w²/4", WRONG),
        (CLUTCH, "t", "I2 w/(4τ)", RIGHT),
    ],
)
def test_what_is_worth_the_answer(problem: str, name: str, text: str, outcome: str) -> None:
    assert part(judge(problem), name, text).verdict.outcome == outcome


@pytest.mark.parametrize(
    ("line", "outcome"),
    [
        ("a = g/2", RIGHT),
        ("2a = g", RIGHT),
        ("M = 2m", RIGHT),
        ("F = 5/4 M g", RIGHT),
        ("a = g/3", WRONG),
        ("M = 3m", WRONG),
        ("m g - T = 3 m a", WRONG),
        ("T = m a", UNDECIDED),  # no law, but true of these numbers
        ("m g = M a", UNDECIDED),
    ],
)
def test_lines_of_working_with_numbers_put_in(line: str, outcome: str) -> None:
    (found,) = judge(FALLING).mark(Paper("one", {}, (line,))).lines
    assert found.verdict.outcome == outcome, found.verdict


def test_what_a_mistake_makes_in_letters_is_no_chance_number() -> None:
    """With M = 2 m a ring for the disc gives a = m g/(m + M) = g/3; where numbers make it the answer, it is a mistake all the same."""
    by = judge("pulleys/block-on-disc")
    asked = by.targets["a"].whole
    assert asked is not None
    mistaken = by.explaining.mistake_in_letters
    m, big, g = Symbol("m"), Symbol("M"), Symbol("g")
    assert mistaken("a", m * g / (m + big), asked) is not None
    assert mistaken("a", 5 * m * g / big, asked) is None


@pytest.mark.parametrize(
    ("problem", "name", "text", "outcome"),
    [
        ("rolling/ball-on-incline", "mu", "2/7 tan θ", RIGHT),
        ("rolling/ball-on-incline", "mu", "2/7tanθ", RIGHT),
        ("rolling/ball-on-incline", "mu", "2/7 cot θ", WRONG),
        ("rolling/ball-on-incline", "mu", "2/7cotθ", WRONG),
        ("rolling/ball-on-incline", "mu", "2/7 cot(25°)", WRONG),
        ("rolling/ball-on-incline", "mu", "2/7 tan(θ)^-1", WRONG),
        ("rolling/ball-on-incline", "mu", "2/7 cotθ = 0.613", WRONG),
        ("rolling/cylinder-on-incline", "mu", "1/3 cot θ", WRONG),
        ("rolling/cylinder-on-incline", "a", "2 g/3 csc θ", WRONG),
        ("rolling/cylinder-on-incline", "a", "2 g/3 sin θ", RIGHT),
        ("hinged/rod-30", "alpha", "-3g/2L sec θ", WRONG),
        ("hinged/rod-30", "alpha", "-3g/2L cos θ", RIGHT),
        ("hinged/ladder", "alpha", "-3 g/2 L sec θ", WRONG),
        ("hinged/conical-pendulum", "T", "2π √(L/g sec θ)", WRONG),
        ("hinged/conical-pendulum", "T", "2π √(L/g cos θ)", RIGHT),
        ("hinged/conical-pendulum", "omega", "√(g/L cos θ)", WRONG),
        ("varying-forces/flywheel-viscous-drag", "n", "1/2 π I ω0/c", WRONG),
        ("varying-forces/flywheel-viscous-drag", "n", "1/2π I ω0/c", RIGHT),
        ("varying-forces/flywheel-viscous-drag", "n", "I ω0/2πc", RIGHT),
    ],
)
def test_denominators(problem: str, name: str, text: str, outcome: str) -> None:
    found = part(judge(problem), name, text)
    assert found.verdict.outcome == outcome, found.verdict
    assert not any("is right" in str(remark.words) for remark in found.verdict.remarks)
    if text.endswith(("1/2π I ω0/c", "2πc")):
        assert found.verdict.read_as
