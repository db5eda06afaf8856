"""Uncertain: what is said of the uncertainty of a number. One above the tolerance costs what a rounded number does."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.grading.comparing.numbers import certified_number, half_figure
from rotsolve.grading.comparing.scalars import Scalar
from rotsolve.grading.reading.records import NUMBER, LineReading
from rotsolve.grading.reading.uncertainty import Uncertainty
from rotsolve.grading.verdict import WRONG, Finding, Remark
from rotsolve.language import marks

UNCERTAIN = "uncertainty"  # the kind of the remark
DOUBT = 1e-9  # the share by which floats may be off


def with_uncertainty(finding: Finding, reading: LineReading, told: Uncertainty, asked: Scalar | None) -> Finding:
    """A finding with what is said of the uncertainty."""
    said, flaws = f"the uncertainty {told.text} is not marked", finding.flaws
    own, allowed = own_margin(reading, told, asked), allowed_margin(asked)
    if own is not None and allowed is not None and own > allowed * (1 + DOUBT):
        said = f"the uncertainty {told.text} is larger than the tolerance"
        if (finding.outcome != WRONG or flaws) and marks.ROUNDING not in flaws:
            flaws = (*flaws, marks.ROUNDING)
    return replace(finding, remarks=(*finding.remarks, Remark(UNCERTAIN, (said,))), flaws=flaws)


def own_margin(reading: LineReading, told: Uncertainty, asked: Scalar | None) -> float | None:
    """By how much a number may be off as its student says, in SI units; None for what is no number."""
    number = None if reading.kind != NUMBER or reading.formula is None else certified_number(reading.formula, {})
    if number is None or asked is None:
        return None
    factor = evaluate((reading.unit or asked.unit).factor, {}).float
    if told.percent:
        return float(told.amount) / 100 * abs(number.float) * factor
    return float(told.amount) * (1 if told.measured else factor)


def allowed_margin(asked: Scalar | None) -> float | None:
    """By how much the answer may be off, in SI units; None where it has no number."""
    if asked is None or asked.value is None:
        return None
    tolerance, value = asked.marking.tolerance, asked.in_unit(asked.si)
    if tolerance.share is not None:
        return float(tolerance.share) * abs(value.float)
    if tolerance.amount is not None:
        return evaluate(tolerance.amount, {}).float
    assert tolerance.figures is not None
    return float(half_figure(value, tolerance.figures))
