"""Sides: which way a direction with letters in it points, as a drawing would show it."""

from __future__ import annotations

from fractions import Fraction

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import Formula, Number

_SMALL, _STEP = (
    Fraction(3, 10),
    Fraction(7, 100),
)  # unequal sizes, so that no difference of letters vanishes by accident


def rough(value: Formula) -> float:
    """A rough value with every letter set to a small positive number, to tell left from right."""
    names = sorted(value.symbols())
    try:
        return evaluate(
            value, {name: Number(_SMALL + _STEP * index) for index, name in enumerate(names)}, digits=3
        ).float
    except ValueError:
        return 0.0
