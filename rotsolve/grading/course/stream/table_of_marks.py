"""Table of marks: a row a paper, as CSV or as Parquet, written in a stream: the whole file or none."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Iterator
from itertools import islice
from pathlib import Path
from typing import Any

from rotsolve.grading.course.handed_in import MARK
from rotsolve.grading.course.questions import SheetTask
from rotsolve.grading.course.report.folder import marks_columns, spreadsheet_row
from rotsolve.grading.course.stream.papers import PaperFile, is_parquet, parquet_packages
from rotsolve.run.delivery import replacing

TABS = (".tsv", ".tab")
GROUP = 10_000  # rows that are written to a Parquet file at a time


def write_marks(output: str, rows: Iterable[list[str]], task: SheetTask, papers: PaperFile) -> None:
    """Write the rows; a CSV is separated as the papers are, unless its name says that it is by tabs."""
    with replacing(Path(output)) as fresh:
        if is_parquet(output):
            write_parquet(fresh, iter(rows), task)
            return
        separator = "\t" if output.lower().endswith(TABS) else papers.columns.separator or ","
        with fresh.open("w", encoding="utf-8", newline="") as stream:
            stream.write(MARK if papers.byte_order_mark else "")
            writer = csv.writer(stream, delimiter=separator, lineterminator="\n")
            writer.writerow(marks_columns(task))
            writer.writerows(spreadsheet_row(row, separator) for row in rows)


def write_parquet(fresh: Path, rows: Iterator[list[str]], task: SheetTask) -> None:
    """The rows with a type for each column; what a CSV leaves empty is null."""
    pyarrow, parquet = parquet_packages()
    schema = marks_schema(pyarrow, task)
    with parquet.ParquetWriter(fresh, schema) as writer:
        while group := list(islice(rows, GROUP)):
            cells = zip(*group, strict=True)
            arrays = [typed_column(pyarrow, column, field.type) for column, field in zip(cells, schema, strict=True)]
            writer.write_table(pyarrow.Table.from_arrays(arrays, schema=schema))


def marks_schema(pyarrow: Any, task: SheetTask) -> Any:
    """Lines are whole numbers, marks are numbers, all else is text."""
    text, number = pyarrow.string(), pyarrow.float64()
    answers = (text, number) * len(list(task.asked()))
    problems = (number,) * (len(task.tasks) if task.is_sheet else 0)
    kinds = [pyarrow.int64(), text, text, text, *answers, *problems, number, number, text]
    return pyarrow.schema(list(zip(marks_columns(task), kinds, strict=True)))


def typed_column(pyarrow: Any, column: Iterable[str], kind: Any) -> Any:
    """A column of texts as one of its type."""
    if pyarrow.types.is_string(kind):
        return pyarrow.array([text or None for text in column], kind)
    convert = float if pyarrow.types.is_floating(kind) else int
    return pyarrow.array([convert(text) if text else None for text in column], kind)
