"""Encounters: an event between two states, as the laws of momentum read it: each body with all the impulses on it.

What a connection does in an event follows from what it does at a moment: where it exerts an unknown force along a direction it gives an
impulse along that, as large as it takes for its rule of speeds to hold afterwards. Weights, springs and forces of a known size give none.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, Number
from rotsolve.core.facts import CONTACT, BodyFacts, Couple, Facts, Force, Requirement, Rule, signed
from rotsolve.core.faults import Unsolvable
from rotsolve.core.passage import Approach, Encounter, Meeting
from rotsolve.core.symbols import is_key, key_of, rub_key
from rotsolve.core.vectors.heading import NOWHERE, UP, Vector
from rotsolve.language.bodies import PointRef
from rotsolve.motion.freebody import free_bodies
from rotsolve.motion.moments import moment_of_inertia
from rotsolve.motion.rigid import tidy
from rotsolve.motion.rubs import STICKS, in_one_body

if TYPE_CHECKING:
    from rotsolve.language.elements import Event
    from rotsolve.motion.configuration import Configuration
    from rotsolve.motion.instant import Instant
    from rotsolve.motion.timeline import Interval

PARTS = {"normal_force": "n", "friction_force": "f"}  # by kind of a force: the index of its impulse
CLOSE = Number(
    Fraction(1, 10_000)
)  # square of the share of their arms by which points that meet may be apart: data are rounded
WAYS = {"x": ("right", "left"), "y": ("up", "down")}
AS_NEEDED = ("force", "tension", *PARTS)  # kinds of the forces that are as large as it takes


def encounter(interval: Interval, before: tuple[Instant, Facts], after: tuple[Instant, Facts]) -> Encounter | None:
    """What an event does to the bodies that take part; None for one that changes no velocity (a string is cut)."""
    event, (first, facts), (last, last_facts) = interval.event, before, after
    points = participants(interval, first.configuration)
    if event is None or not points:
        return None
    states = (last.state, first.state)
    group = frozenset(
        name for ref in points for state in states for name in first.configuration.component(ref.owner, state)
    )
    modes, stuck = modes_through(interval, first, last)
    if modes != first.modes:
        first = replace(first, modes=modes)
        facts = free_bodies(first)
    involved = [body for body in facts.bodies if body.name in group]
    places = common_places(involved, event, first)
    lasting = {  # what parts of one body do to each other is in the blow by which they are joined
        item.name
        for item in last.configuration.connections(last.state)
        if not in_one_body(item, last.configuration, last.state)
    }
    axes = any(body.motion.kind == "axis" for body in involved)
    meetings = [
        replace(
            meeting(body, first, last, last_facts, places.get(body.name)),
            blows=(*impulses_of(body, lasting, first), *blows_on(body, event, first)),
            twists=(*angular_impulses_of(body, lasting, first), *event.twists(body.name, first)),
            held=held_after(body, last_facts) if event.adds() and not axes else None,
        )
        for body in involved
    ]
    check_rails(meetings, event, first)
    impulsive = (impulsive_need(need, first) for need in facts.requirements if need.owner in lasting)
    needs = (*(need for need in impulsive if need.left != ZERO), *event.needs(first, last))
    bounced = (item.bounce(first, last) for item in event.each())
    met = Encounter(interval.name, event.about, tuple(meetings), supports(involved, event, first), needs)
    return replace(
        met,
        bounces=tuple(bounce for bounce in bounced if bounce is not None),
        closings=tuple(closings(event, first, last)),
        rules=(*stuck, *event.rules(first, last)),
        joined=joined_on_an_axis(involved, last, last_facts),
        armless=event.no_torque(first),
        givers=tuple(item.name for item in event.each()),
    )


def closings(event: Event, first: Instant, last: Instant) -> Iterator[Approach]:
    """Which bodies come together in an event and part again, and how fast."""
    for item in event.each():
        speeds, connections = item.closing(first, last), first.configuration.problem.connections
        if speeds is not None:
            pair = tuple(ref.owner for ref in item.points(connections))
            yield Approach(item.name, pair, *speeds, item.bounce(first, last) is not None)


def joined_on_an_axis(
    involved: Sequence[BodyFacts], last: Instant, after: Facts
) -> tuple[tuple[frozenset[str], BodyFacts], ...]:
    """The bodies that an event makes one that turns on an axis, with the facts of that one."""
    members: dict[str, set[str]] = {}
    for body in involved:
        members.setdefault(last.host(body.name), set()).add(body.name)
    wholes = ((frozenset(own), after.body(host)) for host, own in members.items() if len(own) > 1)
    return tuple(
        (own, whole) for own, whole in wholes if whole is not None and whole.motion.kind == "axis" and whole.inertia
    )


def participants(interval: Interval, configuration: Configuration) -> tuple[PointRef, ...]:
    """The points that take part in an event."""
    return interval.event.points(configuration.problem.connections) if interval.event is not None else ()


def modes_through(interval: Interval, first: Instant, last: Instant) -> tuple[dict[str, str], tuple[Rule, ...]]:
    """How what rubs moves in an event: as right after it, or it sticks, with the rules of what does though it slips from then on."""
    configuration, modes = first.configuration, dict(first.modes)
    start, end = (configuration.phase_start(instant.state) for instant in (first, last))
    stuck = {}
    for item in configuration.connections(first.state):
        for ref in item.brakes():  # what resists the turn that the event gives
            names = [f"{item.name}.{instant.host(ref.owner)}" for instant in (first, last)]
            modes[rub_key(names[0], start)] = last.modes.get(rub_key(names[1], end), "")
        if item.rubs():
            after = last.modes.get(rub_key(item.name, end), STICKS)
            modes[rub_key(item.name, start)] = last.modes.get(rub_key(item.name, interval.name), after)
            if modes[rub_key(item.name, start)] != after:
                stuck[item.name] = rub_key(item.name, end)
    if not stuck:
        return modes, ()
    held = replace(last, modes={**last.modes, **dict.fromkeys(stuck.values(), STICKS)})
    return modes, tuple(rule for rule in free_bodies(held).rules if rule.owner in stuck)


# impulses of connections


def impulses_of(body: BodyFacts, owners: Container[str], instant: Instant) -> Iterator[Force]:
    """The impulses of the forces of connections on a body, as forces with an impulse for size."""
    for force in body.forces:
        letters = letters_of(force, instant) if force.owner in owners else {}
        if letters:
            yield replace(force, size=force.size.substitute(letters), noun="blow")


def angular_impulses_of(body: BodyFacts, owners: Container[str], instant: Instant) -> Iterator[Couple]:
    """The angular impulses of belts and gears, and of whatever makes a given motion true."""
    for couple in body.couples:
        item = instant.configuration.connection(couple.owner, instant.state)
        letters = letters_of(couple, instant) if couple.owner in owners else {}
        if letters:
            size, torque = couple.size.substitute(letters), couple.torque.substitute(letters)
            yield replace(couple, size=size, torque=torque, noun="blow")
        elif item is not None and any(item.prescribes()):
            size = instant.ask("angular_impulse", couple.owner, words=instant.turn_words(body.name))
            yield replace(couple, size=size, torque=signed(size, body.motion.sense), noun="blow")


def letters_of(item: Force | Couple, instant: Instant) -> dict[str, Formula]:
    """By letter of a force that is as large as it takes, even in an event: that of its impulse."""
    connection = instant.configuration.connection(item.owner, instant.state)
    return jolts(item.size, instant) if connection is not None and connection.jolts() else {}


def jolts(size: Formula, instant: Instant) -> dict[str, Formula]:
    """By letter of a force that is as large as it takes: that of its impulse."""
    keys = {name: key_of(name) for name in size.symbols() if is_key(name)}
    return {
        name: instant.ask(
            "impulse", key.owner, component=PARTS.get(key.kind, key.component), words=WAYS.get(key.component, ("", ""))
        )
        for name, key in keys.items()
        if key.kind in AS_NEEDED
    }


def impulsive_need(need: Requirement, instant: Instant) -> Requirement:
    """A string does not push and a surface does not pull in an event either."""
    return replace(
        need,
        left=need.left.substitute(jolts(need.left, instant)),
        right=need.right.substitute(jolts(need.right, instant)),
    )


def blows_on(body: BodyFacts, event: Event, instant: Instant) -> Iterator[Force]:
    """The blows of the event itself on one body."""
    for item in event.each():
        for ref in item.points(instant.configuration.problem.connections):
            if instant.host(ref.owner) == body.name:
                yield from item.blows(ref, body, instant)


# each body


def meeting(body: BodyFacts, first: Instant, last: Instant, after: Facts, place: Vector | None) -> Meeting:
    """One body before and after; afterwards it may be part of another, and no body of its own."""
    motion = last.motion(last.host(body.name))
    own = PointRef(body.name, "cm")
    shift = tidy(last.point(own) - first.point(own))  # of its place from the reference, which may be another afterwards
    centre = motion.velocity_of(body.cm + shift)
    if body.inertia is not None:
        inertia = body.inertia.letter
    elif motion.turns:  # what did not turn before may after
        inertia = moment_of_inertia(first.body(body.name), first.configuration, first.state, first.registry).formula
    else:
        inertia = ZERO
    lines = body.motion.kind == motion.kind == "line" and body.motion.heading == motion.heading
    later = after.body(body.name)
    guided = lines and later is not None and not body.pressed and not later.pressed
    return Meeting(body, inertia, body.centre_velocity, centre, body.motion.spin, motion.spin, place, (), guided=guided)


def check_rails(meetings: Sequence[Meeting], event: Event, instant: Instant) -> None:
    """What `moves` along a level line may be pushed down by what falls on it, since the ground bears it; what pushes it to its side in
    another way, from below too, is refused."""
    upright = instant.configuration.problem.plane == "vertical"
    for item in meetings:
        heading, name = item.body.motion.heading, item.body.name
        if not item.guided or heading is None:
            continue
        across = heading.turned(90)
        pushed = any(blow.role is CONTACT and blow.direction.along(across) != ZERO for blow in item.blows)
        met = [other for other in meetings if any(blow.role is CONTACT for blow in other.blows)]
        rising = (instant.configuration.signs.sign(other.before.along(UP)) for other in met)
        if upright and heading.sin() == ZERO and 1 not in rising:
            continue
        if pushed and any(rate.along(across) != ZERO for other in met for rate in (other.before, other.after)):
            held = any(
                ref.owner == name for link in instant.configuration.connections(instant.state) for ref in link.touches()
            )
            help = "" if held else f"leave out `moves` of `{name}`, and give its velocity as [vx, vy]"
            message = f"`{event.name}` pushes `{name}` to the side of the line along which it `moves`"
            raise Unsolvable(message, span=instant.body(name).span, help=help)


def held_after(body: BodyFacts, after: Facts) -> Formula | None:
    """Moment of inertia about the point at which an event holds a body from then on."""
    own = after.body(body.name)
    return own.inertia.letter if own is not None and own.motion.kind == "axis" and own.inertia is not None else None


# where they are


def supports(bodies: list[BodyFacts], event: Event, instant: Instant) -> str:
    """What the point is called about which the group turns: a support, or what the event holds; '' where they are free."""
    first = next((body for body in bodies if body.motion.kind == "axis"), None)
    if first is None:
        events, connections = event.each(), instant.configuration.problem.connections
        held = (item.holds(ref, instant) for item in events for ref in item.points(connections))
        return next(filter(None, held), "") if len(events) == 1 else ""
    axles = (item for item in instant.configuration.connections(instant.state) if item.axial)
    return "axle" if any(ref.owner == first.name for item in axles for ref in item.fixed_points()) else "pivot"


Spot = tuple[str, Vector]  # a body, and a point of it from its reference


def common_places(bodies: list[BodyFacts], event: Event, instant: Instant) -> dict[str, Vector]:
    """Reference of each body from one common point: the axis of one that is held, else where they meet; of those whose place that tells."""
    spots = [(item, list(struck_places(item, instant))) for item in event.each()]
    held = next((body.name for body in bodies if body.motion.kind == "axis"), None)
    origin = {held: NOWHERE} if held else {name: tidy(-spot) for name, spot in spots[0][1][:1]}
    connections = instant.configuration.connections(instant.state)
    joints = [pair for item in connections for pair in shared_places(item.joint(), instant)]
    for item, own in spots:
        check_meeting(own, joints, item, instant)
    axes = [pair for item in connections for pair in shared_places(item.fixed_points(), instant)]
    return placed(origin, [*(pair for _, own in spots for pair in pairwise(own)), *joints, *axes])


def struck_places(event: Event, instant: Instant) -> Iterator[Spot]:
    """Where an event acts on each body."""
    for ref in event.points(instant.configuration.problem.connections):
        yield instant.host(ref.owner), event.spot(ref, instant)


def shared_places(points: tuple[PointRef, ...], instant: Instant) -> Iterator[tuple[Spot, Spot]]:
    """Points of bodies that are at one place, two by two."""
    bodies = instant.configuration.bodies
    yield from pairwise((instant.host(ref.owner), instant.point(ref)) for ref in points if ref.owner in bodies)


def placed(origin: dict[str, Vector], pairs: Sequence[tuple[Spot, Spot]]) -> dict[str, Vector]:
    """References of all bodies whose places follow from that of the first by points that are at one place."""
    found = dict(origin)
    while True:
        ways = (way for pair in pairs for way in (pair, pair[::-1]) if way[0][0] in found and way[1][0] not in found)
        told = next(ways, None)
        if told is None:
            return found
        (known, arm), (name, own) = told
        found[name] = tidy(found[known] + arm - own)


def check_meeting(spots: Sequence[Spot], joints: Sequence[tuple[Spot, Spot]], event: Event, instant: Instant) -> None:
    """Points of bodies that are hinged to each other can only meet where their places are one."""
    if len(spots) != 2 or spots[0][0] == spots[1][0]:
        return
    (one, arm), (other, own) = spots
    places = placed({one: NOWHERE}, joints)
    if other not in places:
        return
    gap, configuration = tidy(arm - places[other] - own), instant.configuration
    spare = gap.dot(gap) - CLOSE * (arm.dot(arm) + own.dot(own))
    if configuration.signs.by_numbers(spare) == 1:
        points = event.points(configuration.problem.connections)
        names = " and ".join(f"`{ref.owner}.{ref.point}`" if ref.point else f"`{ref.owner}`" for ref in points)
        message = f"{names} are not at one place at `{instant.state}`: they can not meet in `{event.name}`"
        raise Unsolvable(message, span=points[1].span)
