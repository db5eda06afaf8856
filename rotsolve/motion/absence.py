"""Absence: what events take away or have yet to begin: the names of what does not act at each state."""

from __future__ import annotations

from rotsolve.elements.connections import Connection
from rotsolve.elements.connections.contacts.touch import Touch
from rotsolve.elements.events import Cuts, Fixes, Grips, Removes
from rotsolve.language.problem import Problem
from rotsolve.motion.timeline import Timeline


def absent(problem: Problem, timeline: Timeline) -> dict[str, frozenset[str]]:
    """By state: what is cut or removed, the surfaces that a body has left, and the contacts that an event has yet to begin."""
    gone = frozenset(item.name for item in gripped(problem))
    result = {timeline.states[0].name: gone}
    for interval in timeline.intervals:
        event = interval.event
        if isinstance(event, Cuts):
            gone |= frozenset(event.cuts)
        elif isinstance(event, Removes):
            gone |= frozenset(event.removes)
        elif isinstance(event, Grips):
            gone = (gone | left_by(event.grips, problem)) - {event.grips}
        elif isinstance(event, Fixes) and event.fixes is not None:
            gone |= surfaces_of(event.fixes.owner, problem)
        result[interval.end] = gone
    return result


def gripped(problem: Problem) -> tuple[Connection, ...]:
    """The contacts that events begin."""
    names = {event.grips for event in problem.events if isinstance(event, Grips)}
    return tuple(item for item in problem.connections if item.name in names)


def left_by(contact: str | None, problem: Problem) -> frozenset[str]:
    """The surfaces that a body leaves for a contact: a ball that hits a corner turns about it and leaves the floor."""
    taken = (item.pair()[0].owner for item in gripped(problem) if isinstance(item, Touch) and item.name == contact)
    return frozenset[str]().union(*(surfaces_of(owner, problem) for owner in taken))


def surfaces_of(name: str, problem: Problem) -> frozenset[str]:
    """The contacts of a body with surfaces."""
    touches = (item for item in problem.connections if isinstance(item, Touch))
    return frozenset(item.name for item in touches if item.pair()[0].owner == name)
