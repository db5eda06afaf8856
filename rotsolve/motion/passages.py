"""Passages: what happened in a phase: displacements, angles turned, work, heights and times, ready for the laws."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Integral, Symbol, negate, total
from rotsolve.core.directions import opposite
from rotsolve.core.drive import TRAVELLING, TURNING, Drive
from rotsolve.core.facts import BodyFacts, Facts, signed
from rotsolve.core.heading import UP, Vector, heading
from rotsolve.core.passage import Passage, Travel, Work
from rotsolve.core.registry import SEPARATOR, TIME
from rotsolve.core.varying import CONSTANT, POSITION, RATE, RATES, UNKNOWN, at_any_time, running
from rotsolve.elements.connections import Hinge
from rotsolve.elements.connections.connection import Orbit
from rotsolve.elements.connections.contacts.touch import Touch
from rotsolve.motion.arrangement import Arrangement
from rotsolve.motion.instant import Instant
from rotsolve.motion.leading import Lead, leading_place, leading_rate, place_of, share, stored_place
from rotsolve.motion.timeline import Interval
from rotsolve.scene.model import PointRef


def passage(
    interval: Interval, start: tuple[Instant, Facts], end: tuple[Instant, Facts], midst: tuple[Instant, Facts]
) -> Passage:
    """All that the laws read about one phase."""
    (first, start_facts), (last, end_facts), (middle, midst_facts) = start, end, midst
    arrangement = first.arrangement
    times = (first.time(), last.time())
    duration = first.ask("time", "", when=interval.name) if times[0] != ZERO else times[1]
    groups = groups_of(arrangement, midst_facts, interval.start)
    leads = {
        name: leading_place(group, first, last, middle) or stored_place(group, start_facts, end_facts, midst_facts)
        for group in groups
        for name in group
    }
    rates = {leading_rate(group, midst_facts) for group in groups}
    travels = tuple(
        led(travel, leads[body.name], rates)
        for body in midst_facts.bodies
        for travel in travels_of(body, interval, first, last, middle)
    )
    works = [
        work
        for body in midst_facts.bodies
        for work in works_on(body, interval, first, last, middle, duration, leads[body.name])
    ]
    works += inner_works(midst_facts, interval, first)
    heights = {body.name: height_pair(body.name, interval, first, last) for body in midst_facts.bodies}
    idle = tuple(words for group in groups for words in reasons(midst_facts, group))
    return Passage(
        interval.name,
        start_facts,
        end_facts,
        midst_facts,
        travels,
        summed(works, groups),
        heights,
        duration,
        times,
        groups,
        idle,
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
    return replace(
        travel,
        coordinate=lead.letter,
        start=start,
        end=end,
        sense=sense,
        leads=True,
        told=travel.start is None and lead.stored,
    )


def groups_of(arrangement: Arrangement, facts: Facts, state: str) -> tuple[frozenset[str], ...]:
    """Bodies that move together, group by group."""
    groups: dict[frozenset[str], None] = {}
    for body in facts.bodies:
        groups[arrangement.component(body.name, state)] = None
    return tuple(groups)


def displacement(name: str, interval: Interval, instant: Instant, component: str = "") -> Formula:
    """Displacement of a body along its line in a phase, counted along its positive sense; or a component of it."""
    return instant.ask(
        "displacement", name, when=interval.name, words=ways(name, instant, component), component=component
    )


def ways(name: str, instant: Instant, component: str) -> tuple[str, str]:
    """The words for the two senses in which a body travels."""
    if component:
        return ("right", "left") if component == "x" else ("up", "down")
    line = instant.line(name)
    return (line[1], opposite(line[1])) if line else ("", "")


def rotation(name: str, interval: Interval, instant: Instant) -> Formula:
    """Angle that a body turns through in a phase, counted along its positive sense."""
    return instant.ask("rotation", name, when=interval.name, words=instant.turn_words(name))


def so_far(word: str, name: str, middle: Instant, component: str = "") -> Formula:
    """Displacement or rotation of a body from the start of a phase up to any moment in it."""
    words = ways(name, middle, component) if word == "displacement" else middle.turn_words(name)
    return middle.ask(word, name, words=words, component=component, letter="phi" if word == "rotation" else "s")


def angle_turned(owner: str, interval: Interval, instant: Instant) -> Formula:
    """Angle through which a body turns in a phase, or the last body of a connection against its first."""
    item = next((item for item in instant.arrangement.connections(interval.start) if item.name == owner), None)
    if item is None or not item.between():
        return rotation(instant.host(owner), interval, instant)
    first, last = (instant.host(ref.owner) for ref in item.between())
    way = instant.sense(first) * instant.sense(last)
    return rotation(last, interval, instant) - signed(rotation(first, interval, instant), way)


def travels_of(body: BodyFacts, interval: Interval, first: Instant, last: Instant, middle: Instant) -> Iterator[Travel]:
    """The coordinates of a body: along its line, and its turning."""
    pace = first.arrangement.pace(body.name, interval.start)
    if body.motion.kind == "line":
        yield line_travel(body.name, interval, pace, first, last, middle)
    elif body.motion.kind == "plane":
        for drive in first.arrangement.drives(body.name, interval.start):
            if drive.component:
                yield component_travel(drive, interval, first, last, middle)
    if body.motion.turns:
        yield turn_travel(body.name, interval, pace, first, last, middle)


def line_travel(name: str, interval: Interval, pace: str, first: Instant, last: Instant, middle: Instant) -> Travel:
    """The way of a body along its line."""
    words = first.line(name)
    label = words[1] if words else ""
    drives = [drive for drive in first.arrangement.drives(name, interval.start) if drive.words == TRAVELLING]
    pace, given = (drives[0].pace, drives[0].order) if drives else (pace, None)
    places = [moment.travel("position", name, label) if given == 0 else None for moment in (first, last, middle)]
    before, after = (moment.travel("velocity", name, label) for moment in (first, last))
    moving = middle.travel("velocity", name, label)
    source = middle if pace != "constant" else first
    acceleration = source.travel("acceleration", name, label)
    initial = first.travel("acceleration", name, label)
    change = displacement(name, interval, first)
    running = so_far("displacement", name, middle) if first.arrangement.runs else None
    ends = (places[0], places[1], places[2])
    travel = Travel(
        name, "line", before, after, acceleration, change, pace, moving, *ends, initial, 1, "", given, running
    )
    orbits = [moment.orbit(name) for moment in (first, last, middle)]
    circle = orbits[0]
    if given == 0 or circle is None or circle.radius is None or any(orbit != circle for orbit in orbits):
        return travel
    start, end, midway = (moment.place_on(circle) for moment in (first, last, middle))
    start, end = (signed(angle, circle.way) for angle in (start, end))
    return replace(travel, start=start, end=end, coordinate=midway, sense=circle.way, arm=circle.radius)


def component_travel(drive: Drive, interval: Interval, first: Instant, last: Instant, middle: Instant) -> Travel:
    """One component of the way of a body that is moved freely in the plane."""
    name, axis = drive.body, drive.component
    before, after, moving = (moment.component("velocity", name, axis) for moment in (first, last, middle))
    initial, later = (moment.component("acceleration", name, axis) for moment in (first, middle))
    acceleration = initial if drive.pace == "constant" else later
    places = [moment.component("position", name, axis) for moment in (first, last, middle)]
    change = displacement(name, interval, first, axis)
    running = so_far("displacement", name, middle, axis) if first.arrangement.runs else None
    ends = (places[0], places[1], places[2])
    return Travel(
        name,
        "line",
        before,
        after,
        acceleration,
        change,
        drive.pace,
        moving,
        *ends,
        initial,
        axis=axis,
        given=drive.order,
        running=running,
    )


def turn_travel(name: str, interval: Interval, pace: str, first: Instant, last: Instant, middle: Instant) -> Travel:
    """The turning of a body; where it is driven, the drive alone tells how its rate varies."""
    drives = [drive for drive in first.arrangement.drives(name, interval.start) if drive.words == TURNING]
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
    running = so_far("rotation", name, middle) if first.arrangement.runs else None
    ends = (start, end, angles[2])
    return Travel(
        name,
        "turn",
        before,
        after,
        acceleration,
        change,
        pace,
        moving,
        *ends,
        initial,
        sense,
        "",
        given,
        running,
    )


def height_pair(name: str, interval: Interval, first: Instant, last: Instant) -> tuple[Formula, Formula] | None:
    """Heights of a body's reference point at both ends of a phase, from a level that stays; None where geometry does not tell."""
    if not first.arrangement.heavy:
        return (ZERO, ZERO)
    line = first.line(name)
    straight = first.motion(name).kind == "line" and first.orbit(name) is None and not first.arrangement.laid(name)
    if straight and line is not None:
        rise = line[0].sin()
        return (ZERO, displacement(name, interval, first) * rise if rise != ZERO else ZERO)
    before, after = height(name, first), height(name, last)
    return None if before is None or after is None else (before, after)


def height(name: str, instant: Instant) -> Formula | None:
    """Height of the reference point above a fixed level: of a pivot 0, of a centre of mass by what the body touches or hangs from."""
    arrangement = instant.arrangement
    if arrangement.pivot(name, instant.state) is not None:
        return ZERO
    orbit = instant.orbit(name)
    if orbit is not None:
        return height_on(orbit, name, instant)
    for item in arrangement.connections(instant.state):
        if isinstance(item, Touch):
            ref, surface = item.pair()[0], arrangement.surfaces.get(item.pair()[1].owner)
            if ref.owner == name and surface is not None and surface.word == "level":
                return negate(item.arm(instant).along(UP))
        if isinstance(item, Hinge) and len(item.hinge) == 2 and item.hinge[1].owner == name:
            carrier, own = item.hinge
            base = height_of_point(carrier, instant)
            return None if base is None else base - instant.point(own).along(UP)
    return None


def height_on(orbit: Orbit, name: str, instant: Instant) -> Formula:
    """Height of a body's centre on its circle, ρ sin φ above that of the circle; a letter of its own on a track of unknown profile."""
    if orbit.radius is None:
        return instant.ask("height", name)
    rise = heading(instant.place_on(orbit)).sin()
    return simplify(orbit.level + orbit.radius * rise, order=instant.arrangement.order)


def height_of_point(ref: PointRef, instant: Instant) -> Formula | None:
    """Height of a point of a body above the same fixed level."""
    name = instant.host(ref.owner)
    reference = height(name, instant)
    return None if reference is None else reference + instant.point(ref).along(UP)


def works_on(
    body: BodyFacts,
    interval: Interval,
    first: Instant,
    last: Instant,
    middle: Instant,
    duration: Formula,
    lead: Lead | None,
) -> Iterator[Work]:
    """Work of the forces and couples on a body that are neither weights, springs nor ideal connections."""
    name = body.name
    way = Way(interval, first, last, middle, lead)
    for force in body.forces:
        if force.internal or not force.works or force.role in ("weight", "spring", "hanging"):
            continue
        yield named_work(force.owner, work_of_force(force.vector, force.arm, body, way), (name,), interval, first)
    for couple in body.couples:
        if couple.role == "power":
            power = power_of(couple.owner, middle)
            amount = Integral(power, TIME, first.time(), last.time()) if power.symbols() & {TIME} else power * duration
            yield named_work(couple.owner, None if running(power.symbols()) else amount, (name,), interval, first)
        elif not couple.internal and couple.role not in ("torsion", "inner"):
            turned = signed(rotation(name, interval, first), first.sense(name))
            told = way.work(couple.torque, turned, body.motion.spin, name)
            yield named_work(couple.owner, told, (name,), interval, first)


def summed(works: Sequence[Work], groups: Sequence[frozenset[str]]) -> tuple[Work, ...]:
    """The works with those added up that stand for one letter: what acts on several bodies of a group works on each."""
    result: list[Work] = []
    for work in works:
        place = next((place for place, other in enumerate(result) if shared(work, other, groups)), None)
        if place is None:
            result.append(work)
            continue
        other = result[place]
        known = other.spelled is not None and work.spelled is not None
        spelled = (other.spelled or ZERO) + (work.spelled or ZERO) if known else None
        result[place] = replace(other, bodies=(*other.bodies, *work.bodies), spelled=spelled)
    return tuple(result)


def shared(one: Work, other: Work, groups: Sequence[frozenset[str]]) -> bool:
    """Whether two works go by one letter and belong to one group of bodies."""
    if one.owner != other.owner or one.amount != other.amount or not (lettered(one) and lettered(other)):
        return False
    return any({*one.bodies, *other.bodies} <= group for group in groups)


def lettered(work: Work) -> bool:
    """Whether a work goes by its own letter: asked for, or told by energy alone."""
    own = isinstance(work.amount, Symbol) and work.amount.name.startswith(f"work{SEPARATOR}")
    return not work.inner and (own or work.spelled is not None)


def inner_works(facts: Facts, interval: Interval, first: Instant) -> Iterator[Work]:
    """Works of inner forces that nothing is said of: of what turns one body on another, of what draws riders or arms in."""
    connections = first.arrangement.connections(interval.start)
    for item in connections:
        if item.between() and item.pace(first.arrangement, interval.start) == UNKNOWN:
            bodies = tuple(first.host(ref.owner) for ref in item.between())
            yield Work(item.name, first.ask("work", item.name, when=interval.name), item.name, bodies, inner=True)
    drawn = {item.rides[0].owner: item.name for item in first.arrangement.rides(interval.start) if not item.free}
    for body in facts.bodies:
        members = [member.name for member in first.arrangement.cluster(body.name, interval.start)]
        for name in (body.name, *members):
            owner = drawn.get(name, name)
            own = name in drawn or (name == body.name and not first.arrangement.laid(name))
            if own and first.arrangement.altered(name, interval.start, interval.end):
                yield Work(owner, first.ask("work", owner, when=interval.name), owner, (body.name,), inner=True)


def power_of(owner: str, instant: Instant) -> Formula:
    """The power of a motor."""
    item = next(item for item in instant.arrangement.actions(instant.state) if item.name == owner)
    return item.now(instant)


def named_work(owner: str, amount: Formula | None, bodies: tuple[str, ...], interval: Interval, first: Instant) -> Work:
    """The work under its own letter where the scene asks for it or fixes it, or where only energy tells it; else spelled out."""
    if amount is None or first.arrangement.asks(owner, "work") or first.arrangement.asks(owner, "power"):
        letter = first.ask("work", owner, when=interval.name)
        return Work(owner, letter, owner, bodies, amount)
    return Work(owner, amount, owner, bodies)


def work_of_force(vector: Vector, arm: Vector, body: BodyFacts, way: Way) -> Formula | None:
    """F · displacement along a line plus r × F times the angle turned; None where a part is not told."""
    name, motion = body.name, body.motion
    parts: list[Formula | None] = []
    if motion.bend is not None and motion.heading is not None:
        parts.append(way.work_round(vector.along(motion.heading), motion.velocity.along(motion.heading), name))
    elif motion.kind == "line" and motion.heading is not None:
        speed = motion.velocity.along(motion.heading)
        parts.append(way.work(vector.along(motion.heading), displacement(name, way.interval, way.first), speed, name))
    torque = arm.cross(vector)
    if motion.turns and torque != ZERO:
        turned = signed(rotation(name, way.interval, way.first), way.first.sense(name))
        parts.append(way.work(torque, turned, motion.spin, name))
    told = [part for part in parts if part is not None]
    return total(told) if len(told) == len(parts) else None


@dataclass(frozen=True)
class Way:
    """A phase as works are summed over it."""

    interval: Interval
    first: Instant
    last: Instant
    middle: Instant
    lead: Lead | None

    def work(self, effort: Formula, change: Formula, rate: Formula, name: str) -> Formula | None:
        """effort · change; ∫ effort · rate dt where the effort varies in time, ∫ effort dx where it varies with the place, and
        None where it varies with the speed, or in a way not told: then energy tells the work."""
        letters = effort.symbols()
        if not running(letters):
            pace = self.first.arrangement.pace(name, self.interval.start) if at_any_time(letters) else CONSTANT
            if TIME in letters or pace == TIME:
                return Integral(effort * rate, TIME, self.first.time(), self.last.time())
            return effort * change if pace == CONSTANT else None
        if TIME in letters:
            return Integral(effort * rate, TIME, self.first.time(), self.last.time())
        if running(letters, RATES):
            return None
        lead = self.lead if self.lead is not None else place_of(name, "angle", self.first, self.last, self.middle)
        if lead is None:
            return None
        return Integral(effort * share(rate, lead.rate), lead.letter.name, lead.start, lead.end)

    def work_round(self, along: Formula, speed: Formula, name: str) -> Formula | None:
        """∫ F ρ dφ of the force along a circle that varies with the place on it alone; else as along a line."""
        circle = self.middle.orbit(name)
        midway = self.middle.place_on(circle).symbols() if circle is not None else frozenset[str]()
        letters = along.symbols()
        if circle is None or circle.radius is None or TIME in letters or not letters & midway:
            return self.work(along, displacement(name, self.interval, self.first), speed, name)
        if set(running(letters)) - midway:
            return None
        ends = (moment.place_on(circle) for moment in (self.first, self.last))
        return Integral(signed(along * circle.radius, circle.way), next(iter(midway)), *ends)


def reasons(facts: Facts, group: frozenset[str]) -> Iterator[str]:
    """Why mechanical energy is conserved, in a sentence about the forces that do no work."""
    roles = {force.role for body in facts.bodies if body.name in group for force in body.forces}
    held = any(body.motion.kind == "axis" for body in facts.bodies if body.name in group)
    parts = []
    if any(body.sliding for body in facts.bodies if body.name in group):
        parts.append("there is no friction where the one slides along the other")
    if "reaction" in roles and held:
        axles = any(
            str(force.words[0]).startswith("axle")
            for body in facts.bodies
            if body.name in group
            for force in body.forces
        )
        parts.append(
            "the axle does no work (it is at rest)" if axles else "the pivot does no work (its point is at rest)"
        )
    if any(body.lays for body in facts.bodies if body.name in group):
        parts.append(
            "what is laid down comes to rest without a jolt (the mass still rolled up is as its radius squared)"
        )
    if "tension" in roles:
        parts.append("the string's tension gives one body what it takes from the other")
    if "friction" in roles:
        parts.append("friction does no work (the point of contact is at rest)")
    elif "normal" in roles:
        parts.append("the normal force does no work (it is perpendicular to the motion)")
    if parts:
        yield "Energy is conserved: " + "; ".join(parts)
