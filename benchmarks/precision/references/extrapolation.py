"""Gragg's extrapolation in mpmath: y(t + h) of y′ = f(t, y) from midpoint rules of 2, 4, 6, … steps, h² → 0."""

from __future__ import annotations

from typing import Any

from mpmath import mp

from ..problem import Rates

MOST_COLUMNS, USUAL_COLUMNS = 40, 20


class NoConvergence(ArithmeticError):
    """The step was too long."""


def midpoint(rates: Rates, time: Any, state: list[Any], step: Any, count: int) -> list[Any]:
    """`count` leapfrog steps over `step`, the first by Euler: its error is a series in the square of their length."""
    short = step / count
    before, now = state, [value + short * rate for value, rate in zip(state, rates(time, state), strict=True)]
    for number in range(1, count):
        slopes = rates(time + number * short, now)
        before, now = now, [value + 2 * short * rate for value, rate in zip(before, slopes, strict=True)]
    return now


def advance(rates: Rates, time: Any, state: list[Any], step: Any, tolerance: Any) -> tuple[list[Any], int]:
    """One step, with as many columns of the table as it takes until two neighbours agree, and how many those were."""
    row: list[list[Any]] = []
    for column in range(1, MOST_COLUMNS):
        newest = [midpoint(rates, time, state, step, 2 * column)]
        for back, older in enumerate(row, start=1):
            ratio = mp.mpf(column) / (column - back)
            newest.append(
                [fine + (fine - rough) / (ratio**2 - 1) for fine, rough in zip(newest[-1], older, strict=True)]
            )
        if row and max(abs(a - b) for a, b in zip(newest[-1], row[-1], strict=True)) < tolerance:
            return newest[-1], column
        row = newest
    raise NoConvergence(f"no convergence within {MOST_COLUMNS} columns over a step of {mp.nstr(step, 5)}")


def integrate(rates: Rates, time: Any, state: list[Any], until: Any, step: Any) -> list[Any]:
    """y at a time, in steps that take about the usual columns; each is good to all but 15 of the working digits."""
    tolerance = mp.mpf(10) ** (15 - mp.dps)
    while time < until:
        step = min(step, until - time)
        try:
            state, columns = advance(rates, time, state, step, tolerance)
        except NoConvergence:
            step /= 2
            continue
        time, step = time + step, step * USUAL_COLUMNS / columns
    return state
