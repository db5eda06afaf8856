"""Units: exact values, the words of the errors, and the units in which answers are printed."""

from __future__ import annotations

import math
import random
import time
from fractions import Fraction

import pytest

from rotsolve.algebra.formula import PI, ZERO, Formula, Negative, Number, Product, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.dimension import (
    ACCELERATION,
    ANGULAR_ACCELERATION,
    ANGULAR_MOMENTUM,
    ANGULAR_VELOCITY,
    ENERGY,
    FORCE,
    FREQUENCY,
    INERTIA,
    LENGTH,
    MASS,
    MOMENTUM,
    NONE,
    POWER,
    STIFFNESS,
    TIME,
    TORQUE,
    TORSION_STIFFNESS,
    Dimension,
)
from rotsolve.algebra.units.quantities import UnitError, number_in_unit, parse_quantity, parse_unit, unit_for
from rotsolve.algebra.units.unit_table import UNITS


def n(value: int | str) -> Number:
    return Number(Fraction(value))


@pytest.mark.parametrize(
    ("text", "value", "dimension", "unit"),
    [
        ("2 kg", n(2), MASS, "kg"),
        ("9.8 m/s^2", n("9.8"), ACCELERATION, "m/s²"),
        ("9.8 m/s²", n("9.8"), ACCELERATION, "m/s²"),
        ("9.8 m s⁻²", n("9.8"), ACCELERATION, "m/s²"),
        ("9.8 m/s/s", n("9.8"), ACCELERATION, "m/s²"),
        ("0.9 kg m^2", n("0.9"), INERTIA, "kg m²"),
        ("0.9 kg*m^2", n("0.9"), INERTIA, "kg m²"),
        ("0.9 kg·m²", n("0.9"), INERTIA, "kg m²"),
        ("120 rev/min", Product((n(4), PI)), ANGULAR_VELOCITY, "rev/min"),
        ("120 rpm", Product((n(4), PI)), ANGULAR_VELOCITY, "rpm"),
        ("6 N m/s^2", n(6), TORQUE / TIME**2, "N m/s²"),
        ("30 deg", Product((n("1/6"), PI)), NONE, "°"),
        ("30°", Product((n("1/6"), PI)), NONE, "°"),
        ("-90 deg", Negative(Product((n("1/2"), PI))), NONE, "°"),
        ("−90°", Negative(Product((n("1/2"), PI))), NONE, "°"),
        ("0 deg", ZERO, NONE, "°"),
        ("½ rev", PI, NONE, "rev"),
        ("0.2 hp_textbook", n("149.2"), POWER, "hp_textbook"),
        ("1 hp_mechanical", n("745.69987158227022"), POWER, "hp_mechanical"),
        ("3/4 m", n("3/4"), LENGTH, "m"),
        ("3 / 4 m", n("3/4"), LENGTH, "m"),
        ("½ m", n("1/2"), LENGTH, "m"),
        ("1e-3 kg", n("0.001"), MASS, "kg"),
        ("2×10^3 kg", n(2000), MASS, "kg"),
        ("2·10⁻³ kg", n("0.002"), MASS, "kg"),
        (".5 m", n("0.5"), LENGTH, "m"),
        ("2 Hz", n(2), FREQUENCY, "Hz"),
        ("5/s", n(5), FREQUENCY, "1/s"),
        ("5 1/s", n(5), FREQUENCY, "1/s"),
        ("36 km/h", n(10), LENGTH / TIME, "km/h"),
        ("2 J/(kg m)", n(2), ACCELERATION, "J/(kg m)"),
        ("2 m/s*kg", n(2), MOMENTUM, "m kg/s"),
        ("20 %", n("0.2"), NONE, "%"),
        ("2*kg", n(2), MASS, "kg"),
        ("  2 kg  ", n(2), MASS, "kg"),
        ("1 µm", n("1e-6"), LENGTH, "µm"),
        ("1 μm", n("1e-6"), LENGTH, "µm"),
        ("2 π rad", Product((n(2), PI)), NONE, "rad"),
        ("3 m/s^(1/2)", n(3), LENGTH / TIME ** Fraction(1, 2), "m/s^(1/2)"),
        ("90 °/s", Product((n("1/2"), PI)), FREQUENCY, "°/s"),
    ],
)
def test_quantities(text: str, value: Formula, dimension: Dimension, unit: str) -> None:
    quantity = parse_quantity(text)
    assert quantity.value == value
    assert quantity.dimension.matches(dimension)
    assert quantity.unit is not None
    assert quantity.unit.text == unit
    assert quantity.text == text


@pytest.mark.parametrize(
    ("text", "value"), [("5", n(5)), ("-1/3", n("-1/3")), ("π/6", Product((n("1/6"), PI))), ("-2 pi", -2 * PI)]
)
def test_pure_numbers(text: str, value: Formula) -> None:
    quantity = parse_quantity(text)
    assert (quantity.value, quantity.dimension, quantity.unit) == (value, NONE, None)


SEVERAL = "write hp_textbook (746 W), hp_mechanical (745.69987158227022 W) or hp_metric (735.5 W)"
ERRORS = [
    ("", "the quantity is empty", 0, 0),
    ("kg", "a quantity begins with a number, such as `2 kg`", 0, 2),
    ("nan kg", "a quantity begins with a number, such as `2 kg`", 0, 6),
    ("1 kgg", "unknown unit `kgg`; did you mean `kg`?", 2, 5),
    ("2 Kg", "unknown unit `Kg`; did you mean `kg`?", 2, 4),
    ("2 Nm", "unknown unit `Nm`; did you mean `N m`?", 2, 4),
    ("2 kgm^2", "unknown unit `kgm`; did you mean `kg m`?", 2, 5),
    ("2 RPM", "unknown unit `RPM`; did you mean `rpm`?", 2, 5),
    ("2 seconds", "unknown unit `seconds`; did you mean `s`?", 2, 9),
    ("2 zzz", "unknown unit `zzz`", 2, 5),
    ("0.2 hp", f"`hp` has several definitions: {SEVERAL}", 4, 6),
    (
        "12,5 kg",
        "`12,5` has a comma: a decimal number takes a point, `12.5`; did you mean `12.5 kg`?",
        0,
        4,
    ),
    ("12 000 kg", "two numbers side by side: `12 000 kg`", 0, 9),
    ("1.5.2 kg", "two numbers side by side: `1.5.2 kg`", 0, 8),
    ("9**9**9 m", "unexpected `9` in a unit", 3, 4),
    ("2 m2", "unexpected `2` in a unit: write a power as `^2`", 3, 4),
    ("2 m^13", "the power of a unit is a whole number from 1 to 12, or its negative", 3, 6),
    ("2 km^(1/2)", "a fractional power of `km` has no exact value: write it in SI units", 2, 4),
    ("2 m^(1/0)", "unexpected `^` in a unit", 3, 4),
    ("2 m//s", "unexpected `/` in a unit", 4, 5),
    ("2 m/", "the unit ends too early", 4, 4),
    ("2 m/s kg", "`m/s kg` can be read in two ways: put what is below the slash in brackets", 2, 8),
    ("2 N/m·s", "`N/m·s` can be read in two ways: put what is below the slash in brackets", 2, 7),
    ("1e500 m", "the exponent of ten is beyond ±400", 0, 5),
    ("1/0 m", "division by zero", 2, 3),
    ("1" * 61 + " m", "the number has more than 60 digits", 0, 61),
    ("1" * 500, "too long for a quantity: 500 characters, at most 200", 200, 500),
]


@pytest.mark.parametrize(("text", "message", "start", "end"), ERRORS, ids=[row[0][:12] for row in ERRORS])
def test_messages(text: str, message: str, start: int, end: int) -> None:
    began = time.process_time()
    with pytest.raises(UnitError) as caught:
        parse_quantity(text)
    assert time.process_time() - began < 2
    assert str(caught.value) == message
    assert (caught.value.start, caught.value.end) == (start, end)


def test_units_alone() -> None:
    assert parse_unit("kg").dimension == MASS
    assert parse_unit("1").text == ""
    assert parse_unit("1/s^2").dimension == FREQUENCY**2
    assert parse_unit("kg^2 m^4").text == "kg² m⁴"
    assert parse_unit("rev/min").factor == Product((n("1/30"), PI))
    assert parse_unit("kg m^2/s").latex == r"\mathrm{kg\,m^{2}/s}"
    assert parse_unit("deg").after("30") == "30°"
    assert parse_unit("kg m^2").after("3") == "3 kg m²"


@pytest.mark.parametrize("name", sorted(UNITS))
def test_every_unit_reads_and_prints(name: str) -> None:
    unit = parse_quantity(f"3 {name}").unit
    assert unit is not None
    assert parse_unit(unit.text) == unit
    assert number_in_unit(parse_quantity(f"3 {name}").value, unit) == n(3)


@pytest.mark.parametrize(
    ("dimension", "kind", "text"),
    [
        (NONE, None, ""),
        (ANGULAR_VELOCITY, None, "rad/s"),
        (ANGULAR_ACCELERATION, None, "rad/s²"),
        (ENERGY, None, "J"),
        (ENERGY, "torque", "N m"),
        (TORQUE, None, "N m"),
        (TORQUE, "energy", "J"),
        (INERTIA, None, "kg m²"),
        (MASS * LENGTH**2, None, "kg m²"),
        (ANGULAR_MOMENTUM, None, "kg m²/s"),
        (MOMENTUM, "impulse", "N s"),
        (POWER, None, "W"),
        (FORCE, None, "N"),
        (ACCELERATION, None, "m/s²"),
        (STIFFNESS, None, "N/m"),
        (TORSION_STIFFNESS, None, "N m/rad"),
        (FREQUENCY, "angular velocity", "rad/s"),
        (FREQUENCY, "frequency", "Hz"),
        (LENGTH**4 / TIME, None, "m⁴/s"),
    ],
)
def test_the_habits_of_the_field(dimension: Dimension, kind: str | None, text: str) -> None:
    unit = unit_for(dimension, kind)
    assert unit.text == text
    assert unit.factor == n(1)


def test_conversion_for_display() -> None:
    assert number_in_unit(Product((n("1/6"), PI)), parse_unit("deg")) == n(30)
    assert number_in_unit(2 * PI / 3, parse_unit("rev")) == n("1/3")
    assert number_in_unit(n(10), parse_unit("km/h")) == n(36)
    assert to_text(number_in_unit(Symbol("L"), parse_unit("cm"))) == "100 L"
    assert to_text(number_in_unit(Symbol("omega"), parse_unit("rpm"))) == "(30/π) ω"


def test_no_text_does_harm() -> None:
    source = random.Random(3)
    pieces = (*"0123456789.,+-−*/^()°%½²⁻³ π·×eE", " kg", " m", "s", "N", "rev", "min", "hp", "**", "pi", "10^", "\x00")
    read = 0
    for _ in range(20_000):
        text = "".join(source.choices(pieces, k=source.randint(1, 10)))
        try:
            quantity = parse_quantity(text)
        except UnitError as error:
            assert 0 <= error.start <= error.end <= len(text), text
            continue
        read += 1
        if quantity.unit is not None:
            assert parse_unit(quantity.unit.text) == quantity.unit, text
    assert read > 500


def test_against_pint() -> None:
    pint = pytest.importorskip("pint")
    registry = pint.UnitRegistry()
    # pint counts Hz in radians, rounds our metric and textbook horsepower otherwise, and has other words for some.
    theirs = {"hp_mechanical": "horsepower", "rev": "turn", "°": "degree", "grad": "grade", "%": "percent"}
    for name, unit in UNITS.items():
        if name not in ("Hz", "kHz", "MHz", "hp_metric", "hp_textbook"):
            si = unit_for(unit.dimension).text.replace("²", "**2").replace("³", "**3") or "dimensionless"
            factor = registry.Quantity(1, theirs.get(name, name)).to(si).magnitude
            assert factor == pytest.approx(float(unit.scale) * math.pi**unit.pi_power, rel=1e-12), name
