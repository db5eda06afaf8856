"""Routing: how a string runs between what it touches: the direction of each leg, where it meets a rim, what has one tension.

A string is drawn from left to right in the order in which it is written. Each leg between two neighbours has a direction, from the
earlier to the later. Round a wheel it passes over the top (clockwise from left to right) unless it is said to pass under.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cached_property, partial
from itertools import pairwise

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ONE, ZERO, negate
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import (
    DOWN,
    LEFT,
    NOWHERE,
    RIGHT,
    UP,
    WORDS,
    Heading,
    Vector,
    opposite,
    unit,
)
from rotsolve.elements.connections.lying import supporting
from rotsolve.elements.connections.places import between, rightward
from rotsolve.elements.shapes import rim_radius, rims, round_part
from rotsolve.language.bodies import PointRef, Surface
from rotsolve.language.elements import Moment


class Leg(Struct, frozen=True):
    """The straight part of a string between two neighbours: unit vector from the first to the second, and the two ends."""

    first: PointRef
    second: PointRef
    along: Vector
    arms: tuple[Vector, Vector]  # from the reference of either body; nothing for what does not move


class Routing(Struct, frozen=True, dict=True):
    """What a string touches, in order, and what the scene says of how it runs: by body the way it pulls, wheels passed under, a surface."""

    name: str
    points: tuple[PointRef, ...]
    pulls: Mapping[str, str]
    under: tuple[str, ...]
    along: str | None
    instant: Moment

    @cached_property
    def legs(self) -> tuple[Leg, ...]:
        """All legs, with the points where they meet the bodies."""
        self.check_along()
        pairs = list(pairwise(self.points))
        along = [self.direction(index) for index in range(len(pairs))]
        ends = [(self.meeting(k, along, k), self.meeting(k + 1, along, k)) for k in range(len(pairs))]
        return tuple(Leg(*pair, way, arms) for pair, way, arms in zip(pairs, along, ends, strict=True))

    def check_along(self) -> None:
        """Something that the string touches travels along the surface that it is said to run along."""
        surface = self.instant.configuration.surfaces.get(self.along or "")
        if surface is not None and not any(self.travels(ref.owner, surface) for ref in self.points):
            message = f"nothing that `{self.name}` touches travels along `{self.along}`"
            help = "say by `pulls` which way it pulls a body"
            raise Unsolvable(message, span=self.points[0].span, help=help)

    def direction(self, index: int) -> Vector:
        """Unit vector of a leg from its first to its second body: as `pulls` says of either, else by whichever end settles it."""
        said, held = self.said(index), self.settled(index, self.fixed)
        if held is not None:
            return self.agreed(index, said, held)
        if said.parts:
            return said
        self.check_straight(index)
        ways = (
            self.settled(index, leaving) for leaving in (self.leaving_mover, self.leaving_hinged, self.leaving_carried)
        )
        way = self.abreast(index) or next((way for way in ways if way is not None), None)
        if way is None:
            self.check_slung(index)
        return way or unit(RIGHT)

    def check_slung(self, index: int) -> None:
        """A wheel that nothing guides does not hang in a string that passes under it without a word of where it runs from there."""
        configuration, state = self.instant.configuration, self.instant.state
        slung = [ref for ref in self.points[index : index + 2] if ref.owner in self.under and configuration.heavy]
        for ref in slung:
            held = configuration.pivot(self.instant.host(ref.owner), state)
            if held is None and supporting(self.mover(ref.owner), configuration, state) is None:
                message = f"which way `{self.name}` runs from `{ref.owner}` nothing tells"
                help = f"say `moves: up` of `{ref.owner}`, or which way it `pulls` it"
                raise Unsolvable(message, span=ref.span, help=help)

    def check_straight(self, index: int) -> None:
        """A straight piece does not pull each of two bodies along another line: a block on a table, a load that falls."""
        first, second = self.points[index : index + 2]
        one, other = (self.line(ref.owner) for ref in (first, second))
        if self.wraps(index) or self.wraps(index + 1) or one is None or other is None or (one - other).sin() == ZERO:
            return
        message = f"`{first.owner}` and `{second.owner}` travel along different lines, with nothing that the string runs over between"
        help = "name the pulley, a light one with `mass: 0`; or say by `pulls` which way it pulls, if it runs straight"
        raise Unsolvable(message, span=second.span, help=help)

    def abreast(self, index: int) -> Vector | None:
        """The direction of a leg between two bodies that travel along one line, level or sloping: from left to right."""
        pair = self.points[index : index + 2]
        if any(self.wraps(index + k) and not self.at_end(index + k) for k in (0, 1)):
            return None
        lines = [self.line_led(ref.owner) for ref in pair]
        if lines[0] is None or lines[1] is None or (lines[0] - lines[1]).sin() != ZERO:
            return None
        right = rightward(lines[0], pair[0], self.instant)
        return None if right is None else unit(right)

    def line(self, owner: str) -> Heading | None:
        """The direction in which a body travels; nothing of what is no body, is carried by another, or turns only."""
        found = self.instant.line(self.instant.host(owner)) if owner in self.instant.configuration.bodies else None
        return None if found is None else found[0]

    def line_led(self, owner: str) -> Heading | None:
        """The direction in which a body travels, or what carries it."""
        found = self.instant.line(self.mover(owner)) if owner in self.instant.configuration.bodies else None
        return None if found is None else found[0]

    def mover(self, owner: str) -> str:
        """The body along whose line another one travels."""
        return self.instant.configuration.mover(owner, self.instant.state)

    def settled(self, index: int, leaving: Callable[[int, int], Vector | None]) -> Vector | None:
        """The direction of a leg by how the string leaves its first end, or else its second."""
        first = leaving(index, index + 1)
        if first is not None:
            return first
        second = leaving(index + 1, index)
        return None if second is None else -second

    def said(self, index: int) -> Vector:
        """Unit vector of a leg as `pulls` says how it pulls one of its ends; nothing where it says of neither."""
        first, second = (self.pulls.get(self.points[station].owner) for station in (index, index + 1))
        if first is not None and second is not None and opposite(first) != second:
            raise self.crossed(self.points[index + 1], second)
        if first:
            return self.worded(index, first)
        return -self.worded(index + 1, second) if second else NOWHERE

    def worded(self, station: int, word: str) -> Vector:
        """Unit vector of a direction at an end: `up` and `down` of what lies on a slope mean along the slope."""
        owner = self.points[station].owner
        bodily = owner in self.instant.configuration.bodies
        surface = supporting(self.mover(owner), self.instant.configuration, self.instant.state) if bodily else None
        if surface is not None and surface.slanted and word in ("up", "down"):
            return unit(surface.travel(word)[0])
        return unit(WORDS[word])

    def agreed(self, index: int, said: Vector, way: Vector) -> Vector:
        """The direction of a leg that does not go against what is said of it."""
        if said.parts and len(way.parts) == 1 and (said.parts[0][1] - way.parts[0][1]).cos() == negate(ONE):
            ref = next(ref for ref in self.points[index : index + 2] if ref.owner in self.pulls)
            raise self.crossed(ref, self.pulls[ref.owner])
        return way

    def crossed(self, ref: PointRef, word: str) -> Unsolvable:
        """Why a string can't pull a body as it is said to."""
        help = f"say `pulls: {{{ref.owner}: {opposite(word)}}}`, or name the bodies in another order"
        return Unsolvable(f"this string can not pull `{ref.owner}` {word}", span=ref.span, help=help)

    def fixed(self, index: int, other: int) -> Vector | None:
        """Direction in which the string leaves a body towards its neighbour, where surfaces or places settle it."""
        ref, neighbour = self.points[index], self.points[other]
        configuration = self.instant.configuration
        surface = configuration.surfaces.get(self.along or "")
        if surface is not None and self.travels(ref.owner, surface) != self.travels(neighbour.owner, surface):
            return unit(uphill(surface) if self.travels(ref.owner, surface) else uphill(surface).turned(180))
        if ref.owner == "ceiling":
            return unit(DOWN)
        if ref.owner in configuration.surfaces and configuration.surfaces[ref.owner].upright:
            return unit(configuration.surfaces[ref.owner].normal)
        return between(ref, neighbour, self.instant)

    def travels(self, owner: str, surface: Surface) -> bool:
        """Whether a body travels along a surface, or what carries it: that one the string pulls up a slope."""
        line = self.line_led(owner)
        return line is not None and (line - uphill(surface)).sin() == ZERO

    def leaving_mover(self, index: int, other: int) -> Vector | None:
        """Direction in which the string leaves a body that travels.

        A hanging body is pulled up, one on a slope up the slope, one on the level towards its neighbour; a travelling pulley is
        pulled up where the string passes under it, down where it passes over.
        """
        ref, neighbour = self.points[index], self.points[other]
        if ref.owner not in self.instant.configuration.bodies:
            return None
        direction = self.line(ref.owner)
        if direction is None:
            return None
        surface = supporting(self.instant.host(ref.owner), self.instant.configuration, self.instant.state)
        if surface is not None and surface.slanted:
            return unit(uphill(surface))
        if direction.sin() == ZERO:
            return unit(RIGHT if other > index else LEFT)
        if self.wraps(index):
            if self.at_end(index):
                return self.leaving_reel(index, other)
            return unit(UP if ref.owner in self.under else DOWN)
        lower = other > index and neighbour.owner in self.instant.configuration.bodies and self.same_line(other)
        return unit(DOWN if lower or self.slung(other) else UP)

    def leaving_hinged(self, index: int, other: int) -> Vector | None:
        """Direction in which the string leaves a point of a body that turns: up, down to what hangs from it."""
        ref, neighbour = self.points[index], self.points[other]
        bodies = self.instant.configuration.bodies
        turns = ref.owner in bodies and self.line(ref.owner) is None and ref.point not in (None, "rim", "center")
        if not turns or not self.instant.configuration.heavy or self.wraps(index):
            return None
        return unit(DOWN if neighbour.owner in bodies and self.same_line(other) else UP)

    def leaving_carried(self, index: int, other: int) -> Vector | None:
        """Direction in which the string leaves what is carried by a body that travels, where nothing else settles it: as it leaves that."""
        owner = self.points[index].owner
        direction = self.line_led(owner)
        if direction is None or self.line(owner) is not None:
            return None
        surface = supporting(self.mover(owner), self.instant.configuration, self.instant.state)
        if surface is not None and surface.slanted:
            return unit(uphill(surface))
        level = direction.sin() == ZERO
        return unit(UP if not level else RIGHT if other > index else LEFT)

    def slung(self, index: int) -> bool:
        """Whether a wheel that travels up and down hangs in the string, which runs up from it on both sides."""
        line = self.line(self.points[index].owner)
        upright = line is not None and line.sin() != ZERO
        return upright and self.wraps(index) and not self.at_end(index) and self.points[index].owner in self.under

    def leaving_reel(self, index: int, other: int) -> Vector | None:
        """Direction in which a string leaves what travels up and down and has its end wound on it: up, save where a body hangs from it."""
        line = self.line(self.points[other].owner)
        if line is None or line.sin() == ZERO:
            return unit(UP)
        if self.wraps(other) and self.at_end(other):  # of two reels the first hangs higher
            return unit(DOWN if other > index else UP)
        return None  # a weight is pulled up, a travelling pulley as the string runs over or under it

    def at_end(self, index: int) -> bool:
        """Whether the string ends there."""
        return index in (0, len(self.points) - 1)

    def same_line(self, index: int) -> bool:
        """Whether a neighbour hangs below: it travels too and the string does not go round it."""
        return not self.wraps(index) and self.line(self.points[index].owner) is not None

    def wraps(self, index: int) -> bool:
        """Whether the string runs on a rim there: a round body named alone, by `rim`, or by one of its radii."""
        ref = self.points[index]
        if ref.owner not in self.instant.configuration.bodies:
            return False
        body = self.instant.body(ref.owner)
        if ref.point in (None, "rim"):
            return self.instant.is_round(ref.owner)
        return ref.point in rims(body) or round_part(body, ref.point) is not None

    def meeting(self, station: int, along: list[Vector], leg: int) -> Vector:
        """Where a leg meets a body: the tangent point of a rim, on the left of the running string when it turns clockwise."""
        ref = self.points[station]
        if ref.owner not in self.instant.configuration.bodies:
            return Vector()
        if not self.wraps(station):
            return self.instant.point(ref)
        return self.instant.hub(ref) if self.light(station) else self.tangent(station, along, leg)

    def tangent(self, station: int, along: list[Vector], leg: int) -> Vector:
        """Where a leg leaves the rim of a wheel."""
        ref = self.points[station]
        radius = rim_radius(self.instant.body(ref.owner), ref.point) or ZERO
        return self.instant.hub(ref) + along[leg].turned(90 * self.clockwise(station, along)).times(radius)

    def clockwise(self, station: int, along: list[Vector]) -> int:
        """+1 where the running string turns a wheel clockwise: over from left to right, or under from right to left."""
        legs = [along[index] for index in (station - 1, station) if 0 <= index < len(along)]
        question = f"whether the string runs to the left or right round `{self.points[station].owner}`"
        decide = partial(self.instant.configuration.certain_sign, question=question, span=self.points[station].span)
        leftward = any(decide(leg.along(RIGHT)) < 0 for leg in legs)
        return -1 if (self.points[station].owner in self.under) != leftward else 1

    def light(self, station: int) -> bool:
        """Whether the string just passes a pulley without inertia, which nothing else turns: the same tension on both sides."""
        ref, configuration = self.points[station], self.instant.configuration
        if self.at_end(station) or not self.wraps(station) or self.instant.hub(ref).parts:
            return False
        name = self.instant.host(ref.owner)
        return self.instant.weightless(name) and not configuration.driven(name, self.instant.state, self.name)

    def strands(self) -> tuple[tuple[Leg, ...], ...]:
        """Runs of legs with one tension: cut at every pulley that has inertia."""
        strands: list[list[Leg]] = [[self.legs[0]]]
        for index in range(1, len(self.legs)):
            if self.light(index):
                strands[-1].append(self.legs[index])
            else:
                strands.append([self.legs[index]])
        return tuple(tuple(strand) for strand in strands)

    def to_rims(self) -> Iterator[tuple[Leg, ...]]:
        """By light pulley: what of its strand lies before it, up to the rim, which goes as fast as the string."""
        along = [leg.along for leg in self.legs]
        for station in filter(self.light, range(1, len(self.legs))):
            strand = next(strand for strand in self.strands() if self.legs[station] in strand)
            last = self.legs[station - 1]
            last = replace(last, arms=(last.arms[0], self.tangent(station, along, station - 1)))
            yield (*strand[: strand.index(self.legs[station - 1])], last)

    def end_of(self, strand: tuple[Leg, ...]) -> str:
        """The body that names a strand: one that it ends at without passing round it, else its first."""
        for ref in (end for leg in strand for end in (leg.first, leg.second)):
            if ref.owner in self.instant.configuration.bodies and not self.wraps(self.points.index(ref)):
                return ref.owner
        return strand[0].first.owner or strand[0].second.owner


def uphill(surface: Surface) -> Heading:
    """Direction up a slope."""
    return surface.travel("up")[0]
