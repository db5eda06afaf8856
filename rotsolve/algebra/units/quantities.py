"""Units: `0.9 kg m²`, `120 rev/min`, `30°` to exact SI values, and back into the units in which a field prints.

Rules that are not obvious:
- units side by side are multiplied; one unit (with its power) or one bracket follows a slash: `N m/s^2` is (N m)/s²,
  `J/(kg m)` needs its bracket, and `m/s kg` is refused since it can be read in two ways;
- `3/4 m` is three quarters of a metre: a slash between two whole numbers belongs to the number;
- the values of degrees and revolutions hold π itself; `Hz` is cycles per second, 1/s, and never rad/s;
- a power may be a fraction in brackets, `s^(1/2)`, of a unit that is no multiple of another;
- a number may be a decimal, `3/4`, `½`, `2×10^3`, and may have a π: `2 π rad`, `π/6`.
"""

from __future__ import annotations

import re
from fractions import Fraction

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import PI, Formula, Negative, Number, Power, Product, Quotient, multiply
from rotsolve.algebra.notation.letters import FRACTIONS, from_superscript
from rotsolve.algebra.notation.tokens import NUMBER, FormulaError, read_number, suggest
from rotsolve.algebra.units.dimension import NONE, Dimension, Exponent, base_unit_text, kind_of, product_of_units
from rotsolve.algebra.units.unit_table import AMBIGUOUS, MEANT, ONE_UNIT, UNITS, Unit, power_of_pi

MAX_LENGTH = 200
MAX_UNIT_POWER = 12

_RAISED = "[⁻⁺]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+"
_WHOLE = r"[+\-−]?[0-9]+"
_SHARE = rf"{_WHOLE}(?:/[1-9])?"
_TOKEN = re.compile(
    rf"\s*(?:(?P<name>°|%|[A-Za-zµμ]+(?:_[a-z]+)?)|(?P<raised>{_RAISED})|(?:\^|\*\*)\s*(?P<power>{_WHOLE}|\({_SHARE}\))"
    r"|(?P<times>[*·×⋅])|(?P<mark>[/()])|(?P<other>\S))"
)
# What is rare is compiled when a text first needs it.
_COMMA = r"[+\-−]?[0-9]+,[0-9]+"
_TEN = rf"\s*[×x*·]\s*10(?:(?P<raised>{_RAISED})|(?:\^|\*\*)(?P<power>{_WHOLE}|\({_WHOLE}\)))"
_PI = r"\s*[*·]?\s*(?:pi(?![A-Za-z_])|π)(?:\s*/\s*(?P<under>[0-9]+))?"
_VALUE = re.compile(
    r"\s*(?P<sign>[+\-−–]?)\s*"
    rf"(?:(?P<top>[0-9]+)\s*/\s*(?P<bottom>[0-9]+)(?![0-9.eE])|(?P<number>{NUMBER})|(?P<glyph>[{''.join(FRACTIONS)}]))?"
)


class UnitError(FormulaError):
    """A text that is no quantity or no unit: what is wrong, in which columns, and perhaps what was meant."""


class UnitValue(Struct, frozen=True):
    """A number with a unit: its exact value in SI, its dimension, and the unit as written (None without one)."""

    value: Formula
    dimension: Dimension
    unit: Unit | None
    text: str


def parse_quantity(text: str) -> UnitValue:
    """The quantity that `text` writes: `2 kg`, `9.8 m/s²`, `-90 deg`, `3/4 m`, `5`."""
    _check_length(text)
    value, pi_power, end = _value(text)
    rest = text[end:]
    stripped = rest.lstrip()
    if not stripped:
        return UnitValue(power_of_pi(value, pi_power), NONE, None, text)
    if (one := re.match(r"1\s*(?=/\s*\D)", stripped)) and rest != stripped:  # 5 1/s, as its unit is printed
        stripped = stripped[one.end() :]
    at = len(text) - len(stripped)
    if stripped[0].isdigit() or stripped[0] in FRACTIONS or stripped[0] == ".":
        raise UnitError(f"two numbers side by side: `{text.strip()}`", 0, len(text))
    if stripped[0] in "*·" and not stripped.startswith("**"):
        at += 1
    unit = _read_unit(text, at, over_one=stripped[0] == "/")
    return UnitValue(power_of_pi(value * unit.scale, pi_power + unit.pi_power), unit.dimension, unit, text)


def parse_unit(text: str) -> Unit:
    """The unit that `text` writes, without a number: `kg m^2/s`."""
    _check_length(text)
    if re.fullmatch(r"\s*1?\s*", text):
        return ONE_UNIT
    start = re.match(r"\s*1\s*(?=/)", text)
    return _read_unit(text, start.end() if start else 0, over_one=start is not None)


def _check_length(text: str) -> None:
    if len(text) > MAX_LENGTH:
        raise UnitError(f"too long for a quantity: {len(text)} characters, at most {MAX_LENGTH}", MAX_LENGTH, len(text))


def _value(text: str) -> tuple[Fraction, int, int]:
    """The number in front: its rational part, its power of π, and where it ends."""
    comma = re.match(_COMMA, text.lstrip()) if "," in text else None
    if comma:
        at = len(text) - len(text.lstrip())
        point = comma[0].replace(",", ".")
        message = f"`{comma[0]}` has a comma: a decimal number takes a point, `{point}`"
        raise UnitError(message, at, at + comma.end(), text.strip().replace(",", ".", 1))
    match = _VALUE.match(text)
    assert match is not None
    bare = match["top"] is None and match["number"] is None and match["glyph"] is None
    pi = _pi(text, match.end())
    if bare and pi is None:
        message = "a quantity begins with a number, such as `2 kg`" if text.strip() else "the quantity is empty"
        raise UnitError(message, 0, len(text))
    value, end = (Fraction(1), match.end()) if bare else _literal(text, match)
    if pi is None:
        pi = _pi(text, end)
    if pi is not None:
        end = pi.end()
        if pi["under"]:
            value /= _denominator(pi["under"], pi.start("under"))
    return (-value if match["sign"] in tuple("-−–") else value), 1 if pi else 0, end


def _pi(text: str, start: int) -> re.Match[str] | None:
    return re.compile(_PI).match(text, start) if "π" in text or "pi" in text else None


def _literal(text: str, match: re.Match[str]) -> tuple[Fraction, int]:
    """The value of the literal without its sign, and where it ends; it may have a power of ten: 2×10^3."""
    if match["top"] is not None:
        top = _leading_number(match["top"], match.start("top"))
        return top / _denominator(match["bottom"], match.start("bottom")), match.end()
    if match["glyph"] is not None:
        return FRACTIONS[match["glyph"]], match.end()
    ten = re.compile(_TEN).match(text, match.end()) if text[match.end() :].lstrip()[:1] in tuple("×x*·") else None
    value = _leading_number(match["number"], match.start("number"))
    if ten is None:
        return value, match.end()
    return value * _leading_number(f"1e{_exponent(ten)}", ten.start()), ten.end()


def _leading_number(text: str, start: int) -> Fraction:
    try:
        return read_number(text, start)
    except FormulaError as error:
        raise UnitError(error.message, error.start, error.end) from None


def _denominator(digits: str, start: int) -> Fraction:
    value = _leading_number(digits, start)
    if not value:
        raise UnitError("division by zero", start, start + len(digits))
    return value


def _exponent(match: re.Match[str]) -> str:
    """The digits of an exponent, ^2 or ²."""
    raised: str | None = match["raised"]
    return from_superscript(raised) if raised else match["power"].strip("()").replace("−", "-")


class UnitFactors:
    """Collects the factors of a unit: name -> exponent, in the order written."""

    def __init__(self) -> None:
        self.exponents: dict[Unit, Exponent] = {}

    def add(self, unit: Unit, exponent: Exponent) -> None:
        self.exponents[unit] = self.exponents.get(unit, 0) + exponent

    def unit(self) -> Unit:
        scale, pi_power, dimension = Fraction(1), 0, NONE
        for unit, exponent in self.exponents.items():
            if isinstance(exponent, int):
                scale *= unit.scale**exponent
                pi_power += unit.pi_power * exponent
            dimension = dimension * unit.dimension**exponent
        text = product_of_units([(unit.text, exponent) for unit, exponent in self.exponents.items()])
        return Unit(text, scale, pi_power, dimension)


def _read_unit(text: str, start: int, *, over_one: bool) -> Unit:
    """The unit in text[start:], which begins with its slash if `over_one`."""
    tokens = [match for match in _TOKEN.finditer(text, start) if match.lastgroup]
    factors = UnitFactors()
    index, sign, in_bracket = 0, 1, False
    expected, after_slash = not over_one, False  # whether a unit must come; whether the last one stood below a slash
    while index < len(tokens):
        token = tokens[index]
        kind, at, end = str(token.lastgroup), token.start(str(token.lastgroup)), token.end()
        found = token[kind]
        index += 1
        if kind == "name":
            if after_slash and not expected and not in_bracket:
                raise _two_ways(text, start)
            exponent, index = _unit_exponent(tokens, index)
            unit = _named(found, at, end)
            if isinstance(exponent, Fraction) and (unit.scale != 1 or unit.pi_power):
                raise UnitError(f"a fractional power of `{found}` has no exact value: write it in SI units", at, end)
            factors.add(unit, sign * exponent)
            expected = False
        elif found == "(" and expected and sign < 0 and not in_bracket:
            in_bracket = True
        elif found == ")" and in_bracket and not expected:
            in_bracket, sign = False, 1
        elif found == "/" and not expected and not in_bracket:
            sign, expected, after_slash = -1, True, True
        elif kind == "times" and not expected:
            if after_slash and not in_bracket:
                if found != "*":
                    raise _two_ways(text, start)
                sign, after_slash = 1, False
            expected = True
        else:
            raise _unexpected(found, kind, at, end)
    if expected or in_bracket:
        raise UnitError("the unit ends too early" if tokens else "a unit is missing", len(text), len(text))
    return factors.unit()


def _unexpected(found: str, kind: str, start: int, end: int) -> UnitError:
    hint = ": write a power as `^2`" if found.isdigit() and kind == "other" else ""
    return UnitError(f"unexpected `{found}` in a unit{hint}", start, end)


def _two_ways(text: str, start: int) -> UnitError:
    unit = text[start:].strip()
    return UnitError(f"`{unit}` can be read in two ways: put what is below the slash in brackets", start, len(text))


def _unit_exponent(tokens: list[re.Match[str]], index: int) -> tuple[Exponent, int]:
    """The exponent that stands at `index`, 1 if none does, and the index after it."""
    if index == len(tokens) or tokens[index].lastgroup not in ("raised", "power"):
        return 1, index
    token = tokens[index]
    digits, _, below = _exponent(token).partition("/")
    if len(digits) > 4 or abs(int(digits)) > MAX_UNIT_POWER or int(digits) == 0:
        message = f"the power of a unit is a whole number from 1 to {MAX_UNIT_POWER}, or its negative"
        raise UnitError(message, token.start(), token.end())
    power = Fraction(int(digits), int(below or 1))
    return (int(power) if power.denominator == 1 else power), index + 1


def _named(name: str, start: int, end: int) -> Unit:
    if name in UNITS:
        return UNITS[name]
    if name in AMBIGUOUS:
        raise UnitError(f"`{name}` has several definitions: {AMBIGUOUS[name]}", start, end)
    suggestion = MEANT.get(name) or MEANT.get(name.lower()) or _side_by_side(name) or suggest(name, UNITS)
    raise UnitError(f"unknown unit `{name}`", start, end, suggestion)


def _side_by_side(name: str) -> str | None:
    """`kgm` as `kg m`: two units whose space is missing, the longest first, never two of a kind."""
    for cut in range(len(name) - 1, 0, -1):
        left, right = UNITS.get(name[:cut]), UNITS.get(name[cut:])
        if left and right and left.dimension != right.dimension:
            return f"{name[:cut]} {name[cut:]}"
    return None


def unit_for(dimension: Dimension, kind: str | None = None) -> Unit:
    """The SI unit by the habits of mechanics; `kind` tells what the dimension alone does not: "torque" is in N m."""
    found = kind_of(dimension, kind)
    written = replace(dimension, angle=max(dimension.angle, 0))  # of (kg m²)² nobody writes that it is per rad⁴
    return Unit(base_unit_text(written) if found is None else found.unit, Fraction(1), 0, dimension)


def number_in_unit(formula: Formula, unit: Unit) -> Formula:
    """The number that stands before `unit` where `formula` is the value in SI."""
    parts = _pi_multiple(formula)
    if parts is not None:
        return power_of_pi(parts[0] / unit.scale, parts[1] - unit.pi_power)
    return multiply(power_of_pi(1 / unit.scale, -unit.pi_power), formula)


def _pi_multiple(formula: Formula) -> tuple[Fraction, int] | None:
    """The formula as (k, n) for k · π^n; None if it is anything else."""
    match formula:
        case Number(value):
            return value, 0
        case Negative(operand):
            inner = _pi_multiple(operand)
            return None if inner is None else (-inner[0], inner[1])
        case Quotient(numerator, denominator):
            above, below = _pi_multiple(numerator), _pi_multiple(denominator)
            if above is None or below is None or not below[0]:
                return None
            return above[0] / below[0], above[1] - below[1]
        case Power(base, Number(value)) if base == PI and value.denominator == 1:
            return Fraction(1), int(value)
        case Product(factors):
            scale, power = Fraction(1), 0
            for factor in factors:
                inner = _pi_multiple(factor)
                if inner is None:
                    return None
                scale, power = scale * inner[0], power + inner[1]
            return scale, power
    return (Fraction(1), 1) if formula == PI else None
