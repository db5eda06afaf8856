"""Slots: the pictures of a reel as data for a page: places for lines and labels, and what each shows at every moment.

A line is told by where it begins, in tenths of a point, and by its shape from there, which most lines keep: shapes are told once.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import Struct, field

from rotsolve.draw.paper.figure import Circle, Mark, Point, arrow_heads
from rotsolve.draw.paper.reel import Reel


class StepPath(Struct, frozen=True):
    """A line from its first point on, how it is drawn, and where it begins, in tenths of a point."""

    role: str
    path: str
    at: tuple[int, int]


class Slots(Struct):
    """All pictures: the kinds of lines, the shapes, and for each slot what it shows: a number at all moments, or one for each."""

    wide: float
    tall: float
    origin: Point
    roles: list[str] = field(default_factory=list)
    shapes: list[str] = field(default_factory=list)
    lines: list[dict[str, int | list[int]]] = field(default_factory=list)
    labels: list[dict[str, int | list[int]]] = field(default_factory=list)


NONE = StepPath("", "", (0, 0))  # of a slot that shows nothing


def slots_of(reel: Reel) -> Slots:
    """The pictures of a reel, on the paper that all need."""
    left, low, right, high = reel.box()
    found = Slots(right - left, high - low, (left, high))
    pictures = [[shape for mark in marks for shape in shapes_of(mark, found.origin)] for marks in reel.pictures]
    roles, shapes = dict[str, int](), dict[str, int]()
    for number in range(max(map(len, pictures), default=0)):
        row = [picture[number] if number < len(picture) else NONE for picture in pictures]
        found.lines.append(
            {
                "r": steady([roles.setdefault(shape.role, len(roles)) for shape in row]),
                "s": steady([shapes.setdefault(shape.path, len(shapes)) for shape in row]),
                "x": steady([shape.at[0] for shape in row]),
                "y": steady([shape.at[1] for shape in row]),
            }
        )
    for number in range(len(reel.labels)):
        shifts = [moment[number] for moment in reel.shifts]
        found.labels.append({"x": steady([tenths(x) for x, _ in shifts]), "y": steady([tenths(-y) for _, y in shifts])})
    found.roles, found.shapes = list(roles), list(shapes)
    return found


def steady(row: list[int]) -> int | list[int]:
    """A number where it is the same at all moments."""
    return row[0] if len(set(row)) == 1 else row


def tenths(value: float) -> int:
    return round(10.0 * value)


def shapes_of(mark: Mark, origin: Point) -> Iterator[StepPath]:
    """A line or a circle as it is drawn, with the heads of arrows."""
    if isinstance(mark, Circle):
        x, y = on_tenths(mark.centre, origin)
        size = tenths(mark.radius)
        r = short_tenths(size)
        yield StepPath(
            mark.role.name,
            f"a{r} {r} 0 1 0 {short_tenths(2 * size)} 0a{r} {r} 0 1 0 -{short_tenths(2 * size)} 0Z",
            (x - size, y),
        )
        return
    yield line_shape(mark.role.name, mark.points, origin, mark.closed)
    for triangle in arrow_heads(mark):
        yield line_shape(f"to-{mark.role.ink} head", triangle, origin, True)


def line_shape(role: str, points: Sequence[Point], origin: Point, closed: bool) -> StepPath:
    """A line by its steps; those too short to be seen are left out."""
    places = [on_tenths(point, origin) for point in points]
    path, before = "l", places[0]
    for place in places[1:]:
        path += signed_tenths(place[0] - before[0]) + signed_tenths(place[1] - before[1])
        before = place
    return StepPath(role, path + ("Z" if closed else ""), places[0])


def on_tenths(point: Point, origin: Point) -> tuple[int, int]:
    return tenths(point[0] - origin[0]), tenths(origin[1] - point[1])


def short_tenths(value: int) -> str:
    """Tenths as a decimal of a path."""
    whole, part = divmod(abs(value), 10)
    text = f"{whole or ''}.{part}" if part else f"{whole}"
    return f"-{text}" if value < 0 else text


def signed_tenths(value: int) -> str:
    """Tenths with what keeps them apart from the number before."""
    text = short_tenths(value)
    return text if text.startswith("-") else f" {text}"
