"""Examiner: marks papers, each by the judge of the scene with the numbers of its variant."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property, lru_cache
from itertools import islice
from typing import TYPE_CHECKING, TypeVar

from msgspec.structs import replace

from rotsolve.core.faults import RotsolveError, Unsolvable
from rotsolve.derivation.requirements import ROOT, SLIPS
from rotsolve.grading.course.questions import Task
from rotsolve.grading.verdict import Marked, Paper
from rotsolve.pipeline import solve_problem
from rotsolve.run.attempt import internal_error
from rotsolve.scene.read import Source, read_source

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.core.derivation import Answer
    from rotsolve.grading.marking.explaining import Wrong
    from rotsolve.grading.marking.judge import Judge
    from rotsolve.grading.mistakes.wrong_answers import WrongAnswers
    from rotsolve.keys.variants import Variant
    from rotsolve.keys.working import Worked
    from rotsolve.solution import Solution

HIGHEST = 10_000  # number of a variant
NUMBER = re.compile(r"(?:variant|version|no\.?|#)?\s*(\d{1,5})(?:[.,]0+)?", re.IGNORECASE)
Forms = tuple["Formula | None", ...]
Given = TypeVar("Given")
Done = TypeVar("Done")


class NotMarked(RotsolveError, ValueError):
    """Why a paper can't be marked."""


def mark_papers(papers: Sequence[Paper | None], judge: Callable[[int], Judge]) -> Iterator[tuple[int, Marked | str]]:
    """The place of each paper with its marks, or why it has none; variant by variant, so that one judge is held at a time.

    `judge` is asked for the numbers of the variants in rising order, 0 for the scene as it stands.
    """
    groups: dict[int, list[tuple[int, Paper]]] = {}
    for place, paper in enumerate(papers):
        if paper is not None:
            number = attempted(variant_of, paper)
            if isinstance(number, str):
                yield place, number
            else:
                groups.setdefault(number, []).append((place, paper))
    for variant in sorted(groups):
        chosen = attempted(judge, variant)
        for place, paper in groups[variant]:
            yield place, chosen if isinstance(chosen, str) else attempted(chosen.mark, paper)


def attempted(work: Callable[[Given], Done], given: Given) -> Done | str:
    """What comes of a work, or why nothing does: a failure of ours is that of one paper, or one variant, alone."""
    try:
        return work(given)
    except NotMarked as reason:
        return str(reason)
    except Exception as error:
        return internal_error("marking", error)


def variant_of(paper: Paper) -> int:
    """The number of the variant, 0 where the paper says none."""
    text = paper.variant.strip()
    if not text:
        return 0
    found = NUMBER.fullmatch(text)
    if found is None or not 1 <= int(found[1]) <= HIGHEST:
        raise NotMarked(f"`{text[:40]}` is no number of a variant")
    return int(found[1])


# judges


class Judges:
    """The judge of the scene as it stands, and of each variant by its number."""

    def __init__(self, scene: Source, seed: int, count: int | None) -> None:
        self.seed, self.count = seed, count
        self.problem = read_source(scene)
        self.solution = solve_problem(self.problem).complete()
        self._wrong: dict[Forms, WrongAnswers] = {}
        self._worked: Iterator[tuple[Variant, Worked]] | None = None
        self._found: list[Worked] = []  # the variants up to the highest that was asked for
        self._unusable = "there are no variants that can be used"
        # the answers to the variants that were asked for, 0 for the scene as it stands
        self.right: dict[int, tuple[Answer, ...]] = {}
        self.judge: Callable[[int], Judge] = self.new_judge

    def keep(self, judges: int) -> None:
        """From now on keep so many judges, those asked for last, from one question to the next; those that were kept are forgotten."""
        self.judge = lru_cache(judges)(self.new_judge)

    @property
    def task(self) -> Task:
        """What is asked, with its letters."""
        from rotsolve.grading.marking.target import labels_of

        answers = self.solution.derivation.answers
        letters = {answer.name: answer.symbol for answer in answers}
        parts = {
            f"{answer.name}_{label}": answer.name for answer in answers if answer.rows for label in labels_of(answer)
        }
        own = {name: whole for name, whole in parts.items() if name not in letters}
        known = {answer.name: answer.dimension for answer in answers if answer.dimension is not None}
        dimensions = known | {name: known[whole] for name, whole in own.items() if whole in known}
        return Task(self.problem.title, letters, own, dimensions=dimensions)

    def new_judge(self, number: int) -> Judge:
        """The judge of a variant, 0 for the scene as it stands; in any order."""
        if number == 0:
            self.right[0] = self.solution.derivation.answers
            return marker_of(self.solution, self.wrong_for(self.solution))
        if self.problem.vary is None:
            raise NotMarked("the problem has no `vary`, so there are no variants of it")
        if self.count is not None and number > self.count:
            raise NotMarked(f"there are {self.count} variants, so none has the number {number}")
        if self._worked is None:
            from rotsolve.keys.variants import worked_variants

            self._worked = worked_variants(self.problem, self.count or HIGHEST, self.seed)
        try:
            self._found += (worked for _, worked in islice(self._worked, max(0, number - len(self._found))))
        except Unsolvable as error:
            self._unusable = error.fault.message
        if number > len(self._found):
            raise NotMarked(self._unusable)
        solution = self.varied(self._found[number - 1])
        self.right[number] = solution.derivation.answers
        return self.judge_of(solution)

    def judge_worked(self, worked: Worked) -> Judge:
        """The judge of a variant that is worked out already."""
        return self.judge_of(self.varied(worked))

    def judge_of(self, solution: Solution) -> Judge:
        return marker_of(solution, self.wrong_for(solution))

    @cached_property
    def by_signs(self) -> bool:
        """Whether numbers decide by their signs alone what slips or holds, so that those of variants can be told to decide alike."""
        validity = self.solution.trace.validity
        return validity is not None and set(validity().decided) <= {SLIPS, ROOT}

    def forms(self, solution: Solution) -> Forms | None:
        """The formulas that a variant shares with others; None where it is by itself."""
        from rotsolve.grading.marking.target import entries_of_answer

        answers = solution.derivation.answers
        own = tuple(part.closed for answer in answers for part in entries_of_answer(answer) or (answer,))
        return own if self.by_signs and None not in own else None

    def wrong_for(self, solution: Solution) -> Wrong:
        """The answers to a variant with a mistake; the scene is solved with each mistake once for all variants of the same formulas."""

        def wrong() -> WrongAnswers:
            from rotsolve.grading.marking.explaining import wrong_answers_of

            forms = self.forms(solution)
            if forms is None:
                return wrong_answers_of(solution)
            if forms not in self._wrong:
                self._wrong[forms] = wrong_answers_of(solution)
            return self._wrong[forms].with_values(solution.problem)

        return wrong

    def varied(self, worked: Worked) -> Solution:
        """The solution with the numbers of a variant; it is marked as the scene says, which the variant's own text leaves out."""
        problem = replace(worked.problem, marking=self.problem.marking, answers=self.problem.answers)
        derivation = replace(worked.like.derivation, givens=worked.shown(), answers=worked.answers)
        return replace(worked.like, problem=problem, derivation=derivation)


def marker_of(solution: Solution, wrong: Wrong | None = None) -> Judge:
    """What marks answers to a solved scene."""
    from rotsolve.grading.marking.judge import Judge

    return Judge(solution, wrong)
