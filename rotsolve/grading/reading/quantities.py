"""Quantities: numbers with units within a formula, `2/3 · 9.81 m/s² · sin 30°`, and a unit behind one, `2/3 g sin θ m/s²`.

They are looked for where a line is not right as a formula in the letters of the scene.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping

from msgspec.structs import replace

from rotsolve.algebra.formula import PI, Call, Formula, Number, Product, Quotient
from rotsolve.algebra.notation.cursor import Cursor, Forks
from rotsolve.algebra.notation.parse import HALF_TURN, Parser
from rotsolve.algebra.notation.tokens import FormulaError, Token
from rotsolve.algebra.units.dimension import NONE, Dimension, DimensionError, dimension_of, kind_of
from rotsolve.algebra.units.quantities import unit_for
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.grading.reading.answers import AnswerParser, answer_line
from rotsolve.grading.reading.lines import with_points
from rotsolve.grading.reading.numbers import (
    BASIC,
    KIND_OF_MARK,
    begins_with_letter,
    is_kind,
    is_unit_run,
    looks_like_unit,
    read_unit,
    units_in_run,
)
from rotsolve.grading.reading.records import FORMULA, NUMBER, LineReading, Names
from rotsolve.grading.reading.unit_names import unit_called, units_called
from rotsolve.grading.reading.vectors import CLOSING, OPENING, end_at, with_remarks
from rotsolve.grading.reading.vocabulary import StudentVocabulary, all_ways, read_formula, run_meaning
from rotsolve.grading.verdict import Remark

UNIT_MARK = "unit:"  # before the name of a unit where letters may be called the same
TRIG = ("sin", "cos", "tan")
BEFORE_UNIT = ("number", "fraction", "raised", ")", "]", "°", "symbol")
MOST_DIGITS = 2  # of a power that is typed without a mark
JOINS = ("/", "*", ".")
COUNTING = ("Hz",)  # units that SI units do not stand for

_TELLS = re.compile(
    r"\d[.,]\d|°|\\circ|(?:sin|cos|tan)\s*\(?\s*\d|[\s\[(](?:m|kg|rad|N|J|W|s)(?![A-Za-z_])|\d\s+[a-z]+[)\]]|-\d"
)
Dimensions = Mapping[str, Dimension]


def quantity_readings(text: str, names: Names, dimensions: Dimensions, known: bool = False) -> tuple[LineReading, ...]:
    """The readings of a line with units within its formula or behind it, and with degrees for the arguments of sin, cos and tan.

    `dimensions` are those of the letters; `known` says that the line is a formula in them, so that units in it are told by a decimal
    number, a function of a number, or a gap in front of them. Nothing where there is no such reading.
    """
    if known and _TELLS.search(text) is None:
        return ()
    try:
        line = answer_line(text, names)
        if line.polar is not None or any(token.kind in ("=", ";") for token in line.tokens):
            return ()
    except FormulaError:
        return ()
    found: list[LineReading] = []
    raised = with_typed_powers(line.tokens)
    ways: list[Callable[[Forks], LineReading]] = []
    if raised != line.tokens:
        ways.append(lambda forks: AnswerParser(replace(line, tokens=raised), forks).line())
    ways.append(lambda forks: _read_with_units(line.text, raised, names, dimensions, forks))
    for way in ways:
        try:
            read = all_ways(way, 3 * len(line.tokens))
        except FormulaError:
            continue
        found += [replace(one, cut=True) for one in read] if read.cut else read
    found += [degrees for reading in list(found) for degrees in readings_in_degrees(reading)]
    return tuple(replace(reading, direction=line.direction) for reading in found)


def _read_with_units(text: str, tokens: list[Token], names: Names, dimensions: Dimensions, forks: Forks) -> LineReading:
    """One way to read a line: a formula with its unit behind it, or with units in it."""
    tokens, remarks = with_points(tokens, forks)
    at = unit_start_behind(tokens, names.letters)
    if 0 < at < len(tokens) - 1 and forks.choose(True):
        reading = _before_unit(text, tokens, at, names, dimensions, forks)
    else:
        reading = _within(text, tokens, names, dimensions, forks)
    return with_remarks(reading, remarks)


def is_likely_unit(name: str) -> bool:
    """Whether a run of letters is one of units in a formula: h, t and d are rather letters that the scene does not have."""
    return is_unit_run(name) and (len(name) > 1 or name in BASIC)


def with_typed_powers(tokens: list[Token]) -> list[Token]:
    """The tokens with the powers that were typed without a mark: m s-2 is m s^(-2), 4.9·10-3 is 4.9·10^(-3), 4.9 10^3 is 4.9·10^3."""
    result: list[Token] = []
    rest = list(tokens)
    while rest:
        token = rest.pop(0)
        before = result[-1] if result else token
        if token.text == "10" and before.kind == "number" and rest[0].kind in ("^", "raised"):
            result.append(Token("*", "*", token.start, token.start))
        result.append(token)
        power = (token.kind == "name" and is_unit_run(token.text)) or (token.text == "10" and before.kind == "*")
        close = len(rest) > 2 and token.end == rest[0].start and rest[0].end == rest[1].start
        if power and close and rest[0].kind == "-" and rest[1].text.isdigit() and len(rest[1].text) <= MOST_DIGITS:
            minus, digits = rest.pop(0), rest.pop(0)
            start, end = token.end, digits.end
            result += [
                Token("^", "^", start, start),
                Token("(", "(", start, start),
                minus,
                digits,
                Token(")", ")", end, end),
            ]
    return result


# a unit behind a formula


def unit_start_behind(tokens: list[Token], letters: frozenset[str]) -> int:
    """Where the unit behind a formula begins; the end where there is none."""
    end = len(tokens) - 1
    bracketed = end > 0 and tokens[end - 1].kind in CLOSING
    start = index = end - bracketed
    while index:
        token = tokens[index - 1]
        if token.kind == "name" and is_likely_unit(token.text):
            start = index = index - 1
            before = tokens[index - 1] if index else token
            if before.kind in JOINS and index > 1 and tokens[index - 2].kind in ("name", "raised"):
                index -= 1
            elif not (before.kind == "name" and run_meaning(before.text, letters) is None):
                break
        elif token.kind == "raised" or (token.kind == "number" and tokens[index - 2].kind == "^"):
            index -= 1 if token.kind == "raised" else 2
        else:
            break
    if not bracketed:
        return start
    return start - 1 if start and tokens[start - 1].kind in OPENING and start < end - 1 else end


def _before_unit(
    text: str, tokens: list[Token], at: int, names: Names, dimensions: Dimensions, forks: Forks
) -> LineReading:
    """A formula with the unit that begins at a place. Where the formula measures the same, the unit is not needed; where it is a pure
    number times letters without dimension, the unit is its own; else the letters stand for numbers in SI units."""
    if not is_kind(tuple(tokens[at:])):
        raise FormulaError("this is no unit", tokens[at].start, tokens[-1].end)
    unit = read_unit(text, tokens[at:], forks)
    formula = names.meant(read_formula(text, [*tokens[:at], end_at(tokens[at])], names.letters, forks))
    if not formula.symbols():
        return _worked_out(text, tokens, formula * unit.factor, unit.dimension)
    own = _measured_dimension(formula, dimensions)
    said = f"a formula in letters has its unit by itself: {unit.text} is not needed"
    remark = Remark("form", (said,), tokens[at].start, tokens[-2].end)
    if own is not None and own.matches(unit.dimension):
        return LineReading(FORMULA, formula=formula, remarks=(remark,))
    return LineReading(FORMULA, unit.after(_typed(text, tokens[:at])), formula * unit.factor, unit)


# units within a formula


class QuantityVocabulary(StudentVocabulary, frozen=True):
    """Letters, and names of units where they stand behind a number; the symbol of a unit has a mark in front."""

    def meanings(self, cursor: Cursor) -> list[Token]:
        if not self.is_unit(cursor):
            return super().meanings(cursor)
        return [_unit_token(word, cursor.token) for word in units_in_run(cursor.token.text)]

    def is_unit(self, cursor: Cursor) -> bool:
        """Whether a name is a unit: it is one by its spelling and its place, and no letter of the scene, or may be either."""
        token, index = cursor.token, cursor.index
        closed = cursor.tokens[index + 1].kind in CLOSING and index > 0 and cursor.tokens[index - 1].kind == "number"
        if not (is_likely_unit(token.text) or (closed and is_unit_run(token.text))) or not behind_number(cursor):
            return False  # (500 g) is a mass
        assert isinstance(self.names, frozenset) and cursor.forks is not None
        if run_meaning(token.text, self.names) is not None:
            return cursor.forks.choose(cursor.tokens[index - 1].end < token.start or in_unit(cursor))
        known = unit_called(token.text) is not None or bool(units_called(token.text))
        return known or not begins_with_letter(token.text, self.names)


def behind_number(cursor: Cursor) -> bool:
    """Whether a number, a bracket or a unit stands in front, perhaps with a mark between."""
    before = cursor.tokens[cursor.index - 1] if cursor.index else None
    if before is None or before.kind in BEFORE_UNIT:
        return before is not None and (before.kind != "symbol" or before.text.startswith(UNIT_MARK))
    if before.kind in OPENING:  # 9.8 (m/s²)
        rest = cursor.tokens[cursor.index :]
        last = next((place for place, token in enumerate(rest) if token.kind in CLOSING), 0)
        number = cursor.index > 1 and cursor.tokens[cursor.index - 2].kind == "number"
        return number and looks_like_unit(rest[: last + 1])
    return before.kind in JOINS and in_unit(cursor)


def in_unit(cursor: Cursor) -> bool:
    """Whether the name of a unit stands before the mark in front, perhaps with its power."""
    index = cursor.index - 1 - (cursor.tokens[cursor.index - 1].kind in JOINS)
    while index > 0 and cursor.tokens[index].kind in ("raised", "number", "^"):
        index -= 1
    return cursor.tokens[index].text.startswith(UNIT_MARK)


def _unit_token(word: str, token: Token) -> Token:
    """A piece of a run of units in the columns of the run."""
    kind = KIND_OF_MARK.get(word, "symbol")
    return Token(kind, UNIT_MARK + word if kind == "symbol" else word, token.start, token.end)


def _within(text: str, tokens: list[Token], names: Names, dimensions: Dimensions, forks: Forks) -> LineReading:
    """A formula with units in it."""
    tokens = [Token("*", "*", token.start, token.end) if token.kind == "." else token for token in tokens]
    formula = Parser(text, list(tokens), QuantityVocabulary.of(names.letters), forks).formula()
    marked = [name for name in formula.symbols() if name.startswith(UNIT_MARK)]
    units = {name: unit for name in marked if (unit := unit_called(name.removeprefix(UNIT_MARK))) is not None}
    if any(word in unit.text for unit in units.values() for word in COUNTING):
        raise FormulaError("a number of turns stands by itself", tokens[0].start, tokens[-1].end)
    measured = _measured_dimension(formula, {**dimensions, **{name: unit.dimension for name, unit in units.items()}})
    if measured is None or (units and kind_of(measured) is None):
        raise FormulaError("its units do not fit together", tokens[0].start, tokens[-1].end)
    value = names.meant(formula.substitute({name: unit.factor for name, unit in units.items()}))
    if not value.symbols():
        return _worked_out(text, tokens, value, measured if units else None)
    if not units:
        return LineReading(FORMULA, formula=value)
    return LineReading(FORMULA, _typed(text, tokens), value, unit_for(measured))


def _worked_out(text: str, tokens: list[Token], value: Formula, dimension: Dimension | None) -> LineReading:
    """A number that is left to be worked out, in SI units."""
    unit: Unit | None = None if dimension is None or dimension == NONE else unit_for(dimension)
    return LineReading(NUMBER, _typed(text, tokens), value, unit)


def _measured_dimension(formula: Formula, known: Dimensions) -> Dimension | None:
    """What a formula measures; None where that is not known, or its parts do not fit together."""
    try:
        return dimension_of(formula, known)
    except DimensionError:
        return None


def _typed(text: str, tokens: list[Token]) -> str:
    """The tokens as they were typed."""
    last = tokens[-2] if tokens[-1].kind == "end" else tokens[-1]
    return text[tokens[0].start : last.end].strip()


# degrees


def readings_in_degrees(reading: LineReading) -> Iterator[LineReading]:
    """The reading with sin(30) as sin 30°; nothing where no function is of a bare number."""
    if reading.formula is None or not reading.formula.holds(*TRIG):
        return
    turned: list[Number] = []

    def change(node: Formula) -> Formula:
        argument = node.arguments[0] if isinstance(node, Call) and node.function in TRIG else None
        if not isinstance(node, Call) or not isinstance(argument, Number):
            return node
        turned.append(argument)
        return Call(node.function, (Quotient(Product((argument, PI)), HALF_TURN),))

    formula = reading.formula.transform(change, *TRIG)
    if turned:
        angle = format(float(turned[0].value), "g")
        remark = Remark("unit", (f"{angle} is read as {angle}°: write the sign of degrees",))
        yield replace(reading, formula=formula, remarks=(*reading.remarks, remark))
