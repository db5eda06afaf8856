"""Scalars: one number or formula held against the one that is asked: value, unit, figures, direction, form."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cached_property
from math import floor, log10

from msgspec import Struct

from rotsolve.algebra.certified.ball import Certified, rounded
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import Dimension, DimensionError, describe, dimension_of
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.grading.comparing.coefficients import (
    USUAL,
    has_decimal,
    numbers_in,
    put_in,
    put_in_both,
    rounding,
    with_letters,
)
from rotsolve.grading.comparing.finding import Finding, found, outcome_of
from rotsolve.grading.comparing.numbers import Sought, Typed, number_of, rounds_to, within
from rotsolve.grading.comparing.signs import right_but_for_sign, turned_round
from rotsolve.grading.comparing.units import likely_meant, may_lack, measured, without_unit
from rotsolve.grading.reading.records import FORMULA, NUMBER, Reading
from rotsolve.grading.verdict import RIGHT, UNDECIDED, WRONG, Remark
from rotsolve.scene import marks
from rotsolve.scene.marks import Marking

POWERS = 9  # of ten: a factor that a prefix or a slip of the decimal point makes
EXACTLY = Fraction(1, 10**15)  # the share within which formulas with numbers put in are equal
LEAST_FIGURES = 2  # a number with fewer says too little to be right as far as it goes

Same = Callable[[Formula, Formula], "bool | None"]
Close = Callable[[Formula, Formula, Fraction], bool]


class Scalar(Struct, frozen=True, dict=True):
    """What is asked for: its closed form and its number, which of them there are, and how it is marked.

    `direction` is that of its value in words, `positive` that of a positive value where a negative one
    has another; a `directed` one has a sign by convention. `turns` says that it counts turns.
    `dimensions` are those of the letters that an answer may hold, `numbers` theirs in SI units; `answers` are the closed
    forms of all answers.
    """

    closed: Formula | None
    value: Certified | None
    unit: Unit
    dimension: Dimension
    marking: Marking
    same: Same
    close: Close
    values: dict[str, Formula]
    dimensions: dict[str, Dimension]
    numbers: Mapping[str, float]
    answers: Mapping[str, Formula]
    direction: str = ""
    positive: str = ""
    directed: bool = False
    turns: bool = False

    @property
    def sign(self) -> int | None:
        """The sign of its value."""
        return None if self.value is None else self.value.sign

    @cached_property
    def sought(self) -> Sought | None:
        """The number in every unit, where there is one."""
        if self.value is None:
            return None
        known = self.closed if self.closed is not None and self.closed.symbols() <= self.values.keys() else None
        return Sought(known, self.values, self.value, self.unit, self.dimension)


def judged(reading: Reading, asked: Scalar) -> Finding:
    """The finding for one reading."""
    if reading.kind == NUMBER and reading.formula is not None:
        return number_judged(Typed(reading.formula, reading.figures, reading.unit), reading.direction, asked)
    if reading.kind == FORMULA and reading.formula is not None:
        meant = None if reading.unit is None else measured(reading.unit, asked.unit, asked.dimension, asked.turns)
        if meant is not None and meant.fault is not None:
            return Finding(WRONG, (meant.fault,))
        return formula_judged(reading.formula, asked, measured=meant is not None)
    return found(WRONG, "form", f"{'a formula' if asked.sought is None else 'a number or a formula'} is asked for")


# numbers


def number_judged(typed: Typed, direction: str, asked: Scalar) -> Finding:
    """The finding for a number with its unit."""
    if typed.rational is None and number_of(typed.value, {}) is None:
        return found(UNDECIDED, "reading", "it has no value")
    sought = asked.sought
    if sought is None:
        return found(WRONG, "form", "a formula is asked for: the scene has no number for it")
    if typed.unit is None:
        return unitless_judged(typed, direction, asked, sought)
    meant = measured(typed.unit, asked.unit, asked.dimension, asked.turns)
    if meant.unit is None:
        assert meant.fault is not None
        return Finding(WRONG, (meant.fault,))
    return valued(typed, meant.unit, direction, asked, sought) or slip(typed, meant.unit, asked, sought)


def unitless_judged(typed: Typed, direction: str, asked: Scalar, sought: Sought) -> Finding:
    """The finding for a number without a unit, in whichever unit it is right."""
    if typed.rational == 0:
        return valued(typed, asked.unit, direction, asked, sought) or slip(typed, asked.unit, asked, sought)
    for unit in without_unit(asked.unit, sought.si, asked.dimension):
        finding = valued(typed, unit, direction, asked, sought)
        if finding is not None:
            return lacking_unit(finding, unit, asked)
    finding = slip(typed, asked.unit, asked, sought)
    return lacking_unit(finding, asked.unit, asked) if finding.flaws else finding


def lacking_unit(finding: Finding, unit: Unit, asked: Scalar) -> Finding:
    """A finding for a number whose unit should have been there."""
    if asked.marking.unit == marks.OPTIONAL or may_lack(unit, asked.dimension):
        return finding
    remark = found(finding.outcome, "unit", f"the unit is missing: {unit.text}").remarks
    return Finding(finding.outcome, (*finding.remarks, *remark), (*finding.flaws, marks.UNIT))


def valued(typed: Typed, unit: Unit, direction: str, asked: Scalar, sought: Sought) -> Finding | None:
    """The finding where the number is within the tolerance, perhaps with the other sign, or where that can't be told; else None."""
    value = sought.in_unit(unit)
    turned = turned_round(direction, asked.direction) if direction and asked.direction else False
    if turned is None:
        return found(WRONG, "direction", f"it points another way: {asked.direction}")
    signed = oriented(typed, value, turned) if direction and asked.direction else typed
    holds = within(signed, value, asked.marking.tolerance, unit)
    if holds is None:
        return found(outcome_of(None), "tolerance", "it lies on the edge of the tolerance")
    if holds:
        return well_formed(typed, value, asked)
    if within(signed.times(Fraction(-1)), value, asked.marking.tolerance, unit):
        if turned:
            return found(WRONG, "direction", f"it points the other way: {asked.direction}")
        return right_but_for_sign(asked.directed, asked.direction, asked.positive, asked.sign, asked.marking)
    return None


def oriented(typed: Typed, value: Certified, turned: bool) -> Typed:
    """The number that a size, or a signed number, with a direction stands for: `−8.8 m/s, left` and `8.8 m/s, left` are both −8.8 m/s
    where right is positive, and so is `−8.8 m/s, right`."""
    minus, wanted = (typed.rational or 0) < 0, (value.sign or 1) < 0
    agrees = minus if turned else not minus or wanted
    return typed if minus == (wanted == agrees) else typed.times(Fraction(-1))


def well_formed(typed: Typed, value: Certified, asked: Scalar) -> Finding:
    """A right number, with what its form costs: too few figures, or a number where a formula is wanted."""
    remarks: list[Remark] = []
    flaws: list[str] = []
    wanted = asked.marking.tolerance.figures
    if wanted is not None and typed.figures is not None and typed.figures < wanted and not is_exactly(typed, value):
        remarks.append(Remark("figures", (f"right as far as it goes, but {wanted} figures are wanted",)))
        flaws.append(marks.ROUNDING)
    if asked.marking.form == marks.EXACT and not is_form(typed, asked):
        remarks.append(Remark("form", ("the number is right, but a formula is wanted",)))
        flaws.append(marks.FORM)
    return Finding(RIGHT, tuple(remarks), tuple(flaws))


def is_form(typed: Typed, asked: Scalar) -> bool:
    """Whether a number is the closed form: ⅝, π/12."""
    closed = asked.closed
    return (
        closed is not None
        and not closed.symbols()
        and bool(asked.same(typed.value * (typed.unit or asked.unit).factor, closed))
    )


def is_exactly(typed: Typed, value: Certified) -> bool:
    """Whether a number is the one that is sought, not just near it."""
    return typed.rational is not None and value.equals(typed.rational)


def slip(typed: Typed, unit: Unit, asked: Scalar, sought: Sought) -> Finding:
    """What a number that is out of the tolerance may come of: too few figures, another unit, a power of ten."""
    value = sought.in_unit(unit)
    if rounds_to(typed, value):
        return too_few(typed)
    for other in likely_meant(typed.unit, asked.unit, sought.si, asked.dimension):
        if within(typed, sought.in_unit(other), asked.marking.tolerance, other):
            return found(WRONG, "unit", f"the number would be right in {other.text or 'no unit'}")
    for power in powers(typed, value):
        if within(typed.times(Fraction(10) ** power), value, asked.marking.tolerance, unit):
            return found(WRONG, "power", f"off by a factor of {10 ** abs(power)}: look at the prefixes of units")
    return Finding(WRONG)


def too_few(typed: Typed) -> Finding:
    """What is said of a number that is right to its figures, but not to the tolerance."""
    count = typed.figures or 0
    said = f"right as far as it goes, but {'1 figure is' if count == 1 else f'{count} figures are'} too few"
    return found(WRONG, "figures", said, flaws=(marks.ROUNDING,) if count >= LEAST_FIGURES else ())


def powers(typed: Typed, value: Certified) -> Iterator[int]:
    """The power of ten by which a number may be off."""
    number, wanted = typed.rational, abs(value.float)
    if number and wanted:
        power = floor(log10(wanted)) - rounded(number, 1)[1]
        for nearby in (power, power - 1, power + 1):
            if 0 < abs(nearby) <= POWERS:
                yield nearby


# formulas


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
    finding = put_in_for_missing(formula, asked, fits) or put_in_beside(formula, asked)
    if finding is None and fits:
        finding = put_in_with_answers(formula, asked, measured)
    return finding if finding is None or fits else lacking_unit(finding, asked.unit, asked)


def put_in_for_missing(formula: Formula, asked: Scalar, fits: bool) -> Finding | None:
    """The finding where the numbers of the letters that a formula lacks make the closed form equal to it."""
    closed = asked.closed
    reduced = None if closed is None else put_in(closed, formula, asked.values, asked.numbers, fits)
    if closed is None or reduced is None:
        return None
    missing = sorted(closed.symbols() - formula.symbols())
    holds = asked.same(formula, reduced) if missing else False
    if holds is None:  # sin 35° and its like, which exact algebra does not know
        holds = asked.close(formula, reduced, EXACTLY)
    if holds:
        return with_numbers(asked, missing)
    if has_decimal(formula):
        share = min(Fraction(rounding(formula)), asked.marking.tolerance.share or Fraction(USUAL))
        if asked.close(formula, reduced, share) and is_near(formula, asked, share):
            return with_numbers(asked, missing, rounded=True)
    return None


def is_near(formula: Formula, asked: Scalar, share: Fraction) -> bool:
    """Whether a formula is within a share of the answer for the scene's own numbers, where it has one for them."""
    number = number_of(formula, asked.values)
    if number is None or asked.sought is None:
        return True
    value = asked.sought.in_unit(asked.sought.si)
    return abs(number.float - value.float) <= share * abs(value.float)


def put_in_with_answers(formula: Formula, asked: Scalar, measured: bool) -> Finding | None:
    """The finding where numbers stand beside letters of other answers: both are written out in givens, with the same numbers put in."""
    some = measured or bool(numbers_in(formula))  # 1 kg has left no number
    both = None if asked.closed is None or not some else put_in_both(asked.closed, formula, asked.values, asked.answers)
    if both is None:
        return None
    holds = asked.same(both.typed, both.closed)
    if holds or (holds is None and asked.close(both.typed, both.closed, EXACTLY)):
        return found(RIGHT, "numbers", "right with numbers put in", flaws=exactness(asked))
    return None


def put_in_beside(formula: Formula, asked: Scalar) -> Finding | None:
    """The finding where a formula is right with letters in place of their numbers."""
    for meant, names in with_letters(formula, asked.numbers):
        if asked.closed is not None and not of_other_dimension(meant, asked) and asked.same(meant, asked.closed):
            return with_numbers(asked, sorted(names))
    return None


def with_numbers(asked: Scalar, names: list[str], *, rounded: bool = False) -> Finding:
    """What is said of a right formula in which there are numbers of these letters."""
    listed = [word for name in names for word in (", ", Symbol(name))][1:]
    put: tuple[str | Formula, ...] = ("right with the number of ", *listed, " put in") if names else ("right",)
    said = (*put, ", but a number in it is rounded") if rounded else put
    return found(RIGHT, "numbers", *said, flaws=exactness(asked))


def exactness(asked: Scalar) -> tuple[str, ...]:
    """The flaw of numbers where a formula is wanted."""
    return (marks.FORM,) if asked.marking.form == marks.EXACT else ()


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
