"""Motions followed in time: extrapolated midpoint steps for any equations, Taylor's series with many digits for Euler's."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np

from second_route.particles import root

Array = Any
Slope = Callable[[float, Array], Array]
LEVELS = 9  # halves of steps: errors of the order (H/…)^18
DIGITS = 30
ORDER = 30


def cross(one: Array, other: Array) -> Array:
    """Of two vectors; NumPy's own is slow for two."""
    (a, b, c), (d, e, f) = one, other
    return np.array([b * f - c * e, c * d - a * f, a * e - b * d])


def midpoint(slope: Slope, time: float, state: Array, step: float, parts: int) -> Array:
    """Gragg's modified midpoint rule, whose error is a series in the square of its parts."""
    part = step / parts
    before, now = state, state + part * slope(time, state)
    for k in range(1, parts):
        before, now = now, before + 2 * part * slope(time + k * part, now)
    return (before + now + part * slope(time + step, now)) / 2


def stepped(slope: Slope, time: float, state: Array, step: float) -> Array:
    """A step, extrapolated to infinitely many parts."""
    counts = [2 * (k + 1) for k in range(LEVELS)]
    row = [midpoint(slope, time, state, step, parts) for parts in counts]
    for level in range(1, LEVELS):
        ratios = [(counts[k + level] / counts[k]) ** 2 for k in range(len(row) - 1)]
        row = [row[k + 1] + (row[k + 1] - row[k]) / (ratio - 1) for k, ratio in enumerate(ratios)]
    return row[0]


def followed(slope: Slope, state: Array, until: float, steps: int) -> Array:
    """The state at a time, from the one at 0."""
    step = until / steps
    for k in range(steps):
        state = stepped(slope, k * step, state, step)
    return state


def first_passage(slope: Slope, state: Array, height: Callable[[Array], float], step: float) -> tuple[float, Array]:
    """When, and how, a height of the state first passes zero after the first step; no two passages may lie within a step."""
    time, state = step, stepped(slope, 0.0, state, step)
    while (height(state) > 0) == (height(after := stepped(slope, time, state, step)) > 0):
        time, state = time + step, after
    part = root(lambda part: height(stepped(slope, time, state, part)), 0.0, step)
    return time + part, stepped(slope, time, state, part)


def euler_series(moments: list[Any], omega: list[Any]) -> list[list[Any]]:
    """Taylor's coefficients of ω in the body's axes: I₁ ω̇₁ = (I₂ − I₃) ω₂ ω₃ and so on round."""
    a, b, c = moments
    shares = ((b - c) / a, (c - a) / b, (a - b) / c)
    rows = [[start] for start in omega]
    for n in range(ORDER):
        for k, more in enumerate([shares[k] * mpmath.fdot(rows[k - 2], rows[k - 1][::-1]) / (n + 1) for k in range(3)]):
            rows[k].append(more)
    return rows


def at_time(rows: list[list[Any]], time: Any) -> list[Any]:
    return [mpmath.polyval(row[::-1], time) for row in rows]


class FreeRotation:
    """A free body's angular velocity in its own axes, followed with thirty digits."""

    def __init__(self, moments: list[float], omega: list[float]) -> None:
        with mpmath.workdps(DIGITS):
            self.moments = [mpmath.mpf(repr(float(item))) for item in moments]
            self.start = [mpmath.mpf(repr(float(item))) for item in omega]
            size = mpmath.sqrt(sum(item**2 for item in self.start))
            self.step = 1 / (4 * size)  # well within the radius of convergence: no share of `euler_series` is above 1

    def after(self, time: float) -> Array:
        with mpmath.workdps(DIGITS):
            left, omega = mpmath.mpf(repr(float(time))), self.start
            while left > 0:
                step = min(left, self.step)
                omega = at_time(euler_series(self.moments, omega), step)
                left -= step
            return np.array([float(item) for item in omega])

    def passages(self, component: int, count: int) -> list[tuple[float, Array]]:
        """When a component passes zero after the start, and ω then, as many times as are asked for."""
        found: list[tuple[float, Array]] = []
        with mpmath.workdps(DIGITS):
            time, omega = mpmath.mpf(0), self.start
            while len(found) < count:
                rows = euler_series(self.moments, omega)
                after = at_time(rows, self.step)
                if omega[component] * after[component] < 0:
                    series = rows[component][::-1]
                    part = mpmath.findroot(
                        lambda t, row=series: mpmath.polyval(row, t), (0, self.step), solver="anderson"
                    )
                    found.append((float(time + part), np.array([float(item) for item in at_time(rows, part)])))
                time, omega = time + self.step, after
        return found
