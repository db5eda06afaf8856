"""Numbers: a number with its unit as typed, and how many significant figures it has; `Nm` and `degrees` are understood, where a scene file
asks for `N m` and `deg`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Number, Power, Product, Quotient, Symbol
from rotsolve.algebra.notation.cursor import Forks
from rotsolve.algebra.notation.letters import from_superscript, superscripted
from rotsolve.algebra.notation.limits import rational
from rotsolve.algebra.notation.tokens import FUNCTION_NAMES, FormulaError, Token, suggest
from rotsolve.algebra.units.dimension import kind_of
from rotsolve.algebra.units.quantities import MAX_UNIT_POWER, UnitFactors
from rotsolve.algebra.units.unit_table import AMBIGUOUS, UNITS, Unit
from rotsolve.grading.reading.records import NUMBER, LineReading, echo
from rotsolve.grading.reading.unit_names import unit_called, units_called
from rotsolve.grading.reading.vocabulary import LONGEST_RUN, REMEMBERED, read_formula, run_meaning

BASIC = ("kg", "m", "s", "N", "J", "W", "rad")  # before all others where units run into each other: `Nms` is N m s
PREFIXED_FIRST = ("mN", "mJ", "mW")  # `mNm` is mN m, since nobody writes m N
KIND_OF_MARK = {"^": "^", "/": "/", "2": "number", "3": "number"}  # of what stands between units in a run
UNIT_MARKS = frozenset(("*", ".", "/", "^", "(", ")", "[", "]", "raised", "number", "-", "°", "%"))
PER_SECOND = {"ms": ("m", "s"), "rads": ("rad", "s")}  # before a negative power
_INDEXED = re.compile(r"([A-Za-zµμ]+?)([23])")  # m/s2
WEIGHT = "mg"  # seldom milligrams where both are letters
NO_NAMES: frozenset[str] = frozenset()


def looks_like_unit(tokens: list[Token]) -> bool:
    """Whether tokens, the last an `end`, can only be the words and marks of a unit."""
    return all(token.kind in UNIT_MARKS or (token.kind == "name" and is_unit_run(token.text)) for token in tokens[:-1])


def is_unit_run(name: str) -> bool:
    """Whether a run of letters is one of units, and no function: sin is not s in."""
    return bool(units_in_run(name)) and name not in FUNCTION_NAMES


def read_unit(text: str, tokens: list[Token], forks: Forks) -> Unit:
    """The unit that tokens write, the last of which is an `end`."""
    words: list[Token] = []
    for index, token in enumerate(tokens):
        if token.kind == "." or (token.kind == "-" and joins_units(tokens, index)):  # N.m and newton-metre are N·m
            words.append(Token("*", "*", token.start, token.end))
        else:
            words += _unit_symbols(token, tokens, forks) if token.kind in ("name", "°", "%") else [token]
    factors = UnitFactors()
    _collect_units(read_formula(text, words, frozenset(), forks), 1, factors, tokens)
    return factors.unit()


def joins_units(tokens: list[Token], index: int) -> bool:
    """Whether a mark stands between two words without a gap, as in newton-metre."""
    before, after = tokens[index - 1] if index else tokens[-1], tokens[index + 1]
    close = before.end == tokens[index].start and tokens[index].end == after.start
    return close and before.kind == after.kind == "name"


@lru_cache(REMEMBERED)
def units_in_run(name: str) -> tuple[str, ...]:
    """The units in a run of letters with the marks between them: `Nm` is N m, `m2` is m ^ 2; nothing if there is none."""
    if name in UNITS:
        return (name,)
    meant = units_called(name)
    if meant or unit_called(name) is not None:
        return meant or (name,)
    powered = _INDEXED.fullmatch(name)
    if powered:
        before = units_in_run(powered[1])
        return (*before, "^", powered[2]) if before else ()
    return _units_side_by_side(name)


def _units_side_by_side(name: str) -> tuple[str, ...]:
    for units in (PREFIXED_FIRST, BASIC, UNITS):
        for unit in sorted(units, key=len, reverse=True):
            if name == unit:
                return (unit,)
            if name.startswith(unit) and len(name) <= 8:
                rest = _units_side_by_side(name.removeprefix(unit))
                if rest:
                    return (unit, *rest)
    return ()


def _unit_symbols(token: Token, tokens: list[Token], forks: Forks) -> list[Token]:
    """The symbols of the units that a token names."""
    name = "deg" if token.text == "°" else token.text
    found = units_in_run(name)
    if not found:
        hint = f": {AMBIGUOUS[name]}" if name in AMBIGUOUS else ""
        message = f"`{name}` has several definitions{hint}" if hint else f"unknown unit `{name}`"
        raise FormulaError(message, token.start, token.end, None if hint else suggest(name, UNITS))
    if name in PER_SECOND and _negative_power_follows(token, tokens) and forks.choose(True):
        found = PER_SECOND[name]  # ms⁻² is m s⁻², seldom 1/ms²
    return _in_columns_of(found, token)


def _in_columns_of(words: tuple[str, ...], token: Token) -> list[Token]:
    """Words that stand side by side in the columns of one token."""
    marks: list[Token] = []
    start = token.start
    for word in words:
        end = min(start + len(word), token.end) if word is not words[-1] else token.end
        marks.append(Token(KIND_OF_MARK.get(word, "symbol"), word, start, end))
        start = end
    return marks


def _negative_power_follows(token: Token, tokens: list[Token]) -> bool:
    """Whether a negative power follows."""
    marks = "".join(mark.text for mark in tokens[tokens.index(token) + 1 :][:3])
    return marks.startswith(("⁻", "^-", "^(-"))


def _collect_units(formula: Formula, power: int, factors: UnitFactors, tokens: list[Token]) -> None:
    """The units of a product or quotient, to a power."""
    match formula:
        case Symbol(name):
            unit = unit_called(name)
            assert unit is not None
            factors.add(unit, power)
        case Product(parts):
            for part in parts:
                _collect_units(part, power, factors, tokens)
        case Quotient(above, below):
            _collect_units(above, power, factors, tokens)
            _collect_units(below, -power, factors, tokens)
        case Power(base, exponent):
            value = rational(exponent)
            if value is None or value.denominator > 1 or not 0 < abs(value * power) <= MAX_UNIT_POWER:
                raise _unit_fault(f"the power of a unit is a whole number from 1 to {MAX_UNIT_POWER}", tokens)
            _collect_units(base, power * value.numerator, factors, tokens)
        case Number(value) if value == 1:
            pass
        case _:
            raise _unit_fault("this is no unit", tokens)


def _unit_fault(message: str, tokens: list[Token]) -> FormulaError:
    return FormulaError(message, tokens[0].start, tokens[-2].end)


# numbers with units


class NumberAndUnit(Struct, frozen=True):
    """A line cut where a unit may begin: the number before it, and the unit (nothing but its `end` where there is none)."""

    number: tuple[Token, ...]
    unit: tuple[Token, ...]

    @property
    def has_unit(self) -> bool:
        return len(self.unit) > 1


def cut_at_unit(tokens: list[Token], names: frozenset[str]) -> NumberAndUnit:
    """The tokens before the first word that belongs to no number, and those from there on; `3/s` and `3 1/s` have 1/s."""
    at = unit_start(tokens, names)
    while at and at < len(tokens) - 1 and tokens[at - 1].kind in ("(", "["):
        at -= 1  # that of a fraction of units, or of [m/s]
    before, unit = tokens[:at], tokens[at:]
    if len(unit) > 1 and before and before[-1].kind == "/":
        slash = before.pop()
        one = Token("number", "1", slash.start, slash.start)
        unit = [one, slash, *unit]
        if len(before) > 1 and before[-1].text == "1" and before[-2].kind in ("number", "raised", "fraction"):
            before.pop()
    elif len(unit) > 1 and before and before[-1].kind == "*":
        before.pop()
    end = unit[0].start
    return NumberAndUnit((*before, Token("end", "", end, end)), tuple(unit))


def unit_start(tokens: list[Token], names: frozenset[str]) -> int:
    """The index of the first word that is no function or π, or of a sign of degrees outside of functions (sin 30° is a number).

    A function whose name is spelled by letters of the scene is none: `2 lg` with l and g.
    """
    called = False
    for index, token in enumerate(tokens):
        if token.kind == "name":
            letters = any(piece.kind == "symbol" for piece in run_meaning(token.text, names) or ())
            if letters or run_meaning(token.text, NO_NAMES) is None:
                return index
            called = called or token.text not in ("pi", "π")
        elif token.kind == "%" or (token.kind == "°" and not called):
            return index
    return len(tokens) - 1


def read_number_with_unit(text: str, parts: NumberAndUnit, forks: Forks) -> LineReading:
    """The number with its unit."""
    number = list(parts.number)
    value = read_formula(text, number, NO_NAMES, forks)
    unit = read_unit(text, list(parts.unit), forks) if parts.has_unit else None
    written, figures, zeros = decimal_literal(number)
    shown = written or echo(value)
    return LineReading(NUMBER, unit.after(shown) if unit else shown, value, unit, figures, zeros=zeros)


def decimal_literal(tokens: list[Token]) -> tuple[str, int | None, int]:
    """A decimal number as it is printed, its significant figures, and how many of these are zeros at the end of a whole number, which need
    not count: 1200 may be told to two figures. Nothing for what is no plain decimal.
    """
    if tokens[0].kind == "(" and tokens[-2].kind == ")":
        tokens = [*tokens[1:-2], tokens[-1]]
    sign = "−" if tokens[0].kind == "-" else ""
    plain = tokens[tokens[0].kind in ("-", "+") : -1]
    if not plain or plain[0].kind != "number":
        return "", None, 0
    mantissa, _, exponent = plain[0].text.lower().partition("e")
    power = exponent.replace("−", "-") or _exponent_of_ten(plain[1:])
    if power is None:
        return "", None, 0
    digits = mantissa.replace(".", "").lstrip("0")
    zeros = 0 if "." in mantissa else len(digits) - len(digits.rstrip("0"))
    raised = f"×10{superscripted(int(power))}" if power else ""
    return f"{sign}{mantissa}{raised}", max(len(digits), 1), zeros


def _exponent_of_ten(tokens: list[Token]) -> str | None:
    """The exponent in `*10^3`, '' where nothing is there, None where something else is."""
    kinds = [token.kind for token in tokens]
    if not tokens:
        return ""
    if kinds[:2] != ["*", "number"] or tokens[1].text != "10":
        return None
    if kinds[2:] == ["raised"]:
        return from_superscript(tokens[2].text)
    digits = "".join(token.text for token in tokens[3:] if token.kind not in "()")
    return digits if kinds[2:3] == ["^"] and digits.removeprefix("-").isdigit() else None


def could_be_number(parts: NumberAndUnit) -> bool:
    """Whether a number stands in front of what can be a unit; no bracket reaches from one into the other."""
    depth = sum((token.kind in "([") - (token.kind in ")]") for token in parts.number[:-1])
    return depth == 0 and len(parts.number) > 1 and (not parts.has_unit or looks_like_unit(list(parts.unit)))


def are_letters(tokens: Iterable[Token], names: frozenset[str]) -> bool:
    """Whether all words are letters of the scene."""
    return all(
        run_meaning(token.text, names) is not None if token.kind == "name" else token.kind not in ("°", "%")
        for token in tokens
    )


def is_strange_unit(parts: NumberAndUnit, names: frozenset[str]) -> bool:
    """Whether a number stands apart in front of words of which none begins with a letter of the scene: `12 hp`, `3.4 m/ss`."""
    words = [token.text for token in parts.unit if token.kind == "name"]
    plain = all(token.kind == "name" or token.kind in UNIT_MARKS for token in parts.unit[:-1])
    apart = parts.has_unit and len(parts.number) > 1 and parts.unit[0].start > parts.number[-2].end
    numeric = all(token.kind not in ("name", "√") for token in parts.number)
    strange = all(word in AMBIGUOUS or not begins_with_letter(word, names) for word in words)
    return plain and apart and numeric and strange


def begins_with_letter(word: str, names: frozenset[str]) -> bool:
    """Whether a letter of the scene stands first in a run, so that it is rather a product than a unit."""
    return any(run_meaning(word[:end], names) is not None for end in range(1, min(len(word), LONGEST_RUN) + 1))


def likely_number(parts: NumberAndUnit) -> bool:
    """Whether `12 m` is likelier a length than a product of letters: by a decimal point, or by a space before m, N or km, not before g.

    Of a rare unit, such as the megagram, the letters are likelier.
    """
    last, first = parts.number[-2], parts.unit[0]
    if any(token.text not in UNITS and unit_called(token.text) for token in parts.unit if token.kind == "name"):
        return False
    if any("." in token.text for token in parts.number):
        return True
    if first.start == last.end:
        return False
    words = [token.text for token in parts.unit if token.kind == "name"]
    long = any(len(word) > 1 and word in UNITS and word != WEIGHT for word in words)
    return long or all(word in UNITS and UNITS[word].scale == 1 for word in words)


def is_kind(unit: tuple[Token, ...]) -> bool:
    """Whether a unit is that of a known kind of quantity, or a power of one unit: N m and m⁴ are, m g is not."""
    names = [token.text for token in unit if token.kind == "name"]
    if len(names) == 1 and names[0] in UNITS and any(token.kind in ("raised", "^") for token in unit):
        return True
    try:
        return kind_of(read_unit("", list(unit), Forks()).dimension) is not None
    except FormulaError:
        return False
