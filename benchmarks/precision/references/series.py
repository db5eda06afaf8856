"""Taylor series on FLINT: y(t) of y′ = f(y), each coefficient from those before by f on truncated power series."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from flint import arb, arb_series, ctx

Field = Callable[[list[Any]], list[Any]]  # f on power series


def coefficients(field: Field, state: list[arb], order: int) -> list[list[arb]]:
    """yₙ up to an order: one more a round, since f of the first n gives the derivative's first n."""
    known = [[value] for value in state]
    for count in range(1, order + 1):
        rates = field([arb_series(given, count) for given in known])
        for given, rate in zip(known, rates, strict=True):
            given.append(arb_series(rate, count)[count - 1] / count)
    return known


def longest(known: list[list[arb]], order: int, digits: int) -> float:
    """The step for which the last two coefficients of each series are as small as the digits ask."""
    logarithms = [
        -(digits + float(abs(given[power]).log()) / math.log(10)) / power
        for given in known
        for power in (order - 1, order)
        if not given[power].contains(0)
    ]
    return float(10 ** min(logarithms))


def summed(given: list[arb], step: arb) -> arb:
    """Σ yₙ hⁿ, without its radius, which says nothing of what is cut off."""
    value = arb(0)
    for coefficient in reversed(given):
        value = value * step + coefficient
    return value.mid()


def integrate(field: Field, start: Callable[[], list[arb]], until: int, digits: int, guard: int = 30) -> list[arb]:
    """y at a time, to about so many digits, worked out with more on `guard`; `start` is called at the precision of the work."""
    order = round(1.3 * digits)
    precision, cap = ctx.dps, ctx.cap
    ctx.dps, ctx.cap = digits + guard, order + 1
    try:
        state, left = start(), arb(until)
        while left > 0:
            known = coefficients(field, state, order)
            step = min(left, arb(longest(known, order, digits)))
            state, left = [summed(given, step) for given in known], (left - step).mid()
        return state
    finally:
        ctx.dps, ctx.cap = precision, cap
