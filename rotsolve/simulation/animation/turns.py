"""Turns: how the bodies of a scene in space have gone and turned at each moment, by the numbers that its motion tells."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.confirm.space.arrows import ALONG, Arrow, Turned, product_of, rows_back
from rotsolve.draw.space.moving import SolidWay
from rotsolve.simulation.animation.course import Course

OWN = ("x_axis", "y_axis", "z_axis")


def solid_ways(course: Course) -> list[dict[str, SolidWay]]:
    """The way of each body at each moment."""
    names = [body.name for body in course.run.problem.bodies]
    course.read(tuple(told for name in names for told in told_of(name) if told in course.run.names))
    first = {name: standing(name, 0, course) for name in names}
    return [
        {name: SolidWay(gone(name, number, course), product_of(standing(name, number, course), rows_back(first[name]))) for name in names}
        for number in range(len(course.times))
    ]


def told_of(name: str) -> Iterator[str]:
    """What is told of a body that a picture asks for."""
    for word in (*OWN, "position"):
        yield from (f"{name}.{word}.{axis}" for axis in "xyz")


def arrow_told(name: str, number: int, course: Course) -> Arrow | None:
    """A vector that is told; None where it is not."""
    parts = [course.value(f"{name}.{axis}", number) for axis in "xyz"]
    x, y, z = (part or 0.0 for part in parts)
    return None if all(part is None for part in parts) else (x, y, z)


def gone(name: str, number: int, course: Course) -> Arrow:
    """How far the centre of mass of a body has gone."""
    return arrow_told(f"{name}.position", number, course) or (0.0, 0.0, 0.0)


def standing(name: str, number: int, course: Course) -> Turned:
    """How a body stands: its own axes as columns."""
    columns = [arrow_told(f"{name}.{word}", number, course) for word in OWN]
    x, y, z = (told or own for told, own in zip(columns, ALONG, strict=True))
    return rows_back((x, y, z))
