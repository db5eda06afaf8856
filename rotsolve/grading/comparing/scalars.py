"""Scalars: what is asked for, and a number held against it: value, unit, figures, direction, form."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from math import floor, log10

from msgspec import Struct

from rotsolve.algebra.certified.ball import Certified, evaluate, multiple_of, rounded
from rotsolve.algebra.certified.balls import with_values
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.formula import Formula
from rotsolve.algebra.units.dimension import ANGLE, NONE, Dimension
from rotsolve.algebra.units.quantities import unit_for
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.core.remembered import remembered
from rotsolve.grading.comparing.numbers import (
    LEAST_FIGURES,
    Typed,
    certified_number,
    figures_that_hold,
    likely_meant,
    may_lack,
    measured_unit,
    within_tolerance,
)
from rotsolve.grading.comparing.signs import along_motion, is_unclear, points_other_way
from rotsolve.grading.verdict import RIGHT, UNDECIDED, WRONG, Finding, Remark, found
from rotsolve.language import marks
from rotsolve.language.marks import Marking

POWERS = 9  # of ten: a factor that a prefix or a slip of the decimal point makes

Same = Callable[[Formula, Formula], "bool | None"]
Close = Callable[[Formula, Formula, Fraction], bool]


class Scalar(Struct, frozen=True, dict=True, eq=False):
    """What is asked for: its closed form and its number, which of them there are, and how it is marked.

    `direction` is that of its value in words, `positive` that of a positive value where a negative one
    has another; a `directed` one has a sign by convention. `turns` says that it counts turns. `level` is where its direction leads on the
    level, along a slope, and `sized` the direction of that whose size is asked.
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
    level: str = ""
    sized: str = ""

    @property
    def si(self) -> Unit:
        return unit_for(self.dimension)

    @remembered
    def in_unit(self, unit: Unit) -> Certified:
        """The number before a unit, where there is one: by its closed form in SI units, or by its ball in its own unit alone."""
        assert self.value is not None
        if (unit.scale, unit.pi_power) == (self.unit.scale, self.unit.pi_power):
            return self.value
        if self.closed is not None and self.closed.symbols() <= self.values.keys():
            return evaluate(self.closed / unit.factor, self.values)
        return multiple_of(self.value, self.unit.factor / unit.factor)


def number_judged(typed: Typed, direction: str, asked: Scalar) -> Finding:
    """The finding for a number with its unit."""
    if typed.rational is None and certified_number(typed.value, {}) is None:
        return found(UNDECIDED, "reading", "it has no value")
    if asked.value is None:
        return found(WRONG, "form", "a formula is asked for: the scene has no number for it")
    if typed.unit is None:
        return unitless_judged(typed, direction, asked)
    meant = measured_unit(typed.unit, asked.unit, asked.dimension, asked.turns)
    if isinstance(meant, Remark):
        return Finding(WRONG, (meant,))
    finding = value_judged(typed, meant, direction, asked) or slip(typed, meant, asked)
    if asked.turns and finding.right and typed.unit.dimension == ANGLE and not typed.unit.counts_turns:
        said = Remark("unit", (f"a number of turns is asked for: the angle in {typed.unit.text} is taken as one",))
        return Finding(finding.outcome, (*finding.remarks, said), finding.flaws)
    return finding


def unitless_judged(typed: Typed, direction: str, asked: Scalar) -> Finding:
    """The finding for a number without a unit, in whichever unit it is right."""
    if typed.rational == 0:
        return value_judged(typed, asked.unit, direction, asked) or slip(typed, asked.unit, asked)
    for unit in (asked.si, asked.unit) if asked.dimension.matches(NONE) else (asked.unit, asked.si):  # likeliest first
        finding = value_judged(typed, unit, direction, asked)
        if finding is not None:
            return lacking_unit(finding, unit, asked)
    finding = slip(typed, asked.unit, asked)
    return lacking_unit(finding, asked.unit, asked) if finding.flaws else finding


def lacking_unit(finding: Finding, unit: Unit, asked: Scalar) -> Finding:
    """A finding for a number whose unit should have been there."""
    if asked.marking.unit == marks.OPTIONAL or may_lack(unit, asked.dimension):
        return finding
    remark = found(finding.outcome, "unit", f"the unit is missing: {unit.text}").remarks
    return Finding(finding.outcome, (*finding.remarks, *remark), (*finding.flaws, marks.UNIT))


def value_judged(typed: Typed, unit: Unit, direction: str, asked: Scalar) -> Finding | None:
    """The finding where the number is within the tolerance, perhaps with the other sign, or where that can't be told; else None."""
    value = asked.in_unit(unit)
    other = pointing_judged(direction, asked)
    if other is not None:
        return other
    turned = is_turned_by(direction, asked)
    signed = oriented(typed, value, turned) if direction and asked.direction else typed
    holds = within_tolerance(signed, value, asked.marking.tolerance, unit)
    if holds is None and is_same_number(signed, unit, asked):
        holds = True
    if holds is None:
        return found(UNDECIDED, "tolerance", "it lies on the edge of the tolerance")
    if holds:
        return of_its_way(form_judged(typed, value, asked), direction, asked)
    if within_tolerance(signed.times(Fraction(-1)), value, asked.marking.tolerance, unit):
        if turned:
            return found(WRONG, "direction", f"it points the other way: {asked.direction}")
        return right_but_for_sign(asked)
    return None


def is_turned_by(direction: str, asked: Scalar) -> bool:
    """Whether words behind an answer tell the direction other than the one that is sought."""
    return bool(
        direction
        and asked.direction
        and points_other_way(along_motion(direction, asked.positive), asked.direction, asked.level)
    )


def pointing_judged(direction: str, asked: Scalar) -> Finding | None:
    """The finding where words tell neither the direction that is sought nor the other; None where they tell one, or nothing is sought.

    Backwards is against the declared positive direction. Where that is not how it was meant, as along a motion that has turned round,
    nothing is decided; nor is it where a word may say the same in another way, left for counterclockwise round a loop.
    """
    if not (direction and asked.direction):
        return None
    meant = along_motion(direction, asked.positive)
    turned = points_other_way(meant, asked.direction, asked.level)
    if turned is False or (turned and meant == direction):
        return None
    if turned or is_unclear(meant, asked.direction):
        return found(UNDECIDED, "direction", f"can't tell whether {direction} is the same as {asked.direction}")
    return found(WRONG, "direction", f"it points another way: {asked.direction}")


def of_its_way(finding: Finding, direction: str, asked: Scalar) -> Finding:
    """A right size, with what a direction costs that is not that of the quantity: it is marked as a sign is."""
    if not direction or not asked.sized or points_other_way(direction, asked.sized, asked.level) is False:
        return finding
    outcome = finding.outcome if asked.marking.sign == marks.LENIENT else WRONG
    remark = Remark("direction", (f"the size is right, but it points another way: {asked.sized}",))
    return Finding(outcome, (*finding.remarks, remark), finding.flaws if outcome != WRONG else ())


def right_but_for_sign(asked: Scalar) -> Finding:
    """What is said of an answer with the other sign: it is marked as the teacher chose."""
    direction, positive = asked.direction, asked.positive
    if not asked.directed:
        return found(WRONG, "sign", "right but for the sign")
    said = "right but for the sign: the other direction is declared positive"
    if direction and positive:
        way = "" if direction == positive else f", and it is {direction}"
        said = f"right but for the sign: {positive} is declared positive{way}"
    elif direction and asked.value is not None and asked.value.sign == 1:
        said = f"right but for the sign: its size is asked for; it points {direction}"
    return found(RIGHT if asked.marking.sign == marks.LENIENT else WRONG, "sign", said)


def oriented(typed: Typed, value: Certified, turned: bool) -> Typed:
    """The number that a size, or a signed number, with a direction stands for: `−8.8 m/s, left` and `8.8 m/s, left` are both −8.8 m/s
    where right is positive, and so is `−8.8 m/s, right`."""
    return typed.times(Fraction(-1)) if turns_round((typed.rational or 0) < 0, value, turned) else typed


def turns_round(minus: bool, value: Certified, turned: bool) -> bool:
    """Whether what is written with a direction stands for its negative, `turned` where that direction is not the one sought."""
    wanted = (value.sign or 1) < 0
    agrees = minus if turned else not minus or wanted
    return minus != (wanted == agrees)


def is_same_number(typed: Typed, unit: Unit, asked: Scalar) -> bool:
    """Whether a number is exactly the one that is sought, √19.6 for √(2 · 9.8), which balls can't tell."""
    if asked.closed is None or not asked.closed.symbols() <= asked.values.keys():
        return False
    try:
        return equal(typed.value * unit.factor, with_values(asked.closed, asked.values))
    except (ValueError, ArithmeticError):
        return False


def form_judged(typed: Typed, value: Certified, asked: Scalar) -> Finding:
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
    closed, number = asked.closed, typed.value * (typed.unit or asked.unit).factor
    return closed is not None and not closed.symbols() and bool(asked.same(number, closed))


def is_exactly(typed: Typed, value: Certified) -> bool:
    """Whether a number is the one that is sought, not just near it."""
    return typed.rational is not None and value.equals(typed.rational)


def slip(typed: Typed, unit: Unit, asked: Scalar) -> Finding:
    """What a number that is out of the tolerance may come of: too few figures, another unit, a power of ten."""
    value = asked.in_unit(unit)
    figures = figures_that_hold(typed, value)
    if figures:
        return too_few(figures)
    for other in likely_meant(typed.unit, asked.unit, asked.si, asked.dimension):
        if within_tolerance(typed, asked.in_unit(other), asked.marking.tolerance, other):
            return found(WRONG, "unit", f"the number would be right in {other.text or 'no unit'}")
    for power in powers(typed, value):
        if within_tolerance(typed.times(Fraction(10) ** power), value, asked.marking.tolerance, unit):
            return found(WRONG, "power", f"off by a factor of {10 ** abs(power)}: look at the prefixes of units")
    return Finding(WRONG)


def too_few(count: int) -> Finding:
    """What is said of a number that is right to so many figures, but not to the tolerance."""
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
