"""Verdict: what a comparison finds, what is said about one answer, and the papers, parts and lines that are judged. Records only."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.derivation import Words

RIGHT, PARTLY, WRONG, UNDECIDED = "right", "partly right", "wrong", "can't decide"
NO_ANSWER, NOT_MARKED, BY_HAND = "no answer", "not marked", "marked by hand"
OUTCOMES = (
    RIGHT,
    PARTLY,
    WRONG,
    UNDECIDED,
    NO_ANSWER,
    NOT_MARKED,
    BY_HAND,
)  # the one word for each state of the marks of an answer
OPEN_OUTCOMES = (UNDECIDED, NOT_MARKED)  # those whose marks a teacher still has to give
VALUELESS = "value"  # the kind of the remark about what has no value for the numbers of the scene


class Remark(Struct, frozen=True):
    """One sentence for the student: its kind, words with formulas in them, and the columns of the answer that it speaks of.

    Kinds: "reading", "value", "comma", "form", "unit", "dimension", "figures", "rounding", "sign", "direction", "mistake", "followed", ….
    """

    kind: str
    words: Words
    start: int | None = None
    end: int | None = None


class Verdict(Struct, frozen=True):
    """One of the outcomes, never one for another; how the answer was read ('' where that is plain); and what is to be said."""

    outcome: str
    read_as: str = ""
    remarks: tuple[Remark, ...] = ()


class Paper(Struct, frozen=True):
    """What one student handed in: answers by the names under `find`, and lines of working."""

    student: str
    answers: Mapping[str, str]
    working: tuple[str, ...] = ()
    variant: str = ""


class JudgedPart(Struct, frozen=True):
    """One answer, judged: its marks of how many, and whether it is right only by the student's own earlier answers."""

    name: str
    text: str
    verdict: Verdict
    marks: Fraction
    of: Fraction
    followed: bool = False


class JudgedLine(Struct, frozen=True):
    """One line of working, judged; `first_wrong` marks where the working leaves the right way."""

    text: str
    verdict: Verdict
    first_wrong: bool = False


class Marked(Struct, frozen=True):
    """A paper, marked: its parts in the order of `find`, its lines of working, and the sum of the marks."""

    student: str
    parts: tuple[JudgedPart, ...]
    lines: tuple[JudgedLine, ...]
    marks: Fraction
    of: Fraction


class Finding(Struct, frozen=True):
    """The outcome for one reading. A wrong one with flaws is right but for them, and keeps the marks that they leave."""

    outcome: str
    remarks: tuple[Remark, ...] = ()
    flaws: tuple[str, ...] = ()

    @property
    def right(self) -> bool:
        return self.outcome == RIGHT


def found(outcome: str, kind: str, *words: str | Formula, flaws: tuple[str, ...] = ()) -> Finding:
    """A finding with one remark."""
    return Finding(outcome, (Remark(kind, tuple(words)),), flaws)


def listed_letters(names: Iterable[str]) -> Words:
    """T, a: letters with commas between them."""
    return tuple(word for name in names for word in (", ", Symbol(name)))[1:]


def all_findings(findings: Iterable[Finding]) -> Finding:
    """The finding for several parts: right where all are, wrong where one is; every remark and flaw once."""
    parts = list(findings)
    outcomes = {part.outcome for part in parts}
    outcome = next((one for one in (WRONG, UNDECIDED) if one in outcomes), RIGHT)
    remarks = dict.fromkeys(remark for part in parts for remark in part.remarks)
    flawed = outcome != WRONG or all(part.flaws for part in parts if part.outcome == WRONG)
    flaws = dict.fromkeys(flaw for part in parts for flaw in part.flaws) if flawed else {}
    return Finding(outcome, tuple(remarks), tuple(flaws))
