"""Vectors: by components, `(3, 4) N` and `3i + 4j`, and by size and direction, `5 N at 53°` and `5 N, 53.1° above the horizontal`.

An angle without words is counted counterclockwise from the right. Where words leave open whether it is to the right or to the left,
both are read.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Call, Formula, Number, add, divide, multiply, negate
from rotsolve.algebra.notation.cursor import Forks
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.notation.tokens import FormulaError, Token
from rotsolve.algebra.units.dimension import ANGLE
from rotsolve.algebra.units.unit_table import UNITS, Unit, power_of_pi
from rotsolve.grading.reading.lines import with_points
from rotsolve.grading.reading.numbers import are_letters, looks_like_unit, read_unit
from rotsolve.grading.reading.records import FORMULA, NUMBER, VECTOR, LineReading
from rotsolve.grading.verdict import Remark

AXES = ("i", "j", "k")
OPENING, CLOSING = ("(", "[", "<"), (")", "]", ">")
MOST_COMPONENTS = 9

ReadValue = Callable[[list[Token]], LineReading]
# A comma between digits is a decimal one, and `rad/s` is no angle.
_HINT = re.compile(
    r"°|∠|@|deg|rad\b(?!\s*[/·*]|\s*s)|\\circ|\\angle|\bangle|\bat\s+[0-9.,]+\s*$|horizontal|vertical|axis"
)
# What is rare is compiled when a line first needs it.
_SPLIT = (
    r"(?:\s*(?<!\\)[,;])?\s*(?:\b(?:at|with|under|in)\b|@|∠|\\angle|(?<!\\)(?:;|(?<![0-9]),|,(?![0-9])))(?:\s*(?:an?\s+|the\s+)?(?:angle|direction)(?:\s+of)?\b)?\s*"
    r"(?=[^,;]*(?:°|∠|@|deg|rad\b|\\circ|horizontal|vertical|axis)|(?<!,)(?<!, )[0-9.,]+\s*$)"
)
_DIRECTION_WORD = (
    r"above|below|under|over|up(?:wards?)?|down(?:wards?)?|left|right|of|to|from|with|the|horizontal|vertical|negative|positive|and|on|side"
    r"|measured|axis|[+\-−]?[xy](?=[\s-]axis|$)|counter-?clockwise|anti-?clockwise|clockwise"
)
_PHRASE = rf"(?i:(?:(?<![A-Za-z\\])(?:{_DIRECTION_WORD})(?![A-Za-z])[\s,.$)\-]*)*)$"
COUNTER = ("counter", "anti", "counterclockwise", "anticlockwise")  # before "clockwise"
DEGREE, RADIAN = UNITS["deg"], UNITS["rad"]


def end_at(token: Token) -> Token:
    """An end that stands before a token."""
    return Token("end", "", token.start, token.start)


def closing_bracket(tokens: list[Token]) -> int:
    """The index of the bracket that closes the first one; −1 where the line begins with none."""
    if tokens[0].kind not in OPENING and tokens[0].text != "<":
        return -1
    level = 0
    for index, token in enumerate(tokens):
        level += (token.text in OPENING) - (token.text in CLOSING)
        if level == 0:
            return index
    return -1


def list_components(tokens: list[Token], forks: Forks) -> list[list[Token]]:
    """What stands in the brackets of a list: its components, each with an `end`; one alone where it is no list.

    Semicolons part them; else commas, of which those between digits may be decimal ones where others have a space behind.
    """
    level = 0
    marks: list[int] = []
    for index, token in enumerate(tokens):
        level += (token.text in OPENING) - (token.text in CLOSING)
        if level == 0 and token.kind in (",", ";"):
            marks.append(index)
    if any(tokens[index].kind == ";" for index in marks):
        marks = [index for index in marks if tokens[index].kind == ";"]
    else:
        tight = [index for index in marks if between_digits(tokens, index)]
        if tight and len(tight) < len(marks):
            marks = [index for index in marks if index not in tight]
        elif len(tight) == len(marks) == 1 and not forks.choose(True):
            marks = []
    starts = [0, *(index + 1 for index in marks)]
    ends = [*marks, len(tokens) - 1]
    return [[*tokens[start:end], end_at(tokens[end])] for start, end in zip(starts, ends, strict=True)]


def between_digits(tokens: list[Token], index: int) -> bool:
    """Whether the comma at a place stands between two digits without a space."""
    before, comma, after = tokens[index - 1], tokens[index], tokens[index + 1]
    return before.kind == after.kind == "number" and before.end == comma.start and comma.end == after.start


def read_list(text: str, tokens: list[Token], forks: Forks, read: ReadValue) -> LineReading | None:
    """A vector in brackets, perhaps with a unit behind them; None where the line is none."""
    last = closing_bracket(tokens)
    behind = tokens[last + 1 :]
    if last < 0 or all(token.kind not in (",", ";") for token in tokens[1:last]) or not looks_like_unit(behind):
        return None
    inside = list_components([*tokens[1:last], end_at(tokens[last])], forks)
    if len(inside) == 1:
        return None
    if len(inside) > MOST_COMPONENTS:
        raise FormulaError("a vector has two or three components", tokens[0].start, tokens[last].end)
    unit = read_unit(text, behind, forks) if len(behind) > 1 else None
    parts = []
    for component in inside:
        if len(component) == 1:
            raise FormulaError("a component is missing", component[0].start - 1, component[0].start)
        pointed, remarks = with_points(component, forks)
        parts.append(with_remarks(read(pointed), remarks))
    return vector_of(parts, unit)


def with_remarks(reading: LineReading, remarks: tuple[Remark, ...]) -> LineReading:
    return replace(reading, remarks=(*reading.remarks, *remarks)) if remarks else reading


def vector_of(parts: list[LineReading], unit: Unit | None) -> LineReading:
    """The vector with these components, all in the unit behind the bracket where that has one."""
    if unit is not None:
        parts = [part if part.unit else replace(part, unit=unit, written=unit.after(part.text)) for part in parts]
        inner = ", ".join(part.text.removesuffix(unit.text).strip() for part in parts)
        shown = unit.after(f"({inner})")
    else:
        shown = f"({', '.join(part.text for part in parts)})"
    remarks = tuple(remark for part in parts for remark in part.remarks)
    quiet = tuple(replace(part, remarks=()) for part in parts)
    return LineReading(VECTOR, shown, unit=unit, parts=quiet, remarks=remarks)


def by_axes(tokens: list[Token], letters: frozenset[str]) -> list[Token] | None:
    """The tokens with each i, j or k by itself as an `axis`; None where the line has none."""
    if not letters.isdisjoint(AXES[:2]):
        return None
    result: list[Token] = []
    for token in tokens:
        if token.kind == "name" and token.text[-1] in AXES and token.text[-1] not in letters:
            result += _split_axis(token, letters)
        else:
            result.append(token)
    return result if any(token.kind == "axis" for token in result) else None


def _split_axis(token: Token, letters: frozenset[str]) -> list[Token]:
    """`mgj` as mg and j; a token that has a meaning of its own stays."""
    if token.text in AXES:
        return [Token("axis", token.text, token.start, token.end)]
    front = Token("name", token.text[:-1], token.start, token.end - 1)
    if are_letters((token,), letters) or not are_letters((front,), letters):
        return [token]
    return [front, Token("axis", token.text[-1], token.end - 1, token.end)]


def read_axes(text: str, tokens: list[Token], forks: Forks, read: ReadValue) -> LineReading:
    """`3i + 4j` with a unit in its terms, behind it, or behind its bracket; the tokens have their axes told apart."""
    last = closing_bracket(tokens)
    if last > 0 and any(token.kind == "axis" for token in tokens[:last]) and looks_like_unit(tokens[last + 1 :]):
        behind = tokens[last + 1 :]
        tokens = [*tokens[1:last], end_at(tokens[last])]
    else:
        final = max(index for index, token in enumerate(tokens) if token.kind == "axis")
        behind = tokens[final + 1 :] if looks_like_unit(tokens[final + 1 :]) else tokens[-1:]
        tokens = [*tokens[: len(tokens) - len(behind)], end_at(behind[0])]
    unit = read_unit(text, behind, forks) if len(behind) > 1 else None
    found: dict[str, LineReading] = {}
    for term in axis_terms(tokens):
        axis, coefficient = axis_and_coefficient(term)
        if axis.text in found:
            raise FormulaError(f"two components along {axis.text}", axis.start, axis.end)
        pointed, remarks = with_points(coefficient, forks)
        found[axis.text] = with_remarks(read(pointed), remarks)
    wanted = AXES if "k" in found else AXES[:2]
    shared = next((part.unit for part in found.values()), None)
    nothing = LineReading(NUMBER, "0", ZERO, shared)
    return vector_of([found.get(axis, nothing) for axis in wanted], unit)


def axis_terms(tokens: list[Token]) -> list[list[Token]]:
    """The terms of a sum with their signs, each with an `end`."""
    level, cuts = 0, [0]
    for index, token in enumerate(tokens[:-1]):
        level += (token.text in OPENING) - (token.text in CLOSING)
        outermost = level == 0 and index and token.kind in ("+", "-")
        if outermost and tokens[index - 1].kind not in ("^", "/", "*", "+", "-"):
            cuts.append(index)
    ends = [*cuts[1:], len(tokens) - 1]
    return [[*tokens[start:end], end_at(tokens[end])] for start, end in zip(cuts, ends, strict=True)]


def axis_and_coefficient(term: list[Token]) -> tuple[Token, list[Token]]:
    """The axis of a term, and what stands before it (1 where nothing does)."""
    places = [index for index, token in enumerate(term) if token.kind == "axis"]
    if not places:
        raise FormulaError("this term has no direction: write i or j behind it", term[0].start, term[-1].end)
    if len(places) > 1:
        axis = term[places[1]]
        raise FormulaError("two directions in one term", axis.start, axis.end)
    axis = term[places[0]]
    rest = [token for token in term if token is not axis]
    if len(rest) > 1 and rest[-2].kind == "*":
        rest = [*rest[:-2], rest[-1]]
    if all(token.kind in ("+", "-", "end") for token in rest):
        rest = [*rest[:-1], Token("number", "1", axis.start, axis.start), rest[-1]]
    if rest[0].kind == "+":
        rest = rest[1:]
    return axis, rest


# by size and direction


class SizeAndAngle(Struct, frozen=True):
    """A line cut into a size, up to `end`, and an angle from `start` to `stop`, with the words behind it."""

    end: int
    start: int
    stop: int
    words: frozenset[str]

    def any(self, *words: str) -> bool:
        return not self.words.isdisjoint(words)


def cut_polar(text: str, start: int) -> SizeAndAngle | None:
    """Where size and angle stand in a line; None where it does not tell a direction by an angle."""
    if _HINT.search(text, start) is None:
        return None
    match = re.compile(_SPLIT).search(text, start)
    if match is None:
        return None
    size = text[start : match.start()]
    if not size.strip() or size.count("(") != size.count(")"):
        return None
    phrase = re.compile(_PHRASE).search(text, match.end())
    assert phrase is not None
    words = frozenset(re.findall(r"[a-z]+|[-−](?=[xy])", phrase[0].lower()))
    return SizeAndAngle(match.start(), match.end(), phrase.start(), words)


def counterclockwise_angle(angle: Formula, half: Formula, cut: SizeAndAngle, forks: Forks) -> Formula:
    """The angle counterclockwise from the right, where `half` is half a turn."""
    down = cut.any("below", "under", "down", "downward", "downwards")
    upright = cut.any("vertical", "y")
    placed = down or cut.any("above", "over", "up", "upward", "upwards")
    if not cut.words - {"of", "to", "the"} or (cut.any(*COUNTER, "positive", "+") and not placed and not upright):
        return angle
    if cut.any("clockwise") and not cut.any(*COUNTER):
        return negate(angle)
    if not placed:
        down = not forks.choose(True)
    right = cut.any("right", "positive", "+")
    left = cut.any("left", "negative", "-", "−") or (not right and not forks.choose(True))
    if upright:
        angle = add(divide(half, Number(Fraction(2))), negate(angle))
    turned = add(half, negate(angle)) if left else angle
    return negate(turned) if down else turned


def polar_vector(size: LineReading, angle: LineReading, cut: SizeAndAngle, forks: Forks) -> LineReading:
    """The vector of a size at an angle, by its components."""
    remarks = (*size.remarks, *angle.remarks)
    if angle.unit is not None and angle.unit.dimension != ANGLE:
        raise FormulaError("a direction is told by an angle, such as 53°", cut.start, cut.stop)
    if angle.kind == NUMBER and angle.unit is None:
        said = "an angle without a unit is read in degrees"
        remarks = (*remarks, Remark("unit", (said,), cut.start, cut.stop))
        angle = LineReading(NUMBER, DEGREE.after(angle.text), angle.formula, DEGREE, angle.figures)
    if size.kind not in (NUMBER, FORMULA) or size.formula is None or angle.formula is None:
        raise FormulaError("a vector is told by its size and one angle", 0, cut.end)
    unit = angle.unit or RADIAN
    way = counterclockwise_angle(angle.formula, power_of_pi(1 / unit.scale, 1 - unit.pi_power), cut, forks)
    shown = angle.unit.after(to_text(way)) if angle.unit is not None else to_text(way)
    parts = []
    for function in ("cos", "sin"):
        value = multiply(size.formula, Call(function, (multiply(way, unit.factor),)))
        text = to_text(value) if size.unit is None else size.unit.after(to_text(value))
        parts.append(LineReading(size.kind, text, value, size.unit, size.figures))
    written = f"{size.text} at {shown}"
    return LineReading(VECTOR, written, unit=size.unit, parts=tuple(parts), remarks=remarks, polar=(size, angle))
