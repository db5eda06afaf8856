"""Columns: what the columns of a class's table hold, by the table's first line, which also tells what separates them."""

from __future__ import annotations

import csv
import re
from collections.abc import Sequence

from msgspec import Struct

from rotsolve.algebra.notation.tokens import FormulaError
from rotsolve.algebra.units.quantities import parse_unit
from rotsolve.core.faults import Fault, Span
from rotsolve.grading.course.handing.content import HandedInError
from rotsolve.grading.course.handing.naming import meant
from rotsolve.language.words import hint, quoted

SEPARATORS = (",", ";", "\t")
STUDENT = (  # words over the column of names, the likeliest first
    *("student", "name", "student name", "full name", "student id", "pupil", "id", "number"),
    *("email", "e-mail", "email address", "username"),
)
VARIANT = ("variant", "version", "sheet")
WORKING = ("working", "equations", "solution", "work")
WITH_UNIT = re.compile(
    r"(?P<name>.+?)\s*(?:\((?P<round>[^()]+)\)|\[(?P<square>[^\[\]]+)\]|\s[i/]n?\s+(?P<plain>\S.*))"
)  # a (m/s²), a in m/s²


class Columns(Struct, frozen=True):
    """The places of the answers by their names, of the student's name, the variant and the working; what is in no use."""

    separator: str
    width: int
    answers: dict[str, int]
    student: int | None
    variant: int | None
    working: int | None
    unused: tuple[str, ...]
    units: dict[str, str] = {}  # of the answers whose column tells one; numbers without a unit are in it
    breadth: int = 0  # cells of the first line, with empty ones at its end


def columns(header: Sequence[str], line: int, file: str, asked: Sequence[str]) -> Columns:
    """The columns by the lines of the first row: separated by what makes the most of its cells known."""
    best = max(
        (read(header, separator, asked) for separator in SEPARATORS), key=lambda item: (len(item.answers), item.width)
    )
    cells = trimmed(row_of(header, best.separator))
    wrong, message = "", ""
    if not best.answers:
        wrong, message = header[0], "no column has the name of an answer"
        help = hint(next(filter(None, cells), ""), asked, "asked")
    elif twice := doubled(cells, asked):
        wrong, message = twice, f"two columns are {quoted(twice)}"
        help = "leave one out, or give it another name"
    if message:
        span = Span(line, max(1, header[0].rfind(wrong) + 1), max(1, len(wrong)))
        raise HandedInError([Fault(message, span, help)], ("",) * (line - 1) + tuple(header), file)
    return best


def read(header: Sequence[str], separator: str, asked: Sequence[str]) -> Columns:
    """The columns, if that is the separator."""
    row = row_of(header, separator)
    cells = trimmed(row)
    answers: dict[str, int] = {}
    units: dict[str, str] = {}
    for place, cell in enumerate(cells):
        name, unit = answer_of(cell, asked)
        if name is not None and name not in answers:
            answers[name] = place
            units |= {name: unit} if unit else {}
    free = [place for place in range(len(cells)) if place not in answers.values()]
    variant, working = (called(cells, free, words) for words in (VARIANT, WORKING))
    free = [place for place in free if place not in (variant, working)]
    student = called(cells, free, STUDENT)
    if student is None:
        student = next(iter(free), None)
    unused = tuple(cells[place] for place in free if place != student and cells[place])
    return Columns(separator, len(cells), answers, student, variant, working, unused, units, len(row))


def answer_of(cell: str, asked: Sequence[str]) -> tuple[str | None, str]:
    """The answer that a cell names, and the unit that it tells: `a (m/s²)`."""
    whole = meant(cell, asked)
    match = WITH_UNIT.fullmatch(cell) if whole is None else None
    name = meant(match["name"], asked) if match else None
    if match is None or name is None:
        return whole, ""
    unit = next(filter(None, (match["round"], match["square"], match["plain"]))).strip()
    try:
        return name, parse_unit(unit).text
    except FormulaError:
        return name, ""


def row_of(header: Sequence[str], separator: str) -> list[str]:
    """The cells of the first row."""
    try:
        return next(csv.reader([f"{line}\n" for line in header], delimiter=separator), [])
    except csv.Error:  # a cell beyond all measure
        return []


def trimmed(row: Sequence[str]) -> list[str]:
    """The names in the first row, without empty ones at its end."""
    cells = [" ".join(cell.split()) for cell in row]
    while cells and not cells[-1]:
        cells.pop()
    return cells


def called(cells: Sequence[str], free: Sequence[int], words: Sequence[str]) -> int | None:
    """The first place of those that are free whose cell is one of the words, by the order of the words."""
    lower = {place: " ".join(cells[place].replace("_", " ").lower().split()) for place in free}
    return next((place for word in words for place in free if lower[place] == word), None)


def doubled(cells: Sequence[str], asked: Sequence[str]) -> str:
    """A cell that names an answer which another cell before it names too."""
    seen: set[str] = set()
    for cell in cells:
        name, _ = answer_of(cell, asked)
        if name in seen:
            return cell
        if name is not None:
            seen.add(name)
    return ""
