"""Polar: vectors by size and direction, `5 N at 53°` and `5 N, 53.1° above the horizontal`.

An angle without words is counted counterclockwise from the right. Where words leave open whether it is to the right or to the left,
both are read.
"""

from __future__ import annotations

import re
from fractions import Fraction

from msgspec import Struct

from rotsolve.algebra.formula import Call, Formula, Number, add, divide, multiply, negate
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.notation.tokens import FormulaError
from rotsolve.algebra.units.dimension import ANGLE
from rotsolve.algebra.units.unit_table import UNITS, times_pi
from rotsolve.grading.reading.grammar.forks import Forks
from rotsolve.grading.reading.records import FORMULA, NUMBER, VECTOR, Reading
from rotsolve.grading.verdict import Remark

# A comma between digits is a decimal one, and `rad/s` is no angle.
_HINT = re.compile(
    r"°|∠|@|deg|rad\b(?!\s*[/·*]|\s*s)|\\circ|\\angle|\bangle|\bat\s+[0-9.,]+\s*$|horizontal|vertical|axis"
)
# What is rare is compiled when a line first needs it.
_SPLIT = (
    r"(?:\s*(?<!\\)[,;])?\s*(?:\b(?:at|with|under|in)\b|@|∠|\\angle|(?<!\\)(?:;|(?<![0-9]),|,(?![0-9])))(?:\s*(?:an?\s+|the\s+)?(?:angle|direction)(?:\s+of)?\b)?\s*"
    r"(?=[^,;]*(?:°|∠|@|deg|rad\b|\\circ|horizontal|vertical|axis)|(?<!,)(?<!, )[0-9.,]+\s*$)"
)
_WORD = (
    r"above|below|under|over|up(?:wards?)?|down(?:wards?)?|left|right|of|to|from|with|the|horizontal|vertical|negative|positive|and|on|side"
    r"|measured|axis|[+\-−]?[xy](?=[\s-]axis|$)|counter-?clockwise|anti-?clockwise|clockwise"
)
_PHRASE = rf"(?i:(?:(?<![A-Za-z\\])(?:{_WORD})(?![A-Za-z])[\s,.$)\-]*)*)$"
COUNTER = ("counter", "anti", "counterclockwise", "anticlockwise")  # before "clockwise"
DEGREE, RADIAN = UNITS["deg"], UNITS["rad"]


class Cut(Struct, frozen=True):
    """A line cut into a size, up to `end`, and an angle from `start` to `stop`, with the words behind it."""

    end: int
    start: int
    stop: int
    words: frozenset[str]

    def any(self, *words: str) -> bool:
        return not self.words.isdisjoint(words)


def cut_polar(text: str, start: int) -> Cut | None:
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
    return Cut(match.start(), match.end(), phrase.start(), words)


def heading(angle: Formula, half: Formula, cut: Cut, forks: Forks) -> Formula:
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


def polar_vector(size: Reading, angle: Reading, cut: Cut, forks: Forks) -> Reading:
    """The vector of a size at an angle, by its components."""
    remarks = (*size.remarks, *angle.remarks)
    if angle.unit is not None and angle.unit.dimension != ANGLE:
        raise FormulaError("a direction is told by an angle, such as 53°", cut.start, cut.stop)
    if angle.kind == NUMBER and angle.unit is None:
        said = "an angle without a unit is read in degrees"
        angle, remarks = told_in_degrees(angle), (*remarks, Remark("unit", (said,), cut.start, cut.stop))
    if size.kind not in (NUMBER, FORMULA) or size.formula is None or angle.formula is None:
        raise FormulaError("a vector is told by its size and one angle", 0, cut.end)
    unit = angle.unit if angle.unit is not None else RADIAN
    factor = unit.factor
    way = heading(angle.formula, times_pi(1 / unit.scale, 1 - unit.pi_power), cut, forks)
    shown = angle.unit.after(to_text(way)) if angle.unit is not None else to_text(way)
    parts = []
    for function in ("cos", "sin"):
        value = multiply(size.formula, Call(function, (multiply(way, factor),)))
        text = to_text(value) if size.unit is None else size.unit.after(to_text(value))
        parts.append(Reading(size.kind, text, value, size.unit, size.figures))
    return Reading(
        VECTOR, f"{size.text} at {shown}", unit=size.unit, parts=tuple(parts), remarks=remarks, polar=(size, angle)
    )


def told_in_degrees(angle: Reading) -> Reading:
    return Reading(NUMBER, DEGREE.after(angle.text), angle.formula, DEGREE, angle.figures)
