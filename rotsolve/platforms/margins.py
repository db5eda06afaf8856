"""Margins: the decimal numbers that stand in a platform's file, and how far an answer may be from them."""

from __future__ import annotations

from fractions import Fraction

from rotsolve.algebra.certified.ball import Certified
from rotsolve.algebra.units.quantities import number_in_unit
from rotsolve.grading.comparing.numbers import certified_number, half_figure
from rotsolve.grading.comparing.scalars import Scalar
from rotsolve.page.values import certified_digits, machine_number

MOST_DIGITS = 15  # of a number of a platform, which is a float there
FINE = 1000  # the margin is so many times what rounding takes away from the number


def tolerated_margin(value: Certified, asked: Scalar) -> Fraction:
    """How far an answer may be from its value, in its unit."""
    tolerance = asked.marking.tolerance
    if tolerance.share is not None:
        return tolerance.share * abs(Fraction(value.float))
    if tolerance.amount is not None:
        amount = certified_number(number_in_unit(tolerance.amount, asked.unit), {})
        return Fraction(0) if amount is None else Fraction(amount.float)
    assert tolerance.figures is not None
    return half_figure(value, tolerance.figures)


def decimal_of(value: Certified, margin: Fraction, digits: int) -> str:
    """The number in so many digits, or more: what rounding takes away from it is nothing beside the margin."""
    for figures in range(min(digits, MOST_DIGITS), MOST_DIGITS + 1):
        text = machine_number(certified_digits(value, figures)[0])
        if text and abs(Fraction(text) - Fraction(value.float)) * FINE <= margin:
            return text
    return machine_number(certified_digits(value, MOST_DIGITS)[0])


def shown_margin(margin: Fraction) -> str:
    """A margin as a decimal number, 0 where there is none."""
    return f"{float(margin):.6g}"
