"""Table: the papers of a class from a CSV, a row a student. What is wrong with a row is said with it, and stops no other.

The table's first line names its columns, and tells what separates them.
"""

from __future__ import annotations

import csv
import re
from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, islice

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.notation.tokens import FormulaError
from rotsolve.algebra.units.quantities import parse_unit
from rotsolve.core.faults import Fault, Span
from rotsolve.grading.course.sheet import (
    MARK,
    NO_PARTS,
    HandedInError,
    Parts,
    as_whole_vectors,
    file_error,
    meant_answer,
)
from rotsolve.grading.verdict import Paper
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

HEADING = 20  # lines that the names of the columns may take
HIGHEST = 200  # lines that one row may take, by line breaks in quotes
NAMED = 5  # lines that are named where a name stands in many
LONGEST = 20_000  # characters of a cell
ROWS = 200_000
SAID = {",": "a comma", ";": "a semicolon", "\t": "a tab"}
KEPT = re.compile(r"'[-+=@−]")  # an apostrophe by which a spreadsheet keeps a text from being worked out
NUMBER = re.compile(r"[-+−]?\d[\d.,]*(?:[eE][-+−]?\d+)?")
WHOLE, REST = re.compile(r"(?:[^\W\d]\w*\s*=\s*)?[-+−]?\d{1,4}"), re.compile(r"\d+\s*[^\W\d]")  # `2` and `18 m/s²`
TOLD = re.compile(r"sep=(.)\s*$")  # what some spreadsheets write above the header


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


def read_columns(header: Sequence[str], line: int, file: str, asked: Sequence[str]) -> Columns:
    """The columns by the lines of the first row: separated by what makes the most of its cells known."""
    tried = (columns_by(header, separator, asked) for separator in SEPARATORS)
    best = max(tried, key=lambda item: (len(item.answers), item.width))
    cells = trimmed_cells(first_row_cells(header, best.separator))
    twice = doubled_column(cells, asked)
    if best.answers and not twice:
        return best
    wrong, message = twice, f"two columns are {quoted(twice)}"
    help = "leave one out, or give it another name"
    if not best.answers:
        wrong, message = header[0], "no column has the name of an answer"
        help = hint(next(filter(None, cells), ""), asked, "asked")
    span = Span(line, max(1, header[0].rfind(wrong) + 1), max(1, len(wrong)))
    raise HandedInError([Fault(message, span, help)], ("",) * (line - 1) + tuple(header), file)


def columns_by(header: Sequence[str], separator: str, asked: Sequence[str]) -> Columns:
    """The columns, if that is the separator."""
    return columns_called(first_row_cells(header, separator), separator, asked)


def columns_called(row: Sequence[str], separator: str, asked: Sequence[str]) -> Columns:
    """The columns by their names."""
    cells = trimmed_cells(row)
    answers: dict[str, int] = {}
    units: dict[str, str] = {}
    for place, cell in enumerate(cells):
        name, unit = answer_of(cell, asked)
        if name is not None and name not in answers:
            answers[name] = place
            units |= {name: unit} if unit else {}
    free = [place for place in range(len(cells)) if place not in answers.values()]
    variant, working = (place_called(cells, free, words) for words in (VARIANT, WORKING))
    free = [place for place in free if place not in (variant, working)]
    called = place_called(cells, free, STUDENT)
    student = next(iter(free), None) if called is None else called
    unused = tuple(cells[place] for place in free if place != student and cells[place])
    return Columns(separator, len(cells), answers, student, variant, working, unused, units, len(row))


def answer_of(cell: str, asked: Sequence[str]) -> tuple[str | None, str]:
    """The answer that a cell names, and the unit that it tells: `a (m/s²)`."""
    whole = meant_answer(cell, asked)
    match = WITH_UNIT.fullmatch(cell) if whole is None else None
    name = meant_answer(match["name"], asked) if match else None
    if match is None or name is None:
        return whole, ""
    unit = next(filter(None, (match["round"], match["square"], match["plain"]))).strip()
    try:
        return name, parse_unit(unit).text
    except FormulaError:
        return name, ""


def first_row_cells(header: Sequence[str], separator: str) -> list[str]:
    """The cells of the first row."""
    try:
        return next(csv.reader([f"{line}\n" for line in header], delimiter=separator), [])
    except csv.Error:  # a cell beyond all measure
        return []


def trimmed_cells(row: Sequence[str]) -> list[str]:
    """The names in the first row, without empty ones at its end."""
    cells = [" ".join(cell.split()) for cell in row]
    while cells and not cells[-1]:
        cells.pop()
    return cells


def place_called(cells: Sequence[str], free: Sequence[int], words: Sequence[str]) -> int | None:
    """The first place of those that are free whose cell is one of the words, by the order of the words."""
    lower = {place: " ".join(cells[place].replace("_", " ").lower().split()) for place in free}
    return next((place for word in words for place in free if lower[place] == word), None)


def doubled_column(cells: Sequence[str], asked: Sequence[str]) -> str:
    """A cell that names an answer which another cell before it names too."""
    seen: set[str] = set()
    for cell in cells:
        name, _ = answer_of(cell, asked)
        if name in seen:
            return cell
        if name is not None:
            seen.add(name)
    return ""


# rows


class Entry(Struct, frozen=True):
    """A row: where it begins, whose it is, its paper if it can be marked, and what is to be said of it."""

    line: int
    student: str
    paper: Paper | None
    remarks: tuple[str, ...] = ()


def varied_entry(entry: Entry, variant: int | None) -> Entry:
    """The entry with a variant where its paper names none."""
    if variant is None or entry.paper is None or entry.paper.variant:
        return entry
    return replace(entry, paper=replace(entry.paper, variant=str(variant)))


class Handed(Struct, frozen=True):
    """All rows of a class with the columns that they have, and whether the file began with a byte order mark."""

    columns: Columns
    entries: tuple[Entry, ...]
    byte_order_mark: bool = False


def read_table(text: str, file: str, asked: Sequence[str], parts: Parts = NO_PARTS) -> Handed:
    """The class in a CSV; of a table that is none, what is wrong. A column may hold a component, one of the `parts` of what is asked."""
    plain = text.removeprefix(MARK)
    return gathered_class(*opened_table(iter(plain.split("\n")), file, asked, parts), file, plain is not text)


def gathered_class(found: Columns, entries: Iterable[Entry], file: str, byte_order_mark: bool = False) -> Handed:
    """All rows of a class at once, with what only shows when all are there."""
    rows = list(islice(entries, ROWS + 1))
    if len(rows) > ROWS:
        help = "split the class, or have the marks alone: -o marks.csv"
        raise HandedInError([Fault(f"the table has more than {ROWS} rows", None, help)], (), file)
    return Handed(found, tuple(with_name_remarks(rows)), byte_order_mark)


def opened_table(
    lines: Iterator[str], file: str, asked: Sequence[str], parts: Parts = NO_PARTS
) -> tuple[Columns, Iterator[Entry]]:
    """The columns of a CSV, and its rows as they are asked for, of which no more than a few lines are held at a time."""
    numbered = ((number, line) for number, line in enumerate(lines, 1) if line.strip() and not TOLD.match(line))
    number, first = next(numbered, (0, ""))
    if not number:
        raise file_error("the table is empty", "its first line names the columns", file)
    ahead = [first, *islice(lines, HEADING - 1)]
    header = first_row(ahead)
    found = read_columns(header, number, file, (*asked, *parts))
    below = chain(ahead[len(header) :], lines)
    return found, whole_entries(table_entries(below, number + len(header), found), found, file, asked, parts)


def whole_entries(
    entries: Iterator[Entry], found: Columns, file: str, asked: Sequence[str], parts: Parts
) -> Iterator[Entry]:
    """The rows, each with the components of a vector as one answer; there has to be one."""
    split = bool(parts.keys() & found.answers.keys())
    entry = None
    for entry in entries:
        yield with_whole_vectors(entry, asked, parts) if split else entry
    if entry is None:
        raise file_error("the table has no row below its first line", "", file)


def with_whole_vectors(entry: Entry, asked: Sequence[str], parts: Parts) -> Entry:
    """The entry with the components of a vector as one answer."""
    if entry.paper is None:
        return entry
    return replace(entry, paper=replace(entry.paper, answers=as_whole_vectors(entry.paper.answers, asked, parts)))


def first_row(lines: Sequence[str]) -> Sequence[str]:
    """The lines of the first row, whose cells may hold line breaks within quotes."""
    for end in range(1, len(lines) + 1):
        if "\n".join(lines[:end]).count('"') % 2 == 0:
            return lines[:end]
    return lines[:1]


def table_entries(lines: Iterator[str], number: int, found: Columns) -> Iterator[Entry]:
    """Row by row, from the line of that number on. A row that can't be read ends with its line, so that a quotation mark left open
    swallows no other."""
    ahead = deque(islice(lines, HIGHEST))
    while ahead:
        height = 1
        if ahead[0].strip(" ,;\t"):
            reader = csv.reader((f"{line}\n" for line in ahead), delimiter=found.separator, strict=True)
            try:
                cells = next(reader)
                height = reader.line_num
            except csv.Error as error:
                student = ahead[0][:40].partition(found.separator)[0].strip('" ')
                yield Entry(number, student, None, (csv_complaint(error),))
            else:
                yield row_entry(number, cells, found)
        number += height
        for _ in range(height):
            ahead.popleft()
        ahead.extend(islice(lines, height))


def csv_complaint(error: csv.Error) -> str:
    """The complaint of Python's reader in our words."""
    if "field larger" in str(error):
        return "a cell is too long"
    said = "a quotation mark is never closed, or text follows a closing one"
    return f"{said}; inside quotes, write a quotation mark twice"


def row_entry(line: int, cells: Sequence[str], found: Columns) -> Entry:
    """One row as a paper; too many cells shift what they hold, so they are not marked."""

    def cell(place: int | None) -> str:
        text = cells[place].strip() if place is not None and place < len(cells) else ""
        return text[1:] if KEPT.match(text) else text

    student = " ".join(cell(found.student).split())
    if any(text.strip() for text in cells[found.width :]):
        cure = f"an answer that holds {SAID[found.separator]} must be in quotes"
        return Entry(line, student, None, (f"the row has {len(cells)} cells, the first line {found.width}: {cure}",))
    if any(len(text) > LONGEST for text in cells):
        return Entry(line, student, None, (f"a cell has more than {LONGEST} characters",))
    remarks = []
    if len(cells) > found.breadth:  # an answer with a separator in it may have shifted the others
        remarks.append(f"the row has {len(cells)} cells, the first line {found.breadth}")
    if cut := cut_decimal(cells, found):
        remarks.append(f"is `{cut}` one number with a decimal comma? Then it must be in quotes")
    if not student and found.student is not None:
        remarks.append("the row has no name")
    beyond = [name for name, place in found.answers.items() if place >= len(cells)]
    if beyond:
        remarks.append(f"the row ends before {', '.join(beyond)}")
    texts = {name: " ".join(cell(place).split("\n")) for name, place in found.answers.items() if cell(place)}
    for name in texts.keys() & found.units.keys():
        if NUMBER.fullmatch(texts[name]):  # in the unit that the column tells
            texts[name] += f" {found.units[name]}"
    working = tuple(part.strip() for part in re.split(r"[\n;]", cell(found.working)) if part.strip())
    return Entry(line, student, Paper(student, texts, working, cell(found.variant)), tuple(remarks))


def cut_decimal(cells: Sequence[str], found: Columns) -> str:
    """A decimal number that a comma may have cut into two cells, `2` and `18 m/s²`; '' where there is none."""
    if found.separator != ",":
        return ""
    places = sorted(found.answers.values())
    for place in places:
        pair = [text.strip() for text in cells[place : place + 2]]
        if place + 1 in places and len(pair) == 2 and WHOLE.fullmatch(pair[0]) and REST.match(pair[1]):
            return ",".join(pair)
    return ""


def with_name_remarks(entries: Sequence[Entry]) -> Iterator[Entry]:
    """The entries; of a name that stands in several rows, each says so."""
    lines: dict[str, list[int]] = {}
    for entry in entries:
        lines.setdefault(entry.student.casefold(), []).append(entry.line)
    for entry in entries:
        yield name_remarked(entry, lines[entry.student.casefold()][: NAMED + 1])


def name_remarked(entry: Entry, lines: Iterable[int]) -> Entry:
    """The entry, which says so where its name stands in other lines too; `lines` are the first that have it, one more than are named."""
    others = [str(line) for line in lines if line != entry.line][:NAMED]
    if not others or not entry.student:
        return entry
    said = f"the same name stands in {'lines' if len(others) > 1 else 'line'} {', '.join(others)}"
    return replace(entry, remarks=(*entry.remarks, said))
