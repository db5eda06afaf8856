"""Rounding: what the answer becomes where a number is rounded before the end: g = 10 m/s², π = 3.14, a given to fewer figures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from msgspec import Struct

from rotsolve.algebra.certified.ball import Certified, rounded, value_of
from rotsolve.algebra.formula import PI, Constant, Formula, Number, Symbol
from rotsolve.algebra.units.quantities import in_unit
from rotsolve.core.derivation import Words
from rotsolve.grading.comparing.numbers import Typed, near, number_of
from rotsolve.language.problem import Given

FEWER = (1, 2, 3)  # figures to which a given may have been rounded
PIS = ("3.14", "22/7", "3.1", "3")
GRAVITIES = ("9.81", "9.8", "10")  # for one another
LARGEST = Fraction(1, 20)  # the share that rounding to two figures may change at most: more is another number
LEAST = 2  # figures of a number of which it can be told how it came about
EXACTLY = Fraction(1, 10_000)  # the share within which an exact number, 10/3, is that of another g
TWO_FIGURES = Fraction(1, 200)  # the share by which rounding to two figures changes a number of middling size


class Rounded(Struct, frozen=True):
    """The answer with one number rounded, in SI units, and what was rounded in words."""

    value: Certified
    words: Words


def rounded_answers(closed: Formula, values: Mapping[str, Formula], givens: Mapping[str, Given]) -> tuple[Rounded, ...]:
    """The answers that come of one number rounded too early."""
    found = []
    for name in sorted(closed.symbols() & values.keys()):
        for number, text in fewer_figures(givens[name]):
            value = number_of(closed, {**values, name: number})
            if value is not None:
                found.append(Rounded(value, (Symbol(name), f" = {text}")))
    if closed.holds(Constant):
        for text in PIS:
            value = number_of(with_pi(closed, Number(Fraction(text))), values)
            if value is not None:
                found.append(Rounded(value, (PI, f" = {text}")))
    return tuple(found)


def with_pi(closed: Formula, pi: Formula) -> Formula:
    """The formula with another number for π."""
    return closed.transform(lambda node: pi if node == PI else node)


def fewer_figures(given: Given) -> Iterator[tuple[Formula, str]]:
    """Other values for a given: to fewer figures in its own unit, and what else is taken for g."""
    unit = given.unit
    number = None if given.value is None else given.value if unit is None else in_unit(given.value, unit)
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
    if typed.figures is not None and (half is None or typed.figures < LEAST):
        return None
    number = Typed(typed.value * factor)
    for answer in answers:
        if (
            near(number, answer.value, share=EXACTLY)
            if half is None
            else near(number, answer.value, margin=half * factor)
        ):
            return answer.words
    return None


def spread(closed: Formula, values: Mapping[str, Formula]) -> float:
    """How far the answer may be off, as a share of it, where every number in it is rounded to about two figures: Σ |Δf|/|f|."""
    exact = number_of(closed, values)
    if exact is None or not exact.float:
        return 0.0
    moved = [
        number_of(closed, {**values, name: (1 + TWO_FIGURES) * values[name]})
        for name in closed.symbols() & values.keys()
    ]
    return sum(abs(other.float / exact.float - 1) for other in moved if other is not None)
