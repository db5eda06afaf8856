"""Papers: a table of papers as a stream of rows: a CSV line by line, a Parquet file batch by batch; neither is ever held as a whole."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterator
from decimal import Decimal
from itertools import chain
from math import isfinite
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.core.faults import Fault, SceneError, missing_package
from rotsolve.grading.course.columns import Columns, columns_called, fault_of_headings
from rotsolve.grading.course.handed_in import BYTES, MARK, SAVE, HandedInError, file_error
from rotsolve.grading.course.questions import SheetTask
from rotsolve.grading.course.table import Entry, entries_of_file, opened_table, row_entry, tells_no_student
from rotsolve.language.words import quoted
from rotsolve.scene.encoding import decoded

PARQUET = (".parquet",)
AT_ONCE = 1000  # rows of a Parquet file


class PaperFile(Struct):
    """A table of papers: its columns, whether it began with a byte order mark, and its rows, each once, in their order."""

    columns: Columns
    byte_order_mark: bool
    entries: Iterator[Entry]


def is_parquet(file: str) -> bool:
    return file.lower().endswith(PARQUET)


def open_papers(file: str, sheet: SheetTask) -> PaperFile:
    """The table of a file, whose name says what it is; HandedInError where it is none."""
    try:
        if is_parquet(file):
            return open_parquet(file, sheet)
        lines = decoded_lines(file)
        first = next(lines, "")
        plain = first.removeprefix(MARK)
        columns, entries = opened_table(chain([plain], lines), file, sheet)
        return PaperFile(columns, first != plain, entries)
    except OSError as error:
        said = os.strerror(error.errno) if error.errno else error
        raise file_error(f"can't read {quoted(file)}: {said}") from None


# CSV


def decoded_lines(file: str) -> Iterator[str]:
    """The lines of a text file without what ends them; of one that is no UTF-8, what is wrong and where."""
    with open(file, "rb") as stream:
        number = 1
        while raw := stream.readline(BYTES + 1):
            if len(raw) > BYTES:
                raise file_error(f"line {number} has more than {BYTES} bytes", "is it a table?", file)
            try:
                text = decoded(raw, file, SAVE)
            except SceneError as error:
                raise HandedInError(*moved_down(error, number - 1), file) from None
            lines = text.removesuffix("\n").removesuffix("\r").replace("\r\n", "\n").replace("\r", "\n").split("\n")
            yield from lines
            number += len(lines)


def moved_down(error: SceneError, lines: int) -> tuple[list[Fault], tuple[str, ...]]:
    """The faults of a line, and the lines of the file as far as they show them, where so many lines stand above it."""
    faults = [
        replace(one, span=replace(one.span, line=one.span.line + lines)) if one.span else one for one in error.faults
    ]
    return faults, ("",) * lines + tuple(error.lines)


# Parquet


def open_parquet(file: str, sheet: SheetTask) -> PaperFile:
    """The table of a Parquet file: the names of its columns are what the first line of a CSV is."""
    pyarrow, parquet = parquet_packages()
    try:
        table = parquet.ParquetFile(file, pre_buffer=False)
    except pyarrow.ArrowInvalid as error:
        raise file_error("this is no Parquet file", str(error).partition(". ")[0], file) from None
    names = table.schema_arrow.names
    found = columns_called(names, "", sheet)
    fault = fault_of_headings(found, names, sheet)
    if fault is not None:
        raise file_error(fault[1], fault[2], file)
    used = {*found.answers.values(), *found.workings.values(), *found.people.values()}
    for place in used:
        refuse_kind(pyarrow, names[place], table.schema_arrow.types[place], file)
    rows = (row for batch in table.iter_batches(AT_ONCE) for row in cell_rows(batch, used))
    entries = (row_entry(number, row, found, sheet) for number, row in enumerate(rows, 1) if not tells_no_student(row))
    return PaperFile(found, False, entries_of_file(entries, file))


def parquet_packages() -> tuple[Any, Any]:
    """The package that reads and writes Parquet."""
    try:
        import pyarrow
        from pyarrow import parquet
    except ModuleNotFoundError:
        raise missing_package("Parquet takes", "pyarrow", "parquet") from None
    return pyarrow, parquet


def refuse_kind(pyarrow: Any, name: str, kind: Any, file: str) -> None:
    """HandedInError for a column of what is neither texts nor numbers, nor lists of them."""
    types = pyarrow.types
    if types.is_dictionary(kind):
        kind = kind.value_type
    if types.is_list(kind) or types.is_large_list(kind) or types.is_fixed_size_list(kind):
        kind = kind.value_type
    plain = ("string", "large_string", "string_view", "integer", "floating", "decimal", "null")
    if not any(getattr(types, f"is_{word}")(kind) for word in plain if hasattr(types, f"is_{word}")):
        raise file_error(f"the column {quoted(name)} holds {kind}", "texts and numbers are read", file)


def cell_rows(batch: Any, used: Collection[int]) -> Iterator[list[str]]:
    """The rows of a batch as the cells of a CSV, '' in columns that are not used."""
    nothing = [""] * batch.num_rows
    columns = (
        [cell_text(value) for value in column.to_pylist()] if place in used else nothing
        for place, column in enumerate(batch.columns)
    )
    return map(list, zip(*columns, strict=True))


def cell_text(value: object) -> str:
    """A value as it would stand in a CSV: a list of texts with a line each, one of numbers as a vector, '' for what is missing."""
    match value:
        case None:
            return ""
        case float():
            return repr(value) if isfinite(value) else ""  # how pandas writes what is missing
        case Decimal():
            return f"{value:f}"
        case list():
            texts = [cell_text(item) for item in value]
            of_texts = all(isinstance(item, str) for item in value)
            return "\n".join(texts) if of_texts else f"({', '.join(texts)})"
    return str(value)
