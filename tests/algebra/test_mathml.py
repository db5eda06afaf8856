"""MathML: what a formula, a letter and a unit become, and that an XML parser reads all of it."""

from __future__ import annotations

from xml.etree.ElementTree import Element, fromstring

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rotsolve.algebra.formula import Call, Formula, Integral, Number, Symbol
from rotsolve.algebra.notation.mathml import letter_to_mathml, mathml, unit_to_mathml
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.units.unit_table import UNITS

CORE = {"math", "mrow", "mi", "mn", "mo", "mtext", "mspace", "mfrac", "msqrt", "msub", "msup", "msubsup"}
CHILDREN = {"mfrac": 2, "msub": 2, "msup": 2, "msubsup": 3}


def read(text: str) -> Element:
    """The element, once it is known to be MathML Core with as many children as each element takes."""
    root = fromstring(f"<math>{text}</math>")
    for element in root.iter():
        assert element.tag in CORE
        assert len(element) == CHILDREN.get(element.tag, len(element)), text
        assert element.get("mathvariant") in (None, "normal")
        assert len(element) or element.text or element.tag == "mspace", f"an empty {element.tag} in {text}"
    return root


def words(text: str) -> str:
    """What a reader sees, without the invisible times."""
    return "".join(read(text).itertext()).replace("\N{INVISIBLE TIMES}", " ")


@pytest.mark.parametrize(
    ("formula", "seen"),
    [
        ("m*g - T", "m g−T"),
        ("-3*g*cos(theta0)/(2*L)", "−3 gcosθ02 L"),
        ("(a + b)*c", "(a+b) c"),
        ("-(a + b)", "−(a+b)"),
        ("2*3^2*m", "2·32 m"),
        ("sin(a)*b", "(sina) b"),
        ("sqrt(a)*b", "a b"),
        ("sin(2*a)^2", "sin2(2 a)"),
        ("abs(a)", "|a|"),
        ("atan2(a, b)", "atan2(a,b)"),
        ("a^(1/2)", "a12"),
    ],
)
def test_formulas(formula: str, seen: str) -> None:
    assert words(mathml(parse(formula))) == seen


def test_a_fraction_has_its_bar_and_a_root_its_own() -> None:
    assert mathml(parse("a/b")) == "<mfrac><mi>a</mi><mi>b</mi></mfrac>"
    assert mathml(parse("sqrt(a)")) == "<msqrt><mi>a</mi></msqrt>"


def test_a_sign_in_front_is_the_first_of_its_row() -> None:
    """Else a browser would set it as the sign of a difference."""
    assert mathml(parse("-a")).startswith("<mrow><mo>−</mo>")


def test_an_integral_shows_its_bounds() -> None:
    integral = Integral(Symbol("x"), "x", Number(parse("0").value), Symbol("L"))  # type: ignore[attr-defined]
    assert words(mathml(integral)) == "∫0Lxdx"


@pytest.mark.parametrize(
    ("name", "seen"),
    [
        ("theta0", "<msub><mi>θ</mi><mn>0</mn></msub>"),
        ("a_end", "<msub><mi>a</mi><mtext>end</mtext></msub>"),
        ("H_x", "<msub><mi>H</mi><mi>x</mi></msub>"),
        ("omega'", "<msup><mi>ω</mi><mo>′</mo></msup>"),
        ("delta_theta", '<mrow><mi mathvariant="normal">Δ</mi><mi>θ</mi></mrow>'),
        ("rod.end.speed", "<mtext>rod.end.speed</mtext>"),
    ],
)
def test_letters(name: str, seen: str) -> None:
    assert letter_to_mathml(name) == seen
    read(seen)


@pytest.mark.parametrize(
    ("text", "seen"),
    [("kg m²/s", "kgm2/s"), ("1/(kg m)", "1/(kgm)"), ("s^(1/2)", "s1/2"), ("°", "°"), ("1/s²", "1/s2")],
)
def test_units(text: str, seen: str) -> None:
    assert words(unit_to_mathml(text)) == seen


@pytest.mark.parametrize("text", sorted({item.text for item in UNITS.values()}))
def test_every_unit_can_be_read(text: str) -> None:
    assert words(unit_to_mathml(text)) == text


NAMES = st.sampled_from(["a", "M", "theta0", "x_end", "delta_K1", "omega(t)", "mass", "rod.end"])
FORMULAS = st.recursive(
    NAMES.map(Symbol) | st.fractions(max_denominator=50).map(Number),
    lambda inner: st.one_of(
        st.tuples(inner, inner).map(lambda pair: pair[0] + pair[1]),
        st.tuples(inner, inner).map(lambda pair: pair[0] * pair[1]),
        st.tuples(inner, inner).map(lambda pair: pair[0] / (pair[1] + 1)),
        inner.map(lambda item: -item),
        st.tuples(inner, st.integers(2, 4)).map(lambda pair: pair[0] ** pair[1]),
        st.tuples(st.sampled_from(["sin", "sqrt", "abs", "log"]), inner).map(lambda pair: Call(pair[0], (pair[1],))),
    ),
    max_leaves=12,
)


@given(FORMULAS)
def test_every_formula_is_well_formed(formula: Formula) -> None:
    read(mathml(formula))
