"""Consistent: whether the rules for accelerations are what the rules for speeds become in time, so that a motion keeps them.

A rule that holds at one moment alone (a string whose direction changes, taken as it is drawn) is found out so, and refused.
"""

from __future__ import annotations

from collections.abc import Sequence

from rotsolve.core.registry import SEPARATOR, TIME
from rotsolve.inquiry.questions import NotYet
from rotsolve.simulation.moving.course import Course
from rotsolve.simulation.moving.names import path
from rotsolve.simulation.tape.series import FLOATS, Expansion, nearest

OFF = 1e-7  # part of the largest acceleration by which the two may differ
ASIDE = (0.137, -0.211, 0.093, 0.171, -0.059)  # how far from the first state the rules are held against each other
PAIRS = {"velocity": "acceleration", "angular_velocity": "angular_acceleration"}


def check_rules(course: Course) -> None:
    """Refuse a scene whose speeds do not change as its accelerations say, at a state near the first one."""
    pairs = [(path(speed), place, course.letters[rate]) for speed, place, rate in speeds_of(course)]
    places = [place for _, *both in pairs for place in both]
    expansion = Expansion(course.tape, [*places, *(item.rate for item in course.variables)], FLOATS)
    lists = expansion.lists
    state = [nearest(item.start) + ASIDE[k % len(ASIDE)] for k, item in enumerate(course.variables)]
    letters = [course.letters[item.letter] for item in course.variables]
    try:
        expansion.begin({**dict(zip(letters, state, strict=True)), course.letters[TIME]: ASIDE[0]})
    except (ValueError, ZeroDivisionError, OverflowError):
        return  # beside where it starts it is no state of the scene
    for item, place in zip(course.variables, letters, strict=True):
        if place in lists:
            lists[place].append(lists[item.rate][0])
    if course.letters[TIME] in lists:
        lists[course.letters[TIME]].append(1.0)
    expansion.extend(1)
    largest = max([abs(lists[rate][0]) for *_, rate in pairs], default=0.0)
    for name, speed, rate in pairs:
        if abs(slope(lists[speed]) - lists[rate][0]) > OFF * largest:
            raise NotYet(f"the rules tell `{name}` for one moment alone, not how it goes on: not simulated yet")


def speeds_of(course: Course) -> Sequence[tuple[str, int, str]]:
    """The speeds that are told by others, with their places and the letters of their accelerations."""
    found = []
    accelerations = {tuple(letter.split(SEPARATOR)[:3]): letter for letter in course.letters if SEPARATOR in letter}
    own = {item.letter for item in course.variables}
    for letter, place in course.letters.items():
        word, *rest = letter.split(SEPARATOR)
        rate = accelerations.get((PAIRS.get(word, ""), *rest[:2]))
        if rate is not None and letter not in own:
            found.append((letter, place, rate))
    return found


def slope(series: Sequence[float]) -> float:
    return series[1] if len(series) > 1 else 0.0
