"""Sides: on which side of a body there is room, and which way its velocity points."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import Formula
from rotsolve.draw.paper.figure import Point, quarter, ray
from rotsolve.draw.plane.places.bodies import Figured
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.language.problem import Condition


def outer_side(body: Figured, stage: PlaneStage) -> Point:
    """The side on which a body has most room: away from the middle of all."""
    xs = [other.place[0] for other in stage.bodies.values()]
    return (1.0, 0.0) if body.place[0] >= sum(xs) / len(xs) - 1e-9 else (-1.0, 0.0)


def body_middle(body: Figured) -> Point:
    """The middle of what bounds a body."""
    points = body.bound()
    return sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points)


def open_side(body: Figured, stage: PlaneStage) -> Point:
    """The side of a rod for its name: above it, or left of an upright one, save where another body is; its length goes opposite."""
    x, y = quarter(ray(body.turn))
    side = (x, y) if y > 0.02 or (abs(y) <= 0.02 and x < 0) else (-x, -y)
    others = [other.place for other in stage.bodies.values() if other is not body and other.dot]
    middle = body_middle(body)
    across = [(ox - middle[0]) * side[0] + (oy - middle[1]) * side[1] for ox, oy in others]
    crowded = abs(y) <= 0.02 and any(gap < -0.02 * stage.sizes.whole for gap in across)
    ahead = velocity_way(body, stage)
    crowded = crowded or ahead[0] * side[0] + ahead[1] * side[1] < -0.5
    return (-side[0], -side[1]) if crowded else side


def told_of(name: str, stage: PlaneStage) -> Iterator[Condition]:
    """The lines of the state that tell a rate of a body which is not 0."""
    for line in stage.model.acting.state.conditions:
        if (
            line.path is not None
            and line.path.owner == name
            and line.path.point in (None, "cm", "center")
            and line.value is not None
        ) and (line.value.symbols() or stage.value(line.value)):
            yield line


def runs_back(value: Formula, stage: PlaneStage) -> bool:
    """Whether a velocity is told against the positive sense."""
    return stage.value(value) < 0.0


def velocity_way(body: Figured, stage: PlaneStage) -> Point:
    """The direction of a velocity that the state tells of a body; nothing where it tells none."""
    speeds = [
        line
        for line in told_of(body.name, stage)
        if line.path is not None and line.path.quantity in ("velocity", "speed")
    ]
    if not speeds or speeds[0].value is None or speeds[0].path is None:
        return 0.0, 0.0
    way = stage.model.line(body.name) or {"x": (1.0, 0.0), "y": (0.0, 1.0)}.get(speeds[0].path.component or "")
    if way is None:
        return 0.0, 0.0
    return (-way[0], -way[1]) if runs_back(speeds[0].value, stage) else way
