"""Constants such as sin 25° are written as they are; what is nothing by their relations is still seen to be nothing."""

from __future__ import annotations

import pytest

from rotsolve.algebra.exact.normal import equal, is_zero, simplify
from rotsolve.algebra.formula import Symbol, call, sqrt
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.notation.text import to_text


@pytest.mark.parametrize(
    ("written", "shown"),
    [
        ("a*sin(25*pi/180) + b*sin(35*pi/180)", ("sin 25°", "sin 35°")),
        ("a*cos(115*pi/180) + b*cos(235*pi/180)", ("sin 25°", "sin 35°")),
    ],
)
def test_constants_stay_as_they_are(written: str, shown: tuple[str, ...]) -> None:
    text = to_text(simplify(parse(written), order=("a", "b")))
    assert all(part in text for part in shown), text
    assert "5°" not in text.replace("25°", "").replace("35°", "")


@pytest.mark.parametrize(
    "nothing",
    [
        "cos(40*pi/180) - 1 + 2*sin(20*pi/180)^2",
        "sin(35*pi/180) - sin(25*pi/180)*cos(10*pi/180) - cos(25*pi/180)*sin(10*pi/180)",
        "cos(115*pi/180) + sin(25*pi/180)",
    ],
)
def test_what_vanishes_by_their_relations_does(nothing: str) -> None:
    assert is_zero(parse(nothing))


def test_a_root_is_one_whatever_the_order_of_its_letters() -> None:
    a, b, c, t, w = map(Symbol, "abctw")
    one, two = sqrt((a - c) * (b - c) / (a * b)), sqrt((b - c) * (a - c) / (b * a))
    positive = frozenset("abctw")
    assert equal(one, two, positive)
    swing = 2 * w * call("exp", t * w * one) / (1 + call("exp", 2 * t * two * w))
    assert equal(swing, 2 * w * call("exp", t * two * w) / (1 + call("exp", 2 * w * t * one)), positive)
    assert not equal(one, sqrt((a - c) * (b + c) / (a * b)), positive)
