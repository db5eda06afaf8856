"""Results: the rows of a class with what marking gave."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.grading.course.report.page import Task
from rotsolve.grading.course.table import Columns, Entry
from rotsolve.grading.verdict import Marked


class Result(Struct, frozen=True):
    """A row, marked; None and the reason among the remarks of the row where it could not be."""

    entry: Entry
    marked: Marked | None

    @property
    def name(self) -> str:
        """The student's name, or the line where there is none."""
        return self.entry.student or f"line {self.entry.line}"

    @property
    def variant(self) -> str:
        return "" if self.entry.paper is None else self.entry.paper.variant


class Course(Struct, frozen=True):
    """A class: the problem, the columns of its table, and its rows; the seed of the variants where the problem has such."""

    task: Task
    columns: Columns
    results: tuple[Result, ...]
    byte_order_mark: bool = False
    seed: int | None = None
