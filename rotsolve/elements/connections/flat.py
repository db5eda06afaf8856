"""Lying flat: a body on a rough level table seen from above, each piece of which rubs by its weight: τ = ∫ r μ g dm."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct, field

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, Integral, Symbol, multiply, negate, sqrt, total
from rotsolve.core.derivation import NEXT, Words
from rotsolve.core.facts import (
    BINDS,
    FRICTION,
    SHARED_FRICTION,
    Couple,
    Force,
    Requirement,
    Summed,
    enough,
    held_still,
    signed,
    square,
)
from rotsolve.core.faults import Unsolvable
from rotsolve.core.limits import Limit
from rotsolve.core.vectors.heading import NOWHERE, Vector, unit, vector
from rotsolve.core.writing import spoken
from rotsolve.elements.connections.faces import Face
from rotsolve.elements.connections.supports import Rides
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import Body, PointRef
from rotsolve.language.elements import Connection, Fact, Moment, Surroundings
from rotsolve.language.friction import Friction


class Spot(Struct, frozen=True):
    """How what lies on a table rubs about an axis, per μ g: ∫ r dm, and the sum of the ways to its pieces, ∫ (r/|r|) dm."""

    arms: Formula
    ways: Vector
    words: Words = ()


class Laid(Connection, frozen=True):
    """A body that lies flat on a rough level table seen from above: each piece rubs by its weight, against the turn. A contact there.

    `spins` marks one that nothing else holds: it spins in place, about its centre of mass.
    """

    word = "contact"
    quantities = ("torque", "friction", "work", "power")
    pointed = ("contact",)

    contact: tuple[PointRef, ...] = ()
    friction: Friction = field(default_factory=Friction)
    spins: bool = False

    def brakes(self) -> tuple[PointRef, ...]:
        return self.contact[:1]

    def fixed_points(self) -> tuple[PointRef, ...]:
        return (PointRef(self.contact[0].owner, "cm", span=self.contact[0].span),) if self.spins else ()

    def twists(self) -> bool:
        return True

    def rooms(self, scene: Surroundings) -> Iterator[Limit]:
        return self.friction.rooms(self.name)

    def check(self, scene: Surroundings) -> None:
        """A body that turns about a fixed axis or spins in place, and lies on the table with what its shape tells."""
        ref = self.contact[0]
        body = scene.bodies[ref.owner]
        led = body.moves is not None or bool(body.moved)
        states = scene.throughout(self.name)
        turns = self.spins or all(scene.host(ref.owner, state) in scene.held for state in states)
        if led or not turns or len(self.contact) > 2 or ref.point not in (None, "center", "cm"):
            message = f"`{body.name}`, which travels over `{self.contact[1].owner}` seen from above, rubs on it in a way that is not solved"
            help = "solved is what turns on an `axle` or `hinge`, or spins in place; without `plane: horizontal` what slides along a line"
            raise Unsolvable(message, span=ref.span, help=help)
        if body.parts or body.holes:
            message = f"how `{body.name}`, which is put together, lies on `{self.contact[1].owner}` is not solved"
            raise Unsolvable(message, span=ref.span, help="`weld` what it is made of, each with a contact of its own")
        wheel = body.shape is None and (body.inertia or body.radius or body.gyration or body.radii)
        if wheel or (self.spins and shape_of(body).pointlike):
            message = f"over what face `{body.name}` rubs on `{self.contact[1].owner}` nothing tells"
            raise Unsolvable(message, span=ref.span, help="give it a `shape`: disc, ring, annulus, cylinder or rod")
        if scene.problem.gravity in (None, ZERO):
            message = f"nothing presses `{body.name}` on `{self.contact[1].owner}`: the scene has no gravity"
            raise Unsolvable(message, span=ref.span, help="leave out `gravity: none`")
        if self.friction.static != self.friction.kinetic:
            message = f"static and kinetic friction that differ over a face, as those of `{self.name}`, are not solved"
            raise Unsolvable(message, span=ref.span, help="give one coefficient: what turns rubs with the kinetic one")
        self.check_loads(scene)
        if self.spins:
            self.check_spins(body, scene)

    def check_loads(self, scene: Surroundings) -> None:
        """What is welded on presses by its own weight as well: it lies on the table too, or nothing tells where it does."""
        ref = self.contact[0]
        for state in scene.throughout(self.name):
            laid = {item.contact[0].owner for item in scene.connections(state) if isinstance(item, Laid)}
            host = scene.host(ref.owner, state)
            for name, other in scene.bodies.items():
                if name not in laid and scene.host(name, state) == host and other.mass != ZERO:
                    message = f"`{name}` is borne by `{ref.owner}`: where its weight presses on `{self.contact[1].owner}` nothing tells"
                    raise Unsolvable(message, span=ref.span, help=f"give `{name}` a contact of its own, or `mass: 0`")

    def check_spins(self, body: Body, scene: Surroundings) -> None:
        """What spins in place is pushed by nothing but couples, and its centre of mass is at rest."""
        ref, span = self.contact[0], self.contact[0].span
        pushed = [
            item.name
            for item in scene.problem.actions
            if ref.owner in owners(item.touches()) and (item.brakes() or not item.twists())
        ]
        pushed += [event.name for event in scene.problem.events]
        pushed += ["velocity" for value in scene.mentions.values(ref.owner, "velocity") if value != ZERO]
        if pushed:
            message = f"`{body.name}` lies on a rough table, and does not just spin in place there: `{pushed[0]}` moves its centre"
            help = f"give it an `axle` or a `hinge`, if it turns about that: `axle: {body.name}`"
            raise Unsolvable(message, span=span, help=help)

    def spot(self, instant: Moment) -> Spot:
        """How it rubs about the axis of the body that it is part of."""
        ref = self.contact[0]
        body = instant.body(ref.owner)
        mass, shape = body.mass or ZERO, shape_of(body)
        arm = instant.point(PointRef(ref.owner, "cm"))
        if shape.pointlike:
            return point_spot(mass, arm)
        face = shape.face()
        if face is not None and not arm.parts:
            return Spot(*round_spot(mass, Face(*face), instant))
        found = self.along(mass, body, instant)
        if found is None:
            host = instant.host(ref.owner)
            joined = f"joined to `{host}`" if host != ref.owner else f"a {shape.word}"
            message = f"how `{body.name}`, {joined}, rubs on `{self.contact[1].owner}` about that axis is not solved"
            help = "solved are round bodies about their centres, rods by themselves, particles; a torque may be told as `friction_torque`"
            raise Unsolvable(message, span=ref.span, help=help)
        return found

    def along(self, mass: Formula, body: Body, instant: Moment) -> Spot | None:
        """Of a straight body about a point of its line: ∫ x dm on both sides of that."""
        shape, name = shape_of(body), instant.host(body.name)
        cut = shape.slicing() if shape.slender and not shape.graded and name == body.name else None
        start, end = (instant.point(PointRef(body.name, point)) for point in ("start", "end"))
        along = (end - start).along(instant.motion(name).orientation)
        if cut is None or len(start.parts) > 1 or len(end.parts) > 1:
            return None
        way = instant.motion(name).orientation
        near, far = simplify(negate(start.along(way))), simplify(end.along(way))
        signs = [instant.configuration.signs.sign(side) for side in (near, far)]
        if -1 in signs or (None in signs and not holds_axis(near, far, along)):
            return None
        x = instant.coordinate("x")
        density = mass / shape.measure()
        halves: list[Formula] = [Integral(density * x, x.name, ZERO, side) for side in (near, far) if side != ZERO]
        arms = 2 * halves[0] if len(halves) == 2 and near == far else total(halves)
        words: Words = ("Cut into pieces of length d", x, ": dm = ", density, " d", x, ".", *each_rubs(x))
        over = simplify(density * (far - near))
        ways = NOWHERE if over == ZERO else vector(over, way)
        return Spot(arms, ways, words)

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """Friction against the turn, whichever way that is; as large as it takes while it holds the body still."""
        ref, gravity = self.contact[0], instant.configuration.problem.gravity or ZERO
        name = instant.host(ref.owner)
        sense, mode = instant.sense(name), instant.mode(f"{self.name}.{name}")
        forward, back = instant.turn_words(name)
        spot, rough = self.spot(instant), self.friction
        press, most = (rough.kinetic or ZERO) * gravity, instant.ask("torque", self.name, when="")
        label = "friction torque, τ = ∫ r μ g dm" if spot.words else "friction torque"
        yield Summed(self.name, most, press * spot.arms, label, (name,), spot.words)
        if mode == "holds":
            size = instant.ask("torque", self.name, when=instant.span(name), words=(forward, back))
            yield Couple(self.name, SHARED_FRICTION, name, signed(size, sense), "friction torque", size)
            yield held_still(self.name, name, instant.motion(name))
            if instant.in_balance:
                yield enough(self.name, size, most, "turn")
            return
        turn, against = (sense, forward) if mode == "turns back" else (-sense, back)
        yield Couple(self.name, FRICTION, name, signed(most, turn), "friction torque", most, against)
        for part, way in spot.ways.parts:
            size, along = simplify(press * part, order=instant.configuration.order), unit(way.turned(90 * turn))
            told = "in all, against its motion"
            yield Force(self.name, FRICTION, name, size, along, NOWHERE, "kinetic friction", told, works=False)


def owners(refs: tuple[PointRef, ...]) -> set[str]:
    """The bodies of points."""
    return {ref.owner for ref in refs}


def holds_axis(near: Formula, far: Formula, whole: Formula) -> bool:
    """Whether an axis lies between the ends by what the scene asks of a place on a rod."""
    return simplify(near + far - whole) == ZERO


def point_spot(mass: Formula, arm: Vector) -> Spot:
    """A particle, all of it at one place."""
    if not arm.parts:
        return Spot(ZERO, NOWHERE)
    if len(arm.parts) == 1:
        size, way = arm.parts[0]
        return Spot(mass * size, vector(mass, way))
    distance = simplify(sqrt(arm.dot(arm)))
    return Spot(mass * distance, arm.times(mass / distance))


def round_spot(mass: Formula, face: Face, instant: Moment) -> tuple[Formula, Vector, Words]:
    """Of a round body about its centre, ring by ring."""
    if face.inner == face.outer:
        return mass * face.outer, NOWHERE, ()
    r: Symbol = instant.coordinate("rho")
    ring = face.share(mass, r)
    words: Words = ("Cut into rings of radius ", r, " and width d", r, ": dm = ")
    return Integral(r * ring, r.name, face.inner, face.outer), NOWHERE, (*words, ring, " d", r, ".", *each_rubs(r))


def each_rubs(r: Symbol) -> Words:
    """What friction does on each piece, at its distance from the axis."""
    return (NEXT, "Each rubs with μ g dm at the distance ", r, " from the axis: torque μ g ", r, " dm.")


def on_a_circle(item: Rides, instant: Moment) -> Iterator[Fact]:
    """Friction gives what lies on a turning table all of its acceleration: f = m a, with r ω² inwards and r α along the circle."""
    rider = item.rides[0].owner
    body, host = instant.body(rider), instant.host(rider)
    motion, order = instant.motion(host), instant.configuration.order
    radius, mass = simplify(shape_of(body).centroid()[0]), body.mass or ZERO
    friction, inward, along = instant.ask("friction_force", item.name), square(motion.spin), motion.spin_rate
    pull = simplify(mass * radius, order=order)
    gives = "r ω² inwards" + (" and r α along the circle" if along != ZERO else "")
    words: Words = (f"Friction alone holds {spoken(rider)} on its circle: it gives the acceleration {gives}.",)
    sides = (friction, multiply(pull, inward))
    if along != ZERO:
        sides = (friction**2, multiply(pull**2, inward**2 + along**2))
    yield Summed(item.name, *sides, f"Newton's second law, {spoken(rider)}", (host,), words)
    if item.friction is not None and item.friction.static is not None:
        kept, otherwise = f"{spoken(rider)} does not slip", f"{spoken(rider)} slips"
        yield Requirement(item.name, BINDS, most_on_a_circle(item, instant) - friction, ZERO, kept, otherwise)


def most_on_a_circle(item: Rides, instant: Moment) -> Formula:
    """μ m g."""
    mass, gravity = instant.body(item.rides[0].owner).mass or ZERO, instant.configuration.problem.gravity or ZERO
    static = item.friction.static if item.friction is not None else None
    return simplify((static or ZERO) * mass * gravity, order=instant.configuration.order)
