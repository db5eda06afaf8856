"""What is printed can be read again and then means the same; and it looks as a textbook has it."""

from __future__ import annotations

import zlib
from fractions import Fraction

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from rotsolve.algebra.formula import (
    FUNCTIONS,
    PI,
    Call,
    Constant,
    Formula,
    Integral,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
)
from rotsolve.algebra.notation.letters import name_to_latex, name_to_text
from rotsolve.algebra.notation.limits import rational
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.notation.tokens import FormulaError
from rotsolve.algebra.notation.typeset import to_latex

NAMES = (
    "m M g a b I E N S e d f L R x y m1 m2 x_12 theta theta0 omega_2 omega alpha beta lambda Delta Omega phi_max a_end "
    "alpha_end theta0_end delta_K delta_theta1 H_x r_i v_P2 I_A A_x time epsilon mu"
)
NAMES_SET = frozenset(NAMES.split())
PRIME = (1 << 61) - 1
K = Symbol("M") / Symbol("R") ** 2
SUMMED = Integral(Symbol("r") ** 3, "r", Number(Fraction(0)), Symbol("R"))


def code(*parts: object) -> int:
    return zlib.crc32(repr(parts).encode())


def value(formula: Formula, values: dict[str, int]) -> int:
    """The formula's value in a prime field, where functions are hashes: equal texts can not differ by rounding."""
    match formula:
        case Number(number):
            return number.numerator * pow(number.denominator, -1, PRIME) % PRIME
        case Symbol(name):
            return values[name] if name in values else code(name)
        case Constant(name):
            return code(name)
        case Sum(terms):
            return sum(value(term, values) for term in terms) % PRIME
        case Product(factors):
            result = 1
            for factor in factors:
                result = result * value(factor, values) % PRIME
            return result
        case Negative(operand):
            return -value(operand, values) % PRIME
        case Quotient(numerator, denominator):
            return value(numerator, values) * pow(value(denominator, values), -1, PRIME) % PRIME
        case Power(base, exponent):
            number = rational(exponent)
            if number is not None and number.denominator == 1:
                return pow(value(base, values), int(number), PRIME)
            return code("power", value(base, values), value(exponent, values))
        case Call(function, arguments):
            return code(function, *(value(argument, values) for argument in arguments))
        case Integral(integrand, variable, lower, upper):
            inner = value(integrand, {**values, variable: 12345})
            return code("integral", inner, value(lower, values), value(upper, values))
    raise TypeError(formula)


numbers = st.one_of(
    st.integers(-12, 12).map(Fraction),
    st.sampled_from(
        [Fraction(1, 2), Fraction(1, 12), Fraction(2, 5), Fraction(49, 5), Fraction(-3, 8), Fraction(1, 700)]
    ),
    st.fractions(min_value=-100, max_value=100, max_denominator=1000),
).map(Number)
leaves = st.one_of(numbers, st.sampled_from(sorted(NAMES_SET)).map(Symbol), st.just(PI))
exponents = st.one_of(
    st.integers(-4, 4).map(lambda n: Number(Fraction(n))),
    st.sampled_from([Number(Fraction(1, 2)), Number(Fraction(-3, 2)), Symbol("x"), Negative(Number(Fraction(2)))]),
    leaves,
)


def grow(inner: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
    several = st.lists(inner, min_size=2, max_size=4).map(tuple)
    single = st.sampled_from([name for name, count in FUNCTIONS.items() if count == 1])
    return st.one_of(
        several.map(Sum),
        several.map(Product),
        several.map(Product),
        st.tuples(inner, inner).map(lambda pair: Quotient(*pair)),
        st.tuples(inner, exponents).map(lambda pair: Power(*pair)),
        st.tuples(exponents, inner).map(lambda pair: Power(*pair)),
        inner.map(Negative),
        st.tuples(single, inner).map(lambda pair: Call(pair[0], (pair[1],))),
        st.tuples(inner, inner).map(lambda pair: Call("atan2", pair)),
        st.tuples(inner, st.sampled_from(["time", "x", "theta", "d"]), inner, inner).map(
            lambda parts: Integral(*parts)
        ),
    )


formulas = st.recursive(leaves, grow, max_leaves=12)


def read_back(formula: Formula, text: str) -> Formula:
    try:
        return parse(text, NAMES_SET)
    except FormulaError as error:
        caps = ("too large", "in an exponent", "too deep")
        assume(not any(cap in error.message for cap in caps))
        raise AssertionError(f"{text!r} of {formula!r}: {error}") from error


@settings(max_examples=1500, deadline=None)
@given(formulas, st.booleans())
def test_what_is_printed_reads_back_the_same(formula: Formula, unicode: bool) -> None:
    text = to_text(formula, unicode=unicode)
    again = read_back(formula, text)
    try:
        expected = value(formula, {})
    except ValueError:  # no inverse: a division by zero
        assume(False)
    assert value(again, {}) == expected, text
    assert unicode or text.isascii()


@settings(max_examples=300, deadline=None)
@given(formulas)
def test_printing_settles(formula: Formula) -> None:
    """The text of what was read back is the same text again, but for brackets that only grouping needed."""
    text = to_text(read_back(formula, to_text(formula)))
    assert to_text(read_back(formula, text)) == text


@settings(max_examples=300, deadline=None)
@given(formulas)
def test_latex_is_balanced(formula: Formula) -> None:
    latex = to_latex(formula)
    assert latex.count("{") == latex.count("}")
    assert latex.count(r"\left") == latex.count(r"\right")
    assert "$" not in latex


@pytest.mark.exhaustive
@settings(max_examples=300, deadline=None)
@given(st.from_regex(r"[A-Za-z]{1,6}[0-9]{0,2}(_[A-Za-z0-9]{1,4}){0,2}", fullmatch=True))
def test_every_name_reads_back(name: str) -> None:
    assume(name not in ("pi", "Pi") and name not in FUNCTIONS)
    assert parse(name_to_text(name), [name]) == Symbol(name)


def n(value: int | str) -> Number:
    return Number(Fraction(value))


a, b, c, d, m, big_m, g, length, radius = (Symbol(name) for name in ("a", "b", "c", "d", "m", "M", "g", "L", "R"))
theta, theta0, x = Symbol("theta"), Symbol("theta0"), Symbol("x")


def call(name: str, *arguments: Formula) -> Call:
    return Call(name, arguments)


TABLE = [
    (m * g - Symbol("T"), "m g − T", "m*g - T"),
    (2 * m * g / (2 * m + big_m), "2 m g/(2 m + M)", "2*m*g/(2*m + M)"),
    (Fraction(1, 2) * big_m * radius**2, "½ M R²", "1/2*M*R^2"),
    (Fraction(1, 3) * big_m * length**2, "⅓ M L²", "1/3*M*L^2"),
    (Fraction(1, 12) * big_m * length**2, "1/12 M L²", "1/12*M*L^2"),
    (Product((Quotient(n(1), n(2)), m)), "1/2 m", "1/2*m"),
    (Fraction(2, 5) * m * radius**2, "⅖ m R²", "2/5*m*R^2"),
    (Fraction(3, 4) * big_m * g * call("sin", theta), "¾ M g sin θ", "3/4*M*g*sin(theta)"),
    (Fraction(1, 3) * call("sqrt", n(3)) * length, "⅓ √3 L", "1/3*sqrt(3)*L"),
    (call("sqrt", n(3)) * g / (4 * length), "√3 g/(4 L)", "sqrt(3)*g/(4*L)"),
    (3 * g * call("cos", theta0) / (2 * length), "3 g cos θ₀/(2 L)", "3*g*cos(theta0)/(2*L)"),
    (m * g * call("sin", n("5/12") * PI), "m g sin 75°", "m*g*sin(5/12*pi)"),
    (Product((Power(call("cos", PI / 8), n(2)), m)), "cos²(22.5°) m", "cos(pi/8)^2*m"),
    (call("tan", PI / 7) * m, "tan(π/7) m", "tan(pi/7)*m"),
    (call("sin", 2 * PI), "sin 360°", "sin(2*pi)"),
    (call("sin", n("12345678901/1000") * PI), "sin(12345678.901 π)", "sin(12345678.901*pi)"),
    (
        -call("sqrt", 3 * g * (1 + call("sin", theta0)) / length),
        "−√(3 g (1 + sin θ₀)/L)",
        "-sqrt(3*g*(1 + sin(theta0))/L)",
    ),
    (Product((big_m, g, Quotient(length, n(2)), call("cos", theta0))), "M g (L/2) cos θ₀", "M*g*(L/2)*cos(theta0)"),
    (Product((Quotient(length, n(2)), call("cos", theta))), "(L/2) cos θ", "(L/2)*cos(theta)"),
    (-(a**2), "−a²", "-a^2"),
    (Power(-a, n(2)), "(−a)²", "(-a)^2"),
    (a / (b * c), "a/(b c)", "a/(b*c)"),
    (Quotient(Quotient(a, b), c), "(a/b)/c", "(a/b)/c"),
    (Quotient(a, Quotient(b, c)), "a/(b/c)", "a/(b/c)"),
    (Sum((a, Negative(Sum((b, Negative(c)))))), "a − (b − c)", "a - (b - c)"),
    (Sum((a, Sum((b, c)))), "a + (b + c)", "a + (b + c)"),
    ((a / b) ** 2, "(a/b)²", "(a/b)^2"),
    (n(2) ** -1, "2⁻¹", "2^(-1)"),
    (n(-2) ** 2, "(−2)²", "(-2)^2"),
    (n("1/2") ** 2, "(½)²", "(1/2)^2"),
    (x ** Fraction(1, 2), "x^(1/2)", "x^(1/2)"),
    (x**b, "x^b", "x^b"),
    (x ** (-b), "x^(−b)", "x^(-b)"),
    ((x**2) ** 3, "(x²)³", "(x^2)^3"),
    (x ** (b**c), "x^(b^c)", "x^(b^c)"),
    (Product((n(2), n(3), x)), "2·3 x", "2*3*x"),
    (Product((x, n(-3))), "x (−3)", "x*(-3)"),
    (Product((n(-3), x)), "−3 x", "-3*x"),
    (Product((a, Negative(b))), "a (−b)", "a*(-b)"),
    (Negative(Negative(a)), "−(−a)", "-(-a)"),
    (Sum((a, n(-2))), "a − 2", "a - 2"),
    (Sum((n(-2), a)), "−2 + a", "-2 + a"),
    (call("cos", theta) ** 2, "cos² θ", "cos(theta)^2"),
    (call("cos", theta) ** -1, "(cos θ)⁻¹", "cos(theta)^(-1)"),
    (call("cos", 2 * theta) ** 2, "cos²(2 θ)", "cos(2*theta)^2"),
    (call("sin", 2 * theta), "sin(2 θ)", "sin(2*theta)"),
    (call("sin", PI), "sin π", "sin(pi)"),
    (call("sin", theta) * call("cos", theta), "sin θ cos θ", "sin(theta)*cos(theta)"),
    (call("sin", theta) * radius, "sin(θ) R", "sin(theta)*R"),
    (call("cos", theta) ** 2 * radius, "cos²(θ) R", "cos(theta)^2*R"),
    (call("sqrt", n(2)) * g, "√2 g", "sqrt(2)*g"),
    (call("sqrt", x) * g, "√(x) g", "sqrt(x)*g"),
    (Power(call("sqrt", x), n(2)), "(√x)²", "sqrt(x)^2"),
    (call("abs", x), "|x|", "abs(x)"),
    (call("abs", call("abs", x) - 1), "abs(|x| − 1)", "abs(abs(x) - 1)"),
    (call("atan2", a, b), "atan2(a, b)", "atan2(a, b)"),
    (call("log", x), "ln x", "log(x)"),
    (call("exp", -x), "exp(−x)", "exp(-x)"),
    (call("asin", a / b), "arcsin(a/b)", "asin(a/b)"),
    (n("9.8") * m, "9.8 m", "9.8*m"),
    (n("7/10") * m, "7/10 m", "7/10*m"),
    (Quotient(n("1/12"), x), "(1/12)/x", "(1/12)/x"),
    (
        Integral(c * Symbol("time") ** 2, "time", n(0), Symbol("t1")),
        "∫[0 → t₁] c time² d time",
        "integral(c*time^2, time, 0, t1)",
    ),
    (Integral(d, "x", n(0), n(1)), "∫[0 → 1] (d) dx", "integral(d, x, 0, 1)"),
    (Integral(Symbol("t1"), "t1", n(0), n(1)), "∫[0 → 1] t₁ dt₁", "integral(t1, t1, 0, 1)"),
    (Integral(Call("abs", (Negative(x),)), "x", n(0), n(1)), "∫[0 → 1] |−x| dx", "integral(abs(-x), x, 0, 1)"),
]


@pytest.mark.parametrize(("formula", "text", "ascii_text"), TABLE, ids=[row[1] for row in TABLE])
def test_looks_like_a_textbook(formula: Formula, text: str, ascii_text: str) -> None:
    assert to_text(formula) == text
    assert to_text(formula, unicode=False) == ascii_text


@pytest.mark.parametrize(
    ("name", "text", "latex"),
    [
        ("m1", "m₁", "m_{1}"),
        ("theta0", "θ₀", r"\theta_{0}"),
        ("omega_2", "ω₂", r"\omega_{2}"),
        ("a_end", "a_end", r"a_{\mathrm{end}}"),
        ("H_x", "Hₓ", "H_{x}"),
        ("r_i", "rᵢ", "r_{i}"),
        ("I_A", "I_A", "I_{A}"),
        ("v_P2", "v_P2", r"v_{\mathrm{P2}}"),
        ("phi_max", "φ_max", r"\phi_{\mathrm{max}}"),
        ("lambda", "λ", r"\lambda"),
        ("Delta", "Δ", r"\Delta"),
        ("x_12", "x₁₂", "x_{12}"),
        ("time", "time", r"\mathrm{time}"),
        ("rod.end.speed", "rod.end.speed", r"\mathrm{rod.end.speed}"),
    ],
)
def test_names(name: str, text: str, latex: str) -> None:
    assert name_to_text(name) == text
    assert name_to_latex(name) == latex


def test_names_that_print_alike_are_told() -> None:
    with pytest.raises(FormulaError, match=r"`x₁` can be read in two ways: write `x1` or `x_1`"):
        parse("x₁", ("x1", "x_1"))


@pytest.mark.parametrize(
    ("formula", "latex"),
    [
        (2 * m * g / (2 * m + big_m), r"\frac{2 m g}{2 m + M}"),
        (Fraction(1, 2) * big_m * radius**2, r"\frac{1}{2} M R^{2}"),
        (-call("sqrt", 3 * g / length), r"-\sqrt{\frac{3 g}{L}}"),
        (call("cos", theta0) ** 2, r"\cos^{2} \theta_{0}"),
        (call("sin", 2 * theta), r"\sin\left(2 \theta\right)"),
        ((a / b) ** 2, r"\left(\frac{a}{b}\right)^{2}"),
        (a * (b + c), r"a \left(b + c\right)"),
        (Sum((a, Negative(Sum((b, c))))), r"a - \left(b + c\right)"),
        (call("abs", x), r"\left|x\right|"),
        (Product((n(2), n(3))), r"2 \cdot 3"),
    ],
)
def test_latex(formula: Formula, latex: str) -> None:
    assert to_latex(formula) == latex


@pytest.mark.parametrize(
    ("formula", "text"),
    [
        (K * SUMMED, "(M/R²) ∫[0 → R] r³ dr"),
        (-(K * SUMMED), "−(M/R²) ∫[0 → R] r³ dr"),
        (K * SUMMED + Symbol("b"), "(M/R²) ∫[0 → R] r³ dr + b"),
        (K * SUMMED * Symbol("q"), "(M/R²) (∫[0 → R] r³ dr) q"),
        (K * SUMMED / Symbol("c"), "((M/R²) ∫[0 → R] r³ dr)/c"),
        ((K * SUMMED) ** 2, "((M/R²) ∫[0 → R] r³ dr)²"),
    ],
)
def test_a_differential_closes_what_it_is_the_last_of(formula: Formula, text: str) -> None:
    """k ∫ f dx needs no brackets where nothing more could be taken into it; it reads back the same."""
    assert to_text(formula) == text and parse(text) == formula
