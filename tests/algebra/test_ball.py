"""Certified numbers: rounding, ties, ill-conditioned formulas, domains, integrals and roots; mpmath is the oracle."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rotsolve.algebra.certified.ball import Certified, Precision, decimal_text, evaluate
from rotsolve.algebra.certified.balls import RealBalls, Undefined
from rotsolve.algebra.certified.rootfind import real_roots
from rotsolve.algebra.formula import ONE, PI, ZERO, Formula, Integral, Number, Symbol, call
from rotsolve.algebra.notation.parse import parse

X, M1, M2, G = (Symbol(name) for name in ("x", "m1", "m2", "g"))


def f(value: str) -> Number:
    return Number(Fraction(value))


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        ("4.9", 4, "4.9"),
        ("4.9000213", 4, "4.900"),
        ("0.45", 4, "0.45"),
        ("2", 4, "2"),
        ("0", 4, "0"),
        ("0.525", 4, "0.525"),
        ("21.7777777", 4, "21.78"),
        ("23.894", 4, "23.89"),
        ("-12.7305", 4, "−12.73"),
        ("1.00049999", 4, "1.000"),
        ("1.0005", 4, "1.001"),
        ("-1.0005", 4, "−1.001"),
        ("99995", 4, "100000"),
        ("123456", 4, "123500"),
        ("999999", 4, "1.000×10⁶"),
        ("1200000", 4, "1.2×10⁶"),
        ("3000000", 4, "3×10⁶"),
        ("0.0001", 4, "0.0001"),
        ("0.00012345", 4, "0.0001235"),
        ("0.00007272205", 4, "7.272×10⁻⁵"),
        ("31.4159265358979", 10, "31.41592654"),
    ],
)
def test_decimals(value: str, digits: int, text: str) -> None:
    assert decimal_text(f(value), digits=digits) == text


def test_exact_through_angles_and_roots() -> None:
    values = {"g": Fraction("9.8"), "theta": PI / 6}
    assert decimal_text(G * call("sin", Symbol("theta")), values) == "4.9"
    assert decimal_text(call("sqrt", f("2")) * call("sqrt", f("8")), values) == "4"
    assert evaluate(call("sin", Symbol("theta")) - f("0.5"), values).sign == 0
    assert decimal_text(call("cos", PI / 3) * f("2.0001"), digits=4) == "1.000"
    assert decimal_text(call("cos", PI / 3) * f("2.001"), digits=4) == "1.001"  # 1.0005 exactly: a tie


def test_nearly_balanced() -> None:
    """m1 − m2 = 10⁻¹² kg: float64 loses everything, a ball nothing."""
    values = {"m1": f("1.000000000001"), "m2": ONE, "g": f("9.8")}
    found = evaluate((M1 - M2) * G / (M1 + M2), values, digits=20)
    assert found.text(6) == "4.9×10⁻¹²" or found.text(6) == "4.90000×10⁻¹²"
    assert found.sign == 1
    near_upright = evaluate(ONE - call("cos", f("1e-8")), {}, digits=20)
    assert near_upright.text(8) == "5.0000000×10⁻¹⁷"
    assert near_upright.digits_certified >= 20


@pytest.mark.parametrize(
    "g",
    [
        ONE / (X - 1),
        call("sqrt", -X),
        call("asin", X + 1),
        call("log", X - 1),
        call("atan2", X - 1, ZERO),
        Symbol("unknown"),
        ONE / (call("sin", PI / 6) - f("0.5")),
    ],
)
def test_undefined(g: Formula) -> None:
    with pytest.raises(Undefined):
        evaluate(g, {"x": ONE})


def test_borderline_arguments_are_settled() -> None:
    half = call("sin", PI / 6)
    assert evaluate(call("sqrt", half - f("0.5")), {}).sign == 0
    assert decimal_text(call("asin", half * 2)) == "1.571"


def test_a_value_that_refers_to_itself() -> None:
    with pytest.raises(Undefined):
        evaluate(X, {"x": Symbol("y"), "y": Symbol("x")})


def test_powers_of_a_difference_that_vanishes() -> None:
    tenth = {"a": Number(Fraction(1, 10)), "b": Number(Fraction(1, 10))}
    for text in ("(a - b)^2 + 1", "(a - b)^3 + 1", "1 - (a - b)^7"):
        assert evaluate(parse(text), tenth).text(4) == "1"


def test_integrals() -> None:
    assert decimal_text(Integral(call("sqrt", 1 - X**2), "x", ZERO, ONE), digits=8) == "0.78539816"
    assert decimal_text(Integral(call("exp", -(X**2)), "x", ZERO, ONE), digits=20) == "0.74682413281242702540"
    moment = Integral(Symbol("k") * X**2, "x", ZERO, Symbol("L"))
    assert evaluate(moment, {"k": Fraction(3), "L": Fraction(2)}).text(6) in ("8", "8.00000")


def test_integrals_up_to_a_turning_point() -> None:
    k = Symbol("k")
    arc = Integral(1 / call("sqrt", k**2 - X**2), "x", ZERO, k)
    assert evaluate(arc, {"k": Fraction(3, 7)}).text(18) == "1.57079632679489662"
    quarter = Integral(1 / call("sqrt", 2 * call("cos", X) - 1), "x", ZERO, call("acos", f("1/2")))
    assert evaluate(quarter, {}).text(15) == "1.68575035481260"  # K(1/2), the complete elliptic integral
    whole = Integral(-1 / call("sqrt", 1 - X**4), "x", -ONE, ONE)
    assert evaluate(whole, {}).text(15) == "−2.62205755429212"  # the lemniscate constant


def test_one_root() -> None:
    (found,) = real_roots(X - call("cos", X), "x", {}, 0, 1, 30).roots
    assert found.text(30) == "0.739085133215160641655312087674"
    assert found.text(4) == "0.7391"
    assert [root.text(4) for root in real_roots(X**2 - 4, "x", {}, 0, 5).roots] == ["2"]
    assert len(real_roots(call("sin", X), "x", {}, 1, 10).roots) == 3
    assert not real_roots(X**2 + 1, "x", {}, -3, 3).roots


def test_real_roots() -> None:
    found = real_roots(call("cos", X) - X / 10, "x", {}, -20, 20)
    assert found.complete
    assert len(found.roots) == 7
    assert all(abs(evaluate(call("cos", X) - X / 10, {"x": f(str(r.float))}).float) < 1e-12 for r in found.roots)
    cubic = real_roots(X**3 - 2 * X, "x", {}, -2, 2)
    assert [root.text(4) for root in cubic.roots] == ["−1.414", "0", "1.414"]
    assert cubic.complete
    ends = real_roots(X * (X - 1), "x", {}, 0, 1)
    assert [root.text(4) for root in ends.roots] == ["0", "1"]
    assert not real_roots(X**2, "x", {}, -2, 3).complete
    domain = real_roots(call("sqrt", X) - f("0.5"), "x", {}, -1, 1)
    assert [root.text(4) for root in domain.roots] == ["0.25"]


@settings(max_examples=150, deadline=None)
@given(
    st.fractions(min_value=Fraction(1, 50), max_value=100, max_denominator=50),
    st.fractions(min_value=-3, max_value=3, max_denominator=40),
)
def test_values_agree_with_mpmath(a: Fraction, x: Fraction) -> None:
    import mpmath

    g = (
        call("sqrt", Symbol("a")) * call("sin", X)
        + call("exp", -X) / (Symbol("a") + X**2)
        - call("atan2", X, Symbol("a"))
    )
    found = evaluate(g, {"a": a, "x": x}, digits=25)
    with mpmath.workdps(60):
        p, q = mpmath.mpf(a.numerator) / a.denominator, mpmath.mpf(x.numerator) / x.denominator
        wanted = mpmath.sqrt(p) * mpmath.sin(q) + mpmath.exp(-q) / (p + q**2) - mpmath.atan2(q, p)
        text = mpmath.nstr(wanted, 50)
    assert abs(Fraction(text) - Fraction(str(found.float))) <= abs(Fraction(text)) * Fraction(1, 10**14)
    assert found.digits_certified >= 25


@settings(max_examples=200, deadline=None)
@given(st.decimals(allow_nan=False, allow_infinity=False, min_value=-1000000, max_value=1000000, places=7))
def test_rounding_is_half_away_from_zero(number: object) -> None:
    from decimal import ROUND_HALF_UP, Context, Decimal

    assert isinstance(number, Decimal)
    text = decimal_text(Number(Fraction(number)), digits=5)
    shown = Decimal(text.replace("−", "-").split("×")[0])
    if "×10" in text:
        shown = shown.scaleb(int(text.split("×10")[1].translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))))
    assert shown == Context(prec=5, rounding=ROUND_HALF_UP).plus(number)


@pytest.mark.parametrize("m", ["0", "1/4", "0.9924038765", "-3", "0.999999999999"])
def test_elliptic_integral_is_that_of_the_arithmetic_geometric_mean(m: str) -> None:
    import mpmath

    with mpmath.workdps(40):
        exact = Fraction(m)
        oracle = mpmath.pi / (2 * mpmath.agm(1, mpmath.sqrt(1 - mpmath.mpf(exact.numerator) / exact.denominator)))
        assert evaluate(call("ellipk", f(m)), {}, digits=30).text(25) == mpmath.nstr(oracle, 25, strip_zeros=False)


@pytest.mark.parametrize("m", ["1", "1.5"])
def test_elliptic_integral_ends_at_one(m: str) -> None:
    with pytest.raises(Undefined):
        evaluate(call("ellipk", f(m)), {})


def test_elliptic_integral_is_the_integral_of_its_definition() -> None:
    turn, m = Symbol("x"), f("3/10")
    root = call("sqrt", ONE - m * call("sin", turn) ** 2)
    quarter = Integral(ONE / root, "x", ZERO, PI / 2)
    assert evaluate(quarter, {}, digits=20).text(15) == evaluate(call("ellipk", m), {}, digits=20).text(15)


def test_a_number_is_told_from_a_near_one_by_a_finer_ball() -> None:
    """exp(125/19) and its like were asked of exact algebra, for minutes, wherever many digits were wanted."""
    asked: list[Fraction] = []
    known = evaluate(parse("exp(-x)*sqrt(m1*(exp(2*x) - 1))"), {"x": f("125/19"), "m1": f("298")})
    number = Certified(known.ball, known.refine, lambda value: bool(asked.append(value)))
    text, sure = number.figures(30)
    assert sure == 30 and text == known.figures(30)[0] and not asked
    exact = evaluate(parse("sqrt(2)*sqrt(8)"), {})
    assert Certified(exact.ball, exact.refine, lambda value: bool(asked.append(value))).figures(30)[1] == 30
    assert asked == [4]  # what is a short number is still tested


@pytest.mark.parametrize("speed", ["6.2e-18", "1e-9", "1e-3", "1"])
def test_the_time_of_a_swing_however_small(speed: str) -> None:
    """t = ∫ dθ/ω from the lowest place to the turning point is K(k²)/ω₁, k = ω₀/(2 ω₁), which is ½ π/ω₁ for small ones.

    Where the precision told no sign of the integrand, the ball was that of the negative number; and it took seconds.
    """
    values = {"i": f("0.002"), "d": f("0.0054"), "w": f(speed)}
    swing = Integral(parse("sqrt(i/(2*d*cos(x) - 2*d + i*w^2))"), "x", ZERO, parse("acos(1 - i*w^2/(2*d))"))
    true = evaluate(parse("ellipk(i*w^2/(4*d))*sqrt(i/d)"), values, digits=40)
    assert evaluate(swing, values, digits=30).figures(30) == true.figures(30)
    for bits in (40, 77, 154, 308):
        with Precision(bits):
            ball = RealBalls(values)(swing)
        assert not ball.is_finite() or ball.overlaps(true.ball)
