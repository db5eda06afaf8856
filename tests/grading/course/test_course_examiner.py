"""The examiner: papers go to the judges of their variants, and what fails takes no other with it."""

from __future__ import annotations

from fractions import Fraction

import pytest

from rotsolve.grading.course.examiner import HIGHEST, NotMarked, mark_papers, variant_of
from rotsolve.grading.verdict import Marked, Paper


class Judge:
    """Gives as many marks as the number of its variant."""

    def __init__(self, number: int) -> None:
        self.number = number

    def mark(self, paper: Paper) -> Marked:
        if paper.student == "Mallory":
            raise ZeroDivisionError("nobody's fault")
        return Marked(paper.student, (), (), Fraction(self.number), Fraction(10))


def paper(student: str, variant: str) -> Paper:
    return Paper(student, {}, (), variant)


def test_papers_are_marked_variant_by_variant(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each judge is made once, in rising order, and only while its papers are marked; every place comes once."""
    monkeypatch.delenv("ROTSOLVE_DEBUG", raising=False)
    made: list[int] = []

    def judge(number: int) -> Judge:
        made.append(number)
        if number == 7:
            raise NotMarked("there are 6 variants")
        if number == 5:
            raise KeyError("lost")
        return Judge(number)

    said = ["3", "", "Variant 2", "#3", "7", "x", "0", "5", "2.0", "3", "999999"]
    papers = [paper("Mallory" if number == 9 else f"Student {number}", text) for number, text in enumerate(said)]
    found = dict(mark_papers([*papers, None], judge))
    assert made == [0, 2, 3, 5, 7]
    assert sorted(found) == list(range(len(said)))
    marks = {place: int(one.marks) for place, one in found.items() if isinstance(one, Marked)}
    assert marks == {0: 3, 1: 0, 2: 2, 3: 3, 8: 2}
    assert {place: found[place] for place in (4, 5, 6, 10)} == {
        4: "there are 6 variants",
        5: "`x` is no number of a variant",
        6: "`0` is no number of a variant",
        10: "`999999` is no number of a variant",
    }
    assert "KeyError" in str(found[7]) and "ZeroDivisionError" in str(found[9])


@pytest.mark.parametrize("text", [f"{HIGHEST + 1}", "1.5", "-3", "two", "3 and 4", "³", "٣x"])
def test_what_is_no_number_of_a_variant(text: str) -> None:
    with pytest.raises(NotMarked, match="is no number of a variant"):
        variant_of(paper("Ada", text))
