"""Files: what each format makes of sheets and keys. A variant's own files are ready at once; those that hold all variants at the end."""

from __future__ import annotations

import csv
import io
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from rotsolve.keys.sheets import Sheet, SheetPage, key_blocks, key_data, solution_pages
from rotsolve.page.blocks import FixedPage, PageBlock, Paragraph, Title
from rotsolve.page.formats import DATA, Format, format_named
from rotsolve.page.languages import ENGLISH
from rotsolve.run.delivery import harmless

NamedContent = tuple[str, str | bytes]  # the name of a file, and what it holds
Row = tuple[str, ...]
CSV = "csv"
CSV_FORMAT = Format(CSV, (".csv",), "tables for spreadsheets", "")  # no page, and none of the formats of pages
PROBLEM_COLUMNS = ("variant", "problem", "title", "text", "given", "find", "positive")
ANSWER_COLUMNS = ("variant", "problem", "given", "answer", "value", "unit", "direction", "word", "exact", "note")


def sheet_files(format: str, numbers: int, digits: int, *, solved: bool, language: str = ENGLISH) -> SheetFiles:
    """What makes the files of a format."""
    if format == CSV:
        return TableFiles(CSV_FORMAT, numbers, digits, False)
    chosen = format_named(format, language)
    return (DataFiles if chosen.use == DATA else PageFiles)(chosen, numbers, digits, solved)


class SheetFiles(ABC):
    """Makes the files of one format; `numbers` is how many digits the number of a variant has in a file's name, 0 without variants."""

    def __init__(self, format: Format, numbers: int, digits: int, solved: bool) -> None:
        self.format, self.numbers, self.digits = format, numbers, digits
        self.solved = solved  # whether the derivations are wanted too

    @abstractmethod
    def add(self, sheet: Sheet) -> Iterator[NamedContent]:
        """Take in one variant; the files that are its own."""

    @abstractmethod
    def close(self) -> Iterator[NamedContent]:
        """The files that hold all variants."""

    def name(self, word: str, variant: int = 0) -> str:
        """The name of a file: `sheet-07.html` for a variant; of all sheets `sheets.html`, or `sheet.html` where there is one."""
        word = "sheets" if word == "sheet" and self.numbers and not variant else word
        return f"{word}{f'-{variant:0{self.numbers}}' if variant else ''}{self.format.suffixes[0]}"


class PageFiles(SheetFiles):
    """Pages to be read: a sheet and, if wanted, the solutions of each variant; all sheets; one key."""

    def __init__(self, format: Format, numbers: int, digits: int, solved: bool) -> None:
        super().__init__(format, numbers, digits, solved)
        self.sheets: list[str] = []
        self.key: list[PageBlock] = [Title(1, ("Answer key",))]

    def add(self, sheet: Sheet) -> Iterator[NamedContent]:
        if sheet.variant and not self.sheets:
            self.key.append(Paragraph((f"Variants by seed {sheet.seed}",)))
        self.sheets.append(self.format.body(SheetPage(sheet)))
        self.key.extend(key_blocks(sheet, self.digits))
        if sheet.variant:
            yield self.name("sheet", sheet.variant), self.format.file(self.sheets[-1:])
        if self.solved:
            bodies = [*map(self.format.body, solution_pages(sheet, self.digits))]
            yield self.name("solutions", sheet.variant), self.format.file(bodies)

    def close(self) -> Iterator[NamedContent]:
        yield self.name("sheet"), self.format.file(self.sheets)
        yield self.name("key"), self.format.file([self.format.body(FixedPage(tuple(self.key)))])


class DataFiles(SheetFiles):
    """Data for programs: all sheets, all answers and all derivations, a file each."""

    def __init__(self, format: Format, numbers: int, digits: int, solved: bool) -> None:
        super().__init__(format, numbers, digits, solved)
        self.sheets: list[dict[str, Any]] = []
        self.key: list[dict[str, Any]] = []
        self.bodies: list[str] = []

    def add(self, sheet: Sheet) -> Iterator[NamedContent]:
        self.sheets.append(SheetPage(sheet).data())
        self.key.append(key_data(sheet, self.digits))
        if self.solved:
            self.bodies += map(self.format.body, solution_pages(sheet, self.digits))
        yield from ()

    def close(self) -> Iterator[NamedContent]:
        for name, sheets in (("sheet", self.sheets), ("key", self.key)):
            yield self.name(name), self.format.file([self.format.body(FixedPage(values={"sheets": sheets}))])
        if self.solved:
            yield self.name("solutions"), self.format.file(self.bodies)


class TableFiles(DataFiles):
    """CSV for spreadsheets: all statements and all answers, a row each; no cell can be a formula."""

    def close(self) -> Iterator[NamedContent]:
        yield self.name("sheet"), csv_text(PROBLEM_COLUMNS, rows_of_sheets(self.sheets, problem_cells))
        yield self.name("key"), csv_text(ANSWER_COLUMNS, rows_of_sheets(self.key, answer_cells))


def rows_of_sheets(
    sheets: Iterable[Mapping[str, Any]], cells: Callable[[Mapping[str, Any]], Iterator[Row]]
) -> Iterator[Row]:
    """Rows for the data of each problem, with its variant and its name in front."""
    for sheet in sheets:
        for problem in sheet["problems"]:
            yield from ((str(sheet.get("variant", "")), problem["problem"], *row) for row in cells(problem))


def problem_cells(problem: Mapping[str, Any]) -> Iterator[Row]:
    """A statement."""
    lists = ("; ".join(problem[key]) for key in ("given", "find", "positive"))
    yield (problem["title"], problem["text"].replace("\n", " "), *lists)


def answer_cells(problem: Mapping[str, Any]) -> Iterator[Row]:
    """The answers, a row each."""
    givens = "; ".join(given["text"] for given in problem["given"])
    for label, answer in with_components(problem["answers"]):
        texts = (answer[key] or "" for key in ("value", "unit", "direction", "word"))
        yield (givens, label, *texts, answer["exact"]["text"] if answer["exact"] else "", answer["note"])


def with_components(answers: Iterable[Mapping[str, Any]], whole: str = "") -> Iterator[tuple[str, Mapping[str, Any]]]:
    """The answers with their components, which take the name of their vector or matrix in front."""
    for answer in answers:
        label = f"{whole}.{answer['name'].removeprefix(f'{whole}_')}" if whole else answer["name"]
        if "rows" not in answer:
            yield label, answer
        yield from with_components(answer["components"], label)


def csv_text(columns: tuple[str, ...], rows: Iterable[Row]) -> str:
    """Comma-separated values with their heading."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(tuple(map(harmless, row)) for row in rows)
    return stream.getvalue()
