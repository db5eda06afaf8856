"""Separation of variables: the time and the way of a motion whose acceleration depends on the speed alone, or on the place alone.

dω/dt = α(ω) gives dt = dω/α and, since dθ = ω dt, dθ = ω dω/α; where α depends on the place, ω(θ) gives dt = dθ/ω.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from rotsolve.algebra.formula import Formula, Integral, Number, Symbol
from rotsolve.core.equation import KINEMATICS, Equation
from rotsolve.core.facts import signed, square
from rotsolve.core.passage import Passage, Travel
from rotsolve.core.writing import spoken

HALF, ONE = Number(Fraction(1, 2)), Number(Fraction(1))


def separation(passage: Passage, section: str) -> Iterator[Equation]:
    """The separated equations of every travel with whose rate or place the forces of its group vary."""
    for travel in passage.travels:
        if travel.leads and travel.pace == "rate" and isinstance(travel.moving, Symbol):
            yield from by_rate(travel, travel.moving.name, passage, section)
        elif travel.leads and travel.pace == "position" and isinstance(travel.coordinate, Symbol):
            yield from along_the_way(travel, travel.coordinate.name, passage, section)


def by_rate(travel: Travel, rate: str, passage: Passage, section: str) -> Iterator[Equation]:
    """t = ∫ dω/α and θ = ∫ ω dω/α from the first speed to the last."""
    limits = (rate, travel.before, travel.after)
    rate_letter, acceleration, place = LETTERS[travel.kind]
    words = f"separating the variables, dt = d{rate_letter}/{acceleration}"
    yield equation(passage.duration, Integral(ONE / travel.acceleration, *limits), words, travel, section)
    words = f"separating the variables, d{place} = {rate_letter} d{rate_letter}/{acceleration}"
    yield equation(travel.change, Integral(travel.moving / travel.acceleration, *limits), words, travel, section)


def along_the_way(travel: Travel, place: str, passage: Passage, section: str) -> Iterator[Equation]:
    """½ ω² − ½ ω₁² = ∫ α dθ up to any place, and t = ∫ dθ/ω."""
    assert travel.start is not None and travel.end is not None
    start, end = (signed(value, travel.sense) for value in (travel.start, travel.end))
    gained = HALF * square(travel.moving) - HALF * square(travel.before)
    pushed = Integral(signed(travel.acceleration, travel.sense), place, start, Symbol(place))
    rate, acceleration, letter = LETTERS[travel.kind]
    words = f"speed at any place, {rate} d{rate} = {acceleration} d{letter}"
    yield equation(gained, pushed, words, travel, section)
    slowness = ONE / signed(travel.moving, travel.sense)
    words = f"separating the variables, dt = d{letter}/{rate}"
    yield equation(passage.duration, Integral(slowness, place, start, end), words, travel, section)


LETTERS = {"turn": ("ω", "α", "θ"), "line": ("v", "a", "x")}


def equation(left: Formula, right: Formula, words: str, travel: Travel, section: str) -> Equation:
    label = f"{words}, {spoken(travel.body)}"
    return Equation(left, right, label, section, KINEMATICS, 3, bodies=(travel.body,))
