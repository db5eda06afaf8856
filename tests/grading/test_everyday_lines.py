"""Everyday notation and words: percent, ratios, siunitx, German, directions, conditions, choices, several statements in a line.

What is right in plain notation is right in these, and what is wrong is wrong."""

from __future__ import annotations

import time
from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest

from rotsolve.algebra.units.dimension import NONE
from rotsolve.grading.comparing.signs import OPPOSITE, plain_directions
from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.reading.choices import options_named
from rotsolve.grading.reading.everyday import everyday, without_head
from rotsolve.grading.verdict import PARTLY, RIGHT, UNDECIDED, WRONG, JudgedPart, Paper
from rotsolve.pipeline import solve
from solutions import solved

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
FILES = sorted(PROBLEMS.glob("*/*.yaml"))
BALL, ICE, LOOP = "rolling/ball-on-incline", "angular-momentum/bullet-on-ice", "rolling/loop-the-loop"
BOWLING, SPUN = "rolling/bowling-ball", "rolling/ball-with-back-spin"
TORQUE, PAIR, FALLING = "space/torque-of-a-force", "kinematics/which-pair-of-angles", "pulleys/block-on-disc-falling"


@cache
def judge(problem: str) -> Judge:
    return Judge(solve(PROBLEMS / f"{problem}.yaml"))


def part(by: Judge, name: str, text: str) -> JudgedPart:
    return next(one for one in by.mark(Paper("one", {name: text})).parts if one.name == name)


@pytest.mark.parametrize(
    ("problem", "name", "text", "outcome"),
    [
        (BALL, "a", r"\SI{2.96}{m/s^2}", RIGHT),
        (BALL, "a", r"\SI{2.96}{\metre\per\second\squared}", RIGHT),
        (BALL, "a", r"\qty{2.96}{m.s^{-2}}", RIGHT),
        (BALL, "a", r"2.96\,\si{\metre\per\second\squared}", RIGHT),
        (BALL, "a", r"\SI{3.96}{m/s^2}", WRONG),
        (BALL, "a", "⁵⁄₇ g sin θ", RIGHT),
        (BALL, "a", "²⁄₃ g sin θ", WRONG),
        (BALL, "a", "a is approximately equal to 2.96 m/s²", RIGHT),
        (BALL, "a", "the acceleration is about 2.96 m/s²", RIGHT),
        (BALL, "a", "5/7 g sin θ if θ > 0", RIGHT),
        (BALL, "a", "5/7 g sin θ if θ > 0, else 0", RIGHT),
        (BALL, "a", "0 if θ > 0, else 5/7 g sin θ", WRONG),
        (BALL, "a", "5/7 g sin θ if θ < 0; 0 otherwise", WRONG),
        (BALL, "a", "5/7 g sin θ (for a solid sphere)", RIGHT),
        (BALL, "a", "5/7 g sin θ when it rolls", RIGHT),
        (BALL, "a", "2/3 g sin θ when it rolls", WRONG),
        (BALL, "a", "5/7 g sin θ for half of it", UNDECIDED),
        (BALL, "a", "Beschleunigung der Kugel: 2,96 m/s²", RIGHT),
        (BALL, "a", "Beschleunigung der Scheibe: 2,96 m/s²", UNDECIDED),
        (BALL, "a", "2,96 Meter pro Quadratsekunde", RIGHT),
        (BALL, "a", "2,96 m/s² hangabwärts", RIGHT),
        (BALL, "a", "2,96 m/s² hangaufwärts", WRONG),
        (BALL, "a", "2,96 m/s² nach unten", RIGHT),
        (BALL, "a", "a 2.96 m/s²", RIGHT),
        (BALL, "a", "a 2.5 m/s²", WRONG),
        (FALLING, "F", "49 Newton's", RIGHT),
        (FALLING, "F", "49 N nach oben", RIGHT),
        (ICE, "share", "60 percent", RIGHT),
        (ICE, "share", "60 per cent", RIGHT),
        (ICE, "share", "60 Prozent", RIGHT),
        (ICE, "share", "61 percent", WRONG),
        (ICE, "share", "3:5", RIGHT),
        (ICE, "share", "share = 3 : 5", RIGHT),
        (ICE, "share", "3 zu 5", RIGHT),
        (ICE, "share", "√9 : 5", RIGHT),
        (ICE, "share", "5:3", WRONG),
        (ICE, "share", "0.6 lost", RIGHT),
        (ICE, "share", "0.6 gained", UNDECIDED),
        (LOOP, "v", "1.93 m/s to the left", UNDECIDED),
        (BOWLING, "a", "2.06 m/s² backwards", RIGHT),
        (BOWLING, "a", "2.06 m/s² forwards", UNDECIDED),
        (BOWLING, "a", "2.06 m/s² upwards", WRONG),
        (BOWLING, "a", "μ g backwards", RIGHT),
        (SPUN, "v", "1.09 m/s backwards", RIGHT),
        (TORQUE, "tau", "[5 -5 -5] N m", RIGHT),
        (TORQUE, "tau", "(5|-5|-5) Nm", RIGHT),
        (TORQUE, "tau", "(5 | -5 | -5) N m", RIGHT),
        (TORQUE, "tau", "[5 -5 -4] N m", WRONG),
        (TORQUE, "tau", "(5|-5|-4) Nm", WRONG),
        (PAIR, "exceeding", "(c)", RIGHT),
        (PAIR, "exceeding", "Pair c", RIGHT),
        (PAIR, "exceeding", "only c", RIGHT),
        (PAIR, "exceeding", "exceeding = c", RIGHT),
        (PAIR, "exceeding", "disc c", RIGHT),
        (PAIR, "exceeding", "disc b", WRONG),
        (PAIR, "exceeding", "a and c", WRONG),
        (PAIR, "exceeding", "not a", UNDECIDED),
        (PAIR, "exceeding", "b or c", UNDECIDED),
        ("axles/brake-block", "n", "169.9 rad", RIGHT),
        ("axles/brake-block", "n", "9733°", RIGHT),
        ("axles/brake-block", "n", "27.04 rad", WRONG),
        ("hinged/rod-30", "alpha", "α = 3 g cos θ0/(2L) = 12.7 rad/s² (clockwise)", RIGHT),
    ],
)
def test_a_line(problem: str, name: str, text: str, outcome: str) -> None:
    found = part(judge(problem), name, text)
    assert found.verdict.outcome == outcome, found.verdict
    assert not any(remark.kind == "chain" for remark in found.verdict.remarks)


@pytest.mark.parametrize(
    ("line", "outcome"),
    [
        ("Adding: m g = T + m a", RIGHT),
        ("Sum of torques: T R = ½ M R² α", RIGHT),
        ("Newton 2: m g - T = m a", RIGHT),
        ("Sum of torques: T R = M R² α", WRONG),
        ("I = ½MR², ω = v/R", RIGHT),
        ("I = ½MR²; ω = v/R", RIGHT),
        ("I = MR², ω = v/R", WRONG),
        ("I = ½MR², ω = 2v/R", WRONG),
        ("v² = 2 a h → v = √(2ah)", RIGHT),
        ("v² = 2 a h => v = √(2ah)", RIGHT),
        ("v² = 2 a h so v = √(ah)", WRONG),
        ("T = m g - m a = 2*9.8 - 2*4.9 = 9.8 N", RIGHT),
        ("T = m g - m a = 2*9.8 - 2*4.9 = 9.9 N", RIGHT),  # within the tolerance
        ("T = m g - m a = 2*9.8 - 2*3.9 = 11.8 N", WRONG),
        ("m a = m a", UNDECIDED),
    ],
)
def test_a_line_of_working(line: str, outcome: str) -> None:
    (found,) = judge(FALLING).mark(Paper("one", {}, (line,))).lines
    assert found.verdict.outcome == outcome, found.verdict


@pytest.mark.sampled(10)
@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_every_answer_in_other_marks(file: Path) -> None:
    """Of each answer its number by siunitx, in percent, with words behind it, and backwards for what is against the positive direction."""
    by = Judge(solved(file))
    for name, target in by.targets.items():
        asked = target.whole
        if (
            asked is None
            or target.parts
            or asked.value is None
            or not asked.value.sign
            or not -3 < _power(asked.value.float) < 6
        ):
            continue
        number = f"{asked.value.float:.6g}"
        unit = asked.unit.text
        plain = part(by, name, f"{number} {unit}".strip()).verdict.outcome
        assert plain in (RIGHT, PARTLY), (name, number)
        forms = [f"{number} {unit} when it is so".strip()]
        if unit:
            forms.append(rf"\SI{{{number}}}{{{unit}}}")
        if asked.dimension == NONE and not unit and not asked.turns:
            forms += [f"{float(number) * 100:.6g} percent", f"{number} : 1"] if float(number) > 0 else []
        positive = plain_directions(asked.positive)
        other = {OPPOSITE[one] for one in positive & {"left", "right", "clockwise", "counterclockwise"}}
        if other and plain_directions(asked.direction) == other:
            forms.append(f"{number.lstrip('-')} {unit} backwards")
        for form in forms:
            assert part(by, name, form).verdict.outcome == plain, (name, form)


def _power(number: float) -> int:
    return int(f"{number:e}".partition("e")[2])


@pytest.mark.sampled(10)
@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_choices_in_words(file: Path) -> None:
    solution = solved(file)
    if not any(answer.word for answer in solution.derivation.answers):
        return
    by = Judge(solution)
    for name, target in by.targets.items():
        if not target.word:
            continue
        options = set(target.options)
        listed = " and ".join(f"({one})" for one in target.word.split(", "))
        for text in (
            target.word,
            f"only {target.word}",
            f"{name} = {target.word}",
            f"the answer is {target.word}.",
            listed,
        ):
            assert part(by, name, text).verdict.outcome == RIGHT, text
        for other in options - set(target.word.split(", ")):
            assert part(by, name, f"only {other}").verdict.outcome == WRONG
            assert part(by, name, f"not {other}").verdict.outcome == UNDECIDED


def test_options_are_words_of_their_own() -> None:
    assert options_named("a disc", ("disc", "ring")) == {"disc"}
    assert options_named("the a", ("a", "b")) == {"a"}
    assert options_named("discs", ("disc", "ring")) is None
    assert options_named("disc rim", ("disc", "disc rim")) == {"disc rim"}
    assert options_named("maybe", ("a", "b")) is None


@pytest.mark.parametrize(
    "text",
    [
        "⁵⁄₇ g",
        r"\SI{2}{m} + x",
        "60 percent",
        "is approximately equal to 3",
        "2 N nach unten",
        "3 N gegen den Uhrzeigersinn",
    ],
)
def test_columns_stay(text: str) -> None:
    assert len(everyday(text)) == len(text)
    assert len(without_head(f"Sum of it: {text} = 2", frozenset())) == len(text) + 15


def test_long_lines_of_words_take_no_time() -> None:
    start = time.process_time()
    for text in (
        "for " + "a" * 500 + "1",
        "2 for " + "ab- " * 120 + "=",
        "(" * 290 + "5|" * 150,
        "2 :" * 190,
        r"\SI{" * 140,
        "is about " * 60,
    ):
        part(judge(BALL), "a", text)
        part(judge(TORQUE), "tau", text)
        judge(FALLING).mark(Paper("one", {}, (text, f"{text} = 2")))
    assert time.process_time() - start < 10


def test_turns_of_an_angle_are_said() -> None:
    found = part(judge("axles/brake-block"), "n", "169.9 rad")
    assert found.marks == Fraction(found.of) and any("turns" in str(remark.words) for remark in found.verdict.remarks)
