"""Files: what each format makes of sheets and keys. A variant's own files are ready at once; those that hold all variants at the end."""

from __future__ import annotations

import csv
import io
from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator
from typing import Any

from rotsolve.core.derivation import Answer
from rotsolve.keys.sheets import (
    Sheet,
    SheetPage,
    given_phrases,
    key_blocks,
    key_data,
    solution_pages,
    statement_data,
)
from rotsolve.page.blocks import FixedPage, PageBlock, Paragraph, Title
from rotsolve.page.data import answer_data
from rotsolve.page.formats import DATA, FORMATS, Format
from rotsolve.page.text import plain_text
from rotsolve.run.delivery import harmless

NamedText = tuple[str, str]  # the name of a file, and its text
CSV = "csv"  # a table of answers is no page, so that it is none of the formats of pages
PROBLEM_COLUMNS = ("variant", "problem", "title", "text", "given", "find", "positive")
ANSWER_COLUMNS = ("variant", "problem", "given", "answer", "value", "unit", "direction", "word", "exact", "note")


def sheet_files(format: str, numbers: int, digits: int, *, solved: bool) -> SheetFiles:
    """What makes the files of a format."""
    if format == CSV:
        return TableFiles(numbers, digits)
    chosen = FORMATS[format]
    return (DataFiles if chosen.use == DATA else PageFiles)(chosen, numbers, digits, solved)


class SheetFiles(ABC):
    """Makes the files of one format; `numbers` is how many digits the number of a variant has in a file's name, 0 without variants."""

    def __init__(self, numbers: int, digits: int) -> None:
        self.numbers, self.digits = numbers, digits

    @abstractmethod
    def add(self, sheet: Sheet) -> Iterator[NamedText]:
        """Take in one variant; the files that are its own."""

    @abstractmethod
    def close(self) -> Iterator[NamedText]:
        """The files that hold all variants."""

    @property
    def all(self) -> str:
        """The name of a file that holds all sheets: `sheets`, or `sheet` where there is one."""
        return "sheets" if self.numbers else "sheet"


class PageFiles(SheetFiles):
    """Pages to be read: a sheet and, if wanted, the solutions of each variant; all sheets; one key."""

    def __init__(self, format: Format, numbers: int, digits: int, solved: bool) -> None:
        super().__init__(numbers, digits)
        self.format, self.solved = format, solved  # whether the derivations are wanted too
        self.sheets: list[str] = []
        self.key: list[PageBlock] = [Title(1, ("Answer key",))]

    def name(self, word: str, variant: int = 0) -> str:
        return f"{word}{f'-{variant:0{self.numbers}}' if variant else ''}{self.format.suffixes[0]}"

    def add(self, sheet: Sheet) -> Iterator[NamedText]:
        if sheet.variant and not self.sheets:
            self.key.append(Paragraph((f"Variants by seed {sheet.seed}",)))
        self.sheets.append(self.format.body(SheetPage(sheet)))
        self.key.extend(key_blocks(sheet, self.digits))
        if sheet.variant:
            yield self.name("sheet", sheet.variant), self.format.document(self.sheets[-1:])
        if self.solved:
            bodies = [*map(self.format.body, solution_pages(sheet, self.digits))]
            yield self.name("solutions", sheet.variant), self.format.document(bodies)

    def close(self) -> Iterator[NamedText]:
        yield self.name(self.all), self.format.document(self.sheets)
        yield self.name("key"), self.format.document([self.format.body(FixedPage(tuple(self.key)))])


class DataFiles(SheetFiles):
    """Data for programs: all sheets, all answers and all derivations, a file each."""

    def __init__(self, format: Format, numbers: int, digits: int, solved: bool) -> None:
        super().__init__(numbers, digits)
        self.format, self.solved = format, solved
        self.sheets: list[dict[str, Any]] = []
        self.key: list[dict[str, Any]] = []
        self.bodies: list[str] = []

    def add(self, sheet: Sheet) -> Iterator[NamedText]:
        self.sheets.append(SheetPage(sheet).data())
        self.key.append(key_data(sheet, self.digits))
        if self.solved:
            self.bodies += map(self.format.body, solution_pages(sheet, self.digits))
        yield from ()

    def close(self) -> Iterator[NamedText]:
        ending = self.format.suffixes[0]
        for name, sheets in ((self.all, self.sheets), ("key", self.key)):
            yield f"{name}{ending}", self.format.document([self.format.body(FixedPage(values={"sheets": sheets}))])
        if self.solved:
            yield f"solutions{ending}", self.format.document(self.bodies)


class TableFiles(SheetFiles):
    """CSV for spreadsheets: all statements and all answers, a row each; no cell can be a formula."""

    def __init__(self, numbers: int, digits: int) -> None:
        super().__init__(numbers, digits)
        self.sheets: list[tuple[str, ...]] = []
        self.key: list[tuple[str, ...]] = []

    def add(self, sheet: Sheet) -> Iterator[NamedText]:
        self.sheets.extend(problem_cells(sheet))
        self.key.extend(answer_cells(sheet, self.digits))
        yield from ()

    def close(self) -> Iterator[NamedText]:
        yield f"{self.all}.csv", csv_text(PROBLEM_COLUMNS, self.sheets)
        yield "key.csv", csv_text(ANSWER_COLUMNS, self.key)


def problem_cells(sheet: Sheet) -> Iterator[tuple[str, ...]]:
    """The statements of one variant, a row each."""
    for name, worked in sheet.problems:
        said = statement_data(name, worked)
        lists = (said["text"].replace("\n", " "), *("; ".join(said[key]) for key in ("given", "find", "positive")))
        yield (str(sheet.variant or ""), name, said["title"], *lists)


def answer_cells(sheet: Sheet, digits: int) -> Iterator[tuple[str, ...]]:
    """The answers of one variant, a row each; the components of a vector have rows of their own behind it."""
    for name, worked in sheet.problems:
        givens = "; ".join(map(plain_text, given_phrases(worked)))
        for label, answer in with_components(worked.answers):
            data = answer_data(answer, digits)
            exact = data["exact"]["text"] if data["exact"] else ""
            cells = (label, data["value"] or "", data["unit"], data["direction"], data["word"], exact, data["note"])
            yield (str(sheet.variant or ""), name, givens, *cells)


def with_components(answers: Iterable[Answer], whole: str = "") -> Iterator[tuple[str, Answer]]:
    """The answers with their components, which take the name of their vector or matrix in front."""
    for answer in answers:
        label = f"{whole}.{answer.name.removeprefix(f'{whole}_')}" if whole else answer.name
        if not answer.rows:
            yield label, answer
        yield from with_components(answer.components, label)


def csv_text(columns: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> str:
    """Comma-separated values with their heading."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(tuple(map(harmless, row)) for row in rows)
    return stream.getvalue()
