"""Together: other numbers for several letters at once with which the equations of all bodies leave nothing over.

From each of some starts they are improved together by Gauss's and Newton's steps: angles from other quadrants, sizes from others.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import suppress

from rotsolve.confirm import NotConfirmed, Unfit
from rotsolve.confirm.space.hearing import STEP, Hearing
from rotsolve.language.limited import limited_letters
from rotsolve.language.problem import Find

QUADRANTS = (0.25, 0.5, 0.75)  # of a turn, further than the angle that is answered
OTHER_SIZES = (0.3, -1.0)  # of a size that is answered
STEPS = 12
CLOSE = 1e-7  # share of a number by which it is no longer improved
APART = 1e-3  # of numbers that are others
FARTHEST = 1e6  # times the number that is answered

Numbers = dict[str, float]


def other_sets(hearing: Hearing) -> Iterator[Numbers]:
    """Other numbers for all letters that are put in with which nothing is left over, and no size of a body is negative."""
    own = {name: hearing.known[name] for name in hearing.places if isinstance(name, str)}
    sizes = limited_letters(hearing.problem).keys() & own.keys()
    for start in begun_from(hearing, own) if len(own) == len(hearing.places) else ():
        found = improved(hearing, start)
        if found is not None and is_another(hearing, found, own) and all(found[name] > 0.0 for name in sizes):
            yield found


def as_good(hearing: Hearing, find: Find, own: float) -> bool:
    """Whether an answer may as well be one of other numbers: where the largest is asked for, one that is larger."""
    letter = hearing.letter(find)
    if letter is None:
        return True
    found = [numbers[letter] for numbers in hearing.other_sets if in_sense(hearing, numbers)]
    if hearing.is_angle(letter):
        found = [math.remainder(value, math.tau) for value in found]
    beyond = {"largest": own.__lt__, "smallest": own.__gt__}.get(find.modifier, own.__ne__)
    return any(map(beyond, found))


def in_sense(hearing: Hearing, found: Numbers) -> bool:
    """Whether nothing that is answered as positive is negative among other numbers; of an angle nothing is."""
    return all(hearing.is_angle(name) or value >= 0.0 or hearing.known[name] < 0.0 for name, value in found.items())


def begun_from(hearing: Hearing, own: Numbers) -> Iterator[Numbers]:
    """The numbers from which it is looked, one of them changed at a time."""
    for name, value in own.items():
        if hearing.is_angle(name):
            yield from ({**own, name: value + math.tau * share} for share in QUADRANTS)
        else:
            yield from ({**own, name: value * share} for share in OTHER_SIZES)


def improved(hearing: Hearing, start: Numbers) -> Numbers | None:
    """The numbers near some with which nothing is left over; None where there are none."""
    now = dict(start)
    for _ in range(STEPS):
        here = Hearing(hearing.problem, {**hearing.known, **now}, hearing.told, hearing.scans)
        with suppress(NotConfirmed, Unfit, ArithmeticError, ValueError):
            ways = [change / STEP * step for change, step in zip(here.corrections, here.steps(), strict=True)]
            sizes = [here.size(place) for place in here.places]
            if not all(abs(way) <= FARTHEST * (size or 1.0) for way, size in zip(ways, sizes, strict=True)):
                return None
            now = {name: now[name] + way for name, way in zip(now, ways, strict=True)}
            if all(abs(way) <= CLOSE * size for way, size in zip(ways, sizes, strict=True)):
                return now
            continue
        return None
    return None


def is_another(hearing: Hearing, found: Numbers, own: Numbers) -> bool:
    """Whether one of some numbers is another than that which is answered; whole turns of an angle are none."""
    for name, value in found.items():
        apart = value - own[name]
        near = math.remainder(apart, math.tau) if hearing.is_angle(name) else apart
        if abs(near) > APART * max(abs(own[name]), abs(value), 1.0 if hearing.is_angle(name) else 0.0):
            return True
    return False
