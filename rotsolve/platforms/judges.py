"""Judges: the judge of each problem of a sheet, by whom its papers are marked, for each variant."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rotsolve.grading.course.examiner import Judges

if TYPE_CHECKING:
    from rotsolve.grading.marking.judge import Judge
    from rotsolve.keys.sheets import SheetProblem


class ProblemJudges:
    """Finds judges; each problem is solved with its mistakes once for all variants."""

    def __init__(self) -> None:
        self._known: dict[int, Judges] = {}

    def judge(self, one: SheetProblem) -> Judge:
        """The judge of a problem with the numbers of its variant, in the points of its sheet."""
        number = one.listed.number
        if number not in self._known:
            self._known[number] = Judges(one.marked, 0, None)
        return self._known[number].judge_worked(one.worked)
