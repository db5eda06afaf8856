"""Integrals as they stand before they are worked out: the antiderivative at both ends."""

from __future__ import annotations

from fractions import Fraction

import pytest

from rotsolve.algebra.calculus.integral import at_bounds, integrate
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import Formula, Integral, Number
from rotsolve.algebra.notation.parse import parse as parse_any
from rotsolve.algebra.notation.text import to_text

NAMES = {"M", "L", "R", "b", "c", "k", "w", "x"}
POSITIVE = frozenset(NAMES)
VALUES = {name: Number(Fraction(place + 2, 3)) for place, name in enumerate(sorted(NAMES))}


def parse(text: str) -> Formula:
    return parse_any(text, NAMES)


def tidy(value: Formula) -> Formula:
    return simplify(value, positive=POSITIVE)


@pytest.mark.parametrize(
    ("integrand", "lower", "upper", "written"),
    [
        ("M*x^2/L", "-L/2", "L/2", "(M/(3 L)) ((½ L)³ − (−½ L)³)"),
        ("k*x^2", "-R", "R", "⅓ k (R³ − (−R)³)"),
        ("2*M*x^3/R^2", "0", "R", "(2 M/R²) (¼ R⁴)"),
        ("pi*(R^2-x^2)", "0", "R", "π (R³ − ⅓ R³)"),
        ("pi*(R^2-x^2)", "-R", "R", "2 π (R³ − ⅓ R³)"),
        ("M*(b^2+x^2)", "-L/2", "L/2", "2 M (½ b² L + ⅓ (½ L)³)"),
        ("-k/c", "b", "0", "k b/c"),
        ("-k/(c*x)", "b", "b/2", "−(k/c) ln(½ b/b)"),
        ("k*x/(M+c*x^2)", "0", "b", "(k/(2 c)) ln((M + b² c)/M)"),
        ("k*sin(w*x)", "0", "R", "−(k/w) (cos(w R) − cos(0))"),
        ("k*cos(w*x)", "0", "R", "k sin(w R)/w"),
        ("k*sin(x)^3", "0", "pi", "k (−cos π + ⅓ cos³ π + cos(0) − ⅓ cos³(0))"),
    ],
)
def test_the_antiderivative_stands_at_both_ends(integrand: str, lower: str, upper: str, written: str) -> None:
    f, low, high = parse(integrand), tidy(parse(lower)), tidy(parse(upper))
    found = at_bounds(Integral(f, "x", low, high), tidy)
    assert found is not None
    assert to_text(found) == written
    whole = integrate(f, "x", low, high, positive=POSITIVE)
    assert whole is not None
    assert evaluate(found, VALUES).float == pytest.approx(evaluate(whole, VALUES).float, rel=1e-12)


@pytest.mark.parametrize("integrand", ["1/(M-c*x^2)", "exp(-x^2)", "1/sqrt(M-c*x^2)"])
def test_without_an_antiderivative_of_the_page_nothing_is_written(integrand: str) -> None:
    assert at_bounds(Integral(parse(integrand), "x", parse("0"), parse("b")), tidy) is None
