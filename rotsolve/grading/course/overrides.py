"""Overrides: marks that a teacher gives by hand, in `overrides.csv` of the report, each with its reason. They stay from run to run."""

from __future__ import annotations

import csv
import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.core.faults import Fault, Span
from rotsolve.grading.course.columns import SEPARATORS, plain_heading
from rotsolve.grading.course.handed_in import MARK, HandedInError, content_of
from rotsolve.grading.course.marked import MarkedSheet
from rotsolve.grading.course.questions import Asked, SheetTask
from rotsolve.grading.course.students import Student
from rotsolve.grading.course.table import plain_cell
from rotsolve.grading.verdict import BY_HAND, Marked, Remark, Verdict
from rotsolve.keys.parts import exact_points
from rotsolve.language.words import hint, quoted

OVERRIDES = "overrides.csv"
HEADS = STUDENT, NUMBER, PART, MARKS, REASON = ("name", "number", "part", "mark", "reason")
NEEDED = (PART, MARKS)
A_MARK = re.compile(r"\d{1,6}(?:[.,]\d{1,6})?|\d{1,6}/[1-9]\d{0,5}")


class Override(Struct, frozen=True):
    """A mark by hand: of which answer, how many marks, and why."""

    asked: Asked
    marks: Fraction
    reason: str
    line: int


Overrides = Mapping[int, Sequence[Override]]  # by the place of the student


def empty_overrides(separator: str, mark: str) -> str:
    """The table before there is anything in it."""
    return f"{mark}{separator.join(HEADS)}\n"


def read_overrides(folder: Path, sheet: SheetTask, students: Sequence[tuple[Student, str]]) -> Overrides:
    """The marks by hand of each student, who is known by the number, the name, or what tells equal names apart. HandedInError names all
    rows with a fault."""
    path = folder / OVERRIDES
    if not path.is_file():
        return {}
    text = content_of(str(path)).removeprefix(MARK)
    return OverrideReader(text.split("\n"), str(path), sheet, students).read()


class OverrideReader:
    """Reads the table; all its faults are told at once."""

    def __init__(
        self, lines: Sequence[str], file: str, sheet: SheetTask, students: Sequence[tuple[Student, str]]
    ) -> None:
        self.lines, self.file, self.sheet, self.students = lines, file, sheet, students
        self.faults: list[Fault] = []
        self.line = 0

    def read(self) -> Overrides:
        found: dict[int, dict[Asked, Override]] = {}
        start = next((place for place, line in enumerate(self.lines) if line.strip()), None)
        if start is None:
            return {}
        self.line = start + 1
        separator, columns = self.columns(self.lines[start])
        for number, line in enumerate(self.lines[start + 1 :], start + 2):
            self.line = number
            if line.strip(" ,;\t") and columns:
                self.add(self.cells(line, separator), columns, found)
        if self.faults:
            raise HandedInError(self.faults, self.lines, self.file)
        return {place: tuple(own.values()) for place, own in found.items()}

    def columns(self, head: str) -> tuple[str, dict[str, int]]:
        """What separates the columns, and where each of them is."""
        tried = {sign: [plain_heading(cell) for cell in self.cells(head, sign)] for sign in SEPARATORS}
        separator, cells = max(tried.items(), key=lambda item: len({*HEADS}.intersection(item[1])))
        columns = {name: cells.index(name) for name in HEADS if name in cells}
        missing = [name for name in NEEDED if name not in columns]
        if missing or not {STUDENT, NUMBER} & columns.keys():
            message = f"there is no column {quoted((missing or [NUMBER])[0])}"
            self.fault(message, head, f"its first line is: {separator.join(HEADS)}")
            return separator, {}
        return separator, columns

    def cells(self, line: str, separator: str) -> list[str]:
        return next(csv.reader([line], delimiter=separator), [])

    def fault(self, message: str, text: str, help: str) -> None:
        """A fault of the row, at the text that it is about."""
        column = self.lines[self.line - 1].find(text) + 1 if text else 0
        self.faults.append(Fault(message, Span(self.line, max(1, column), max(1, len(text))), help))

    def add(self, cells: Sequence[str], columns: Mapping[str, int], found: dict[int, dict[Asked, Override]]) -> None:
        """One row."""
        said = {name: plain_cell(cells, columns.get(name)) for name in HEADS}
        if len(cells) > max(columns.values()) + 1 and any(cells[max(columns.values()) + 1 :]):
            self.fault("the row has too many cells", "", "put a reason or mark that holds a comma in quotes")
            return
        place, asked = self.student(said[STUDENT], said[NUMBER]), self.asked(said[PART])
        marks = None if asked is None else self.marks(said[MARKS], asked)
        if place is None or asked is None or marks is None:
            return
        own = found.setdefault(place, {})
        if asked in own:
            help = "leave one of them out"
            self.fault(f"this answer has a mark by hand in line {own[asked].line} already", said[PART], help)
        own[asked] = Override(asked, marks, said[REASON], self.line)

    def student(self, name: str, number: str) -> int | None:
        """The place of the student that is meant."""
        if not name and not number:
            self.fault("the row says no student", "", "write the name, or the number")
            return None
        same = Student("", number).identity(NUMBER)
        meant = [place for place, (student, _) in enumerate(self.students) if same and student.identity(NUMBER) == same]
        if number and not meant:
            numbers = tuple(student.number for student, _ in self.students if student.number)
            self.fault(f"no student has the number {quoted(number)}", number, hint(number, numbers, "numbers"))
            return None
        among = meant or range(len(self.students))
        called = Student(name)
        exact = [place for place in among if self.students[place][1].casefold() == name.casefold()]
        found = exact or [place for place in among if not name or self.students[place][0].words == called.words]
        if len(found) == 1:
            return found[0]
        labels = tuple(self.students[place][1] for place in found or among)
        if found:
            self.fault(f"{quoted(name)} may be several students", name, f"write one of: {', '.join(labels)}")
            return None
        message = f"the number {number} is that of {labels[0]}" if meant else f"no student is called {quoted(name)}"
        self.fault(message, name, hint(name, labels, "students"))
        return None

    def asked(self, word: str) -> Asked | None:
        """The answer that is meant."""
        asked = self.sheet.meant(word) if word else None
        if asked is None or asked[1] not in self.sheet.tasks[asked[0]].letters:
            message = f"no answer is called {quoted(word)}" if word else "the row says no part"
            self.fault(message, word, hint(word, self.sheet.names(), "asked"))
            return None
        return asked

    def marks(self, text: str, asked: Asked) -> Fraction | None:
        """The mark, from nothing to all that there are."""
        most = self.sheet.tasks[asked[0]].points[asked[1]]
        whole = f"write a number from 0 to {exact_points(most)}"
        if not A_MARK.fullmatch(text):
            self.fault(f"{quoted(text)} is no mark" if text else "the row has no mark", text, whole)
            return None
        found = Fraction(text.replace(",", "."))
        if found > most:
            key = self.sheet.key(asked)
            self.fault(f"{text} is more than the {exact_points(most)} marks of {quoted(key)}", text, whole)
            return None
        return found


def with_overrides(marked: MarkedSheet, overrides: Sequence[Override]) -> MarkedSheet:
    """A paper with the marks that were given by hand."""
    problems = list(marked.problems)
    for one in overrides:
        problems[one.asked[0]] = with_override(problems[one.asked[0]], one)
    return replace(marked, problems=tuple(problems))


def with_override(marked: Marked, override: Override) -> Marked:
    """The papers of one problem with a mark by hand."""
    said = f"{BY_HAND}: {override.reason}" if override.reason else BY_HAND
    verdict = Verdict(BY_HAND, "", (Remark("by hand", (said,)),))
    parts = tuple(
        replace(part, verdict=verdict, marks=override.marks, followed=False) if part.name == override.asked[1] else part
        for part in marked.parts
    )
    return replace(marked, parts=parts, marks=sum((part.marks for part in parts), Fraction(0)))
