"""Judges: a problem that has been solved, and what judges the answers to each of its variants."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from rotsolve.grading.course.examiner import HIGHEST, Judge, NotMarked
from rotsolve.grading.course.student import Task
from rotsolve.pipeline import solve_problem
from rotsolve.scene.read import read_source

if TYPE_CHECKING:
    from rotsolve.keys.variants import Variant
    from rotsolve.solution import Solution


class Judges:
    """The judge of the scene as it stands, and of each variant by its number."""

    def __init__(self, scene: Path | str, seed: int, count: int | None) -> None:
        self.scene, self.seed, self.count = scene, seed, count
        self.problem = read_source(scene)
        self.solution = solve_problem(self.problem)
        self._variants: Iterator[Variant] | None = None

    @property
    def task(self) -> Task:
        """What is asked, with its letters."""
        answers = self.solution.derivation.answers
        return Task(self.problem.title, {answer.name: answer.symbol for answer in answers})

    def judge(self, number: int) -> Judge:
        """The judge of a variant, 0 for the scene as it stands; the numbers are asked for in rising order."""
        if number == 0:
            return judge_of(self.solution)
        problem = read_source(self.scene, self.settings(number))
        return judge_of(solve_problem(problem))

    def settings(self, number: int) -> Mapping[str, str]:
        """The givens of a variant, which all that come after it need not work out again."""
        if self.problem.vary is None:
            raise NotMarked("the problem has no `vary`, so there are no variants of it")
        if self.count is not None and number > self.count:
            raise NotMarked(f"there are {self.count} variants, so none has the number {number}")
        if self._variants is None:
            from rotsolve.keys.variants import variants

            self._variants = variants(self.problem, self.count or HIGHEST, self.seed)
        for variant in self._variants:
            if variant.number == number:
                return variant.settings
        raise NotMarked(f"there is no variant {number}")


def judge_of(solution: Solution) -> Judge:
    """What marks answers to a solved scene."""
    from rotsolve.grading.marking.judge import Judge

    return Judge(solution)
