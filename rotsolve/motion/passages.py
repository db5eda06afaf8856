"""Passages: what happened in a phase, ready for the laws: the travels, works and heights of its bodies, group by group."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.core.facts import Facts
from rotsolve.core.passage import Passage, Work
from rotsolve.core.symbols import UNKNOWN, key_of
from rotsolve.core.vectors.heading import RIGHT, UP
from rotsolve.motion.configuration import groups_of
from rotsolve.motion.instant import Instant
from rotsolve.motion.places import gone_along, heights, way_by_links
from rotsolve.motion.travels import Lead, leading_place, leading_rate, led, stored_place, travels_of
from rotsolve.motion.works import PhaseWorks, works_on

if TYPE_CHECKING:
    from rotsolve.motion.timeline import Interval


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
        parts.append("what the string takes from one body it gives to the others")
    if any(role.rubs for role in roles):
        parts.append("friction does no work (the point of contact is at rest)")
    elif any(role.presses for role in roles):
        parts.append("the normal force does no work (it is perpendicular to the motion)")
    if parts:
        yield "Energy is conserved: " + "; ".join(parts)


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
    levels = {body.name: heights(body.name, interval, first, last) for body in midst_facts.bodies}
    idle = tuple(words for group in groups for words in why_conserved(midst_facts, group))
    return Passage(
        interval.name,
        start_facts,
        end_facts,
        midst_facts,
        travels,
        merged_works(works, groups),
        levels,
        duration,
        times,
        groups,
        idle,
        tuple(linked_ways(midst_facts, interval, first, last)),
        dict(ways_in_the_plane(midst_facts, groups, interval, first, last)),
    )


def ways_in_the_plane(
    facts: Facts, groups: Sequence[frozenset[str]], interval: Interval, first: Instant, last: Instant
) -> Iterator[tuple[str, tuple[Formula | None, Formula | None]]]:
    """How far to the right and up bodies go that move together, one of them at least freely; None where that is not told."""
    free = {body.name for body in facts.bodies if body.motion.kind == "plane"}
    for name in (name for group in groups if len(group) > 1 and group & free for name in sorted(group)):
        right, up = (gone_along(name, axis, interval, first, last) for axis in (RIGHT, UP))
        yield name, (right, up)


def linked_ways(
    facts: Facts, interval: Interval, first: Instant, last: Instant
) -> Iterator[tuple[str, Formula, Formula]]:
    """Bodies with their ways along their lines, and what these are by the angles of what leads them."""
    for body in facts.bodies:
        way = way_by_links(body.name, interval, first, last)
        if way is not None:
            yield body.name, *way


def leads_of(groups: Sequence[frozenset[str]], start: Known, end: Known, midst: Known) -> dict[str, Lead | None]:
    """By body: the place with which the forces on its group vary, where there is one."""
    (first, start_facts), (last, end_facts), (middle, midst_facts) = start, end, midst
    return {
        name: leading_place(group, first, last, middle) or stored_place(group, start_facts, end_facts, midst_facts)
        for group in groups
        for name in group
    }
