"""Passages: what happened in a phase: the travels, works and heights of its bodies, group by group, ready for the laws."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.facts import Facts
from rotsolve.core.passage import Passage
from rotsolve.core.vectors.heading import UP, heading
from rotsolve.language.bodies import Orbit
from rotsolve.language.problem import PointRef
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.instant import Instant
from rotsolve.motion.timeline import Interval
from rotsolve.motion.travels import Lead, displacement, leading_place, leading_rate, led, stored_place, travels_of
from rotsolve.motion.works import PhaseWorks, inner_works, summed, why_conserved, works_on


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
        summed(works, groups),
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
    groups: dict[frozenset[str], None] = {}
    for body in facts.bodies:
        groups[configuration.component(body.name, state)] = None
    return tuple(groups)
