"""Matrices: a matrix, of which each row is a line of its own, perhaps with a factor in front, and named components: `L_x = …, L_y = …`.

Of a symmetric matrix the entries on one side of its diagonal may stand alone: `[[a, b, c], [d, e], [f]]`, `I_xy = …`, a blank in LaTeX;
`diag(a, b, c)` has none beside it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import islice, product

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO
from rotsolve.algebra.notation.tokens import FormulaError
from rotsolve.grading.reading.answers import after_name, read_line
from rotsolve.grading.reading.lines import EQUALS
from rotsolve.grading.reading.records import FORMULA, NUMBER, VECTOR, AnswerError, LineReading, Names
from rotsolve.grading.reading.tokens import tokens_of
from rotsolve.grading.reading.vectors import with_factor_in_front

_NAME = r"(?:[pbvBV]?(?:small)?matrix\}|array\}\s*\{[^{}]*\})"
LATEX = re.compile(
    rf"(?:\\left\s*[\[(]\s*)?\\begin\{{{_NAME}(?P<inside>.*)\\end\{{\w+\}}(?:\s*\\right\s*[\])])?", re.DOTALL
)
DIAGONAL = re.compile(r"(?:\\operatorname\{diag\}|\\?\bdiag)\s*(?:\\left\s*)?[\[(](?P<inside>.*)[\])]", re.DOTALL)
NESTED = re.compile(r"[\[(]\s*(?P<inside>[\[(].*[\])])\s*[\])]", re.DOTALL)
FLAT = re.compile(r"[\[(](?P<inside>[^\[\]()]*;[^\[\]()]*)[\])]")
LARGEST = 4000  # characters of a matrix
MOST_MATRICES = 64  # that the readings of its rows make together
OPEN, CLOSE = "[(", "])"
BLANK = ("", "*", "\\ast", "\\cdot", "\\cdots")  # an entry that stands on the other side of the diagonal

MatrixRow = tuple[str, int]  # the entries of one row between brackets, and where they begin in the line


def read_matrix(text: str, names: Names) -> tuple[LineReading, ...]:
    """The readings of a matrix, its rows as vectors; AnswerError where it can not be read."""
    start = value_start(text, names)
    forms = (LATEX, DIAGONAL, NESTED, FLAT) if len(text) <= LARGEST else ()
    shape = next((match for form in forms if (match := form.search(text, start)) is not None), None)
    if shape is None:
        raise AnswerError("a matrix is written row by row: `[[1, 0], [0, 2]] kg m²`", 0, len(text))
    wholes = written_matrices(shape, text[shape.end() :].strip(), names)
    front = re.sub(r"(?:[\s$*·⋅×]|\\cdot|\\times)+$", "", text[start : shape.start()])
    if not front.strip(" $"):
        return wholes
    readings = read_line(front, Names(names.givens, names.answers))
    factor = next((one for one in readings if one.kind in (NUMBER, FORMULA)), None)
    if factor is None:
        raise AnswerError("what stands in front of the matrix is no factor", start, shape.start())
    return tuple(with_factor_in_front(factor, whole) for whole in wholes)


def value_start(text: str, names: Names) -> int:
    """Where the matrix begins: behind `NAME =`, and behind what leads from there to it with another sign of equality."""
    signs = list(EQUALS.finditer(text))
    if not signs or not names.asked:
        return 0
    try:
        after_name(text[: signs[0].end()], names)
    except FormulaError as error:
        raise AnswerError.of(error, text) from None
    return signs[-1].end()


def written_matrices(shape: re.Match[str], unit: str, names: Names) -> tuple[LineReading, ...]:
    """The matrix as it is written, with the unit behind it, in each way in which its rows can be read together."""
    inside, start = shape["inside"], shape.start("inside")
    rows: Iterator[MatrixRow] | list[MatrixRow] = [(inside, start)]
    if shape.re is LATEX:
        rows = latex_rows(inside, start)
    elif shape.re is not DIAGONAL:
        rows = bracketed_rows(inside, start) or flat_rows(inside, start)
    ways = [read_row(*row, unit, names) for row in rows]
    tried = list(islice(product(*ways), MOST_MATRICES + 1))
    cut = len(tried) > MOST_MATRICES or any(row.cut for way in ways for row in way)
    result = []
    for read in tried[:MOST_MATRICES]:
        parts = on_diagonal(read[0]) if shape.re is DIAGONAL else mirrored(read)
        written = f"[{', '.join(row.text for row in read)}]"
        result.append(LineReading(VECTOR, written, parts=tuple(parts), cut=cut))
    return tuple(result)


def read_row(text: str, start: int, unit: str, names: Names) -> tuple[LineReading, ...]:
    """The readings of one row, with the unit behind the whole matrix."""
    try:
        return read_line(f"({text}) {unit}".strip(), names)
    except AnswerError as error:
        first, end = start - 1 + error.start, start - 1 + error.end
        raise AnswerError(error.message, first, end, error.suggestion, error.unknown) from None


def latex_rows(inside: str, start: int) -> Iterator[MatrixRow]:
    """The rows of a LaTeX matrix, without the blanks in front of or behind their entries."""
    at = 0
    for line in inside.split("\\\\"):
        place, cells = start + at, line.split("&")
        at += len(line) + len("\\\\")
        blank = [cell.strip() in BLANK for cell in cells]
        if all(blank):
            continue
        first, last = blank.index(False), len(blank) - blank[::-1].index(False)
        yield ";".join(cells[first:last]), place + sum(len(cell) + 1 for cell in cells[:first])


def flat_rows(inside: str, start: int) -> Iterator[MatrixRow]:
    return ((match[0], start + match.start()) for match in re.finditer("[^;]+", inside))


def bracketed_rows(inside: str, start: int) -> list[MatrixRow]:
    """What stands between brackets of the outermost level."""
    rows, depth, first = [], 0, 0
    for index, character in enumerate(inside):
        if character in OPEN:
            depth += 1
            first = index + 1 if depth == 1 else first
        elif character in CLOSE:
            depth -= 1
            if depth == 0:
                rows.append((inside[first:index], start + first))
    return rows


def entries_of_row(row: LineReading) -> tuple[LineReading, ...]:
    """The entries of a row; a unit behind it is that of each."""
    return row.parts or (row,)


def mirrored(rows: Sequence[LineReading]) -> Sequence[LineReading]:
    """The rows of a matrix; where one side of the diagonal stands alone, both sides are that."""
    size, cells = len(rows), [entries_of_row(row) for row in rows]
    lengths = [len(row) for row in cells]
    if size < 2 or lengths not in ([*range(size, 0, -1)], [*range(1, size + 1)]):
        return rows
    upper = lengths[0] == size

    def entry(one: int, other: int) -> LineReading:
        low, high = min(one, other), max(one, other)
        return cells[low][high - low] if upper else cells[high][low]

    return [LineReading(VECTOR, parts=tuple(entry(one, other) for other in range(size))) for one in range(size)]


def on_diagonal(row: LineReading) -> list[LineReading]:
    """The rows of a matrix that has nothing beside its diagonal."""
    cells = entries_of_row(row)
    nothing = LineReading(NUMBER, "0", ZERO, cells[0].unit)
    size = range(len(cells))
    return [LineReading(VECTOR, parts=tuple(cells[one] if one == other else nothing for other in size)) for one in size]


# named components


def named_components(text: str, names: Names, labels: Sequence[str]) -> LineReading | None:
    """`L_x = 1 N m, L_y = L_z = 0` as a vector or matrix with these labels; None where the line names none of them.

    An entry of a matrix is also that on the other side of the diagonal.
    """
    told: dict[str, LineReading] = {}
    for name, value, start in told_components(text, names, labels):
        if name in told:
            raise AnswerError(f"`{names.asked}_{name}` is told twice", start, start + len(value))
        try:
            told[name] = read_line(value, Names(names.givens, names.answers))[0]
        except AnswerError as error:
            raise AnswerError(error.message, start + error.start, start + error.end, error.suggestion) from None
    if not told:
        return None
    missing = [label for label in labels if label not in told and label[::-1] not in told]
    if missing:
        raise AnswerError(f"`{names.asked}_{missing[0]}` is missing", 0, len(text))
    parts = [told[label] if label in told else told[label[::-1]] for label in labels]
    unit = next((part.unit for part in reversed(parts) if part.unit is not None), None)
    parts = [replace(part, unit=unit) if part.unit is None and part.kind == NUMBER else part for part in parts]
    return LineReading(VECTOR, text.strip(), parts=tuple(parts))


def told_components(text: str, names: Names, labels: Sequence[str]) -> Iterator[tuple[str, str, int]]:
    """The labels that a line names, each with the value behind it and the place of that: `L_x = L_y = 0` tells 0 of both."""
    signs = list(EQUALS.finditer(text))
    heads: list[tuple[str, int, int]] = []  # the label in front of each sign of equality, from where to where
    for sign in signs:
        before = re.search(r"\\?[^\W\d_][\w{}\\]*\s*$", text[: sign.start()])
        label = None if before is None else label_of_name(before[0], names, labels)
        if before is None or label is None:
            return
        heads.append((label, before.start(), sign.end()))
    waiting: list[str] = []
    for place, (label, _, end) in enumerate(heads):
        following = heads[place + 1][1] if place + 1 < len(heads) else len(text)
        value = re.sub(r"(?:[,;\s$&]|\\\\|\\quad|\\qquad|\\,|\band\b)+$", "", text[end:following])
        waiting.append(label)
        if value.strip():
            yield from ((name, value, end) for name in waiting)
            waiting = []


def label_of_name(name: str, names: Names, labels: Sequence[str]) -> str | None:
    """The label of the component that a name means: `L_x`, `Lx` or `L_{x}` is x."""
    try:
        tokens = tokens_of(name)
    except FormulaError:
        return None
    if len(tokens) != 2 or tokens[0].kind != "name":
        return None
    both = dict.fromkeys([*labels, *(label[::-1] for label in labels)])
    meant = (label for label in both if replace(names, asked=f"{names.asked}_{label}").is_asked(tokens[0].text))
    return next(meant, None)
