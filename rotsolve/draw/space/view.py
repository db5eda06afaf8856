"""View: how space is seen on paper: along a slanting direction, x towards the reader, y to the right, z up, nothing smaller far away."""

from __future__ import annotations

import math
from collections.abc import Sequence

from rotsolve.confirm.space.arrows import Arrow, inner_product, normed, scaled, square_to, sum_of
from rotsolve.draw.paper.figure import Point

AZIMUTH, HEIGHT = math.radians(32.0), math.radians(20.0)  # from where the reader looks
AROUND = 48  # points of a circle

TOWARDS: Arrow = (
    math.cos(HEIGHT) * math.cos(AZIMUTH),
    math.cos(HEIGHT) * math.sin(AZIMUTH),
    math.sin(HEIGHT),
)  # to the reader
RIGHT: Arrow = (-math.sin(AZIMUTH), math.cos(AZIMUTH), 0.0)
UP: Arrow = (-math.sin(HEIGHT) * math.cos(AZIMUTH), -math.sin(HEIGHT) * math.sin(AZIMUTH), math.cos(HEIGHT))


def seen(place: Arrow) -> Point:
    """Where a place is on paper, in metres."""
    return inner_product(place, RIGHT), inner_product(place, UP)


def depth(place: Arrow) -> float:
    """How near a place is."""
    return inner_product(place, TOWARDS)


def faces(normal: Arrow) -> bool:
    """Whether a side with this direction out of it is seen."""
    return inner_product(normal, TOWARDS) > 1e-9


def ring(centre: Arrow, axis: Arrow, radius: float, first: float = 0.0, last: float = 2 * math.pi) -> list[Arrow]:
    """Places of a circle about an axis, or of a part of it."""
    third = normed(axis)
    one = square_to(third)
    other = crossed_unit(third, one)
    count = max(6, round(AROUND * abs(last - first) / (2 * math.pi)))
    angles = (first + (last - first) * k / count for k in range(count + 1))
    return [sum_of(centre, scaled(radius * math.cos(a), one), scaled(radius * math.sin(a), other)) for a in angles]


def crossed_unit(a: Arrow, b: Arrow) -> Arrow:
    x, y, z = a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
    return normed((x, y, z))


def span_on_paper(places: Sequence[Point]) -> tuple[float, float]:
    """Width and height of points on paper."""
    if not places:
        return 0.0, 0.0
    xs, ys = [x for x, _ in places], [y for _, y in places]
    return max(xs) - min(xs), max(ys) - min(ys)
