"""Records: the letters that a student's line may use, one way to read it, and why it can not be read."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cached_property

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.letters import spellings
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.notation.tokens import FormulaError, UnknownName
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.core.symbols import TIME
from rotsolve.grading.reading.tokens import MAX_LENGTH
from rotsolve.grading.verdict import Remark

SHORT_TIME = "t"
_TOLD = re.compile(r"[\s$\\]*([^\W\d_]\w*)\s*[=≈:]")
_DEGREES = re.compile(r"(\d+(?:\.\d+)?) π/180(?!\d)")  # how 30° is printed, an exact number
FORMULA, NUMBER, VECTOR, EQUATION = "formula", "number", "vector", "equation"


class Names(Struct, frozen=True, dict=True):
    """Letters that the scene declares, by their ASCII names: its givens, and the quantities that it asks for.

    `asked` is the one that the line is to tell: `a = …` may stand in front. Without it a line with `=` is an equation. `components` is
    how many it has where it is a vector, or in a row where it is a matrix; 0 where it is a number, or where that is not known.
    Where the time is among the letters, t means it unless t is declared. `nouns` are the words for what is asked, `near` what may be
    typed for its letter, where no other can be meant.
    """

    givens: frozenset[str]
    answers: frozenset[str] = frozenset()
    asked: str = ""
    components: int = 0
    nouns: frozenset[str] = frozenset()
    near: frozenset[str] = frozenset()

    @classmethod
    def of(cls, givens: Iterable[str], answers: Iterable[str] = (), asked: str = "") -> Names:
        return cls(frozenset(givens), frozenset(answers), asked)

    @cached_property
    def letters(self) -> frozenset[str]:
        """All names that may be typed."""
        names = self.givens | self.answers
        return names | {SHORT_TIME} if TIME in names else names

    def meant(self, formula: Formula) -> Formula:
        """The formula with the time by its name in the scene."""
        if TIME not in self.letters or SHORT_TIME in self.givens or SHORT_TIME in self.answers:
            return formula
        return formula.substitute({SHORT_TIME: Symbol(TIME)})

    def is_asked(self, typed: str) -> bool:
        """Whether a spelling means the quantity that is asked for: `ω₀` is omega0."""
        if not typed:
            return False
        if typed == self.asked or self.asked in spellings(typed):
            return True
        return typed not in self.letters and (spelled_alike(typed, self.asked) or self.is_near(typed))

    def is_near(self, typed: str) -> bool:
        """Whether a letter that the scene does not have can only mean the quantity that is asked for."""
        return bool(self.near) and not self.near.isdisjoint(spellings(typed))

    def near_name(self, text: str) -> str:
        """The near letter with which a line tells what is asked for; '' where it has the letter itself, or none."""
        told = _TOLD.match(text)
        if told is None or self.asked in spellings(told[1]) or spelled_alike(told[1], self.asked):
            return ""
        return spellings(told[1])[0] if told[1] not in self.letters and self.is_near(told[1]) else ""


def spelled_alike(typed: str, name: str) -> bool:
    """Whether a spelling differs from a name in underlines or capitals alone, `Fx` for F_x, or is w for ω."""
    if typed[:1] == "w" and name == f"omega{typed[1:]}":
        return True
    return len(typed) > 1 and typed.replace("_", "").casefold() == name.replace("_", "").casefold()


class LineReading(Struct, frozen=True):
    """What a line says, read in one way; `written` is its echo where that is not just its formula.

    `formula` is that of a formula or the exact number in the unit as typed; of an equation it is the left side, with numbers in SI units.
    `unit` is the unit as typed, `figures` the significant figures of a number, None where it is exact (1/2, √3) or worked out.
    `parts` are the components of a vector; where it was told by size and direction, `polar` holds these two as typed.
    `basis` is the first of the unit vectors by which one is told, "i", "e_x" or "e_1". `direction` is that of a number told in words:
    "down", "clockwise". `cut` says that the line can be read in more ways than were tried. `zeros` are those of the figures that need not
    count, at the end of a whole number.
    """

    kind: str
    written: str = ""
    formula: Formula | None = None
    unit: Unit | None = None
    figures: int | None = None
    parts: tuple[LineReading, ...] = ()
    right: Formula | None = None
    cut: bool = False
    remarks: tuple[Remark, ...] = ()
    polar: tuple[LineReading, ...] = ()
    direction: str = ""
    basis: str = ""
    zeros: int = 0

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

    @classmethod
    def of_length(cls, text: str) -> AnswerError | None:
        """The fault of a line that is too long for anything in it to be looked at; None where it is not."""
        if len(text) <= MAX_LENGTH:
            return None
        return cls(f"the answer is too long: {len(text)} characters, at most {MAX_LENGTH}", MAX_LENGTH, len(text))
