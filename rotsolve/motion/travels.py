"""Travels: how each coordinate of a body runs through a phase, and the one place or rate with which the forces on tied bodies vary."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, Formula, Negative, Symbol, negate
from rotsolve.core.drive import TRAVELLING, TURNING, Drive
from rotsolve.core.facts import BodyFacts, Facts, signed
from rotsolve.core.passage import Travel
from rotsolve.core.quantity import PLANE
from rotsolve.core.symbols import CONSTANT, PLACES, POSITION, RATE, RATES, key_of, paths_in, running
from rotsolve.language.keys import varying_values

if TYPE_CHECKING:
    from rotsolve.motion.instant import Instant
    from rotsolve.motion.timeline import Interval


class Lead(Struct, frozen=True):
    """A place that runs through a phase: its letter, its values at both ends, and the rate at which it grows; whether it is one with
    which energy is `stored`."""

    body: str
    letter: Symbol
    start: Formula
    end: Formula
    rate: Formula
    stored: bool = False


def leading_place(group: frozenset[str], first: Instant, last: Instant, middle: Instant) -> Lead | None:
    """The place that the values acting on a group speak of; where there are several, the rules tell the others by it."""
    configuration, state = middle.configuration, middle.state
    acting = [item for item in configuration.acting(state) if any(ref.owner in group for ref in item.touches())]
    said = [path for item in acting for value in varying_values(item) for path in paths_in(value)]
    for word in PLACES:
        for _, owner, spoken in said:
            if spoken == word and middle.host(owner) in group:
                return led_by(middle.host(owner), word, first, last, middle)
    return None


def stored_place(group: frozenset[str], first: Facts, last: Facts, middle: Facts) -> Lead | None:
    """How far the one spring of a group is stretched, or how much of its rope hangs down: with that its pull, or its weight, varies."""
    owners = [stored.owner for stored in middle.potentials if group & set(stored.bodies)]
    ends = [{item.owner: item.elongation for item in facts.potentials} for facts in (first, last)]
    if len(owners) != 1 or not all(owners[0] in end for end in ends):
        return None
    stored = next(item for item in middle.potentials if item.owner == owners[0])
    running_ = [name for name in stored.elongation.symbols() if key_of(name).running]
    if len(running_) != 1 or stored.placed:
        return None
    letter = Symbol(running_[0])
    rest = simplify(stored.elongation - letter)
    if letter.name in rest.symbols():
        return None
    start, end = (simplify(side[stored.owner] - rest) for side in ends)
    return Lead(stored.bodies[-1], letter, start, end, stored.rate, stored=True)


def led_by(name: str, word: str, first: Instant, last: Instant, middle: Instant) -> Lead | None:
    """Angle, rotation or displacement of a body as the leading place."""
    letter = middle.variable(word, name)
    if not isinstance(letter, Symbol):
        return None
    start, end = (moment.variable(word, name) for moment in (first, last))
    motion = middle.motion(name)
    rate = middle.variable("velocity" if word == "displacement" else "angular_velocity", name)
    return Lead(name, letter, start, end, signed(rate, motion.sense) if word == "angle" else rate)


def leading_rate(group: frozenset[str], facts: Facts) -> str:
    """The letter of the rate with which the forces on a group vary; '' where there is none."""
    bodies = [body for body in facts.bodies if body.name in group]
    efforts = [force.size for body in bodies for force in body.forces]
    efforts += [couple.torque for body in bodies for couple in body.couples]
    spoken = {name for effort in efforts for name in effort.symbols()}
    for given in facts.given:
        if given.drive.body in group:
            spoken |= given.letters[given.drive.word].symbols()
    for rule in facts.rules:
        if not rule.linear and set(rule.bodies) & group:
            spoken |= rule.velocity[0].symbols() | rule.velocity[1].symbols()
    return next(iter(running(spoken, RATES)), "")


def relative_rate(rate: Formula, lead: Formula) -> Formula | int:
    """How fast something moves for each unit of the leading rate: ±1 for the leading body itself."""
    if rate == lead:
        return 1
    if rate == negate(lead) or (isinstance(lead, Negative) and lead.operand == rate):
        return -1
    return rate / lead


def travels_of(body: BodyFacts, interval: Interval, first: Instant, last: Instant, middle: Instant) -> Iterator[Travel]:
    """The coordinates of a body: along its line, and its turning."""
    pace = first.configuration.pace(body.name, interval.start)
    if body.motion.kind == "line":
        yield line_travel(body.name, interval, pace, first, last, middle)
    elif body.motion.kind == "plane":
        drives = {drive.component: drive for drive in first.configuration.drives(body.name, interval.start)}
        for axis in PLANE:
            if axis in drives or pace == CONSTANT:
                yield component_travel(body.name, axis, drives.get(axis), interval, first, last, middle)
    if body.motion.turns:
        yield turn_travel(body.name, interval, pace, first, last, middle)


def line_travel(name: str, interval: Interval, pace: str, first: Instant, last: Instant, middle: Instant) -> Travel:
    """The way of a body along its line."""
    words = first.line(name)
    label = words[1] if words else ""
    drives = [drive for drive in first.configuration.drives(name, interval.start) if drive.kinds == TRAVELLING]
    pace, given = (drives[0].pace, drives[0].order) if drives else (pace, None)
    places = [moment.travel("position", name, label) if given == 0 else None for moment in (first, last, middle)]
    before, after = (moment.travel("velocity", name, label) for moment in (first, last))
    moving = middle.travel("velocity", name, label)
    source = middle if pace != "constant" else first
    acceleration = source.travel("acceleration", name, label)
    initial = first.travel("acceleration", name, label)
    change = displacement(name, interval, first)
    running = so_far("displacement", name, middle) if first.configuration.mentions.runs else None
    ends = (places[0], places[1], places[2], initial)
    travel = Travel(
        name, "line", before, after, acceleration, change, pace, moving, *ends, given=given, running=running
    )
    orbits = [moment.orbit(name) for moment in (first, last, middle)]
    circle = orbits[0]
    if given == 0 or circle is None or circle.radius is None or any(orbit != circle for orbit in orbits):
        return travel
    start, end, midway = (moment.place_on(circle) for moment in (first, last, middle))
    start, end = (signed(angle, circle.way) for angle in (start, end))
    return replace(travel, start=start, end=end, coordinate=midway, sense=circle.way, arm=circle.radius)


def component_travel(
    name: str, axis: str, drive: Drive | None, interval: Interval, first: Instant, last: Instant, middle: Instant
) -> Travel:
    """One component of the way of a body that moves freely in the plane."""
    before, after, moving = (moment.component("velocity", name, axis) for moment in (first, last, middle))
    initial, later = (moment.component("acceleration", name, axis) for moment in (first, middle))
    pace, given = (drive.pace, drive.order) if drive is not None else (CONSTANT, None)
    acceleration = initial if pace == CONSTANT else later
    places = (
        [moment.component("position", name, axis) for moment in (first, last, middle)] if given == 0 else [None] * 3
    )
    change = displacement(name, interval, first, axis)
    running = so_far("displacement", name, middle, axis) if first.configuration.mentions.runs else None
    ends = (places[0], places[1], places[2], initial)
    return Travel(
        name, "line", before, after, acceleration, change, pace, moving, *ends, axis=axis, given=given, running=running
    )


def turn_travel(name: str, interval: Interval, pace: str, first: Instant, last: Instant, middle: Instant) -> Travel:
    """The turning of a body; where it is driven, the drive alone tells how its rate varies."""
    drives = [drive for drive in first.configuration.drives(name, interval.start) if drive.kinds == TURNING]
    pace = CONSTANT if first.configuration.carries_evenly(name, interval.start) else pace
    pace = drives[0].pace if drives else pace
    before, after, moving = (moment.rate("angular_velocity", name) for moment in (first, last, middle))
    source = middle if pace != "constant" else first
    acceleration = source.rate("angular_acceleration", name)
    angles = tuple(moment.angle(name) for moment in (first, last, middle))
    sense = first.sense(name)
    start, end = (None if angle is None else signed(angle, sense) for angle in angles[:2])
    change = rotation(name, interval, first)
    initial = first.rate("angular_acceleration", name)
    given = drives[0].order if drives else None
    running = so_far("rotation", name, middle) if first.configuration.mentions.runs else None
    ends = (start, end, angles[2], initial)
    return Travel(
        name, "turn", before, after, acceleration, change, pace, moving, *ends, sense, given=given, running=running
    )


def led(travel: Travel, lead: Lead | None, rates: set[str]) -> Travel:
    """A travel whose coordinate or rate is the one with which the forces vary."""
    if isinstance(travel.moving, Symbol) and travel.pace == RATE and travel.moving.name in rates:
        return replace(travel, leads=True)
    if travel.arm != ONE or lead is None or travel.pace != POSITION:
        return travel  # on a circle its weight varies with the place there
    if lead.rate not in (travel.moving, negate(travel.moving)):
        return travel
    sense = 1 if lead.rate == travel.moving else -1
    start, end = signed(lead.start, sense), signed(lead.end, sense)
    told = travel.start is None and lead.stored
    return replace(travel, coordinate=lead.letter, start=start, end=end, sense=sense, leads=True, told=told)


def displacement(name: str, interval: Interval, instant: Instant, component: str = "") -> Formula:
    """Displacement of a body along its line in a phase, counted along its positive sense; or a component of it."""
    words = ways(name, instant, component)
    return instant.ask("displacement", name, when=interval.name, words=words, component=component)


def ways(name: str, instant: Instant, component: str) -> tuple[str, str]:
    """The words for the two senses in which a body travels."""
    if component:
        return ("right", "left") if component == "x" else ("up", "down")
    return instant.line_words(name)


def rotation(name: str, interval: Interval, instant: Instant) -> Formula:
    """Angle that a body turns through in a phase, counted along its positive sense."""
    return instant.ask("rotation", name, when=interval.name, words=instant.turn_words(name))


def so_far(word: str, name: str, middle: Instant, component: str = "") -> Formula:
    """Displacement or rotation of a body from the start of a phase up to any moment in it."""
    words = ways(name, middle, component) if word == "displacement" else middle.turn_words(name)
    return middle.ask(word, name, words=words, component=component, letter="phi" if word == "rotation" else "s")


def way_gone(owner: str, interval: Interval, instant: Instant) -> Formula:
    """Displacement of a body, which may be part of another, along its own positive sense in a phase."""
    return instant.as_travelled(displacement(instant.host(owner), interval, instant), owner)


def angle_turned(owner: str, interval: Interval, instant: Instant) -> Formula:
    """Angle through which a body turns in a phase, or the last body of a connection against its first."""
    item = next((item for item in instant.configuration.connections(interval.start) if item.name == owner), None)
    if item is None or not item.between():
        return instant.as_counted(rotation(instant.host(owner), interval, instant), owner)
    first, last = (ref.owner for ref in item.between())
    turned, carried = (
        instant.as_counted(rotation(instant.host(name), interval, instant), name) for name in (last, first)
    )
    return turned - signed(carried, instant.sense(first) * instant.sense(last))
