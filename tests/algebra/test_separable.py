"""Integrals of separated variables: real closed forms against mpmath, ends that are only approached, inversion, nested roots."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest

from rotsolve.algebra.calculus.separable import LONG, Stretch, Unending, in_closed_form
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.exact.normal import equal, simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.exact.roots import solve_unwrapped
from rotsolve.algebra.formula import Formula, Integral, Number, Symbol, sqrt
from rotsolve.algebra.notation.parse import parse as parse_any
from rotsolve.algebra.notation.text import to_text

NAMES = {"a", "b", "c", "k", "x", "y"}
VALUES = {"a": Number(Fraction(7, 5)), "b": Number(Fraction(3, 4)), "c": Number(Fraction(2, 9))}


def parse(text: str) -> Formula:
    return parse_any(text, NAMES)


def sign(f: Formula) -> int | None:
    return evaluate(f, VALUES, digits=5).sign


def number(f: Formula) -> float:
    return evaluate(f, VALUES, digits=15).float


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("integrand", "lower", "upper"),
    [
        ("-a/(c*x)", "b", "b/2"),
        ("1/(a-b*x)", "0", "a/(2*b)"),
        ("x/(a-b*x)", "0", "a/(2*b)"),
        ("b/(a-c*x^2)", "0", "2"),
        ("b/(c*x^2-a)", "5", "4"),
        ("b*x/(a-c*x^2)", "-1", "2"),
        ("1/(a+c*x^2)", "-1", "3"),
        ("x/(a+b*x+c*x^2)", "0", "1"),
        ("(1+x)/(3*a+c*x+c*x^2)", "0", "4"),
        ("1/(x*(a+b*x))", "1", "2"),
        ("1/(x^2-2*x+1)", "2", "3"),
        ("x^2/(a+b*x^2)", "0", "2"),
        ("-a/(c*sqrt(x))", "b", "0"),
        ("a*sqrt(x)/c", "b", "3"),
        ("(a+b*x-x^2)/(c*sqrt(x))", "b/2", "3"),
        ("1/sqrt(a-c*x^2)", "0", "2"),
        ("-1/sqrt(a+b*x-c*x^2)", "2", "-1"),
        ("sqrt(b/(x*(a-c*x)))", "0", "a/c"),
        ("1/sqrt(a+b*x+c*x^2)", "0", "2"),
        ("1/sqrt(a+b*x)", "0", "2"),
        ("sqrt(a-c*x^2)", "0", "2"),
        ("-sqrt(a+b*x+c*x^2)", "0", "1"),
        ("x^2/sqrt(a-c*x^2)", "0", "1"),
        ("-x/sqrt(a+b*x-c*x^2)", "-1", "2"),
        ("(1-x^2)/sqrt(a+b*x+c*x^2)", "0", "1"),
        ("(b-x)*sqrt(c/(a-x^2))", "0", "1"),
    ],
)
def test_integrals(integrand: str, lower: str, upper: str) -> None:
    f, ends = parse(integrand), (parse(lower), parse(upper))
    found = Stretch("x", *ends, sign).integral(f)
    assert found is not None
    at = {name: mpmath.mpf(value.value.numerator) / value.value.denominator for name, value in VALUES.items()}
    whole = mpmath.quad(
        lambda x: eval_at(integrand, {**at, "x": x}),
        [number(ends[0]), (number(ends[0]) + number(ends[1])) / 2, number(ends[1])],
    )
    assert abs(number(found) - float(whole)) < 1e-7 * abs(float(whole))


def eval_at(text: str, values: dict[str, mpmath.mpf]) -> mpmath.mpf:
    """A formula by Python's own arithmetic."""
    return eval(text.replace("^", "**"), {"sqrt": mpmath.sqrt, **values})


@pytest.mark.parametrize(
    ("integrand", "lower", "upper"), [("1/(c*x)", "b", "0"), ("1/(a-b*x)", "0", "a/b"), ("1/(a-c*x^2)", "0", "9")]
)
def test_an_end_that_is_only_approached(integrand: str, lower: str, upper: str) -> None:
    with pytest.raises(Unending):
        Stretch("x", parse(lower), parse(upper), sign).integral(parse(integrand))


@pytest.mark.parametrize("text", ["sin(x)/x", "1/(1+x^3)", "1/sqrt(1-x^4)", "exp(x)"])
def test_what_is_of_another_kind_is_left_alone(text: str) -> None:
    assert Stretch("x", parse("0"), parse("1/2"), sign).integral(parse(text)) is None


def test_signs_by_letters() -> None:
    signs = SignOracle({}, frozenset(NAMES))
    assert signs.by_letters(parse("a*b+c")) == 1
    assert signs.by_letters(parse("-a/b")) == -1
    assert signs.by_letters(parse("a-a")) == 0
    assert signs.by_letters(parse("a-b")) is None


@pytest.mark.parametrize(
    ("text", "root"),
    [
        ("a*log(b/x)-c", "b*exp(-c/a)"),
        ("a*log(a/(a-b*x))-c", "a*(1-exp(-c/a))/b"),
        ("asin(x/a)-b", "a*sin(b)"),
        ("2*atan(b*x)-a", "tan(a/2)/b"),
        ("a*exp(b*x)-c", "log(c/a)/b"),
    ],
)
def test_unwrapped(text: str, root: str) -> None:
    (found,) = solve_unwrapped(parse(text), "x", positive=NAMES)
    assert equal(found, parse(root), NAMES)


def test_unwrapping_needs_the_unknown_in_one_place() -> None:
    assert solve_unwrapped(parse("x+log(x)-a"), "x") == []
    assert solve_unwrapped(parse("exp(x)+sin(x)-a"), "x") == []


@pytest.mark.parametrize(
    "text", ["sqrt(sqrt(a/b))", "sqrt(a*sqrt(2*b/c))", "sqrt(sqrt(sqrt(a*b)))", "sqrt(sqrt(a+b)*a/c)"]
)
def test_roots_of_roots_keep_their_value(text: str) -> None:
    f = parse(text)
    for positive in (frozenset[str](), frozenset(NAMES)):
        assert abs(number(simplify(f, positive=positive)) - number(f)) < 1e-12


def test_a_size_has_both_signs() -> None:
    """|2 x − a| = b is 2 x − a = b or −b."""
    assert [to_text(root) for root in solve_unwrapped(parse("abs(2*x-a)-b"), "x", positive=NAMES)] == [
        "½ (a + b)",
        "½ (a − b)",
    ]


def test_constants_of_a_long_integrand_are_letters_meanwhile() -> None:
    """∫ dx/√(A + B x − C x²) with long A, B, C is the same number as by steps."""
    letters = {
        name: Fraction(number, 10) for name, number in zip("abcdefgh", (13, 7, 21, 9, 16, 11, 5, 8), strict=True)
    }
    a, b, c, d, e, f, g, h, x = map(Symbol, "abcdefghx")
    long = (a + b * c) * (d + e * (f + g) + h**2) / (a + d * e)
    push = (
        long + (b + c * (d + e) + f * g) * x / (g + h) - (c * (a + b) + d * e * f) / (b + h) * (x - f / (a * b * h)) * x
    )
    node = Integral(1 / sqrt(push), "x", g / (a + b + c), h / (d + e))
    assert length(node) > LONG
    signs = SignOracle({name: Number(value) for name, value in letters.items()}, frozenset(letters))
    found = in_closed_form(node, signs.sign, tuple(letters), frozenset(letters))
    assert found is not None and not found.holds(Integral)
    values = {name: Number(value) for name, value in letters.items()}
    assert evaluate(found, values).float == pytest.approx(evaluate(node, values).float, rel=1e-12)
