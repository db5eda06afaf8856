"""Formula: one held against the closed form that is asked: equal, right with numbers put in, of another sign or dimension."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import DimensionError, describe, dimension_of
from rotsolve.grading.comparing.finding import Finding, found, outcome_of
from rotsolve.grading.comparing.formulas.coefficients import (
    USUAL,
    has_decimal,
    numbers_in,
    numbers_stand,
    put_in,
    rounding,
    with_letters,
)
from rotsolve.grading.comparing.numbers import Typed, number_of
from rotsolve.grading.comparing.scalars import Scalar, lacking_unit, valued
from rotsolve.grading.comparing.signs import right_but_for_sign
from rotsolve.grading.verdict import RIGHT, WRONG
from rotsolve.language import marks

EXACTLY = Fraction(1, 10**15)  # the share within which formulas with numbers put in are equal


def formula_judged(formula: Formula, asked: Scalar, *, measured: bool = False) -> Finding:
    """The finding for a formula; `measured` says that units in it tell what it measures, and that this is what is asked for."""
    if asked.closed is None:
        return worked_out(formula, asked)
    holds = asked.same(formula, asked.closed)
    if holds:
        if asked.marking.form == marks.NUMBER and asked.sought is not None:
            return found(RIGHT, "form", "right, but a number is wanted", flaws=(marks.FORM,))
        return Finding(RIGHT)
    if holds is None:
        return found(outcome_of(None), "equality", "it agrees wherever it was tried, but that is no proof")
    misfit = "" if measured else of_other_dimension(formula, asked)
    partly = partly_numeric(formula, asked, fits=not misfit, measured=measured)
    if partly is not None or misfit:
        return partly or found(WRONG, "dimension", misfit)
    if asked.same(-formula, asked.closed) or partly_numeric(-formula, asked, fits=True) is not None:
        return right_but_for_sign(asked.directed, asked.direction, asked.positive, asked.sign, asked.marking)
    return Finding(WRONG)


def partly_numeric(formula: Formula, asked: Scalar, *, fits: bool, measured: bool = False) -> Finding | None:
    """The finding for a formula that is right with numbers of letters put in, or but for a rounded coefficient; else None.

    One that does not measure what is asked (`fits`) has lost the units of its numbers.
    """
    finding = put_in_for_letters(formula, asked, fits, measured) or put_in_beside(formula, asked)
    return finding if finding is None or fits else lacking_unit(finding, asked.unit, asked)


def put_in_for_letters(formula: Formula, asked: Scalar, fits: bool, measured: bool) -> Finding | None:
    """The finding where the numbers of the letters that a formula lacks make the closed form equal to it."""
    both = None if asked.closed is None else put_in(asked.closed, formula, asked.values, asked.answers)
    if both is None or not (fits or numbers_stand(formula, both.missing, asked.numbers)):
        return None
    if not (measured or formula.symbols() <= asked.values.keys() or numbers_in(formula)):
        return None  # made of other answers alone: no number stands in it
    holds = asked.same(both.typed, both.closed) if both.missing else False
    if holds is None:  # sin 35° and its like, which exact algebra does not know
        holds = asked.close(both.typed, both.closed, EXACTLY)
    if holds:
        return with_numbers(asked, both.missing)
    if has_decimal(formula):
        share = min(Fraction(rounding(formula)), asked.marking.tolerance.share or Fraction(USUAL))
        if asked.close(both.typed, both.closed, share) and is_near(both.typed, asked, share):
            return with_numbers(asked, both.missing, rounded=True)
    return None


def is_near(formula: Formula, asked: Scalar, share: Fraction) -> bool:
    """Whether a formula is within a share of the answer for the scene's own numbers, where it has one for them."""
    number = number_of(formula, asked.values)
    if number is None or asked.sought is None:
        return True
    value = asked.sought.in_unit(asked.sought.si)
    return abs(number.float - value.float) <= share * abs(value.float)


def put_in_beside(formula: Formula, asked: Scalar) -> Finding | None:
    """The finding where a formula is right with letters in place of their numbers."""
    for meant, names in with_letters(formula, asked.numbers):
        if asked.closed is not None and not of_other_dimension(meant, asked) and asked.same(meant, asked.closed):
            return with_numbers(asked, names)
    return None


def with_numbers(asked: Scalar, names: Iterable[str], *, rounded: bool = False) -> Finding:
    """What is said of a right formula in which there are numbers of these letters."""
    listed = [word for name in sorted(names) for word in (", ", Symbol(name))][1:]
    put: tuple[str | Formula, ...] = ("right with the number of ", *listed, " put in") if listed else ("right",)
    said = (*put, ", but a number in it is rounded") if rounded else put
    return found(RIGHT, "numbers", *said, flaws=(marks.FORM,) if asked.marking.form == marks.EXACT else ())


def worked_out(formula: Formula, asked: Scalar) -> Finding:
    """The finding for a formula where there is no closed form: its number is held against the one that is sought."""
    number = number_of(formula, asked.values)
    if asked.sought is None or number is None:
        return found(outcome_of(None), "equality", "there is no closed form to compare it with")
    value = Typed(formula.substitute(asked.values))
    return valued(value, asked.sought.si, "", asked, asked.sought) or Finding(WRONG)


def of_other_dimension(formula: Formula, asked: Scalar) -> str:
    """What is said of a formula that measures something else; '' where it does not, or where that is not known."""
    if not formula.symbols() <= asked.dimensions.keys():
        return ""
    try:
        found_dimension = dimension_of(formula, asked.dimensions)
    except DimensionError as error:
        return f"its parts do not fit together: {error.message}"
    if found_dimension.matches(asked.dimension):
        return ""
    here, wanted = describe(found_dimension, article=True), describe(asked.dimension, article=True)
    return f"it measures {here}, but {wanted} is asked for"
