"""Leaning: a rod on an edge, on the corner of a body or on something round, which pushes square to the rod."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Protocol, cast

from msgspec import field

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.facts import LIES, NORMAL, TOUCHES, Force, Requirement, Rule, square
from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import has_quantities
from rotsolve.core.vectors.heading import LEFT, NOWHERE, RIGHT, UP, Heading, Vector, heading, unit
from rotsolve.core.writing import spoken
from rotsolve.elements.connections.touch import Touch
from rotsolve.elements.shapes import rim_radius, rims, shape_of
from rotsolve.elements.surfaces import Corner, Curved, Dome
from rotsolve.language.bodies import Body, PointRef, Surface
from rotsolve.language.elements import Fact, Moment, PlaceOf, SceneElements, Surroundings
from rotsolve.language.friction import Friction

ENDS = ("start", "end")
FLAT_ON = (None, "cm", "center")  # of a box on a floor: the points by which it is named as a whole


class WithSurfaces(Protocol):
    """What a scene declares, its surfaces as well."""

    @property
    def surfaces(self) -> tuple[Surface, ...]: ...


class LeanedOn(Surface, frozen=True):
    """What a rod leans on with its side: it pushes square to the rod, so that only the rod tells which way."""

    word = "edge"
    away = "perpendicular to the rod"
    into = "perpendicular to the rod"


def leaning(item: Touch, grip: Friction, scene: SceneElements) -> Leans | None:
    """A contact as that of a rod that leans with its side: on an edge, on a corner of a body, or at a told place on what is round."""
    own, under = item.touches()[:2]
    bodies = {body.name: body for body in scene.bodies}
    body = bodies.get(own.owner)
    if (
        body is None
        or scene.space
        or len(item.touches()) > 2
        or not shape_of(body).slender
        or own.point in ENDS
        or own.point in rims(body)
    ):
        return None
    below = bodies.get(under.owner)
    surface = next((one for one in cast("WithSurfaces", scene).surfaces if one.name == under.owner), None)
    if surface is not None and (surface.bearer() or not isinstance(surface, (Corner, Dome))):
        return None
    if below is not None:
        cornered = under.point is not None and under.point in corners(below)
        if not (cornered or (own.point is not None and rim_radius(below, under.point) is not None)):
            return None
    alone = sum(other.touches()[:1] == (own,) or other.lying() == own.owner for other in scene.connections) == 1
    pivots = grip.kind == "any" and own.point is not None and isinstance(surface, Corner) and alone
    return Leans(name=item.name, contact=(own, under), friction=grip, pivots=pivots)


def corners(body: Body) -> tuple[str, ...]:
    return tuple(point for point in shape_of(body).points if point.startswith("corner"))


class Leans(Touch, frozen=True):
    """A rod that leans on an edge with its side: N square to the rod, friction along it. A contact of a rod."""

    word = "contact"
    pointed = ("contact",)
    leaning = True

    contact: tuple[PointRef, ...] = ()
    friction: Friction = field(default_factory=Friction)
    pivots: bool = False  # whether it is on a fixed edge alone, rough enough for anything, and turns about that

    def grip(self) -> Friction:
        return self.friction

    def fixed_points(self) -> tuple[PointRef, ...]:
        return self.contact[:1] if self.pivots else ()

    def rests(self, body: Body) -> bool:
        return False

    def check(self, scene: Surroundings) -> None:
        """On what pushes square to it, at a place that is told, or that the height of the edge above its foot tells."""
        ref, under = self.contact
        surface, carrier = scene.surfaces.get(under.owner), scene.bodies.get(under.owner)
        if carrier is not None and carrier.name == ref.owner:
            raise Unsolvable(f"`{ref.owner}` leans on itself", span=under.span)
        if scene.bodies[ref.owner].moved:
            raise Unsolvable(
                f"a given motion of `{ref.owner}`, which leans on `{under.owner}`, is not solved yet", span=ref.span
            )
        foot = any(
            other.lying() == ref.owner and other.touches()[0].point in ENDS for other in scene.problem.connections
        )
        if ref.point is None and (isinstance(surface, Dome) or not foot):
            help = f"`{ref.owner}.at(x)` is x from its start"
            raise Unsolvable(
                f"where along `{ref.owner}` it leans on `{under.owner}` nothing tells", span=ref.span, help=help
            )
        rolls = isinstance(surface, Dome) or (carrier is not None and rim_radius(carrier, under.point) is not None)
        if len(scene.problem.states) > 1 and ref.point is not None and (rolls or self.friction.kind == "none"):
            message = f"where along `{ref.owner}` it leans on `{under.owner}` from state to state is not solved yet"
            raise Unsolvable(message, span=ref.span, help="ask for one moment, with the place there")

    def surface(self, configuration: Surroundings, state: str) -> Surface | None:
        return LeanedOn(self.contact[1].owner)

    def round(self, configuration: Surroundings) -> Formula:
        """Radius of what it leans on, 0 of an edge."""
        under = self.contact[1]
        if under.owner in configuration.bodies:
            return rim_radius(configuration.bodies[under.owner], under.point) or ZERO
        surface = configuration.surfaces[under.owner]
        return (surface.radius() if isinstance(surface, Curved) else None) or ZERO

    def along(self, instant: Moment) -> Heading:
        """How the rod runs, from its start to its end."""
        return heading(instant.angle_of(self.contact[0].owner))

    def normal(self, surface: Surface, instant: Moment) -> Heading:
        """Square to the rod, out of what it leans on: up where that is certain, else on the left of the way from its start to its end."""
        out = self.along(instant).turned(90)
        ahead = total_along(out, self.outward(instant))
        return out.turned(180) if instant.configuration.signs.sign(ahead) == -1 else out

    def outward(self, instant: Moment) -> list[Vector]:
        """The directions between which an edge can push: away from both sides that meet there; up of what is round."""
        under = self.contact[1]
        surface, carrier = (
            instant.configuration.surfaces.get(under.owner),
            instant.configuration.bodies.get(under.owner),
        )
        if isinstance(surface, Corner):
            surface.height()  # which has to be said of an edge, and only matters where the rod stands on the floor
            return [unit(UP), unit(LEFT if surface.side == "right" else RIGHT)]
        if carrier is None or under.point not in corners(carrier):
            return [unit(UP)]
        names = corners(carrier)
        number = names.index(under.point or "")
        beside = (names[number - 1], names[(number + 1) % len(names)])
        return [instant.point(under) - instant.point(PointRef(under.owner, name)) for name in beside]

    def place_on_rod(self, instant: Moment) -> PointRef:
        """The point of the rod that touches: as told, else as high above the foot as the edge is above the floor, h = x sin θ."""
        ref, high = self.contact[0], self.height(instant)
        rise = self.along(instant).sin()
        if ref.point is None and high is None:
            message = f"how high `{self.contact[1].owner}` is above the foot of `{ref.owner}` nothing tells"
            raise Unsolvable(message, span=ref.span, help=f"`{ref.owner}.at(x)` is x from its start")
        foot = self.foot(instant)
        if high is None or foot is None:
            return ref
        if ref.point is None:
            start = instant.point(PointRef(ref.owner, "start")), instant.point(foot[0])
            before = (start[1] - start[0]).along(self.along(instant))
            return PointRef(ref.owner, "at", simplify(before + high / rise), span=ref.span)
        gap = simplify((instant.point(ref) - instant.point(foot[0])).along(UP) - high)
        if gap != ZERO and not has_quantities(gap) and instant.configuration.signs.decide(gap) != 0:
            message = f"as `{ref.owner}` stands, that place is not as high above its foot as `{self.contact[1].owner}` is above `{foot[1]}`"
            raise Unsolvable(message, span=ref.span, help=f"leave the place out: `contact: [{ref.owner}, …]`")
        return ref

    def foot(self, instant: Moment) -> tuple[PointRef, str] | None:
        """The end with which the rod stands on a level floor, and that."""
        for other in instant.configuration.connections(instant.state):
            if other.lying() == self.contact[0].owner and other.touches()[0].point in ENDS:
                floor = instant.configuration.surfaces.get(other.places()[0].owner)
                if floor is not None and floor.level:
                    return other.touches()[0], floor.name
        return None

    def height(self, instant: Moment) -> Formula | None:
        """How high above the floor of the foot it touches: an edge as told, a box by its side, what rolls there at R + R cos θ."""
        under, configuration, foot = self.contact[1], instant.configuration, self.foot(instant)
        if foot is None:
            return None
        if under.owner not in configuration.bodies:
            return configuration.surfaces[under.owner].height()
        laid = [item for item in configuration.connections(instant.state) if item.lying() == under.owner]
        if [item.places()[0].owner for item in laid] != [foot[1]]:
            return None
        radius = self.round(configuration)
        if radius != ZERO:
            return simplify(radius + radius * self.normal(LeanedOn(""), instant).sin())
        carrier, own = configuration.bodies[under.owner], laid[0].touches()[0]
        if own.point not in FLAT_ON or instant.motion(under.owner).turns:
            return None
        return simplify((instant.point(under) - instant.point(PointRef(under.owner, corners(carrier)[0]))).along(UP))

    def touching_arm(self, instant: Moment) -> Vector:
        return instant.point(self.place_on_rod(instant))

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """N square to the rod, on both; the rod stays on the edge; friction along the rod."""
        ref, edge = self.contact[0], LeanedOn(self.contact[1].owner)
        name, facing, arm = instant.host(ref.owner), self.normal(edge, instant), self.touching_arm(instant)
        size = instant.ask("normal_force", self.name, when=instant.span(name))
        force = Force(
            self.name, NORMAL, name, size, unit(facing), arm, "normal force", edge.away, works=False, internal=True
        )
        yield from self.both(force, instant, "push", edge.into, ref.owner)
        kept = f"{spoken(ref.owner)} stays on the {spoken(edge.name)}"
        yield Requirement(self.name, TOUCHES, size, ZERO, kept, f"{spoken(ref.owner)} leaves the {spoken(edge.name)}")
        for side in self.outward(instant):
            ahead = simplify(side.along(facing))
            if instant.configuration.signs.sign(ahead) not in (0, 1):
                yield Requirement(self.name, LIES, ahead, ZERO, "", f"{spoken(ref.owner)} lies in {spoken(edge.name)}")
        if ref.point is None:
            room, reach = rod_room(ref.owner, instant), self.place_on_rod(instant).argument or ZERO
            if instant.configuration.signs.sign(room - reach) not in (0, 1):
                short = f"{spoken(ref.owner)} does not reach {spoken(edge.name)}"
                yield Requirement(self.name, LIES, simplify(room - reach), ZERO, "", short)
        rubbing = self.friction_facts(instant, name, arm, edge, size)
        if self.pivots:  # the laws of what turns about an axis hold it there
            yield from (fact for fact in rubbing if not isinstance(fact, Rule))
            return
        yield self.stays(kept, arm, facing, instant)
        yield from rubbing
        if instant.mode(self.name).startswith("slips") and len(instant.configuration.problem.states) > 1:
            message = f"how `{ref.owner}` slips on `{edge.name}` from state to state is not solved yet"
            raise Unsolvable(message, span=ref.span, help="ask for the moment in which it begins to slip")

    def stays(self, label: str, arm: Vector, facing: Heading, instant: Moment) -> Rule:
        """Square to the rod v · n = v_O · n and a · n = a_O · n + 2 ω (v − v_O) · t + ω² R, O the edge or the centre of what is round."""
        rod, radius = instant.motion(self.contact[0].owner), self.round(instant.configuration)
        velocity, acceleration = NOWHERE, NOWHERE
        carrier = self.carrier(instant.configuration)
        if carrier:
            below = instant.motion(carrier)
            centre = self.underneath(instant) + unit(facing.turned(180)).times(radius)
            velocity, acceleration = below.velocity_of(centre), below.acceleration_of(centre)
        ahead = facing.turned(-90)
        sliding = (rod.velocity_of(arm) - velocity).along(ahead)
        own = rod.velocity_of(arm).along(facing), rod.acceleration_of(arm).along(facing)
        bend = acceleration.along(facing) + 2 * rod.spin * sliding + square(rod.spin) * radius
        bodies = tuple(instant.host(name) for name in (self.contact[0].owner, carrier) if name)
        return Rule(self.name, label, bodies, (own[0], velocity.along(facing)), (own[1], bend), linear=False)

    def place(self, name: str, way: Heading, instant: Moment, place_of: PlaceOf) -> Formula | None:
        """While it does not slip on a fixed edge it turns about that."""
        own, under = self.contact
        fixed = self.friction.kind != "none" and not instant.mode(self.name).startswith("slips")
        if instant.host(own.owner) != name or under.owner in instant.configuration.bodies or own.point is None:
            return None
        return -self.touching_arm(instant).along(way) if fixed and self.round(instant.configuration) == ZERO else None

    def ways_along(self, instant: Moment, name: str) -> tuple[str, str]:
        """Along the rod, the way that counts as positive first."""
        ahead = self.forward(instant) == self.along(instant)
        ways = ("along the rod towards its end", "along the rod towards its start")
        return ways if ahead else ways[::-1]

    def pace(self, configuration: Surroundings, state: str) -> str:
        return "position"


def rod_room(name: str, instant: Moment) -> Formula:
    """How far it is along a rod from its start to its end."""
    ends = (instant.point(PointRef(name, end)) for end in ENDS)
    start, end = ends
    return (end - start).along(heading(instant.angle_of(name)))


def total_along(out: Heading, sides: list[Vector]) -> Formula:
    found: Formula = ZERO
    for side in sides:
        found = found + side.along(out)
    return simplify(found)
