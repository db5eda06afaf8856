"""Kinematics over a phase: constant acceleration, acceleration as a function of time, of the place, or of the speed alone."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import HALF, ONE, Integral, Number, Symbol, add
from rotsolve.core.equation import (
    BY_PLACE,
    COORDINATE,
    IN_TIME,
    SEPARATED_BY_PLACE,
    SEPARATED_BY_RATE,
    SPEED_AT_PLACE,
    STEADY_TRAVEL,
    STEADY_TURN,
    SUMMED_OVER_WAY,
    TIME_ELAPSED,
    TRAVEL_AT_ANY_TIME,
    TRAVEL_BY_MEAN,
    TURN_AT_ANY_TIME,
    TURN_BY_MEAN,
    Equation,
)
from rotsolve.core.facts import signed, square
from rotsolve.core.passage import Passage, Travel
from rotsolve.core.symbols import TIME
from rotsolve.laws.table import OverPhase

TWO = Number(Fraction(2))
LETTERS = {"turn": ("ω", "α", "θ"), "line": ("v", "a", "x")}
CHANGE = {"turn": "angle turned", "line": "displacement"}


def motion_over_phase(over: OverPhase) -> Iterator[Equation]:
    """The equations of motion of every coordinate, by how its acceleration varies."""
    passage, section = over.passage, over.section
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
            yield COORDINATE.equation(travel.change, change, section, (travel.body,), words=words)
        if travel.running is not None:
            yield from travel_at_any_time(travel, passage, section)
    if passage.times[0] != passage.times[1] and not is_zero(passage.times[1] - passage.times[0] - passage.duration):
        yield TIME_ELAPSED.equation(passage.duration, passage.times[1] - passage.times[0], section)


def constant(travel: Travel, passage: Passage, section: str) -> Iterator[Equation]:
    """v₂ = v₁ + a t and its three companions."""
    before, after, rate = travel.before, travel.after, travel.acceleration
    change, time = travel.change, passage.duration
    law, mean = (STEADY_TRAVEL, TRAVEL_BY_MEAN) if travel.kind == "line" else (STEADY_TURN, TURN_BY_MEAN)
    bodies = (travel.body,)
    yield law.equation(after, before + rate * time, section, bodies)
    yield law.equation(change, before * time + HALF * rate * square(time), section, bodies, cost=3)
    yield law.equation(square(after), square(before) + TWO * rate * change, section, bodies, cost=3)
    yield mean.equation(change, HALF * (before + after) * time, section, bodies, ("mean velocity × time",))


def varying(travel: Travel, passage: Passage, section: str) -> Iterator[Equation]:
    """v₂ = v₁ + ∫ a dt where the velocity is not given, and the change of the coordinate as ∫ v dt."""
    bodies, (start, end) = (travel.body,), passage.times
    if travel.given != 1:
        words = "velocity from acceleration" if travel.kind == "line" else "angular velocity from angular acceleration"
        gained = Integral(travel.acceleration, TIME, start, end)
        yield IN_TIME.equation(travel.after, travel.before + gained, section, bodies, words=words)
        gained = Integral(travel.acceleration, TIME, start, Symbol(TIME))
        yield IN_TIME.equation(travel.moving, travel.before + gained, section, bodies, words=f"{words}, at any time")
    words = "displacement from velocity" if travel.kind == "line" else "angle turned from angular velocity"
    yield IN_TIME.equation(travel.change, Integral(travel.moving, TIME, start, end), section, bodies, words=words)


def travel_at_any_time(travel: Travel, passage: Passage, section: str) -> Iterator[Equation]:
    """v(t) and the change of the coordinate up to any time, and what the coordinate is then."""
    start, now = passage.times[0], Symbol(TIME)
    change, bodies = travel.running, (travel.body,)
    assert change is not None
    if travel.pace == "constant" and travel.given != 0:
        law = TRAVEL_AT_ANY_TIME if travel.kind == "line" else TURN_AT_ANY_TIME
        rate, passed = travel.acceleration, now - start
        yield law.equation(travel.moving, travel.before + rate * passed, section, bodies)
        way = travel.before * passed + HALF * rate * square(passed)
        yield law.equation(change, way, section, bodies)
    elif travel.pace == "time" and travel.given != 0:
        words = "displacement from velocity" if travel.kind == "line" else "angle turned from angular velocity"
        way = Integral(travel.moving, TIME, start, now)
        yield IN_TIME.equation(change, way, section, bodies, words=f"{words}, at any time")
    if travel.start is not None and travel.coordinate is not None:
        gained = travel.arm * (signed(travel.coordinate, travel.sense) - travel.start)
        words = f"{CHANGE[travel.kind]}, at any time"
        yield COORDINATE.equation(change, gained, section, bodies, words=words)


def by_place(travel: Travel, section: str) -> Iterator[Equation]:
    """½ (v₂² − v₁²) = ∫ a dx, for an acceleration that depends on the place or angle alone (ω dω = α dθ)."""
    if travel.start is None or travel.end is None or not isinstance(travel.coordinate, Symbol):
        return
    gained = HALF * square(travel.after) - HALF * square(travel.before)
    start, end = (signed(angle, travel.sense) for angle in (travel.start, travel.end))
    integral = Integral(signed(travel.acceleration * travel.arm, travel.sense), travel.coordinate.name, start, end)
    if travel.given is not None:
        words = "ω dω = α dθ" if travel.kind == "turn" else "v dv = a dx"
        yield BY_PLACE.equation(gained, integral, section, (travel.body,), words=words)
    else:
        over = "angle" if travel.kind == "turn" else "way"
        yield SUMMED_OVER_WAY.equation(gained, integral, section, (travel.body,), over=over)


def separated(over: OverPhase) -> Iterator[Equation]:
    """The separated equations of every travel with whose rate or place the forces of its group vary."""
    for travel in over.passage.travels:
        if travel.leads and travel.pace == "rate" and isinstance(travel.moving, Symbol):
            yield from by_rate(travel, travel.moving.name, over.passage, over.section)
        elif travel.leads and travel.pace == "position" and isinstance(travel.coordinate, Symbol):
            yield from along_the_way(travel, travel.coordinate.name, over.passage, over.section)


def by_rate(travel: Travel, rate: str, passage: Passage, section: str) -> Iterator[Equation]:
    """t = ∫ dω/α and θ = ∫ ω dω/α from the first speed to the last."""
    limits = (rate, travel.before, travel.after)
    rate_letter, acceleration, place = LETTERS[travel.kind]
    time, way = (Integral(top / travel.acceleration, *limits) for top in (ONE, travel.moving))
    words = f"dt = d{rate_letter}/{acceleration}"
    yield SEPARATED_BY_RATE.equation(passage.duration, time, section, (travel.body,), words=words)
    words = f"d{place} = {rate_letter} d{rate_letter}/{acceleration}"
    yield SEPARATED_BY_RATE.equation(travel.change, way, section, (travel.body,), words=words)


def along_the_way(travel: Travel, place: str, passage: Passage, section: str) -> Iterator[Equation]:
    """½ ω² − ½ ω₁² = ∫ α dθ up to any place, and t = ∫ dθ/ω."""
    assert travel.start is not None and travel.end is not None
    start, end = (signed(value, travel.sense) for value in (travel.start, travel.end))
    gained = HALF * square(travel.moving) - HALF * square(travel.before)
    pushed = Integral(signed(travel.acceleration, travel.sense), place, start, Symbol(place))
    rate, acceleration, letter = LETTERS[travel.kind]
    words = f"{rate} d{rate} = {acceleration} d{letter}"
    yield SPEED_AT_PLACE.equation(gained, pushed, section, (travel.body,), words=words)
    time = Integral(ONE / signed(travel.moving, travel.sense), place, start, end)
    yield SEPARATED_BY_PLACE.equation(passage.duration, time, section, (travel.body,), words=f"dt = d{letter}/{rate}")
