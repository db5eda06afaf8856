"""Marked: the papers of one student to a sheet, as they are marked, with the right answers as pages show them. Records only."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from msgspec import Struct

from rotsolve.grading.verdict import BY_HAND, RIGHT, WRONG, JudgedPart, Marked
from rotsolve.page.blocks import AnswerRow

UNMARKED = "unmarked"  # the kind of the remark why a paper has no marks


class RightAnswer(Struct, frozen=True):
    """A right answer as pages show it, a row for each of its cases, and for programs."""

    name: str
    rows: tuple[AnswerRow, ...]
    data: dict[str, Any]


Right = Mapping[int, tuple[RightAnswer, ...]]  # the right answers of a problem, by the number of the variant


class MarkedSheet(Struct, frozen=True):
    """All papers of one student, marked, in the order of the problems; the right answers of each where they are to be shown."""

    problems: tuple[Marked, ...]
    right: tuple[tuple[RightAnswer, ...], ...] = ()

    @property
    def parts(self) -> tuple[JudgedPart, ...]:
        """All answers, in the order of the problems."""
        return tuple(part for one in self.problems for part in one.parts)

    @property
    def marks(self) -> Fraction:
        return sum((one.marks for one in self.problems), Fraction(0))

    @property
    def of(self) -> Fraction:
        return sum((one.of for one in self.problems), Fraction(0))

    @property
    def all_right(self) -> bool:
        """Whether every answer is right, or has all marks by hand, and no line of working is wrong."""
        answers = all(
            part.verdict.outcome == RIGHT or (part.verdict.outcome == BY_HAND and part.marks == part.of)
            for part in self.parts
        )
        return answers and not any(line.verdict.outcome == WRONG for one in self.problems for line in one.lines)

    def outcomes(self) -> frozenset[str]:
        """The states that its answers are in."""
        return frozenset(part.verdict.outcome for part in self.parts)
