"""A law from outside: I α = τ where one couple alone turns a body, by a record, a function and a row in LAWS."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from rotsolve.core.equation import ANGULAR_MOMENTUM, ENERGY, NEWTON, Equation, Law
from rotsolve.core.facts import signed
from rotsolve.laws import newton, table
from rotsolve.laws.table import STATE, AtMoment, Principle
from rotsolve.pipeline import solve

SCENE = """
title: A wheel and its motor
given: {m: 2 kg, R: 0.1 m, tau: 3 N m}
bodies: {wheel: {shape: disc, mass: m, radius: R}}
connections: {axle: {axle: wheel}}
actions: {motor: {couple: tau, on: wheel}}
find: {alpha: wheel.angular_acceleration}
"""


def declare(monkeypatch: pytest.MonkeyPatch, family: str, share: int = 1) -> None:
    """Put the law into the table, as one of a family; `share` 2 makes it wrong."""
    spin_up = Law("spin up", "one couple alone turns {body}", family, 1)

    def written(at: AtMoment) -> Iterator[Equation]:
        for body in at.facts.bodies:
            if body.motion.kind == "axis" and body.inertia is not None and len(body.couples) == 1:
                rate = share * body.inertia.letter * signed(body.motion.spin_rate, body.motion.sense)
                torque = signed(body.couples[0].torque, body.motion.sense)
                yield spin_up.equation(rate, torque, at.section, (body.name,))

    monkeypatch.setattr(table, "LAWS", (*table.LAWS, Principle((spin_up,), (STATE,), written)))


def test_it_is_chosen_for_its_cost(monkeypatch: pytest.MonkeyPatch) -> None:
    declare(monkeypatch, NEWTON)
    solution = solve(SCENE)
    assert "one couple alone turns wheel     I α = τ" in str(solution)
    assert solution.answers["alpha"].exact == "2 τ/(m R²)"


@pytest.mark.parametrize("place", [0, None], ids=["in front", "behind"])
def test_of_two_laws_that_write_the_same_the_cheaper_one_is_told(
    monkeypatch: pytest.MonkeyPatch, place: int | None
) -> None:
    """Wherever it stands in the table: here the law for rotation, τ = I α, under another name."""
    cheap, dear = (Law(words, f"{words}, {{body}}", NEWTON, cost) for words, cost in (("cheap", 1), ("dear", 4)))

    def written(law: Law) -> Principle:
        def equations(at: AtMoment) -> Iterator[Equation]:
            for equation in newton.law_of_rotation(at):
                yield law.equation(equation.left, equation.right, equation.section, equation.bodies)

        return Principle((law,), (STATE,), equations)

    rows = (*table.LAWS[:place], written(cheap), written(dear), *(table.LAWS if place == 0 else ()))
    monkeypatch.setattr(table, "LAWS", rows)
    assert "cheap, wheel" in str(solve(SCENE))


def test_it_serves_its_family_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    declare(monkeypatch, ANGULAR_MOMENTUM)
    assert "one couple alone turns wheel" in str(solve(SCENE, law="angular-momentum"))
    assert "one couple alone turns wheel" not in str(solve(SCENE, law="energy"))


def test_a_law_that_is_wrong_is_found_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every equation of the scene is held against the answers, whoever wrote it."""
    declare(monkeypatch, ENERGY, share=2)
    with pytest.raises(Exception, match="contradict"):
        solve(SCENE)
