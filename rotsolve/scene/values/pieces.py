"""Pieces: the paths (`rod.end.speed`) and quantities (`20 cm`) inside an expression, cut out before the formula is parsed.

Each is replaced by a letter of the same length, so that the parser's columns still fit.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

from msgspec import Struct

from rotsolve.algebra.units.quantities import UnitError, parse_unit

NUMBER = r"(?:\d+\.?\d*|\.\d+)(?:[eE][-+−]?\d+)?"
NAME = r"[^\W\d]\w*"
SCAN = re.compile(rf"(?P<number>{NUMBER})|(?P<name>{NAME}(?:\.{NAME})*)|(?P<space>\s+)|(?P<mark>.)", re.DOTALL)
POWER = r"(?:\s*\^\s*(?:[-−]?\d+|\([-−]?\d+/\d\))|[²³⁻¹⁴]+)?"
UNIT = re.compile(rf"\s*(?P<word>[^\W\d_]+|°|%){POWER}")
# What is rare is compiled when a text first needs it.
MORE = rf"(?:\s*[*·]\s*|\s*/\s*|\s+)(?P<word>[^\W\d_]+){POWER}"
CALL = rf"\.{NAME}"


class Piece(Struct, frozen=True):
    """A part of an expression: kind is number, quantity, name, path, mark or space."""

    kind: str
    text: str
    start: int
    end: int


def pieces(text: str, names: Collection[str]) -> Iterator[Piece]:
    """The expression in pieces; a number before a unit is one piece, a path with its `at(…)` is one piece."""
    position = 0
    while position < len(text):
        match = SCAN.match(text, position)
        assert match is not None
        kind, end = str(match.lastgroup), match.end()
        if kind == "number" and (stop := unit_end(text, end, names)) > end:
            kind, end = "quantity", stop
        elif kind == "name" and (text[position:end].endswith(".at") and text[end : end + 1] == "("):
            kind, end = "path", path_end(text, end)
        elif kind == "name" and "." in match[0]:
            kind = "path"
        yield Piece(kind, text[position:end], position, end)
        position = end


def path_end(text: str, position: int) -> int:
    """Where a path ends, from the `(` of its `at(…)` on."""
    depth = 0
    while position < len(text):
        depth += {"(": 1, ")": -1}.get(text[position], 0)
        position += 1
        if depth == 0:
            break
    while match := re.compile(CALL).match(text, position):
        position = match.end()
    return position


def unit_end(text: str, position: int, names: Collection[str]) -> int:
    """Where the unit after a number ends; `position` itself when none stands there."""
    match = UNIT.match(text, position)
    if not match or not is_unit(match["word"]) or text[match.end() : match.end() + 1] in ("_", "(", "."):
        return position
    position = match.end()
    while position < len(text) and (match := re.compile(MORE).match(text, position)):
        following = text[match.end() : match.end() + 1]
        if match["word"] in names or following in ("_", "(", ".") or following.isdigit() or not is_unit(match["word"]):
            break
        position = match.end()
    return position


def is_unit(word: str) -> bool:
    try:
        parse_unit(word)
    except UnitError:
        return False
    return True


def stand_in(number: int, length: int) -> str:
    """A letter that no scene has, of a given length: `Zq1_____`."""
    return f"Zq{number}".ljust(length, "z")
