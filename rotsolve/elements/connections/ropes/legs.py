"""Legs: the course of a string at one moment: its straight parts, their directions, and where they meet bodies."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.formula import ZERO
from rotsolve.core.vectors.heading import DOWN, LEFT, RIGHT, UP, Heading, Vector, unit
from rotsolve.elements.connections.places import between
from rotsolve.elements.rims import rim_radius
from rotsolve.elements.sides import rough
from rotsolve.elements.surfaces import Surface, Wall
from rotsolve.language.problem import PointRef

if TYPE_CHECKING:
    from rotsolve.motion.instant import Instant

WORDS = {"right": RIGHT, "left": LEFT, "up": UP, "down": DOWN}


class Leg(Struct, frozen=True):
    """The straight part of a string between two neighbours: unit vector from the first to the second, and the two ends."""

    first: PointRef
    second: PointRef
    along: Vector
    arms: tuple[Vector, Vector]  # from the reference of either body; nothing for what does not move


class Course(Struct, frozen=True, dict=True):
    """What a string touches, in order, and what the scene says of how it runs: by body the way it pulls, wheels passed under, a surface."""

    points: tuple[PointRef, ...]
    pulls: Mapping[str, str]
    under: tuple[str, ...]
    along: str | None
    instant: Instant

    @cached_property
    def legs(self) -> tuple[Leg, ...]:
        """All legs, with the points where they meet the bodies."""
        pairs = list(pairwise(self.points))
        along = [self.direction(index) for index in range(len(pairs))]
        result = []
        for index, (first, second) in enumerate(pairs):
            arms = (self.meeting(index, along, index), self.meeting(index + 1, along, index))
            result.append(Leg(first, second, along[index], arms))
        return tuple(result)

    def direction(self, index: int) -> Vector:
        """Unit vector of a leg from its first to its second body, by whichever end settles it."""
        leaving = self.leaving(index, index + 1)
        if leaving is not None:
            return leaving
        arriving = self.leaving(index + 1, index)
        if arriving is not None:
            return -arriving
        return unit(RIGHT)

    def leaving(self, index: int, other: int) -> Vector | None:
        """Direction in which the string leaves a body towards its neighbour, where that body settles it."""
        ref, neighbour = self.points[index], self.points[other]
        pulled = self.pulls.get(ref.owner)
        if pulled is not None:
            return unit(WORDS[pulled])
        configuration = self.instant.configuration
        surface = configuration.surfaces.get(self.along or "")
        if surface is not None and any(self.travels(owner, surface) for owner in (ref.owner, neighbour.owner)):
            return unit(uphill(surface) if ref.owner in configuration.bodies else uphill(surface).turned(180))
        if ref.owner == "ceiling":
            return unit(DOWN)
        if isinstance(configuration.surfaces.get(ref.owner), Wall):
            return unit(configuration.surfaces[ref.owner].normal)
        geometric = between(ref, neighbour, self.instant)
        if geometric is not None:
            return geometric
        return self.leaving_mover(index, other) if ref.owner in configuration.bodies else None

    def travels(self, owner: str, surface: Surface) -> bool:
        """Whether a body travels along a surface."""
        instant = self.instant
        line = instant.line(instant.host(owner)) if owner in instant.configuration.bodies else None
        return line is not None and (line[0] - uphill(surface)).sin() == ZERO

    def leaving_mover(self, index: int, other: int) -> Vector | None:
        """Direction in which the string leaves a body that travels.

        A hanging body is pulled up, one on a slope up the slope, one on the level towards its neighbour; a travelling pulley is
        pulled up where the string passes under it, down where it passes over.
        """
        ref, neighbour = self.points[index], self.points[other]
        line = self.instant.line(self.instant.host(ref.owner))
        if line is None:
            hinged = ref.point not in (None, "rim", "center") and self.instant.configuration.heavy
            if not hinged or self.wraps(index):
                return None
            hanging = neighbour.owner in self.instant.configuration.bodies and self.same_line(other)
            return unit(DOWN if hanging else UP)
        direction, words = line
        if words.endswith("slope"):
            return unit(direction if words.startswith("up") else direction.turned(180))
        if direction.sin() == ZERO:
            return unit(RIGHT if other > index else LEFT)
        if self.wraps(index):
            if index in (0, len(self.points) - 1):
                return None if neighbour.owner == "ceiling" else unit(UP)
            return unit(UP if ref.owner in self.under else DOWN)
        lower = other > index and neighbour.owner in self.instant.configuration.bodies and self.same_line(other)
        return unit(DOWN if lower else UP)

    def same_line(self, index: int) -> bool:
        """Whether a neighbour hangs below: it travels too and the string does not go round it."""
        owner = self.points[index].owner
        return self.instant.configuration.line(owner, self.instant.state) is not None and not self.wraps(index)

    def wraps(self, index: int) -> bool:
        """Whether the string runs on a rim there: a round body named alone, by `rim`, or by one of its radii."""
        ref = self.points[index]
        if ref.owner not in self.instant.configuration.bodies or not self.instant.is_round(ref.owner):
            return False
        radii = {name for name, _ in self.instant.body(ref.owner).radii} | {"inner", "outer"}
        return ref.point is None or ref.point == "rim" or ref.point in radii

    def meeting(self, station: int, along: list[Vector], leg: int) -> Vector:
        """Where a leg meets a body: the tangent point of a rim, on the left of the running string when it turns clockwise."""
        ref = self.points[station]
        if ref.owner not in self.instant.configuration.bodies:
            return Vector()
        if not self.wraps(station):
            return self.instant.point(ref)
        centre = self.instant.point(PointRef(ref.owner, "center"))
        radius = rim_radius(self.instant.body(ref.owner), ref.point) or ZERO
        if self.light(station):
            return centre
        return centre + along[leg].turned(90 * self.clockwise(station, along)).times(radius)

    def clockwise(self, station: int, along: list[Vector]) -> int:
        """+1 where the running string turns a wheel clockwise: over from left to right, or under from right to left."""
        legs = [along[index] for index in (station - 1, station) if 0 <= index < len(along)]
        leftward = any(rough(leg.along(RIGHT)) < -1e-9 for leg in legs)
        return -1 if (self.points[station].owner in self.under) != leftward else 1

    def light(self, station: int) -> bool:
        """Whether the string just passes a pulley without inertia: the same tension on both sides."""
        if station in (0, len(self.points) - 1) or not self.wraps(station):
            return False
        name = self.instant.host(self.points[station].owner)
        weightless = all(piece.moment == ZERO for piece in self.instant.frame(name).pieces)
        return weightless and not self.instant.configuration.driven(name, self.instant.state)

    def strands(self) -> tuple[tuple[Leg, ...], ...]:
        """Runs of legs with one tension: cut at every pulley that has inertia."""
        strands: list[list[Leg]] = [[self.legs[0]]]
        for index in range(1, len(self.legs)):
            if self.light(index):
                strands[-1].append(self.legs[index])
            else:
                strands.append([self.legs[index]])
        return tuple(tuple(strand) for strand in strands)

    def end_of(self, strand: tuple[Leg, ...]) -> str:
        """The body that names a strand: one that it ends at without passing round it, else its first."""
        stations = [(leg, side) for leg in strand for side in (0, 1)]
        for leg, side in stations:
            ref = (leg.first, leg.second)[side]
            index = self.points.index(ref)
            if ref.owner in self.instant.configuration.bodies and not self.wraps(index):
                return ref.owner
        return strand[0].first.owner or strand[0].second.owner


def uphill(surface: Surface) -> Heading:
    """Direction up a slope."""
    return surface.travel("up")[0]
