"""Reading formulas: the trees, the messages, and that no text whatever does harm."""

from __future__ import annotations

import contextlib
import random
import time
from fractions import Fraction

import pytest

from rotsolve.algebra.formula import (
    PI,
    Call,
    Formula,
    Integral,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
    call,
)
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.notation.tokens import FormulaError

LETTERS = "m M g a b c d T L R I E N S x alpha beta lambda theta theta0 omega m1 m2 a_end H_x t1 time"
NAMES = frozenset(LETTERS.split())


def n(value: int | str) -> Number:
    return Number(Fraction(value))


m, g, a, b, c, length, radius, x, theta = (Symbol(name) for name in ("m", "g", "a", "b", "c", "L", "R", "x", "theta"))
sin_theta = Call("sin", (theta,))

TREES: list[tuple[str, Formula]] = [
    ("m*g - T", Sum((Product((m, g)), Negative(Symbol("T"))))),
    ("L/2", Quotient(length, n(2))),
    ("a*b*c", Product((a, b, c))),
    ("a + b - c", Sum((a, b, Negative(c)))),
    ("a - (b - c)", Sum((a, Negative(Sum((b, Negative(c))))))),
    ("2 m g", Product((n(2), m, g))),
    ("2m", Product((n(2), m))),
    ("2mg", Product((n(2), m, g))),
    ("m1g", Product((Symbol("m1"), g))),
    ("2mg/(2m+M)", Quotient(Product((n(2), m, g)), Sum((Product((n(2), m)), Symbol("M"))))),
    ("3(a+b)", Product((n(3), Sum((a, b))))),
    ("(a)(b)", Product((a, b))),
    ("[a + b]²", Power(Sum((a, b)), n(2))),
    ("m g sin(theta)/2", Quotient(Product((m, g, sin_theta)), n(2))),
    ("1/2 m a^2", Product((Quotient(n(1), n(2)), m, Power(a, n(2))))),
    ("a/b c", Product((Quotient(a, b), c))),
    ("a/b/c", Quotient(Quotient(a, b), c)),
    ("-a^2", Negative(Power(a, n(2)))),
    ("(-a)^2", Power(Negative(a), n(2))),
    ("-a b", Negative(Product((a, b)))),
    ("a * -b", Product((a, Negative(b)))),
    ("-5", n(-5)),
    ("a^b^c", Power(a, Power(b, c))),
    ("a**2", Power(a, n(2))),
    ("a^-1 b", Product((Power(a, n(-1)), b))),
    ("a⁻¹²", Power(a, n(-12))),
    ("½ m", Product((n("1/2"), m))),
    ("1.5e-3", n("0.0015")),
    (".5", n("0.5")),
    ("a·b×c", Product((a, b, c))),
    ("a − b", Sum((a, Negative(b)))),
    ("θ₀", Symbol("theta0")),
    ("m₁", Symbol("m1")),
    ("m_1", Symbol("m1")),
    ("Hₓ", Symbol("H_x")),
    ("2πR", Product((n(2), PI, radius))),
    ("pi", PI),
    ("√x", Call("sqrt", (x,))),
    ("√(a b)", Call("sqrt", (Product((a, b)),))),
    ("√2 g", Product((Call("sqrt", (n(2),)), g))),
    ("sin θ", sin_theta),
    ("sinθ", sin_theta),
    ("m g sin θ/2", Quotient(Product((m, g, sin_theta)), n(2))),
    ("mgsin(θ)", Product((m, g, sin_theta))),
    ("sin² θ", Power(sin_theta, n(2))),
    ("sin^2 θ", Power(sin_theta, n(2))),
    ("sin(θ)^2", Power(sin_theta, n(2))),
    ("sin θ cos θ", Product((sin_theta, Call("cos", (theta,))))),
    ("ln x", Call("log", (x,))),
    ("arcsin(x)", Call("asin", (x,))),
    ("atan2(a, b)", Call("atan2", (a, b))),
    ("|a - b|", Call("abs", (Sum((a, Negative(b))),))),
    ("a |x| b", Product((a, Call("abs", (x,)), b))),
    ("||a||", Call("abs", (Call("abs", (a,)),))),
    ("I E N S", Product((Symbol("I"), Symbol("E"), Symbol("N"), Symbol("S")))),
    ("lambda beta", Product((Symbol("lambda"), Symbol("beta")))),
    ("∫[0 → t1] c time² d time", Integral(Product((c, Power(Symbol("time"), n(2)))), "time", n(0), Symbol("t1"))),
    ("∫[0 → t1] c q dq", Integral(Product((c, Symbol("q"))), "q", n(0), Symbol("t1"))),
    ("2 ∫[0 → 1] (d) d d + a", Sum((Product((n(2), Integral(Symbol("d"), "d", n(0), n(1)))), a))),
    ("integral(q^2, q, 0, 1)", Integral(Power(Symbol("q"), n(2)), "q", n(0), n(1))),
]


@pytest.mark.parametrize(("text", "tree"), TREES, ids=[row[0] for row in TREES])
def test_trees(text: str, tree: Formula) -> None:
    assert parse(text, NAMES) == tree


def test_without_a_table_any_name_will_do() -> None:
    assert parse("mg + ωt") == Sum((Symbol("mg"), Product((Symbol("omega"), Symbol("t")))))


def test_the_table_wins_over_functions_and_constants() -> None:
    assert parse("pi sin", {"pi", "sin"}) == Product((Symbol("pi"), Symbol("sin")))


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("rod.end.acceleration", "rod.end.acceleration"),
        ("drum.inner", "drum.inner"),
        ("rod.at( 3 * L / 4 )", "rod.at(3*L/4)"),
        ("rod.at(3 L/4).speed", "rod.at(3*L/4).speed"),
        ("pivot.force.x", "pivot.force.x"),
        ("mg", "mg"),
    ],
)
def test_paths(text: str, name: str) -> None:
    assert parse(text, NAMES, paths=True) == Symbol(name)


def test_paths_in_a_formula() -> None:
    tree = Sum((Product((n(2), Symbol("rod.end.speed"))), Negative(Call("sin", (Symbol("rod.angle"),)))))
    assert parse("2 rod.end.speed - sin rod.angle", NAMES, paths=True) == tree
    assert parse("m/rod.end", NAMES, paths=True) == Quotient(m, Symbol("rod.end"))


ERRORS = [  # text, whole message, columns
    ("", "the formula is empty", 0, 0),
    ("a +", "the formula ends too early", 3, 3),
    ("a + (b", "this `(` is never closed", 4, 5),
    ("a)", "this `)` closes nothing", 1, 2),
    ("a = b", "unexpected character `=`: a formula has no equals sign", 2, 3),
    ("a # b", "unexpected character `#`", 2, 3),
    ("a\x00", "unexpected character `U+0000`", 1, 2),
    ("a + thetta0", "unknown name `thetta0`; did you mean `theta0`?", 4, 11),
    ("2 Theta", "unknown name `Theta`; did you mean `theta`?", 2, 7),
    ("q", "unknown name `q`", 0, 1),
    ("rod.end", "unknown name `rod`", 0, 3),
    ("x.end", "unexpected `.`", 1, 2),
    ("12,5 m", "unexpected comma: a decimal number takes a point, `1.5`", 2, 3),
    ("2 3", "two numbers side by side: `2 3`", 0, 3),
    ("1.2.3", "two numbers side by side: `1.2.3`", 0, 5),
    ("2½", "two numbers side by side: `2½`", 0, 2),
    ("* a", "unexpected `*`", 0, 1),
    ("a × / b", "unexpected `/`", 4, 5),
    ("sin", "`sin` needs an argument", 0, 3),
    ("sin -θ", "`sin` needs an argument", 0, 3),
    ("atan2(a)", "`atan2` takes 2 arguments, not 1", 0, 8),
    ("sin(a, b)", "`sin` takes 1 argument, not 2", 0, 9),
    ("atan2 a", "`atan2` needs brackets: atan2(y, x)", 0, 5),
    ("sin θ²", "`sin θ²` can be read in two ways: write sin(…) with its argument in brackets", 0, 6),
    ("sin 2 θ", "`sin 2 θ` can be read in two ways: write sin(…) with its argument in brackets", 0, 7),
    ("sin mg", "`sin mg` can be read in two ways: write sin(…) with its argument in brackets", 0, 6),
    ("sin⁻¹ x", "`sin⁻¹` can be read in two ways: write asin(x) or 1/sin(x)", 0, 5),
    ("sin^-1(x)", "`sin^-` can be read in two ways: write asin(x) or 1/sin(x)", 0, 5),
    ("√x²", "`√x²` can be read in two ways: write √(…) with its argument in brackets", 0, 3),
    ("a/mg", "`/mg` can be read in two ways: write the denominator in brackets", 1, 4),
    ("x²^3", "`x²^` can be read in two ways: write brackets around the inner power", 0, 3),
    ("9^9^9", "a power of numbers in an exponent is not allowed", 0, 5),
    ("x^65", "the exponent is too large: at most 64", 0, 4),
    ("((x^9)^9)^9", "the exponent is too large: at most 64", 1, 8),
    ("1e401", "the exponent of ten is beyond ±400", 0, 5),
    ("1" * 61, "the number has more than 60 digits", 0, 61),
    ("∫ x", "an integral needs its bounds: ∫[a → b] f dx", 0, 1),
    ("∫[0 → 1] x", "an integral needs its variable: ∫[a → b] f dx", 0, 1),
]


@pytest.mark.parametrize(("text", "message", "start", "end"), ERRORS, ids=[repr(row[0])[:20] for row in ERRORS])
def test_messages(text: str, message: str, start: int, end: int) -> None:
    with pytest.raises(FormulaError) as caught:
        parse(text, NAMES)
    assert str(caught.value) == message
    assert (caught.value.start, caught.value.end) == (start, end)


def test_a_suggestion_is_apart_from_the_message() -> None:
    with pytest.raises(FormulaError) as caught:
        parse("thetta0", NAMES)
    assert (caught.value.message, caught.value.suggestion) == ("unknown name `thetta0`", "theta0")


def test_an_e_that_is_a_name_is_not_taken_for_a_power_of_ten() -> None:
    with pytest.raises(FormulaError, match="`2e-1` can be read in two ways"):
        parse("2e-1", {"e"})
    assert parse("2 e - 1", {"e"}) == Sum((Product((n(2), Symbol("e"))), n(-1)))


@pytest.mark.parametrize("text", ["a/b c", "3 g/2L", "a/2(b)"])
def test_strict_reading_refuses_what_follows_a_slash(text: str) -> None:
    parse(text, NAMES)
    with pytest.raises(FormulaError, match="can be read in two ways"):
        parse(text, NAMES, strict=True)


@pytest.mark.parametrize("text", ["1/2 m g", "a/(b c)", "(a/b) c", "a/b*c", "½ m g/L", "m g sin θ/2"])
def test_strict_reading_takes_what_is_plain(text: str) -> None:
    assert parse(text, NAMES, strict=True) == parse(text, NAMES)


HOSTILE = [
    "(" * 10_000,
    "(" * 1999,
    "-" * 1999,
    "a/" * 999 + "a",
    "x^" * 999 + "x",
    "√" * 1999,
    "sin " * 400 + "x",
    "|" * 1999,
    "m" * 2000,
    "mq" * 40,
    "(" * 59 + "x" + ")^1" * 59,
    "rod." * 400 + "a",
    "∫[0→" * 300,
    "9**9**9",
    "2^(9^9)",
    "(9^9)^9^9",
    "1e400" + "*1e400" * 300,
    "x^(1e400*1e400)",
    "integral(" * 200,
    "rod.at(" * 280,
]


@pytest.mark.parametrize("text", HOSTILE, ids=[text[:12] for text in HOSTILE])
@pytest.mark.parametrize("paths", [False, True])
def test_hostile_texts_cost_nothing(text: str, paths: bool) -> None:
    start = time.process_time()
    with contextlib.suppress(FormulaError):
        parse(text, NAMES, paths=paths)
    assert time.process_time() - start < 5


PIECES = (
    *"abcdgmxLRTIE0123456789.,()[]|+-*/^ √∫→½²³⁻¹₀₁ₓθωπ·×−_=#",
    *(
        "sin",
        "cos ",
        "sqrt(",
        "theta0",
        "m1",
        " d ",
        "d x",
        "e-3",
        "**",
        "atan2(",
        ", ",
        ".at(",
        "rod.end",
        "integral(",
    ),
)


def test_no_text_does_harm() -> None:
    """Random texts either read, and then print and read again, or are refused with columns inside the text."""
    source = random.Random(1)
    read = 0
    for _ in range(25_000):
        text = "".join(source.choices(PIECES, k=source.randint(1, 14)))
        names = source.choice([NAMES, NAMES, None])
        paths = source.random() < 0.3
        try:
            formula = parse(text, names, paths=paths)
        except FormulaError as error:
            assert 0 <= error.start <= error.end <= len(text), text
            assert error.message
            continue
        read += 1
        printed = to_text(formula)
        assert to_text(parse(printed, names, paths=paths)) == printed, (text, printed)
    assert read > 1000


def test_k_with_a_bracket_is_the_elliptic_integral_unless_it_is_a_letter() -> None:
    argument = Symbol("m")
    assert parse("2 K(m)", {"m"}) == 2 * call("ellipk", argument)
    assert parse("K(m)", {"m", "K"}) == Symbol("K") * argument
    assert parse(to_text(call("ellipk", argument)), {"m"}) == call("ellipk", argument)
    assert parse("ellipk(m)", None) == call("ellipk", argument)


@pytest.mark.parametrize("text", ["m.5", "2*m.25", "(m + M).5", "m_1.5"])
def test_a_decimal_stands_behind_nothing(text: str) -> None:
    """It is no factor that has been left out: `m.5` would else be half of m."""
    with pytest.raises(FormulaError, match=r"stands right behind"):
        parse(text, ["m", "M", "m_1"])


@pytest.mark.parametrize("text", ["m*.5", "m .5", ".5 m", "m + .5", "(.5 + m)"])
def test_a_decimal_may_begin_with_its_point(text: str) -> None:
    assert parse(text, ["m"])
