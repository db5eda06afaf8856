"""Numbers: whether a typed number is within the tolerance of the number that is sought, |x − v| ≤ margin, in certified balls.

A number on the very edge is within; where neither the balls nor exact arithmetic tell, nothing is decided. Its unit has to measure what is
asked: a frequency in Hz counts turns, an angular velocity in rad/s counts radians. Neither stands for the other, though both are 1/s.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from msgspec import Struct

from rotsolve.algebra.certified.ball import Certified, Precision, ends, evaluate, rounded
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.flints import arb
from rotsolve.algebra.formula import Formula, Number
from rotsolve.algebra.notation.limits import rational
from rotsolve.algebra.units.dimension import (
    ANGLE,
    ANGULAR_ACCELERATION,
    ANGULAR_VELOCITY,
    FREQUENCY,
    NONE,
    Dimension,
    describe,
    kind_of,
)
from rotsolve.algebra.units.quantities import number_in_unit, parse_unit
from rotsolve.algebra.units.unit_table import ONE_UNIT, Unit
from rotsolve.grading.verdict import Remark
from rotsolve.language.marks import Tolerance

DIGITS = (15, 40, 120, 400)  # how closely both numbers are known, until they can be told apart
BITS = 1600  # of precision in which they are compared
FLOAT_BITS = 45  # of a ball that floats stand for
FLOAT_DOUBT = 1e-12  # the share by which they may be off, with room to spare
HALF = Fraction(1, 2)
LEAST_FIGURES = 2  # a number with fewer says too little to be right as far as it goes
ALIKE = {  # units that are taken for one another
    ANGLE: ("rad", "°", "rev"),
    ANGULAR_VELOCITY: ("rad/s", "rev/s", "rpm", "°/s"),
    ANGULAR_ACCELERATION: ("rad/s²", "rev/s²", "°/s²"),
}


class Typed(Struct, frozen=True):
    """A number as a student typed it: its value before the unit, its significant figures (None where it is exact), its unit.

    `zeros` at the end of a whole number are figures that need not count.
    """

    value: Formula
    figures: int | None = None
    unit: Unit | None = None
    zeros: int = 0

    @property
    def sure_figures(self) -> int | None:
        """The figures that surely count."""
        return None if self.figures is None else self.figures - self.zeros

    @property
    def rational(self) -> Fraction | None:
        """The number where it is rational: every decimal is."""
        return rational(self.value)

    @property
    def half_unit(self) -> Fraction | None:
        """Half a unit of its last figure; None where it is exact, or zero."""
        return self.half_unit_of(self.figures)

    def half_unit_of(self, figures: int | None) -> Fraction | None:
        """Half a unit of the last of so many figures."""
        number = self.rational
        if not number or figures is None:
            return None
        return HALF * Fraction(10) ** (rounded(number, figures)[1] - figures + 1)

    def times(self, factor: Fraction) -> Typed:
        """The same figures for a number so many times as large."""
        return Typed(factor * self.value, self.figures, self.unit, self.zeros)


def within_tolerance(typed: Typed, value: Certified, tolerance: Tolerance, unit: Unit) -> bool | None:
    """Whether |x − v| is no more than the tolerance allows; both numbers before `unit`. None where that can't be told."""
    if tolerance.share is not None:
        return is_near(typed, value, share=tolerance.share)
    if tolerance.amount is not None:
        return is_near(typed, value, margin=number_in_unit(tolerance.amount, unit))
    assert tolerance.figures is not None
    return is_near(typed, value, margin=Number(half_figure(value, tolerance.figures)))


def half_figure(value: Certified, figures: int) -> Fraction:
    """Half a unit of the last of so many figures of a number."""
    with Precision(BITS):
        largest = ends(value.ball.abs_upper())[1]
    return HALF * Fraction(10) ** (rounded(largest, figures)[1] - figures + 1) if largest else Fraction(0)


def is_near(
    typed: Typed, value: Certified, *, share: Fraction = Fraction(0), margin: Formula | None = None
) -> bool | None:
    """Whether |x − v| ≤ share · |v|, or ≤ margin."""
    clear = near_by_floats(typed, value, share, margin)
    if clear is not None:
        return clear
    number = evaluate(typed.value, {})
    for digits in DIGITS:
        x, v = (one.ball if digits == DIGITS[0] else one.refine(digits) for one in (number, value))
        with Precision(BITS):
            allowed = (
                abs(v) * (arb(share.numerator) / share.denominator)
                if margin is None
                else evaluate(margin, {}, digits=digits).ball
            )
            gap = abs(x - v) - allowed
        if gap <= 0:
            return True
        if gap > 0:
            return False
    return True if any(value.equals(edge) for edge in tolerance_edges(typed, share, margin)) else None


def near_by_floats(typed: Typed, value: Certified, share: Fraction, margin: Formula | None) -> bool | None:
    """What floats tell where they are far from the edge; None where they are not, or where the number is not known so well."""
    number = typed.rational
    exact = margin is None or isinstance(margin, Number)
    if number is None or not exact or value.ball.rel_accuracy_bits() < FLOAT_BITS:
        return None
    try:
        x, v = float(number), value.float
        allowed = float(share) * abs(v) if not isinstance(margin, Number) else float(margin.value)
    except OverflowError:
        return None
    gap, doubt = abs(x - v) - allowed, FLOAT_DOUBT * (abs(x) + abs(v) + allowed)
    return None if abs(gap) <= doubt else gap < 0


def tolerance_edges(typed: Typed, share: Fraction, margin: Formula | None) -> Iterator[Fraction]:
    """The values for which a rational number lies exactly on the edge."""
    number = typed.rational
    if number is None or not (margin is None or isinstance(margin, Number)):
        return
    for side in (1, -1):
        if isinstance(margin, Number):
            yield number + side * margin.value
        elif share < 1 or side == 1:
            yield number / (1 + side * share)


def rounds_to(typed: Typed, value: Certified) -> bool:
    """Whether the typed number is the other, rounded to the figures that it has."""
    return bool(figures_that_hold(typed, value))


def figures_that_hold(typed: Typed, value: Certified) -> int:
    """To how many of its figures the typed number is the other, rounded; 0 where it is not. Without zeros that need not count, two at
    least are left."""
    figures, sure = typed.figures or 0, typed.sure_figures or 0
    for count in range(figures, min(figures, max(sure, LEAST_FIGURES)) - 1, -1):
        half = typed.half_unit_of(count or None)
        if half is not None and is_near(typed, value, margin=Number(half)):
            return count
    return 0


def certified_number(value: Formula, values: Mapping[str, Formula]) -> Certified | None:
    """The certified value of a formula; None where a letter has no value, or it has none."""
    if not value.symbols() <= values.keys():
        return None
    try:
        return evaluate(value, values)
    except (Undefined, ZeroDivisionError):
        return None


# units


def measured_unit(typed: Unit, wanted: Unit, dimension: Dimension, turns: bool = False) -> Unit | Remark:
    """The unit in which a number in the typed one is meant, or the remark that it does not measure what is asked; `turns` says that a
    pure number counts turns."""
    if not typed.dimension.matches(dimension):
        return Remark("dimension", (other_dimension(typed, dimension),))
    if dimension.matches(FREQUENCY):
        return measured_rate(typed, wanted, dimension)
    if typed.is_hertz and dimension.angle:
        return Remark("unit", (f"{typed.text} counts turns, {wanted.text} radians",))
    if turns and typed.dimension == ANGLE:
        return ONE_UNIT if typed.counts_turns else typed.of_turns
    return typed


def other_dimension(typed: Unit, dimension: Dimension) -> str:
    """What is said of a unit that measures something else."""
    kind, asked = kind_of(typed.dimension, "frequency" if typed.is_hertz else None), describe(dimension, article=True)
    here = f"is the unit of {kind.words}" if kind is not None else "is the unit of something else"
    return f"{typed.text} {here}, but {asked} is asked for"


def measured_rate(typed: Unit, wanted: Unit, dimension: Dimension) -> Unit | Remark:
    """Hz beside rad/s: revolutions in a second are a frequency too, radians are not, and Hz is no angular velocity."""
    if dimension.angle and typed.is_hertz:
        said = f"{typed.text} counts turns: it measures a frequency, and ω = 2π f is in rad/s"
        return Remark("unit", (said,))
    if wanted.is_hertz and typed.dimension.angle:
        if typed.counts_turns:
            return typed.of_turns
        said = f"{typed.text} measures an angular frequency: f = ω/(2π) is in Hz"
        return Remark("unit", (said,))
    return typed


def may_lack(unit: Unit, dimension: Dimension) -> bool:
    """Whether a unit may be left out: radians may, where there is no other."""
    return dimension.matches(NONE) and unit.scale == 1 and not unit.pi_power


def likely_meant(typed: Unit | None, wanted: Unit, si: Unit, dimension: Dimension) -> tuple[Unit, ...]:
    """Units in which a number may have been worked out, though another was written."""
    alike = next((names for kind, names in ALIKE.items() if kind.matches(dimension)), ())
    units = dict.fromkeys((wanted, si, *map(parse_unit, alike)))
    return tuple(unit for unit in units if typed is None or unit.factor != typed.factor)
