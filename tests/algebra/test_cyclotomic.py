"""Sums of sines and cosines of parts of a turn that are nothing, and others that are nearly so."""

from __future__ import annotations

from fractions import Fraction

import pytest

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.exact.cyclotomic import vanishes_by_turns
from rotsolve.algebra.formula import ONE, PI, Formula, Number, call


def cos(degrees: int | str) -> Formula:
    return call("cos", PI * Number(Fraction(degrees) / 180))


def sin(degrees: int | str) -> Formula:
    return call("sin", PI * Number(Fraction(degrees) / 180))


NOTHING = {
    "three at 120°": cos("7.3") + cos("127.3") + cos("247.3"),
    "sines times cosines": sin(10) * cos(10) + sin(70) * cos(70) + sin(130) * cos(130),
    "of one angle alone": 1 - 6 * sin(10) + 8 * sin(10) ** 3,
    "a product": cos(20) * cos(40) * cos(80) - ONE / 8,
    "of a pentagon": cos(36) - cos(72) - ONE / 2,
    "a fraction": ONE / (cos(10) - 2) + ONE / (2 - sin(80)),
    "times what is no such number": PI * (cos(40) + cos(160) + cos(280)),
}
OTHERS = {
    "another factor": cos(20) * cos(40) * cos(80) - ONE / 7,
    "an angle a little off": cos(40) + cos(160) + cos("280.1"),
    "another sign": cos(40) + cos(160) - cos(280),
    "one alone": cos(20),
    "over nothing": (cos(40) + cos(160) + cos(280)) / (cos(36) - cos(72) - ONE / 2),
}


@pytest.mark.parametrize("case", NOTHING)
def test_what_is_nothing_is_so_exactly(case: str) -> None:
    assert vanishes_by_turns(NOTHING[case])
    assert evaluate(NOTHING[case], {}).sign == 0


@pytest.mark.parametrize("case", OTHERS)
def test_what_is_not_is_not_taken_for_it(case: str) -> None:
    assert not vanishes_by_turns(OTHERS[case])


def test_an_angle_beyond_all_fine_parts_of_a_turn_is_not_decided() -> None:
    value = cos("40.00001") + cos("160.00001") + cos("280.00001")
    assert evaluate(value, {}).sign is None
