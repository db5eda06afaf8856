"""Crossings: where within a step a function changes its sign, and when it would if accelerations stayed."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

from rotsolve.confirm.course.gauges import Gauge
from rotsolve.confirm.course.laps import Lap
from rotsolve.confirm.course.node import Node

FAR = 1e6  # seconds after which nothing is waited for any more
SAMPLES = (0.03, 0.25, 0.5, 0.75, 0.97, 1.0)  # the outer ones tell that it turns near an end
JUMP = (
    1e-2  # share of the values beside it above which what is left at a change of sign is half a jump, as an angle makes
)
GOLDEN, SECTIONS = (math.sqrt(5) - 1) / 2, 24
NEAR = 0.5  # share of what is left at a look below which more is looked for beside it


def sign_change(function: Callable[[Node], float], at: Callable[[float], Node], low: float, high: float) -> float:
    """The part of a step at which a function changes its sign, by the rule of Illinois."""
    a, b = function(at(low)), function(at(high))
    kept = 0  # which end has stayed: one that stays twice counts half, else an end with a large value stays for ever
    for _ in range(100):
        part = high - b * (high - low) / (b - a) if b != a else (low + high) / 2
        value = function(at(part))
        if abs(value) < 1e-14 * max(abs(a), abs(b), 1e-300) or abs(high - low) < 1e-13:
            break
        if (value > 0) == (b > 0):
            high, b, a = part, value, a / 2 if kept == -1 else a
            kept = -1
        else:
            low, a, b = part, value, b / 2 if kept == 1 else b
            kept = 1
    return part


def crossings(gauge: Gauge, lap: Lap) -> list[float]:
    """Where a gauge changes its sign within a step; not where the phase begins."""
    parts = (0.0, *SAMPLES)
    values = [gauge.value(lap.at(part)) for part in parts]
    small = 1e-9 * gauge.size
    found: list[float] = []
    for place in (
        range(1, len(values) - 1) if not (gauge.passing or gauge.way) else ()
    ):  # it may come to it and go back between
        a, b, c = values[place - 1 : place + 2]
        if a * b > 0 < b * c and abs(b) < min(abs(a), abs(c)):
            found += touched(gauge.value, lap.at, parts[place - 1], parts[place + 1])
    for low, high, a, b in zip(parts, parts[1:], values, values[1:], strict=False):
        if (abs(a) <= small and low == 0.0) or a * gauge.way > small:  # of an extreme the other one
            continue
        if a * b < 0 and abs(b) > small:
            part = sign_change(gauge.value, lap.at, low, high)
            if gauge.passing or gauge.way or abs(gauge.value(lap.at(part))) <= JUMP * max(abs(a), abs(b)):
                found.append(part)
        elif abs(b) <= small < abs(a):
            found.append(high)
    return sorted(found)


def touched(function: Callable[[Node], float], at: Callable[[float], Node], low: float, high: float) -> list[float]:
    """Where a function first changes its sign between places between which it comes nearest to zero, by golden sections; else none."""
    begun = function(at(low))
    way, start = (1.0 if begun > 0 else -1.0), low
    for _ in range(SECTIONS):
        inner, outer = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        one, two = (way * function(at(part)) for part in (inner, outer))
        if min(one, two) < 0.0:
            return [sign_change(function, at, start, inner if one < 0.0 else outer)]
        low, high = (low, outer) if one < two else (inner, high)
    return []


def dips(known: Sequence[tuple[float, float]]) -> Iterator[tuple[float, float]]:
    """The parts between which what is above zero at some may come below it and back: where a parabola through three does, or nearly."""
    for (x, a), (y, b), (z, c) in zip(known, known[1:], known[2:], strict=False):
        least, first, last = min(a, b, c), (b - a) / (y - x), (c - b) / (z - y)
        bend = (last - first) / (z - x)
        if least > 0.0 < bend:
            slope = first + bend * (y - x)  # in the midst
            if x < y - slope / (2.0 * bend) < z and b - slope**2 / (4.0 * bend) < NEAR * least:
                yield x, z


def first_zero(gauge: Gauge, bare: Lap) -> float | None:
    """When a gauge vanishes with constant accelerations: by the parabola through three instants, and once more near there."""
    scale = 1.0
    for _ in range(3):
        values = [gauge.value(bare.at(part * scale)) for part in (0.0, 0.5, 1.0)]
        if abs(values[0]) <= 1e-12 * gauge.size:
            values[0] = 0.0
        bend = 2.0 * (values[2] - 2.0 * values[1] + values[0])
        slope = values[2] - values[0] - bend
        soonest = least_positive(bend, slope, values[0])
        if soonest is None:
            return None
        scale *= soonest
    return scale if 0.0 < scale < FAR else None


def least_positive(a: float, b: float, c: float) -> float | None:
    """The smallest positive root of a x² + b x + c."""
    size = max(abs(a), abs(b), abs(c))
    if size == 0.0:
        return None
    if abs(a) < 1e-13 * size:
        return -c / b if b and -c / b > 1e-12 else None
    inside = b * b - 4.0 * a * c
    if inside < -1e-12 * size * size:
        return None
    root = math.sqrt(max(inside, 0.0))
    q = -0.5 * (b + math.copysign(root, b))
    roots = [q / a] + ([c / q] if q else [])
    positive = [value for value in roots if value > 1e-9]
    return min(positive, default=None)
