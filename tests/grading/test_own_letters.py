"""Letters as a student defines them: what is said of a letter of the scene counts in the answer in which it is said, and is never lost."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from rotsolve.algebra.notation.text import to_text
from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.marking.target import Target
from rotsolve.grading.verdict import RIGHT, UNDECIDED, WRONG, Finding, JudgedPart, Marked, Paper
from rotsolve.pipeline import solve

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
DISC, ATWOOD, BALL = "pulleys/block-on-disc", "pulleys/atwood", "rolling/ball-on-incline"
ALL = [path.relative_to(PROBLEMS).with_suffix("").as_posix() for path in sorted(PROBLEMS.rglob("*.yaml"))]
BULLET = """
given: {M: 2 kg, L: 1.2 m, m: 20 g, u: 300 m/s}
bodies:
  rod: {shape: rod, mass: M, length: L}
  bullet: {mass: m, moves: right}
connections: {pin: {hinge: rod.at(L/4)}}
states:
  before: {rod.angle: -90 deg, rod.angular_velocity: 0, bullet.velocity: u}
  after: {}
events: {hit: {joins: [bullet, rod.end], from: before, to: after}}
find: {w: rod.angular_velocity at after}
"""
LONGEST = 120  # characters of a formula that is tried
WHOLE = "7/48 M L² + 9/16 m L²"


@cache
def judge(scene: str) -> Judge:
    return Judge(solve(scene if "\n" in scene else PROBLEMS / f"{scene}.yaml"))


def marked(scene: str, answers: dict[str, str], working: tuple[str, ...] = ()) -> Marked:
    return judge(scene).mark(Paper("one", answers, working))


def part(scene: str, name: str, text: str, working: tuple[str, ...] = ()) -> JudgedPart:
    return next(one for one in marked(scene, {name: text}, working).parts if one.name == name)


def kinds(found: JudgedPart) -> set[str]:
    return {remark.kind for remark in found.verdict.remarks}


WAYS = (  # in which one letter can be defined beside an answer
    "{answer} with {name} = {value}",
    "{answer}, {name} = {value}",
    "{answer}; {name} = {value}",
    "{answer} where {name} = {value}",
    "{answer} ({name} = {value})",
    "{name} = {value}; a = {answer}",
    "{name} = {value}, {answer}",
    "let {name} = {value}, then a = {answer}",
    "{name} = {value} → a = {answer}",
    "{name} = {value} so a = {answer}",
    "a = {answer} for {name} = {value}",
)
FORMULAS = {DISC: "m g/(m + I/R²)", ATWOOD: "(m2 - m1) g/(m1 + m2 + I/R²)", BALL: "g sin θ/(1 + I/(m R²))"}
INERTIAS = {
    DISC: ("½ M R²", "M R²"),
    ATWOOD: ("½ M R²", "M R²"),
    BALL: ("2/5 m R²", "m R²"),
}


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("scene", FORMULAS)
def test_a_moment_of_inertia_is_what_the_student_says(scene: str, way: str) -> None:
    right, wrong = (way.format(answer=FORMULAS[scene], name="I", value=value) for value in INERTIAS[scene])
    assert part(scene, "a", right).verdict.outcome == RIGHT
    found = part(scene, "a", wrong)
    assert found.verdict.outcome == WRONG and not found.marks and "defined" in kinds(found)


@pytest.mark.parametrize("way", WAYS)
def test_a_given_with_another_number_is_judged_with_it(way: str) -> None:
    answer = "2 m g/(2 m + M)"
    same, near, other, none = (
        part(DISC, "a", way.format(answer=answer, name=name, value=value))
        for name, value in (("g", "9.8 m/s²"), ("g", "9.81 m/s²"), ("M", "1 kg"), ("M", "0"))
    )
    assert same.verdict.outcome == RIGHT and "defined" not in kinds(same)
    assert near.verdict.outcome == RIGHT and "defined" in kinds(near)  # 0.1 % is within the tolerance
    for found in (other, none):
        assert found.verdict.outcome == WRONG and not found.marks and "defined" in kinds(found)


def test_another_g_costs_what_it_costs_in_a_number() -> None:
    with_letters = part(DISC, "a", "2 m g/(2 m + M) with g = 10 m/s²")
    with_number = part(DISC, "a", "4.44 m/s² with g = 10 m/s²")
    assert with_letters.marks == with_number.marks < with_letters.of
    assert "defined" in kinds(with_letters) & kinds(with_number)


def test_several_letters_stand_for_each_other() -> None:
    for text, outcome in (
        ("g/(1 + I/k), where k = m R², I = ½ M R²", RIGHT),
        ("g/(1 + I/k) with k = m R² and I = M R²", WRONG),
        ("g/(1 + k) with k = I/(m R²)", RIGHT),
        ("(m g - T)/m where T = m g/2", WRONG),
        ("(m g - T)/m with T = M a/2", RIGHT),  # a law, no definition
        ("m g/(m + I/R²) with I = foo", UNDECIDED),
    ):
        assert part(DISC, "a", text).verdict.outcome == outcome, text


def test_brackets_at_the_end_belong_to_what_is_defined() -> None:
    for value in ("2 (M/2 + m)", "(m + M/2) 2"):
        assert part(DISC, "a", f"2 m g/k with k = {value}").verdict.outcome == RIGHT


def test_i_may_be_that_of_the_whole() -> None:
    formula = "m u (3 L/4)/I"
    assert part(BULLET, "w", f"{formula} with I = {WHOLE}").verdict.outcome == RIGHT
    assert part(BULLET, "w", f"{formula} with I = 7/48 M L²").verdict.outcome == WRONG
    working = (f"I = {WHOLE}", "m u (3 L/4) = I w")
    found = marked(BULLET, {"w": formula}, working)
    assert found.parts[0].verdict.outcome == RIGHT
    assert [line.verdict.outcome for line in found.lines] == [UNDECIDED, RIGHT]


@pytest.mark.parametrize("word", ["", "let ", "with ", "put "])
def test_a_line_of_working_may_define_it(word: str) -> None:
    laws = ("m g - T = m a", "T R = I α")
    right = marked(DISC, {"a": FORMULAS[DISC]}, (f"{word}I = ½ M R²", *laws))
    assert right.parts[0].verdict.outcome == RIGHT and right.lines[0].verdict.outcome == RIGHT
    wrong = marked(DISC, {"a": FORMULAS[DISC]}, (f"{word}I = M R²", *laws))
    assert wrong.parts[0].verdict.outcome == WRONG and wrong.lines[0].first_wrong


@pytest.mark.sampled(4)
@pytest.mark.parametrize("scene", ALL)
def test_the_scenes_own_meanings_change_nothing(scene: str) -> None:
    """An answer in letters stays right with what the scene says of one of its letters, and with a number ten times as large it is not
    right without a word."""
    own = judge(scene)
    for name, target in own.targets.items():
        closed = own.letters.closed.get(name)
        if target.whole is None or closed is None or target.parts or len(to_text(closed)) > LONGEST:
            continue
        plain, numbers = to_text(closed), own.letters.numbers
        held = (one for one in own.letters.problem.givens if one.name in closed.symbols() and numbers.get(one.name))
        given = next(held, None)
        if given is None or found_in(own, target, plain).outcome != RIGHT:
            continue
        assert found_in(own, target, f"{plain} with {given.name} = {given.text}").outcome == RIGHT, (name, given.name)
        other = found_in(own, target, f"{plain} with {given.name} = {10 * numbers[given.name]}")
        assert other.outcome != RIGHT or any(one.kind == "defined" for one in other.remarks), (name, given.name)


def found_in(own: Judge, target: Target, text: str) -> Finding:
    """What is found in a text by itself, without a search for what it comes of."""
    return (own.cases.judged(target, text, ()) or own.texts.judged(target, text)).finding
