"""Together: other numbers for several letters at once with which the equations of all bodies leave nothing over.

From each of some starts they are improved together by Gauss's and Newton's steps: angles from other quadrants, sizes from others.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import suppress

from rotsolve.algebra.formula import Symbol
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
    found = [value for value in found if is_apart(hearing, letter, value, own)]
    if hearing.is_angle(letter):
        found = [math.remainder(value, math.tau) for value in found]
    beyond = {"largest": own.__lt__, "smallest": own.__gt__}.get(find.modifier)
    return any(map(beyond, found)) if beyond is not None else bool(found)


def against_its_sense(hearing: Hearing, letter: str, own: float) -> float | None:
    """Another number of a letter, with others of the rest; None where there is none."""
    found = (numbers[letter] for numbers in hearing.other_sets)
    return next((value for value in found if is_apart(hearing, letter, value, own)), None)


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
    """Whether one of some numbers is another than that which is answered."""
    return any(is_apart(hearing, name, value, own[name]) for name, value in found.items())


def is_apart(hearing: Hearing, name: str, value: float, own: float) -> bool:
    """Whether two numbers of a letter are different ones; angles whole turns apart are not."""
    angle = hearing.is_angle(name)
    near = math.remainder(value - own, math.tau) if angle else value - own
    return abs(near) > APART * max(abs(own), abs(value), 1.0 if angle else 0.0)


def sets_on_the_way(hearing: Hearing) -> Iterator[tuple[str, Numbers, str]]:
    """Other numbers of several letters, of which some are asked for by no question, each set with the first of these that is another, and
    with what is said of it where it goes against its sense."""
    asked = {find.formula for find in hearing.problem.finds if not find.terms}
    names = [name for name in hearing.places if isinstance(name, str) and Symbol(name) not in asked]
    for found in hearing.other_sets if names else ():
        letter = next((name for name in names if is_apart(hearing, name, found[name], hearing.known[name])), "")
        if letter:
            said = f": {letter} = {found[letter]:g} in SI units makes it so too"
            yield letter, found, "" if in_sense(hearing, found) else said
