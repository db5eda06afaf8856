"""Ordinary writing: answers as the pages print them, in each language; uncertainties, figures, directions, numbers in units of letters."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import Number
from rotsolve.grading.comparing.numbers import figures_that_hold
from rotsolve.grading.comparing.readings import typed_in
from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.reading.answers import read_line
from rotsolve.grading.reading.records import Names
from rotsolve.grading.verdict import RIGHT, UNDECIDED, WRONG, JudgedPart, Paper
from rotsolve.page.blocks import Amount
from rotsolve.page.languages import LANGUAGES, language_named
from rotsolve.page.languages.language import Translation
from rotsolve.page.values import answer_row
from rotsolve.pipeline import solve

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
ALL = [path.relative_to(PROBLEMS).with_suffix("").as_posix() for path in sorted(PROBLEMS.rglob("*.yaml"))]
DISC, SLOPE = "pulleys/block-on-disc", "rolling/cylinder-on-incline"
SLEDGE = """
given: {m1: 4 kg, m2: 6 kg, M: 5 kg, R: 20 cm, mu: 0.25}
surfaces: {floor: level}
bodies:
  sledge: {mass: m1, moves: right}
  drum: {shape: disc, mass: M, radius: R, turns: clockwise}
  bucket: {mass: m2, moves: down}
connections:
  base: {contact: [sledge, floor], friction: mu}
  axle: {axle: drum}
  rope: {string: [sledge, drum, bucket]}
find: {a: bucket.acceleration, T: rope.bucket.tension, f: size of base.friction_force, alpha: size of drum.angular_acceleration}
"""


@cache
def judge(scene: str) -> Judge:
    return Judge(solve(scene if "\n" in scene else PROBLEMS / f"{scene}.yaml"))


def part(scene: str, name: str, text: str) -> JudgedPart:
    return next(one for one in judge(scene).mark(Paper("one", {name: text})).parts if one.name == name)


def kinds(found: JudgedPart) -> set[str]:
    return {remark.kind for remark in found.verdict.remarks}


def number(scene: str, name: str) -> float:
    whole = judge(scene).targets[name].whole
    assert whole is not None and whole.value is not None
    return whole.value.float


@pytest.mark.sampled(6)
@pytest.mark.parametrize("scene", ALL)
def test_an_answer_as_the_pages_print_it_is_right(scene: str) -> None:
    own = judge(scene)
    for answer in own.letters.solution.derivation.answers:
        row = answer_row(answer, 4)
        shown = next((form for form in row.forms if isinstance(form, Amount) and isinstance(form.number, str)), None)
        if answer.rows or answer.otherwise or shown is None:
            continue
        for code in LANGUAGES:
            language = language_named(code)
            page = None if language is None else Translation(language)
            value = shown.number if page is None else str(shown.number).replace(".", ",")
            amount = f"{value} {shown.unit.text}" if shown.unit else str(value)
            asides = [aside if page is None else page.translate(aside) for aside in row.asides]
            text = ", ".join((amount, *asides))
            target = own.targets[answer.name]
            found = own.cases.judged(target, text, ()) or own.texts.judged(target, text)
            assert found.finding.outcome == RIGHT, text


def test_a_number_in_units_of_letters_is_a_number() -> None:
    share = number(SLEDGE, "a") / 9.8  # nothing of this scene is in proportion to it
    for text in ("{:.4f} g", "{:.3f}·g", "({:.4f}) g", "g · {:.4f}", "g*{:.4f}"):
        assert (
            part(
                SLEDGE, "a", text.format(judge(SLEDGE).letters.numbers["a"] / judge(SLEDGE).letters.numbers["g"])
            ).verdict.outcome
            == RIGHT
        ), text
    assert part(SLEDGE, "a", f"{share * 1.1:.4f} g").verdict.outcome == WRONG
    assert "dimension" not in kinds(part(SLEDGE, "a", "0.123 g"))


@pytest.mark.parametrize(
    "way", ["{} ± {} m/s²", "({} ± {}) m/s²", "{} m/s² ± {} m/s²", "{} m/s² +/- {}", r"{} \pm {} m/s²"]
)
def test_an_uncertainty_is_read_and_said(way: str) -> None:
    small, large = (part(DISC, "a", way.format("4.36", width)) for width in ("0.02", "2"))
    assert small.verdict.outcome == RIGHT and small.marks == small.of and "uncertainty" in kinds(small)
    assert 0 < large.marks < large.of and "uncertainty" in kinds(large)
    assert part(DISC, "a", way.format("5.36", "2")).marks == 0


def test_an_uncertainty_may_be_a_share() -> None:
    assert part(DISC, "a", "4.36 m/s² ± 0.5 %").marks == 1
    assert 0 < part(DISC, "a", r"4.36 m/s² ± 5 \%").marks < 1


@pytest.mark.parametrize(
    ("name", "text", "marks"), [("T", "11 N", "3/4"), ("alpha", "20 rad/s²", "0"), ("alpha", "22 rad/s²", "3/4")]
)
def test_figures_of_block_on_disc(name: str, text: str, marks: str) -> None:
    assert str(part(DISC, name, text).marks) == marks


@pytest.mark.parametrize(
    ("wanted", "text", "figures"),
    [
        ("39.52", "40", 2),
        ("10.29", "10", 2),
        ("144.8", "100", 0),
        ("1234", "1200", 2),
        ("1200.4", "1200", 4),
        ("44.9", "40", 0),
    ],
)
def test_zeros_at_the_end_count_where_that_helps(wanted: str, text: str, figures: int) -> None:
    (reading,) = read_line(text, Names.of(()))
    assert figures_that_hold(typed_in(reading), evaluate(Number(Fraction(wanted)), {})) == figures
    (sure,) = read_line(f"{int(text)}.", Names.of(()))  # all of them count
    assert figures_that_hold(typed_in(sure), evaluate(Number(Fraction(wanted)), {})) in (0, len(text))


def test_a_word_for_the_level_is_no_other_way() -> None:
    value = f"{number(SLOPE, 'a'):.4g} m/s²"
    for words, outcome in (
        ("to the right", RIGHT),
        ("down the slope", RIGHT),
        ("down and to the right", RIGHT),
        ("to the left", WRONG),
        ("up the slope", WRONG),
        ("up and to the left", WRONG),
    ):
        assert part(SLOPE, "a", f"{value} {words}").verdict.outcome == outcome, words


def test_a_size_with_another_direction_is_marked_as_a_sign_is() -> None:
    value = f"{number(SLEDGE, 'alpha'):.4g} rad/s²"
    assert part(SLEDGE, "alpha", f"{value} clockwise").verdict.outcome == RIGHT
    strict = part(SLEDGE, "alpha", f"{value} anticlockwise")
    assert strict.verdict.outcome == WRONG and "direction" in kinds(strict)
    lenient = part(f"{SLEDGE}marking: {{alpha: {{sign: lenient}}}}\n", "alpha", f"{value} anticlockwise")
    assert lenient.verdict.outcome == RIGHT and "direction" in kinds(lenient)


@pytest.mark.parametrize("text", ["m (9.8 − a)", "m (9.81 - a)", "2 (9.8 - a)"])
def test_a_number_that_stands_for_a_letter_needs_no_unit(text: str) -> None:
    found = part(DISC, "T", text)
    assert found.verdict.outcome == RIGHT and found.marks == found.of and "numbers" in kinds(found)


@pytest.mark.parametrize(
    ("text", "outcome"),
    [
        ("4.356x10^0 m/s²", RIGHT),
        ("0.4356x10¹ m/s²", RIGHT),
        ("43.56x10^-1 m/s²", RIGHT),
        ("4 356 mm/s²", RIGHT),
        ("4 356 mm/s²", RIGHT),
        ("4.36 m/s² (acceleration)", RIGHT),
        ("4.36 m/s² (constant)", RIGHT),
        ("4.36 m/s² (not sure)", UNDECIDED),
        ("5 356 mm/s²", WRONG),
    ],
)
def test_ordinary_numbers(text: str, outcome: str) -> None:
    assert part(DISC, "a", text).verdict.outcome == outcome


def test_j_is_no_joule_but_nearly() -> None:
    found = part("angular-momentum/coin-on-a-turntable", "f0", "14.7 j")
    assert found.verdict.outcome == UNDECIDED and "`J`" in str(found.verdict.remarks[0].words)
