"""Encounters: an event between two states, as the laws of momentum read it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.facts import REACTION, BodyFacts, Facts, Force
from rotsolve.core.passage import Encounter, Meeting
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, Vector, unit
from rotsolve.language.bodies import PointRef
from rotsolve.motion.freebody import free_body
from rotsolve.motion.rigid import tidy

if TYPE_CHECKING:
    from rotsolve.language.elements import Event
    from rotsolve.motion.configuration import Configuration
    from rotsolve.motion.instant import Instant
    from rotsolve.motion.timeline import Interval


def encounter(interval: Interval, before: tuple[Instant, Facts], after: tuple[Instant, Facts]) -> Encounter | None:
    """What an event does to the bodies that take part; None for one that changes no velocity (a string is cut)."""
    event, (first, first_facts), (last, last_facts) = interval.event, before, after
    points = participants(interval, first.configuration)
    if event is None or not points:
        return None
    states = (last.state, first.state)
    group = frozenset(
        name for ref in points for state in states for name in first.configuration.component(ref.owner, state)
    )
    involved = [body for body in first_facts.bodies if body.name in group]
    blows = {body.name: tuple(blows_on(body, event, points, first)) for body in involved}
    places = common_places(involved, points, event, first)
    meetings = tuple(
        replace(
            meeting(body, first, last, blows[body.name], places.get(body.name)),
            twists=event.twists(body.name, first),
            held=held_after(body, last_facts) if event.adds() else None,
        )
        for body in involved
    )
    supports = {body.name: support(body, first) for body in involved if body.motion.kind == "axis"}
    supports |= {first.host(ref.owner): held for ref in points if (held := event.holds(ref, first))}
    return Encounter(interval.name, event.about, meetings, (group,), supports, event.bounce(first, last))


def participants(interval: Interval, configuration: Configuration) -> tuple[PointRef, ...]:
    """The points that take part in an event."""
    return interval.event.points(configuration.problem.connections) if interval.event is not None else ()


def support(body: BodyFacts, instant: Instant) -> str:
    """What the body's axis is called."""
    held = (item for item in instant.configuration.connections(instant.state) if item.axial)
    return "axle" if any(ref.owner == body.name for item in held for ref in item.fixed_points()) else "pivot"


def held_after(body: BodyFacts, after: Facts) -> Formula | None:
    """Moment of inertia about the point at which an event holds a body from then on."""
    own = after.body(body.name)
    return own.inertia.letter if own is not None and own.motion.kind == "axis" and own.inertia is not None else None


def meeting(body: BodyFacts, first: Instant, last: Instant, blows: tuple[Force, ...], place: Vector | None) -> Meeting:
    """One body before and after; afterwards it may be part of another."""
    motion, own = last.motion(last.host(body.name)), PointRef(body.name, "cm")
    shift = tidy(last.point(own) - first.point(own))  # of its place from the reference, which may be another afterwards
    centre = motion.velocity_of(body.cm + shift)
    inertia = (
        body.inertia or free_body(first.body(body.name), first, (), ()).inertia
    )  # what did not turn before may after
    letter: Formula = inertia.letter if inertia is not None else ZERO
    return Meeting(body, letter, body.centre_velocity, centre, body.motion.spin, motion.spin, place, blows)


def common_places(
    bodies: list[BodyFacts], points: tuple[PointRef, ...], event: Event, instant: Instant
) -> dict[str, Vector]:
    """Centre of mass of each body from one common point: the axis of the one that is held, else where they meet."""
    held = next((body for body in bodies if body.motion.kind == "axis"), None)
    if held is not None:
        where = next((ref for ref in points if instant.host(ref.owner) == held.name), None)
        places = {body.name: NOWHERE for body in bodies if body.motion.kind == "axis"}
        if where is None:
            return places
        contact = instant.point(where)
    else:
        places, contact = {}, NOWHERE
    for ref in points:
        name = instant.host(ref.owner)
        body = next((body for body in bodies if body.name == name), None)
        if body is not None and name not in places:
            places[name] = contact - (event.spot(ref, instant) - body.cm)
    return places


def blows_on(body: BodyFacts, event: Event, points: tuple[PointRef, ...], instant: Instant) -> Iterator[Force]:
    """The blows on one body: at its support, and from the event itself."""
    for force in body.forces:
        if force.role.holds:
            axis, words = ("x", ("right", "left")) if force.direction == unit(RIGHT) else ("y", ("up", "down"))
            size = instant.ask("impulse", force.owner, component=axis, words=words)
            push, arm = force.direction, force.arm
            yield Force(force.owner, REACTION, body.name, size, push, arm, "blow", internal=True)
    for ref in points:
        if instant.host(ref.owner) == body.name:
            yield from event.blows(ref, body, instant)
