"""Columns: what the columns of a class's table hold, by the table's first line, which also tells what separates them."""

from __future__ import annotations

import csv
from collections.abc import Sequence

from msgspec import Struct

from rotsolve.core.faults import Fault, Span
from rotsolve.grading.course.handing.content import HandedInError
from rotsolve.grading.course.handing.naming import meant
from rotsolve.scene.words import hint, quoted

SEPARATORS = (",", ";", "\t")
STUDENT = (  # words over the column of names, the likeliest first
    *("student", "name", "student name", "full name", "student id", "pupil", "id", "number"),
    *("email", "e-mail", "email address", "username"),
)
VARIANT = ("variant", "version", "sheet")
WORKING = ("working", "equations", "solution", "work")


class Columns(Struct, frozen=True):
    """The places of the answers by their names, of the student's name, the variant and the working; what is in no use."""

    separator: str
    width: int
    answers: dict[str, int]
    student: int | None
    variant: int | None
    working: int | None
    unused: tuple[str, ...]


def columns(header: Sequence[str], line: int, file: str, asked: Sequence[str]) -> Columns:
    """The columns by the lines of the first row: separated by what makes the most of its cells known."""
    best = max(
        (read(header, separator, asked) for separator in SEPARATORS), key=lambda item: (len(item.answers), item.width)
    )
    cells = cells_of(header, best.separator)
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
    cells = cells_of(header, separator)
    answers: dict[str, int] = {}
    for place, cell in enumerate(cells):
        name = meant(cell, asked)
        if name is not None:
            answers.setdefault(name, place)
    free = [place for place in range(len(cells)) if place not in answers.values()]
    variant, working = (called(cells, free, words) for words in (VARIANT, WORKING))
    free = [place for place in free if place not in (variant, working)]
    student = called(cells, free, STUDENT)
    if student is None:
        student = next(iter(free), None)
    unused = tuple(cells[place] for place in free if place != student and cells[place])
    return Columns(separator, len(cells), answers, student, variant, working, unused)


def cells_of(header: Sequence[str], separator: str) -> list[str]:
    """The names in the first row, without empty ones at its end."""
    try:
        cells = next(csv.reader([f"{line}\n" for line in header], delimiter=separator), [])
    except csv.Error:  # a cell beyond all measure
        return []
    while cells and not cells[-1].strip():
        cells.pop()
    return [" ".join(cell.split()) for cell in cells]


def called(cells: Sequence[str], free: Sequence[int], words: Sequence[str]) -> int | None:
    """The first place of those that are free whose cell is one of the words, by the order of the words."""
    lower = {place: " ".join(cells[place].replace("_", " ").lower().split()) for place in free}
    return next((place for word in words for place in free if lower[place] == word), None)


def doubled(cells: Sequence[str], asked: Sequence[str]) -> str:
    """A cell that names an answer which another cell before it names too."""
    seen: set[str] = set()
    for cell in cells:
        name = meant(cell, asked)
        if name in seen:
            return cell
        if name is not None:
            seen.add(name)
    return ""
