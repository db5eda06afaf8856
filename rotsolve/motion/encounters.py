"""Encounters: an event between two states, as the laws of momentum read it."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, negate
from rotsolve.core.facts import BLOW, CONTACT, REACTION, BodyFacts, Facts, Force, Inertia
from rotsolve.core.passage import Encounter, Meeting
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, UP, Heading, Vector, unit
from rotsolve.elements.actions import pointing
from rotsolve.elements.connections.touch import Touch
from rotsolve.elements.events import Collides, Cuts, Event, Fixes, Grips, Impulse, Joins, Removes
from rotsolve.elements.rims import rim_radius
from rotsolve.language.problem import PointRef
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.freebody import free_body
from rotsolve.motion.instant import Instant
from rotsolve.motion.rigid import tidy
from rotsolve.motion.timeline import Interval

HOLDING = (Fixes, Grips)


def encounter(interval: Interval, before: tuple[Instant, Facts], after: tuple[Instant, Facts]) -> Encounter | None:
    """What an event does to the bodies that take part; None for one that changes no velocity (a string is cut)."""
    event = interval.event
    if not isinstance(event, Event) or isinstance(event, (Cuts, Removes)):
        return None
    (first, first_facts), (last, last_facts) = before, after
    points = participants(interval, first.configuration)
    group: frozenset[str] = frozenset()
    for ref in points:
        group |= first.configuration.component(ref.owner, last.state) | first.configuration.component(
            ref.owner, first.state
        )
    involved = [body for body in first_facts.bodies if body.name in group]
    blows = {body.name: tuple(blows_on(body, event, points, first)) for body in involved}
    places = common_places(involved, points, event, first)
    meetings = tuple(
        replace(
            meeting(body, first, last, blows[body.name], places.get(body.name)),
            twists=twists_on(body, event, points, first),
            held=held_after(body, event, last_facts),
        )
        for body in involved
    )
    supports = {body.name: support(body, first) for body in involved if body.motion.kind == "axis"}
    supports |= {first.host(ref.owner): suddenly(event, ref, first) for ref in points if isinstance(event, HOLDING)}
    words = getattr(event, "about", "")
    return Encounter(interval.name, words, meetings, (group,), supports, bounce(event, points, first, last))


def participants(interval: Interval, configuration: Configuration) -> tuple[PointRef, ...]:
    """The points that an event names; of a contact that grips the body's."""
    event = interval.event
    if isinstance(event, Joins):
        return event.joins
    if isinstance(event, Collides):
        return event.collides
    if isinstance(event, Impulse) and event.on is not None:
        return (event.on,)
    if isinstance(event, Fixes) and event.fixes is not None:
        return (event.fixes,)
    contact = gripping(event, configuration)
    return contact.pair()[:1] if contact is not None else ()


def gripping(event: Event | None, configuration: Configuration) -> Touch | None:
    """The contact that an event begins."""
    named = event.grips if isinstance(event, Grips) else None
    found = (item for item in configuration.problem.connections if item.name == named)
    return next((item for item in found if isinstance(item, Touch)), None)


def spot(ref: PointRef, event: Event, instant: Instant) -> Vector:
    """Where an event acts on a body, from its reference: a named point, or where a contact that grips touches it."""
    contact = gripping(event, instant.configuration)
    return instant.point(ref) if contact is None else contact.arm(instant)


def support(body: BodyFacts, instant: Instant) -> str:
    """What the body's axis is called."""
    held = (
        item
        for item in instant.configuration.connections(instant.state)
        for ref in item.fixed_points()
        if ref.owner == body.name
    )
    return "axle" if any(item.word == "axle" for item in held) else "pivot"


def suddenly(event: Event, ref: PointRef, instant: Instant) -> str:
    """What the point is called at which an event holds a body."""
    contact = gripping(event, instant.configuration)
    surface = contact.surface(instant.configuration, instant.state) if contact is not None else None
    if surface is not None:
        return surface.held_at
    return f"{ref.owner}'s {ref.point or 'centre'}".replace("_", " ")


def held_after(body: BodyFacts, event: Event, after: Facts) -> Formula | None:
    """Moment of inertia about the point at which an event holds a body from then on."""
    own = after.body(body.name) if isinstance(event, Fixes) else None
    return own.inertia.letter if own is not None and own.motion.kind == "axis" and own.inertia is not None else None


def meeting(body: BodyFacts, first: Instant, last: Instant, blows: tuple[Force, ...], place: Vector | None) -> Meeting:
    """One body before and after; afterwards it may be part of another."""
    host = last.host(body.name)
    motion = last.motion(host)
    own = PointRef(body.name, "cm")
    shift = tidy(last.point(own) - first.point(own))  # of its place from the reference, which may be another afterwards
    centre = motion.velocity_of(body.cm + shift)
    inertia: Formula = body.inertia.letter if body.inertia is not None else own_inertia(body, first)
    return Meeting(body, inertia, body.centre_velocity, centre, body.motion.spin, motion.spin, place, blows)


def own_inertia(body: BodyFacts, instant: Instant) -> Formula:
    """Moment of inertia of a body that did not turn before but may after."""
    own = free_body(instant.body(body.name), instant, (), ())
    inertia: Inertia | None = own.inertia
    return inertia.letter if inertia is not None else ZERO


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
            places[name] = contact - (spot(ref, event, instant) - body.cm)
    return places


def blows_on(body: BodyFacts, event: Event, points: tuple[PointRef, ...], instant: Instant) -> list[Force]:
    """The blows on one body: at its support, and from the event itself."""
    blows = []
    for force in body.forces:
        if force.role.holds:
            axis = "x" if force.direction == unit(RIGHT) else "y"
            words = ("right", "left") if axis == "x" else ("up", "down")
            size = instant.ask("impulse", force.owner, component=axis, words=words)
            blows.append(
                Force(force.owner, REACTION, body.name, size, force.direction, force.arm, "blow", internal=True)
            )
    for index, ref in enumerate(points):
        if instant.host(ref.owner) != body.name:
            continue
        arm = spot(ref, event, instant)
        if isinstance(event, Impulse):
            blows.append(outside_blow(event, body, arm, instant))
        else:
            for axis, direction in contact_axes(event, points, instant):
                size = instant.ask("impulse", event.name, component=axis)
                push = unit(direction if index == len(points) - 1 else direction.turned(180))
                blows.append(Force(event.name, CONTACT, body.name, size, push, arm, "blow", internal=True))
    return blows


def twists_on(body: BodyFacts, event: Event, points: tuple[PointRef, ...], instant: Instant) -> tuple[Formula, ...]:
    """Bodies that stick together also twist each other until they turn as one."""
    if not isinstance(event, Joins):
        return ()
    owners = [instant.host(ref.owner) for ref in points]
    if body.name not in owners:
        return ()
    twist = instant.ask("angular_impulse", event.name)
    return (twist if owners.index(body.name) == 1 else negate(twist),)


def outside_blow(event: Impulse, body: BodyFacts, arm: Vector, instant: Instant) -> Force:
    """The impulse of a blow from outside."""
    size = event.impulse or ZERO
    if event.direction in (None, "tangential", "clockwise", "counterclockwise"):
        turn = {"clockwise": -1, "counterclockwise": 1}.get(str(event.direction), body.motion.sense)
        radius = rim_radius(instant.body(body.name), event.on.point if event.on else None)
        if arm.parts:
            push = unit(arm.parts[0][1].turned(90 * turn))
        elif radius is not None and event.on is not None and event.on.point is not None:
            arm, push = Vector(((radius, RIGHT),)), unit(UP.turned(0 if turn > 0 else 180))
        else:
            push = unit(body.motion.heading or RIGHT)
    else:
        push = pointing(event.direction)
    return Force(event.name, BLOW, body.name, size, push, arm, "impulse")


def contact_axes(event: Event, points: tuple[PointRef, ...], instant: Instant) -> tuple[tuple[str, Heading], ...]:
    """Directions in which two bodies push each other: both when they stick, the line of approach when they bounce."""
    if isinstance(event, Collides):
        return (("", approach_heading(points, instant)),)
    return (("x", RIGHT), ("y", UP))


def approach_heading(points: tuple[PointRef, ...], instant: Instant) -> Heading:
    """The line along which two bodies approach: that on which one of them travels."""
    for ref in points:
        motion = instant.motion(ref.owner)
        if motion.kind == "line" and motion.heading is not None:
            return motion.heading
    for ref in points:
        parts = instant.velocity(ref).parts
        if len(parts) == 1:
            return parts[0][1]
    return RIGHT


def bounce(
    event: Event, points: tuple[PointRef, ...], first: Instant, last: Instant
) -> tuple[Formula, Formula, Formula] | None:
    """(e, approach speed before, separation speed after) along the line of approach."""
    if not isinstance(event, Collides) or event.restitution is None:
        return None
    line = approach_heading(points, first)
    one, two = points
    approach = first.velocity(one).along(line) - first.velocity(two).along(line)
    separation = last.velocity(two).along(line) - last.velocity(one).along(line)
    return event.restitution, approach, separation
