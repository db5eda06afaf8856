"""Sizes beside roots: |q| = √(q²) joins a root that holds q, √(q r)/|q| = √(r/q), and keeps its value wherever it has one."""

from __future__ import annotations

import random
from collections.abc import Iterator
from fractions import Fraction

import pytest

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import Formula, Number
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.notation.text import to_text

NAMES = ("g", "r", "R", "t", "L", "x", "y", "z")
FORMS = (
    ("sqrt(x*y)/abs(x)", "√(y/x)"),
    ("abs(x)/sqrt(x*y)", "√(x/y)"),
    ("abs(x)*sqrt(y/x)", "√(x y)"),
    ("sqrt(x*y)*abs(x)", "|x| √(x y)"),
    ("x*sqrt(x*y)/abs(x)", "x √(x y)/|x|"),
    ("sqrt(-x*y)/abs(y)", "√(−x/y)"),
    ("sqrt(x*y*z)/(abs(x)*abs(y))", "√(z/(x y))"),
    ("abs(cos(t))*sqrt(L/(g*cos(t)))", "√(L cos t/g)"),
    ("sqrt(2*g*cos(t)/((4*r - 3*R*cos(t))*sin(t)))", "√(2 g cos t/((4 r − 3 R cos t) sin t))"),
)
SHAPES = (
    "sqrt(A*B)/abs(A)",
    "abs(A)*sqrt(B/A)",
    "abs(A)/sqrt(A*B*C)",
    "A*sqrt(A*B)/abs(A)",
    "sqrt(A*B*C)/(abs(A)*abs(B))",
    "A*abs(B)*sqrt(B/A)",
    "sqrt(A/B)*abs(B*C)/A",
)


@pytest.mark.parametrize(("text", "shown"), FORMS)
def test_a_size_joins_a_root_that_holds_what_it_is_of(text: str, shown: str) -> None:
    assert to_text(simplify(parse(text, NAMES), positive=frozenset({"g", "r", "R", "L"}))) == shown


def drawn(chance: random.Random) -> Iterator[str]:
    """Brackets of one or two terms."""
    letters = ("x", "y", "z", "x*y", "cos(t)", "y*cos(t)", "sin(t)", "1")
    while True:
        terms = (
            f"({chance.choice((-3, -2, -1, 1, 2, 3))}*{chance.choice(letters)})" for _ in range(chance.choice((1, 2)))
        )
        yield f"({' + '.join(terms)})"


def value(formula: Formula, numbers: dict[str, Number]) -> float | None:
    try:
        return evaluate(formula, numbers).float
    except (Undefined, ZeroDivisionError):
        return None


@pytest.mark.parametrize("seed", range(4))
def test_it_keeps_its_value_whatever_the_signs(seed: int) -> None:
    chance, compared = random.Random(seed), 0
    brackets = drawn(chance)
    for _ in range(60):
        text = chance.choice(SHAPES)
        for name in "ABC":
            text = text.replace(name, next(brackets))
        try:
            whole = parse(text, NAMES)
            short = simplify(whole)
        except ZeroDivisionError:
            continue
        for _ in range(6):
            numbers = {name: Number(Fraction(chance.randint(1, 40) * chance.choice((-1, 1)), 8)) for name in "xyzt"}
            before = value(whole, numbers)
            if before is not None:
                compared += 1
                assert value(short, numbers) == pytest.approx(before, rel=1e-9), text
    assert compared > 60


def test_a_number_stands_first_under_a_root() -> None:
    """Also where what stands under it is a factor of what stands beside it."""
    root = "sqrt(3*m*(3*m + 4*M))"
    fraction = parse(f"sqrt(2*(m + 3*M*((-3*m + {root})/(6*M))^2)/(3*(m + 2*M*((-3*m + {root})/(6*M)))))")
    written = to_text(simplify(fraction, positive={"m", "M"}))
    assert "√(3 m (3 m + 4 M))" in written
    assert "·" not in written
