"""Files: what each format makes of sheets and keys. A variant's own files are ready at once; those that hold all variants at the end."""

from __future__ import annotations

import csv
import io
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from msgspec.structs import replace

from rotsolve.keys.sheets import Sheet, SheetPage, key_blocks, key_data, solution_pages
from rotsolve.language.sheet_keys import A4
from rotsolve.page.blocks import FixedPage, PageBlock, Paragraph, Title, authored
from rotsolve.page.formats import DATA, Format, format_named
from rotsolve.page.languages import ENGLISH
from rotsolve.run.delivery import harmless

NamedContent = tuple[str, str | bytes]  # the name of a file, and what it holds
Row = tuple[str, ...]
CSV = "csv"
BESIDE = ("latex", "typst", "markdown")  # formats whose pages refer to the files of their images
CSV_FORMAT = Format(CSV, (".csv",), "tables for spreadsheets", "")  # no page, and none of the formats of pages
PROBLEM_COLUMNS = ("variant", "number", "problem", "title", "points", "text", "given", "find", "positive")
ANSWER_COLUMNS = (
    *("variant", "number", "problem", "given", "part", "answer", "value", "unit", "direction", "word", "exact", "note"),
    *("points", "tolerance"),
)


def sheet_files(
    format: str, numbers: int, digits: int, *, solved: bool, language: str = ENGLISH, paper: str = A4
) -> SheetFiles:
    """What makes the files of a format."""
    if format == CSV:
        return TableFiles(CSV_FORMAT, numbers, digits, False)
    chosen = replace(format_named(format, language), paper=paper)
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
        self.key: list[PageBlock] = []
        self.names = frozenset[str]()
        self.images: dict[str, bytes] = {}

    def add(self, sheet: Sheet) -> Iterator[NamedContent]:
        if not self.sheets:
            self.names = sheet.names()
            self.key += key_head(sheet)
            self.images = {image.name: image.content() or b"" for image in sheet.images()}
            yield from images_beside(self.format, self.images)
        self.sheets.append(self.format.body(SheetPage(sheet)))
        self.key.extend(key_blocks(sheet, self.digits))
        if sheet.variant:
            yield self.name("sheet", sheet.variant), self.format.file(self.sheets[-1:], self.images)
        if self.solved:
            bodies = [*map(self.format.body, solution_pages(sheet, self.digits))]
            yield self.name("solutions", sheet.variant), self.format.file(bodies, self.images)

    def close(self) -> Iterator[NamedContent]:
        yield self.name("sheet"), self.format.file(self.sheets, self.images)
        yield self.name("key"), self.format.file([self.format.body(KeyPage(tuple(self.key), words=self.names))])


class KeyPage(FixedPage, frozen=True):
    """The answers of all variants."""

    words: frozenset[str] = frozenset()

    def names(self) -> frozenset[str]:
        return self.words


def key_head(sheet: Sheet) -> Iterator[PageBlock]:
    """The title of a key, that of its sheet, and the seed of its variants."""
    yield Title(1, ("Answer key", *((": ", authored(sheet.set.title)) if sheet.set.title else ())))
    if sheet.variant:
        yield Paragraph((f"Variants by seed {sheet.seed}",))


def images_beside(format: Format, images: Mapping[str, bytes]) -> Iterator[NamedContent]:
    """The files of the images to which the pages of a format refer; an SVG for LaTeX as a PDF."""
    if format.name not in BESIDE:
        return
    for name, content in images.items():
        if format.name == "latex" and name.endswith(".svg"):
            from rotsolve.page.press import printed_image

            yield name.replace(".svg", ".pdf"), printed_image(name, content)
        else:
            yield name, content


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
            place = (str(sheet.get("variant", "")), str(problem["number"]), problem["problem"])
            yield from ((*place, *row) for row in cells(problem))


def problem_cells(problem: Mapping[str, Any]) -> Iterator[Row]:
    """A statement."""
    given, positive = ("; ".join(problem[key]) for key in ("given", "positive"))
    find = "; ".join(f"({part['part']}) {part['asked']}" for part in problem["parts"])
    yield (problem["title"], problem["points"], " ".join(problem["text"].split()), given, find, positive)


def answer_cells(problem: Mapping[str, Any]) -> Iterator[Row]:
    """The answers, a row each."""
    givens = "; ".join(given["text"] for given in problem["given"])
    for whole in problem["answers"]:
        for label, answer in with_components([whole]):
            texts = (answer[key] or "" for key in ("value", "unit", "direction", "word"))
            exact = answer["exact"]["text"] if answer["exact"] else ""
            marks = (whole["points"], whole["tolerance"]) if answer is whole or "rows" in whole else ("", "")
            yield (givens, whole["part"], label, *texts, exact, answer["note"], *marks)


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
