"""Supports: hinges, axles and shafts hold bodies to the ground; hinges, welds and what rides hold them to each other."""

from __future__ import annotations

from collections.abc import Container, Iterator
from typing import Any, ClassVar

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.drive import BY_INERTIA, TURNING
from rotsolve.core.facts import (
    AXLE,
    DRIVE,
    FRICTION,
    REACTION,
    Couple,
    Force,
    Role,
    Rule,
    Summed,
    Whirl,
    enough,
    held_still,
    signed,
)
from rotsolve.core.faults import Unsolvable
from rotsolve.core.limits import Limit
from rotsolve.core.symbols import TIME, combined, pace_of
from rotsolve.core.vectors.heading import RIGHT, TURNS, UP, Heading, unit
from rotsolve.elements.connections.faces import (
    Radii,
    check_pressed,
    face_between,
    face_cone,
    face_radii,
    face_radius,
    face_uniform,
)
from rotsolve.elements.shapes import ends_at, rims, room_from, shape_of
from rotsolve.language.bodies import Joint, PointRef, Ride
from rotsolve.language.elements import Connection, Fact, Moment, PlaceOf, Surroundings
from rotsolve.language.friction import Friction
from rotsolve.language.keys import amount, key

Axis = tuple[Formula, ...]
GIVEN = (*TURNING, *BY_INERTIA)  # the keys that give a turn


class Driven(Connection, frozen=True):
    """Base of what turns a body by itself: a rate given as a value or a formula of `time`."""

    quantities: ClassVar[tuple[str, ...]] = ("force", "torque", "angle", "angular_velocity", "angular_acceleration")
    guiding: ClassVar[bool] = True

    friction_torque: Formula | None = amount(
        "friction torque, against the motion",
        "torque",
        "tau",
        "nonnegative",
        default=None,
        plane=True,
        instead="while it turns one way, a couple against that does the same: `actions: {rub: {couple: -2 N m, on: BODY}}`",
    )
    angle: Formula | None = amount("driven angle", "angle", "theta", varies=True, default=None)
    angular_velocity: Formula | None = amount(
        "driven angular velocity", "angular velocity", "omega", varies=True, default=None
    )
    angular_acceleration: Formula | None = amount(
        "driven angular acceleration", "angular acceleration", "alpha", varies=True, default=None
    )
    angular_momentum: Formula | None = amount(
        "given angular momentum of all that turns with the body",
        "angular momentum",
        "L",
        varies=True,
        default=None,
        plane=True,
    )
    kinetic_energy: Formula | None = amount(
        "given kinetic energy of all that turns with the body, along its positive turn",
        "energy",
        "K",
        varies=True,
        default=None,
        plane=True,
    )

    at: Axis = key("place", "where in the scene it holds to the ground, `[x, y]`", default=(), plane=True)

    def held(self) -> tuple[PointRef, ...]:
        """The bodies that turn about it."""
        return ()

    def rubbing(self) -> bool:
        """Whether it rubs against the turn of what it holds."""
        return self.friction_torque is not None

    def most(self, name: str, instant: Moment) -> tuple[Formula, tuple[Summed, ...]]:
        """The torque with which it rubs on a body, with what defines it."""
        return (self.friction_torque or ZERO).substitute({"time": instant.time()}), ()

    def brakes(self) -> tuple[PointRef, ...]:
        return self.held() if self.rubbing() else ()

    def along_turns(self) -> Iterator[tuple[Formula | None, PointRef]]:
        yield from ((rate, ref) for ref in self.held() for rate in (self.angular_velocity, self.angular_acceleration))

    def first_rate(self) -> tuple[Connection, PointRef, Formula] | None:
        rate, held = self.angular_velocity, self.held()
        if rate is None or not held or TIME in rate.symbols() or self.angular_acceleration in (None, ZERO):
            return None
        return replace(self, angular_velocity=None), held[-1], rate

    def prescribes(self) -> Iterator[tuple[str, str, str, Formula]]:
        values = [(word, value) for word in GIVEN if (value := getattr(self, word)) is not None]
        by_inertia = [word for word, _ in values if word in BY_INERTIA]
        if by_inertia and (len(values) > 1 or len(self.held()) > 1):
            beside = "beside another given motion" if len(values) > 1 else "of several bodies on one axle"
            message = f"`{by_inertia[0]}` is given {beside}: that is not solved"
            raise Unsolvable(message, span=self.held()[-1].span, help="give one of them, of one body")
        if (values or self.rubbing()) and not self.fixed_points():
            does = "drives one moving body" if values else "rubs with a friction torque of one moving body"
            raise Unsolvable(f"`{self.name}` {does} against another: not solved yet", span=self.held()[-1].span)
        for word, value in values:
            yield from ((ref.owner, word, "", value) for ref in self.held())

    def place(self, name: str, way: Heading, instant: Moment, place_of: PlaceOf) -> Formula | None:
        """Of one of two joined bodies: that of the other's point, less how far its own point is from its reference."""
        ends = self.joint() if len(self.joint()) == 2 else ()
        for own, other in (ends, ends[::-1]) if ends else ():
            if instant.host(own.owner) == name and (base := place_of(other)) is not None:
                return base - instant.point(own).along(way)
        return None

    def pace(self, configuration: Surroundings, state: str) -> str:
        """Of its torques; a drive's couple follows what it drives."""
        drives = (drive for ref in self.held() for drive in configuration.drives(ref.owner, state))
        return combined([pace_of(self.friction_torque or ZERO), *(drive.pace for drive in drives)])

    def twists(self) -> bool:
        return self.rubbing()

    def couples(self, instant: Moment) -> Iterator[Fact]:
        """Friction against the positive turn; the couple of whatever drives the body; a torque that the scene asks for."""
        hosts = dict.fromkeys(instant.host(ref.owner) for ref in self.held())
        if self.rubbing() and len(hosts) < len(self.held()):
            names = " and ".join(f"`{ref.owner}`" for ref in self.held())
            message = (
                f"{names} are one body: whether the friction of `{self.name}` acts on it once or on each is not told"
            )
            help = "give each an `axle` of its own with its `friction_torque`, or one alone"
            raise Unsolvable(message, span=self.held()[-1].span, help=help)
        for name in hosts:
            sense = instant.sense(name)
            if self.rubbing():
                yield from self.friction_on(instant, name, sense)
            asked = not self.rubbing() and instant.configuration.mentions.asks(self.name, "torque")
            if asked or any(getattr(self, word) is not None for word in GIVEN):
                size = self.torque_on(name, instant, instant.turn_words(name))
                yield Couple(self.name, DRIVE, name, signed(size, sense), "torque", size)

    def torque_on(self, name: str, instant: Moment, words: tuple[str, str]) -> Formula:
        """The letter of the torque on a body; of several wheels on one axle each has its own."""
        several = len({instant.host(ref.owner) for ref in self.held()}) > 1
        return instant.ask("torque", self.name, when=instant.span(name), component=name if several else "", words=words)

    def friction_on(self, instant: Moment, name: str, sense: int) -> Iterator[Fact]:
        """Friction of the axle: against the turn, whichever way that is; as large as it takes while it holds the body still."""
        mode = instant.mode(f"{self.name}.{name}")
        forward, back = instant.turn_words(name)
        most, defined = self.most(name, instant)
        yield from defined
        if mode == "holds":
            size = self.torque_on(name, instant, (forward, back))
            yield Couple(self.name, FRICTION, name, signed(size, sense), "friction torque", size)
            yield held_still(self.name, name, instant.motion(name))
            if instant.in_balance:
                yield enough(self.name, size, most, "turn")
            return
        turn, against = (sense, forward) if mode == "turns back" else (-sense, back)
        yield Couple(self.name, FRICTION, name, signed(most, turn), "friction torque", most, against)


GROUND = PointRef("ground")


def carrier_and_point(points: tuple[PointRef, ...]) -> tuple[PointRef, PointRef]:
    """What carries a body, the ground where nothing else does, and the point that is held."""
    return (points[0] if len(points) > 1 else GROUND), points[-1]


def axis_in_space(item: Hinge | Axle) -> tuple[Formula, Formula, Formula]:
    """The direction about which a body turns; one that the scene leaves out is refused by name."""
    if len(item.along) == 3:
        x, y, z = item.along
        return (x, y, z)
    help = "give `along: z`, or `along: [a, b, c]`"
    raise Unsolvable(f"nothing tells the direction of the axis of `{item.name}`", span=item.held()[-1].span, help=help)


def driven_as(item: Driven) -> tuple[tuple[str, Formula], ...]:
    """How a support turns what it holds, by the words of its keys."""
    said = ((word, getattr(item, word)) for word in TURNING)
    return tuple((word, value) for word, value in said if value is not None)


def two_bearings() -> Any:
    """The key of what holds an axis at two places."""
    return key(
        "quantities",
        "places of two bearings along the axis, from the point held",
        default=(),
        dimension="length",
        letter="b",
        count=(2, 2),
        space=True,
    )


class Hinge(Driven, frozen=True):
    """A point of a body held to the ground, or to a point of another body; it turns freely about it."""

    word = "hinge"
    about = "holds a point of a body to the ground, or to a point of another body; the body turns freely about it"
    quantities = (*Driven.quantities, "impulse", "work", "power", "freedoms")
    quantities_in_space = ("angular_impulse",)
    bodily = True
    hinge: tuple[PointRef, ...] = key(
        "points", "the point held, or [carrier, body]", count=(1, 2), required=True, example="rod.start"
    )
    along: Axis = key("axis in space", "direction of the axis, in the body as it is drawn", default=(), space=True)
    bearings: tuple[Formula, ...] = two_bearings()
    spatial = True

    def check(self, scene: Surroundings) -> None:
        """A hinge of a rod or the like says which point it holds."""
        for ref in self.hinge:
            points = shape_of(scene.bodies[ref.owner]).points if ref.owner in scene.bodies and ref.point is None else ()
            if "start" in points:
                help = f"write {', '.join(f'`{ref.owner}.{point}`' for point in points)} or `{ref.owner}.at(x)`"
                raise Unsolvable(f"`hinge: {ref.owner}` names no point", span=ref.span, help=help)

    def joint_in_space(self) -> Joint:
        return Joint(
            self.name,
            *carrier_and_point(self.hinge),
            turning=(axis_in_space(self),),
            drive=driven_as(self),
            bearings=self.bearings,
        )

    def joint(self) -> tuple[PointRef, ...]:
        return self.hinge

    def held(self) -> tuple[PointRef, ...]:
        return self.hinge[-1:]

    def fixed_points(self) -> tuple[PointRef, ...]:
        grounded = len(self.hinge) == 1 or self.hinge[0].owner in ("ground", "ceiling")
        return self.hinge[-1:] if grounded else ()

    def pace(self, configuration: Surroundings, state: str) -> str:
        steady = self.fixed_points() or travels_straight(self.joint(), configuration, state)
        return super().pace(configuration, state) if steady else "position"

    def facts(self, instant: Moment) -> Iterator[Fact]:
        yield from self.couples(instant)
        carrier, body = self.hinge[0], self.hinge[-1]
        yield from reaction(self.name, REACTION, body, instant)
        if not self.fixed_points():
            yield from reaction(self.name, REACTION, carrier, instant, opposite=body)
            yield from joint(self.name, carrier, body, instant)
        elif instant.motion(body.owner).kind != "axis" or instant.point(body).parts:  # it turns about another point
            yield from joint(self.name, PointRef("ground"), body, instant)


class Axle(Driven, frozen=True):
    word = "axle"
    about = (
        "a fixed axis through the centre of a wheel, or of several that turn freely on it; or one on a body that moves"
    )
    quantities = (*Driven.quantities, "impulse", "work", "power", "freedoms")
    quantities_in_space = ("angular_impulse",)
    bodily = True
    axle: tuple[PointRef, ...] = key(
        "points",
        "the wheel, or wheels, and the body that carries the axle, if any",
        count=(1, 20),
        required=True,
        example="disc",
    )

    along: Axis = key("axis in space", "its direction, in the axes of what carries it", default=(), space=True)
    bearings: tuple[Formula, ...] = two_bearings()
    press: Formula | None = amount(
        "force along it that presses a collar or a foot on its bearing, with `friction` and `radii`",
        "force",
        "F",
        "positive",
        default=None,
        plane=True,
    )
    friction: Formula | None = amount(
        "coefficient of friction of that", "number", "mu", "positive", default=None, plane=True
    )
    radius: Formula | None = face_radius()
    radii: Radii = face_radii()
    cone: Formula | None = face_cone()
    uniform: str = face_uniform()

    independent = True
    axial = True
    spatial = True

    def joint_in_space(self) -> Joint:
        return Joint(
            self.name,
            *carrier_and_point(self.axle),
            turning=(axis_in_space(self),),
            drive=driven_as(self),
            aligned=True,
            bearings=self.bearings,
        )

    def rubbing(self) -> bool:
        return self.friction_torque is not None or self.press is not None

    def most(self, name: str, instant: Moment) -> tuple[Formula, tuple[Summed, ...]]:
        """Of a collar or a foot that is pressed on its bearing τ = ∫ r μ dN."""
        face = face_between(self)
        if self.press is None or face is None:
            return super().most(name, instant)
        summed = face.torque(self.name, self.friction or ZERO, self.press, (name,), instant)
        return summed.letter, (summed,)

    def check(self, scene: Surroundings) -> None:
        """It runs through the centre of a wheel; what carries it may do so at any point."""
        super().check(scene)
        check_pressed(self, self.axle[-1])
        if self.press is not None and face_between(self) is None:
            help = "give it `radii: {inner: r, outer: R}`, or `radius: R` of a foot"
            message = f"`{self.name}`, along which a force presses, has no face that rubs"
            raise Unsolvable(message, span=self.axle[-1].span, help=help)
        if self.press is not None and len(self.axle) > 1:
            message = f"`{self.name}`, along which a force presses, names several bodies"
            raise Unsolvable(message, span=self.axle[-1].span, help="give each an `axle` of its own")
        for ref in self.axle[-1:] if len(self.axle) < 3 else self.axle[1:]:
            if ref.owner in scene.bodies and ref.point in {*rims(scene.bodies[ref.owner]), "rim", "top", "bottom"}:
                help = f"write `axle: {ref.owner}`, or `hinge: {ref.owner}.{ref.point}` for what hangs by its rim"
                raise Unsolvable("an axle runs through the centre of a wheel", span=ref.span, help=help)

    def among(self, moving: Container[str]) -> Connection:
        """On a mount where one of its bodies moves by itself: that carries the others."""
        mounts = [ref for ref in self.axle if ref.owner in moving]
        if len(self.axle) == 1 or not mounts:
            return self
        return Mounted(**{name: getattr(self, name) for name in self.__struct_fields__}, mount=mounts[0])

    def held(self) -> tuple[PointRef, ...]:
        return self.axle

    def fixed_points(self) -> tuple[PointRef, ...]:
        return self.axle

    def facts(self, instant: Moment) -> Iterator[Fact]:
        yield from self.couples(instant)
        hosts: set[str] = set()
        for ref in self.axle:
            if instant.host(ref.owner) not in hosts:
                hosts.add(instant.host(ref.owner))
                yield from reaction(self.name, AXLE, ref, instant, several=len(self.axle) > 1)


class Mounted(Axle, frozen=True):
    """An axle on a body that moves, its `mount`, which carries the wheels along. No scene writes it; it is what an axle becomes."""

    mount: PointRef = PointRef("")

    independent = False
    axial = False

    def among(self, moving: Container[str]) -> Connection:
        return self

    def joint(self) -> tuple[PointRef, ...]:
        return (self.mount, *self.held())

    def held(self) -> tuple[PointRef, ...]:
        return tuple(ref for ref in self.axle if ref is not self.mount)

    def fixed_points(self) -> tuple[PointRef, ...]:
        return ()

    def pace(self, configuration: Surroundings, state: str) -> str:
        steady = travels_straight((self.mount, *self.held()), configuration, state)
        return super().pace(configuration, state) if steady else "position"

    def facts(self, instant: Moment) -> Iterator[Fact]:
        yield from self.couples(instant)
        for wheel in self.held():
            several = len(self.axle) > 2
            yield from reaction(self.name, AXLE, wheel, instant, several=several)
            yield from reaction(self.name, AXLE, self.mount, instant, opposite=wheel, several=several)
            yield from joint(self.name, self.mount, wheel, instant)


class Weld(Connection, frozen=True):
    word = "weld"
    about = "makes two bodies one"
    spatial_word = "clamp"
    quantities = ("force", "torque")
    bodily = True
    weld: tuple[PointRef, ...] = key("points", "the two bodies", count=(2, 2), required=True, example="[drum, rod.end]")

    def joined(self) -> tuple[PointRef, ...]:
        return self.weld


class Rides(Connection, frozen=True):
    word = "rides"
    about = "a particle slides along another body and turns with it, at its `radius` from the axis"
    instead = "`slide: [BAR.P, BEAD], along: x` lets it slide along what carries it, from a point of that"
    quantities = ("work", "friction_force", "normal_force")
    words = ("slips", "sticks")
    bodily = True
    rides: tuple[PointRef, ...] = key("points", "[bead, bar]", count=(2, 2), required=True, example="[bead, bar]")
    friction: Friction | None = key(
        "friction",
        "`none`: it is let go and slides freely; a coefficient: it lies on what it rides, seen from above, and friction holds it there;"
        " else it is held or drawn, and at rest on the bar at each state",
        default=None,
        letter="mu",
        limits="nonnegative",
    )

    def check(self, scene: Surroundings) -> None:
        """A particle on a body that an axle or hinge holds; of what slides freely each state says where, and no event happens meanwhile."""
        rider, carrier = self.rides
        if self.lies() and (scene.problem.plane != "horizontal" or scene.problem.gravity in (None, ZERO)):
            message = f"`{rider.owner}` lies on `{carrier.owner}`, which turns about an upright axis, in a scene seen from above"
            raise Unsolvable(message, span=rider.span, help="say `plane: horizontal`, and leave out `gravity: none`")
        if not shape_of(scene.bodies[rider.owner]).pointlike:
            help = "leave out its `shape`: its mass is at its `radius` from the axis"
            raise Unsolvable(f"`{rider.owner}` rides: it has to be a particle", span=rider.span, help=help)
        shape = shape_of(scene.bodies[carrier.owner])
        if shape.spread == "line" and not shape.slender:
            message = f"`{rider.owner}` rides straight out from the axis, where `{carrier.owner}`, a thin {shape.word}, is not"
            help = (
                f"what is fixed to it is joined by a `weld`: `weld: [{carrier.owner}.{shape.points[1]}, {rider.owner}]`"
            )
            raise Unsolvable(message, span=carrier.span, help=help)
        if carrier.owner not in scene.held or rider.owner in scene.held:
            help = f"give `axle: {carrier.owner}`"
            raise Unsolvable(f"`{carrier.owner}` has to turn on an axle or hinge", span=carrier.span, help=help)
        untold = scene.mentions.untold(rider.owner, "radius") if self.ride().free else None
        if untold is not None:
            help = f"give `{rider.owner}.radius`, if only as a letter that is sought, `given: {{r: unknown}}`"
            raise Unsolvable(f"nothing tells where `{rider.owner}` is at `{untold[0]}`", span=untold[1], help=help)
        if self.lies():
            self.check_alone(scene)
        if self.ride().free and scene.problem.events:
            raise Unsolvable("events with what slides freely are not solved yet", span=rider.span)
        self.check_on_axis(scene)

    def rooms(self, scene: Surroundings) -> Iterator[Limit]:
        """On a rod the rider lies between the axis and the rod's end, on a round body within its rim."""
        rider, carrier = self.rides
        held = (ref for item in scene.problem.connections for ref in item.fixed_points() if ref.owner == carrier.owner)
        axis = next(held, None)
        far = None if axis is None else room_from(scene.bodies[carrier.owner], axis)
        for place in scene.mentions.values(rider.owner, "radius"):
            yield Limit(place, f"`{rider.owner}` is on the other side of its axis")
            if far is None:
                continue
            yield Limit(simplify(far - place), f"`{rider.owner}` is beyond the end of `{carrier.owner}`")

    def check_alone(self, scene: Surroundings) -> None:
        """What friction alone holds bears nothing, and nothing else pulls it."""
        rider, states = self.rides[0], scene.throughout(self.name)
        others = [item for state in states for item in scene.connections(state) if item.name != self.name]
        pulls = [
            item for item in (*others, *scene.problem.actions) if rider.owner in {ref.owner for ref in item.touches()}
        ]
        if pulls:
            message = (
                f"friction alone holds what lies on a turning table, and `{pulls[0].name}` acts on `{rider.owner}`"
            )
            help = f"leave `{pulls[0].name}` out; what lies on `{rider.owner}` is part of its mass"
            raise Unsolvable(message, span=rider.span, help=help)

    def check_on_axis(self, scene: Surroundings) -> None:
        """On a rod that begins at its axis the rider stays where it is at rest on that."""
        rider, carrier = self.rides
        held = (ref for item in scene.problem.connections for ref in item.fixed_points() if ref.owner == carrier.owner)
        axis = next(held, None)
        if not self.ride().free or axis is None or not ends_at(scene.bodies[carrier.owner], axis):
            return
        for state in scene.problem.states:
            lines = [line for line in state.conditions if line.path is not None and line.path.owner == rider.owner]
            told = {(line.path.quantity, line.path.component): line.value for line in lines if line.value is not None}
            speed = told.get(("velocity", "radial"))
            if told.get(("radius", None)) == ZERO and speed is not None and scene.signs.sign(speed) == 0:
                message = f"`{rider.owner}` rests on the axis of `{carrier.owner}`, and stays there"
                raise Unsolvable(message, span=rider.span, help="give it a `radius` or a `velocity.radial` there")

    def ride(self) -> Ride:
        return Ride(self.name, self.rides[0], self.rides[1], self.friction is not None and self.friction.kind == "none")

    def lies(self) -> bool:
        """Whether friction holds it on its circle."""
        return self.friction is not None and self.friction.kind != "none"

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """The friction that holds what lies on a turning table, and the most that it can be."""
        if self.lies():
            from rotsolve.elements.connections.flat import on_a_circle

            yield from on_a_circle(self, instant)

    def verge(self, instant: Moment) -> tuple[tuple[Formula, Formula, Formula], ...]:
        if not self.lies() or self.friction is None or self.friction.static is None:
            return ()
        from rotsolve.elements.connections.flat import most_on_a_circle

        friction, most = instant.ask("friction_force", self.name), most_on_a_circle(self, instant)
        return ((friction, most, friction), (friction, most, friction))

    def force_within(self, quantity: str, instant: Moment) -> Formula | None:
        told = quantity == "friction_force" if self.lies() else quantity == "normal_force" and self.ride().free
        words = TURNS if quantity == "normal_force" else ("", "")
        return instant.ask(quantity, self.name, words=words) if told else None


def travels_straight(joint: tuple[PointRef, ...], configuration: Surroundings, state: str) -> bool:
    """Whether a joint travels along the line of the body that carries it, since it goes round the middle of none."""
    carrier = configuration.host(joint[0].owner, state)
    straight = configuration.line(carrier, state) is not None
    return straight and not any(configuration.swings_round(ref, state) for ref in joint)


def reaction(
    owner: str, role: Role, ref: PointRef, instant: Moment, *, opposite: PointRef | None = None, several: bool = False
) -> Iterator[Force]:
    """The two components of a support's force on a body, right and up.

    They are reversed on the carrier of a joint, where `opposite` is the other body.
    """
    name = instant.host(ref.owner)
    turned = instant.host((opposite or ref).owner)
    # a force that holds a centre of mass off the axis turns with the body, so that it is one of the moment
    span = instant.span(turned) if instant.configuration.balanced(turned, instant.state) else instant.when
    for axis, direction in (("x", RIGHT), ("y", UP)):
        component = f"{axis}_{turned}" if several else axis
        words = ("right", "left") if axis == "x" else ("up", "down")
        size = instant.ask("force", owner, when=span, component=component, words=words)
        arm = instant.point(ref)
        noun, way = "axle force" if role.axle else "hinge force", words[0] if opposite is None else words[1]
        push = unit(direction if opposite is None else direction.turned(180))
        works = bool(opposite) or instant.motion(name).kind != "axis"
        yield Force(owner, role, name, size, push, arm, noun, way, works=works, internal=True)


def joint(owner: str, carrier: PointRef, body: PointRef, instant: Moment) -> Iterator[Rule]:
    """The joined points of two bodies move together, right and up."""
    for word, direction in (("right", RIGHT), ("up", UP)):
        bodies = tuple(ref.owner for ref in (carrier, body) if ref.owner in instant.configuration.bodies)
        moves = "moves as one point" if len(bodies) > 1 else "stays where it is"
        label = f"the joint {moves} ({word})"
        velocity = (instant.velocity(body).along(direction), instant.velocity(carrier).along(direction))
        acceleration = (instant.acceleration(body).along(direction), instant.acceleration(carrier).along(direction))
        yield Rule(owner, label, bodies, velocity, acceleration, linear=False)


class Shaft(Connection, frozen=True):
    word = "shaft"
    about = "hinges a point of a body to an upright shaft that turns steadily; the picture is the upright plane that turns with it"
    instead = "`hinge: shaft.O, along: z, angular_velocity: w` turns a shaft, and `hinge: [shaft.O, BODY.P], along: y` holds a body on it"
    quantities = ("force", "angle")
    circling = True
    shaft: tuple[PointRef, ...] = key("points", "the point held", count=(1, 1), required=True, example="rod.start")
    turning: Formula | None = amount(
        "angular velocity of the shaft", "angular velocity", "Omega", "positive", required=True, default=None
    )
    distance: Formula | None = amount(
        "how far to the right of the axis the hinge is", "length", "b", "nonnegative", default=None
    )

    def fixed_points(self) -> tuple[PointRef, ...]:
        return self.shaft

    def facts(self, instant: Moment) -> Iterator[Fact]:
        yield from reaction(self.name, REACTION, self.shaft[0], instant)

    def whirl(self) -> Whirl | None:
        return Whirl(self.turning or ZERO, self.distance or ZERO)
