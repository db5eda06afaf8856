"""Units as students write them: every spelling is the unit that it names, held against an independent library; letters come first."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from pathlib import Path

import pint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.reading.answers import read_line
from rotsolve.grading.reading.records import AnswerError, Names
from rotsolve.grading.reading.unit_names import POWERS, SYMBOLS, unit_called
from rotsolve.grading.verdict import RIGHT, UNDECIDED, WRONG, JudgedPart, Paper
from rotsolve.pipeline import solve

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
ENGLISH = {
    name: symbol for name, symbol in SYMBOLS.items() if name not in ("deka", "hekto", "dezi", "zenti", "mikro", "piko")
}
NAMES = {  # of the singular the plural and the symbol
    "metre": ("metres", "m"),
    "meter": ("meters", "m"),
    "gram": ("grams", "g"),
    "second": ("seconds", "s"),
    "newton": ("newtons", "N"),
    "joule": ("joules", "J"),
    "watt": ("watts", "W"),
    "pascal": ("pascals", "Pa"),
    "hertz": ("hertz", "Hz"),
    "litre": ("litres", "L"),
    "radian": ("radians", "rad"),
}
BARE = Names.of([], asked="x")


@cache
def registry() -> pint.UnitRegistry[Fraction]:
    return pint.UnitRegistry(non_int_type=Fraction)


def in_si(unit: str) -> Fraction:
    """The factor of a unit to SI, by pint."""
    return Fraction(registry().Quantity(Fraction(1), unit).to_base_units().magnitude)


def factor_read(text: str) -> Fraction:
    """The factor of the unit behind the only number of a line."""
    (reading,) = read_line(text, BARE)
    assert reading.unit is not None and not reading.unit.pi_power
    return reading.unit.scale


def plain_factor(symbol: str, prefix: str) -> Fraction:
    return Fraction(1, 1000 if symbol in ("g", "L") else 1) * Fraction(10) ** POWERS[prefix]


@given(
    st.sampled_from([*ENGLISH]),
    st.sampled_from([*NAMES]),
    st.sampled_from(["plain", "plural", "symbol", "capital"]),
    st.integers(1, 999),
)
@settings(max_examples=300, deadline=None)
def test_every_unit_takes_every_prefix(prefix: str, name: str, form: str, number: int) -> None:
    plural, symbol = NAMES[name]
    typed = {
        "plain": prefix + name,
        "plural": prefix + plural,
        "symbol": ENGLISH[prefix] + symbol,
        "capital": (prefix + plural).capitalize(),
    }[form]
    if typed in ("Grad", "cW", "qm"):  # a degree and a square metre in German, and clockwise
        return
    expected = plain_factor(symbol, ENGLISH[prefix])
    assert factor_read(f"{number} {typed}") == expected
    if prefix not in ("quetta", "ronna", "ronto", "quecto"):  # younger than some versions of pint
        assert expected == in_si(prefix + name.replace("metre", "meter"))


PER = [("metres", "m"), ("km", "km"), ("kilometres", "km"), ("cm", "cm"), ("feet", "ft"), ("miles", "mile")]
TIMES = [
    ("second", "s"),
    ("s", "s"),
    ("hour", "hour"),
    ("h", "hour"),
    ("hr", "hour"),
    ("min", "minute"),
    ("minute", "minute"),
]


@pytest.mark.parametrize(("way", "way_symbol"), PER)
@pytest.mark.parametrize(("time", "time_symbol"), TIMES)
def test_a_speed_in_every_spelling(way: str, way_symbol: str, time: str, time_symbol: str) -> None:
    expected = in_si(f"{way_symbol}/{time_symbol}")
    for text in (
        f"5 {way}/{time}",
        f"5 {way} per {time}",
        f"5 {way} / {time}",
        f"5 {way} {time}^-1",
        f"5 {way} pro {time}",
    ):
        assert factor_read(without(text)) == expected, text


def without(text: str) -> str:
    from rotsolve.grading.reading.lines import without_asides

    return without_asides(text, BARE)


@pytest.mark.parametrize(
    ("typed", "unit"),
    [
        ("mps", "m/s"),
        ("kmh", "km/hour"),
        ("km/h", "km/hour"),
        ("kph", "km/hour"),
        ("kmph", "km/hour"),
        ("km/hr", "km/hour"),
        ("cc", "cm**3"),
        ("ml", "mL"),
        ("l", "L"),
        ("Å", "angstrom"),
        ("Ångström", "angstrom"),
        ("angstroms", "angstrom"),
        ("µg", "microgram"),
        ("μg", "microgram"),
        ("ug", "microgram"),
        ("Mg", "megagram"),
        ("cg", "centigram"),
        ("pm", "picometer"),
        ("mNm", "millinewton*meter"),
        ("kNm", "kilonewton*meter"),
        ("newton-metres", "newton*meter"),
        ("N-m", "newton*meter"),
        ("Newtonmeter", "newton*meter"),
        ("Zentimeter", "cm"),
        ("Millisekunden", "ms"),
        ("Sekunden", "s"),
        ("Minuten", "minute"),
        ("Stunden", "hour"),
        ("Kilogramm", "kg"),
        ("Gramm", "gram"),
        ("Tonnen", "tonne"),
        ("Kilojoule", "kJ"),
        ("square metres", "m**2"),
        ("Quadratmeter", "m**2"),
        ("cubic centimetres", "cm**3"),
        ("Kubikzentimeter", "cm**3"),
        ("sec", "s"),
        ("m/sec", "m/s"),
        ("m/sec²", "m/s**2"),
        ("metres per second squared", "m/s**2"),
        ("Meter pro Sekunde zum Quadrat", "m/s**2"),
        ("metres/second/second", "m/s**2"),
        ("m s^-1", "m/s"),
        ("kg·metre²", "kg*m**2"),
    ],
)
def test_short_forms_and_german_names(typed: str, unit: str) -> None:
    assert factor_read(without(f"5 {typed}")) == in_si(unit)


@pytest.mark.parametrize(
    "word", ["metric", "secondary", "kilo", "mm s m x", "metresper", "Kmh h h q", "newtonian", "hp", "yx"]
)
def test_what_names_no_unit_is_none(word: str) -> None:
    assert unit_called(word) is None
    with pytest.raises(AnswerError):
        read_line(f"5 {word}", BARE)


# in a scene


@cache
def judge(problem: str) -> Judge:
    return Judge(solve(PROBLEMS / f"{problem}.yaml"))


def part(problem: str, name: str, text: str) -> JudgedPart:
    return next(one for one in judge(problem).mark(Paper("one", {name: text})).parts if one.name == name)


SPELLINGS = {  # of the tension 10.889 N of a scene with the letters m, M, R and g
    "N": ("N", "newtons", "Newton", "kg m/s²", "kg·m/s^2", "J/m", "joules per metre", "Nm/m"),
    "kN": ("kN", "kilonewtons", "kilonewton", "Kilonewton"),
    "mN": ("mN", "millinewtons", "g m/s²", "grams metres per second squared"),
    "µN": ("µN", "μN", "uN", "micronewtons", "mg m/s²"),
    "MN": ("MN", "meganewton", "Mg km/s²"),
}
SIZES = {"N": 1.0, "kN": 1e-3, "mN": 1e3, "µN": 1e6, "MN": 1e-6}


@pytest.mark.parametrize(("unit", "typed"), [(unit, typed) for unit, forms in SPELLINGS.items() for typed in forms])
def test_a_right_number_is_right_in_every_spelling_and_another_is_wrong(unit: str, typed: str) -> None:
    right, wrong = 10.8889 * SIZES[unit], 12.3 * SIZES[unit]
    assert part("pulleys/block-on-disc", "T", f"{right:.6g} {typed}").verdict.outcome == RIGHT
    assert part("pulleys/block-on-disc", "T", f"{wrong:.6g} {typed}").verdict.outcome == WRONG
    assert part("pulleys/block-on-disc", "T", f"{10 * right:.6g} {typed}").verdict.outcome == WRONG


@pytest.mark.parametrize(
    ("text", "outcome"),
    [
        ("m Mg/(2m + M)", RIGHT),  # M g, though Mg is a megagram too
        ("Mmg/(2m+M)", RIGHT),
        ("3 Mg", WRONG),
        ("5 Mg", WRONG),
        ("10.89 kg", WRONG),
        ("10.89 cc", WRONG),
        ("10.89 pm", WRONG),
        ("10.89 mps", WRONG),
        ("10.89 min", WRONG),
        ("10.89 Newtons of force", RIGHT),
        ("10.89 Newtons of Mg", UNDECIDED),
    ],
)
def test_letters_of_the_scene_come_first(text: str, outcome: str) -> None:
    assert part("pulleys/block-on-disc", "T", text).verdict.outcome == outcome


def test_what_can_be_letters_and_a_unit_is_said_to_be_read_as_letters() -> None:
    assert part("pulleys/block-on-disc", "T", "3 Mg").verdict.read_as == "3 M g"
    assert part("pulleys/block-on-disc-falling", "F", "3 Mg").verdict.read_as == "3 M g"
