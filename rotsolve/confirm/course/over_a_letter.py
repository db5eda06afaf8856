"""Over a letter: `largest Q` and `x where Q is largest` in the plane: what Q is over the whole range of the letter, by a scan."""

from __future__ import annotations

from collections.abc import Callable

from rotsolve.algebra.formula import Symbol
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.following import Course
from rotsolve.confirm.course.node import Budget
from rotsolve.confirm.course.samples import Fits
from rotsolve.confirm.course.scans import Scans
from rotsolve.confirm.extremes import (
    end_of_range,
    extreme_over,
    extreme_place,
    letter_of_extreme,
    phrase_of,
    plainly_asked,
)
from rotsolve.language.limited import limited_letters
from rotsolve.language.problem import Find, Given

BUDGET = 30_000  # instants of one body that the scan of one question may cost
Valued = Callable[[Find, Course], float]  # the number of a question in a course


class OverLetter:
    """A quantity over a letter of the scene: at each place all moves anew; there is none where the scene `fits` no such number."""

    def __init__(self, phrase: Find, given: Given, course: Course, valued: Valued, fits: Fits) -> None:
        self.phrase, self.given, self.course, self.valued, self.fits = (
            plainly_asked(phrase),
            given,
            course,
            valued,
            fits,
        )
        self.budget = Budget(BUDGET)

    def at(self, number: float) -> float:
        """The quantity where the letter has a number."""
        numbers = {**self.course.numbers, self.given.name: number}
        if not self.fits(numbers):
            raise NotConfirmed("the scene may have no such number")
        return self.valued(self.phrase, Course(self.course.problem, numbers, self.budget))

    @property
    def reach(self) -> float | None:
        """Up to where from 0 the letter can be."""
        end = end_of_range(self.given.name, self.course.problem)
        return None if end is None else self.course.value(end)

    @property
    def sized(self) -> bool:
        return self.given.name in limited_letters(self.course.problem)

    def most(self, word: str) -> float:
        """The largest or smallest value."""
        begun = self.course.numbers.get(self.given.name, 1.0)
        return extreme_over(self.given, word, begun, self.at, self.reach, sized=self.sized)[1]

    def place(self, word: str, said: float) -> float:
        """Where it is largest or smallest: the place that is said, where nothing is better."""
        return extreme_place(self.given, word, said, self.at, self.reach, sized=self.sized)


def largest_value(find: Find, course: Course, valued: Valued, scans: Scans | None) -> float | None:
    """`largest Q` over the one open letter; None of what is asked over a time, and where no letter is open."""
    phrase = phrase_of(find, course.problem)
    letter = letter_of_extreme(find, course.problem)
    if letter is None:
        return None
    scans = scans or Scans()
    over = OverLetter(phrase, letter, course, valued, scans.fits)
    return scans.once(find, letter, course.numbers, None, lambda: over.most(find.extreme))


def place_of_largest(find: Find, said: float, course: Course, valued: Valued, scans: Scans | None) -> float:
    """`x where Q is largest`: the place that is said, or a better one."""
    condition = find.where
    assert condition is not None and condition.phrase is not None and condition.word is not None
    letter = next(given for given in course.problem.givens if Symbol(given.name) == find.formula)
    scans = scans or Scans()
    over, word = OverLetter(condition.phrase, letter, course, valued, scans.fits), condition.word
    return scans.once(find, letter, course.numbers, said, lambda: over.place(word, said))
