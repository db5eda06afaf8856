"""Places: where bodies and their points are along a direction that stays, by what they touch or hang from; and their ways in a phase."""

from __future__ import annotations

from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, Symbol, total
from rotsolve.core.vectors.heading import RIGHT, UP, Heading, Vector, heading
from rotsolve.motion.travels import displacement

if TYPE_CHECKING:
    from rotsolve.language.bodies import Orbit
    from rotsolve.language.problem import PointRef
    from rotsolve.motion.instant import Instant
    from rotsolve.motion.timeline import Interval

Ends = tuple[Formula, Formula]


def place_along(
    name: str, way: Heading, instant: Instant, *, ways: bool = True, seen: tuple[str, ...] = ()
) -> Formula | None:
    """How far along a direction the reference of a body is, r · e: of a pivot 0, else by what the body touches or hangs from.

    With `ways` also by how far it has travelled along its line since the first state; `seen` are the bodies on whose way it is looked for.
    """
    configuration = instant.configuration
    if configuration.pivot(name, instant.state) is not None:
        return ZERO
    orbit = instant.orbit(name)
    if orbit is not None:
        return place_on(orbit, name, way, instant)
    known = partial(place_of_point, way=way, instant=instant, ways=ways, seen=(*seen, name))
    told = (item.place(name, way, instant, known) for item in configuration.connections(instant.state))
    found = next((value for value in told if value is not None), None)
    line = instant.line(name)
    if found is None and line is not None and not configuration.laid(name):
        along = (line[0] - way).cos()
        if ways or along == ZERO:
            return instant.since_first("displacement", name) * along if along != ZERO else ZERO
    if found is None and way not in (RIGHT, UP):
        sides = [(place_along(name, axis, instant, ways=ways, seen=seen), (axis - way).cos()) for axis in (RIGHT, UP)]
        parts = [None if side is None else side * share for side, share in sides if share != ZERO]
        return None if None in parts else sum((part for part in parts if part is not None), start=ZERO)
    return found


def place_on(orbit: Orbit, name: str, way: Heading, instant: Instant) -> Formula | None:
    """On a circle ρ cos(φ − direction) from its centre; on a track of unknown profile the height has a letter of its own."""
    if orbit.radius is None:
        return instant.ask("height", name) if way == UP else None
    level = orbit.level if way == UP else ZERO
    along = orbit.radius * (heading(instant.place_on(orbit)) - way).cos()
    return simplify(level + along, order=instant.configuration.order)


def place_of_point(
    ref: PointRef, way: Heading, instant: Instant, *, ways: bool = True, seen: tuple[str, ...] = ()
) -> Formula | None:
    """How far along a direction a point of a body is, from the same origin."""
    if ref.owner not in instant.configuration.bodies or (name := instant.host(ref.owner)) in seen:
        return None
    reference = place_along(name, way, instant, ways=ways, seen=seen)
    return None if reference is None else reference + instant.point(ref).along(way)


def height(name: str, instant: Instant) -> Formula | None:
    """Height of the reference point above a level that stays; of what flies on from where that was known, by how far it has gone up."""
    found, before = place_along(name, UP, instant, ways=False), instant.configuration.timeline.before(instant.state)
    if found is not None or instant.generic or before is None or instant.motion(name).kind != "plane":
        return found
    first = replace(instant, state=before.start)
    base = height(name, first)
    if base is None or before.event is not None:
        return base
    return base + displacement(name, before, first, "y")


def ends_of(name: str, way: Heading, interval: Interval, first: Instant, last: Instant) -> Ends | None:
    """Places of a body's reference at both ends of a phase, along a direction; None where geometry does not tell."""
    line = first.line(name)
    straight = first.motion(name).kind == "line" and first.orbit(name) is None and not first.configuration.laid(name)
    link = straight and led_by_links(name, way, first)
    if straight and line is not None and not link:
        along = (line[0] - way).cos()
        return (ZERO, displacement(name, interval, first) * along if along != ZERO else ZERO)
    before, after = place_along(name, way, first), place_along(name, way, last)
    if before is None or after is None:
        return ends_on_side(name, way, interval, first)
    return (simplify(before), simplify(after)) if link else (before, after)


def ends_on_side(name: str, way: Heading, interval: Interval, first: Instant) -> Ends | None:
    """Places of what slides on a side of a body that travels, from where it begins, by how far it goes right and up; None of all else."""
    items = first.configuration.connections(first.state)
    if not any(item.lying() == name and item.slides_down(first) is not None for item in items):
        return None
    ways = [(displacement(name, interval, first, axis), (side - way).cos()) for axis, side in (("x", RIGHT), ("y", UP))]
    return ZERO, total([gone * share for gone, share in ways if share != ZERO])


def led_by_links(name: str, way: Heading, instant: Instant) -> bool:
    """Whether joints or slots tell where a body on a line is along that, by the angles of what they join it to: a slider on a rod."""
    known = partial(place_of_point, way=way, instant=instant, ways=False, seen=(name,))
    items = (item for item in instant.configuration.connections(instant.state) if item.guiding)
    return any(item.place(name, way, instant, known) is not None for item in items)


def way_by_links(name: str, interval: Interval, first: Instant, last: Instant) -> Ends | None:
    """The way of a body along its line in a phase, and what that is by the angles of what joints and slots join it to."""
    line = first.line(name)
    if line is None or first.motion(name).kind != "line" or first.orbit(name) is not None:
        return None
    if first.configuration.laid(name) or not led_by_links(name, line[0], first):
        return None
    ends = ends_of(name, line[0], interval, first, last)
    return None if ends is None else (displacement(name, interval, first), simplify(ends[1] - ends[0]))


def gone_along(name: str, way: Heading, interval: Interval, first: Instant, last: Instant) -> Formula | None:
    """How far a body's reference goes along x or y in a phase: by geometry, else as it moves freely; None where neither tells."""
    ends = ends_of(name, way, interval, first, last)
    if ends is not None:
        return ends[1] - ends[0]
    free = first.motion(name).kind == "plane" and way in (RIGHT, UP)
    return displacement(name, interval, first, "x" if way == RIGHT else "y") if free else None


def heights(name: str, interval: Interval, first: Instant, last: Instant) -> Ends | None:
    """Heights of a body's reference at both ends of a phase; 0 where nothing weighs."""
    return ends_of(name, UP, interval, first, last) if first.configuration.heavy else (ZERO, ZERO)


def carried_along(
    arm: Vector, name: str, middle: Instant, ends: tuple[Instant, Instant]
) -> tuple[Vector, Vector] | None:
    """Where a point that is fixed to a body is from the reference, at both ends of a phase; None where it does not turn with the body."""
    angle = middle.angle(name)
    if not isinstance(angle, Symbol) or any((angle, Fraction(1)) not in own.terms for _, own in arm.parts):
        return None
    angles = [moment.angle(name) for moment in ends]
    before, after = (arm.rotated(heading(end) - heading(angle)) for end in angles if end is not None)
    return before, after
