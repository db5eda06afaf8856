"""Strings over and round pulleys and drums: tensions, and the rate rules of a string that neither stretches nor slips.

A string is drawn from left to right in the order in which it is written. Each leg between two neighbours has a direction, from the
earlier to the later; the two ends of a leg move equally fast along it. Round a wheel it passes over the top (clockwise from left
to right) unless it is said to pass under.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import ZERO, Formula, Number, Symbol, negate
from rotsolve.core.directions import along_text, opposite
from rotsolve.core.facts import Force, Requirement, Rule
from rotsolve.core.heading import DOWN, LEFT, RIGHT, UP, Heading, Vector, unit, vector
from rotsolve.core.writing import moved
from rotsolve.elements.connections.connection import Connection, Fact
from rotsolve.elements.connections.contacts import spoken
from rotsolve.elements.rims import rim_radius
from rotsolve.elements.surfaces import Surface, Wall
from rotsolve.scene.keys import key
from rotsolve.scene.model import Body, PointRef

if TYPE_CHECKING:
    from rotsolve.motion.arrangement import Arrangement
    from rotsolve.motion.instant import Instant

_SMALL, _STEP = Fraction(3, 10), Fraction(7, 100)
WORDS = {"right": RIGHT, "left": LEFT, "up": UP, "down": DOWN}


@dataclass(frozen=True)
class Leg:
    """The straight part of a string between two neighbours: unit vector from the first to the second, and the two ends."""

    first: PointRef
    second: PointRef
    along: Vector
    arms: tuple[Vector, Vector]  # from the reference of either body; nothing for what does not move


@dataclass(frozen=True)
class String(Connection):
    """A string over, round and under what it touches, named in order from its first end (on the left) to its last."""

    word = "string"
    about = "a string by what it touches, in order from its first end on the left to its last"
    quantities = ("tension", "force", "work", "power", "impulse", "length")
    words = ("slack", "taut")
    string: tuple[PointRef, ...] = key(
        "points", "what it touches, in order", count=(2, 50), required=True, example="[left, pulley, right]"
    )
    pulls: tuple[tuple[str, str], ...] = key(
        "map of directions",
        "direction in which it pulls a body",
        default=(),
        choices=("left", "right", "up", "down"),
        refers=("body",),
    )
    over: tuple[str, ...] = key(
        "names", "pulleys that it passes over, turning them clockwise (the default)", default=(), refers=("body",)
    )
    under: tuple[str, ...] = key(
        "names", "pulleys that it passes under, turning them counterclockwise", default=(), refers=("body",)
    )
    along: str | None = key("name", "the surface that it runs along", default=None, refers=("surface",))
    mass: Formula | None = key(
        "quantity", "mass of the string", dimension="mass", limits="nonnegative", default=None, letter="m", later=True
    )

    def hangs(self, body: Body) -> bool:
        """A body at an end of a string hangs from it where nothing else says how it travels."""
        ends = (self.string[0], self.string[-1])
        return any(ref.owner == body.name and ref.point in (None, "center") for ref in ends)

    def pace(self, arrangement: Arrangement, state: str) -> str:
        """Constant while all its legs keep their directions: bodies on lines and wheels turning about their centres."""
        for ref in self.string:
            if ref.owner in arrangement.bodies and arrangement.line(ref.owner, state) is None:
                pivot = arrangement.pivot(ref.owner, state)
                if pivot is None or not arrangement.balanced(ref.owner, state):
                    return "position"
        return "constant"

    def facts(self, instant: Instant) -> Iterator[Fact]:
        legs = self.legs(instant)
        for number, strand in enumerate(self.strands(legs, instant)):
            tension = self.tension(strand, legs, instant)
            yield Requirement(
                self.name, tension, ZERO, (tension, " ≥ 0: the string stays taut"), "the string goes slack"
            )
            for leg in strand:
                yield from self.pulls_of(leg, tension, instant)
            yield from self.rules(strand, instant, number)

    def tension_at(self, name: str, instant: Instant) -> Formula | None:
        """Tension of the part that leaves a body or support towards the next one in the list; at the last one, of the part that arrives."""
        index = next((k for k, ref in enumerate(self.string) if ref.owner == name), None)
        if index is None:
            return None
        legs = self.legs(instant)
        wanted = legs[min(index, len(legs) - 1)]
        return next(self.tension(strand, legs, instant) for strand in self.strands(legs, instant) if wanted in strand)

    def legs(self, instant: Instant) -> tuple[Leg, ...]:
        """All legs, with the points where they meet the bodies."""
        pairs = list(zip(self.string, self.string[1:], strict=False))
        along = [self.direction(index, instant) for index in range(len(pairs))]
        result = []
        for index, (first, second) in enumerate(pairs):
            arms = (self.meeting(index, along, index, instant), self.meeting(index + 1, along, index, instant))
            result.append(Leg(first, second, along[index], arms))
        return tuple(result)

    def direction(self, index: int, instant: Instant) -> Vector:
        """Unit vector of a leg from its first to its second body, by whichever end settles it."""
        leaving = self.leaving(index, index + 1, instant)
        if leaving is not None:
            return leaving
        arriving = self.leaving(index + 1, index, instant)
        if arriving is not None:
            return -arriving
        return unit(RIGHT)

    def leaving(self, index: int, other: int, instant: Instant) -> Vector | None:
        """Direction in which the string leaves a body towards its neighbour, where that body settles it."""
        ref, neighbour = self.string[index], self.string[other]
        pulled = dict(self.pulls).get(ref.owner)
        if pulled is not None:
            return unit(WORDS[pulled])
        arrangement = instant.arrangement
        if ref.owner == "ceiling":
            return unit(DOWN)
        surface = arrangement.surfaces.get(self.along or "")
        if surface is not None:
            return unit(uphill(surface) if ref.owner in arrangement.bodies else uphill(surface).turned(180))
        if isinstance(arrangement.surfaces.get(ref.owner), Wall):
            return unit(arrangement.surfaces[ref.owner].normal)
        geometric = between(ref, neighbour, instant)
        if geometric is not None:
            return geometric
        return self.leaving_mover(index, other, instant) if ref.owner in arrangement.bodies else None

    def leaving_mover(self, index: int, other: int, instant: Instant) -> Vector | None:
        """A hanging body is pulled up, one on a slope up the slope, one on the level towards its neighbour; a travelling pulley is
        pulled up where the string passes under it, down where it passes over."""
        ref, neighbour = self.string[index], self.string[other]
        line = instant.arrangement.line(instant.host(ref.owner), instant.state)
        if line is None:
            hinged = ref.point not in (None, "rim", "center") and instant.arrangement.heavy
            return unit(UP) if hinged and not self.wraps(index, instant) else None
        direction, words = line
        if words.endswith("slope"):
            return unit(direction if words.startswith("up") else direction.turned(180))
        if direction.sin() == ZERO:
            return unit(RIGHT if other > index else LEFT)
        if self.wraps(index, instant):
            if index in (0, len(self.string) - 1):
                return None if neighbour.owner == "ceiling" else unit(UP)
            return unit(UP if ref.owner in self.under else DOWN)
        lower = other > index and neighbour.owner in instant.arrangement.bodies and self.same_line(other, instant)
        return unit(DOWN if lower else UP)

    def same_line(self, index: int, instant: Instant) -> bool:
        """Whether a neighbour hangs below: it travels too and the string does not go round it."""
        owner = self.string[index].owner
        return instant.arrangement.line(owner, instant.state) is not None and not self.wraps(index, instant)

    def wraps(self, index: int, instant: Instant) -> bool:
        """Whether the string runs on a rim there: a round body named alone, by `rim`, or by one of its radii."""
        ref = self.string[index]
        if ref.owner not in instant.arrangement.bodies or not instant.is_round(ref.owner):
            return False
        radii = {name for name, _ in instant.body(ref.owner).radii} | {"inner", "outer"}
        return ref.point is None or ref.point == "rim" or ref.point in radii

    def meeting(self, station: int, along: list[Vector], leg: int, instant: Instant) -> Vector:
        """Where a leg meets a body: the tangent point of a rim, on the left of the running string when it turns clockwise."""

        ref = self.string[station]
        if ref.owner not in instant.arrangement.bodies:
            return Vector()
        if not self.wraps(station, instant):
            return instant.point(ref)
        centre = instant.point(PointRef(ref.owner, "center"))
        radius = rim_radius(instant.body(ref.owner), ref.point) or ZERO
        if self.light(station, instant):
            return centre
        return centre + along[leg].turned(90 * self.clockwise(station, along)).times(radius)

    def clockwise(self, station: int, along: list[Vector]) -> int:
        """+1 where the running string turns a wheel clockwise: over from left to right, or under from right to left."""
        legs = [along[index] for index in (station - 1, station) if 0 <= index < len(along)]
        leftward = any(rough(leg.along(RIGHT)) < -1e-9 for leg in legs)
        return -1 if (self.string[station].owner in self.under) != leftward else 1

    def light(self, station: int, instant: Instant) -> bool:
        """Whether the string just passes a pulley without inertia: the same tension on both sides."""
        if station in (0, len(self.string) - 1) or not self.wraps(station, instant):
            return False
        name = instant.host(self.string[station].owner)
        weightless = all(piece.moment == ZERO for piece in instant.frame(name).pieces)
        return weightless and not instant.arrangement.driven(name, instant.state)

    def strands(self, legs: tuple[Leg, ...], instant: Instant) -> tuple[tuple[Leg, ...], ...]:
        """Runs of legs with one tension: cut at every pulley that has inertia."""
        strands: list[list[Leg]] = [[legs[0]]]
        for index in range(1, len(legs)):
            if self.light(index, instant):
                strands[-1].append(legs[index])
            else:
                strands.append([legs[index]])
        return tuple(tuple(strand) for strand in strands)

    def tension(self, strand: tuple[Leg, ...], legs: tuple[Leg, ...], instant: Instant) -> Formula:
        """The tension of a strand, named after the body that it ends at where the string has several."""
        component = "" if len(strand) == len(legs) else self.end_of(strand, instant)
        owner = next(ref.owner for ref in self.string if ref.owner in instant.arrangement.bodies)
        return instant.ask("tension", self.name, when=instant.span(instant.host(owner)), component=component)

    def end_of(self, strand: tuple[Leg, ...], instant: Instant) -> str:
        """The body that names a strand: one that it ends at without passing round it, else its first."""
        stations = [(leg, side) for leg in strand for side in (0, 1)]
        for leg, side in stations:
            ref = (leg.first, leg.second)[side]
            index = self.string.index(ref)
            if ref.owner in instant.arrangement.bodies and not self.wraps(index, instant):
                return ref.owner
        return strand[0].first.owner or strand[0].second.owner

    def pulls_of(self, leg: Leg, tension: Formula, instant: Instant) -> Iterator[Force]:
        """The tension on the bodies at both ends of a leg."""
        for ref, arm, push in ((leg.first, leg.arms[0], leg.along), (leg.second, leg.arms[1], -leg.along)):
            if ref.owner in instant.arrangement.bodies:
                words = (
                    "tension ",
                    tension,
                    told_along(push, ref.owner, instant) or said(push, arm, instant.motion(ref.owner).kind),
                )
                yield Force(self.name, "tension", instant.host(ref.owner), tension, push, arm, words, internal=True)

    def rules(self, strand: tuple[Leg, ...], instant: Instant, number: int) -> Iterator[Rule]:
        """Σ over the legs of (rate of the second end − rate of the first end) along the leg = 0."""
        sides = []
        for rates in (velocity_at, acceleration_at):
            terms = []
            for leg in strand:
                terms.append((rates(instant, leg.second, leg.arms[1]).dot(leg.along), 1))
                terms.append((rates(instant, leg.first, leg.arms[0]).dot(leg.along), -1))
            sides.append(balance([(value, sign) for value, sign in terms if value != ZERO]))
        bodies = tuple(
            {
                ref.owner: None
                for leg in strand
                for ref in (leg.first, leg.second)
                if ref.owner in instant.arrangement.bodies
            }
        )
        turning = any(instant.motion(name).turns for name in bodies) and len(strand) == 1
        label = "the string does not slip" if turning else "the string does not stretch"
        others = [name for name in bodies if not instant.motion(name).turns] if len(self.string) > 2 else []
        label += f", {spoken(others[0])}" if len(others) == 1 else ""
        yield Rule(
            self.name,
            label,
            bodies,
            sides[0],
            sides[1],
            linear=self.pace(instant.arrangement, instant.state) == "constant",
        )


def velocity_at(instant: Instant, ref: PointRef, arm: Vector) -> Vector:
    """Velocity of the point of a body at an arm from its reference; the ground is at rest."""
    return instant.motion(ref.owner).velocity_of(arm) if ref.owner in instant.arrangement.bodies else Vector()


def acceleration_at(instant: Instant, ref: PointRef, arm: Vector) -> Vector:
    """Acceleration along a leg; a rim's centripetal part does not feed the string, which leaves it on a tangent."""
    return instant.motion(ref.owner).acceleration_of(arm) if ref.owner in instant.arrangement.bodies else Vector()


def balance(terms: list[tuple[Formula, int]]) -> tuple[Formula, Formula]:
    """Σ sign · term = 0 as an equation of positive terms: those of the first body on the left, the others moved across."""
    left, right = moved([value if sign > 0 else negate(value) for value, sign in terms], ())
    if left == ZERO or (right != ZERO and not isinstance(left, Symbol) and isinstance(right, Symbol)):
        left, right = right, left
    return left, right


def uphill(surface: Surface) -> Heading:
    """Direction up a slope."""
    return surface.travel("up")[0]


def between(first: PointRef, second: PointRef, instant: Instant) -> Vector | None:
    """Unit vector from a point to another where the scene gives both places: fixed places, and points of bodies on a fixed axis."""
    places = [where(ref, instant) for ref in (first, second)]
    if places[0] is None or places[1] is None or not (first.place or second.place):
        return None
    from rotsolve.algebra.exact.normal import simplify
    from rotsolve.algebra.formula import sqrt

    gap = places[1] - places[0]
    x, y = simplify(gap.along(RIGHT)), simplify(gap.along(UP))
    length = simplify(sqrt(x**2 + y**2))
    return vector(x / length, RIGHT) + vector(y / length, UP)


def where(ref: PointRef, instant: Instant) -> Vector | None:
    """A point in the scene's coordinates: a fixed place, or a point of a body whose fixed pivot is the origin."""
    if ref.place is not None:
        return vector(ref.place[0], RIGHT) + vector(ref.place[1], UP)
    if ref.owner in instant.arrangement.bodies and instant.motion(ref.owner).kind == "axis":
        return instant.point(ref)
    return None


def told_along(push: Vector, name: str, instant: Instant) -> str:
    """A pull along the line on which a body travels, in the words of that line: ", up the slope"."""
    line = instant.arrangement.line(instant.host(name), instant.state)
    if line is None or len(push.parts) != 1:
        return ""
    gap = push.parts[0][1] - line[0]
    if gap.terms or gap.degrees % 180:
        return ""
    return f", {line[1]}" if gap.degrees % 360 == 0 else f", {opposite(line[1])}"


def said(push: Vector, arm: Vector, kind: str) -> str:
    """How a pull is told: its direction for what travels, its turn for what is held on an axis."""

    direction = along_text(push.parts[0][1]) if len(push.parts) == 1 else ""
    if kind == "axis" and arm.parts:
        turn = rough(arm.cross(push))
        sense = "" if abs(turn) < 1e-12 else ", turning it counterclockwise" if turn > 0 else ", turning it clockwise"
        return (f" {direction}" if direction and not sense else "") + sense
    return f", {direction}" if direction else ", along the string"


def rough(value: Formula) -> float:
    """A rough value with every letter set to a small positive number, to tell left from right."""
    from rotsolve.algebra.certified.ball import evaluate

    names = sorted(value.symbols())
    try:
        return evaluate(
            value, {name: Number(_SMALL + _STEP * index) for index, name in enumerate(names)}, digits=3
        ).float
    except ValueError:
        return 0.0
