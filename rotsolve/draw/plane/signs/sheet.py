"""Sheet: the paper of a scene: metres become points of paper, and the usual signs are drawn there, such as hatching and round arrows."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

from rotsolve.draw.paper.figure import (
    BODY,
    DIMENSION,
    GHOST,
    HATCH,
    HOLE,
    PIN,
    SOLID,
    STRING,
    SUPPORT,
    SURFACE,
    Figure,
    InkRole,
    Point,
    arc_points,
    quarter,
    ray,
    shifted_by,
    unit_of,
)
from rotsolve.draw.paper.labels import Lettering
from rotsolve.draw.paper.lettering import Words
from rotsolve.draw.plane.places.outlines import BodyOutline

DOT, STOUT = 3.0, 2.3  # radius of a point, half width of a rod
STROKE, EVERY = 5.5, 5.5  # of hatching: how long, how far apart
HUB, STAND = 2.2, 10.0  # radius of a pin, height of its support
ARROW = 26.0  # of a sense
SPREAD = 15.0  # from a body to its dimension line


class ScenePaper:
    """A figure with its labels, and the scale on which metres are drawn."""

    def __init__(self, scale: float, title: str = "", description: str = "") -> None:
        self.scale = scale
        self.figure = Figure(title, description)
        self.letters = Lettering()

    def at(self, place: Point) -> Point:
        """A place of the scene on paper."""
        return place[0] * self.scale, place[1] * self.scale

    def finished(self) -> Figure:
        """The figure with its labels."""
        self.letters.place(self.figure)
        return self.figure

    # bodies

    def outline(self, outline: BodyOutline, ghost: bool = False) -> None:
        """A part of a body; `ghost` for one at another state."""
        points = [self.at(point) for point in outline.points]
        role = GHOST if ghost else HOLE if outline.cut else BODY
        if outline.radius is not None:
            radius = outline.radius * self.scale
            small = outline.radius == 0.0
            self.figure.circle(points[0], DOT if small else radius, (GHOST if ghost else SOLID) if small else role)
        elif outline.light:
            self.figure.line(points, GHOST if ghost else STRING)
        elif outline.slender:
            self.figure.line(widened(points, STOUT), role, closed=True)
        else:
            self.figure.line(points, role, closed=True)

    # signs

    def hatched(self, points: Sequence[Point], inwards: int = -1, role: InkRole = SURFACE) -> None:
        """A surface along paper points, with hatching on its right (−1) or left (+1)."""
        self.figure.line(points, role)
        left = EVERY / 2
        for start, end in itertools.pairwise(points):
            way = (end[0] - start[0], end[1] - start[1])
            long, along = math.hypot(*way), unit_of(way)
            side = quarter(along)
            slant = unit_of((along[0] * -0.75 + side[0] * inwards, along[1] * -0.75 + side[1] * inwards))
            while left < long:
                foot = shifted_by(start, along, left)
                self.figure.line([foot, shifted_by(foot, slant, STROKE)], HATCH)
                left += EVERY
            left -= long

    def patch(self, middle: Point, out: Point, wide: float = 26.0) -> None:
        """A piece of something fixed at a paper point, hatched on the side that `out` leaves."""
        side = quarter(out)
        self.hatched([shifted_by(middle, side, wide / 2), shifted_by(middle, side, -wide / 2)])

    def pin(self, at: Point, away: Point = (0.0, 1.0), stands: bool = True) -> None:
        """A hinge at a paper point, on a support that lies in the direction `away`."""
        if stands:
            foot, side = shifted_by(at, away, STAND), quarter(away)
            self.figure.line([at, shifted_by(foot, side, 5.5), shifted_by(foot, side, -5.5)], SUPPORT, closed=True)
            self.patch(foot, (-away[0], -away[1]), 24.0)
        self.figure.circle(at, HUB, PIN)

    def prop(self, at: Point) -> None:
        """An edge on which something lies."""
        top = (at[0], at[1] - STOUT)
        foot = (top[0], top[1] - STAND - 2.0)
        self.figure.line([top, (foot[0] + 7.0, foot[1]), (foot[0] - 7.0, foot[1])], SUPPORT, closed=True)
        self.patch(foot, (0.0, 1.0), 26.0)

    def hub(self, at: Point) -> None:
        """The axle of a wheel."""
        self.figure.circle(at, 1.7, SOLID)

    def arrow(
        self, start: Point, way: Point, size: float, role: InkRole, words: Words | None = None, tag: str = ""
    ) -> None:
        """An arrow from a paper point, with words at its tip."""
        tip = shifted_by(start, way, size)
        self.figure.line([start, tip], role, heads=">", tag=tag)
        if words is not None:
            self.letters.name(words, tip, way, 3.0, role.ink)

    def round_arrow(
        self,
        centre: Point,
        radius: float,
        start: float,
        turn: float,
        role: InkRole,
        words: Words | None = None,
        tag: str = "",
    ) -> None:
        """An arrow round a paper point, from an angle through a turn in radians, with words at its middle."""
        self.figure.line(arc_points(centre, radius, start, start + turn), role, heads=">", tag=tag)
        if words is not None:
            middle = ray(start + turn / 2)
            self.letters.name(words, shifted_by(centre, middle, radius), middle, 3.0, role.ink)

    def dimension(self, first: Point, second: Point, words: Words, off: float = SPREAD) -> None:
        """A dimension line between two paper points, so far on the left of the way from one to the other."""
        way = unit_of((second[0] - first[0], second[1] - first[1]))
        side = quarter(way)
        ends = [shifted_by(point, side, off) for point in (first, second)]
        sign = math.copysign(1.0, off)
        for point, end in zip((first, second), ends, strict=True):
            self.figure.line([shifted_by(point, side, sign * 3.5), shifted_by(end, side, sign * 2.5)], DIMENSION)
        self.figure.line(ends, DIMENSION, heads="<>")
        middle = ((ends[0][0] + ends[1][0]) / 2, (ends[0][1] + ends[1][1]) / 2)
        self.letters.name(words, middle, (side[0] * sign, side[1] * sign), 2.0)

    def radius(self, centre: Point, radius: float, angle: float, words: Words) -> None:
        """A radius of a circle on paper, with its letter beside the middle of it."""
        self.figure.line([centre, shifted_by(centre, ray(angle), radius)], DIMENSION, heads=">")
        middle = shifted_by(centre, ray(angle), 0.6 * radius)
        self.letters.name(words, middle, quarter(ray(angle)), 1.5)

    def angle(self, vertex: Point, radius: float, start: float, end: float, words: Words) -> None:
        """The arc of an angle with its letter."""
        self.figure.line(arc_points(vertex, radius, start, end), DIMENSION)
        middle = ray((start + end) / 2)
        self.letters.name(words, shifted_by(vertex, middle, radius), middle, 1.5)


def widened(points: Sequence[Point], half: float) -> list[Point]:
    """The outline of a stout line through points."""
    sides: list[Point] = []
    for k, _point in enumerate(points):
        before, after = points[max(k - 1, 0)], points[min(k + 1, len(points) - 1)]
        sides.append(quarter(unit_of((after[0] - before[0], after[1] - before[1]))))
    ends = list(zip(points, sides, strict=True))
    return [shifted_by(p, s, half) for p, s in ends] + [shifted_by(p, s, -half) for p, s in reversed(ends)]
