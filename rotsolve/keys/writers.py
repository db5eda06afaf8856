"""Writers: the files of each format. A variant's own files are ready at once; those that hold all variants at the end."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator
from typing import Any

from rotsolve.keys.layouts import LAYOUTS
from rotsolve.keys.sheets import Sheet, key_lines, problem_sheet, solutions
from rotsolve.keys.tables import (
    ANSWER_COLUMNS,
    PROBLEM_COLUMNS,
    answer_rows,
    key_data,
    problem_rows,
    problems_data,
    table,
)
from rotsolve.render import format_named
from rotsolve.render.json import text

File = tuple[str, str]  # its name and its text


class Writer(ABC):
    """Makes the files of one format; `numbers` is how many digits the number of a variant has in a file's name, 0 without variants."""

    def __init__(self, format: str, numbers: int, digits: int, solved: bool) -> None:
        self.format = format
        self.numbers = numbers
        self.digits = digits
        self.solved = solved  # whether the derivations are wanted too

    @abstractmethod
    def add(self, sheet: Sheet) -> Iterator[File]:
        """Take in one variant; the files that are its own."""

    @abstractmethod
    def close(self) -> Iterator[File]:
        """The files that hold all variants."""

    def all(self, word: str) -> str:
        """The name of a file that holds all sheets: `sheets.csv`, or `sheet.csv` where there is one."""
        return f"{word}{'s' if self.numbers else ''}"


class Pages(Writer):
    """Markdown, LaTeX and HTML: a sheet and, if wanted, the solutions of each variant; all sheets; one key."""

    def __init__(self, format: str, numbers: int, digits: int, solved: bool) -> None:
        super().__init__(format, numbers, digits, solved)
        self.chosen = format_named(format)
        self.layout = LAYOUTS[format]
        self.sheets: list[str] = []
        self.key = [self.layout.heading(1, "Answer key")]

    def name(self, word: str, sheet: Sheet | None = None) -> str:
        number = f"-{sheet.variant:0{self.numbers}}" if sheet is not None and sheet.variant else ""
        return f"{word}{number}{self.chosen.suffixes[0]}"

    def add(self, sheet: Sheet) -> Iterator[File]:
        if sheet.variant and not self.sheets:
            self.key.append(self.layout.paragraph("", f"Variants by seed {sheet.seed}"))
        page = problem_sheet(sheet, self.layout)
        self.sheets.append(page)
        self.key.extend(key_lines(sheet, self.layout, self.digits))
        if sheet.variant:
            yield self.name("sheet", sheet), self.layout.document([page])
        if self.solved:
            yield self.name("solutions", sheet), self.chosen.document(solutions(sheet, self.chosen, self.digits))

    def close(self) -> Iterator[File]:
        yield self.name(self.all("sheet")), self.layout.document(self.sheets)
        yield self.name("key"), self.layout.document([self.layout.sheet(self.key)])


class Json(Writer):
    """JSON: all sheets, all answers and all derivations, a file each."""

    def __init__(self, format: str, numbers: int, digits: int, solved: bool) -> None:
        super().__init__(format, numbers, digits, solved)
        self.sheets: list[dict[str, Any]] = []
        self.key: list[dict[str, Any]] = []
        self.bodies: list[str] = []

    def add(self, sheet: Sheet) -> Iterator[File]:
        self.sheets.append(problems_data(sheet))
        self.key.append(key_data(sheet, self.digits))
        if self.solved:
            self.bodies += solutions(sheet, format_named("json"), self.digits)
        yield from ()

    def close(self) -> Iterator[File]:
        yield f"{self.all('sheet')}.json", text({"sheets": self.sheets})
        yield "key.json", text({"sheets": self.key})
        if self.solved:
            yield "solutions.json", format_named("json").document(self.bodies)


class Csv(Writer):
    """CSV: all statements and all answers, a row each; derivations have no place in a table."""

    def __init__(self, format: str, numbers: int, digits: int, solved: bool) -> None:
        super().__init__(format, numbers, digits, solved)
        self.sheets: list[tuple[str, ...]] = []
        self.key: list[tuple[str, ...]] = []

    def add(self, sheet: Sheet) -> Iterator[File]:
        self.sheets.extend(problem_rows(sheet))
        self.key.extend(answer_rows(sheet, self.digits))
        yield from ()

    def close(self) -> Iterator[File]:
        yield f"{self.all('sheet')}.csv", table(PROBLEM_COLUMNS, self.sheets)
        yield "key.csv", table(ANSWER_COLUMNS, self.key)


WRITERS: dict[str, type[Writer]] = {**dict.fromkeys(LAYOUTS, Pages), "json": Json, "csv": Csv}
