"""Readings: one reading of a number or a formula held against what is asked."""

from __future__ import annotations

from rotsolve.grading.comparing.finding import Finding, found
from rotsolve.grading.comparing.formulas.formula import formula_judged
from rotsolve.grading.comparing.numbers import Typed
from rotsolve.grading.comparing.scalars import Scalar, number_judged
from rotsolve.grading.comparing.units import measured
from rotsolve.grading.reading.records import FORMULA, NUMBER, Reading
from rotsolve.grading.verdict import WRONG


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
