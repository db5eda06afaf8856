"""Equality, textbook form and solving, by tables and against SymPy."""

from __future__ import annotations

import math
from fractions import Fraction
from math import isclose

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.exact.exponentials import one_logarithm
from rotsolve.algebra.exact.linear import NotLinear, Singular, solve_all, solve_linear
from rotsolve.algebra.exact.normal import coefficients, equal, is_zero, simplify
from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import (
    FUNCTIONS,
    ONE,
    PI,
    Call,
    Constant,
    Formula,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
    call,
)

ORDER = ("m", "M", "L", "R", "theta0", "g")
POSITIVE = frozenset({"m", "M", "m1", "m2", "R", "L", "g", "h", "k", "a", "b"})


class Letters(dict[str, object]):
    """Every unknown word is a symbol."""

    def __missing__(self, name: str) -> Formula:
        return Symbol(name)


def parse(text: str) -> Formula:
    """A formula from a Python expression in symbols; whole numbers are exact."""
    import re

    words = Letters(pi=PI, N=lambda n: Number(Fraction(n)))
    for name in FUNCTIONS:
        words[name] = lambda *args, name=name: call(name, *args)
    return eval(re.sub(r"(?<![\w.])(\d+)", r"N(\1)", text), {"__builtins__": {}}, words)


def show(f: Formula) -> str:
    """A plain text of a formula, for the tables."""

    def inner(node: Formula) -> str:
        fraction = isinstance(node, Number) and node.value.denominator > 1
        return f"({show(node)})" if isinstance(node, (Sum, Quotient)) or fraction else show(node)

    if isinstance(f, Number):
        return str(f.value)
    if isinstance(f, (Symbol, Constant)):
        return f.name
    if isinstance(f, Sum):
        return " + ".join(show(term) for term in f.terms).replace("+ -", "- ")
    if isinstance(f, Product):
        return " ".join(inner(factor) for factor in f.factors)
    if isinstance(f, Quotient):
        below = show(f.denominator)
        below = f"({below})" if isinstance(f.denominator, (Product, Sum, Quotient)) else below
        return f"{inner(f.numerator)}/{below}"
    if isinstance(f, Negative):
        return "-" + (show(f.operand) if isinstance(f.operand, Quotient) else inner(f.operand))
    if isinstance(f, Power):
        return f"{inner(f.base)}^{inner(f.exponent)}"
    assert isinstance(f, Call)
    return f"{f.function}({', '.join(show(argument) for argument in f.arguments)})"


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("m*g*2/(M+m*2)", "2 m g/(2 m + M)"),
        ("M*a/2", "(1/2) M a"),
        ("R*R*M/2", "(1/2) M R^2"),
        ("-3*g*cos(theta0)/2/L", "-3 g cos(theta0)/(2 L)"),
        ("3*g*cos(theta0)/2", "3 g cos(theta0)/2"),
        ("m*g-m*(2*m*g/(2*m+M))", "m M g/(2 m + M)"),
        ("2*m*g/(2*m*R+M*R)", "2 m g/(R (2 m + M))"),
        ("-(m1*g-m2*g)/(m1+m2)", "g (m2 - m1)/(m1 + m2)"),
        ("sqrt(3*g*(1+sin(theta0))/L)", "sqrt(3 g (1 + sin(theta0))/L)"),
        ("-sqrt(3)*sqrt(g)*sqrt((1+sin(theta0))/L)", "-sqrt(3 g (1 + sin(theta0))/L)"),
        ("sqrt(4*m*g*h/(2*m+M))", "2 sqrt(m g h/(2 m + M))"),
        ("sqrt(2*g*R*R*h)", "R sqrt(2 g h)"),
        ("sqrt(a/b)", "sqrt(a/b)"),
        ("sqrt(a*b)/b", "sqrt(a/b)"),
        ("2*pi*sqrt(L/g)", "2 pi sqrt(L/g)"),
        ("sqrt(12)", "2 sqrt(3)"),
        ("1/sqrt(2)", "sqrt(2)/2"),
        ("sqrt(x**2)", "abs(x)"),
        ("sqrt(R**2)", "R"),
        ("1-sin(x)**2", "cos(x)^2"),
        ("(1-cos(x))/sin(x)**2", "1/(1 + cos(x))"),
        ("g*sin(x)/cos(x)", "g tan(x)"),
        ("m*sin(x)**2+M*cos(x)**2", "m sin(x)^2 + M cos(x)^2"),
        ("sin(x)**2+cos(x)**2", "1"),
        ("sin(x-y)", "sin(x - y)"),
        ("sin(y-x)", "-sin(x - y)"),
        ("sin(x-y)-sin(x)*cos(y)", "-cos(x) sin(y)"),
        ("sin(2*x)+sin(x)", "(1 + 2 cos(x)) sin(x)"),
        ("cos(x-pi/2)", "sin(x)"),
        ("sin(pi/6)", "1/2"),
        ("tan(pi/3)", "sqrt(3)"),
        ("asin(1/2)", "pi/6"),
        ("asin(x*sqrt(a/b)/y)-asin(0)", "asin(x sqrt(a/b)/y)"),  # the sum is its first term, which is not done twice
        ("acos(-1/2)", "2 pi/3"),
        ("atan2(1,1)", "pi/4"),
        ("atan2(-1,-1)", "-3 pi/4"),
        ("sin(asin(x))", "x"),
        ("sin(-asin(x*sin(y)))", "-x sin(y)"),
        ("cos(acos(x))", "x"),
        ("tan(atan(x))", "x"),
        ("log(exp(x))", "x"),
        ("exp(-b*t)*exp(b*t)", "1"),
        ("exp(-b*t)", "exp(-b t)"),
        ("m1+m2/2", "m1 + (1/2) m2"),
        ("1/(1-x)-1/(1+x)", "2 x/(1 - x^2)"),
        ("3*g*cos(theta0)/2/L", "3 g cos(theta0)/(2 L)"),
        ("m*L*g**2*sqrt(3)", "sqrt(3) m L g^2"),
        ("sqrt(3)*g/4/m/L", "sqrt(3) g/(4 m L)"),
        ("L*sqrt(3)/3", "(1/3) sqrt(3) L"),
        ("sqrt(2)*sqrt(3)*sqrt(g)*a", "a sqrt(6 g)"),
        ("3*M*g*cos(x)*sin(x)/4", "(3/4) M g sin(x) cos(x)"),
        ("a*cos(x)+a*sin(x)", "a (sin(x) + cos(x))"),
        ("cos(2*x)*sin(2*x)*cos(y)*sin(y)", "sin(2 x) cos(2 x) sin(y) cos(y)"),
        ("M*R**2*u**2/2-M*R**2*v**2/2", "(1/2) M R^2 (u^2 - v^2)"),
        ("m*R**2*(b-a)*(a+b)", "m R^2 (b^2 - a^2)"),
        ("sqrt(a**2-b**2)", "sqrt(a^2 - b^2)"),
        ("4*L**2*x**2-g**2*y**2", "4 L^2 x^2 - g^2 y^2"),
        ("(a+b)**2*(a-b)", "(a - b) (a + b)^2"),
        ("m*(a**4-b**4)", "m (a^2 - b^2) (a^2 + b^2)"),
        ("M*R**2*2/5", "(2/5) M R^2"),
        ("2*g/3", "(2/3) g"),
        ("M*g*(1+3*sin(x)**2)/4", "(1/4) M g (1 + 3 sin(x)^2)"),
        ("5*g*sin(x)/7", "5 g sin(x)/7"),
        ("3*g/2", "3 g/2"),
        ("7*M*L**2/48", "7 M L^2/48"),
        ("M*L**2/12", "(1/12) M L^2"),
        ("2*sqrt(3*g*h)/3", "2 sqrt(g h/3)"),
        ("(48*m*u**2-7*M*x**2)/96", "(1/2) m u^2 - 7 M x^2/96"),
        ("u/2+x/2", "(1/2) (u + x)"),
        ("M/6+m/2", "(1/2) m + (1/6) M"),
        ("M*L**2/6+m*L**2/2", "(1/6) L^2 (3 m + M)"),
        ("m*(g+L*x*cos(theta0)/2)", "m (g + (1/2) L x cos(theta0))"),
        ("-m*(g+L*x/2)", "-m (g + (1/2) L x)"),
        ("m*(1+2*sin(x))/2", "(1/2) m (1 + 2 sin(x))"),
        ("3*m*(4*a+b)/4", "3 m (a + (1/4) b)"),
    ],
)
def test_textbook_form(text: str, shown: str) -> None:
    f = parse(text)
    g = simplify(f, order=ORDER, positive=POSITIVE)
    assert show(g) == shown
    assert equal(f, g, POSITIVE)


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("sin(2*x)", "2*sin(x)*cos(x)"),
        ("cos(3*x)", "4*cos(x)**3-3*cos(x)"),
        ("cos(x)**4-sin(x)**4", "cos(2*x)"),
        ("sin(x+y)*sin(x-y)", "sin(x)**2-sin(y)**2"),
        ("tan(x/2)", "sin(x)/(1+cos(x))"),
        ("sin(x+pi/6)", "sin(x)*sqrt(3)/2+cos(x)/2"),
        ("sin(pi/12)", "(sqrt(6)-sqrt(2))/4"),
        ("sqrt(a/b)", "sqrt(a*b)/b"),
        ("sqrt(a)*sqrt(b)", "sqrt(a*b)"),
        ("sqrt(x**2)", "abs(x)"),
        ("1/(sqrt(a)+sqrt(b))", "(sqrt(a)-sqrt(b))/(a-b)"),
        ("cos(asin(x))", "sqrt(1-x**2)"),
        ("sin(2*atan(x))", "2*x/(1+x**2)"),
        ("sin(atan2(y,x))", "y/sqrt(x**2+y**2)"),
        ("exp(x)**2*exp(-2*x)", "m/m"),
        ("log(a*b)-log(a)", "log(b)"),
        ("acos(x)", "pi/2-asin(x)"),
        ("atan(-x)", "-atan(x)"),
        ("sin(2*pi*k*t)", "2*sin(pi*k*t)*cos(pi*k*t)"),
    ],
)
def test_equal(left: str, right: str) -> None:
    assert equal(parse(left), parse(right), POSITIVE)


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("sqrt(x**2)", "x"),
        ("sin(x)", "cos(x)"),
        ("sqrt(a)", "a"),
        ("sin(x)**2", "1"),
        ("g/L", "L/g"),
        ("sin(2*x)", "2*sin(x)"),
        ("abs(x)", "-x"),
    ],
)
def test_not_equal(left: str, right: str) -> None:
    assert not equal(parse(left), parse(right), POSITIVE)


def test_division_by_zero() -> None:
    with pytest.raises(ZeroDivisionError):
        is_zero(parse("1/(sin(x)**2+cos(x)**2-1)"))


def test_the_angle_of_two_roots_is_written_whole() -> None:
    """A ratio of the sides may have a root of a half in it, which is no polynomial with whole coefficients."""
    side = parse("sqrt((8*m - M)*(M - 4*m)/2)/2")
    found = simplify(Call("atan2", (side, parse("2*m"))), positive=POSITIVE)
    ratio = evaluate(found, {"m": Number(Fraction(3, 20)), "M": Number(Fraction(4, 5))}).float
    assert isclose(ratio, math.atan2(math.sqrt(0.4 * 0.2 / 2) / 2, 0.3))


def test_huge_coefficients_are_left_unfactored() -> None:
    value = parse("(10**30*m**2 + M**2)*(m**2 + 10**30*M**2)/g")
    assert is_zero(simplify(value) - value)


def test_coefficients() -> None:
    found = coefficients(parse("(a*x**2+b*x)/m-c"), "x")
    assert found is not None
    assert [show(c) for c in found] == ["-c m", "b", "a"]
    assert coefficients(parse("sin(x)*a"), "x") is None
    assert solve_linear(parse("x**2-1"), "x") is None
    solved = solve_linear(parse("m*g-m*x-M*x/2"), "x", order=ORDER)
    assert solved is not None
    assert show(solved) == "2 m g/(2 m + M)"


ATWOOD = ("m1*g-T1-m1*a", "T2-m2*g-m2*a", "(T1-T2)*R-M*R**2/2*alpha", "a-R*alpha")


@pytest.mark.parametrize(
    ("asked", "shown"),
    [
        ("a", "2 g (m1 - m2)/(M + 2 m1 + 2 m2)"),
        ("T1", "g m1 (M + 4 m2)/(M + 2 m1 + 2 m2)"),
        ("alpha", "2 g (m1 - m2)/(R (M + 2 m1 + 2 m2))"),
    ],
)
def test_atwood(asked: str, shown: str) -> None:
    found = solve_all([parse(text) for text in ATWOOD], ["a", "T1", "T2", "alpha"], ORDER, POSITIVE)[asked]
    assert show(found) == shown


def test_system_with_angle() -> None:
    """The friction of a rolling disc on a slope; sin² + cos² = 1 must not hide a zero pivot."""
    texts = ("m*g*sin(x)-f-m*a", "f*R-m*R**2/2*alpha", "a-R*alpha", "Nn-m*g*cos(x)")
    equations = [parse(text) for text in texts]
    assert show(solve_all(equations, ["a", "f", "alpha", "Nn"], ORDER, POSITIVE)["f"]) == "(1/3) m g sin(x)"
    turned = [parse("u*cos(x)-v*sin(x)-p"), parse("u*sin(x)+v*cos(x)-q")]
    found = solve_all(turned, ["u", "v"])["u"]
    assert equal(found, parse("p*cos(x)+q*sin(x)"))
    singular = [parse("u*cos(x)**2+v-p"), parse("u*(1-sin(x)**2)+v-p")]
    with pytest.raises(Singular):
        solve_all(singular, ["u", "v"])


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("a*x**2+b*x+c", ["(-b + sqrt(b^2 - 4 a c))/(2 a)", "-(b + sqrt(b^2 - 4 a c))/(2 a)"]),
        ("m*x**2/2-m*g*h", ["sqrt(2 g h)", "-sqrt(2 g h)"]),
        ("x**2-2*x+1", ["1"]),
        ("(x-a)*(x-b)", ["a", "b"]),
        ("x**2+2*x", ["0", "-2"]),
        ("x**2-x-1", ["(1/2) (1 + sqrt(5))", "(1/2) (1 - sqrt(5))"]),
        ("sin(x)-1", []),
        ("3*a*x**2-b*x**3", ["0", "3 a/b"]),
        ("x**4-5*x**2+4", ["1", "-1", "2", "-2"]),
        ("x**3-x-1", []),
    ],
)
def test_polynomial_roots(text: str, shown: list[str]) -> None:
    found = solve_polynomial(parse(text), "x", positive=POSITIVE)
    assert [show(root) for root in found] == shown or all(
        is_zero(parse(text).substitute({"x": root}), POSITIVE) for root in found
    )


@pytest.mark.parametrize(
    "text",
    [
        "m*g*sin(x)-k*cos(x)",
        "k*sin(x)-1",
        "3*cos(x)-1",
        "a*sin(x)+b*cos(x)-1",
        "2*sin(x)**2-1",
        "cos(2*x)-1/2",
        "2*cos(x)-2*sin(x)**2+1",
        "sin(2*x+1)-1/2",
        "g*sin(x)-k*a*sin(x)*cos(x)",
    ],
)
def test_trig_roots(text: str) -> None:
    values = {"m": Fraction(1), "g": Fraction(10), "k": Fraction(7, 2), "a": Fraction(3), "b": Fraction(2)}
    f = parse(text)
    found = solve_trig(f, "x", positive=POSITIVE)
    assert found
    for root in found:
        value = evaluate(f, {**values, "x": root})
        assert abs(value.float) < 1e-12


def test_a_factor_without_closed_form_leaves_all_angles_open() -> None:
    assert solve_trig(parse("cos(x)*(2*cos(x)-1)*sin(x)"), "x", positive=POSITIVE)
    assert not solve_trig(parse("cos(x)*(sin(x)**3-3*sin(x)+1)*sin(x)"), "x", positive=POSITIVE)


def formulas() -> st.SearchStrategy[Formula]:
    """Random rational and trigonometric expressions in a few symbols."""
    leaves = st.one_of(
        st.sampled_from([Symbol(name) for name in ("a", "b", "x", "m", "g")]),
        st.integers(-4, 4).map(lambda n: Number(Fraction(n))),
    )

    def grow(inner: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
        pairs = st.tuples(inner, inner)
        return st.one_of(
            pairs.map(lambda p: p[0] + p[1]),
            pairs.map(lambda p: p[0] - p[1]),
            pairs.map(lambda p: p[0] * p[1]),
            pairs.map(lambda p: p[0] / (p[1] * p[1] + 1)),
            inner.map(lambda f: call("sin", f)),
            inner.map(lambda f: call("cos", f * 2)),
            inner.map(lambda f: call("sqrt", f * f * 3 + Symbol("a"))),
            inner.map(lambda f: f * f),
        )

    return st.recursive(leaves, grow, max_leaves=8)


VALUES = {"a": 1.3, "b": 0.7, "x": -0.45, "m": 2.1, "g": 9.8}


def number(f: Formula) -> float:
    return evaluate(f, {name: Fraction(str(value)) for name, value in VALUES.items()}, digits=15).float


@settings(max_examples=120, deadline=None)
@given(formulas())
@example(parse("sqrt(3*((m-3)**2 + sqrt(3*(a+m)**2+a))**2 + a)"))
@example(parse("sqrt(3*((m-3)**2 + sqrt(3*(a+a)**2+a))**2 + a)"))
@example(parse("sin(a/(1+a) + b/(1+a))"))
@example(parse("sin(sqrt(a+3*b**2/(1+a**2)**2)*sqrt(a+3*b**2/(1+a**2)**2))"))
def test_simplify_keeps_the_value(f: Formula) -> None:
    g = simplify(f, order=ORDER, positive=POSITIVE)
    assert isclose(number(f), number(g), rel_tol=1e-9, abs_tol=1e-12)
    assert equal(f, g, POSITIVE)


@settings(max_examples=40, deadline=None)
@given(formulas(), formulas())
def test_equality_agrees_with_numbers(f: Formula, g: Formula) -> None:
    assert equal((f + g) * (f - g), f * f - g * g, POSITIVE)
    close = isclose(number(f), number(g), rel_tol=1e-12, abs_tol=1e-13)
    if not close:
        assert not equal(f, g, POSITIVE)


@pytest.mark.exhaustive
@settings(max_examples=25, deadline=None)
@given(st.lists(st.lists(st.integers(-3, 3), min_size=4, max_size=4), min_size=3, max_size=3), st.integers(0, 2))
def test_systems_agree_with_sympy(rows: list[list[int]], asked: int) -> None:
    import sympy

    from rotsolve.algebra.sympy_bridge import to_sympy

    names = ["u", "v", "w"]
    letters = [[Symbol("p"), ONE, Symbol("q"), Symbol("p")], [ONE, Symbol("q"), ONE, Symbol("r")], [ONE] * 4]
    equations = []
    for row, letter in zip(rows, letters, strict=True):
        f: Formula = letter[3] * row[3]
        for name, n, c in zip(names, row, letter, strict=False):
            f = f + c * n * Symbol(name)
        equations.append(f)
    matrix, right = sympy.linear_eq_to_matrix([to_sympy(f) for f in equations], [to_sympy(Symbol(n)) for n in names])
    if matrix.det().expand() == 0:
        return
    found = solve_all(equations, names)[names[asked]]
    wanted = matrix.LUsolve(right)[asked]
    assert sympy.cancel(to_sympy(found) - wanted) == 0


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("log(2*(a+b)/(a+m)) + log((a+m)/(2*b))", "log((a+b)/b)"),
        ("log(a*b) - log(b) - x", "log(a) - x"),
        ("log(a) - x", "log(a) - x"),
        ("log(a + b) + log(a + m)", "log((a + b)*(a + m))"),
    ],
)
def test_logarithms_are_put_together_where_that_is_shorter(left: str, right: str) -> None:
    found = one_logarithm(parse(left), simplify)
    assert found == parse(right) if left == right else equal(found, parse(right), POSITIVE)
    assert sum(isinstance(node, Call) and node.function == "log" for node in found.walk()) == 1


@pytest.mark.parametrize(
    ("equations", "error"),
    [
        (("x+y-1", "2*x+2*y-2"), "y is not settled|x is not settled"),
        (("x+y-1", "x-y", "2*x-3"), "contradicts the others"),
        (("x+y-1", "2*x+2*y-3"), "equation 2 contradicts the others"),
        (("x+y-1",), "is not settled"),
        (("x*y-1", "x-y"), "not linear"),
        (("sin(x)+y", "x-y"), "not linear in x"),
    ],
)
def test_systems_that_do_not_settle_all_unknowns_are_refused(equations: tuple[str, ...], error: str) -> None:
    with pytest.raises((Singular, NotLinear), match=error):
        solve_all([parse(text) for text in equations], ["x", "y"])


def test_an_equation_that_says_nothing_new_does_no_harm() -> None:
    found = solve_all([parse("x+y-m"), parse("x-y"), parse("2*x+2*y-2*m")], ["x", "y"])
    assert all(is_zero(value - parse("m/2")) for value in found.values())


def test_the_argument_of_an_inverse_function_may_hold_a_root_of_a_quotient() -> None:
    """The radicand 1 − (b √(2/(2 b² + 3 m v²)))² is made of canonical roots alone."""
    one = parse("cos(a + asin(b*sqrt(2/(2*b**2 + 3*m*v**2))))")
    other = parse("cos(a)*sqrt(3*m*v**2/(2*b**2 + 3*m*v**2)) - sin(a)*b*sqrt(2/(2*b**2 + 3*m*v**2))")
    assert equal(simplify(one, positive=("a", "b", "m", "v")), simplify(other, positive=("a", "b", "m", "v")))


@pytest.mark.parametrize("inside", ["1/(2 + sqrt(3))", "2 - sqrt(3)", "3/4"])
def test_an_angle_of_a_root_that_no_table_knows_stays(inside: str) -> None:
    angle = parse(f"atan(sqrt({inside}))")
    assert simplify(angle).holds("atan")
    assert evaluate(simplify(angle) - angle, {}, digits=12).float == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize(
    "power", ["sqrt(2*m)*sqrt(F*u+F*x)", "sqrt(2*m)/sqrt(F*u-F*x)", "sqrt(m)*sqrt(3*F*u*x-2*u*u*x)/b"]
)
@pytest.mark.parametrize("known", ["m", "mb", "mFu"])
def test_the_factors_under_a_root_stand_in_one_product(power: str, known: str) -> None:
    """Whether or not the sign of each is known: √(2 F m (u + x)), never √(2 m (F (u + x)))."""
    f = parse(power)
    g = simplify(f, order=ORDER, positive=tuple(known))
    products = [node for node in g.walk() if isinstance(node, Product)]
    assert products and not any(isinstance(factor, Product) for node in products for factor in node.factors)
    numbers = {name: Number(Fraction(size)) for name, size in zip("mbFux", (2, 3, 17, 11, 7), strict=True)}
    assert evaluate(f - g, numbers).sign == 0


@pytest.mark.parametrize("power", ["sqrt((u+F*x)/(F*x-u))", "2*sqrt((u+F*x)/(F*x-u))", "3/sqrt(b/(u+x))"])
def test_a_logarithm_may_hold_a_root_of_a_quotient(power: str) -> None:
    """It is written as √(a/b), and what comes back out of it is made of canonical roots."""
    root, log = parse(power), parse(f"log({power})")
    assert is_zero(call("exp", log) - root)
    assert is_zero(call("exp", 2 * log) - root * root)
    numbers = {name: Number(Fraction(size)) for name, size in zip("bFux", (3, 17, 11, 7), strict=True)}
    assert evaluate(simplify(call("log", call("exp", root))) - root, numbers).float == pytest.approx(0, abs=1e-12)
    assert evaluate(simplify(log) - log, numbers).float == pytest.approx(0, abs=1e-12)
