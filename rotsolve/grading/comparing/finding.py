"""Finding: what a comparison found: the outcome, what is to be said, and the flaws that cost marks."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct

from rotsolve.algebra.formula import Formula
from rotsolve.grading.verdict import RIGHT, UNDECIDED, WRONG, Remark


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


def outcome_of(holds: bool | None) -> str:
    """The outcome for what is proved, disproved or neither."""
    return UNDECIDED if holds is None else RIGHT if holds else WRONG


def together(findings: Iterable[Finding]) -> Finding:
    """The finding for several parts: right where all are, wrong where one is; every remark and flaw once."""
    parts = list(findings)
    outcomes = {part.outcome for part in parts}
    outcome = next((one for one in (WRONG, UNDECIDED) if one in outcomes), RIGHT)
    remarks = dict.fromkeys(remark for part in parts for remark in part.remarks)
    flawed = outcome != WRONG or all(part.flaws for part in parts if part.outcome == WRONG)
    flaws = dict.fromkeys(flaw for part in parts for flaw in part.flaws) if flawed else {}
    return Finding(outcome, tuple(remarks), tuple(flaws))
