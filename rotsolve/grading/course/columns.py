"""Columns: what the first row of a class's table says: which column holds which answer, the working, and who the students are.

Headings may be those of a form, of a spreadsheet, or of an export of Moodle or Canvas, in English or German.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Mapping, Sequence

from msgspec import Struct

from rotsolve.algebra.notation.tokens import FormulaError
from rotsolve.algebra.units.quantities import parse_unit, unit_for
from rotsolve.core.faults import Fault, Span
from rotsolve.grading.course.handed_in import HandedInError
from rotsolve.grading.course.questions import Asked, SheetTask
from rotsolve.language.words import hint, quoted

SEPARATORS = (",", ";", "\t")
NAME, FIRST, LAST, VARIANT, CANVAS = "name", "first", "last", "variant", "canvas"
NUMBER, EMAIL, LOGIN, SECTION = "number", "email", "login", "section"
PEOPLE: Mapping[str, tuple[str, ...]] = {  # words over the columns that say whose a row is, the likeliest first
    VARIANT: ("variant", "version", "sheet", "variante", "blatt"),
    NUMBER: (
        *("student number", "student id", "student no", "number", "id number", "idnumber", "sis user id", "matriculation number"),
        *("matrikelnummer", "matrikel nr", "matrikel", "id nummer", "nummer", "roll number", "registration number", "id"),
    ),
    FIRST: ("first name", "firstname", "given name", "given names", "forename", "vorname", "vornamen", "rufname"),
    LAST: ("last name", "lastname", "surname", "family name", "nachname", "familienname", "zuname"),
    EMAIL: ("email", "e mail", "email address", "e mail address", "e mail adresse", "email adresse", "mail"),
    LOGIN: ("username", "user name", "login", "sis login id", "benutzername", "anmeldename"),
    SECTION: ("section",),
    NAME: (
        *("student", "name", "student name", "full name", "pupil", "vollständiger name", "schüler", "schülerin"),
        *("studierende", "studierender", "vor und nachname", "nachname, vorname", "name, vorname"),
    ),
}  # fmt: skip
OF_CANVAS = "sis "  # begins headings of Canvas, in whose tables `ID` is a number of its own
WORKING = ("working", "equations", "solution", "work", "rechnung", "rechenweg", "lösungsweg")
WITH_UNIT = re.compile(
    r"(?P<name>.+?)\s*(?:\((?P<round>[^()]+)\)|\[(?P<square>[^\[\]]+)\]|\s[i/]n?\s+(?P<plain>\S.*))"
)  # a (m/s²), a in m/s²


class Columns(Struct, frozen=True):
    """The places of the answers, of the working of each problem, and of what says whose a row is; what is in no use."""

    separator: str
    width: int
    answers: dict[Asked, int]
    workings: dict[int, int]
    people: dict[str, int]
    unused: tuple[str, ...]
    units: dict[Asked, str] = {}  # of the answers whose column tells one; numbers without a unit are in it
    breadth: int = 0  # cells of the first line, with empty ones at its end
    remarks: tuple[str, ...] = ()  # what is to be said of headings

    def held(self, sheet: SheetTask) -> set[Asked]:
        """The answers that there are columns of, or of a component of them."""
        return {(place, sheet.tasks[place].parts.get(name, name)) for place, name in self.answers}


def read_columns(header: Sequence[str], line: int, file: str, sheet: SheetTask) -> Columns:
    """The columns by the lines of the first row: separated by what makes the most of its cells known."""
    tried = (columns_by(header, separator, sheet) for separator in SEPARATORS)
    best = max(tried, key=lambda item: (len(item.answers), item.width))
    cells = trimmed_cells(first_row_cells(header, best.separator))
    fault = fault_of_headings(best, cells, sheet)
    if fault is None:
        return best
    wrong, message, help = fault
    wrong = wrong or header[0]
    span = Span(line, max(1, header[0].rfind(wrong) + 1), max(1, len(wrong)))
    raise HandedInError([Fault(message, span, help)], ("",) * (line - 1) + tuple(header), file)


def fault_of_headings(found: Columns, cells: Sequence[str], sheet: SheetTask) -> tuple[str, str, str] | None:
    """Why no class can be marked by these headings: the heading, '' for all, what is wrong, and what would help."""
    twice = doubled_column(cells, sheet)
    if not found.answers:
        help = hint(next(filter(None, cells), ""), sheet.names(), "asked")
        return "", "no column has the name of an answer", help
    if twice:
        return twice, f"two columns are {quoted(twice)}", "leave one out, or give it another name"
    return column_of_other_unit(found, cells, sheet)


def columns_by(header: Sequence[str], separator: str, sheet: SheetTask) -> Columns:
    """The columns, if that is the separator."""
    return columns_called(first_row_cells(header, separator), separator, sheet)


def columns_called(row: Sequence[str], separator: str, sheet: SheetTask) -> Columns:
    """The columns with these names."""
    cells = trimmed_cells(row)
    answers: dict[Asked, int] = {}
    workings: dict[int, int] = {}
    units: dict[Asked, str] = {}
    for place, cell in enumerate(cells):
        asked, unit = answer_of(cell, sheet)
        if asked is not None and asked not in answers:
            answers[asked] = place
            units |= {asked: unit} if unit else {}
    free = [place for place in range(len(cells)) if place not in answers.values()]
    for number, words in enumerate(words_for_working(task, sheet) for task in range(len(sheet.tasks))):
        found = place_called(cells, free, words)
        if found is not None:
            workings[number] = found
            free.remove(found)
    people = places_of_people(cells, free)
    taken = {*people.values()}
    unused = tuple(cells[place] for place in free if place not in taken and cells[place])
    remarks = filter(None, (sheet.other_label(cells[place]) for place in answers.values()))
    return Columns(separator, len(cells), answers, workings, people, unused, units, len(row), tuple(remarks))


def words_for_working(place: int, sheet: SheetTask) -> tuple[str, ...]:
    """The headings of the working of a problem: `1.working`; `working` alone where there is one problem."""
    task = sheet.tasks[place]
    own = (f"{head}.{word}" for head in (str(task.number), task.name.casefold()) for word in WORKING)
    return (*(own if sheet.is_sheet else ()), *(WORKING if len(sheet.tasks) == 1 else ()))


def places_of_people(cells: Sequence[str], free: Sequence[int]) -> dict[str, int]:
    """The places of what says whose a row is; the first column that is nothing else where none does."""
    left, found = list(free), dict[str, int]()
    table = {CANVAS: ("id",), **PEOPLE} if any(plain_heading(cell).startswith(OF_CANVAS) for cell in cells) else PEOPLE
    for kind, words in table.items():
        place = place_called(cells, left, words)
        if place is not None:
            found[kind] = place
            left.remove(place)
    if not found.keys() - {VARIANT, SECTION} and left:
        found[NAME] = left[0]
    return found


def answer_of(cell: str, sheet: SheetTask) -> tuple[Asked | None, str]:
    """The answer that a cell names, and the unit that it tells: `1.a (m/s²)`."""
    whole = sheet.meant(cell)
    match = WITH_UNIT.fullmatch(cell) if whole is None else None
    asked = sheet.meant(match["name"]) if match else None
    if match is None or asked is None:
        return whole, ""
    unit = next(filter(None, (match["round"], match["square"], match["plain"]))).strip()
    try:
        return asked, parse_unit(unit).text
    except FormulaError:
        return asked, ""


def column_of_other_unit(found: Columns, cells: Sequence[str], sheet: SheetTask) -> tuple[str, str, str] | None:
    """A heading whose unit is none of what it names, with what is wrong and what would do."""
    for asked, unit in found.units.items():
        dimension = sheet.tasks[asked[0]].dimensions.get(asked[1])
        if dimension is not None and not parse_unit(unit).dimension.matches(dimension):
            cell, wanted = cells[found.answers[asked]], unit_for(dimension).text
            help = f"write {quoted(f'{sheet.key(asked)} ({wanted})')}, or leave the unit out"
            return cell, f"{quoted(unit)} is no unit of {sheet.key(asked)}", help
    return None


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


def plain_heading(cell: str) -> str:
    """A heading in small letters, whatever joins its words."""
    return " ".join(re.sub(r"[_\-/]|\.(?!\w)", " ", cell.lower()).split())


def place_called(cells: Sequence[str], free: Sequence[int], words: Sequence[str]) -> int | None:
    """The first place of those that are free whose cell is one of the words, by the order of the words."""
    lower = {place: plain_heading(cells[place]) for place in free}
    meant = [plain_heading(word) for word in words]
    return next((place for word in meant for place in free if lower[place] == word), None)


def doubled_column(cells: Sequence[str], sheet: SheetTask) -> str:
    """A cell that names an answer which another cell before it names too."""
    seen: set[Asked] = set()
    for cell in cells:
        asked, _ = answer_of(cell, sheet)
        if asked in seen:
            return cell
        if asked is not None:
            seen.add(asked)
    return ""
