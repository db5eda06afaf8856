"""Contacts: a body on a surface, with or without friction, sliding or rolling."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import ZERO, Formula, call, negate
from rotsolve.core.directions import along_text, opposite
from rotsolve.core.facts import Force, Requirement, Rule, square
from rotsolve.core.heading import NOWHERE, RIGHT, Heading, Vector, unit, vector
from rotsolve.core.writing import spoken
from rotsolve.elements.connections.connection import Connection, Fact
from rotsolve.elements.rims import rim_radius
from rotsolve.elements.surfaces import Surface
from rotsolve.scene.keys import key
from rotsolve.scene.model import Body, PointRef

if TYPE_CHECKING:
    from rotsolve.motion.arrangement import Arrangement
    from rotsolve.motion.instant import Instant


@dataclass(frozen=True)
class Friction:
    """Friction of a contact: `none`, one coefficient, static and kinetic, or `any` (rough enough; the engine decides)."""

    kind: str = "none"  # none | coefficient | any
    static: Formula | None = None
    kinetic: Formula | None = None


@dataclass(frozen=True)
class Touch(Connection):
    """Base of contacts: a normal force, friction that sticks or slips, and the rule that goes with it."""

    def pair(self) -> tuple[PointRef, PointRef]:
        """The body's point and the surface."""
        raise NotImplementedError

    def grip(self) -> Friction:
        raise NotImplementedError

    def surface(self, arrangement: Arrangement) -> Surface | None:
        return arrangement.surfaces.get(self.pair()[1].owner)

    def track(self, body: Body, arrangement: Arrangement, state: str) -> tuple[Heading, str] | None:
        """A body that lies or rolls on a surface travels along it; one that leans on it with an end does not."""
        ref, surface = self.pair()[0], self.surface(arrangement)
        rims = ("bottom", "rim", "center", *(name for name, _ in (*body.radii, *getattr(body.shape, "radii", ()))))
        if ref.owner != body.name or surface is None or not (ref.point is None or ref.point in rims):
            return None
        return surface.travel(body.moves)

    def natural_turn(self, body: Body, arrangement: Arrangement, state: str) -> int:
        """Rolling: v + ω × r = 0 at the contact, so travel with the surface on its right turns a wheel clockwise."""
        track, surface = self.track(body, arrangement, state), self.surface(arrangement)
        if track is None or surface is None:
            return 0
        return -1 if (surface.normal - track[0]).degrees % 360 == 90 else 1

    def pace(self, arrangement: Arrangement, state: str) -> str:
        return "constant" if self.track(arrangement.bodies[self.pair()[0].owner], arrangement, state) else "position"

    def facts(self, instant: Instant) -> Iterator[Fact]:
        """The normal force, the rule that the body stays on the surface where its motion does not say so, and friction."""
        ref, surface = self.pair()[0], self.surface(instant.arrangement)
        name = instant.host(ref.owner)
        if surface is None or instant.mode(self.name) == "leaves":
            return
        arm, span = contact_arm(ref, surface, instant), instant.span(name)
        normal = instant.ask("normal_force", self.name, when=span)
        text = ("normal force ", normal, f", {away(surface)}")
        yield Force(self.name, "normal", name, normal, unit(surface.normal), arm, text, works=False, internal=True)
        yield Requirement(
            self.name,
            normal,
            ZERO,
            (normal, " ≥ 0: the surface can only push"),
            f"{spoken(ref.owner)} leaves the surface",
        )
        if self.course(instant) is None:
            label = f"{spoken(name)} stays on the {spoken(surface.name)}"
            kept = instant.point(PointRef(ref.owner, "center")) if instant.is_round(ref.owner) else arm
            yield slip_rule(self.name, label, name, kept, surface.normal, instant, linear=False)
        yield from self.friction_facts(instant, name, arm, surface, normal)

    def course(self, instant: Instant) -> Heading | None:
        """The body's line of travel where that runs along this surface."""
        surface, heading = self.surface(instant.arrangement), instant.motion(self.pair()[0].owner).heading
        along = surface is not None and heading is not None and (heading - surface.normal).cos() == ZERO
        return heading if along else None

    def forward(self, instant: Instant) -> Heading:
        """The way along the surface that counts as positive."""
        surface = self.surface(instant.arrangement)
        return self.course(instant) or (surface.normal.turned(-90) if surface is not None else RIGHT)

    def touching_velocity(self, instant: Instant) -> Vector:
        """Velocity of the body's touching point."""
        ref, surface = self.pair()[0], self.surface(instant.arrangement)
        return NOWHERE if surface is None else instant.motion(ref.owner).velocity_of(contact_arm(ref, surface, instant))

    def grip_rule(self, instant: Instant) -> Rule | None:
        """No slip at this moment, for a state that says `rolls` or `sticks`."""
        ref, surface = self.pair()[0], self.surface(instant.arrangement)
        if surface is None:
            return None
        name, arm = instant.host(ref.owner), contact_arm(ref, surface, instant)
        label = f"{spoken(name)} no longer slips"
        return slip_rule(self.name, label, name, arm, self.forward(instant), instant, linear=False)

    def friction_facts(
        self, instant: Instant, name: str, arm: Vector, surface: Surface, normal: Formula
    ) -> Iterator[Fact]:
        """Friction: none; sticking (a force as large as it takes, and no slip); or slipping (μ N against the slip)."""
        grip, mode, motion = self.grip(), instant.mode(self.name), instant.motion(name)
        if grip.kind == "none":
            return
        forward = self.forward(instant)
        ahead, back = travel_words(self.course(instant), surface, instant, name)
        span = instant.span(name)
        if mode.startswith("slips"):
            backward = mode.startswith("slips back")
            size = ((grip.static if mode.endswith("at most") else grip.kinetic) or ZERO) * normal
            against = forward if backward else forward.turned(180)
            text = ("kinetic friction ", size, f", {ahead if backward else back}")
            yield Force(self.name, "friction", name, size, unit(against), arm, text)
            return
        size = instant.ask("friction_force", self.name, when=span, words=(back, ahead))
        text = ("friction ", size, f", {back}")
        yield Force(self.name, "friction", name, size, unit(forward.turned(180)), arm, text, works=False, internal=True)
        rolling = motion.turns
        label = f"{spoken(name)} rolls without slipping" if rolling else f"{spoken(name)} does not slip"
        yield slip_rule(self.name, label, name, arm, forward, instant, linear=motion.kind == "line")
        if grip.static is not None:
            limit = grip.static * normal
            words = ("friction needed |", size, "| ≤ ", limit)
            yield Requirement(self.name, limit, call("abs", size), words, "slips")


def away(surface: Surface) -> str:
    """Direction of a surface's push in words."""
    return {"level": "up", "slope": "square to the slope"}.get(surface.word, "away from the wall")


def travel_words(direction: Heading | None, surface: Surface, instant: Instant, name: str) -> tuple[str, str]:
    """Words for the way along a surface that a body counts as positive, and for the other way."""

    if direction is None:
        words = along_text(surface.normal.turned(-90)) or "along the surface"
    else:
        line = instant.arrangement.line(name, instant.state)
        words = line[1] if line else along_text(direction)
    return words, opposite(words)


def contact_arm(ref: PointRef, surface: Surface, instant: Instant) -> Vector:
    """From the body's reference to where it touches: a wheel's rim towards the surface, a named point, or the body itself."""

    radius = rim_radius(instant.body(ref.owner), ref.point)
    if radius is not None and instant.is_round(ref.owner):
        centre = PointRef(ref.owner, "center")
        return instant.point(centre) + vector(radius, surface.normal.turned(180))
    if instant.motion(ref.owner).kind == "line" and not instant.motion(ref.owner).turns:
        return NOWHERE
    return instant.point(ref)


def slip_rule(
    owner: str, label: str, name: str, arm: Vector, direction: Heading, instant: Instant, *, linear: bool
) -> Rule:
    """The touching point does not move along a direction: travel of the centre on the left, turning on the right."""
    motion = instant.motion(name)
    turned, inward = arm.turned(90), arm.turned(180).times(square(motion.spin))
    turning = turned.times(motion.spin), turned.times(motion.spin_rate) + inward
    left = motion.velocity.along(direction), motion.acceleration.along(direction)
    right = tuple(negate(part.along(direction)) for part in turning)
    # the centripetal part of a rolling wheel's contact point is along the normal: a rule along the surface has none
    return Rule(owner, label, (name,), (left[0], right[0]), (left[1], right[1]), linear)


@dataclass(frozen=True)
class Contact(Touch):
    word = "contact"
    about = "a body lies on, slides along or rolls on a surface, or a wheel rubs on another: both on fixed axles"
    quantities = ("force", "normal_force", "friction_force", "friction", "torque", "angle", "work", "power", "impulse")
    words = ("rolls", "slips", "leaves", "sticks")
    contact: tuple[PointRef, ...] = key(
        "points", "[body, surface]", count=(2, 2), required=True, example="[block, ramp]"
    )
    friction: Friction = key(
        "friction",
        "`none`, a coefficient, {static: , kinetic: }, or `any`",
        default=Friction(),
        letter="mu",
        limits="nonnegative",
    )
    press: Formula | None = key(
        "quantity",
        "force that presses two wheels together at their rims",
        dimension="force",
        letter="F",
        limits="positive",
        default=None,
    )

    def pair(self) -> tuple[PointRef, PointRef]:
        return self.contact[0], self.contact[1]

    def grip(self) -> Friction:
        return self.friction


@dataclass(frozen=True)
class Rolls(Touch):
    word = "rolls"
    about = "a wheel rolls without slipping on a surface, or on several that join smoothly"
    quantities = ("force", "normal_force", "friction_force", "friction", "torque", "angle", "work", "power", "impulse")
    words = ("rolls", "slips", "leaves", "sticks")
    rolls: tuple[PointRef, ...] = key(
        "points", "[wheel, surface, …]", count=(2, 10), required=True, example="[ball, floor]"
    )

    def pair(self) -> tuple[PointRef, PointRef]:
        return self.rolls[0], self.rolls[1]

    def grip(self) -> Friction:
        return Friction("any")
