"""Verdict: what is said about one answer, and the papers, parts and lines that are judged. Records only."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from msgspec import Struct

from rotsolve.core.derivation import Words

RIGHT, WRONG, UNDECIDED = "right", "wrong", "can't decide"


class Remark(Struct, frozen=True):
    """One sentence for the student: its kind, words with formulas in them, and the columns of the answer that it speaks of.

    Kinds: "reading", "comma", "form", "unit", "dimension", "figures", "rounding", "sign", "direction", "mistake", "followed", ….
    """

    kind: str
    words: Words
    start: int | None = None
    end: int | None = None


class Verdict(Struct, frozen=True):
    """Right, wrong or undecided, never one for another; how the answer was read ('' where that is plain); and what is to be said."""

    outcome: str
    read_as: str = ""
    remarks: tuple[Remark, ...] = ()


class Paper(Struct, frozen=True):
    """What one student handed in: answers by the names under `find`, and lines of working."""

    student: str
    answers: Mapping[str, str]
    working: tuple[str, ...] = ()
    variant: str = ""


class Part(Struct, frozen=True):
    """One answer, judged: its marks of how many, and whether it is right only by the student's own earlier answers."""

    name: str
    text: str
    verdict: Verdict
    marks: Fraction
    of: Fraction
    followed: bool = False


class Line(Struct, frozen=True):
    """One line of working, judged; `first_wrong` marks where the working leaves the right way."""

    text: str
    verdict: Verdict
    first_wrong: bool = False


class Marked(Struct, frozen=True):
    """A paper, marked: its parts in the order of `find`, its lines of working, and the sum of the marks."""

    student: str
    parts: tuple[Part, ...]
    lines: tuple[Line, ...]
    marks: Fraction
    of: Fraction
