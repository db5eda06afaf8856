"""Columns: lines of a page of plain text: where they are broken, what stands below what, and which parts a terminal may colour."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from msgspec import Struct

from rotsolve.page.blocks import ARROW

GAP = 4  # blanks between two columns of a table
FEW_LINES = 2  # of a remark below its formula; a longer one begins
UNDER_WORDS = 6  # in this column
SHORT = 6  # a remark that is no longer than this is a number, as (12)
HELD = "\N{NO-BREAK SPACE}"  # a blank at which no line may be broken
LONG = 40  # a formula longer than this may be broken before its outer signs
IN_FORMULAS = (  # blanks behind a number, beside a sign, and before a bracket that a letter is multiplied by; compiled where needed
    r"(?<=\d) (?=\w{1,3}\b|\w+/)| (?=[=+−·≈<>] )|(?<=[=+−·≈<>]) |(?<=\b[^\W\d]) (?=\()"
)
CORNERS = (("⎡", "⎤"), ("⎢", "⎥"), ("⎣", "⎦"))
SEPARATOR = "─" * 72  # between two pages
SIGNS = ("=", "+", "−", "≈", "≤", "≥", "<", ">")


class TextLine(Struct, frozen=True):
    """One line of text; `role` says what it is, and the first `heading` characters are a heading."""

    text: str
    role: str = ""
    heading: int = 0


class ColumnRow(Struct, frozen=True):
    """One row of a table: what it is, the formula, and a remark or number behind it."""

    left: str
    middle: str = ""
    right: str = ""


def together(prose: str) -> str:
    """Prose with the blanks within its formulas, and between a number and its unit, made unbreakable."""
    return re.sub(IN_FORMULAS, HELD, prose)


def hold(text: str) -> str:
    """The text with its blanks made unbreakable; a long one may still be broken before a sign outside all brackets."""
    held = text.replace(" ", HELD)
    return held if len(text) <= LONG else loosened(held, outer=True)


def loosened(held: str, *, outer: bool) -> str:
    """Held text that may be broken before its signs: before all of them, or before those outside all brackets."""
    depth, result = 0, list(held)
    for index, letter in enumerate(held[:-1]):
        depth += (letter in "([") - (letter in ")]")
        before_sign = letter == HELD and held[index + 1] in SIGNS and held[index + 2 : index + 3] == HELD
        if before_sign and not (outer and depth):
            result[index] = " "
    return "".join(result)


def fold(text: str, width: int) -> list[str]:
    """A formula in lines of at most `width`: broken before the arrows, then before the equals sign, then before + and −."""
    if len(text) <= width:
        return [text]
    first, *steps = text.split(f" {ARROW}")
    if steps:
        parts = [first.rstrip(HELD), *(f"{ARROW}{step.rstrip(HELD)}" for step in steps)]
        return [line for part in parts for line in fold(part, width)]
    left, equals, right = text.replace(" =", f"{HELD}=").partition(f"{HELD}={HELD}")
    if equals and len(left) > 12:
        sides = (left, f"{HELD * 2}={HELD}{right}")
        return [line for side in sides for line in wrap(hold(release(side)) if side is left else side, width, 4)]
    return wrap(text, width, 4)


def release(text: str) -> str:
    """The text with ordinary blanks again, and none at its end."""
    return text.replace(HELD, " ").rstrip()


def wrap(text: str, width: int, hanging: int = 0) -> list[str]:
    """The text in lines of at most `width` columns where it has a place to break; later lines are indented by `hanging`."""
    if len(text) <= width:
        return [text]
    lines = folded(text, max(width, 20), hanging)
    if all(len(line) <= width for line in lines):
        return lines
    return folded(loosened(text, outer=False), max(width, 20), hanging)


def folded(text: str, width: int, hanging: int) -> list[str]:
    """The text broken at blanks, which fall away there: as many words to a line as fit, at least one."""
    words = iter(text.replace("\n", " ").split(" "))
    lines, line = [], next(words)
    for word in words:
        if word and line.strip(" ") and len(line) + 1 + len(word) > width:
            lines.append(line.rstrip(" "))
            line = " " * hanging + word
        else:
            line += f" {word}"
    return [*lines, line.rstrip(" ")]


def paragraph_lines(text: str, indent: int, width: int, role: str = "") -> Iterator[TextLine]:
    """A paragraph, wrapped, every line of it indented."""
    for line in wrap(text, width - indent):
        yield TextLine(release(" " * indent + line), role)


def labelled_lines(
    label: str, items: Sequence[str], separator: str, width: int, indent: int = 0, label_width: int = 0
) -> Iterator[TextLine]:
    """A heading with what belongs to it on the same line, wrapped between (and, where it must be, within) the items."""
    column = indent + max(8, label_width + 2, len(label) + 2)
    text = separator.join(items)
    if len(separator) > 2 and len(text) > width - column:  # wide gaps between items: one item a line
        lines = [line for item in items for line in wrap(item, width - column, 2)]
    else:
        lines = wrap(text.replace("     ", HELD * 5), width - column)
    for number, line in enumerate(lines):
        head = (" " * indent + label).ljust(column) if number == 0 else " " * column
        yield TextLine(release(head + line), "", len(label) + indent if number == 0 else 0)


def column_lines(rows: Sequence[ColumnRow], indent: int, width: int, role: str = "") -> Iterator[TextLine]:
    """The rows with their columns aligned; a cell that is too long goes on below, in its own column."""
    lefts = [len(row.left) for row in rows if row.middle]
    room = width - indent - GAP - max((len(row.middle) for row in rows), default=0)
    widest = max(width * 9 // 20, room)  # a longer first cell has its formula on the next line
    left = max((length for length in lefts if length <= widest), default=min(widest, max(lefts, default=0)))
    column = indent + left + GAP if left else indent
    room = max(width - column, 20)
    numbered = all(len(row.right) <= SHORT for row in rows)  # numbers stand behind the longest formula
    middles = [len(row.middle) for row in rows if (numbered or row.right) and len(row.middle) <= room]
    ends = column + max(middles, default=0) + GAP
    for row in rows:
        yield from (TextLine(release(line), role) for line in row_lines(row, indent, column, ends, width))


def row_lines(row: ColumnRow, indent: int, column: int, ends: int, width: int) -> Iterator[str]:
    """The lines of one row: `column` is where the formula starts, `ends` where the remark does."""
    first = " " * indent + row.left
    middles = fold(row.middle, max(width - column, 20)) if row.middle else []
    if not middles or len(first) > column - GAP:
        lines = [" " * indent + line for line in wrap(row.left, width - indent, 4)]
        first = "" if middles else lines.pop()
        yield from lines
    for number, middle in enumerate(middles):
        if number:
            yield first
            first = ""
        first = first.ljust(column) + middle
    yield from with_remark(first, row.right, column, ends, width)


def with_remark(line: str, remark: str, column: int, ends: int, width: int) -> Iterator[str]:
    """The last line of a row with its remark at the right, or below it where there is no room; a long one has all of the line."""
    if not remark:
        yield line
    elif len(line) + GAP <= ends and ends + len(remark) <= width:
        yield line.ljust(ends) + remark
    elif len(line) + GAP + len(remark) <= width:
        yield line + " " * GAP + remark
    else:
        yield line
        start = column + 2
        if len(wrap(remark, width - start)) > FEW_LINES:
            start = min(start, UNDER_WORDS)
        yield from (" " * start + part for part in wrap(remark, width - start))


def page_text(lines: Iterable[TextLine]) -> str:
    """The lines as one text that ends with a line break."""
    return "\n".join(line.text for line in lines) + "\n"


def boxed(rows: Sequence[Sequence[str]]) -> list[str]:
    """The rows of a matrix between tall brackets, their columns aligned; a single row between round ones."""
    if len(rows) == 1:
        return [f"({', '.join(rows[0])})"]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = ["   ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)) for row in rows]
    return [f"{left} {line} {right}" for (left, right), line in zip(CORNERS, lines, strict=True)]


def clipped_around(text: str, room: int, columns: tuple[int, int] | None = None) -> tuple[str, int]:
    """The text on one line, clipped around some of its columns where it is long; and the column at which it begins."""
    if len(text) <= room:
        return text, 0
    wanted = columns[0] if columns is not None else 0
    begin = 0 if wanted < room * 2 // 3 else min(wanted - room // 3, len(text) - room + 2)
    end = begin + room - (2 if begin else 1)
    return f"{'…' if begin else ''}{text[begin:end]}{'…' if end < len(text) else ''}", begin
