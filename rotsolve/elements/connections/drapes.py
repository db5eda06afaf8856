"""Drapes: a heavy rope over a wheel, a peg or the edge of a table, or wound on a drum.

All of the rope moves along itself with one speed, so it is one body that travels to the side on which its end goes down. Its weight
drives it by the parts that hang: m g b/L for the length b on the side of its travel, less that of the part on the other side.
"""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import PI, ZERO, Formula, negate, total
from rotsolve.core.facts import (
    GRIP,
    HANGING,
    REACHES,
    REACTION,
    TAUT,
    TENSION,
    Force,
    Potential,
    Requirement,
    Rule,
    square,
)
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import DOWN, LEFT, NOWHERE, RIGHT, UP, Heading, unit, vector
from rotsolve.core.writing import spoken
from rotsolve.elements.connections.lying import is_level
from rotsolve.elements.shapes import rim_radius
from rotsolve.elements.shapes.thin import Rope
from rotsolve.language.bodies import Body, PointRef
from rotsolve.language.elements import Connection, Fact, Moment, Surroundings
from rotsolve.language.keys import key


class Drapes(Connection, frozen=True):
    """A rope on what carries it, and the body that is tied to its end, if there is one."""

    word = "drapes"
    about = (
        "a heavy rope over a wheel (it does not slip), a small smooth peg (`ground`) or the edge of a smooth table, "
        "or wound on a drum; a third body is tied to its hanging end"
    )
    quantities = ("length", "tension")
    kept = ("length",)
    drapes: tuple[PointRef, ...] = key(
        "points",
        "[rope, what carries it], and what is tied to its end",
        count=(2, 3),
        required=True,
        example="[rope, pulley]",
    )
    wound: bool = key("flag", "the rest of the rope is wound on the wheel and does not hang", default=False)

    def on_rims(self, scene: Surroundings) -> tuple[PointRef, ...]:
        return self.drapes[1:2]

    def ropes(self) -> tuple[PointRef, ...]:
        return self.drapes[:1]

    def check(self, scene: Surroundings) -> None:
        """It hangs over a wheel on an axle, a peg or a level table."""
        rope, over, *_ = self.drapes
        turning = {ref.owner for item in scene.problem.connections if item.axial for ref in item.touches()}
        if not (over.owner in turning if over.owner in scene.bodies else is_level(over.owner, scene)):
            help = "it hangs over a wheel on an `axle`, a smooth peg (`ground`) or the edge of a level table"
            raise Unsolvable(f"`{rope.owner}` can not hang over `{over.owner}`", span=over.span, help=help)

    def track(self, body: Body, configuration: Surroundings, state: str) -> tuple[Heading, str] | None:
        """The rope travels to the side where it runs down: right, or left where its body says so."""
        if body.name != self.drapes[0].owner:
            return None
        return (LEFT, "left") if body.moves == "left" else (RIGHT, "right")

    def hangs(self, body: Body) -> bool:
        return any(ref.owner == body.name for ref in self.drapes[2:])

    def weighs(self, body: Body) -> bool:
        return body.name == self.drapes[0].owner

    def natural_turn(self, body: Body, configuration: Surroundings, state: str) -> int:
        """A rope that goes over to the right turns its wheel clockwise."""
        if body.name != self.drapes[1].owner:
            return 0
        return 1 if configuration.bodies[self.drapes[0].owner].moves == "left" else -1

    def pace(self, configuration: Surroundings, state: str) -> str:
        return "position"

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """The weights of the parts that hang, the energy that they store, the grip of a wheel, the pull of what is tied on."""
        hanging = instant.ask("length", self.name, letter="x")
        rest = self.other_length(hanging, instant)
        if rest != ZERO:
            kept, otherwise = "the rope still reaches back", "the rope's other end has run off"
            yield Requirement(self.name, REACHES, rest, ZERO, kept, otherwise)
        if instant.configuration.heavy:
            yield from self.weights(hanging, rest, instant)
        if self.drapes[1].owner in instant.configuration.bodies:
            yield from self.grip(instant)
        for load in self.drapes[2:]:
            yield from self.tied(load, instant)

    def rope(self, instant: Moment) -> Body:
        return instant.body(self.drapes[0].owner)

    def heading(self, instant: Moment) -> tuple[Heading, str]:
        track = self.track(self.rope(instant), instant.configuration, instant.state)
        assert track is not None
        return track

    def other_length(self, hanging: Formula, instant: Moment) -> Formula:
        """What neither hangs on the side of the travel nor lies on the rim: L − b − π R."""
        shape, over = self.rope(instant).shape, self.drapes[1]
        length = shape.length if isinstance(shape, Rope) and shape.length is not None else ZERO
        rest = length - hanging
        if not self.wound and over.owner in instant.configuration.bodies:
            rest = rest - PI * (rim_radius(instant.body(over.owner), over.point) or ZERO)
        return simplify(rest, order=instant.configuration.order)

    def weights(self, hanging: Formula, rest: Formula, instant: Moment) -> Iterator[Fact]:
        """λ g b forward and λ g a back, with the energies −½ λ g b² and −½ λ g a² below the top."""
        rope, forward = self.rope(instant), self.heading(instant)[0]
        shape, gravity = rope.shape, instant.configuration.problem.gravity or ZERO
        assert isinstance(shape, Rope) and shape.length is not None
        over = self.drapes[1].owner
        lies = self.wound or (over in instant.configuration.surfaces and over != "ground")
        parts = [(hanging, forward, "of the part that hangs", "forward")]
        if not lies:
            parts.append((rest, forward.turned(180), "of the part on the other side", "back"))
        whole, weight = shape.length, (rope.mass or ZERO) * gravity
        for length, direction, part, way in parts:
            size = weight * length / whole
            yield Force(self.name, HANGING, rope.name, size, unit(direction), NOWHERE, "weight", way, part)
        energies = [weight * x / 2 if x == whole else weight * square(x) / (2 * whole) for x, *_ in parts]
        energy = negate(total(energies))
        rate = instant.motion(rope.name).velocity.along(forward)
        words = ("hanging rope ", energy)
        label = "the hanging part grows by what the rope moves"
        yield Potential(self.name, energy, hanging, rate, (rope.name,), words, label)

    def grip(self, instant: Moment) -> Iterator[Fact]:
        """The wheel's rim goes with the rope: its grip pulls the rope back and the rim on; how the rope presses is left open."""
        rope, over = self.rope(instant).name, self.drapes[1]
        forward, side = self.heading(instant)
        wheel, radius = instant.host(over.owner), rim_radius(instant.body(over.owner), over.point) or ZERO
        top, span = vector(radius, UP), instant.span(rope)
        size = instant.ask("force", self.name, when=span)
        back = unit(forward.turned(180))
        yield Force(self.name, GRIP, rope, size, back, NOWHERE, "grip of the rim", "back", internal=True)
        noun, way = "grip of the rope", f"along the rim to the {side}"
        yield Force(self.name, GRIP, wheel, size, unit(forward), top, noun, way, internal=True)
        for axis, direction in (("x", RIGHT), ("y", DOWN)):
            press = instant.ask("force", self.name, when=span, component=axis)
            noun = "press of the rope"
            yield Force(self.name, REACTION, wheel, press, unit(direction), NOWHERE, noun, internal=True)
        own, rim = instant.motion(rope), instant.motion(wheel)
        velocity = (own.velocity.along(forward), rim.velocity_of(top).along(forward))
        acceleration = (own.acceleration.along(forward), rim.acceleration_of(top).along(forward))
        label = f"the rope does not slip, {spoken(wheel)}"
        yield Rule(self.name, label, (rope, wheel), velocity, acceleration)

    def tied(self, load: PointRef, instant: Moment) -> Iterator[Fact]:
        """A body at the end of the rope goes down as fast as the rope goes on."""
        rope, name = self.rope(instant).name, instant.host(load.owner)
        forward = self.heading(instant)[0]
        size = instant.ask("tension", self.name, when=instant.span(rope))
        yield Requirement(self.name, TAUT, size, ZERO, "the rope stays taut", "the rope goes slack")
        yield Force(self.name, TENSION, name, size, unit(UP), NOWHERE, "tension", "up", internal=True)
        noun = "tension of its end"
        yield Force(self.name, TENSION, rope, size, unit(forward), NOWHERE, noun, "forward", internal=True)
        own, hung = instant.motion(rope), instant.motion(name)
        velocity = (hung.velocity.along(DOWN), own.velocity.along(forward))
        acceleration = (hung.acceleration.along(DOWN), own.acceleration.along(forward))
        label = f"the rope does not stretch, {spoken(name)}"
        yield Rule(self.name, label, (rope, name), velocity, acceleration)
