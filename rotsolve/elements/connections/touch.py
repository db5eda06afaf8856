"""Touch: a body on a surface or on another body: where they touch, the push of the one on the other, and friction between them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, ClassVar

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, add, call, negate
from rotsolve.core.facts import FRICTION, GRIPS, NORMAL, TOUCHES, Force, Requirement, Rule, square
from rotsolve.core.vectors.directions import TURNS, along_text, opposite
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, Heading, Vector, heading, unit, vector
from rotsolve.core.writing import spoken
from rotsolve.elements.connections.connection import Connection, Fact, Orbit
from rotsolve.elements.rims import rim_radius
from rotsolve.elements.surfaces import Curved, Level, Surface
from rotsolve.language.problem import Body, PointRef

if TYPE_CHECKING:
    from rotsolve.motion.configuration import Configuration
    from rotsolve.motion.instant import Instant


class Friction(Struct, frozen=True):
    """Friction of a contact: `none`, one coefficient, static and kinetic, or `any` (rough enough; the engine decides)."""

    kind: str = "none"  # none | coefficient | any
    static: Formula | None = None
    kinetic: Formula | None = None


class Touch(Connection, frozen=True):
    """Base of contacts: a normal force, friction that sticks or slips, and the rule that goes with it."""

    quantities: ClassVar[tuple[str, ...]] = (
        "force",
        "normal_force",
        "friction_force",
        "friction",
        "torque",
        "angle",
        "work",
        "power",
        "impulse",
    )
    words: ClassVar[tuple[str, ...]] = ("rolls", "slips", "leaves", "sticks")

    def pair(self) -> tuple[PointRef, ...]:
        """The body's point and the surface, or the surfaces that join smoothly."""
        raise NotImplementedError

    def grip(self) -> Friction:
        raise NotImplementedError

    def places(self) -> tuple[PointRef, ...]:
        """The surfaces on which the body may be, in the order in which they join."""
        return self.pair()[1:]

    def carrier(self, configuration: Configuration) -> str:
        """The body on which it lies or rolls; '' for what does not move."""
        ref = self.places()[0]
        return ref.owner if ref.owner in configuration.bodies else ""

    def surface(self, configuration: Configuration, state: str) -> Surface | None:
        """The surface on which the body is: of several the curved one where the state speaks of the contact's angle; the back of
        another body lies as that on which it travels."""
        carrier = self.carrier(configuration)
        if carrier:
            below = supporting(carrier, configuration, state)
            return replace(below, name=carrier) if below is not None else Level(carrier)
        found = [surface for ref in self.places() if (surface := configuration.surfaces.get(ref.owner)) is not None]
        bent = [surface for surface in found if isinstance(surface, Curved) and surface.radius() is not None]
        if len(found) > 1 and bent and configuration.mentions.says(state, self.name, "angle", "leaves"):
            return bent[0]
        return found[0] if found else None

    def rests(self, body: Body) -> bool:
        """Whether a body lies or rolls on the surface; one that leans on it with an end does not."""
        ref = self.pair()[0]
        rims = ("bottom", "rim", "center", *(name for name, _ in (*body.radii, *getattr(body.shape, "radii", ()))))
        return ref.owner == body.name and (ref.point is None or ref.point in rims)

    def track(self, body: Body, configuration: Configuration, state: str) -> tuple[Heading, str] | None:
        """A body that lies or rolls on a flat surface travels along it."""
        surface = self.surface(configuration, state) if self.rests(body) else None
        if surface is None or isinstance(surface, Curved):
            return None
        return surface.travel(body.moves)

    def orbit(self, body: Body, configuration: Configuration, state: str) -> Orbit | None:
        """On a curved surface the centre of a body moves on a circle; a particle is its own centre."""
        surface = self.surface(configuration, state)
        if not isinstance(surface, Curved) or not self.rests(body):
            return None
        radius = surface.circle(rim_radius(body, self.pair()[0].point) or ZERO)
        way, level = surface.way(body.moves), ZERO if radius is None else surface.level(radius)
        turn = "forward along" if radius is None else "counterclockwise round" if way > 0 else "clockwise round"
        return Orbit(self.name, radius, level, way, f"{turn} the {spoken(surface.name)}")

    def angle(self, instant: Instant) -> Formula:
        """Angle of the touching radius of a curved surface; for a wheel on the floor the place of a corner settles it."""
        ref, surface = self.pair()[0], self.surface(instant.configuration, instant.state)
        rim = rim_radius(instant.body(ref.owner), ref.point)
        if isinstance(surface, Curved) and rim is not None and instant.orbit(ref.owner) is None:
            met = surface.met(rim)
            if met is not None:
                return met
        return instant.ask("angle", self.name, words=TURNS)

    def normal(self, surface: Surface, instant: Instant) -> Heading:
        """Direction out of the surface where the body touches it."""
        return surface.facing(heading(self.angle(instant))) if isinstance(surface, Curved) else surface.normal

    def natural_turn(self, body: Body, configuration: Configuration, state: str) -> int:
        """Rolling: v + ω × r = 0 at the contact, so travel with the surface on its right turns a wheel clockwise."""
        track, surface = self.track(body, configuration, state), self.surface(configuration, state)
        orbit = self.orbit(body, configuration, state)
        if orbit is not None and isinstance(surface, Curved):
            return orbit.way if surface.outside else -orbit.way
        if track is None or surface is None:
            return 0
        return -1 if (surface.normal - track[0]).degrees % 360 == 90 else 1

    def pace(self, configuration: Configuration, state: str) -> str:
        return (
            "constant" if self.track(configuration.bodies[self.pair()[0].owner], configuration, state) else "position"
        )

    def facts(self, instant: Instant) -> Iterator[Fact]:
        """The normal force, the rule that the body stays on the surface where its motion does not say so, and friction."""
        ref, surface = self.pair()[0], self.surface(instant.configuration, instant.state)
        name = instant.host(ref.owner)
        if surface is None:
            return
        facing = self.normal(surface, instant)
        arm, span = contact_arm(ref, facing, instant), instant.span(name)
        normal = instant.ask("normal_force", self.name, when=span)
        if isinstance(surface, Curved) and surface.radius() is None:  # a push that no law tells
            yield from self.friction_facts(instant, name, arm, surface, normal)
            return
        push, way = unit(facing), away(surface)
        force = Force(self.name, NORMAL, name, normal, push, arm, "normal force", way, works=False, internal=True)
        yield from self.both(force, instant, "push", into(surface), ref.owner)
        kept, otherwise = f"{spoken(self.name)} keeps contact", f"{spoken(ref.owner)} leaves the surface"
        yield Requirement(self.name, TOUCHES, normal, ZERO, kept, otherwise)
        if self.course(instant) is None:
            label = f"{spoken(name)} stays on the {spoken(surface.name)}"
            point = instant.point(PointRef(ref.owner, "center")) if instant.is_round(ref.owner) else arm
            yield self.no_slip(label, point, facing, instant, linear=False)
        yield from self.friction_facts(instant, name, arm, surface, normal)

    def arm(self, instant: Instant) -> Vector:
        """From the body's reference to its touching point."""
        surface = self.surface(instant.configuration, instant.state)
        return NOWHERE if surface is None else contact_arm(self.pair()[0], self.normal(surface, instant), instant)

    def course(self, instant: Instant) -> Heading | None:
        """The body's line of travel where that runs along this surface."""
        surface = self.surface(instant.configuration, instant.state)
        ahead = instant.motion(self.pair()[0].owner).heading
        along = surface is not None and ahead is not None and (ahead - self.normal(surface, instant)).cos() == ZERO
        return ahead if along else None

    def forward(self, instant: Instant) -> Heading:
        """The way along the surface that counts as positive: that of the body's travel, else with the surface on its right."""
        surface = self.surface(instant.configuration, instant.state)
        return self.course(instant) or (RIGHT if surface is None else self.normal(surface, instant).turned(-90))

    def touching_velocity(self, instant: Instant) -> Vector:
        """Velocity of the body's touching point, relative to what it lies on."""
        return instant.motion(self.pair()[0].owner).velocity_of(self.arm(instant)) - self.ground(instant)[0]

    def ground(self, instant: Instant) -> tuple[Vector, Vector]:
        """Velocity and acceleration of what it lies on."""
        carrier = self.carrier(instant.configuration)
        if not carrier:
            return NOWHERE, NOWHERE
        motion = instant.motion(carrier)
        return motion.velocity, motion.acceleration

    def grip_rule(self, instant: Instant) -> Rule | None:
        """No slip at this moment, for a state that says `rolls` or `sticks`."""
        ref, surface = self.pair()[0], self.surface(instant.configuration, instant.state)
        if surface is None:
            return None
        name, arm = instant.host(ref.owner), contact_arm(ref, self.normal(surface, instant), instant)
        label = f"{spoken(name)} no longer slips"
        return self.no_slip(label, arm, self.forward(instant), instant, linear=False)

    def no_slip(self, label: str, arm: Vector, direction: Heading, instant: Instant, *, linear: bool) -> Rule:
        """The touching point does not move along a direction on what it touches: travel of the centre on the left."""
        name, carrier = instant.host(self.pair()[0].owner), self.carrier(instant.configuration)
        motion = instant.motion(name)
        turned, inward = arm.turned(90), arm.turned(180).times(square(motion.spin))
        turning = turned.times(motion.spin), turned.times(motion.spin_rate) + inward
        left = motion.velocity.along(direction), motion.acceleration.along(direction)
        # the centripetal part of a rolling wheel's contact point is along the normal: a rule along the surface has none
        right = tuple(
            add(moving.along(direction), negate(part.along(direction)))
            for part, moving in zip(turning, self.ground(instant), strict=True)
        )
        bodies = (name, instant.host(carrier)) if carrier else (name,)
        return Rule(self.name, label, bodies, (left[0], right[0]), (left[1], right[1]), linear)

    def friction_facts(
        self, instant: Instant, name: str, arm: Vector, surface: Surface, normal: Formula
    ) -> Iterator[Fact]:
        """Friction: none; sticking (a force as large as it takes, and no slip); or slipping (μ N against the slip)."""
        grip, mode, motion = self.grip(), instant.mode(self.name), instant.motion(name)
        if grip.kind == "none":
            return
        forward = self.forward(instant)
        ahead, back = travel_words(forward, self.course(instant), instant, name)
        span = instant.span(name)
        if mode.startswith("slips"):
            backward = mode.startswith("slips back")
            size = ((grip.static if mode.endswith("at most") else grip.kinetic) or ZERO) * normal
            way = forward if backward else forward.turned(180)
            ways = (ahead, back) if backward else (back, ahead)
            force = Force(self.name, FRICTION, name, size, unit(way), arm, "kinetic friction", ways[0])
            yield from self.both(force, instant, force.noun, ways[1], name)
            return
        size = instant.ask("friction_force", self.name, when=span, words=(back, ahead))
        against = unit(forward.turned(180))
        force = Force(self.name, FRICTION, name, size, against, arm, "friction", back, works=False, internal=True)
        yield from self.both(force, instant, force.noun, ahead, name)
        rolling = motion.turns and instant.is_round(name)
        label = f"{spoken(name)} rolls without slipping" if rolling else f"{spoken(name)} does not slip"
        yield self.no_slip(label, arm, forward, instant, linear=motion.kind == "line")
        if grip.static is not None:
            yield Requirement(self.name, GRIPS, grip.static * normal, call("abs", size), "", "slips")

    def both(self, force: Force, instant: Instant, noun: str, way: str, of: str) -> Iterator[Force]:
        """A force on the body, and that by which it acts back on the body that carries it."""
        yield force
        carrier = self.carrier(instant.configuration)
        if carrier:
            host, back = instant.host(carrier), -force.direction
            place = f"of {spoken(of)}"
            yield replace(force, body=host, direction=back, arm=NOWHERE, noun=noun, way=way, place=place)


def supporting(name: str, configuration: Configuration, state: str) -> Surface | None:
    """The flat surface along which a body travels."""
    for item in configuration.connections(state):
        if isinstance(item, Touch) and item.track(configuration.bodies[name], configuration, state) is not None:
            return item.surface(configuration, state)
    return None


def into(surface: Surface) -> str:
    """Direction in which something presses on a surface, in words."""
    return "down" if surface.word == "level" else "into the slope"


def away(surface: Surface) -> str:
    """Direction of a surface's push in words."""
    words = {"level": "up", "slope": "perpendicular to the slope", "dome": "outward", "hollow": "towards the centre"}
    return words.get(surface.word, f"away from the {spoken(surface.word)}")


def travel_words(forward: Heading, path: Heading | None, instant: Instant, name: str) -> tuple[str, str]:
    """Words for the way along a surface that counts as positive, and for the other way; `path` is that of the body's travel."""
    if path is None or forward != path:
        words = along_text(forward) or "along the surface"
    else:
        line = instant.line(name)
        words = line[1] if line else along_text(forward)
    return words, opposite(words)


def contact_arm(ref: PointRef, facing: Heading, instant: Instant) -> Vector:
    """From the body's reference to where it touches: a wheel's rim towards the surface, a named point, or the body itself."""
    radius = rim_radius(instant.body(ref.owner), ref.point)
    if radius is not None and instant.is_round(ref.owner):
        centre = PointRef(ref.owner, "center")
        return instant.point(centre) + vector(radius, facing.turned(180))
    if instant.motion(ref.owner).kind == "line" and not instant.motion(ref.owner).turns:
        return NOWHERE
    return instant.point(ref)
