"""Events: what happens in no time between two states."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rotsolve.algebra.formula import ZERO, Formula, negate
from rotsolve.core.derivation import Words, direction_in_words
from rotsolve.core.facts import BLOW, CONTACT, BodyFacts, Couple, Force
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import RIGHT, Direction, Vector, pointing, unit
from rotsolve.core.writing import and_joined, spoken
from rotsolve.elements.actions import SQUARE, across, aimed, turn_sense
from rotsolve.elements.collisions import called, whereabouts
from rotsolve.elements.connections.supports import GROUND, Axis, Hinge
from rotsolve.elements.connections.touch import Touch
from rotsolve.elements.shapes import rim_radius
from rotsolve.language.bodies import Joint, PointRef, Surface
from rotsolve.language.elements import Connection, Event, Moment, Surroundings
from rotsolve.language.keys import amount, key

AFTERWARDS = "begin a scene of its own with what is left then, and with how it stands and moves"


class Joins(Event, frozen=True):
    word = "joins"
    at_points = True
    bodily = True
    about = "two bodies meet and stay together (inelastic)"
    heats = True
    quantities = ("impulse", "angular_impulse")
    spatial = True
    joins: tuple[PointRef, ...] = key(
        "points", "the two bodies, or points of them", count=(2, 2), required=True, example="[putty, beam.end]"
    )

    def points(self, connections: Sequence[Connection]) -> tuple[PointRef, ...]:
        return self.joins

    def told(self) -> Words:
        one, other = map(whereabouts, self.joins)
        return (*one, " and ", *other, " stay together")

    def joined(self) -> tuple[PointRef, ...]:
        return self.joins

    def twists(self, body: str, instant: Moment) -> tuple[Couple, ...]:
        """Bodies that stick together also twist each other until they turn as one; a particle has nothing to be turned by."""
        owners = [instant.host(ref.owner) for ref in self.joins]
        if body not in owners or any(instant.weightless(name) for name in owners):
            return ()
        size = instant.ask("angular_impulse", self.name)
        twist = size if owners.index(body) == 1 else negate(size)
        return (Couple(self.name, CONTACT, body, twist, "twist", size, internal=True),)


class Impulse(Event, frozen=True):
    word = "impulse"
    at_points = True
    about = "a blow: an impulse on a point of a body"
    blow = True
    quantities = ("impulse", "angular_impulse")
    spatial = True
    impulse: Formula | None = amount("size; `unknown` asks for it", "impulse", "J", required=True)
    on: PointRef | None = key("point", "where it acts", required=True, example="rod.end")
    direction: Direction | None = aimed()

    def told(self) -> Words:
        if self.impulse is None or self.on is None:
            return ()
        return ("impulse ", self.impulse, " on ", *whereabouts(self.on), *aimed_in_words(self.direction))

    def blow_in_space(self) -> tuple[PointRef, Formula, tuple[Formula, Formula, Formula]] | None:
        assert self.on is not None
        if not isinstance(self.direction, tuple) or len(self.direction) != 3:
            help = "give it `direction: [x, y, z]`"
            raise Unsolvable(f"in which direction `{self.name}` strikes nothing tells", span=self.on.span, help=help)
        x, y, z = self.direction
        return self.on, self.impulse or ZERO, (x, y, z)

    def points(self, connections: Sequence[Connection]) -> tuple[PointRef, ...]:
        return (self.on,) if self.on is not None else ()

    def blows(self, ref: PointRef, body: BodyFacts, instant: Moment) -> Iterator[Force]:
        """Its own impulse, from outside."""
        size, arm = self.impulse or ZERO, self.spot(ref, instant)
        if self.direction is not None and self.direction not in SQUARE:
            push = pointing(self.direction)
        else:
            rim = ref.point is not None and rim_radius(instant.body(ref.owner), ref.point) is not None
            push = unit(body.motion.heading or RIGHT)
            if rim or arm.parts:
                on = ref if ref.point is not None else PointRef(ref.owner, "center")
                push, arm = across(on, arm, turn_sense(self.direction, instant.sense(ref.owner)), instant)
        yield Force(self.name, BLOW, body.name, size, push, arm, "impulse")


class Cuts(Event, frozen=True):
    word = "cuts"
    lets_fly = True
    about = "a string or other connection is gone from then on"
    instead = AFTERWARDS
    cuts: tuple[str, ...] = key(
        "names", "the connection", refers=("connection",), required=True, default=(), example="cord"
    )

    def told(self) -> Words:
        return (f"{and_joined([*map(spoken, self.cuts)])} {'is' if len(self.cuts) == 1 else 'are'} cut",)

    def ends(self, connections: Sequence[Connection]) -> tuple[str, ...]:
        return self.cuts


class Removes(Event, frozen=True):
    word = "removes"
    lets_fly = True
    about = "a support, action or body is taken away"
    instead = AFTERWARDS
    removes: tuple[str, ...] = key(
        "names",
        "the connection, action or body",
        refers=("connection", "action", "body"),
        required=True,
        default=(),
        example="prop",
    )

    def told(self) -> Words:
        return (f"{and_joined([*map(spoken, self.removes)])} {'is' if len(self.removes) == 1 else 'are'} taken away",)

    def ends(self, connections: Sequence[Connection]) -> tuple[str, ...]:
        return self.removes


class Leaves(Removes, frozen=True):
    """What a state that says `touch: leaves` is followed by: the contact is gone."""

    about = "what no longer presses on a surface leaves it"

    def told(self) -> Words:
        return ()

    def left_behind(self, connections: Sequence[Connection]) -> tuple[Connection, ...]:
        return tuple(item for item in connections if item.name in self.removes)


class Fixes(Event, frozen=True):
    word = "fixes"
    about = "a point of a moving body is suddenly held; from then on the body turns about it"
    heats = True
    quantities = ("force", "impulse")
    quantities_in_space = ("torque", "angular_impulse")
    spatial = True
    at_once = "`fixes: [BODY.A, BODY.B]` holds two points of a body at once"
    fixes: tuple[PointRef, ...] = key(
        "points", "the point; in space also two, of an axis", count=(1, 2), required=True, example="plate.corner1"
    )
    along: Axis = key(
        "axis in space", "direction of the axis of a hinge, in the body as it is drawn", default=(), space=True
    )

    def check(self, scene: Surroundings) -> None:
        """It fixes what moves freely."""
        for ref in self.fixes:
            if ref.owner in scene.held:
                message = f"`{ref.owner}` is held by `{scene.held[ref.owner]}` already"
                raise Unsolvable(message, span=ref.span, help="fix a point of a body that moves freely")
        if len(self.fixes) > 1:
            message = f"`{self.name}` holds two points: in the plane a body is then at rest"
            raise Unsolvable(
                message, span=self.fixes[1].span, help="fix one point; in space, with `up: z`, it turns about the line"
            )

    def told(self) -> Words:
        if len(self.fixes) > 1:
            return (*whereabouts(self.fixes[0]), " and ", self.fixes[1].point or "centre", " are held from then on")
        axis = (", on a hinge along ", *direction_in_words(self.along)) if self.along else ()
        return (*whereabouts(self.fixes[0]), " is held from then on", *axis) if self.fixes else ()

    def points(self, connections: Sequence[Connection]) -> tuple[PointRef, ...]:
        return self.fixes

    def ends(self, connections: Sequence[Connection]) -> tuple[str, ...]:
        """The body leaves what it lies on."""
        return tuple(item.name for item in connections if self.fixes and item.lying() == self.fixes[0].owner)

    def adds(self) -> tuple[Connection, ...]:
        return (Hinge(self.name, hinge=self.fixes),) if self.fixes else ()

    def joint_in_space(self) -> Joint | None:
        """A ball joint of the ground, or a hinge where it tells the direction of its axis or a second point on it."""
        if not self.fixes:
            return None
        turning = ((self.along[0], self.along[1], self.along[2]),) if self.along else ()
        through = self.fixes[1] if len(self.fixes) > 1 else None
        return Joint(
            self.name, GROUND, self.fixes[0], turning=turning, free=not turning and through is None, through=through
        )

    def holds(self, ref: PointRef, instant: Moment) -> str:
        return called(ref)


class Grips(Event, frozen=True):
    word = "grips"
    about = "a contact begins and does not slip: the touching point of the body is suddenly at rest"
    heats = True
    quantities = ("impulse",)
    instead = (
        "an unknown impulse stops a point: `impulse: J, on: BODY.P, direction: [p, q, 1]` with `J`, `p` and `q` unknown under `given`,"
        " and `BODY.P.velocity: [0, 0, 0]` in the state after it; `fixes: BODY.P` holds it from then on"
    )
    grips: str | None = key("name", "the contact", refers=("connection",), required=True, default=None, example="base")

    def told(self) -> Words:
        return (f"no slip at {spoken(self.grips or '')} from then on",)

    def contact(self, connections: Sequence[Connection]) -> Connection | None:
        """The contact that begins."""
        return next((item for item in connections if item.name == self.grips and item.lying()), None)

    def check(self, scene: Surroundings) -> None:
        """It grips a contact with a flat surface or a corner."""
        item = self.contact(scene.problem.connections)
        if item is None:
            contacts = sorted(item.name for item in scene.problem.connections if item.lying())
            help = f"contacts: {', '.join(contacts)}" if contacts else "the scene has no contact"
            raise Unsolvable(f"`{self.name}` can only grip a contact, and `{self.grips}` is none", help=help)
        if isinstance(item, Touch) and item.grip().kind == "none":
            ref = item.slider()
            touching = ref.owner if ref.point is None else f"{ref.owner}.{ref.point}"
            help = f"`friction: any` where it grips; `collides: [{touching}, {item.places()[0].owner}], restitution: 0` where it slides on"
            message = f"`{self.name}` grips `{item.name}`, which is smooth"
            raise Unsolvable(message, span=item.touches()[0].span, help=help)
        for ref in item.places():
            surface = scene.surfaces.get(ref.owner)
            if surface is not None and surface.curved and surface.height() is None:
                message = f"`{self.name}` on a curved surface is not solved yet"
                raise Unsolvable(message, span=item.places()[0].span, help="solved are flat surfaces and corners")

    def points(self, connections: Sequence[Connection]) -> tuple[PointRef, ...]:
        item = self.contact(connections)
        return (item.slider(),) if item is not None else ()

    def begins(self) -> tuple[str, ...]:
        return (self.grips,) if self.grips is not None else ()

    def ends(self, connections: Sequence[Connection]) -> tuple[str, ...]:
        """A ball that hits a corner turns about it and leaves the floor."""
        item = self.contact(connections)
        return tuple(other.name for other in connections if item is not None and other.lying() == item.lying())

    def spot(self, ref: PointRef, instant: Moment) -> Vector:
        """Where the body touches what it grips."""
        item = self.contact(instant.configuration.problem.connections)
        return instant.point(ref) if item is None else item.touching_arm(instant)

    def gripped(self, instant: Moment) -> Surface | None:
        """The surface that it grips; None for a corner."""
        item = self.contact(instant.configuration.problem.connections)
        return item.surface(instant.configuration, instant.state) if item is not None else None

    def holds(self, ref: PointRef, instant: Moment) -> str:
        surface = self.gripped(instant)
        return called(ref) if surface is None else surface.held_at

    def no_torque(self, instant: Moment) -> str:
        """Of a blow, or of friction that lasts until it rolls."""
        surface, heavy = self.gripped(instant), instant.configuration.problem.gravity is not None
        if surface is None or not (surface.level and heavy):
            return "what acts there has no arm, whatever it is"
        where = f"friction, whatever it is, has no arm about a fixed point of {spoken(surface.name)}"
        return f"{where}, and weight and normal force balance along one line"


def aimed_in_words(direction: Direction | None) -> Words:
    """A direction behind what is aimed: ", up", ", along y", ", along (p, q, 1)", ", at α"."""
    if direction is None:
        return ()
    if isinstance(direction, str):
        return (f", {direction}",)
    if isinstance(direction, Formula):
        return (", at ", direction)
    return (", along ", *direction_in_words(direction))
