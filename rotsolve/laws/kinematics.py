"""Kinematics over a phase: constant acceleration, acceleration as a function of time, of the place, or of the speed alone."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from rotsolve.algebra.formula import ONE, Formula, Integral, Number, Symbol, add
from rotsolve.core.derivation import Words
from rotsolve.core.equation import KINEMATICS, NEWTON, Equation
from rotsolve.core.facts import signed, square
from rotsolve.core.passage import Passage, Travel
from rotsolve.core.registry import TIME
from rotsolve.core.writing import spoken

HALF, TWO = Number(Fraction(1, 2)), Number(Fraction(2))
LETTERS = {"turn": ("ω", "α", "θ"), "line": ("v", "a", "x")}
CHANGE = {"turn": "angle turned", "line": "displacement"}


def kinematics(passage: Passage, section: str) -> Iterator[Equation]:
    """The equations of motion of every coordinate, by how its acceleration varies."""
    for travel in passage.travels:
        if travel.given == 0:
            pass  # the change of a given coordinate is told by its values at both ends
        elif travel.pace == "constant":
            yield from constant(travel, passage, section)
        elif travel.pace == "time":
            yield from varying(travel, passage, section)
        elif travel.pace == "position":
            yield from by_place(travel, section)
        start, end = (None, None) if travel.told else (travel.start, travel.end)
        if start is not None and end is not None and end != add(start, travel.change):
            change = travel.arm * (end - start)
            words = CHANGE[travel.kind] if travel.arm == ONE else "way along the circle"
            yield equation(travel.change, change, words, travel, section, cost=1)
        if travel.running is not None:
            yield from at_any_time(travel, passage, section)
    if passage.times[0] != passage.times[1]:
        yield Equation(passage.duration, passage.times[1] - passage.times[0], "time elapsed", section, KINEMATICS, 1)


def equation(
    left: Formula,
    right: Formula,
    words: str,
    travel: Travel,
    section: str,
    family: str = KINEMATICS,
    cost: int = 2,
    remark: Words = (),
) -> Equation:
    return Equation(
        left, right, f"{words}, {spoken(travel.body)}", section, family, cost, remark, bodies=(travel.body,)
    )


def constant(travel: Travel, passage: Passage, section: str) -> Iterator[Equation]:
    """v₂ = v₁ + a t and its three companions."""
    before, after, rate, change, time = (
        travel.before,
        travel.after,
        travel.acceleration,
        travel.change,
        passage.duration,
    )
    words = "constant acceleration" if travel.kind == "line" else "constant angular acceleration"
    yield equation(after, before + rate * time, words, travel, section)
    yield equation(change, before * time + HALF * rate * square(time), words, travel, section, cost=3)
    yield equation(square(after), square(before) + TWO * rate * change, words, travel, section, cost=3)
    yield equation(
        change, HALF * (before + after) * time, words, travel, section, cost=3, remark=("mean velocity × time",)
    )


def varying(travel: Travel, passage: Passage, section: str) -> Iterator[Equation]:
    """v₂ = v₁ + ∫ a dt where the velocity is not given, and the change of the coordinate as ∫ v dt."""
    start, end = passage.times
    if travel.given != 1:
        words = "velocity from acceleration" if travel.kind == "line" else "angular velocity from angular acceleration"
        gained = Integral(travel.acceleration, TIME, start, end)
        yield equation(travel.after, travel.before + gained, words, travel, section)
        gained = Integral(travel.acceleration, TIME, start, Symbol(TIME))
        yield equation(travel.moving, travel.before + gained, f"{words}, at any time", travel, section)
    words = "displacement from velocity" if travel.kind == "line" else "angle turned from angular velocity"
    yield equation(travel.change, Integral(travel.moving, TIME, start, end), words, travel, section)


def at_any_time(travel: Travel, passage: Passage, section: str) -> Iterator[Equation]:
    """v(t) and the change of the coordinate up to any time, and what the coordinate is then."""
    start, now = passage.times[0], Symbol(TIME)
    change = travel.running
    assert change is not None
    if travel.pace == "constant" and travel.given != 0:
        words = "constant acceleration" if travel.kind == "line" else "constant angular acceleration"
        rate, passed = travel.acceleration, now - start
        words = f"{words}, at any time"
        yield equation(travel.moving, travel.before + rate * passed, words, travel, section, cost=3)
        way = travel.before * passed + HALF * rate * square(passed)
        yield equation(change, way, words, travel, section, cost=3)
    elif travel.pace == "time" and travel.given != 0:
        words = "displacement from velocity" if travel.kind == "line" else "angle turned from angular velocity"
        way = Integral(travel.moving, TIME, start, now)
        yield equation(change, way, f"{words}, at any time", travel, section)
    if travel.start is not None and travel.coordinate is not None:
        gained = travel.arm * (signed(travel.coordinate, travel.sense) - travel.start)
        yield equation(change, gained, f"{CHANGE[travel.kind]}, at any time", travel, section, cost=1)


def by_place(travel: Travel, section: str) -> Iterator[Equation]:
    """½ (v₂² − v₁²) = ∫ a dx, for an acceleration that depends on the place or angle alone (ω dω = α dθ)."""
    if travel.start is None or travel.end is None or not isinstance(travel.coordinate, Symbol):
        return
    gained = HALF * square(travel.after) - HALF * square(travel.before)
    start, end = (signed(angle, travel.sense) for angle in (travel.start, travel.end))
    integral = Integral(signed(travel.acceleration * travel.arm, travel.sense), travel.coordinate.name, start, end)
    if travel.given is not None:
        words = "ω dω = α dθ" if travel.kind == "turn" else "v dv = a dx"
        yield equation(gained, integral, words, travel, section)
    else:
        over = "angle" if travel.kind == "turn" else "way"
        yield equation(gained, integral, f"Newton's law summed over the {over}", travel, section, NEWTON, 5)


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
    yield equation(passage.duration, Integral(ONE / travel.acceleration, *limits), words, travel, section, cost=3)
    words = f"separating the variables, d{place} = {rate_letter} d{rate_letter}/{acceleration}"
    yield equation(
        travel.change, Integral(travel.moving / travel.acceleration, *limits), words, travel, section, cost=3
    )


def along_the_way(travel: Travel, place: str, passage: Passage, section: str) -> Iterator[Equation]:
    """½ ω² − ½ ω₁² = ∫ α dθ up to any place, and t = ∫ dθ/ω."""
    assert travel.start is not None and travel.end is not None
    start, end = (signed(value, travel.sense) for value in (travel.start, travel.end))
    gained = HALF * square(travel.moving) - HALF * square(travel.before)
    pushed = Integral(signed(travel.acceleration, travel.sense), place, start, Symbol(place))
    rate, acceleration, letter = LETTERS[travel.kind]
    words = f"speed at any place, {rate} d{rate} = {acceleration} d{letter}"
    yield equation(gained, pushed, words, travel, section, cost=3)
    slowness = ONE / signed(travel.moving, travel.sense)
    words = f"separating the variables, dt = d{letter}/{rate}"
    yield equation(passage.duration, Integral(slowness, place, start, end), words, travel, section, cost=3)
