"""Elliptic functions sn, cn, dn, am, F and Π as functions of formulas: numbers, derivatives, exact values, text that is read again."""

from __future__ import annotations

from fractions import Fraction

import pytest

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.ball import Precision, evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.certified.elliptic import third_kind_up_to
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.flints import arb
from rotsolve.algebra.formula import ELLIPTIC, ONE, PI, ZERO, Call, Formula, Number, Symbol, call, formula, multiply
from rotsolve.algebra.notation.mathml import mathml
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.notation.typeset import to_latex
from rotsolve.algebra.sympy_bridge import from_sympy, to_sympy
from rotsolve.algebra.units.dimension import TIME, DimensionError, dimension_of

U, M = Symbol("u"), Symbol("m")
JACOBI = ("ellipsn", "ellipcn", "ellipdn")


def number(value: str | int) -> Formula:
    return formula(Fraction(value))


@pytest.mark.parametrize("m", ["1/4", "0.999999999999", "1e-12", "0.5"])
@pytest.mark.parametrize("u", ["0.3", "-7.25", "12345.678", "1e-9"])
@pytest.mark.parametrize("function", JACOBI)
def test_certified_numbers_are_those_of_fifty_digits(function: str, u: str, m: str) -> None:
    import mpmath

    with mpmath.workdps(60):
        at, parameter = (mpmath.mpf(Fraction(text).numerator) / Fraction(text).denominator for text in (u, m))
        true = mpmath.nstr(mpmath.ellipfun(ELLIPTIC[function], at, m=parameter), 55)
    with Precision(200):
        assert (evaluate(call(function, number(u), number(m)), {}, digits=30).ball / arb(true) - 1).abs_upper() < 1e-29


@pytest.mark.parametrize(("m", "rational"), [("0", "sin(u)"), ("1", "tanh(u)")])
def test_at_both_ends_of_the_parameter(m: str, rational: str) -> None:
    at = {"u": number("0.7"), "a": number(2)}
    inexact = number(m) * call("sqrt", Symbol("a")) ** 2 / Symbol("a")  # 0 or 1, which a ball alone does not tell
    for parameter in (number(m), inexact):
        found = evaluate(Call("ellipsn", (U, parameter)), at, digits=25).text(20)
        assert found == evaluate(parse(rational, {"u"}), at, digits=25).text(20)


@pytest.mark.parametrize("m", ["-1/2", "3/2"])
def test_other_parameters_have_no_value(m: str) -> None:
    for function in (*JACOBI, "ellipf"):
        with pytest.raises(Undefined):
            evaluate(call(function, number(2), number(m)), {})


def test_the_integral_is_undone_by_its_functions() -> None:
    """sn F(φ, m) = sin φ, also beyond a quarter turn."""
    for phi, m in (("0.3", "0.5"), ("5", "0.9"), ("-40", "0.999999")):
        whole = call("ellipsn", call("ellipf", number(phi), number(m)), number(m))
        assert evaluate(whole, {}, digits=25).text(20) == evaluate(call("sin", number(phi)), {}, digits=25).text(20)
    assert evaluate(call("ellipf", PI / 2, number("1/3")), {}).text(12) == evaluate(
        call("ellipk", number("1/3")), {}
    ).text(12)


@pytest.mark.parametrize("function", [*JACOBI, "ellipf", "ellipam", "ellippiinc"])
def test_derivatives_are_differences(function: str) -> None:
    value = call(function, *([-M] if function == "ellippiinc" else []), 2 * U, M)
    at, step = {"m": number("0.7"), "u": number("0.6")}, Fraction(1, 10**12)
    slope = evaluate(differentiate(value, "u"), at, digits=30)
    ends = [evaluate(value, {**at, "u": formula(Fraction(6, 10) + way * step)}, digits=40).ball for way in (1, -1)]
    assert abs(float(slope.ball) - float((ends[0] - ends[1]) / (2 * float(step)))) < 1e-9
    with pytest.raises(ValueError, match="no derivative"):
        differentiate(value, "m")


def test_what_is_nothing_or_negative_is_simpler() -> None:
    assert [simplify(call(name, ZERO, M)) for name in JACOBI] == [ZERO, ONE, ONE]
    assert simplify(call("ellipf", ZERO, M)) == ZERO
    assert [to_text(simplify(call(name, -U, M))) for name in JACOBI] == ["−sn(u, m)", "cn(u, m)", "dn(u, m)"]
    assert [to_text(simplify(call(name, U, ZERO))) for name in (*JACOBI, "ellipf")] == ["sin u", "cos u", "1", "u"]
    assert simplify(call("ellipsn", U + U, M) - call("ellipsn", 2 * U, M)) == ZERO


@pytest.mark.parametrize("n", ["-3/2", "1e-9", "0.999"])
@pytest.mark.parametrize("m", ["1e-12", "0.5", "0.999"])
def test_the_third_kind_is_that_of_fifty_digits(n: str, m: str) -> None:
    import mpmath

    with mpmath.workdps(60):
        own, parameter = (mpmath.mpf(Fraction(text).numerator) / Fraction(text).denominator for text in (n, m))
        true = mpmath.nstr(mpmath.ellippi(own, parameter), 55)
    with Precision(200):
        found = evaluate(call("ellippi", number(n), number(m)), {}, digits=30).ball
        assert (found / arb(true) - 1).abs_upper() < 1e-29


@pytest.mark.parametrize("n", ["-1000000", "-3/2", "1e-9", "0.999"])
@pytest.mark.parametrize("m", ["1e-12", "0.5", "0.999999"])
@pytest.mark.parametrize("phi", ["0.3", "-1.5707963267948966", "12345.678", "-1e-9"])
def test_the_incomplete_third_kind_goes_on_by_its_period(n: str, m: str, phi: str) -> None:
    """Within a quarter turn, beside one, and far beyond, against fifty digits; a ball about the place holds the value too."""
    import mpmath

    with mpmath.workdps(70):
        own, at, parameter = (mpmath.mpf(Fraction(text).numerator) / Fraction(text).denominator for text in (n, phi, m))
        halves = mpmath.nint(at / mpmath.pi)
        whole = mpmath.ellippi(own, at - halves * mpmath.pi, parameter) + 2 * halves * mpmath.ellippi(own, parameter)
        true = mpmath.nstr(whole, 55)
    with Precision(200):
        found = evaluate(call("ellippiinc", number(n), number(phi), number(m)), {}, digits=30).ball
        assert (found / arb(true) - 1).abs_upper() < 1e-29
        wide = third_kind_up_to(*(arb(*pair) for pair in ((mid(n),), (mid(phi), 1e-9), (mid(m),))))
        assert wide.contains(third_kind_up_to(arb(mid(n)), arb(mid(phi)), arb(mid(m))))


def mid(value: str) -> float:
    return float(Fraction(value))


@pytest.mark.parametrize("m", ["1e-12", "0.5", "0.999999"])
@pytest.mark.parametrize("phi", ["0.3", "-1.5707963267948966", "3.2", "123.4"])
def test_the_amplitude_undoes_the_first_kind(phi: str, m: str) -> None:
    whole = call("ellipam", call("ellipf", number(phi), number(m)), number(m))
    with Precision(200):
        assert abs(evaluate(whole, {}, digits=30).ball - evaluate(number(phi), {}, digits=40).ball) < 1e-25


def test_the_amplitude_and_the_incomplete_third_kind_at_both_ends() -> None:
    assert evaluate(call("ellipam", number("0.7"), ONE), {}).text(12) == evaluate(
        parse("atan((exp(0.7) - exp(-0.7))/2)", set()), {}
    ).text(12)
    assert simplify(call("ellipam", U, ZERO)) == U and simplify(call("ellippiinc", ZERO, U, M)) == call("ellipf", U, M)
    assert to_text(simplify(call("ellippiinc", M, -U, M))) == "−Π(m, u, m)"
    value = call("ellippiinc", -U, call("ellipam", 2 * U, M), M)
    assert to_text(value) == "Π(−u, am(2 u, m), m)" and parse(to_text(value), {"u", "m"}) == value
    assert from_sympy(to_sympy(value)) == value
    assert r"\operatorname{am}\left(2 u, m\right)" in to_latex(value) and "<mi>am</mi>" in mathml(value)
    with pytest.raises((Undefined, ValueError)):
        evaluate(call("ellippiinc", number(2), number("0.5"), number("0.5")), {})


def test_the_third_kind_has_simpler_cases_and_no_value_beyond() -> None:
    assert simplify(call("ellippi", ZERO, M)) == call("ellipk", M)
    assert to_text(simplify(call("ellippi", U, ZERO))) == "π/(2 √(1 − u))"
    assert to_text(call("ellippi", -U, M)) == "Π(−u, m)"
    assert parse("Π(−u, m)", {"u", "m"}) == call("ellippi", -U, M)
    assert to_latex(call("ellippi", U, M)) == r"\Pi\left(u, m\right)"
    assert from_sympy(to_sympy(call("ellippi", U, M))) == call("ellippi", U, M)
    with pytest.raises((Undefined, ValueError)):
        evaluate(call("ellippi", number(2), number("0.5")), {})


def test_texts_are_read_again() -> None:
    value = 2 * call("ellipcn", 3 * U + call("ellipf", call("atan", U), M), M) ** 2 + call("ellipdn", U, M)
    text = to_text(value)
    assert text == "2 (cn(3 u + F(arctan u, m), m))² + dn(u, m)"
    assert parse(text, {"u", "m"}) == value
    assert parse(to_text(value, unicode=False), {"u", "m"}) == value
    assert parse("s*n*(u + 1)", {"s", "n", "u"}) == parse(
        "sn(u + 1)", {"s", "n", "u"}
    )  # letters, where there is no comma
    assert to_latex(call("ellipsn", U, M)) == r"\operatorname{sn}\left(u, m\right)"
    assert "<mi>sn</mi>" in mathml(call("ellipsn", U, M))


def test_sympy_has_no_word_for_some_and_gives_them_back() -> None:
    for function in (*JACOBI, "ellipf"):
        value = call(function, U, M)
        assert from_sympy(to_sympy(value)) == value
    assert from_sympy(to_sympy(call("ellipk", M))) == call("ellipk", M)


@pytest.mark.parametrize("value", [call("ellipsn", U, Number(Fraction(1, 2))), call("ellipsn", ONE, U)])
def test_they_take_pure_numbers(value: Formula) -> None:
    with pytest.raises(DimensionError):
        dimension_of(value, {"u": TIME})


def test_what_is_simpler_within_another_has_its_roots_in_normal_form() -> None:
    """am(u, 0) is u, of which the roots may have been written as √(a/b): within Π(n, φ, m) that was no polynomial."""
    a, b, n = Symbol("a"), Symbol("b"), Symbol("n")
    u = multiply(U, call("sqrt", a / b))
    inner = call("ellipam", PI / 2 + u, ZERO)
    found = simplify(call("ellippiinc", n, inner, M), positive=frozenset("abu"))
    assert found == simplify(call("ellippiinc", n, PI / 2 + u, M), positive=frozenset("abu"))
