"""Figure: a picture as lines, circles and labels on paper, each in a role that says how it is drawn. Points of 1/72 inch, y up."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from msgspec import Struct, field

Point = tuple[float, float]
Box = tuple[float, float, float, float]  # left, low, right, high

HEAD, NARROW = 6.5, 2.4  # length and half width of the head of an arrow
SMOOTH = 7.0  # degrees between two points of an arc
MARGIN = 9.0  # round a picture


class InkRole(Struct, frozen=True):
    """How marks of a kind are drawn: width of the line, ink, filling, dashes, and which of them lie above others.

    Ink and filling are names of colours that a writer knows on light and on dark paper; '' is none.
    """

    name: str
    width: float = 0.9
    ink: str = "ink"
    fill: str = ""
    dash: str = ""
    layer: int = 0


SURFACE = InkRole("surface", 1.1, layer=1)
GROUND = InkRole("ground", 0.0, ink="", fill="ground", layer=0)
HATCH = InkRole("hatch", 0.5, layer=0)
BEHIND = InkRole("behind", 0.9, layer=2)  # a string where a body covers it
BODY = InkRole("body", 1.1, fill="body", layer=3)
HOLE = InkRole("hole", 0.9, fill="paper", layer=3)  # just above its own body: what lies in it is drawn after it
THICK = InkRole("thick", 3.4, layer=3)  # a rod
GHOST = InkRole("ghost", 0.8, ink="faint", dash="4 2.5", layer=2)  # another state
THIN = InkRole("thin", 0.6, layer=5)
STRING = InkRole("string", 0.9, layer=5)
SOLID = InkRole("solid", 0.7, fill="ink", layer=6)
SUPPORT = InkRole("support", 0.9, fill="paper", layer=4)
AXIS = InkRole("axis", 0.6, ink="faint", dash="7 2 1.5 2", layer=1)
DIMENSION = InkRole("dimension", 0.5, ink="faint", layer=6)
SENSE = InkRole("sense", 1.1, ink="sense", layer=7)
FORCE = InkRole("force", 1.5, ink="force", layer=8)
UNSURE = InkRole("unsure", 1.3, ink="force", dash="3.5 2", layer=8)  # a force of which nothing tells which way it acts
PIN = InkRole("pin", 0.9, fill="paper", layer=6)
SPIN = InkRole("spin", 1.3, ink="spin", layer=8)  # of velocities and angular velocities that are given
ROLES = (
    SURFACE, GROUND, HATCH, BEHIND, BODY, HOLE, THICK, GHOST, THIN, STRING, SOLID, SUPPORT, AXIS, DIMENSION, PIN, SENSE, FORCE,
    UNSURE, SPIN,
)  # fmt: skip


class Line(Struct, frozen=True):
    """A line through points; `closed` ones may be filled; `heads` has '<' for an arrow at its start, '>' for one at its end."""

    points: tuple[Point, ...]
    role: InkRole
    closed: bool = False
    heads: str = ""
    tag: str = ""  # what it stands for, where a test or a reader asks


class Circle(Struct, frozen=True):
    centre: Point
    radius: float
    role: InkRole


class Label(Struct, frozen=True):
    """Words at a place, middle of the text; `box` is the room that they take."""

    text: str
    latex: str
    at: Point
    box: Box
    ink: str = "ink"
    size: float = 10.5
    tag: str = ""


Mark = Line | Circle


class Figure(Struct):
    """A picture: its title, what it shows in words, and its marks."""

    title: str = ""
    description: str = ""
    marks: list[Mark] = field(default_factory=list)
    labels: list[Label] = field(default_factory=list)

    def line(
        self, points: Sequence[Point], role: InkRole, *, closed: bool = False, heads: str = "", tag: str = ""
    ) -> None:
        """Adds a line."""
        self.marks.append(Line(tuple(points), role, closed, heads, tag))

    def circle(self, centre: Point, radius: float, role: InkRole) -> None:
        """Adds a circle."""
        self.marks.append(Circle(centre, radius, role))

    def in_layers(self) -> list[Mark]:
        """The marks from the lowest to the highest; those of one layer in the order in which they were made."""
        return sorted(self.marks, key=lambda mark: mark.role.layer)

    def box(self, margin: float = MARGIN) -> Box:
        """What the picture needs."""
        boxes = [*map(box_of, self.marks), *(label.box for label in self.labels)]
        left, low, right, high = around(boxes) if boxes else (0.0, 0.0, 10.0, 10.0)
        return left - margin, low - margin, right + margin, high + margin

    def shifted(self, by: Point) -> Figure:
        """The same picture elsewhere."""
        return Figure(
            self.title,
            self.description,
            [moved_mark(mark, by) for mark in self.marks],
            [moved_label(label, by) for label in self.labels],
        )


def shifted_by(point: Point, by: Point, times: float = 1.0) -> Point:
    """A point that has gone along an arrow, so many times."""
    return point[0] + times * by[0], point[1] + times * by[1]


def moved_mark(mark: Mark, by: Point) -> Mark:
    if isinstance(mark, Circle):
        return Circle(shifted_by(mark.centre, by), mark.radius, mark.role)
    return Line(tuple(shifted_by(point, by) for point in mark.points), mark.role, mark.closed, mark.heads, mark.tag)


def moved_label(label: Label, by: Point) -> Label:
    left, low, right, high = label.box
    box = (left + by[0], low + by[1], right + by[0], high + by[1])
    return Label(label.text, label.latex, shifted_by(label.at, by), box, label.ink, label.size, label.tag)


def box_of(mark: Mark) -> Box:
    """The room of a mark."""
    if isinstance(mark, Circle):
        (x, y), radius = mark.centre, mark.radius
        return x - radius, y - radius, x + radius, y + radius
    wide = NARROW if mark.heads else 0.0
    xs, ys = [point[0] for point in mark.points], [point[1] for point in mark.points]
    return min(xs) - wide, min(ys) - wide, max(xs) + wide, max(ys) + wide


def around(boxes: Sequence[Box]) -> Box:
    """The box round several."""
    lefts, lows, rights, highs = zip(*boxes, strict=True)
    return min(lefts), min(lows), max(rights), max(highs)


def boxes_apart(one: Box, other: Box, gap: float = 0.0) -> bool:
    """Whether two boxes share nothing."""
    return one[2] + gap <= other[0] or other[2] + gap <= one[0] or one[3] + gap <= other[1] or other[3] + gap <= one[1]


def ray(angle: float, size: float = 1.0) -> Point:
    """The arrow of a direction, counterclockwise from the right in radians, and a size."""
    return size * math.cos(angle), size * math.sin(angle)


def arc_points(centre: Point, radius: float, start: float, end: float) -> list[Point]:
    """Points of an arc between two angles in radians, counterclockwise where the second is larger."""
    count = max(2, math.ceil(abs(math.degrees(end - start)) / SMOOTH))
    return [shifted_by(centre, ray(start + (end - start) * k / count, radius)) for k in range(count + 1)]


def unit_of(vector: Point) -> Point:
    """The direction of an arrow; to the right where it has none."""
    size = math.hypot(*vector)
    return (vector[0] / size, vector[1] / size) if size else (1.0, 0.0)


def quarter(vector: Point) -> Point:
    """An arrow turned by a quarter, counterclockwise."""
    return -vector[1], vector[0]


def arrow_heads(line: Line) -> Iterator[tuple[Point, Point, Point]]:
    """The triangles at the ends of a line that has heads."""
    ends = [(line.points[-1], line.points[-2])] * (">" in line.heads) + [(line.points[0], line.points[1])] * (
        "<" in line.heads
    )
    for tip, before in ends:
        along = unit_of((tip[0] - before[0], tip[1] - before[1]))
        size = HEAD if line.role.width >= 1.0 else 0.75 * HEAD
        back, side = shifted_by(tip, along, -size), quarter(along)
        wide = NARROW * size / HEAD
        yield tip, shifted_by(back, side, wide), shifted_by(back, side, -wide)
