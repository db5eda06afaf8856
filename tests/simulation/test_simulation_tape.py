"""The tape: a formula on it is worth what the formula is worth, its power series that of the formula, whatever is drawn together."""

from __future__ import annotations

import math
from fractions import Fraction

import mpmath
import pytest

from rotsolve.algebra.certified.ball import Precision, evaluate
from rotsolve.algebra.flints import arb, fmpq
from rotsolve.algebra.formula import Number
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.tape import BITS, Unwritable
from rotsolve.simulation.harmonics import fewer_products
from rotsolve.simulation.linear import Contradictory, Linear
from rotsolve.simulation.series import FLOATS, Expansion, rough_value
from rotsolve.simulation.tape import SeriesTape

m = mpmath
SAME = {  # formulas, and what they mean
    "sqrt(2)*x": lambda x, y: m.sqrt(2) * x,
    "x/sqrt(3) + 2^(3/2)*y - sqrt(12)": lambda x, y: x / m.sqrt(3) + m.sqrt(8) * y - m.sqrt(12),
    "cos(pi/6)*sin(x) - tan(1/3)*cos(y)": lambda x, y: m.cos(m.pi / 6) * m.sin(x) - m.tan(m.mpf(1) / 3) * m.cos(y),
    "(x + y)^3/(1 + x^2) - x*y": lambda x, y: (x + y) ** 3 / (1 + x**2) - x * y,
    "sin(x - y)*cos(x) + sin(x)^2 + cos(x)^2*y": lambda x, y: (
        m.sin(x - y) * m.cos(x) + m.sin(x) ** 2 + m.cos(x) ** 2 * y
    ),
    "sqrt(x^2 + y^2)*exp(-x) + log(2 + y)": lambda x, y: m.sqrt(x**2 + y**2) * m.exp(-x) + m.log(2 + y),
    "atan(x*y) + asin(x/3) - acos(y/4) + abs(x - 2*y)": lambda x, y: (
        m.atan(x * y) + m.asin(x / 3) - m.acos(y / 4) + abs(x - 2 * y)
    ),
    "atan2(3, -4)*x - abs(-7/3)": lambda x, y: m.atan2(3, -4) * x - m.mpf(7) / 3,
    "x^(5/2)/y^3": lambda x, y: x**2 * m.sqrt(x) / y**3,
}
X, Y = Fraction(7, 10), Fraction(6, 5)


@pytest.mark.parametrize("text", SAME)
def test_a_formula_is_worth_the_same_on_the_tape(text: str) -> None:
    formula = parse(text)
    with Precision(BITS):
        tape = SeriesTape()
        letters = {name: tape.letter(name) for name in ("x", "y")}
        place = tape.formula(formula, letters)
        places = [place, *fewer_products(tape, [place, place])]
    exact = evaluate(formula, {"x": Number(X), "y": Number(Y)}).float
    at = {"x": fmpq(X.numerator, X.denominator), "y": fmpq(Y.numerator, Y.denominator)}
    assert all(abs(rough_value(tape, found, at) - exact) < 1e-14 * max(1, abs(exact)) for found in places)


@pytest.mark.parametrize("text", SAME)
def test_a_series_has_the_coefficients_of_taylor(text: str) -> None:
    """Along x = X + t, y = Y − t/2."""
    with Precision(BITS):
        tape = SeriesTape()
        letters = {name: tape.letter(name) for name in ("x", "y")}
        place = tape.formula(parse(text), letters)
    expansion = Expansion(tape, [place], FLOATS)
    expansion.begin({letters["x"]: float(X), letters["y"]: float(Y)})
    for order in range(1, 9):
        for name, slope in (("x", 1.0), ("y", -0.5)):
            if letters[name] in expansion.lists:
                expansion.lists[letters[name]].append(slope if order == 1 else 0.0)
        expansion.extend(order)

    def along(t: mpmath.mpf) -> mpmath.mpf:
        x, y = mpmath.mpf(X.numerator) / X.denominator + t, mpmath.mpf(Y.numerator) / Y.denominator - t / 2
        return SAME[text](x, y)

    with mpmath.workdps(40):
        expected = mpmath.taylor(along, 0, 8)
    series = expansion.lists[place]
    scale = max(abs(float(value)) for value in expected)
    assert all(abs(found - float(value)) < 1e-11 * scale for found, value in zip(series, expected, strict=False))


def test_linear_equations_with_changing_coefficients() -> None:
    """cos x · p + q = 1, p − q = x, r = p + q, and one that says nothing new."""
    with Precision(BITS):
        tape = SeriesTape()
        letters = {"x": tape.letter("x")}
        linear = Linear(tape, letters, lambda place: rough_value(tape, place, {"x": fmpq(1, 2)}))
        rows = [
            linear.row(parse(text), "pqr") for text in ("cos(x)*p + q - 1", "p - q - x", "r - p - q", "2*r - 2*p - 2*q")
        ]
        known = linear.solve(rows, {"p": 1})
    p, q, r = (rough_value(tape, known[name], {"x": fmpq(1, 2)}) for name in "pqr")
    assert abs(p - 1.5 / (math.cos(0.5) + 1)) < 1e-15 and abs(q - p + 0.5) < 1e-15 and abs(r - p - q) < 1e-15


def test_equations_that_contradict_each_other_are_named() -> None:
    with Precision(BITS):
        tape = SeriesTape()
        linear = Linear(tape, {}, lambda place: rough_value(tape, place, {}))
        rows = [linear.row(parse(text), "pq") for text in ("p - q", "p - q - 1")]
        with pytest.raises(Contradictory):
            linear.solve(rows, {})


def test_what_has_no_series_is_refused() -> None:
    tape = SeriesTape()
    letters = {"x": tape.letter("x")}
    for text in ("ellipk(x)", "1/(2 - 2)", "y", "sqrt(0 - 2)"):
        with pytest.raises(Unwritable):
            tape.formula(parse(text), letters)
    assert tape.constant(tape.formula(parse("2/4"), letters)) == fmpq(1, 2)
    assert arb(tape.constant(tape.formula(parse("sqrt(2)"), letters))) ** 2 - 2 < 1e-9
