"""Springs and torsion springs."""

from __future__ import annotations

from collections.abc import Container, Iterator

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import HALF, ZERO, Formula, add, negate
from rotsolve.core.facts import SPRING, TORSION, Couple, Force, Potential, square
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import DOWN, LEFT, RIGHT, UP, Heading, Vector, along_text, unit
from rotsolve.elements.connections.places import between, distance, gap_between, rightward
from rotsolve.elements.shapes import shape_of, taken_round
from rotsolve.language.bodies import Body, PointRef, Ride
from rotsolve.language.elements import Connection, Fact, LetterMaker, Moment, Surroundings
from rotsolve.language.keys import amount, key

WAYS = {"left": LEFT, "right": RIGHT, "up": UP, "down": DOWN}


class Spring(Connection, frozen=True):
    word = "spring"
    at_points = True
    about = "an ideal spring between two points"
    quantities = ("force", "elongation", "potential_energy", "work", "power", "length", "stiffness")
    kept = ("elongation", "force")
    instead = "at one moment a spring pulls with k x along it: `actions: {pull: {force: k*x, on: BODY.P, direction: [x, y, z]}}`"
    spring: tuple[PointRef, ...] = key("points", "its two ends", count=(2, 2), required=True, example="[ground, block]")
    stiffness: Formula | None = amount("stiffness", "stiffness", "k", "positive", default=None)
    rest_length: Formula | None = amount("length without force", "length", "L", "nonnegative", default=None)
    direction: str | None = key(
        "choice", "which way a long one runs, from its first end to its second", choices=("left", "right", "up", "down")
    )

    def check(self, scene: Surroundings) -> None:
        """One from a place ends at a hinged body, whose hinge is the origin, and its rest length tells how it is stretched; so that of what
        slides freely, which no direction that stays tells."""
        ride = next((ride for item in scene.problem.connections if (ride := self.slides(item.ride()))), None)
        if ride is not None and self.rest_length is None:
            message = f"`{self.name}` holds `{ride.rider.owner}`, which slides: give its `rest_length`"
            raise Unsolvable(message, span=self.spring[0].span, help="how long it is without force")
        if self.direction is not None and (self.placed or ride is not None):
            message = f"`{self.name}` runs from one of its ends to the other, whose places tell its direction"
            raise Unsolvable(message, span=self.spring[0].span, help="leave out `direction`")
        for ref in self.spring if self.placed else ():
            led = ref.owner in scene.bodies and self.led(scene.bodies[ref.owner])
            if ref.place is None and ref.owner not in scene.held and ride is None and not led:
                help = "solved are springs from a place to a hinged body, its hinge at [0, 0], or to a particle that `moves`"
                raise Unsolvable(f"where `{ref.owner}` is in the scene is not told", span=ref.span, help=help)
        if self.placed and self.rest_length is None:
            help = "a given that is `unknown` where a state tells how far it is stretched"
            message = f"`{self.name}` runs from a place: give its `rest_length`"
            raise Unsolvable(message, span=self.spring[0].span, help=help)

    def led(self, body: Body) -> bool:
        """Whether a body is a particle on a line that it tells, as a collar on its guide."""
        return body.moves is not None and shape_of(body).pointlike and not body.parts

    def hangs(self, body: Body) -> bool:
        return not self.placed and any(ref.owner == body.name and ref.point in (None, "center") for ref in self.spring)

    def pace(self, configuration: Surroundings, state: str) -> str:
        return "position"

    def leans(self, configuration: Surroundings, state: str) -> tuple[str, ...]:
        return taken_round(self.spring, configuration, state)

    def facts(self, instant: Moment) -> Iterator[Fact]:
        first, second = self.ends(instant)
        along, elongation = self.along(instant), self.elongation(instant)
        stiffness, bodies = self.stiffness, instant.configuration.bodies
        size = instant.ask("force", self.name) if stiffness is None else stiffness * elongation
        for ref, push in ((first, along), (second, -along)):
            if ref.owner in bodies:
                name, arm = instant.host(ref.owner), instant.point(ref)
                way = (along_text(push.parts[0][1]) if len(push.parts) == 1 else "") or "along the spring"
                yield Force(self.name, SPRING, name, size, push, arm, "spring force", way)
        if stiffness is not None:
            rate = instant.velocity(second).dot(along) - instant.velocity(first).dot(along)
            energy = HALF * stiffness * square(elongation)
            owners = tuple(ref.owner for ref in self.spring if ref.owner in bodies)
            yield Potential(self.name, energy, elongation, rate, owners, ("spring ", energy), placed=self.told(instant))

    def slides(self, ride: Ride | None) -> Ride | None:
        """What slides freely along a body, where one end is on it."""
        ends = [ref.owner for ref in self.spring]
        return ride if ride is not None and ride.free and ride.rider.owner in ends else None

    def sliding(self, instant: Moment) -> frozenset[str]:
        """The bodies at its ends that slide freely along others."""
        rides = (self.slides(item.ride()) for item in instant.configuration.connections(instant.state))
        return frozenset(ride.rider.owner for ride in rides if ride is not None)

    def ends(self, instant: Moment) -> tuple[PointRef, PointRef]:
        """Its two ends: of what slides the particle itself."""
        free = self.sliding(instant)
        first, second = (replace(ref, point="cm") if ref.owner in free else ref for ref in self.spring)
        return first, second

    def told(self, instant: Moment) -> bool:
        """Whether the places of its ends tell its length."""
        return self.placed or bool(self.sliding(instant))

    @property
    def placed(self) -> bool:
        """Whether it runs from a place in the scene."""
        return any(ref.place is not None for ref in self.spring)

    def elongation(self, instant: Moment) -> Formula:
        """The letter for how far it is stretched, or its length by the places of its ends, less the rest length."""
        gap = gap_between(*self.ends(instant), instant) if self.told(instant) else None
        if gap is None or self.rest_length is None:
            return instant.ask("elongation", self.name)
        return add(distance(gap, instant), negate(self.rest_length))

    def along(self, instant: Moment) -> Vector:
        """Unit vector from the first end to the second: as is said, or where they are, if a place is named; from a wall out of it; else
        from left to right along a level or sloping line of travel of one of them, up from the ground, down from the ceiling, of two bodies
        down."""
        configuration = instant.configuration
        straight = between(*self.ends(instant), instant) if self.told(instant) else None
        if straight is not None:
            return straight
        if self.direction is not None:
            return unit(WAYS[self.direction])
        anchor, body = self.spring if self.spring[0].owner not in configuration.bodies else self.spring[::-1]
        lines = ((self.travel(ref, instant), ref) for ref in (body, anchor))
        line, ref = next((found for found in lines if found[0] is not None), (None, body))
        right = None if line is None else rightward(line, ref, instant)
        surface = configuration.surfaces.get(anchor.owner)
        if surface is not None and surface.upright:
            outward = surface.normal if right is None else right if surface.normal == RIGHT else right.turned(180)
        elif right is not None:
            return unit(right)
        else:
            outward = DOWN if surface is None and anchor.owner == "ceiling" else UP
        return unit(outward if anchor is self.spring[0] else outward.turned(180))

    def travel(self, ref: PointRef, instant: Moment) -> Heading | None:
        """The line along which an end travels: its body's own, or at the middle of what another body carries the line of that."""
        configuration = instant.configuration
        if ref.owner not in configuration.bodies:
            return None
        own = instant.line(instant.host(ref.owner))
        middle = ref.point in (None, "rim", "center")
        found = instant.line(configuration.mover(ref.owner, instant.state)) if own is None and middle else own
        return None if found is None else found[0]


class Torsion(Connection, frozen=True):
    word = "torsion"
    about = "a torsion spring or wire that turns a body back"
    quantities = ("torque", "potential_energy", "work", "power", "angle")
    instead = (
        "at one moment, of a body on a hinge along x with `BODY.angle: theta`, it gives the couple −K θ:"
        " `actions: {wire: {couple: [-K*theta, 0, 0], on: BODY}}`"
    )
    torsion: tuple[PointRef, ...] = key(
        "points", "the body, or two bodies", count=(1, 2), required=True, example="disc"
    )
    stiffness: Formula | None = amount("torque per angle", "torsional stiffness", "kappa", "positive", default=None)
    rest_angle: Formula | None = amount("angle without torque, 0 where none is told", "angle", "theta", default=None)

    def completed(self, letters: LetterMaker, held: Container[str]) -> Connection:
        """It always has a stiffness; that of an ordinary spring may be told by its force."""
        if self.stiffness is not None:
            return self
        return replace(self, stiffness=letters.make("kappa", self.name, "torsional stiffness"))

    def pace(self, configuration: Surroundings, state: str) -> str:
        return "position"

    def winds(self) -> tuple[PointRef, ...]:
        return self.torsion

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """Torque −κ (θ − θ₀) on the last-named body, the opposite on the other."""
        own = [ref.owner for ref in self.torsion if ref.owner in instant.configuration.bodies]
        names = [instant.host(name) for name in own]
        last = names[-1]
        twist = instant.angle_of(own[-1])
        if len(names) == 2:
            twist = twist - instant.angle_of(own[0])
        if self.rest_angle is not None:
            twist = simplify(twist - self.rest_angle)
        stiffness = self.stiffness if self.stiffness is not None else ZERO
        torque = stiffness * twist
        yield Couple(self.name, TORSION, last, negate(torque), "torsion torque", torque, "turning it back")
        if len(names) == 2:
            yield Couple(self.name, TORSION, names[0], torque, "torsion torque", torque)
        rate = instant.motion(last).spin - (instant.motion(names[0]).spin if len(names) == 2 else ZERO)
        energy = HALF * stiffness * square(twist)
        yield Potential(self.name, energy, twist, rate, tuple(names), ("torsion spring ", energy))
