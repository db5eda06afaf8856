"""The analysis of a class: its figures against NumPy and by hand, and that the order of the papers changes nothing."""

from __future__ import annotations

import random
from fractions import Fraction

import numpy
import pytest

from rotsolve.algebra.formula import Symbol
from rotsolve.grading.course.analysis import complete_papers, correlated, group_weights, part_figures
from rotsolve.grading.course.marked import MarkedSheet
from rotsolve.grading.course.questions import SheetTask, Task
from rotsolve.grading.verdict import OPEN_OUTCOMES, RIGHT, JudgedPart, Marked, Verdict

NAMES = ("a", "b", "c", "d")
SHEET = SheetTask("", (Task("", {name: Symbol(name) for name in NAMES}),))


def paper(*marks: int, outcome: str = RIGHT) -> MarkedSheet:
    """A paper with these marks, of four each."""
    parts = tuple(
        JudgedPart(name, "x", Verdict(outcome), Fraction(own), Fraction(4))
        for name, own in zip(NAMES, marks, strict=True)
    )
    return MarkedSheet((Marked("", parts, (), Fraction(sum(marks)), Fraction(16)),))


@pytest.mark.parametrize("size", [2, 3, 10, 37, 100])
def test_against_numpy(size: int) -> None:
    chance = random.Random(size)
    table = numpy.array([[chance.randint(0, 4) for _ in NAMES] for _ in range(size)], dtype=float)
    papers = [paper(*map(int, row)) for row in table]
    for place, one in enumerate(part_figures(papers, SHEET)):
        others = table.sum(axis=1) - table[:, place]
        assert float(one.share) == pytest.approx(table[:, place].mean() / 4)
        if table[:, place].std() and others.std():
            assert one.correlation == pytest.approx(numpy.corrcoef(table[:, place], others)[0, 1])
        else:
            assert one.correlation is None


def test_the_best_less_the_worst_by_hand() -> None:
    """100 papers with totals 1, …, 100: the best 27 are those above 73."""
    papers = [paper(4 * (k > 73), 0, 0, 0) for k in range(100)]
    assert part_figures(papers, SHEET)[0].gap == Fraction(26, 27)
    assert group_weights([Fraction(k) for k in range(100)]) == [Fraction(k >= 73) for k in range(100)]


def test_those_who_share_the_last_places_share_them() -> None:
    """Of 100 papers 20 are above 50 who are level: each of these belongs to the best by 7/50."""
    weights = group_weights([Fraction(2)] * 20 + [Fraction(1)] * 50 + [Fraction(0)] * 30)
    assert weights == [Fraction(1)] * 20 + [Fraction(7, 50)] * 50 + [Fraction(0)] * 30


def test_the_order_of_the_papers_changes_nothing() -> None:
    chance = random.Random(3)
    papers = [paper(*(chance.randint(0, 4) for _ in NAMES)) for _ in range(25)]
    shuffled = chance.sample(papers, len(papers))
    for one, other in zip(part_figures(papers, SHEET), part_figures(shuffled, SHEET), strict=True):
        assert (one.share, one.gap) == (other.share, other.gap)
        assert one.correlation == pytest.approx(other.correlation)


def test_what_tells_strong_from_weak_and_what_does_not() -> None:
    papers = [paper(4 if k > 5 else 0, k % 2 * 4, 4 if k > 5 else 0, 2) for k in range(10)]
    tells, chance, _, same = part_figures(papers, SHEET)
    assert tells.gap == 1 and tells.correlation is not None and tells.correlation > 0.6
    assert chance.correlation is not None and abs(chance.correlation) < 0.2
    assert same.correlation is None and same.gap == 0


@pytest.mark.parametrize("outcome", OPEN_OUTCOMES)
def test_papers_with_marks_still_to_be_given_do_not_count(outcome: str) -> None:
    assert complete_papers([paper(1, 2, 3, 4), paper(0, 0, 0, 0, outcome=outcome)]) == [paper(1, 2, 3, 4)]


def test_nothing_correlates_with_what_is_the_same_for_all() -> None:
    assert correlated([Fraction(1)] * 3, [Fraction(1), Fraction(2), Fraction(3)]) is None
    assert part_figures([], SHEET) == []
