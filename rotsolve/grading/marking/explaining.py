"""Explaining: what a wrong answer may come of: a number rounded before the end, or a mistake with which the scene gives just that answer.

Rounded too early are g = 10 m/s², π = 3.14, or a given to fewer figures.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cached_property, partial
from itertools import islice
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified, rounded, value_of
from rotsolve.algebra.formula import ONE, PI, Constant, Formula, Negative, Number, Sum, Symbol, negate
from rotsolve.algebra.units.quantities import number_in_unit
from rotsolve.algebra.units.unit_table import ONE_UNIT
from rotsolve.core.derivation import Answer, Words
from rotsolve.core.remembered import remembered
from rotsolve.grading.comparing.formulas import numbers_stand, of_other_dimension, put_in
from rotsolve.grading.comparing.numbers import Typed, certified_number, is_near, rounds_to
from rotsolve.grading.comparing.readings import component_readings, components_right
from rotsolve.grading.comparing.scalars import Scalar
from rotsolve.grading.marking.target import SceneLetters, Target, entries_of_answer
from rotsolve.grading.reading.records import LineReading
from rotsolve.grading.verdict import WRONG, Finding, found
from rotsolve.language import marks
from rotsolve.language.problem import Given
from rotsolve.solution import Solution

if TYPE_CHECKING:
    from rotsolve.grading.mistakes.mistake import Mistake
    from rotsolve.grading.mistakes.wrong_answers import WrongAnswers

FEWER = (1, 2, 3)  # figures to which a given may have been rounded
PIS = ("3.14", "22/7", "3.1", "3")
GRAVITIES = ("9.81", "9.8", "10")  # for one another
LARGEST = Fraction(1, 20)  # the share that rounding to two figures may change at most: more is another number
LEAST_ROUNDED = 2  # figures of a number of which it can be told how it came about
EXACTLY = Fraction(1, 10_000)  # the share within which an exact number, 10/3, is that of another g
TWO_FIGURES = Fraction(1, 200)  # the share by which rounding to two figures changes a number of middling size
ALIKE = Fraction(1, 500)  # the share within which a number is that of a mistake
FAR = 0.1  # the share by which no number of two figures is rounded
ROUGHLY = 1e-6  # the share by which numbers of one formula may differ in floats
LEAST_FOR_MISTAKE = 2  # figures of a number that may name a mistake
MOST_TERMS = 12  # of a formula whose signs are turned
ENOUGH = 3  # figures of a number that may be the answer to another question
Wrong = Callable[[], "WrongAnswers"]
Rounded = tuple[Certified, Words]  # the answer with one number rounded, in SI units, and what was rounded in words


def fewer_figures(given: Given) -> Iterator[tuple[Formula, str]]:
    """Other values for a given: to fewer figures in its own unit, and what else is taken for g."""
    unit = given.unit
    number = None if given.value is None else given.value if unit is None else number_in_unit(given.value, unit)
    if not isinstance(number, Number):
        return
    others = [value_of(rounded(number.value, figures), figures) for figures in FEWER]
    if given.name == "g" and Fraction(GRAVITIES[1]) <= number.value <= Fraction(GRAVITIES[0]):
        others += [Fraction(text) for text in GRAVITIES]
    for other in dict.fromkeys(others):
        if other and other != number.value and abs(other - number.value) <= LARGEST * abs(number.value):
            shown = format(float(other), "g")
            yield (Number(other) if unit is None else other * unit.factor), unit.after(shown) if unit else shown


def rounded_early(typed: Typed, factor: Formula, answers: tuple[Rounded, ...]) -> Words | None:
    """What was rounded, where that gives the typed number to its figures; `factor` is that of its unit."""
    half = typed.half_unit
    if typed.figures is not None and (half is None or (typed.sure_figures or 0) < LEAST_ROUNDED):
        return None
    number, margin = Typed(typed.value * factor), None if half is None else half * factor
    near = (words for value, words in answers if is_near(number, value, share=EXACTLY, margin=margin))
    return next(near, None)


# mistakes


def wrong_answers_of(solution: Solution) -> WrongAnswers:
    """The answers of a solved scene with each mistake in it, in the case that is printed first."""
    from rotsolve.grading.mistakes.wrong_answers import WrongAnswers  # a right answer needs none of them

    points = solution.trace.points
    return WrongAnswers.of(solution.problem, points[0] if points else {})


class Explaining:
    """Finds the mistakes behind wrong answers; the scene is solved with each of them once, as far as they are needed."""

    def __init__(self, letters: SceneLetters, wrong: Wrong | None = None) -> None:
        self.letters = letters
        self._wrong = wrong  # where the mistakes of the scene are solved for other numbers already

    @cached_property
    def wrong_answers(self) -> WrongAnswers:
        """The answers of the scene with each mistake in it, the commonest first."""
        return wrong_answers_of(self.letters.solution) if self._wrong is None else self._wrong()

    def number(self, name: str, typed: Typed, asked: Scalar) -> Finding | None:
        """What a wrong number comes of; None where nothing tells. Its unit is the one that is asked for where it has none."""
        unit = typed.unit or asked.unit
        named = rounded_early(typed, unit.factor, self.roundings(asked))
        if named is not None:
            words = ("rounded too early: this is what comes with ", *named)
            return found(WRONG, "rounding", *words, flaws=(marks.ROUNDING,))
        other = self.another(name, typed, asked)
        return other or self.mistake_of_number(name, typed, asked) or self.roughly(typed, asked)

    def another(self, name: str, typed: Typed, asked: Scalar) -> Finding | None:
        """The answer to another question, given for this one."""
        if (typed.sure_figures is not None and typed.sure_figures < ENOUGH) or typed.unit not in (None, asked.unit):
            return None
        for answer in self.letters.solution.derivation.answers:
            alike = answer.name != name and answer.unit == asked.unit and not answer.components
            if alike and answer.value is not None and rounds_to(typed, answer.value):
                return found(WRONG, "mistake", "it is the value of ", Symbol(answer.name))
        return None

    @remembered
    def roundings(self, asked: Scalar) -> tuple[Rounded, ...]:
        """The answers that come of one number rounded too early."""
        closed, values = asked.closed, asked.values
        if closed is None or not closed.symbols() <= values.keys():
            return ()
        givens = {given.name: given for given in self.letters.problem.givens}
        found: list[tuple[Certified | None, Words]] = [
            (certified_number(closed, {**values, name: number}), (Symbol(name), f" = {text}"))
            for name in sorted(closed.symbols())
            for number, text in fewer_figures(givens[name])
        ]
        for text in PIS if closed.holds(Constant) else ():
            other = closed.transform(partial(node_replaced, PI, Number(Fraction(text))))
            found.append((certified_number(other, values), (PI, f" = {text}")))
        return tuple((value, words) for value, words in found if value is not None)

    def mistake_of_number(self, name: str, typed: Typed, asked: Scalar) -> Finding | None:
        """The mistake that gives a number."""
        nothing = typed.rational == 0
        if typed.sure_figures is not None and typed.sure_figures < LEAST_FOR_MISTAKE and not nothing:
            return None
        number = Typed(typed.value * (typed.unit or asked.unit).factor / asked.unit.factor, typed.figures)
        same_unit = typed.unit is None or typed.unit.factor == asked.unit.factor
        rough = certified_number(number.value, {})

        def fits(wrong: Answer) -> bool:
            if wrong.value is None or wrong.unit != asked.unit or rough is None:
                return False
            if abs(wrong.value.float - rough.float) > FAR * abs(rough.float):
                return False  # most are told apart by their size
            rounded_so = same_unit and not nothing and rounds_to(typed, wrong.value)
            return bool(rounded_so or is_near(number, wrong.value, share=ALIKE))

        return self._first_mistake(name, fits)

    def vector(self, target: Target, reading: LineReading) -> Finding | None:
        """The mistake that gives a vector or a matrix: with it every component is right; None where none does."""
        typed = component_readings(reading)

        def fits(wrong: Answer) -> bool:
            parts = entries_of_answer(wrong)
            if not len(parts) == len(typed) == len(target.parts):
                return False
            wanted = [self.in_place_of(own, part) for own, part in zip(target.parts, parts, strict=True)]
            return components_right(typed, wanted)

        return self._first_mistake(target.name, fits)

    def _first_mistake(self, name: str, fits: Callable[[Answer], bool]) -> Finding | None:
        """The commonest mistake with which an answer is such as fits."""
        mistake = self.wrong_answers.first(name, fits)
        return None if mistake is None else mistake_finding(mistake)

    def in_place_of(self, right: Scalar, wrong: Answer) -> Scalar:
        """A component as it is with a mistake."""
        closed, unit = self.letters.written(wrong.closed), wrong.unit or ONE_UNIT
        return replace(right, closed=closed, value=wrong.value, unit=unit)

    def roughly(self, typed: Typed, asked: Scalar) -> Finding | None:
        """Whether rounding to about two figures on the way may give a number."""
        closed = asked.closed
        if closed is None or asked.value is None or not closed.symbols() <= asked.values.keys():
            return None
        value = asked.in_unit(typed.unit or asked.unit)
        if not is_near(typed, value, share=self.spread(asked)):
            return None
        said = "close: as far off as when numbers on the way are rounded to two figures"
        return found(WRONG, "rounding", said, flaws=(marks.ROUNDING,))

    @remembered
    def spread(self, asked: Scalar) -> Fraction:
        """How far the answer may be off, as a share of it, where every number in it is rounded to about two figures: Σ |Δf|/|f|."""
        closed, values = asked.closed, asked.values
        exact = None if closed is None else certified_number(closed, values)
        if closed is None or exact is None or not exact.float:
            return Fraction(0)
        letters = closed.symbols() & values.keys()
        moved = [certified_number(closed, {**values, name: (1 + TWO_FIGURES) * values[name]}) for name in letters]
        return Fraction(sum(abs(other.float / exact.float - 1) for other in moved if other is not None))

    def formula(self, name: str, formula: Formula, asked: Scalar) -> Finding | None:
        """What a wrong formula comes of; None where nothing tells."""
        return self.mistake_of_formula(name, formula, asked) or self.sign(formula, asked)

    def sign(self, formula: Formula, asked: Scalar) -> Finding | None:
        """The term whose sign alone is wrong: a in m (g − a)."""
        sums = [node for node in formula.walk(Sum) if isinstance(node, Sum)]
        places = [(node, place) for node in sums for place in range(len(node.terms))]
        for node, place in islice(places, MOST_TERMS):
            term = node.terms[place]
            other = Sum((*node.terms[:place], negate(term), *node.terms[place + 1 :]))
            turned = formula.transform(partial(node_replaced, node, other))
            if asked.closed is not None and asked.same(turned, asked.closed):
                shown = term.operand if isinstance(term, Negative) else term
                return found(WRONG, "mistake", "it would be right with the other sign of ", shown)
        return None

    def mistake_of_formula(self, name: str, formula: Formula, asked: Scalar) -> Finding | None:
        """The mistake that gives a formula; None where none does."""
        number = certified_number(formula, asked.values)

        def fits(wrong: Answer) -> bool:
            rough = si_value(wrong)
            if number is not None and rough is not None and abs(number.float - rough) > ROUGHLY * abs(rough):
                return False  # most are told apart by their numbers
            both = None if wrong.closed is None else put_in(wrong.closed, formula, asked.values, {})
            if both is None or any(asked.values[letter] == ONE for letter in both.missing):
                return False  # what is 1 can be left out of any formula
            if of_other_dimension(formula, asked) and not numbers_stand(formula, both.missing, asked.numbers):
                return False
            return asked.same(both.typed, both.closed) is True

        return self._first_mistake(name, fits)

    def mistake_in_letters(self, name: str, formula: Formula, asked: Scalar) -> Finding | None:
        """The mistake or the sign with which a formula is the answer whatever numbers its letters have; None where there is none."""

        def fits(wrong: Answer) -> bool:
            closed = wrong.closed
            return closed is not None and closed.symbols() == formula.symbols() and bool(asked.same(formula, closed))

        return self._first_mistake(name, fits) or self.sign(formula, asked)


def node_replaced(old: Formula, new: Formula, node: Formula) -> Formula:
    return new if node == old else node


def si_value(answer: Answer) -> float | None:
    """The value of an answer in SI units, roughly."""
    factor = None if answer.unit is None else certified_number(answer.unit.factor, {})
    return None if answer.value is None or factor is None else answer.value.float * factor.float


def mistake_finding(mistake: Mistake) -> Finding:
    return found(WRONG, "mistake", f"it looks as if {mistake.words}")
