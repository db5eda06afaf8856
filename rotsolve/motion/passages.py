"""Passages: what happened in a phase, ready for the laws: the travels, works and heights of its bodies, group by group."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, Integral, Symbol, total
from rotsolve.core.facts import BodyFacts, Facts, signed
from rotsolve.core.passage import Passage, Work
from rotsolve.core.symbols import CONSTANT, RATES, TIME, UNKNOWN, at_any_time, key_of, running
from rotsolve.core.vectors.heading import UP, Vector, heading
from rotsolve.motion.instant import Instant
from rotsolve.motion.travels import (
    Lead,
    displacement,
    leading_place,
    leading_rate,
    led,
    led_by,
    relative_rate,
    rotation,
    stored_place,
    travels_of,
)

if TYPE_CHECKING:
    from rotsolve.language.bodies import Orbit
    from rotsolve.language.problem import PointRef
    from rotsolve.motion.configuration import Configuration
    from rotsolve.motion.timeline import Interval


def works_on(body: BodyFacts, way: PhaseWorks, duration: Formula) -> Iterator[Work]:
    """Work of the forces and couples on a body that are neither weights, springs nor ideal connections."""
    name, interval, first = body.name, way.interval, way.first
    for force in body.forces:
        if force.internal or not force.works or force.role.stores:
            continue
        yield named_work(force.owner, work_of_force(force.vector, force.arm, body, way), (name,), interval, first)
    for couple in body.couples:
        if couple.role.powered:
            motors = first.configuration.actions(way.middle.state)
            power = next(item for item in motors if item.name == couple.owner).now(way.middle)
            summed = Integral(power, TIME, first.time(), way.last.time())
            amount = summed if TIME in power.symbols() else power * duration
            yield named_work(couple.owner, None if running(power.symbols()) else amount, (name,), interval, first)
        elif not (couple.internal or couple.role.stores or couple.role.inner):
            turned = signed(rotation(name, interval, first), first.sense(name))
            told = way.work(couple.torque, turned, body.motion.spin, name)
            yield named_work(couple.owner, told, (name,), interval, first)


def work_of_force(vector: Vector, arm: Vector, body: BodyFacts, way: PhaseWorks) -> Formula | None:
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


class PhaseWorks(Struct, frozen=True):
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
            pace = self.first.configuration.pace(name, self.interval.start) if at_any_time(letters) else CONSTANT
            if TIME in letters or pace == TIME:
                return Integral(effort * rate, TIME, self.first.time(), self.last.time())
            return effort * change if pace == CONSTANT else None
        if TIME in letters:
            return Integral(effort * rate, TIME, self.first.time(), self.last.time())
        if running(letters, RATES):
            return None
        lead = self.lead if self.lead is not None else led_by(name, "angle", self.first, self.last, self.middle)
        if lead is None:
            return None
        return Integral(effort * relative_rate(rate, lead.rate), lead.letter.name, lead.start, lead.end)

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


def named_work(owner: str, amount: Formula | None, bodies: tuple[str, ...], interval: Interval, first: Instant) -> Work:
    """The work under its own letter where the scene asks for it or fixes it, or where only energy tells it; else spelled out."""
    mentions = first.configuration.mentions
    if amount is None or mentions.asks(owner, "work") or mentions.asks(owner, "power"):
        letter = first.ask("work", owner, when=interval.name)
        return Work(owner, letter, owner, bodies, amount)
    return Work(owner, amount, owner, bodies)


def inner_works(facts: Facts, interval: Interval, first: Instant) -> Iterator[Work]:
    """Works of inner forces that nothing is said of: of what turns one body on another, of what draws riders or arms in."""
    connections = first.configuration.connections(interval.start)
    for item in connections:
        if item.between() and item.pace(first.configuration, interval.start) == UNKNOWN:
            bodies = tuple(first.host(ref.owner) for ref in item.between())
            yield Work(item.name, first.ask("work", item.name, when=interval.name), item.name, bodies, inner=True)
    drawn = {item.rider.owner: item.owner for item in first.configuration.rides(interval.start) if not item.free}
    for body in facts.bodies:
        for name in first.configuration.carried(body.name, interval.start):
            owner = drawn.get(name, name)
            own = name in drawn or (name == body.name and not first.configuration.laid(name))
            if own and first.configuration.altered(name, interval.start, interval.end):
                yield Work(owner, first.ask("work", owner, when=interval.name), owner, (body.name,), inner=True)


def merged_works(works: Sequence[Work], groups: Sequence[frozenset[str]]) -> tuple[Work, ...]:
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
    own = isinstance(work.amount, Symbol) and key_of(work.amount.name).kind == "work"
    return not work.inner and (own or work.spelled is not None)


def why_conserved(facts: Facts, group: frozenset[str]) -> Iterator[str]:
    """Why mechanical energy is conserved, in a sentence about the forces that do no work."""
    bodies = [body for body in facts.bodies if body.name in group]
    roles = [force.role for body in bodies for force in body.forces]
    parts = []
    if any(body.sliding for body in bodies):
        parts.append("there is no friction where the one slides along the other")
    if any(body.motion.kind == "axis" for body in bodies) and any(role.holds for role in roles):
        held = "the pivot does no work (its point is at rest)"
        parts.append("the axle does no work (it is at rest)" if any(role.axle for role in roles) else held)
    if any(body.lays for body in bodies):
        jolt = "what is laid down comes to rest without a jolt (the mass still rolled up is as its radius squared)"
        parts.append(jolt)
    if any(role.pulls for role in roles):
        parts.append("the string's tension gives one body what it takes from the other")
    if any(role.rubs for role in roles):
        parts.append("friction does no work (the point of contact is at rest)")
    elif any(role.presses for role in roles):
        parts.append("the normal force does no work (it is perpendicular to the motion)")
    if parts:
        yield "Energy is conserved: " + "; ".join(parts)


def height_pair(name: str, interval: Interval, first: Instant, last: Instant) -> tuple[Formula, Formula] | None:
    """Heights of a body's reference point at both ends of a phase, from a level that stays; None where geometry does not tell."""
    if not first.configuration.heavy:
        return (ZERO, ZERO)
    line = first.line(name)
    straight = first.motion(name).kind == "line" and first.orbit(name) is None and not first.configuration.laid(name)
    if straight and line is not None:
        rise = line[0].sin()
        return (ZERO, displacement(name, interval, first) * rise if rise != ZERO else ZERO)
    before, after = height(name, first), height(name, last)
    return None if before is None or after is None else (before, after)


def height(name: str, instant: Instant) -> Formula | None:
    """Height of the reference point above a fixed level: of a pivot 0, of a centre of mass by what the body touches or hangs from."""
    configuration = instant.configuration
    if configuration.pivot(name, instant.state) is not None:
        return ZERO
    orbit = instant.orbit(name)
    if orbit is not None:
        return height_on(orbit, name, instant)
    heights = (
        item.height(name, instant, partial(height_of_point, instant=instant))
        for item in configuration.connections(instant.state)
    )
    return next((found for found in heights if found is not None), None)


def height_on(orbit: Orbit, name: str, instant: Instant) -> Formula:
    """Height of a body's centre on its circle, ρ sin φ above that of the circle; a letter of its own on a track of unknown profile."""
    if orbit.radius is None:
        return instant.ask("height", name)
    rise = heading(instant.place_on(orbit)).sin()
    return simplify(orbit.level + orbit.radius * rise, order=instant.configuration.order)


def height_of_point(ref: PointRef, instant: Instant) -> Formula | None:
    """Height of a point of a body above the same fixed level."""
    name = instant.host(ref.owner)
    reference = height(name, instant)
    return None if reference is None else reference + instant.point(ref).along(UP)


Known = tuple[Instant, Facts]


def passage(interval: Interval, start: Known, end: Known, midst: Known) -> Passage:
    """All that the laws read about one phase."""
    (first, start_facts), (last, end_facts), (middle, midst_facts) = start, end, midst
    configuration = first.configuration
    times = (first.time(), last.time())
    duration = first.ask("time", "", when=interval.name) if times[0] != ZERO else times[1]
    groups = groups_of(configuration, midst_facts, interval.start)
    leads = leads_of(groups, start, end, midst)
    rates = {leading_rate(group, midst_facts) for group in groups}
    travels = tuple(
        led(travel, leads[body.name], rates)
        for body in midst_facts.bodies
        for travel in travels_of(body, interval, first, last, middle)
    )
    works = [
        work
        for body in midst_facts.bodies
        for work in works_on(body, PhaseWorks(interval, first, last, middle, leads[body.name]), duration)
    ]
    works += inner_works(midst_facts, interval, first)
    heights = {body.name: height_pair(body.name, interval, first, last) for body in midst_facts.bodies}
    idle = tuple(words for group in groups for words in why_conserved(midst_facts, group))
    return Passage(
        interval.name,
        start_facts,
        end_facts,
        midst_facts,
        travels,
        merged_works(works, groups),
        heights,
        duration,
        times,
        groups,
        idle,
    )


def leads_of(groups: Sequence[frozenset[str]], start: Known, end: Known, midst: Known) -> dict[str, Lead | None]:
    """By body: the place with which the forces on its group vary, where there is one."""
    (first, start_facts), (last, end_facts), (middle, midst_facts) = start, end, midst
    return {
        name: leading_place(group, first, last, middle) or stored_place(group, start_facts, end_facts, midst_facts)
        for group in groups
        for name in group
    }


def groups_of(configuration: Configuration, facts: Facts, state: str) -> tuple[frozenset[str], ...]:
    """Bodies that move together, group by group."""
    return tuple(dict.fromkeys(configuration.component(body.name, state) for body in facts.bodies))
