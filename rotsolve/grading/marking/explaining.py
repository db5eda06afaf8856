"""Explaining: what a wrong answer may come of: a number rounded too early, or a mistake with which the scene gives just that answer."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.formula import ONE, Formula, Negative, Sum, Symbol, negate
from rotsolve.core.derivation import Answer
from rotsolve.grading.comparing.finding import Finding, found
from rotsolve.grading.comparing.formulas.coefficients import numbers_stand, put_in
from rotsolve.grading.comparing.formulas.formula import of_other_dimension
from rotsolve.grading.comparing.numbers import Typed, near, number_of, rounds_to
from rotsolve.grading.comparing.rounding import Rounded, rounded_answers, rounded_early, spread
from rotsolve.grading.comparing.scalars import Scalar
from rotsolve.grading.marking.target import Letters
from rotsolve.grading.verdict import WRONG
from rotsolve.language import marks

if TYPE_CHECKING:
    from rotsolve.grading.mistakes.mistake import Mistake

ALIKE = Fraction(1, 500)  # the share within which a number is that of a mistake
FAR = 0.1  # the share by which no number of two figures is rounded
ROUGHLY = 1e-6  # the share by which numbers of one formula may differ in floats
LEAST = 2  # figures of a number that may name a mistake
MOST_TERMS = 12  # of a formula whose signs are turned
ENOUGH = 3  # figures of a number that may be the answer to another question


Wrong = Callable[[], "Iterator[tuple[Mistake, Mapping[str, Answer]]]"]


class Mistaken(Struct, frozen=True):
    """The answers of the scene with one mistake in it."""

    mistake: Mistake
    answers: Mapping[str, Answer]


class Explaining:
    """Finds the mistakes behind wrong answers; the scene is solved with each of them once, as far as they are needed."""

    def __init__(self, letters: Letters, wrong: Wrong | None = None) -> None:
        self.letters = letters
        self._wrong = wrong  # where the mistakes of the scene are solved for other numbers already
        self._rest: Iterator[tuple[Mistake, Mapping[str, Answer]]] | None = None
        self._solved: list[Mistaken] = []
        self._roundings: dict[Formula, tuple[Rounded, ...]] = {}
        self._spreads: dict[Formula, float] = {}

    def mistaken(self) -> Iterator[Mistaken]:
        """The scene with each mistake in it, the commonest first."""
        yield from self._solved
        if self._rest is None:
            from rotsolve.grading.mistakes import wrong_answers  # a right answer needs none of them

            self._rest = iter(wrong_answers(self.letters.problem) if self._wrong is None else self._wrong())
        for mistake, answers in self._rest:
            self._solved.append(Mistaken(mistake, answers))
            yield self._solved[-1]

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
        if typed.figures is not None and typed.figures < ENOUGH:
            return None
        for answer in self.letters.solution.derivation.answers:
            alike = answer.name != name and answer.unit == asked.unit and not answer.components
            if (
                alike
                and answer.value is not None
                and typed.unit in (None, asked.unit)
                and rounds_to(typed, answer.value)
            ):
                return found(WRONG, "mistake", "it is the value of ", Symbol(answer.name))
        return None

    def roundings(self, asked: Scalar) -> tuple[Rounded, ...]:
        """The answer with one number rounded too early."""
        closed = asked.closed
        if closed is None or not closed.symbols() <= asked.values.keys():
            return ()
        if closed not in self._roundings:
            givens = {given.name: given for given in self.letters.problem.givens}
            self._roundings[closed] = rounded_answers(closed, asked.values, givens)
        return self._roundings[closed]

    def mistake_of_number(self, name: str, typed: Typed, asked: Scalar) -> Finding | None:
        """The mistake that gives a number."""
        if typed.figures is not None and typed.figures < LEAST:
            return None
        number = Typed(typed.value * (typed.unit or asked.unit).factor / asked.unit.factor, typed.figures)
        same_unit = typed.unit is None or typed.unit.factor == asked.unit.factor
        rough = number_of(number.value, {})
        for one in self.mistaken():
            answer = one.answers.get(name)
            if answer is None or answer.value is None or answer.unit != asked.unit or rough is None:
                continue
            if abs(answer.value.float - rough.float) > FAR * abs(rough.float):
                continue  # most are told apart by their size
            if (same_unit and rounds_to(typed, answer.value)) or near(number, answer.value, share=ALIKE):
                return told(one.mistake)
        return None

    def roughly(self, typed: Typed, asked: Scalar) -> Finding | None:
        """Whether rounding to about two figures on the way may give a number."""
        closed, sought = asked.closed, asked.sought
        if closed is None or sought is None or not closed.symbols() <= asked.values.keys():
            return None
        if closed not in self._spreads:
            self._spreads[closed] = spread(closed, asked.values)
        value = sought.in_unit(typed.unit or asked.unit)
        if not near(typed, value, share=Fraction(self._spreads[closed])):
            return None
        said = "close: as far off as when numbers on the way are rounded to two figures"
        return found(WRONG, "rounding", said, flaws=(marks.ROUNDING,))

    def formula(self, name: str, formula: Formula, asked: Scalar) -> Finding | None:
        """What a wrong formula comes of; None where nothing tells."""
        return self.mistake_of_formula(name, formula, asked) or self.sign(formula, asked)

    def sign(self, formula: Formula, asked: Scalar) -> Finding | None:
        """The term whose sign alone is wrong: a in m (g − a)."""
        sums = [node for node in formula.walk(Sum) if isinstance(node, Sum)]
        places = [(node, place) for node in sums for place in range(len(node.terms))]
        for node, place in islice(places, MOST_TERMS):
            terms = [negate(term) if index == place else term for index, term in enumerate(node.terms)]
            other = Sum(tuple(terms))
            if asked.closed is not None and asked.same(
                formula.transform(partial(exchanged, node, other)), asked.closed
            ):
                term = node.terms[place]
                shown = term.operand if isinstance(term, Negative) else term
                return found(WRONG, "mistake", "it would be right with the other sign of ", shown)
        return None

    def mistake_of_formula(self, name: str, formula: Formula, asked: Scalar) -> Finding | None:
        """The mistake that gives a formula; None where none does."""
        number = number_of(formula, asked.values)
        for one in self.mistaken():
            answer = one.answers.get(name)
            if answer is None or answer.closed is None:
                continue
            rough = in_si(answer)
            if number is not None and rough is not None and abs(number.float - rough) > ROUGHLY * abs(rough):
                continue  # most are told apart by their numbers
            both = put_in(answer.closed, formula, asked.values, {})
            if both is None or any(asked.values[name] == ONE for name in both.missing):
                continue  # what is 1 can be left out of any formula
            fits = not of_other_dimension(formula, asked) or numbers_stand(formula, both.missing, asked.numbers)
            if fits and asked.same(both.typed, both.closed):
                return told(one.mistake)
        return None


def exchanged(old: Formula, new: Formula, node: Formula) -> Formula:
    return new if node == old else node


def in_si(answer: Answer) -> float | None:
    """The value of an answer in SI units, roughly."""
    factor = None if answer.unit is None else number_of(answer.unit.factor, {})
    return None if answer.value is None or factor is None else answer.value.float * factor.float


def told(mistake: Mistake) -> Finding:
    return found(WRONG, "mistake", f"it looks as if {mistake.words}")
