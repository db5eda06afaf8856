"""Lines as students write them: prose, statements that lead to the last, near letters, exact values before rounded ones. What is right
in plain notation is right in all of these, and what is wrong is wrong in all of them."""

from __future__ import annotations

import time
from functools import cache
from itertools import product
from pathlib import Path

import pytest

from rotsolve.algebra.effort import Purse
from rotsolve.algebra.notation.parse import parse
from rotsolve.grading.comparing.equality import FreeLetter, Region, SampledRegion
from rotsolve.grading.comparing.here import same_in
from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.mistakes import wrong_answers
from rotsolve.grading.mistakes.wrong_answers import WrongAnswers
from rotsolve.grading.reading.near import near_letters
from rotsolve.grading.verdict import RIGHT, UNDECIDED, WRONG, JudgedPart, Marked, Paper
from rotsolve.pipeline import solve
from rotsolve.scene.read import read_file

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
DISC, FALLING, ROD = "pulleys/block-on-disc", "pulleys/block-on-disc-falling", "hinged/rod-30"
SPEEDUP = "axles/wheel-speedup"


@cache
def judge(problem: str) -> Judge:
    return Judge(solve(PROBLEMS / f"{problem}.yaml"))


def marked(problem: str, answers: dict[str, str], working: tuple[str, ...] = ()) -> Marked:
    return judge(problem).mark(Paper("one", answers, working))


def part(problem: str, name: str, text: str) -> JudgedPart:
    return next(one for one in marked(problem, {name: text}).parts if one.name == name)


def said(found: JudgedPart) -> str:
    """The kinds of what is said."""
    return " ".join(remark.kind for remark in found.verdict.remarks)


# words and statements

ROUND = (  # what may stand round a value
    "{}",
    "a = {}",
    "a is {}",
    "a: {}",
    "∴ a = {}",
    "⇒ {}",
    "Therefore a = {}.",
    "so a = {}",
    "the acceleration is {}",
    "The acceleration of the block is {}.",
    "the acceleration of the block is therefore a = {}",
    "acceleration = {}",
    "we find that a = {}",
    "answer: {}",
    "die Beschleunigung beträgt {}",
    "also a = {}",
    "m g - T = m a, so a = {}",
    "mg − T = ma and T = Ma/2 → a = {}",
    "mg − T = ma; T = Ma/2; therefore the acceleration is a = {}",
    "T = 10.89 N so a = {}",
    "a² = 18.97 m²/s⁴ ⇒ a = {}",
    "a = 2mg/(2m+M) \\Rightarrow a = {}",
    "let k = M/m, then a = {}",
    "{} = a",
)


@pytest.mark.parametrize("words", ROUND)
def test_words_round_a_value_change_nothing(words: str) -> None:
    for value, outcome in (("4.36 m/s²", RIGHT), ("5.12 m/s²", WRONG), ("4.36 m/s", WRONG), ("4.36 kN", WRONG)):
        found = part(DISC, "a", words.format(value))
        assert found.verdict.outcome == outcome, (words, value, found.verdict)


@pytest.mark.parametrize(
    "text",
    [
        "the acceleration is not 4.36 m/s²",
        "the acceleration of the disc is 4.36 m/s²",
        "the tension is 4.36 m/s²",
        "the initial acceleration is 4.36 m/s²",
        "a = 3 m/s² or a = 4.36 m/s²",
        "a = 4.36 m/s² or 5 m/s²",
        "either a = 4.36 m/s²",
        "a is about twice 2.18 m/s²",
        "g is 4.36 m/s²",
        "a = 4.36 m/s² so g = 9.8 m/s²",
        "a ≠ 4.36 m/s²",
        "2 a = 4.36 m/s²",
        "a = 4.36 m/s² is wrong",
        "if a = 4.36 m/s², T = 10.9 N",
    ],
)
def test_other_words_are_not_passed_over(text: str) -> None:
    assert part(DISC, "a", text).verdict.outcome == UNDECIDED


@pytest.mark.parametrize(
    ("name", "text", "outcome", "kinds"),
    [
        ("v", "v² = 2ah = 9.8 → v = 3.13 m/s", RIGHT, ""),
        ("v", "v² = 2 g h so v = √(2 a h) = 3.13 m/s", RIGHT, ""),
        ("v", "v = 2 m/s, so v = 3.13 m/s", RIGHT, "chain"),
        ("v", "v = 3.13 m/s, so v = 2 m/s", WRONG, ""),
        ("v", "m g h = ½ m v² + ½ I ω² ⇒ v = 2√(mgh/(2m+M))", RIGHT, ""),
        ("v", "√(9.8) m/s ≈ 3 m/s", RIGHT, ""),
        ("v", "v = √9.8 ≈ 3.1 m/s", RIGHT, ""),
        ("v", "v = √9.8 ≈ 4.2 m/s", WRONG, "chain"),
        ("v", "v = √8.8 ≈ 3.0 m/s", WRONG, ""),
        ("v", "√9.8 m/s = 3 m/s", WRONG, "chain figures"),  # no ≈
        ("v", "3.130 m/s (4 s.f.)", RIGHT, ""),
        ("v", "3.13 m/s to 3 significant figures", RIGHT, ""),
        ("v", "2.13 m/s (3 s.f.)", WRONG, ""),
    ],
)
def test_the_last_statement_answers(name: str, text: str, outcome: str, kinds: str) -> None:
    found = part(FALLING, name, text)
    assert (found.verdict.outcome, said(found) if outcome == RIGHT else kinds) == (outcome, kinds)


# near letters


def test_a_near_letter_is_that_of_which_there_is_one() -> None:
    near = near_letters({"theta0", "F_low", "omega1", "omega2", "m1", "m2", "v_x", "v_y", "g"}, {"F_x", "alpha"})
    assert near == {
        "theta": "theta0",
        "F": "F_low",
        "Flow": "F_low",
        "w1": "omega1",
        "w2": "omega2",
        "vx": "v_x",
        "vy": "v_y",
    }
    assert near_letters({"theta0"}, {"theta"}) == {}
    assert near_letters({"omega", "omega_end"}) == {
        "w": "omega",
        "w_end": "omega_end",
        "wend": "omega_end",
        "omegaend": "omega_end",
    }


@pytest.mark.parametrize(
    ("name", "text", "outcome"),
    [
        ("alpha", "-3g cos θ/(2L)", RIGHT),
        ("alpha", "-3g \\cos\\theta/(2L)", RIGHT),
        ("alpha", "-3g sin θ/(2L)", WRONG),
        ("alpha", "-3g cos φ/(2L)", UNDECIDED),
        ("F_low", "F = M g (5 + 3 sin θ)/2", RIGHT),
        ("F_low", "F = 23.9 N", RIGHT),
        ("F_low", "F = 17.9 N", WRONG),
        ("F_x", "F = 2.387 N", UNDECIDED),
    ],
)
def test_near_letters_are_told(name: str, text: str, outcome: str) -> None:
    found = part(ROD, name, text)
    assert found.verdict.outcome == outcome
    assert ("letter" in said(found)) == (outcome != UNDECIDED)


def test_a_line_of_working_may_have_near_letters() -> None:
    right, wrong = marked(SPEEDUP, {}, ("alpha = (w2 - w1)/t", "alpha = (w2 + w1)/t")).lines
    assert (right.verdict.outcome, wrong.verdict.outcome) == (RIGHT, WRONG)
    assert [remark.kind for remark in right.verdict.remarks] == ["letter", "letter"]


# proofs

LETTERS = ("x", "y", "m", "M", "k", "n", "t", "v", "R", "theta", "mu")
NUMBERS = {"x": 0.4, "y": 0.3, "theta": 0.7}
EQUAL = """
    x^(n+1) ; x*x^n ; x^n/x^(-1)
    (x*y)^n ; x^n*y^n ; (x/y)^n*y^(2*n)
    (x^2)^n ; x^(2*n) ; (x^n)^2
    4^n ; 2^(2*n) ; 8^n/2^n
    sqrt(x^n) ; x^(n/2)
    (2*m+2*M)^n ; 2^n*(m+M)^n
    exp(n*log(1+x)) ; (1+x)^n
    (m/M)^(k/(k+1)) ; (M/m)^(-k/(k+1))
    log(x^n) ; n*log(x) ; -n*log(1/x)
    m*log((m+M)^2/m^2) ; 2*m*log(1+M/m) ; 2*m*(log(m+M) - log(m))
    exp(-k*t)*exp(k*t/2) ; exp(-k*t/2) ; 1/exp(k*t/2)
    v*exp(-mu*theta) ; v/exp(mu*theta)
    asin(x) ; pi/2 - acos(x) ; atan(x/sqrt(1-x^2))
    atan(x/y) ; pi/2 - atan(y/x)
    R*acos(1-x/2) ; 2*R*asin(sqrt(x)/2)
    sqrt(x)*acos(1-x/2) ; 2*sqrt(x)*asin(sqrt(x)/2)
    2*atan(x) ; asin(2*x/(1+x^2)) ; acos((1-x^2)/(1+x^2))
    acos(1-2*sin(theta/2)^2) ; theta
    tan(asin(x)) ; x/sqrt(1-x^2)
    m*asin(x) + M*acos(x) ; m*asin(x) + M*(pi/2 - asin(x))
"""
ROWS = [[form.strip() for form in line.split(";")] for line in EQUAL.strip().splitlines()]


@cache
def domain() -> SampledRegion:
    names = set(LETTERS)
    letters = tuple(
        FreeLetter(name, NUMBERS.get(name, 1.3 + 0.37 * place), False, True, None) for place, name in enumerate(LETTERS)
    )
    return SampledRegion(Region(letters, {}, frozenset(names), (parse("1-x", names), parse("1-y", names))))


@pytest.mark.parametrize("forms", ROWS, ids=[row[0] for row in ROWS])
def test_equal_forms_are_proved_equal(forms: list[str]) -> None:
    for one, other in product(forms, forms):
        assert same_in(domain(), *(parse(form, set(LETTERS)) for form in (one, other))) is True, (one, other)


def test_forms_of_different_rows_are_not() -> None:
    firsts = [parse(row[0], set(LETTERS)) for row in ROWS]
    for place, one in enumerate(firsts):
        assert not any(same_in(domain(), one, other) for other in firsts[place + 1 :])
    for one, other in (("x^(n+1)", "x^n + x"), ("log(x^n)", "n*log(y)"), ("asin(x)", "acos(x)"), ("4^n", "2^(n+2)")):
        assert same_in(domain(), *(parse(form, set(LETTERS)) for form in (one, other))) is False


EXACT = """
title: A block falls
given: {g: 9.8 m/s^2, h: 1 m}
gravity: g
bodies: {block: {mass: 2 kg, moves: down}}
states: {start: at rest, fallen: {block.displacement: h}}
find: {v: block.velocity at fallen, t: time from start to fallen}
marking: {v: {tolerance: 0 %}, t: {tolerance: 0 %}}
"""


@pytest.mark.parametrize(
    ("name", "text", "outcome"),
    [
        ("v", "√(2·9.8·1) m/s", RIGHT),
        ("v", "√19.6 m/s", RIGHT),
        ("v", "2·√4.9 m/s", RIGHT),
        ("v", "√20.61 m/s", WRONG),
        ("v", "4.527 m/s", WRONG),
        ("v", "√(2 g h)", RIGHT),
        ("t", "√(2/9.8) s", RIGHT),
        ("t", "1000 √(2/9.8) ms", RIGHT),
        ("t", "√(10/49) s", RIGHT),
        ("t", "√(2/9.9) s", WRONG),
    ],
)
def test_identical_forms_are_right_without_tolerance(tmp_path: Path, name: str, text: str, outcome: str) -> None:
    (tmp_path / "fall.yaml").write_text(EXACT, encoding="utf-8")
    marks = Judge(solve(tmp_path / "fall.yaml")).mark(Paper("one", {name: text}))
    assert next(one for one in marks.parts if one.name == name).verdict.outcome == outcome


# length and work


def test_a_line_of_a_million_characters_is_not_looked_at() -> None:
    text = "m g + " * 170_000
    began = time.process_time()
    found = marked(DISC, {"a": text}, (text,))
    assert time.process_time() - began < 0.1
    (answer,) = (one for one in found.parts if one.name == "a")
    assert answer.verdict.outcome == found.lines[0].verdict.outcome == UNDECIDED
    assert "too long" in str(answer.verdict.remarks[0].words)


def mistakes(words: str = "pulleys/atwood") -> list[str]:
    return [mistake.words for mistake, _ in WrongAnswers.of(read_file(PROBLEMS / f"{words}.yaml"))]


def test_the_search_for_mistakes_ends_with_its_work(monkeypatch: pytest.MonkeyPatch) -> None:
    """With less work fewer are found, always the same ones, and the verdict is as it was."""
    whole = mistakes()
    found = {steps: len(set(mistakes_with(steps, monkeypatch))) for steps in (0, 60, 20_000)}
    assert found[0] == 0 < found[60] < found[20_000] == len(whole)
    assert mistakes_with(60, monkeypatch) == mistakes_with(60, monkeypatch)
    assert Purse.left is None
    monkeypatch.setattr(wrong_answers, "STEPS", 0)
    one = Judge(solve(PROBLEMS / "pulleys/atwood.yaml")).mark(Paper("one", {"a": "g (m2 - m1)/(m1 + m2)"})).parts[0]
    assert (one.verdict.outcome, one.verdict.remarks) == (WRONG, ())


def mistakes_with(steps: int, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    with monkeypatch.context() as patched:
        patched.setattr(wrong_answers, "STEPS", steps)
        return mistakes()


def test_no_more_than_so_many_mistakes_are_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(wrong_answers, "MOST_TRIED", 3)
    assert 0 < len(mistakes()) <= 3


WORDS = ("{}", "{} = {}", "so {} = {}", "we get {} = {}", "x y = 3 so {} = {}", "{} is {}", "∴ {} = {}")


@pytest.mark.sampled(4)
@pytest.mark.parametrize("file", sorted(PROBLEMS.glob("*/*.yaml"))[3::40], ids=lambda file: file.stem)
def test_words_change_no_verdict_in_any_scene(file: Path) -> None:
    """What is right by itself is right within words, and what is not is not."""
    solution = solve(file)
    own = Judge(solution)
    for answer in solution.derivation.answers:
        if answer.value is None or answer.components or answer.word or not answer.value.float:
            continue
        unit = "" if answer.unit is None else answer.unit.text
        for factor in (1, 1.7):
            value = f"{factor * answer.value.float:.6g} {unit}".strip()
            texts = [words.format(*([answer.name] if words.count("{}") > 1 else []), value) for words in WORDS]
            found = [
                next(one for one in own.mark(Paper("one", {answer.name: text})).parts if one.name == answer.name)
                for text in texts
            ]
            assert {one.verdict.outcome for one in found} == {found[0].verdict.outcome}, texts
            assert factor == 1 or found[0].verdict.outcome != RIGHT, texts
