"""Vectors: by components, `(3, 4) N` and `3i + 4j`, and by size and direction, `5 N at 53°` and `5 N, 53.1° above the horizontal`.

Unit vectors are i, j, k, e_x, e_y, e_z (x̂, ŷ, ẑ) or e₁, e₂, e₃; a factor may stand in front of a vector or behind it, `M a² (1, −1, 0)`.
An angle without words is counted counterclockwise from the right. Where words leave open whether it is to the right or to the left,
both are read.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection
from fractions import Fraction
from itertools import accumulate, combinations, pairwise

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Call, Formula, Negative, Number, add, divide, multiply, negate
from rotsolve.algebra.notation.cursor import Forks
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.notation.tokens import FormulaError, Token
from rotsolve.algebra.units.dimension import ANGLE
from rotsolve.algebra.units.unit_table import UNITS, Unit, power_of_pi
from rotsolve.grading.reading.lines import CALLED, with_points
from rotsolve.grading.reading.numbers import are_letters, looks_like_unit, read_unit
from rotsolve.grading.reading.records import FORMULA, NUMBER, VECTOR, LineReading
from rotsolve.grading.verdict import Remark

AXES = ("i", "j", "k")
BASES = (AXES, ("e_x", "e_y", "e_z"), ("e_1", "e_2", "e_3"))
_TYPED = {  # other spellings of unit vectors
    **{f"e{sub}": f"e_{plain}" for sub, plain in zip("₁₂₃", "123", strict=True)},
    **{f"e{plain}": f"e_{plain}" for plain in "123"},
    **{f"{axis}hat": axis for axis in AXES},
    **{f"{axis}hat": f"e_{axis}" for axis in "xyz"},
}
UNIT_VECTORS = {name: name for basis in BASES for name in basis} | _TYPED
PLACES = {name: place for basis in BASES for place, name in enumerate(basis)}
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
    r"(?=(?:[^,;]|(?<=[0-9]),(?=[0-9]))*(?:°|∠|@|deg|rad\b|\\circ|horizontal|vertical|axis)|(?<!,)(?<!, )[0-9.,]+\s*$)"
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


def list_components(tokens: list[Token], asked: int, forks: Forks) -> list[list[Token]]:
    """What stands in the brackets of a list: its components, each with an `end`; one alone where it is no list.

    Semicolons part them; else commas, of which those between digits may be decimal ones. `asked` is how many components the answer
    has, 0 where that is not known.
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
        decimal = decimal_commas(tokens, marks, asked, forks)
        marks = [index for index in marks if index not in decimal]
    starts = [0, *(index + 1 for index in marks)]
    ends = [*marks, len(tokens) - 1]
    return [[*tokens[start:end], end_at(tokens[end])] for start, end in zip(starts, ends, strict=True)]


def decimal_commas(tokens: list[Token], marks: list[int], asked: int, forks: Forks) -> Collection[int]:
    """The commas of a list that belong to numbers: as many as leave the components asked for, else those without a space where others
    have one.

    Which of them, the list leaves open, `(1,5,2)` for two components: the leftmost are tried first.
    """
    tight = [index for index in marks if between_digits(tokens, index)]
    if len(tight) == len(marks) == 1:
        return () if forks.choose(True) else tight
    counts = (3, 2) if asked == 2 and len(tight) == len(marks) else (asked,)  # in the plane, a third may be written
    surplus = [len(marks) + 1 - count for count in counts if asked and len(marks) < 2 * MOST_COMPONENTS]
    ways = [way for size in surplus if size >= 0 for way in combinations(tight, size) if make_numbers(tokens, way)]
    for way in ways:
        if way is ways[-1] or forks.choose(True):
            return way
    return tight if len(tight) < len(marks) else ()


def make_numbers(tokens: list[Token], commas: tuple[int, ...]) -> bool:
    """Whether numbers can have these commas within: one alone, or several between groups of three digits."""
    return all(index - 2 not in commas or len(tokens[index + 1].text.partition(".")[0]) == 3 for index in commas)


def between_digits(tokens: list[Token], index: int) -> bool:
    """Whether the comma at a place stands between two digits without a space."""
    before, comma, after = tokens[index - 1], tokens[index], tokens[index + 1]
    joined = before.kind == after.kind == "number" and before.end == comma.start and comma.end == after.start
    return joined and "." not in before.text


def read_list(text: str, tokens: list[Token], asked: int, forks: Forks, read: ReadValue) -> LineReading | None:
    """A vector in brackets, perhaps with a factor in front of or behind it, and a unit; None where the line is none.

    `asked` is how many components the answer has, 0 where that is not known.
    """
    front, listed, behind = around_list(tokens, asked)
    if listed and (behind[0].kind in ("/", "*") or not looks_like_unit(behind)):
        behind = (
            behind if behind[0].kind in ("/", "*") else [Token("*", "*", behind[0].start, behind[0].start), *behind]
        )
        whole = read_list(text, [*front[:-1], *listed, end_at(behind[0])], asked, forks, read)
        return None if whole is None else with_factor_in_front(read(with_one(behind)), whole)
    if not listed:
        return None
    if front:
        whole = read_list(text, [*listed, *behind], asked, forks, read)
        return None if whole is None else with_factor_in_front(read(with_one(front)), whole)
    inside = list_components([*listed[1:-1], end_at(listed[-1])], asked, forks)
    if len(inside) == 1:
        return None
    if len(inside) > MOST_COMPONENTS:
        raise FormulaError("a vector has two or three components", listed[0].start, listed[-1].end)
    unit = read_unit(text, behind, forks) if len(behind) > 1 else None
    parts = []
    for component in inside:
        if len(component) == 1:
            raise FormulaError("a component is missing", component[0].start - 1, component[0].start)
        pointed, remarks = with_points(component, forks)
        parts.append(with_remarks(read(pointed), remarks))
    return vector_of(parts, unit)


def around_list(tokens: list[Token], asked: int) -> tuple[list[Token], list[Token], list[Token]]:
    """A line as a factor in front of a list (with an `end`; nothing where there is none), the list in its brackets, and what is behind."""
    if all(token.kind not in (",", ";") for token in tokens):
        return [], [], tokens
    start = 0
    while start < len(tokens):
        last = start + closing_bracket(tokens[start:])
        listed = tokens[start : last + 1]
        while (
            len(listed) > 2 and closing_bracket(listed[1:]) == len(listed) - 3
        ):  # brackets round a matrix that has its own
            listed = listed[1:-1]
        front = tokens[: start - 1] if start and tokens[start - 1].kind == "*" else tokens[:start]
        if listed and is_listed(listed, front, asked):
            return [*front, end_at(tokens[start])] if front else [], listed, tokens[last + 1 :]
        start = max(start, last) + 1
    return [], [], tokens


def is_listed(tokens: list[Token], front: list[Token], asked: int) -> bool:
    """Whether commas or semicolons part what stands in brackets, behind a factor not the arguments of a function, nor a decimal number
    where not two components are asked for."""
    marks = [index for index, token in enumerate(tokens) if token.kind in (",", ";")]
    if not front:
        return bool(marks)
    called = front[-1].kind == "name" and front[-1].text.endswith(CALLED)
    decimal = asked != 2 and len(marks) == 1 and between_digits(tokens, marks[0])
    return bool(marks) and not called and not decimal


def with_factor_in_front(factor: LineReading, reading: LineReading) -> LineReading:
    """A vector or matrix with a factor in front of it."""
    if reading.parts:
        parts = tuple(with_factor_in_front(factor, part) for part in reading.parts)
        return replace(reading, parts=parts, written=f"{factor.text} {reading.text}")
    assert reading.formula is not None and factor.formula is not None
    formula, unit = multiply(factor.formula, reading.formula), reading.unit or factor.unit
    rounded = [one.figures for one in (factor, reading) if one.figures is not None and not is_whole(one.formula)]
    figures = min(rounded, default=None)
    kind = FORMULA if FORMULA in (factor.kind, reading.kind) else NUMBER
    return LineReading(kind, unit.after(to_text(formula)) if unit else "", formula, unit, figures)


def is_whole(value: Formula | None) -> bool:
    """Whether a number has no decimals, so that beside a factor it counts exactly."""
    number = value.operand if isinstance(value, Negative) else value
    return isinstance(number, Number) and number.value.denominator == 1


def with_one(tokens: list[Token]) -> list[Token]:
    """A sign alone, or what begins with `/` or `*`, with the 1 that goes without saying."""
    one = Token("number", "1", tokens[0].start, tokens[0].start)
    if tokens[0].kind in ("/", "*"):
        return [one, *tokens]
    return [*tokens[:-1], one, tokens[-1]] if all(token.kind in ("+", "-", "end") for token in tokens) else tokens


def with_remarks(reading: LineReading, remarks: tuple[Remark, ...]) -> LineReading:
    return replace(reading, remarks=(*reading.remarks, *remarks)) if remarks else reading


def vector_of(parts: list[LineReading], unit: Unit | None) -> LineReading:
    """The vector with these components, all in the unit behind the bracket, or behind the last of them where no other has one."""
    if unit is None and all(part.unit is None and part.kind == NUMBER for part in parts[:-1]):
        unit = parts[-1].unit
    if unit is not None:
        parts = [part if part.unit else replace(part, unit=unit, written=unit.after(part.text)) for part in parts]
        inner = ", ".join(part.text.removesuffix(unit.text).strip() for part in parts)
        shown = unit.after(f"({inner})")
    else:
        shown = f"({', '.join(part.text for part in parts)})"
    remarks = tuple(remark for part in parts for remark in part.remarks)
    quiet = tuple(replace(part, remarks=()) for part in parts)
    return LineReading(VECTOR, shown, unit=unit, parts=quiet, remarks=remarks)


def by_axes(tokens: list[Token], letters: frozenset[str], asked: int = 2) -> list[Token] | None:
    """The tokens with each unit vector by itself as an `axis`, called as in BASES; None where the line has none.

    Where three components are `asked`, a letter of the scene that is called as one is the unit vector in a term that has no other.
    """
    known = UNIT_VECTORS.keys() - letters
    if not letters.isdisjoint(AXES[:2]):
        known -= set(AXES)
    result = [
        part for token in tokens for part in (_split_axis(token, letters, known) if token.kind == "name" else [token])
    ]
    if not any(token.kind == "axis" for token in result):
        return None
    return with_shadowed(result, letters) if asked == 3 else result


def with_shadowed(tokens: list[Token], letters: frozenset[str]) -> list[Token]:
    """The tokens with the last letter that is called as a unit vector as that, in each term of a sum that has none: k in `3 i + 4 k`."""
    levels = list(accumulate((token.text in OPENING) - (token.text in CLOSING) for token in tokens))
    base = next(level for level, token in zip(levels, tokens, strict=True) if token.kind == "axis")
    signs = [
        index
        for index in range(1, len(tokens))
        if levels[index] == base
        and tokens[index].kind in "+-"
        and tokens[index - 1].kind not in ("^", "/", "*", "+", "-")
    ]
    result = list(tokens)
    for start, end in pairwise([0, *signs, len(tokens)]):
        term = [index for index in range(start, end) if levels[index] == base]
        named = [index for index in term if tokens[index].kind == "name" and tokens[index].text in letters]
        hidden = [index for index in named if tokens[index].text in UNIT_VECTORS]
        if hidden and not any(tokens[index].kind == "axis" for index in term):
            old = tokens[hidden[-1]]
            result[hidden[-1]] = Token("axis", UNIT_VECTORS[old.text], old.start, old.end)
    return result


def _split_axis(token: Token, letters: frozenset[str], known: Collection[str]) -> list[Token]:
    """`mgj` as mg and j; a token that has a meaning of its own stays."""
    if token.text in known:
        return [Token("axis", UNIT_VECTORS[token.text], token.start, token.end)]
    name = next((name for name in known if token.text.endswith(name)), "")
    cut = token.end - len(name)
    front = Token("name", token.text[: -len(name)], token.start, cut)
    if not name or are_letters((token,), letters) or not are_letters((front,), letters):
        return [token]
    return [front, Token("axis", UNIT_VECTORS[name], cut, token.end)]


def read_axes(text: str, tokens: list[Token], asked: int, forks: Forks, read: ReadValue) -> LineReading:
    """`3i + 4j` with a unit in its terms, behind it, or behind its bracket; the tokens have their axes told apart.

    What is not written is nothing; a third component is there where it is written or three are `asked` for.
    """
    start = next((index for index, token in enumerate(tokens) if token.kind in OPENING), 0)
    last = start + closing_bracket(tokens[start:])
    inside = last > start and any(token.kind == "axis" for token in tokens[start:last])
    if inside and start:
        sign = [] if tokens[start - 1].kind != "*" else tokens[start - 1 : start]
        front = [*tokens[: start - len(sign)], end_at(tokens[start])]
        return with_factor_in_front(read(with_one(front)), read_axes(text, tokens[start:], asked, forks, read))
    if inside and looks_like_unit(tokens[last + 1 :]):
        behind = tokens[last + 1 :]
        tokens = [*tokens[1:last], end_at(tokens[last])]
    else:
        final = max(index for index, token in enumerate(tokens) if token.kind == "axis")
        behind = tokens[final + 1 :] if looks_like_unit(tokens[final + 1 :]) else tokens[-1:]
        tokens = [*tokens[: len(tokens) - len(behind)], end_at(behind[0])]
    unit = read_unit(text, behind, forks) if len(behind) > 1 else None
    found: dict[int, LineReading] = {}
    bases = set()
    for term in axis_terms(tokens):
        axis, coefficient = axis_and_coefficient(term, asked)
        place, basis = PLACES[axis.text], next(names for names in BASES if axis.text in names)
        if place in found:
            raise FormulaError(f"two components along {axis.text}", axis.start, axis.end)
        bases.add(basis)
        if len(bases) > 1:
            raise FormulaError("unit vectors of two kinds in one line", axis.start, axis.end)
        pointed, remarks = with_points(coefficient, forks)
        found[place] = with_remarks(read(pointed), remarks)
    shared = next((part.unit for part in found.values()), None)
    nothing = LineReading(NUMBER, "0", ZERO, shared)
    whole = vector_of([found.get(place, nothing) for place in range(3 if asked == 3 or 2 in found else 2)], unit)
    return replace(whole, basis=basis[0])


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


def axis_and_coefficient(term: list[Token], asked: int) -> tuple[Token, list[Token]]:
    """The axis of a term, and what stands before it (1 where nothing does)."""
    places = [index for index, token in enumerate(term) if token.kind == "axis"]
    if not places:
        axes = "i, j or k" if asked == 3 else "i or j"
        raise FormulaError(f"this term has no direction: write {axes} behind it", term[0].start, term[-1].end)
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
    return axis, without_brackets(rest)


def without_brackets(tokens: list[Token]) -> list[Token]:
    """A coefficient, perhaps with a sign, without the brackets round a single number with its unit: `−(3 N) i`."""
    sign = 1 if tokens[0].kind == "-" else 0
    inner = tokens[sign + 1 : -2]
    whole = closing_bracket(tokens[sign:]) == len(tokens) - sign - 2
    plain = bool(inner) and inner[0].kind == "number" and not any(one.kind in ("+", "-") for one in inner)
    return [*tokens[:sign], *inner, tokens[-1]] if whole and plain else tokens


# by size and direction


class SizeAndAngle(Struct, frozen=True):
    """A line cut into a size, up to `end`, and an angle from `start` to `stop`, with the words behind it and the `direction` before it."""

    end: int
    start: int
    stop: int
    words: frozenset[str]
    direction: str = ""

    def any(self, *words: str) -> bool:
        return not self.words.isdisjoint(words)


def cut_polar(text: str, start: int) -> SizeAndAngle | None:
    """Where size and angle stand in a line; None where it does not tell a direction by an angle."""
    if _HINT.search(text, start) is None:
        return None
    match = re.compile(_SPLIT).search(text, start)
    if match is None:
        return None
    said = re.compile(_PHRASE).search(text[: match.start()], start)  # 5 N, up and to the left, at 53°
    end = match.start() if said is None or not said[0].strip(" ,.$)-") else said.start()
    size = text[start:end].rstrip(" ,")
    if not size.strip() or size.count("(") != size.count(")"):
        return None
    phrase = re.compile(_PHRASE).search(text, match.end())
    assert phrase is not None
    words = frozenset(re.findall(r"[a-z]+|[-−](?=[xy])", f"{text[end : match.start()]} {phrase[0]}".lower()))
    direction = text[end : match.start()].strip(" ,")
    return SizeAndAngle(start + len(size), match.end(), phrase.start(), words, direction)


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
    polar = (replace(size, direction=cut.direction), angle)
    return LineReading(VECTOR, written, unit=size.unit, parts=tuple(parts), remarks=remarks, polar=polar)
