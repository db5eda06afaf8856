"""Collisions: two bodies that bounce off each other, and a body that bounces off a surface or off something fixed."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from typing import ClassVar

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ZERO, Formula, negate
from rotsolve.core.derivation import Words
from rotsolve.core.facts import (
    COMES,
    CONTACT,
    GAINS,
    PUSHES,
    SLIDES,
    TURNS,
    BodyFacts,
    Force,
    Requirement,
    Rule,
    enough,
    signed,
)
from rotsolve.core.faults import UNSOLVED, Unsolvable
from rotsolve.core.vectors.heading import DOWN, NOWHERE, RIGHT, Heading, Vector, unit
from rotsolve.core.writing import is_negative, spoken
from rotsolve.elements.connections.touch import contact_arm
from rotsolve.elements.shapes import rim_radius, shape_of
from rotsolve.elements.surfaces import Level
from rotsolve.language.bodies import PointRef, Surface
from rotsolve.language.elements import Connection, Event, Moment, Surroundings
from rotsolve.language.friction import Friction
from rotsolve.language.keys import amount, key


def called(ref: PointRef) -> str:
    """A point in words: "plate's corner1"."""
    return f"{ref.owner}'s {ref.point or 'centre'}".replace("_", " ")


def whereabouts(ref: PointRef) -> Words:
    """A body, or a point of it, in words: "puck", "rod's end", "the point of rod at x"."""
    if ref.argument is not None:
        return (f"the point of {spoken(ref.owner)} at ", ref.argument)
    return (spoken(ref.owner) if ref.point is None else called(ref),)


def centre_instead(ref: PointRef) -> PointRef:
    """The centre of mass of a body of which a point is named; of one named alone that body."""
    return ref if ref.point is None else PointRef(ref.owner, "cm")


class Overhead(Level, frozen=True):
    """The underside of what is above."""

    away = "down"
    into = "up"

    @property
    def normal(self) -> Heading:
        return DOWN


CEILING = Overhead("ceiling")
FIXED = ("ground", "ceiling")


class Collides(Event, frozen=True):
    word = "collides"
    at_points = True
    bodily = True
    about = "two bodies bounce off each other"
    blow = True
    heats = True
    quantities = ("impulse", "angular_impulse", "work")
    instead = (
        "a blow off something fixed: `impulse: J, on: BODY.P, direction: z` with `J: unknown` under `given`, and"
        " `BODY.P.velocity.z: e*u` in the state after it"
    )
    lacking: ClassVar[str] = "say along which line one of them travels: `moves: right`"
    collides: tuple[PointRef, ...] = key(
        "points", "the two bodies, or points of them", count=(2, 2), required=True, example="[ball, rod.end]"
    )
    restitution: Formula | None = amount("coefficient of restitution, 0 to 1", "number", "e", "fraction", default=None)
    friction: Friction = key(
        "friction",
        "of a surface as it is struck: `none`, a coefficient, {static: , kinetic: }, or `any`, so rough that it grips",
        default=Friction(),
        letter="mu",
        limits="nonnegative",
    )
    tangential: Formula | None = amount(
        "coefficient of restitution along a surface that is struck: 0 where it grips, 1 of a super-ball",
        "number",
        "",
        "fraction",
        default=None,
    )

    def completed(self, bodies: Container[str], surfaces: Mapping[str, Surface]) -> Event:
        """Where one of the two is no body, what bounces off a surface or off something fixed."""
        moving = [ref for ref in self.collides if ref.owner in bodies]
        fixed = next((ref for ref in self.collides if ref.owner in surfaces or ref.owner in FIXED), None)
        if fixed is None or len(moving) != 1:
            return self
        surface = CEILING if fixed.owner == CEILING.name else surfaces.get(fixed.owner)
        own = {word: getattr(self, word) for word in ("from_", "to", "restitution", "friction", "tangential")}
        return Bounces(name=self.name, collides=self.collides, struck=moving[0], surface=surface, **own)

    def check(self, scene: Surroundings) -> None:
        """Two bodies are smooth as they meet, or grip each other for good, as in `joins`."""
        if self.friction != Friction() or self.tangential is not None:
            message = f"friction of two bodies in `{self.name}` is not solved yet"
            raise Unsolvable(message, span=self.collides[0].span, help="solved is a body that strikes a flat surface")

    def points(self, connections: Sequence[Connection]) -> tuple[PointRef, ...]:
        return self.collides

    def met(self) -> tuple[str, ...]:
        return tuple(ref.owner for ref in self.collides)

    def of_centres(self) -> Collides:
        return replace(self, collides=tuple(map(centre_instead, self.collides)))

    def told(self) -> Words:
        bounce: Words = () if self.restitution is None else (", coefficient of restitution ", self.restitution)
        one, other = map(whereabouts, self.collides)
        return (*one, " and ", *other, " bounce off each other", *bounce)

    def axes(self, instant: Moment) -> tuple[tuple[str, Heading], ...]:
        return (("", self.approach(instant)),)

    def approach(self, instant: Moment) -> Heading:
        """The line along which the bodies approach: that on which one of them travels, else the one line of their velocities."""
        for ref in self.points(()):
            motion = instant.motion(ref.owner)
            if motion.kind == "line" and motion.heading is not None:
                return motion.heading
        one, *others = self.points(())
        speed = instant.velocity(one) - (instant.velocity(others[0]) if others else NOWHERE)
        headings = [heading for _, heading in speed.parts]
        line = headings[0] if headings else RIGHT
        if any((heading - line).sin() != ZERO for heading in headings):
            help = self.lacking
            message = f"nothing tells along which line the blow of `{self.name}` acts"
            raise Unsolvable(message, span=self.collides[0].span, help=help)
        return line

    def push(self, instant: Moment) -> Formula:
        """The impulse along that line, on the last-named."""
        return instant.ask("impulse", self.name)

    def closing(self, before: Moment, after: Moment) -> tuple[Formula, Formula]:
        """Along the line of approach."""
        line, (one, two) = self.approach(before), self.collides
        approach = before.velocity(one).along(line) - before.velocity(two).along(line)
        return approach, after.velocity(two).along(line) - after.velocity(one).along(line)

    def bounce(self, before: Moment, after: Moment) -> tuple[Formula, Formula, Formula] | None:
        return None if self.restitution is None else (self.restitution, *self.closing(before, after))


class Bounces(Collides, frozen=True):
    """What `collides` is where a body strikes a flat surface, across which it bounces, or something fixed in its way."""

    lacking = "name the surface that it strikes, as in `collides: [ball, floor]`"
    struck: PointRef = PointRef("")
    surface: Surface | None = None

    def points(self, connections: Sequence[Connection]) -> tuple[PointRef, ...]:
        return (self.struck,)

    def bounced_off(self) -> tuple[PointRef, Surface | None]:
        return self.struck, self.surface

    def of_centres(self) -> Collides:
        against, own = centre_instead(self.against), centre_instead(self.struck)
        return replace(self, collides=(own, against), struck=own)

    def told(self) -> Words:
        """In words: "ball bounces off floor, coefficient of restitution e, friction μ"."""
        bounce: Words = () if self.restitution is None else (", coefficient of restitution ", self.restitution)
        along: Words = () if self.tangential is None else (", along the surface ", self.tangential)
        kinds: dict[str, Words] = {"any": (", which is rough",), "none": ()}
        rough = kinds.get(self.friction.kind, (", coefficient of friction ", self.friction.kinetic or ZERO))
        return (*whereabouts(self.struck), " bounces off ", spoken(self.against.owner), *bounce, *along, *rough)

    @property
    def against(self) -> PointRef:
        """What it strikes."""
        return next(ref for ref in self.collides if ref is not self.struck)

    @property
    def grips(self) -> bool:
        """Whether something acts along the surface that is as large as it takes, if that does not slip."""
        return self.friction.kind != "none" or self.tangential is not None

    def rubs(self) -> bool:
        return self.friction.kind == "coefficient"

    def lying(self) -> str:
        return self.struck.owner

    def static(self) -> Formula | None:
        return self.friction.static

    def completed(self, bodies: Container[str], surfaces: Mapping[str, Surface]) -> Event:
        return self

    def check(self, scene: Surroundings) -> None:
        """A flat surface on which the body does not lie, or something fixed, which is smooth; and what touches it is told."""
        body, name = scene.bodies[self.struck.owner], self.against.owner
        if self.surface is not None and self.surface.curved:
            help = "solved are flat surfaces; of something fixed in its way say `ground`"
            raise Unsolvable(f"a blow off `{name}` is not solved yet", span=self.against.span, help=help)
        if self.grips and self.surface is None:
            help = "name a surface: `floor: level`, `side: {wall: right}`, a `slope`"
            raise Unsolvable(f"nothing tells which way `{name}` is rough", span=self.against.span, help=help)
        if self.tangential is not None and self.friction.kind == "coefficient":
            message = f"`{self.name}` has a `tangential` restitution and a coefficient of friction"
            raise Unsolvable(message, span=self.struck.span, help="give one of the two")
        if self.rubs() and self.friction.static != self.friction.kinetic:
            message = f"`{self.name}` with two coefficients of friction is not solved yet: which of them it is may change within a blow"
            raise Unsolvable(message, span=self.struck.span, help="give it one coefficient", kind=UNSOLVED)
        bare = self.struck.point is None and rim_radius(body, None) is None
        if self.surface is not None and bare and (body.parts or not shape_of(body).pointlike):
            message = f"with which point `{body.name}` strikes `{name}` nothing tells"
            raise Unsolvable(message, span=self.struck.span, help=f"name it, as in `{body.name}.end`")
        for item in scene.connections(self.from_ or ""):
            if item.lying() == body.name and name in {ref.owner for ref in item.places()}:
                message = f"`{item.name}` holds `{body.name}` on `{name}`, off which `{self.name}` lets it bounce"
                raise Unsolvable(message, span=self.against.span, help=f"leave `{item.name}` out")

    def coupled(self, instant: Moment) -> bool:
        """Whether the push also moves the touching point along the surface: it turns the body about another point, or a joint holds it."""
        name = instant.host(self.struck.owner)
        central = is_zero(self.spot(self.struck, instant).along(self.forward))
        return bool(self.holding(instant)) or instant.motion(name).kind != "plane" or not central

    def holding(self, instant: Moment) -> list[Connection]:
        """The connections of the body and of all that moves with it, before the blow and after."""
        name, states = self.struck.owner, (self.from_ or "", self.to or "")
        group = {host for state in states for host in instant.configuration.component(name, state)}
        held = (item for state in states for item in instant.configuration.connections(state))
        bodies = instant.configuration.bodies
        return [
            item
            for item in held
            if any(ref.owner in bodies and instant.host(ref.owner) in group for ref in item.touches())
        ]

    def check_freedom(self, instant: Moment) -> None:
        """Friction is solved of what flies freely, or on hinges and axles; what lies on something else or is led along a line is not."""
        name = instant.host(self.struck.owner)
        other = [
            item.name for item in self.holding(instant) if not (item.joint() or item.fixed_points() or item.joined())
        ]
        if other or instant.motion(name).kind == "line":
            by = f"`{other[0]}` holds" if other else "is led along a line"
            message = f"friction of `{self.name}` on `{name}`, which {by}, is not solved yet"
            help = "solved is what flies freely, without `moves`, or hangs on hinges and axles; a smooth blow"
            raise Unsolvable(message, span=self.struck.span, help=help)

    @property
    def forward(self) -> Heading:
        """The way along the surface that counts as positive, with the surface on its right."""
        return RIGHT if self.surface is None else self.surface.normal.turned(-90)

    def approach(self, instant: Moment) -> Heading:
        """Into the surface; against something fixed the way in which it comes, as the scene writes its speed: −v up is v down."""
        if self.surface is not None:
            return self.surface.normal.turned(180)
        line = super().approach(instant)
        return line.turned(180) if is_negative(self.rate(instant, line)) else line

    def spot(self, ref: PointRef, instant: Moment) -> Vector:
        """Where the body touches the surface: a rim towards it, or the point that is named."""
        return instant.point(ref) if self.surface is None else contact_arm(ref, self.surface.normal, instant)

    def slip(self, instant: Moment) -> Formula:
        return self.rate(instant, self.forward)

    def rate(self, instant: Moment, way: Heading) -> Formula:
        """How fast the touching point moves in a direction."""
        return instant.motion(self.struck.owner).velocity_of(self.spot(self.struck, instant)).along(way)

    def push(self, instant: Moment) -> Formula:
        """The impulse out of what it strikes."""
        return instant.ask("impulse", self.name, component="n" if self.grips else "")

    def closing(self, before: Moment, after: Moment) -> tuple[Formula, Formula]:
        line = self.approach(before)
        speeds = self.rate(before, line), negate(self.rate(after, line))
        if speeds == (ZERO, ZERO):
            message = f"`{self.struck.owner}` does not move towards `{self.against.owner}`"
            raise Unsolvable(
                message, span=self.struck.span, help="leave out its `moves`, and give its velocity as [vx, vy]"
            )
        return speeds

    def blows(self, ref: PointRef, body: BodyFacts, instant: Moment) -> Iterator[Force]:
        """The push of the surface, and friction along it: as large as it takes, or μ times the push against the slip."""
        away, arm = self.approach(instant).turned(180), self.spot(ref, instant)
        push = self.push(instant)
        yield Force(self.name, CONTACT, body.name, push, unit(away), arm, "blow", internal=True)
        if not self.grips:
            return
        self.check_freedom(instant)
        mode = instant.mode(self.name)
        if mode == "sticks":
            rub = instant.ask("impulse", self.name, component="f")
            yield Force(self.name, CONTACT, body.name, rub, unit(self.forward), arm, "friction", internal=True)
        else:
            way = self.forward if mode == "slips back" else self.forward.turned(180)
            size = (self.friction.kinetic or ZERO) * push
            yield Force(self.name, CONTACT, body.name, size, unit(way), arm, "friction", internal=True)

    def barrier(self, before: Moment) -> tuple[PointRef, str, Heading | None] | None:
        body, motion = before.body(self.struck.owner), before.motion(self.struck.owner)
        point = self.struck.point is None and (rim_radius(body, None) is not None or shape_of(body).pointlike)
        straight = motion.kind == "line" if self.surface is None else motion.kind != "axis"
        told = straight and (point or not motion.turns)
        return self.struck, self.against.owner, self.approach(before).turned(180) if told else None

    def holds(self, ref: PointRef, instant: Moment) -> str:
        return self.surface.held_at if self.surface is not None and self.grips else ""

    def rules(self, before: Moment, after: Moment) -> Iterator[Rule]:
        """How the touching point moves along the surface that it does not slip on: not at all, or back with e_t of its speed."""
        if not self.grips or before.mode(self.name) != "sticks":
            return
        body, on = spoken(self.struck.owner), spoken(self.against.owner)
        name, motion = after.host(self.struck.owner), after.motion(self.struck.owner)
        turning = self.spot(self.struck, after).turned(90).times(motion.spin).along(self.forward)
        sides, label = (motion.velocity.along(self.forward), negate(turning)), f"{body} grips the {on} as it leaves"
        if self.tangential is not None and self.tangential != ZERO:
            slips = self.slip(after), negate(self.tangential * self.slip(before))
            sides, label = slips, f"the touching point of {body} comes back along the {on}"
        yield Rule(self.name, label, (name,), sides, None, linear=False)

    def needs(self, before: Moment, after: Moment) -> Iterator[Requirement]:
        """What strikes a surface comes towards it and leaves it no faster, nor into it; friction suffices, or slip goes on as it was."""
        if self.surface is None:
            return
        body, on = spoken(self.struck.owner), spoken(self.against.owner)
        came, went = self.closing(before, after)
        yield Requirement(self.name, COMES, came, ZERO, "", f"{body} does not come towards the {on} in")
        if self.restitution is None:
            faster, into = f"{body} leaves the {on} faster than it came", f"{body} goes into the {on}"
            yield Requirement(self.name, GAINS, came - went, ZERO, "", f"{faster}: no blow gives energy, in")
            yield Requirement(self.name, GAINS, went, ZERO, "", f"{into} in")
        if not self.grips:
            return
        push, rub = (before.ask("impulse", self.name, component=part) for part in "nf")
        mode, coupled = before.mode(self.name), self.coupled(before)
        if coupled:
            yield Requirement(
                self.name, PUSHES, push, ZERO, f"the {on} pushes {body}", f"the {on} would have to pull {body}"
            )
        if mode != "sticks":
            slip = signed(self.slip(after), -1 if mode == "slips back" else 1)
            turns = Requirement(
                self.name, TURNS, slip, ZERO, f"{body} slips all through", f"the slip of {body} turns back"
            )
            yield turns if coupled else Requirement(self.name, SLIDES, slip, ZERO, "", f"{body} slips back in")
            return
        if self.rubs():
            yield enough(self.name, rub, (self.friction.static or ZERO) * push, "slip")
        if coupled:
            yield self.loses(before, after)

    def passive(self, before: Moment, after: Moment) -> Iterator[Requirement]:
        if self.grips and not self.coupled(before):
            yield self.loses(before, after)

    def loses(self, before: Moment, after: Moment) -> Requirement:
        """What grips gives no energy: twice what its impulses take, J (u − u′) − J_f (s + s′), s how fast it slips."""
        push, rub = (before.ask("impulse", self.name, component=part) for part in "nf")
        came, went = self.closing(before, after)
        lost = push * (came - went) - rub * (self.slip(before) + self.slip(after))
        gains = f"{spoken(self.struck.owner)} would gain energy, which no blow gives, in"
        return Requirement(self.name, GAINS, lost, ZERO, "", gains)
