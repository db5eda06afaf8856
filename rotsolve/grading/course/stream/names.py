"""Names: in which lines a name stands, of as many papers as there are: kept on disk, in a table that goes with the process."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterable

from rotsolve.grading.course.table import NAMED, Entry


class NamedLines:
    """The lines of each name, however it is capitalised."""

    def __init__(self, entries: Iterable[Entry]) -> None:
        self.papers = 0  # how many rows there are
        self.table = sqlite3.connect("")  # a file without a name, of which little is in memory
        self.table.execute("CREATE TABLE names (name TEXT, line INTEGER)")
        self.table.executemany("INSERT INTO names VALUES (?, ?)", map(self.counted, entries))
        self.table.execute("CREATE INDEX by_name ON names (name)")

    def counted(self, entry: Entry) -> tuple[str, int]:
        self.papers += 1
        return entry.student.casefold(), entry.line

    def first(self, entry: Entry) -> list[int]:
        """The first lines that its name stands in, one more than a remark names."""
        asked = "SELECT line FROM names WHERE name = ? ORDER BY rowid LIMIT ?"
        return [line for (line,) in self.table.execute(asked, (entry.student.casefold(), NAMED + 1))]
