"""Records: one way to read a student's line, and why a line can not be read."""

from __future__ import annotations

import re

from msgspec import Struct

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.notation.tokens import FormulaError, UnknownName
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.grading.verdict import Remark

_DEGREES = re.compile(r"(\d+(?:\.\d+)?) π/180(?!\d)")  # how 30° is printed, an exact number
FORMULA, NUMBER, VECTOR, WORD, EQUATION = "formula", "number", "vector", "word", "equation"


class Reading(Struct, frozen=True):
    """What a line says, read in one way; `written` is its echo where that is not just its formula.

    `formula` is that of a formula or the exact number in the unit as typed; of an equation it is the left side, with numbers in SI units.
    `unit` is the unit as typed, `figures` the significant figures of a number, None where it is exact (1/2, √3) or worked out.
    `parts` are the components of a vector; where it was told by size and direction, `polar` holds these two as typed.
    `direction` is that of a number told in words: "down", "clockwise".
    """

    kind: str
    written: str = ""
    formula: Formula | None = None
    unit: Unit | None = None
    figures: int | None = None
    parts: tuple[Reading, ...] = ()
    right: Formula | None = None
    remarks: tuple[Remark, ...] = ()
    polar: tuple[Reading, ...] = ()
    direction: str = ""

    @property
    def text(self) -> str:
        """The echo of the line, as the program would print it."""
        if self.written or self.formula is None:
            return self.written
        return echo(self.formula)

    @property
    def has_units(self) -> bool:
        """Whether a unit was read, perhaps in a component."""
        return self.unit is not None or any(part.has_units for part in self.parts)


def echo(formula: Formula) -> str:
    """A formula as it is said back: 30° as it was typed, though it is an exact number."""
    return _DEGREES.sub(r"\1°", to_text(formula))


class AnswerError(ValueError):
    """A line that can not be read: what is wrong, in which columns of the text as typed, and perhaps what was meant.

    `unknown` is the name that the scene does not declare, where that is what is wrong.
    """

    def __init__(self, message: str, start: int, end: int, suggestion: str | None = None, unknown: str = "") -> None:
        super().__init__(message if suggestion is None else f"{message}; did you mean `{suggestion}`?")
        self.message = message
        self.start = start
        self.end = end
        self.suggestion = suggestion
        self.unknown = unknown

    @classmethod
    def of(cls, error: FormulaError, text: str) -> AnswerError:
        """The fault of a formula within a line."""
        unknown = text[error.start : error.end] if isinstance(error, UnknownName) else ""
        return cls(error.message, error.start, error.end, error.suggestion, unknown)
