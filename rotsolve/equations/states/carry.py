"""Carrying over: an event moves nothing, and leaves the velocities of what it does not touch."""

from __future__ import annotations

from rotsolve.elements.connections.touch import Touch
from rotsolve.elements.events import Grips
from rotsolve.elements.surfaces import Curved
from rotsolve.equations.states.fixed import Fixed
from rotsolve.language.problem import State
from rotsolve.motion.instant import Instant
from rotsolve.motion.timeline import Interval

RATES = ("velocity", "angular_velocity")


def carry_over(state: State, fixed: Fixed) -> None:
    """What an event before a state leaves as it was."""
    before = fixed.configuration.timeline.before(state.name)
    if before is None or before.event is None:
        return
    last, fresh = fixed.instant(before.start), fixed.instant(state.name)
    said = {line.path.owner for line in state.conditions if line.path and line.path.quantity in RATES}
    touched = touched_by(before, fixed) | said | ({"all"} if any(line.rest for line in state.conditions) else set())
    for item in fixed.configuration.connections(state.name):
        for word in item.kept:
            fixed.fix(fresh.ask(word, item.name), last.ask(word, item.name))
    keep_places(before, last, fresh, fixed)
    for body in fixed.configuration.present(state.name):
        keep_angle(body.name, last, fresh, fixed)
        if body.name not in touched and "all" not in touched:
            for one, other in zip(fixed.rates(last, body.name), fixed.rates(fresh, body.name), strict=False):
                fixed.fix(other, one)


def keep_angle(body: str, last: Instant, fresh: Instant, fixed: Fixed) -> None:
    """A body does not turn in an event; a new hinge counts the angle from its own side."""
    old, new = last.angle(body), fresh.angle(body)
    if new is not None:
        same = old is not None and fresh.offset(body) == last.offset(body)
        turned = last.orientation(body) + fresh.offset(body)
        fixed.fix(new, old if same and old is not None else turned.formula())


def keep_places(event: Interval, last: Instant, fresh: Instant, fixed: Fixed) -> None:
    """A body stays where it touches a curved surface, also one that it only meets in the event."""
    met = {event.event.grips} if isinstance(event.event, Grips) else set()
    acting = {item.name for item in fixed.configuration.connections(event.start)} | met
    for item in fixed.configuration.connections(event.end):
        if isinstance(item, Touch) and item.name in acting:
            surface = item.surface(fixed.configuration, event.end)
            if isinstance(surface, Curved):
                fixed.fix(item.angle(fresh), item.angle(last))


def touched_by(interval: Interval, fixed: Fixed) -> frozenset[str]:
    """Bodies whose velocities an event changes."""
    from rotsolve.motion.encounters import participants

    found: frozenset[str] = frozenset()
    for ref in participants(interval, fixed.configuration):
        for state in (interval.start, interval.end):
            found |= fixed.configuration.component(ref.owner, state)
    return found
