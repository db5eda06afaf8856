"""Passages: what happened in a phase: displacements, angles turned, work, heights and times, ready for the laws."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, Integral, negate
from rotsolve.core.directions import opposite
from rotsolve.core.facts import BodyFacts, Facts, signed
from rotsolve.core.heading import RIGHT, UP, Vector, heading
from rotsolve.core.passage import Passage, Travel, Work
from rotsolve.elements.connections import Contact, Hinge
from rotsolve.elements.connections.connection import Orbit
from rotsolve.motion.arrangement import Arrangement
from rotsolve.motion.instant import Instant
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
    travels = tuple(travel for body in midst_facts.bodies for travel in travels_of(body, interval, first, last, middle))
    groups = groups_of(arrangement, midst_facts, interval.start)
    works = [work for body in midst_facts.bodies for work in works_on(body, interval, first, last, middle, duration)]
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


def groups_of(arrangement: Arrangement, facts: Facts, state: str) -> tuple[frozenset[str], ...]:
    """Bodies that move together, group by group."""
    groups: dict[frozenset[str], None] = {}
    for body in facts.bodies:
        groups[arrangement.component(body.name, state)] = None
    return tuple(groups)


def displacement(name: str, interval: Interval, instant: Instant) -> Formula:
    """Displacement of a body along its line in a phase, counted along its positive sense."""
    line = instant.line(name)
    words = (line[1], opposite(line[1])) if line else ("", "")
    return instant.ask("displacement", name, when=interval.name, words=words)


def rotation(name: str, interval: Interval, instant: Instant) -> Formula:
    """Angle that a body turns through in a phase, counted along its positive sense."""
    return instant.ask("rotation", name, when=interval.name, words=instant.turn_words(name))


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
    if body.motion.turns:
        yield turn_travel(body.name, interval, pace, first, last, middle)


def line_travel(name: str, interval: Interval, pace: str, first: Instant, last: Instant, middle: Instant) -> Travel:
    """The way of a body along its line."""
    words = first.line(name)
    label = words[1] if words else ""
    before, after = (moment.travel("velocity", name, label) for moment in (first, last))
    moving = middle.travel("velocity", name, label)
    source = middle if pace != "constant" else first
    acceleration = source.travel("acceleration", name, label)
    initial = first.travel("acceleration", name, label)
    change = displacement(name, interval, first)
    travel = Travel(name, "line", before, after, acceleration, change, pace, moving, initial=initial)
    orbits = [moment.orbit(name) for moment in (first, last, middle)]
    circle = orbits[0]
    if circle is None or circle.radius is None or any(orbit != circle for orbit in orbits):
        return travel
    start, end, midway = (moment.place_on(circle) for moment in (first, last, middle))
    start, end = (signed(angle, circle.way) for angle in (start, end))
    return replace(travel, start=start, end=end, coordinate=midway, sense=circle.way, arm=circle.radius)


def turn_travel(name: str, interval: Interval, pace: str, first: Instant, last: Instant, middle: Instant) -> Travel:
    """The turning of a body."""
    before, after, moving = (moment.rate("angular_velocity", name) for moment in (first, last, middle))
    source = middle if pace != "constant" else first
    acceleration = source.rate("angular_acceleration", name)
    angles = tuple(moment.angle(name) for moment in (first, last, middle))
    sense = first.sense(name)
    start, end = (None if angle is None else signed(angle, sense) for angle in angles[:2])
    change = rotation(name, interval, first)
    initial = first.rate("angular_acceleration", name)
    return Travel(
        name, "turn", before, after, acceleration, change, pace, moving, start, end, angles[2], initial, sense
    )


def height_pair(name: str, interval: Interval, first: Instant, last: Instant) -> tuple[Formula, Formula] | None:
    """Heights of a body's reference point at both ends of a phase, from a level that stays; None where geometry does not tell."""
    if not first.arrangement.heavy:
        return (ZERO, ZERO)
    line = first.line(name)
    if first.orbit(name) is None and first.motion(name).kind == "line" and line is not None:
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
        if isinstance(item, Contact):
            ref, surface = item.contact[0], arrangement.surfaces.get(item.contact[1].owner)
            if ref.owner == name and surface is not None and surface.word == "level":
                return negate(instant.point(ref).along(UP))
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
    body: BodyFacts, interval: Interval, first: Instant, last: Instant, middle: Instant, duration: Formula
) -> Iterator[Work]:
    """Work of the forces and couples on a body that are neither weights, springs nor ideal connections."""
    name = body.name
    for force in body.forces:
        if force.internal or not force.works or force.role in ("weight", "spring", "hanging"):
            continue
        amount = work_of_force(force.vector, force.arm, body, interval, first, last, middle)
        yield named_work(force.owner, amount, (name,), interval, first)
    for couple in body.couples:
        if couple.role == "power":
            yield named_work(couple.owner, power_of(couple.owner, first) * duration, (name,), interval, first)
        elif not couple.internal and couple.role not in ("torsion", "inner"):
            turned = signed(rotation(name, interval, first), first.sense(name))
            amount = work_over(couple.torque, turned, body.motion.spin, middle, interval, first, last)
            yield named_work(couple.owner, amount, (name,), interval, first)


def summed(works: Sequence[Work], groups: Sequence[frozenset[str]]) -> tuple[Work, ...]:
    """The works with those added up that stand for one letter: what acts on several bodies of a group works on each."""
    result: list[Work] = []
    for work in works:
        place = next((place for place, other in enumerate(result) if shared(work, other, groups)), None)
        if place is None:
            result.append(work)
            continue
        other = result[place]
        spelled = (other.spelled or ZERO) + (work.spelled or ZERO)
        result[place] = replace(other, bodies=(*other.bodies, *work.bodies), spelled=spelled)
    return tuple(result)


def shared(one: Work, other: Work, groups: Sequence[frozenset[str]]) -> bool:
    """Whether two works go by one letter and belong to one group of bodies."""
    if one.spelled is None or other.spelled is None or one.amount != other.amount:
        return False
    return any({*one.bodies, *other.bodies} <= group for group in groups)


def inner_works(facts: Facts, interval: Interval, first: Instant) -> Iterator[Work]:
    """Works of inner forces that nothing is said of: of what turns one body on another, of what draws riders or arms in."""
    connections = first.arrangement.connections(interval.start)
    for item in connections:
        if item.between() and item.pace(first.arrangement, interval.start) == "unknown":
            bodies = tuple(first.host(ref.owner) for ref in item.between())
            yield Work(item.name, first.ask("work", item.name, when=interval.name), item.name, bodies, inner=True)
    drawn = {item.rides[0].owner: item.name for item in first.arrangement.rides(interval.start) if not item.free}
    for body in facts.bodies:
        members = [member.name for member in first.arrangement.cluster(body.name, interval.start)]
        for name in (body.name, *members):
            owner = drawn.get(name, name)
            if first.arrangement.altered(name, interval.start, interval.end) and (name == body.name or name in drawn):
                yield Work(owner, first.ask("work", owner, when=interval.name), owner, (body.name,), inner=True)


def power_of(owner: str, instant: Instant) -> Formula:
    """The constant power of a motor."""
    item = next(item for item in instant.arrangement.actions(instant.state) if item.name == owner)
    return item.now(instant)


def named_work(owner: str, amount: Formula, bodies: tuple[str, ...], interval: Interval, first: Instant) -> Work:
    """The work under its own letter where the scene asks for it or fixes it, else spelled out."""
    if first.arrangement.asks(owner, "work") or first.arrangement.asks(owner, "power"):
        letter = first.ask("work", owner, when=interval.name)
        return Work(owner, letter, owner, bodies, amount)
    return Work(owner, amount, owner, bodies)


def work_of_force(
    vector: Vector, arm: Vector, body: BodyFacts, interval: Interval, first: Instant, last: Instant, middle: Instant
) -> Formula:
    """F · displacement along a line plus r × F times the angle turned."""
    name, motion = body.name, body.motion
    amount: Formula = ZERO
    if motion.bend is not None:
        amount = work_round(vector.along(motion.heading or RIGHT), name, interval, first, last, middle)
    elif motion.kind == "line" and motion.heading is not None:
        along = vector.along(motion.heading)
        speed = motion.velocity.along(motion.heading)
        amount = work_over(along, displacement(name, interval, first), speed, middle, interval, first, last)
    torque = arm.cross(vector)
    if motion.turns and torque != ZERO:
        turned = signed(rotation(name, interval, first), first.sense(name))
        amount = amount + work_over(torque, turned, motion.spin, middle, interval, first, last)
    return amount


def work_round(
    along: Formula, name: str, interval: Interval, first: Instant, last: Instant, middle: Instant
) -> Formula:
    """∫ F ρ dφ of the force along a circle; F s where that does not change on the way."""
    circle = middle.orbit(name)
    midway = middle.place_on(circle) if circle is not None else ZERO
    if circle is None or circle.radius is None or not along.symbols() & midway.symbols():
        return along * displacement(name, interval, first)
    ends = (moment.place_on(circle) for moment in (first, last))
    return Integral(signed(along * circle.radius, circle.way), next(iter(midway.symbols())), *ends)


def work_over(
    effort: Formula, change: Formula, rate: Formula, middle: Instant, interval: Interval, first: Instant, last: Instant
) -> Formula:
    """effort · change; ∫ effort · rate dt where the effort varies in time."""
    if "time" in effort.symbols():
        return Integral(effort * rate, "time", first.time(), last.time())
    return effort * change


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
    if "tension" in roles:
        parts.append("the string's tension gives one body what it takes from the other")
    if "friction" in roles:
        parts.append("friction does no work (the point of contact is at rest)")
    elif "normal" in roles:
        parts.append("the normal force does no work (it is square to the motion)")
    if parts:
        yield "Energy is conserved: " + "; ".join(parts)
