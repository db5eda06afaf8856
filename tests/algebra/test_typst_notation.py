"""Typst: what a formula, a letter and a unit become; that it compiles is seen on the pages of problems (tests/page/test_typst.py)."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rotsolve.algebra.formula import Call, Integral, Number, Symbol
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.notation.typst import name_to_typst, to_typst, typst_string, unit_in_typst
from rotsolve.algebra.units.unit_table import UNITS


@pytest.mark.parametrize(
    ("formula", "written"),
    [
        ("m*g - T", "m g - T"),
        ("-3*g*cos(theta0)/(2*L)", "-frac(3 g cos theta_0, 2 L)"),
        ("(a + b)*c", "(a + b) c"),
        ("-(a + b)", "-(a + b)"),
        ("2*3^2*m", "2 dot 3^2 m"),
        ("sin(2*a)^2", "sin^2(2 a)"),
        ("abs(a)", "abs(a)"),
        ("atan2(a, b)", 'op("atan2")(a, b)'),
        ("a^(1/2)", "a^(frac(1, 2))"),
        ("omega0^2", "omega_0^2"),
        ("5e199*x", "5 times 10^(199) x"),
        ("pi*R^2", "pi R^2"),
    ],
)
def test_formulas_in_typst(formula: str, written: str) -> None:
    assert to_typst(parse(formula)) == written


@pytest.mark.parametrize(
    ("name", "written"),
    [
        ("theta0", "theta_0"),
        ("a_end", 'a_"end"'),
        ("m12", "m_12"),
        ("a1_end", 'a_(1,"end")'),
        ("H_x", "H_x"),
        ("delta_K1", "Delta K_1"),
        ("omega'", "omega'"),
        ("x˙", "dot(x)"),
        ("x˙˙", "dot.double(x)"),
        ("omega(t)", "omega (t)"),
        ("dK", '"dK"'),
        ("rod.end.velocity", '"rod.end.velocity"'),
    ],
)
def test_letters_in_typst(name: str, written: str) -> None:
    assert name_to_typst(name) == written


def test_an_integral_has_its_bounds_and_its_differential() -> None:
    made = Integral(Symbol("F"), "x", Number(0), Symbol("L"))
    assert to_typst(made) == "integral_(0)^(L) F dif x"
    assert to_typst(Call("K", (Symbol("m"),))).endswith("(m)")


@pytest.mark.parametrize(
    ("unit", "written"),
    [
        ("kg m²/s", '"kg" thin "m"^2\\/"s"'),
        ("1/s", '1\\/"s"'),
        ("°", '"°"'),
        ("N m^(1/2)", '"N" thin "m"^(1/2)'),
        ("s⁻²", '"s"^(-2)'),
    ],
)
def test_units_in_typst(unit: str, written: str) -> None:
    assert unit_in_typst(unit) == written


@pytest.mark.parametrize("unit", UNITS)
def test_every_unit_keeps_its_letters(unit: str) -> None:
    assert unit in unit_in_typst(unit)


@given(st.text())
def test_a_string_ends_where_its_text_does(text: str) -> None:
    inner = typst_string(text)[1:-1].replace("\\\\", "").replace('\\"', "").replace("\\n", "")
    assert '"' not in inner and "\\" not in inner
