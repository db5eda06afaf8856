"""Names: what each body is called, within it where there is room, else beside it."""

from __future__ import annotations

from collections.abc import Sequence

from rotsolve.draw.paper.figure import Point, shifted_by
from rotsolve.draw.paper.lettering import SIZE
from rotsolve.draw.plane.places.bodies import Figured
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.signs.ground import told_words
from rotsolve.draw.plane.signs.lengths import mentioned
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.draw.plane.signs.sides import body_middle, open_side, outer_side
from rotsolve.draw.plane.signs.wording import named_in
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import PointRef

LONG = 3.0  # width of a low block beside its height
INWARDS = (-0.51, -0.86)  # from the middle of a wheel to its name within


def draw_names(stage: PlaneStage, sheet: ScenePaper) -> None:
    """The name of each body: within a block, else beside the body."""
    for body in stage.bodies.values():
        name_body(body, stage, sheet)


def name_body(body: Figured, stage: PlaneStage, sheet: ScenePaper) -> None:
    """The name of one body."""
    words = named_in(body.body, stage.model.problem)
    at, way = sheet.at(body.place), outer_side(body, stage)
    points = [sheet.at(point) for point in body.bound()]
    if body.block and low_block(body, sheet):
        low = min(y for _, y in points)
        sheet.letters.name(words, (at[0], low), (0.0, -1.0), 3.0, tag=body.name)
    elif body.block:
        sheet.letters.name(words, at, way, sheet.scale * body.reach(way) + 3.0, inside=True, tag=body.name)
    elif points and broad(body, sheet):
        sheet.letters.name(words, sheet.at(body_middle(body)), (0.5, -0.5), 6.0, inside=True, tag=body.name)
    elif points and roomy(body, sheet):
        off = (inner_radius(body, sheet) + core_radius(body, sheet)) / 2
        at = shifted_by(at, INWARDS, max(off, 0.58 * inner_radius(body, sheet)))
        sheet.letters.name(words, at, name_side(body, stage), 4.0, inside=True, tag=body.name)
    elif points:
        way = name_side(body, stage)
        sheet.letters.name(words, place_beside(body, points, way, stage, sheet), way, 6.0, tag=body.name)


def place_beside(body: Figured, points: Sequence[Point], way: Point, stage: PlaneStage, sheet: ScenePaper) -> Point:
    """The place of a body next to which its name goes: the middle of a rod, off which it goes where a place on it is told."""
    if not shape_of(body.body).slender:
        return max(points, key=lambda point: point[0] * way[0] + point[1] * way[1])
    middle = (sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points))
    if not any(told_words(stage, ref.argument) for ref in mentioned(body.name, stage)):
        return middle
    end = sheet.at(body.spot(stage.model.spot(PointRef(body.name, "end"))))
    return shifted_by(middle, (end[0] - middle[0], end[1] - middle[1]), 0.75)


def low_block(body: Figured, sheet: ScenePaper) -> bool:
    """Whether a block has no room for its name within, since it is too low."""
    xs, ys = [x for x, _ in body.outlines[0].points], [y for _, y in body.outlines[0].points]
    high, wide = max(ys) - min(ys), max(xs) - min(xs)
    return high * sheet.scale < SIZE + 2.0 and wide > LONG * high


def name_side(body: Figured, stage: PlaneStage) -> Point:
    """Across a rod, above it; of other bodies down to the right."""
    if shape_of(body.body).slender:
        return open_side(body, stage)
    return (0.75, -0.65) if outer_side(body, stage)[0] > 0 else (-0.75, -0.65)


def broad(body: Figured, sheet: ScenePaper) -> bool:
    """Whether a body of straight edges has room for its name within."""
    first = body.outlines[0]
    if first.radius is not None or first.slender or len(first.points) < 3:
        return False
    xs, ys = [x for x, _ in first.points], [y for _, y in first.points]
    return min(max(xs) - min(xs), max(ys) - min(ys)) * sheet.scale > 30.0


def inner_radius(body: Figured, sheet: ScenePaper) -> float:
    """The radius of a round body on paper."""
    return (body.outlines[0].radius or 0.0) * sheet.scale


def roomy(body: Figured, sheet: ScenePaper) -> bool:
    """Whether a round body has room for its name within."""
    outer = inner_radius(body, sheet)
    return outer > 26.0 and outer - core_radius(body, sheet) > 17.0 and not any(one.cut for one in body.outlines)


def core_radius(body: Figured, sheet: ScenePaper) -> float:
    """The radius of the next circle within the outer one."""
    inside = [one.radius for one in body.outlines[1:] if one.radius]
    return max(inside, default=0.0) * sheet.scale
