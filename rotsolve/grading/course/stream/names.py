"""Names: in which lines a name or a number stands, of as many papers as there are: kept on disk, in a table that goes with the process."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterable

from msgspec import Struct

from rotsolve.grading.course.students import IDENTITIES, Student, name_and_identity, name_apart
from rotsolve.grading.course.table import NAMED, Entry, also_elsewhere

COLUMNS = ("line", "name", "called", "sure", *IDENTITIES)
LOOK = 1000  # rows of one name that are looked at for those which nothing tells apart


class NamedEntry(Struct, frozen=True):
    """A row, and what its student is called so that no two are called alike."""

    entry: Entry
    name: str


class NamedLines:
    """The lines of each name, however it is capitalised."""

    def __init__(self, entries: Iterable[Entry]) -> None:
        self.papers = 0  # how many rows there are
        self.table = sqlite3.connect("")  # a file without a name, of which little is in memory
        self.table.execute(f"CREATE TABLE rows ({', '.join(COLUMNS)})")
        self.table.executemany(f"INSERT INTO rows VALUES ({', '.join('?' * len(COLUMNS))})", map(self.counted, entries))
        for columns in ("name", "called, sure", *IDENTITIES):
            self.table.execute(f"CREATE INDEX [by {columns}] ON rows ({columns})")

    def counted(self, entry: Entry) -> tuple[int | str, ...]:
        self.papers += 1
        student = entry.student
        called, sure = name_and_identity(student, entry.place)
        identities = (student.identity(kind) for kind in IDENTITIES)
        return (entry.line, *(text.casefold() for text in (student.name, called, sure)), *identities)

    def named(self, entry: Entry) -> NamedEntry:
        """The row with its student's name told apart from others, and with remarks where something of it stands in other lines too."""
        name = name_and_identity(entry.student, entry.place)
        called, sure = (text.casefold() for text in name)
        own = self.number("called = ?", called), self.number("called = ? AND sure = ?", called, sure)
        if entry.student.name:
            entry = also_elsewhere(entry, "the same name", self.namesakes(entry))
        kind = next((kind for kind in IDENTITIES if getattr(entry.student, kind)), None)
        if kind is not None:
            said = getattr(entry.student, kind)
            entry = also_elsewhere(
                entry, f"the {kind} {said}", self.lines(entry, f"{kind} = ?", entry.student.identity(kind))
            )
        return NamedEntry(entry, name_apart(name, entry.place, *own))

    def number(self, where: str, *given: str) -> int:
        """How many rows there are of a kind, 2 for more."""
        return len(self.table.execute(f"SELECT 1 FROM rows WHERE {where} LIMIT 2", given).fetchall())

    def lines(self, entry: Entry, where: str, *given: str) -> list[int]:
        """The first lines of a kind but that of the row itself."""
        asked = f"SELECT line FROM rows WHERE {where} AND line <> ? ORDER BY rowid LIMIT {NAMED}"
        return [line for (line,) in self.table.execute(asked, (*given, entry.line))]

    def namesakes(self, entry: Entry) -> list[int]:
        """The first lines of the same name whose student shares no number or address with this one that would tell."""
        asked = (
            f"SELECT line, {', '.join(IDENTITIES)} FROM rows WHERE name = ? AND line <> ? ORDER BY rowid LIMIT {LOOK}"
        )
        found = []
        for line, *identities in self.table.execute(asked, (entry.student.name.casefold(), entry.line)):
            other = Student("", **dict(zip(IDENTITIES, identities, strict=True)))
            if entry.student.same_identity(other) is None:
                found.append(line)
            if len(found) == NAMED:
                break
        return found
