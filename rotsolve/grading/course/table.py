"""Table: the papers of a class from a CSV, a row a student. What is wrong with a row is said with it, and stops no other.

The table's first line names its columns, and tells what separates them.
"""

from __future__ import annotations

import csv
import re
from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, islice
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.core.faults import Fault
from rotsolve.grading.course.columns import (
    CANVAS,
    EMAIL,
    FIRST,
    LAST,
    LOGIN,
    NAME,
    NUMBER,
    SECTION,
    VARIANT,
    Columns,
    read_columns,
)
from rotsolve.grading.course.handed_in import MARK, HandedInError, as_whole_vectors, file_error
from rotsolve.grading.course.questions import SheetTask
from rotsolve.grading.course.students import Student
from rotsolve.grading.verdict import Paper

HEADING = 20  # lines that the names of the columns may take
HIGHEST = 200  # lines that one row may take, by line breaks in quotes
NAMED = 5  # lines that are named where a name stands in many
LONGEST = 20_000  # characters of a cell
ROWS = 200_000
SAID = {",": "a comma", ";": "a semicolon", "\t": "a tab"}
KEPT = re.compile(r"'(?='*[-+=@−＝＋－＠])")  # an apostrophe by which a spreadsheet keeps a text from being worked out
DECIMAL = re.compile(r"[-+−]?\d[\d.,]*(?:[eE][-+−]?\d+)?")
WHOLE, REST = re.compile(r"(?:[^\W\d]\w*\s*=\s*)?[-+−]?\d{1,4}"), re.compile(r"\d+\s*[^\W\d]")  # `2` and `18 m/s²`
TOLD = re.compile(r"sep=(.)\s*$")  # what some spreadsheets write above the header
NO_STUDENT = "points possible"  # begins a row of Canvas that says how many marks there are


class Entry(Struct, frozen=True):
    """A row: where it begins, whose it is, its papers if they can be marked, one for each problem, and what is to be said of it.

    A paper has the answers that the table has columns of, '' where the cell is empty.
    """

    line: int
    student: Student
    papers: tuple[Paper, ...] | None
    remarks: tuple[str, ...] = ()
    variant: str = ""
    file: str = ""

    @property
    def place(self) -> str:
        """Which row it is, in words."""
        return f"line {self.line}"


def varied_entry(entry: Entry, variant: int | None) -> Entry:
    """The row; where it tells no variant, with this one."""
    if entry.papers is None or entry.variant or variant is None:
        return entry
    papers = tuple(replace(paper, variant=str(variant)) for paper in entry.papers)
    return replace(entry, papers=papers, variant=str(variant))


class Handed(Struct, frozen=True):
    """All rows of a class with the columns that they have, and whether the file began with a byte order mark."""

    columns: Columns
    entries: tuple[Entry, ...]
    byte_order_mark: bool = False


def read_table(text: str, file: str, sheet: SheetTask) -> Handed:
    """The class in a CSV; of a table that is none, what is wrong. A column may hold a component of what is asked."""
    plain = text.removeprefix(MARK)
    return gathered_class(*opened_table(iter(plain.split("\n")), file, sheet), file, plain is not text)


def gathered_class(found: Columns, entries: Iterable[Entry], file: str, byte_order_mark: bool = False) -> Handed:
    """All rows of a class at once, with what only shows when all are there."""
    rows = list(islice(entries, ROWS + 1))
    if len(rows) > ROWS:
        help = "split the class, or have the marks alone: -o marks.csv"
        raise HandedInError([Fault(f"the table has more than {ROWS} rows", None, help)], (), file)
    return Handed(found, tuple(with_name_remarks(rows)), byte_order_mark)


def opened_table(lines: Iterator[str], file: str, sheet: SheetTask) -> tuple[Columns, Iterator[Entry]]:
    """The columns of a CSV, and its rows as they are asked for, of which no more than a few lines are held at a time."""
    numbered = ((number, line) for number, line in enumerate(lines, 1) if line.strip() and not TOLD.match(line))
    number, first = next(numbered, (0, ""))
    if not number:
        raise file_error("the table is empty", "its first line names the columns", file)
    ahead = [first, *islice(lines, HEADING - 1)]
    header = first_row(ahead)
    found = read_columns(header, number, file, sheet)
    below = chain(ahead[len(header) :], lines)
    return found, entries_of_file(table_entries(below, number + len(header), found, sheet), file)


def entries_of_file(entries: Iterable[Entry], file: str) -> Iterator[Entry]:
    """The rows with the file that they are of; there has to be one."""
    entry = None
    for entry in entries:
        yield replace(entry, file=Path(file).name)
    if entry is None:
        raise file_error("the table has no row below its first line", "", file)


def first_row(lines: Sequence[str]) -> Sequence[str]:
    """The lines of the first row, whose cells may hold line breaks within quotes."""
    for end in range(1, len(lines) + 1):
        if "\n".join(lines[:end]).count('"') % 2 == 0:
            return lines[:end]
    return lines[:1]


def table_entries(lines: Iterator[str], number: int, found: Columns, sheet: SheetTask) -> Iterator[Entry]:
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
                yield unread_entry(number, ahead[0], error, found)
            else:
                if not tells_no_student(cells):
                    yield row_entry(number, cells, found, sheet)
        number += height
        for _ in range(height):
            ahead.popleft()
        ahead.extend(islice(lines, height))


def unread_entry(number: int, line: str, error: csv.Error, found: Columns) -> Entry:
    """A row that can't be read; its cells may tell whose it is."""
    cells = [text.strip('" ') for text in line[:HIGHEST].split(found.separator)]
    known = student_of(cells, found.people)
    return Entry(number, Student(known.name, known.number), None, (csv_complaint(error),))


def tells_no_student(cells: Sequence[str]) -> bool:
    """Whether a row is that of a gradebook which says how many marks there are."""
    return bool(cells) and cells[0].strip().lower().startswith(NO_STUDENT)


def csv_complaint(error: csv.Error) -> str:
    """The complaint of Python's reader in our words."""
    if "field larger" in str(error):
        return "a cell is too long"
    said = "a quotation mark is never closed, or text follows a closing one"
    return f"{said}; inside quotes, write a quotation mark twice"


def plain_cell(cells: Sequence[str], place: int | None) -> str:
    """What stands in a cell, without the apostrophe by which a spreadsheet keeps it a text."""
    text = cells[place].strip() if place is not None and place < len(cells) else ""
    return text[1:] if KEPT.match(text) else text


def student_of(cells: Sequence[str], people: dict[str, int]) -> Student:
    """Whose row it is. First and last names are joined; where one of the two has no column of its own, `name` is the other."""
    said = {kind: " ".join(plain_cell(cells, place).split()) for kind, place in people.items()}
    name = said.get(NAME, "")
    if FIRST in said or LAST in said:
        name = " ".join(filter(None, (said.get(FIRST, name), said.get(LAST, name))))
    rest = {kind: said.get(kind, "") for kind in (NUMBER, EMAIL, LOGIN, SECTION, CANVAS)}
    return Student(name, **rest)


def row_entry(line: int, cells: Sequence[str], found: Columns, sheet: SheetTask) -> Entry:
    """One row as papers; too many cells shift what they hold, so they are not marked."""
    student, variant = student_of(cells, found.people), plain_cell(cells, found.people.get(VARIANT))
    if any(text.strip() for text in cells[found.width :]):
        cure = f"an answer that holds {SAID[found.separator]} must be in quotes"
        said = f"the row has {len(cells)} cells, the first line {found.width}: {cure}"
        return Entry(line, student, None, (said,), variant)
    if any(len(text) > LONGEST for text in cells):
        return Entry(line, student, None, (f"a cell has more than {LONGEST} characters",), variant)
    read = [paper_in_row(place, cells, found, sheet) for place in range(len(sheet.tasks))]
    papers = tuple(replace(paper, student=student.called, variant=variant) for paper in read)
    return Entry(line, student, papers, tuple(row_remarks(student, cells, found, sheet)), variant)


def row_remarks(student: Student, cells: Sequence[str], found: Columns, sheet: SheetTask) -> Iterator[str]:
    """What is odd about a row that can be read."""
    if len(cells) > found.breadth:  # an answer with a separator in it may have shifted the others
        yield f"the row has {len(cells)} cells, the first line {found.breadth}"
    if cut := cut_decimal(cells, found):
        yield f"is `{cut}` one number with a decimal comma? Then it must be in quotes"
    if not student.called and found.people:
        yield "the row has no name"
    beyond = [sheet.key(asked) for asked, place in found.answers.items() if place >= len(cells)]
    if beyond:
        yield f"the row ends before {', '.join(beyond)}"


def paper_in_row(place: int, cells: Sequence[str], found: Columns, sheet: SheetTask) -> Paper:
    """What a row has of one problem."""
    task = sheet.tasks[place]
    texts = {
        asked: " ".join(plain_cell(cells, column).split("\n"))
        for asked, column in found.answers.items()
        if asked[0] == place and plain_cell(cells, column)
    }
    for asked in texts.keys() & found.units.keys():
        if DECIMAL.fullmatch(texts[asked]):  # in the unit that the column tells
            texts[asked] += f" {found.units[asked]}"
    named = {name: text for (_, name), text in texts.items()}
    working = plain_cell(cells, found.workings.get(place))
    lines = tuple(part.strip() for part in re.split(r"[\n;]", working) if part.strip())
    whole = as_whole_vectors(named, tuple(task.letters), task.parts)
    held = {task.parts.get(name, name) for number, name in found.answers if number == place}
    return Paper("", {name: whole.get(name, "") for name in task.letters if name in held}, lines)


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
    """The entries; of a name that stands in several rows without anything to tell them apart, each says so."""
    lines: dict[str, list[int]] = {}
    for entry in entries:
        lines.setdefault(entry.student.name.casefold(), []).append(entry.line)
    students = {entry.line: entry.student for entry in entries}
    for entry in entries:
        same = lines[entry.student.name.casefold()] if entry.student.name else []
        unlike = (line for line in same if line != entry.line and entry.student.same_identity(students[line]) is None)
        yield also_elsewhere(entry, "the same name", list(islice(unlike, NAMED)))


def also_elsewhere(entry: Entry, what: str, lines: Sequence[int]) -> Entry:
    """The entry, which says of something of its student that it stands in other lines too, where there are such."""
    if not lines:
        return entry
    said = f"{what} stands in {'lines' if len(lines) > 1 else 'line'} {', '.join(map(str, lines))}"
    return replace(entry, remarks=(*entry.remarks, said))
