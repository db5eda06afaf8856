"""Clock: the moments of a motion that are drawn, and how fast they are shown."""

from __future__ import annotations

import math

from msgspec import Struct

PER_SECOND = 25  # pictures in a second of the show
BRIEF, LONG = 1.0, 30.0  # seconds of a motion that is slowed down, and of one that is sped up
SHOWN = 3.0  # seconds that a brief motion is shown, at least; a long one is shown for LONG seconds, at most


class Clock(Struct, frozen=True):
    """The moments that are drawn, a step apart up to the end, and how many seconds of the motion go by in one second of the show."""

    times: tuple[float, ...]
    step: float
    pace: float


def clock_for(end: float, step: float | None = None) -> Clock:
    """The clock of a motion of so many seconds, with a picture after each step, or as many as the eye needs."""
    pace = pace_for(end)
    step = step or pace / PER_SECOND
    count = math.ceil(end / step * (1 - 1e-9))
    return Clock((*(step * k for k in range(count)), end), step, pace)


def pace_for(end: float) -> float:
    """1 for real time; of what lasts under a second, or over half a minute, the nearest of 1, 2, 5, 10 … times slower or faster."""
    if BRIEF <= end <= LONG or end <= 0.0:
        return 1.0
    if end < BRIEF:
        return 1.0 / round_number(SHOWN / end)
    return round_number(end / LONG)


def round_number(least: float) -> float:
    """The smallest of 1, 2, 5, 10, 20 … that is no less than a number."""
    unit = 10.0 ** math.floor(math.log10(least))
    return next(part * unit for part in (1, 2, 5, 10) if part * unit >= least * (1 - 1e-9))
