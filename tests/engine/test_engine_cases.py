"""Letters case by case: what numbers would decide is told with its conditions, and each case is what the scene says with its numbers."""

from __future__ import annotations

import json
from collections.abc import Mapping

import pytest

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve
from rotsolve.solution.answer import AnswerView

SLEDGE = """
given: {m: kg, P: N, mu: number, t1: s}
surfaces: {snow: level}
bodies: {sledge: {mass: m, moves: right}}
connections: {runners: {contact: [sledge, snow], friction: mu}}
actions: {rope: {force: P, on: sledge, direction: right}}
states: {start: at rest, end: {time: t1}}
find: {v: sledge.velocity at end}
"""
HELD = """
given: {m: kg, M: kg, mu: number}
surfaces: {table: level}
bodies: {box: {mass: M, moves: right}, load: {mass: m, moves: down}, pulley: {mass: 0, radius: 10 cm, turns: clockwise}}
connections: {under: {contact: [box, table], friction: mu}, string: {string: [box, pulley, load]}, axle: {axle: pulley}}
find: {a: load.acceleration, T: string.load.tension}
"""
SLOPE = """
given: {m: kg, R: m, theta: rad, mu: number}
surfaces: {ramp: {slope: theta, down: right}}
bodies: {ball: {shape: sphere, mass: m, radius: R, moves: down}}
connections: {touch: {contact: [ball, ramp], friction: mu}}
find: {a: ball.acceleration, alpha: ball.angular_acceleration}
"""
ATWOOD = """
given: {m1: kg, m2: kg, h: m}
bodies: {one: {mass: m1, moves: down}, two: {mass: m2, moves: up}, wheel: {radius: 0.1 m, mass: 0, turns: clockwise}}
connections: {rope: {string: [two, wheel, one]}, axle: {axle: wheel}}
states: {start: at rest, low: {one.displacement: h}}
find: {v: one.velocity at low}
"""


def told(answer: AnswerView) -> list[tuple[str | None, tuple[str, ...]]]:
    return [(case.exact, case.conditions) for case in answer.branches]


@pytest.mark.parametrize(
    ("text", "name", "cases"),
    [
        (SLEDGE, "v", {("0", ("P ≤ μ m g",)), ("t₁ (P − μ m g)/m", ("P > μ m g",))}),
        (HELD, "a", {("0", ("m ≤ μ M",)), ("g (m − μ M)/(m + M)", ("m > μ M",))}),
        (HELD, "T", {("m g", ("m ≤ μ M",)), ("m M g (1 + μ)/(m + M)", ("m > μ M",))}),
        (SLOPE, "a", {("5 g sin θ/7", ("μ ≥ 2 tan θ/7",)), ("g (sin θ − μ cos θ)", ("μ < 2 tan θ/7",))}),
    ],
)
def test_both_cases_are_told_with_their_conditions(
    text: str, name: str, cases: set[tuple[str, tuple[str, ...]]]
) -> None:
    assert set(told(solve(text).answers[name])) == cases


@pytest.mark.parametrize(
    ("text", "sets"),
    [
        (SLEDGE, [{"m": "2 kg", "P": p, "mu": "0.4", "t1": "3 s"} for p in ("5 N", "7.8 N", "7.9 N", "40 N")]),
        (HELD, [{"m": "1 kg", "M": "2 kg", "mu": mu} for mu in ("0.2", "0.49", "0.51", "0.9")]),
        (SLOPE, [{"m": "1 kg", "R": "0.2 m", "theta": t, "mu": "0.2"} for t in ("10 deg", "34 deg", "36 deg", "80 deg")]),
    ],
)  # fmt: skip
def test_letters_then_numbers_are_numbers_from_the_start(text: str, sets: list[dict[str, str]]) -> None:
    lettered = solve(text)
    for settings in sets:
        numbered = solve(text, settings=settings)
        values = numbered.problem.values
        for name, view in numbered.answers.items():
            assert value_at(lettered.answers[name], values) == pytest.approx(view.float)


def value_at(answer: AnswerView, values: Mapping[str, object]) -> float:
    """What an answer in letters says at some numbers: by the one case whose conditions hold."""
    fitting = [case for case in answer.branches if all(holds(one, values) for one in case.answer.conditions)]
    assert len(fitting) == 1
    closed = fitting[0].answer.closed
    assert closed is not None
    return evaluate(closed, values).float


def holds(condition: object, values: Mapping[str, object]) -> bool:
    gap = evaluate(condition.left - condition.right, values).float
    return {">": gap > 0, "<": gap < 0, "≥": gap >= 0, "≤": gap <= 0}[condition.relation]


def test_a_case_without_an_answer_says_why() -> None:
    """The lighter load does not sink: there is no speed, and the page says for which letters."""
    solution = solve(ATWOOD)
    assert told(solution.answers["v"]) == [("√(2 g h (m₁ − m₂)/(m₁ + m₂))", ("m₁ > m₂",))]
    assert "if m₁ ≤ m₂ there is no answer" in solution.to("text")


def test_a_refusal_that_holds_for_all_letters_is_one() -> None:
    with pytest.raises(Unsolvable):
        solve(ATWOOD.replace("mass: m1", "mass: m2/2"))


def test_conditions_are_data() -> None:
    answer = json.loads(solve(SLEDGE).to("json"))["answers"][0]
    assert answer["conditions"] == [{"text": "P ≤ μ m g", "left": "P", "relation": "≤", "right": "mu*m*g"}]
    assert [case["conditions"][0]["relation"] for case in answer["otherwise"]] == [">"]


def test_what_is_supposed_of_letters_is_told() -> None:
    """Of P and of the angle nothing but the question says that they are positive; of a mass its kind does."""
    assert "P > 0" in solve(SLEDGE).to("text")
    assert "> 0" not in solve(ATWOOD).to("text").partition("Answers")[0].partition("Find")[0]


def test_many_sets_are_each_answered_by_their_case() -> None:
    forces = [5.0, 7.8, 7.9, 40.0]
    many = solve(SLEDGE).evaluate_many({"m": 2.0, "P": forces, "mu": 0.4, "t1": 3.0})["v"]
    again = [solve(SLEDGE, settings={"m": "2 kg", "P": f"{p} N", "mu": "0.4", "t1": "3 s"}) for p in forces]
    assert many == pytest.approx([one.answers["v"].float for one in again])
