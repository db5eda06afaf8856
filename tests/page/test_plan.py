"""The plan of a page: which law is named, and what it is said to give."""

from __future__ import annotations

from pathlib import Path

import pytest

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.derivation import Cited, Equality, LawLine, Move, Section
from rotsolve.core.equation import DEFINITION, SECOND_LAW
from rotsolve.page.backing import Backing
from rotsolve.page.plan import is_principle, plan_of
from rotsolve.page.text import plain_text
from rotsolve.pipeline import solve

ROOT = Path(__file__).resolve().parents[2]
A, B, C, D = map(Symbol, "abcd")


def plan(problem: str) -> str:
    return " ".join(plain_text(sentence) for sentence in plan_of(solve(ROOT / f"problems/{problem}.yaml").derivation))


def law(number: int, left: Formula, right: Formula, *, newton: bool) -> LawLine:
    kind = SECOND_LAW if newton else DEFINITION
    return LawLine(number, kind.name, Equality(left, right), name=kind.name, family=kind.family)


def test_an_answer_rests_on_a_law_by_all_the_steps_that_lead_to_it() -> None:
    laws = (law(1, A * B, C, newton=True), law(2, D, A + B, newton=False), law(3, B, C, newton=False))
    moves = (
        Move("", (Equality(B, C),), 4, into="(3)"),
        Move("", (Equality(A, C / B),), 5, put=(Cited(B, "(4)"),), into="(1)"),
        Move("", (Equality(D, A + C),), put=(Cited(A),), into="(2)"),
    )
    backing = Backing(Section("", laws=laws, moves=moves), is_principle)
    assert backing.rests(A) and backing.rests(D)
    assert not backing.rests(B) and not backing.rests(Symbol("x"))


def test_what_a_stage_gives_is_what_rests_on_its_laws() -> None:
    assert "2. Later: Newton's second law for top; this gives N." in plan("space/gyroscope-in-time")
    assert "work and energy; this gives ω₁." in plan("varying-forces/torque-growing-with-angle")


@pytest.mark.parametrize(
    ("problem", "turning"),
    [("space/ball-on-a-turntable", False), ("space/leaning-top", True), ("space/wheel-let-go", False)],
)
def test_axes_that_turn_are_named_where_there_are_some(problem: str, turning: bool) -> None:
    assert ("in axes that turn, τ = dL/dt + Ω × L" in plan(problem)) == turning
    assert ("the rate of the angular momentum, τ = dL/dt, for" in plan(problem).replace("The", "the")) != turning
