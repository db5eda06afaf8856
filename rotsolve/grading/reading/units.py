"""Units: the unit behind a student's number; `Nm` and `degrees` are understood, where a scene file asks for `N m` and `deg`."""

from __future__ import annotations

import re
from functools import lru_cache

from rotsolve.algebra.formula import Formula, Number, Power, Product, Quotient, Symbol
from rotsolve.algebra.notation.limits import rational
from rotsolve.algebra.notation.tokens import FUNCTION_NAMES, FormulaError, Token, suggest
from rotsolve.algebra.units.quantities import MAX_UNIT_POWER, Factors
from rotsolve.algebra.units.unit_table import AMBIGUOUS, MEANT, UNITS, Unit
from rotsolve.grading.reading.grammar.forks import Forks
from rotsolve.grading.reading.grammar.formulas import read_formula
from rotsolve.grading.reading.grammar.runs import REMEMBERED

BASIC = ("kg", "m", "s", "N", "J", "W", "rad")  # before all others where units run into each other: `Nms` is N m s
MARKS = frozenset(("*", ".", "/", "^", "(", ")", "[", "]", "raised", "number", "-", "°", "%"))
PER_SECOND = {"ms": ("m", "s"), "rads": ("rad", "s")}  # before a negative power
_INDEXED = re.compile(r"([A-Za-zµμ]+?)([23])")  # m/s2


def looks_like_unit(tokens: list[Token]) -> bool:
    """Whether tokens, the last an `end`, can only be the words and marks of a unit."""
    return all(token.kind in MARKS or (token.kind == "name" and is_unit(token.text)) for token in tokens[:-1])


def is_unit(name: str) -> bool:
    """Whether a run of letters is one of units, and no function: sin is not s in."""
    return bool(split(name)) and name not in FUNCTION_NAMES


def read_unit(text: str, tokens: list[Token], forks: Forks) -> Unit:
    """The unit that tokens write, the last of which is an `end`."""
    words: list[Token] = []
    for token in tokens:
        if token.kind == ".":  # N.m is N·m
            words.append(Token("*", "*", token.start, token.end))
        else:
            words += _words(token, tokens, forks) if token.kind in ("name", "°", "%") else [token]
    factors = Factors()
    _collect(read_formula(text, words, frozenset(), forks), 1, factors, tokens)
    return factors.unit()


@lru_cache(REMEMBERED)
def split(name: str) -> tuple[str, ...]:
    """The units in a run of letters with the marks between them: `Nm` is N m, `m2` is m ^ 2; nothing if there is none."""
    if name in UNITS:
        return (name,)
    meant = MEANT.get(name) or MEANT.get(name.lower())
    if meant is not None:
        return tuple(re.findall(r"[A-Za-zµ]+|/", meant))
    powered = _INDEXED.fullmatch(name)
    if powered:
        before = split(powered[1])
        return (*before, "^", powered[2]) if before else ()
    return _side_by_side(name)


def _side_by_side(name: str) -> tuple[str, ...]:
    for units in (BASIC, UNITS):
        for unit in sorted(units, key=len, reverse=True):
            if name == unit:
                return (unit,)
            if name.startswith(unit) and len(name) <= 8:
                rest = _side_by_side(name.removeprefix(unit))
                if rest:
                    return (unit, *rest)
    return ()


def _words(token: Token, tokens: list[Token], forks: Forks) -> list[Token]:
    """The symbols of the units that a token names."""
    name = {"°": "deg"}.get(token.text, token.text)
    found = split(name)
    if not found:
        hint = f": {AMBIGUOUS[name]}" if name in AMBIGUOUS else ""
        message = f"`{name}` has several definitions{hint}" if hint else f"unknown unit `{name}`"
        raise FormulaError(message, token.start, token.end, None if hint else suggest(name, UNITS))
    if name in PER_SECOND and _negative(token, tokens) and forks.choose(True):  # ms⁻² is m s⁻², seldom 1/ms²
        found = PER_SECOND[name]
    return _spread(found, token)


def _spread(words: tuple[str, ...], token: Token) -> list[Token]:
    """Words that stand side by side in the columns of one token."""
    kinds = {"^": "^", "/": "/", "2": "number", "3": "number"}
    marks: list[Token] = []
    start = token.start
    for word in words:
        end = min(start + len(word), token.end) if word is not words[-1] else token.end
        marks.append(Token(kinds.get(word, "symbol"), word, start, end))
        start = end
    return marks


def _negative(token: Token, tokens: list[Token]) -> bool:
    """Whether a negative power follows."""
    after = tokens[tokens.index(token) + 1 :][:3]
    marks = "".join(mark.text for mark in after)
    return marks.startswith(("⁻", "^-", "^(-"))


def _collect(formula: Formula, power: int, factors: Factors, tokens: list[Token]) -> None:
    """The units of a product or quotient, to a power."""
    match formula:
        case Symbol(name):
            factors.add(UNITS[name], power)
        case Product(parts):
            for part in parts:
                _collect(part, power, factors, tokens)
        case Quotient(above, below):
            _collect(above, power, factors, tokens)
            _collect(below, -power, factors, tokens)
        case Power(base, exponent):
            value = rational(exponent)
            if value is None or value.denominator > 1 or not 0 < abs(value * power) <= MAX_UNIT_POWER:
                raise _fault(f"the power of a unit is a whole number from 1 to {MAX_UNIT_POWER}", tokens)
            _collect(base, power * value.numerator, factors, tokens)
        case Number(value) if value == 1:
            pass
        case _:
            raise _fault("this is no unit", tokens)


def _fault(message: str, tokens: list[Token]) -> FormulaError:
    return FormulaError(message, tokens[0].start, tokens[-2].end)
