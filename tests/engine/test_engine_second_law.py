"""A second law is an objection only where it gives another value: two forms of one angle are compared by numbers, also of letters."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import PI, Formula, Number
from rotsolve.derivation import second_law
from rotsolve.pipeline import solve
from rotsolve.search.answers import Answered
from rotsolve.search.search import Search

RODS = """
title: Two rods in one, let go
given: {M: kg, L: m, m: kg}
bodies: {a: {shape: rod, mass: M, length: L}, b: {shape: rod, mass: m, length: L}}
connections: {pin: {hinge: a.start}, joint: {weld: [a.start, b.start]}}
states: {s: {a.angle: -90 deg, b.angle: ANGLE deg, at rest: all}, low: {a.angle: WORD}}
find: {th: a.angle at low}
"""
LEANING = [(0, "smallest"), (180, "largest"), (120, "largest")]  # at 60° its conditions are too long in letters
SIZES = {"M": 2.0, "m": 0.7, "L": 1.3, "g": 9.8}


def objections(text: str) -> list[str]:
    return [str(check.words) for check in solve(text, confirm=False).derivation.checks if check.holds is False]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("angle", "word"), LEANING)
def test_two_forms_of_one_angle_are_no_objection(angle: int, word: str) -> None:
    """It comes as high on the other side of the lowest place of its centre of mass, towards which the second rod turns it."""
    text = RODS.replace("ANGLE", str(angle)).replace("WORD", word)
    assert not objections(text)
    apart = math.radians(angle + 90)
    x, y = (SIZES["M"] * f(0) + SIZES["m"] * f(apart) for f in (math.cos, math.sin))
    lowest = -math.pi / 2 - math.atan2(y, x)
    expected = 2 * lowest + math.pi / 2
    found = solve(text, confirm=False).answers["th"].formula
    assert found is not None
    values = {name: Number(Fraction(str(size))) for name, size in SIZES.items()}
    assert math.remainder(evaluate(found, values).float - expected, 2 * math.pi) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("given", ["M: kg, L: m, m: kg", "M: 2 kg, L: 1 m, m: 0.7 kg", "M: 2 kg, L: 1 m, m: kg"])
@pytest.mark.parametrize("off", [PI * 2, Number(Fraction(1, 1000))])
def test_another_value_is_one(monkeypatch: pytest.MonkeyPatch, given: str, off: Formula) -> None:
    """A full turn is one too: angles are not wrapped."""
    text = RODS.replace("ANGLE", "0").replace("WORD", "smallest").replace("M: kg, L: m, m: kg", given)
    again = second_law.again

    def wrong(other: Search, answered: Answered) -> Formula | None:
        found = again(other, answered)
        return None if found is None else found + off

    assert not objections(text)
    monkeypatch.setattr(second_law, "again", wrong)
    assert any("gives another" in words for words in objections(text))
