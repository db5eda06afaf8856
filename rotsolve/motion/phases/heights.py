"""Heights: how high a body is at both ends of a phase, from a level that stays, where geometry tells."""

from __future__ import annotations

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, negate
from rotsolve.core.vectors.heading import UP, heading
from rotsolve.elements.connections import Hinge
from rotsolve.elements.connections.connection import Orbit
from rotsolve.elements.connections.contacts.touch import Touch
from rotsolve.language.problem import PointRef
from rotsolve.motion.instant import Instant
from rotsolve.motion.phases.travels import displacement
from rotsolve.motion.timeline import Interval


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
    for item in configuration.connections(instant.state):
        if isinstance(item, Touch):
            ref, surface = item.pair()[0], configuration.surfaces.get(item.pair()[1].owner)
            if ref.owner == name and surface is not None and surface.word == "level":
                return negate(item.arm(instant).along(UP))
        if isinstance(item, Hinge) and len(item.hinge) == 2 and item.hinge[1].owner == name:
            carrier, own = item.hinge
            base = height_of_point(carrier, instant)
            return None if base is None else base - instant.point(own).along(UP)
    return None


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
