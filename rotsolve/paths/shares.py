"""Shares: what one body has of mass, momentum, angular momentum and energy, alone or as one of several that are joined."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import HALF, ZERO, Formula, total
from rotsolve.core.facts import BodyFacts, Motion, square
from rotsolve.core.vectors.heading import NOWHERE, Vector, unit
from rotsolve.language.problem import PointRef
from rotsolve.motion.rigid import centre_of_mass, mass_of, moment_about, pieces, tidy
from rotsolve.paths.meaning import NotYet

if TYPE_CHECKING:
    from rotsolve.motion.instant import Instant


class Share(Struct, frozen=True):
    """One body at one moment: its mass, where its centre of mass is from the reference of all that is joined to it, and how that moves.

    `moment` is its moment of inertia about the fixed axis, else about its own centre of mass; `along` its speed along what it slides on.
    """

    mass: Formula
    moment: Formula
    motion: Motion
    cm: Vector
    velocity: Vector
    acceleration: Vector
    along: Formula = ZERO

    @property
    def axial(self) -> bool:
        return self.motion.kind == "axis"

    @property
    def base(self) -> Vector:
        """The point about which `moment` is."""
        return NOWHERE if self.axial else self.cm

    def momentum(self) -> Vector:
        """m v."""
        return self.velocity.scaled(self.mass)

    def angular_momentum(self, point: Vector | None = None) -> Formula:
        """I ω + r × m v about a point, counterclockwise: about the axis, else the centre of mass, where none is told."""
        return self._about(point, self.motion.spin, self.velocity)

    def torque(self, point: Vector | None = None) -> Formula:
        """I α + r × m a: of all that acts on it, about a point."""
        return self._about(point, self.motion.spin_rate, self.acceleration)

    def _about(self, point: Vector | None, turning: Formula, moving: Vector) -> Formula:
        arm = NOWHERE if point is None else tidy(self.base - point)
        spin = self.moment * turning if ZERO not in (self.moment, turning) else ZERO
        return total([part for part in (arm.cross(moving.scaled(self.mass)), spin) if part != ZERO])

    def inertia(self, point: Vector) -> Formula:
        """I + m d² about a point: from the axis, else the centre of mass, by the parallel axes."""
        near, far = (tidy(self.cm - place) for place in (self.base, point))
        gained = simplify(far.dot(far) - near.dot(near))
        return self.moment if gained == ZERO else self.moment + self.mass * gained

    def translational(self) -> list[Formula]:
        """½ m v² of the centre of mass, part by part where the parts are at right angles."""
        parts = self.velocity.parts
        across = all((one - other).cos() == ZERO for (_, one), (_, other) in combinations(parts, 2))
        whole = [simplify(self.velocity.dot(self.velocity))]
        return [HALF * self.mass * item for item in ([square(size) for size, _ in parts] if across else whole)]

    def kinetic_energy(self) -> Formula:
        """½ I ω² about a fixed axis, else ½ m v² + ½ I ω²; what slides along another has that speed too."""
        ways = [HALF * self.mass * square(self.along)] if self.axial else self.translational()
        return total([term for term in (*ways, HALF * self.moment * square(self.motion.spin)) if term != ZERO])


def share_of(name: str, instant: Instant, facts: BodyFacts, *, whole: bool = False) -> Share:
    """The share of a body: all of the facts of what stands for it where it is not joined to another, or the `whole` is asked for."""
    motion = facts.motion
    if whole or not joined(name, instant):
        letter = facts.inertia.letter if facts.inertia is not None else ZERO
        return Share(facts.mass, letter, motion, facts.cm, facts.centre_velocity, facts.centre_acceleration)
    if facts.sweep is not None:
        raise NotYet(f"what `{name}` alone has on a turning shaft is not solved yet")
    body, order, ref = instant.body(name), instant.configuration.order, PointRef(name, "cm")
    items, mass, place = pieces(body), mass_of(body), instant.point(ref)
    own, _ = moment_about(items, centre_of_mass(items), order)
    moment = simplify(own + mass * place.dot(place), order=order) if motion.kind == "axis" else own
    along = instant.outward(name)
    velocity = instant.velocity(ref) + (unit(motion.orientation).times(along) if along != ZERO else NOWHERE)
    return Share(mass, moment, motion, place, velocity, instant.acceleration(ref), along)


def joined(name: str, instant: Instant) -> bool:
    """Whether a body moves as one with others, so that its own share has to be told apart."""
    return instant.host(name) != name or bool(instant.configuration.cluster(name, instant.state))


def place_about(about: PointRef, name: str, instant: Instant) -> Vector:
    """The point about which is asked, from the reference of all that is joined to a body: a point of one of these, the support that
    holds them, a point on the same axis, or of what the body meets in an event."""
    from rotsolve.motion.corners import refuse_untold

    configuration, host = instant.configuration, instant.host(name)
    support = configuration.connection(about.owner, instant.state)
    points = support.touches() if support is not None else (about,)
    named = [ref for ref in points if ref.owner in configuration.bodies]
    for ref in named:
        refuse_untold(ref, instant.state, configuration)
        if instant.host(ref.owner) == host:
            return instant.point(ref)
    for ref in named:
        other = instant.host(ref.owner)
        axes = [configuration.axis(item, instant.state) for item in (host, other)]
        if axes[0] and axes[0] == axes[1]:
            return instant.point(ref)
        meeting = meeting_point(host, other, instant)
        if meeting is not None:
            return meeting + instant.point(ref)
    help = f"name a point of `{name}`, or of what it meets in an event"
    raise NotYet(f"where `{name}` is, seen from `{about.owner}`, is not known", about.span, help)


def meeting_point(host: str, other: str, instant: Instant) -> Vector | None:
    """From the reference of a body to that of another that it meets in an event, as they stand then."""
    configuration = instant.configuration
    for interval in configuration.timeline.intervals:
        beside = interval.event is not None and instant.state in (interval.start, interval.end)
        for event in interval.event.each() if interval.event is not None and beside else ():
            refs = event.points(configuration.problem.connections)
            places = {instant.host(ref.owner): event.spot(ref, instant) for ref in refs}
            if host in places and other in places:
                return places[host] - places[other]
    return None


def named_last(owner: str, bodies: Sequence[str], instant: Instant) -> str:
    """Of the bodies on which an element acts, the one that it names last; none where it acts on none."""
    items = (item for item in instant.configuration.acting(instant.state) if item.name == owner)
    refs = [ref for item in items for ref in item.touches() if ref.owner in instant.configuration.bodies]
    named = [instant.host(ref.owner) for ref in refs]
    return next((name for name in reversed(named) if name in bodies), bodies[-1] if bodies else "")
