"""Passages: what happened in a phase: the travels, works and heights of its bodies, group by group, ready for the laws."""

from __future__ import annotations

from collections.abc import Sequence

from rotsolve.algebra.formula import ZERO
from rotsolve.core.facts import Facts
from rotsolve.core.passage import Passage
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.instant import Instant
from rotsolve.motion.phases.heights import height_pair
from rotsolve.motion.phases.leading import Lead, leading_place, leading_rate, stored_place
from rotsolve.motion.phases.travels import led, travels_of
from rotsolve.motion.phases.works import Way, inner_works, summed, why_conserved, works_on
from rotsolve.motion.timeline import Interval

Moment = tuple[Instant, Facts]


def passage(interval: Interval, start: Moment, end: Moment, midst: Moment) -> Passage:
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
        for work in works_on(body, Way(interval, first, last, middle, leads[body.name]), duration)
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


def leads_of(groups: Sequence[frozenset[str]], start: Moment, end: Moment, midst: Moment) -> dict[str, Lead | None]:
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
