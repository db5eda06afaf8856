"""Matrices: the rows of one as lines of their own: `[[1, 0], [0, 2]] kg m²`, `(1, 0; 0, 2)`, or as LaTeX writes them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from msgspec import Struct

from rotsolve.grading.reading import AnswerError, Names, Reading, read_answer
from rotsolve.grading.reading.records import VECTOR

LATEX = re.compile(r"\\begin\{[pb]?matrix\}(?P<inside>.*)\\end\{[pb]?matrix\}", re.DOTALL)
NESTED = re.compile(r"\s*[\[(]\s*(?P<inside>[\[(].*[\])])\s*[\])]", re.DOTALL)
FLAT = re.compile(r"\s*[\[(](?P<inside>[^\[\]()]*;[^\[\]()]*)[\])]")
LARGEST = 4000  # characters of a matrix
OPEN, CLOSE = "[(", "])"


class Row(Struct, frozen=True):
    """The entries of one row between brackets, and where they begin in the line."""

    text: str
    start: int


def read_matrix(text: str, names: Names) -> tuple[Reading, ...]:
    """The one reading of a matrix, its rows as vectors; AnswerError where it can not be read."""
    shape = None if len(text) > LARGEST else LATEX.search(text) or NESTED.search(text) or FLAT.search(text)
    if shape is None:
        raise AnswerError("a matrix is written row by row: `[[1, 0], [0, 2]] kg m²`", 0, len(text))
    inside, start = shape["inside"], shape.start("inside")
    unit = text[shape.end() :].strip()
    rows = latex_rows(inside, start) if shape.re is LATEX else bracketed(inside, start) or flat_rows(inside, start)
    return (Reading(VECTOR, text.strip(), parts=tuple(read_row(row, unit, names) for row in rows)),)


def read_row(row: Row, unit: str, names: Names) -> Reading:
    """One row, with the unit behind the whole matrix."""
    try:
        return next(iter(read_answer(f"({row.text}) {unit}".strip(), names)))
    except AnswerError as error:
        start = row.start - 1 + error.start
        raise AnswerError(error.message, start, row.start - 1 + error.end, error.suggestion, error.unknown) from None


def latex_rows(inside: str, start: int) -> Iterator[Row]:
    for match in re.finditer(r"(?:(?!\\\\).)+", inside, re.DOTALL):
        if match[0].strip():
            yield Row(match[0].replace("&", ","), start + match.start())


def flat_rows(inside: str, start: int) -> Iterator[Row]:
    return (Row(match[0], start + match.start()) for match in re.finditer("[^;]+", inside))


def bracketed(inside: str, start: int) -> list[Row]:
    """What stands between brackets of the outermost level."""
    rows, depth, first = [], 0, 0
    for index, character in enumerate(inside):
        if character in OPEN:
            depth += 1
            first = index + 1 if depth == 1 else first
        elif character in CLOSE:
            depth -= 1
            if depth == 0:
                rows.append(Row(inside[first:index], start + first))
    return rows
