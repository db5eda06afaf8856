"""Analysis: how hard the answers of a sheet were for a class, and how well each tells strong papers from weak ones.

Only papers count in which every answer has its marks. Nothing here depends on the order of the papers.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from statistics import StatisticsError, correlation, mean

from msgspec import Struct

from rotsolve.grading.course.marked import MarkedSheet
from rotsolve.grading.course.questions import Asked, SheetTask
from rotsolve.grading.verdict import OPEN_OUTCOMES

FEW = 30  # papers; with fewer, chance decides more than the answer
GROUP = Fraction(27, 100)  # of the papers, the best and the worst: T. L. Kelley, J. Educ. Psychol. 30 (1939) 17


class PartFigures(Struct, frozen=True):
    """One answer: the mean share of its marks; its correlation with the marks of all others, None where one of both is the same for all;
    and by how much the mean share of the best papers is above that of the worst."""

    asked: Asked
    share: Fraction
    correlation: float | None
    gap: Fraction


def complete_papers(papers: Sequence[MarkedSheet]) -> list[MarkedSheet]:
    """The papers of which every answer has its marks."""
    return [paper for paper in papers if not paper.outcomes() & {*OPEN_OUTCOMES}]


def part_figures(papers: Sequence[MarkedSheet], sheet: SheetTask) -> list[PartFigures]:
    """The figures of every answer that has marks, by papers that are complete."""
    if not papers:
        return []
    totals = [paper.marks for paper in papers]
    best, worst = group_weights(totals), group_weights([-total for total in totals])
    found = []
    for place, asked in enumerate(sheet.asked()):
        marks, most = [paper.parts[place].marks for paper in papers], papers[0].parts[place].of
        if not most:
            continue
        others = [total - own for total, own in zip(totals, marks, strict=True)]
        gap = weighted_mean(marks, best) - weighted_mean(marks, worst)
        found.append(PartFigures(asked, mean(marks) / most, correlated(marks, others), gap / most))
    return found


def correlated(one: Sequence[Fraction], other: Sequence[Fraction]) -> float | None:
    """Pearson's coefficient of two rows of marks, None where one of them does not change."""
    try:
        return correlation([float(value) for value in one], [float(value) for value in other])
    except StatisticsError:
        return None


def group_weights(totals: Sequence[Fraction]) -> list[Fraction]:
    """How far each paper belongs to the best 27 %: those that share the last places are all in it, each by an equal part."""
    size = GROUP * len(totals)
    limit = sorted(totals, reverse=True)[max(0, -(-size // 1) - 1)]
    above, level = sum(total > limit for total in totals), sum(total == limit for total in totals)
    part = (size - above) / level
    return [Fraction(1) if total > limit else part if total == limit else Fraction(0) for total in totals]


def weighted_mean(values: Sequence[Fraction], weights: Sequence[Fraction]) -> Fraction:
    """The mean of values that count so much each."""
    return sum((value * weight for value, weight in zip(values, weights, strict=True)), Fraction(0)) / sum(weights)
