"""Choices: which option is the largest, exceeds a bound or holds, with its reason, and what can not be decided."""

from __future__ import annotations

import re

import pytest

from rotsolve.algebra.notation.text import to_text
from rotsolve.confirm.course.samples import holds, with_givens
from rotsolve.core.faults import SceneError
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

SCENE = """
title: Ball and ring on a slope
given: {M: 2 kg, r: 10 cm, d: 3 m, beta: 30 deg, n: number, k: 3}
surfaces: {ramp: {slope: beta, down: right}}
bodies:
  ball: {shape: sphere, mass: M, radius: r, moves: down}
  ring: {shape: ring, mass: M, radius: r, moves: down}
connections: {one: {rolls: [ball, ramp]}, two: {rolls: [ring, ramp]}}
find:
  a: ball.acceleration
  pick: CHOICE
"""


def chosen(choice: str) -> Solution:
    return solve(SCENE.replace("CHOICE", choice))


@pytest.mark.parametrize(
    ("choice", "word"),
    [
        ("{which of: {ball: ball.acceleration, ring: ring.acceleration}, is: largest}", "ball"),
        ("{which of: {ball: ball.acceleration, ring: ring.acceleration}, is: smallest}", "ring"),
        ("{which of: {ball: a, ring: ring.acceleration}, is: above 3 m/s^2}", "ball"),
        ("{which of: {ball: a, ring: ring.acceleration}, is: above 2 m/s^2}", "ball, ring"),
        ("{which of: {ball: a, ring: ring.acceleration}, is: below 2 m/s^2}", "none"),
        ("{which of: {ball: ball.acceleration/10, ring: ring.acceleration/7, none of them: g/28}, is: largest}",
         "ball, ring, none of them"),
        ("{which of: {slow: ring.acceleration < a < 3 m/s^2, faster than the ring: ring.acceleration < a <= g/2}}",
         "faster than the ring"),
        ("{which of: {equal: 7*a = 5*g*sin(beta), above: 7*a > 5*g*sin(beta), at least: 7*a >= 5*g*sin(beta)}}",
         "equal, at least"),
        ("{which of: {steep: beta > 45 deg, flat: beta ≤ 45 deg}}", "flat"),
        ("{which of: {right: k == 3, wrong: k < 3}}", "right"),
        ("{which of: {half: 2*n*g, whole: 3*n*g}, is: largest}", "whole"),
    ],
)  # fmt: skip
def test_the_option_that_holds(choice: str, word: str) -> None:
    solution = chosen(choice)
    answer = solution.answers["pick"]
    assert answer.word == word
    assert ("n > 0" in solution.to("text")) == ("n*g" in choice)  # n might be negative: what is supposed of it is told
    assert answer.formula is None and answer.value is None


def test_letters_that_are_positive_are_compared_exactly() -> None:
    scene = SCENE.replace("M: 2 kg", "M: kg").replace("d: 3 m,", "d: 3 m, q: kg,")
    solution = solve(scene.replace("CHOICE", "{which of: {one: M*g, two: 2*M*g}, is: largest}"))
    assert solution.answers["pick"].word == "two"


def test_the_reason_is_told() -> None:
    text = chosen("{which of: {ball: a, ring: ring.acceleration}, is: above 3 m/s^2}").to("text")
    assert "pick: ball (ball: 3.5 m/s² > 3 m/s²; ring: 2.45 m/s² ≤ 3 m/s²)" in text
    lines = [" ".join(line.split()) for line in text.splitlines()]
    assert "ball: a > x (3.5 m/s² > 3 m/s²)" in lines
    assert "x = 3 m/s²" in lines[2]


def test_of_a_chain_that_fails_the_failing_comparison_is_told() -> None:
    answer = chosen("{which of: {low: 1 < k < 2, high: 2 < k < 4}}").answers["pick"]
    assert str(answer) == "pick: high (high: 2 < 3, 3 < 4; low: 3 ≥ 2)"


def test_a_quantity_asked_before_is_not_worked_out_again() -> None:
    solution = chosen("{which of: {ball: ball.acceleration, ring: ring.acceleration}, is: largest}")
    used = [law.law for section in solution.steps for law in section.laws]
    assert used.count("Newton's second law, ball, along the slope") <= 1


def test_what_a_choice_compares_may_fail_by_name() -> None:
    solution = solve(
        SCENE.replace("find:", "states: {top: at rest, foot: {ball.displacement: d}}\nfind:").replace(
            "CHOICE", "{which of: {a: ball.velocity, b: ring.velocity}, is: largest}"
        )
    )
    assert any("is not the same at all states" in refusal.fault.message for refusal in solution.derivation.refused)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("label", ["nil", "not at all", "'not moving'"])
@pytest.mark.parametrize("zero", ["0", "0 m/s^2", "0 km/h^2", "-0 m/s^2"])
@pytest.mark.parametrize("compared", ["a > {zero}", "{zero} < ring.acceleration", "a/2 >= {zero}"])
def test_zero_is_of_every_kind_or_of_that_of_its_unit(label: str, zero: str, compared: str) -> None:
    option = compared.format(zero=zero)
    assert chosen(f"{{which of: {{{label}: {option}, other: a < 0 m/s^2}}}}").answers["pick"].word == label.strip("'")
    assert (
        chosen("{which of: {one: a, two: ring.acceleration}, is: above ZERO}".replace("ZERO", zero))
        .answers["pick"]
        .word
    )


@pytest.mark.parametrize("label", ["nil", "not at all"])
@pytest.mark.parametrize(
    ("compared", "kinds"),
    [
        ("a > 0 m/s", "an acceleration (m/s²), but `0 m/s` is a velocity (m/s)"),
        ("a = 5", "an acceleration (m/s²), but `5` is a pure number"),
        ("a = 5 kg", "an acceleration (m/s²), but `5 kg` is a mass (kg)"),
    ],
)
def test_what_is_of_another_kind_is_refused_whatever_the_label(label: str, compared: str, kinds: str) -> None:
    with pytest.raises(SceneError, match=re.escape(kinds)):
        chosen(f"{{which of: {{{label}: {compared}, other: a < 0 m/s^2}}}}")


def test_in_letters_the_values_beside_a_choice_are_those_of_its_own_case() -> None:
    """A ball is faster than a block that slides, and than one that rests: what is told of the block differs."""
    solution = solve("""
title: Ball and block on a slope
given: {beta: rad, mu: number}
surfaces: {ramp: {slope: beta, down: right}}
bodies: {ball: {shape: sphere, moves: down}, block: {mass: 1 kg, moves: down}}
connections: {one: {rolls: [ball, ramp]}, two: {contact: [block, ramp], friction: mu}}
find: {fast: {which of: {ball: ball.acceleration, block: block.acceleration}, is: largest}}
""")
    (found,) = solution.derivation.answers
    cases = (found, *found.otherwise)
    for mu, word, moves in ((0.1, "block", True), (0.4, "ball", True), (0.8, "ball", False)):
        numbers = with_givens(solution.problem, {"beta": 0.6, "mu": mu})
        (own,) = [case for case in cases if all(holds(one, numbers) for one in case.conditions)]
        assert own.word == word
        told = "".join(part if isinstance(part, str) else to_text(part) for part in own.remark)
        assert ("0 m/s²" in told) != moves, told
