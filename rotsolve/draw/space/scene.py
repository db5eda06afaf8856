"""The scene in space: bodies seen obliquely, the farthest first, their joints and axes, what turns them, and the axes x, y, z."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

from rotsolve.confirm.signs import GROUND
from rotsolve.confirm.space.arrows import Arrow, Z, arrow_length, crossed, inner_product, less, normed, scaled, sum_of
from rotsolve.draw.paper.figure import AXIS, BODY, HATCH, HOLE, SOLID, STRING, SUPPORT, THIN, Figure, Point
from rotsolve.draw.paper.figure import GROUND as EARTH
from rotsolve.draw.paper.lettering import letter
from rotsolve.draw.plane.places.overlaps import hull
from rotsolve.draw.plane.signs.sheet import DOT, STOUT, ScenePaper, widened
from rotsolve.draw.space.marks import draw_marks
from rotsolve.draw.space.solids import Piece
from rotsolve.draw.space.stage import DrawnSolid, SpaceStage
from rotsolve.draw.space.view import TOWARDS, depth, faces, seen, span_on_paper
from rotsolve.language.bodies import Joint

WIDE, TALL, LARGEST = 330.0, 215.0, 150.0  # points of paper for all, and for one body
AXES = 0.75  # length of the axes, in the size of the largest body
BEYOND = 1.35  # of an axis of turning beyond its body
FLOOR = 1.5  # of the floor round a body, in its size


def draw_space(stage: SpaceStage, title: str = "", description: str = "") -> Figure:
    """The picture of a scene in space."""
    sheet = ScenePaper(space_scale(stage), title, description)
    draw_floors(stage, sheet)
    draw_axes(stage, sheet)
    draw_bodies(stage, sheet)
    draw_marks(stage, sheet)
    return sheet.finished()


def draw_bodies(stage: SpaceStage, sheet: ScenePaper) -> None:
    """All bodies, the farthest first, their axes and their joints."""
    for solid in sorted(stage.solids.values(), key=lambda solid: depth(solid.place)):
        draw_axis_behind(solid, stage, sheet)
        draw_solid(solid, sheet)
    for name in stage.solids:
        for joint in stage.joints(name):
            draw_joint(joint, stage, sheet)


def space_scale(stage: SpaceStage) -> float:
    """Points of paper for a metre."""
    points = [seen(point) for solid in stage.solids.values() for piece in solid.pieces for point in piece.points]
    points += [seen(stage.held_at(joint)) for joint in stage.rig.joints.values() if joint.body.owner in stage.solids]
    wide, tall = span_on_paper(points)
    single = max((2 * solid.size for solid in stage.solids.values()), default=0.0)
    limits = ((WIDE, wide), (TALL, tall), (LARGEST, single))
    return min((room / size for room, size in limits if size > 0.0), default=90.0 / stage.whole)


def on_paper(place: Arrow, sheet: ScenePaper) -> Point:
    return sheet.at(seen(place))


# bodies


def draw_solid(solid: DrawnSolid, sheet: ScenePaper) -> None:
    """The pieces of a body, those behind first."""
    for piece in sorted(solid.pieces, key=middle_depth):
        PIECES[piece.kind](piece, sheet)


def middle_depth(piece: Piece) -> tuple[float, float]:
    """Holes after the faces in which they are, sides of a hull after the hull."""
    order = {"edge": 0.0, "hull": 1.0, "face": 1.0, "rod": 1.0, "hole": 2.0, "mark": 2.5, "front": 3.0, "dot": 3.0}[
        piece.kind
    ]
    ahead = sum(depth(point) for point in piece.points) / len(piece.points)
    return (order, ahead) if piece.kind != "face" or piece.way is None else (1.5, ahead)


def draw_face(piece: Piece, sheet: ScenePaper) -> None:
    if piece.way is None or faces(piece.way):
        sheet.figure.line([on_paper(point, sheet) for point in piece.points], BODY, closed=True)


def draw_hull(piece: Piece, sheet: ScenePaper) -> None:
    sheet.figure.line(hull([on_paper(point, sheet) for point in piece.points]), BODY, closed=True)


def draw_hole(piece: Piece, sheet: ScenePaper) -> None:
    if piece.way is None or faces(piece.way):
        sheet.figure.line([on_paper(point, sheet) for point in piece.points], HOLE, closed=True)


def draw_rod(piece: Piece, sheet: ScenePaper) -> None:
    sheet.figure.line(widened([on_paper(point, sheet) for point in piece.points], STOUT), BODY, closed=True)


def draw_edge(piece: Piece, sheet: ScenePaper) -> None:
    sheet.figure.line([on_paper(point, sheet) for point in piece.points], STRING)


def draw_front(piece: Piece, sheet: ScenePaper) -> None:
    """The half of an equator that is seen."""
    middle = scaled(1.0 / len(piece.points), sum_of(*piece.points))
    near = [point for point in piece.points if depth(point) >= depth(middle) - 1e-12]
    ordered = sorted(near, key=lambda point: seen(point)[0])
    sheet.figure.line([on_paper(point, sheet) for point in ordered], THIN)


def draw_mark(piece: Piece, sheet: ScenePaper) -> None:
    if piece.way is None or faces(piece.way):
        sheet.figure.line([on_paper(point, sheet) for point in piece.points], THIN)


def draw_dot(piece: Piece, sheet: ScenePaper) -> None:
    sheet.figure.circle(on_paper(piece.points[0], sheet), DOT, SOLID)


PIECES: dict[str, Callable[[Piece, ScenePaper], None]] = {
    "face": draw_face,
    "hull": draw_hull,
    "hole": draw_hole,
    "rod": draw_rod,
    "edge": draw_edge,
    "mark": draw_mark,
    "front": draw_front,
    "dot": draw_dot,
}


# what holds them


def draw_axis_behind(solid: DrawnSolid, stage: SpaceStage, sheet: ScenePaper) -> None:
    """The axis about which a body turns, or its own axis where it tilts, beyond it on both sides."""
    for at, way in turning_axes_of(solid, stage):
        reach = BEYOND * max(solid.size, 0.3 * stage.whole)
        ends = [sum_of(at, scaled(side * reach, way)) for side in (-1.0, 1.0)]
        sheet.figure.line([on_paper(end, sheet) for end in ends], AXIS)


def turning_axes_of(solid: DrawnSolid, stage: SpaceStage) -> Iterator[tuple[Arrow, Arrow]]:
    for joint in stage.joints(solid.name):
        way = stage.way(joint)
        if way is not None:
            yield stage.held_at(joint), normed(way)
    if stage.lines.nods(solid.name):
        axis = stage.axis(solid.name)
        if axis is not None:
            yield solid.place, normed(axis)


def draw_joint(joint: Joint, stage: SpaceStage, sheet: ScenePaper) -> None:
    """A ball on its foot, bearings on an axis, a sleeve round one; the arm from what carries it."""
    at = stage.held_at(joint)
    place = on_paper(at, sheet)
    grounded = joint.carrier.owner not in stage.solids
    if joint.rolls or joint.flat:
        return
    if not grounded:
        arm(joint, stage, sheet)
    if joint.free:
        below = at[2] <= stage.solids[joint.body.owner].place[2] + 1e-9
        sheet.pin(place, (0.0, -1.0) if below else (0.0, 1.0), grounded)
        return
    way = stage.way(joint)
    if way is None:
        sheet.patch(place, (0.0, 1.0))
        return
    reach = BEYOND * max(stage.solids[joint.body.owner].size, 0.3 * stage.whole)
    told = [stage.value(part) for part in joint.bearings] or [-0.86 * reach, 0.86 * reach]
    for side in told if grounded else ():
        bearing(on_paper(sum_of(at, scaled(side, normed(way))), sheet), seen(normed(way)), sheet)
    if joint.sliding:
        bearing(place, seen(normed(way)), sheet, 9.0)


def bearing(at: Point, way: Point, sheet: ScenePaper, half: float = 4.5) -> None:
    """Two strokes on both sides of an axis."""
    long = math.hypot(*way)
    along = (way[0] / long, way[1] / long) if long > 1e-6 else (0.0, 1.0)
    side = (-along[1], along[0])
    for sign in (1.0, -1.0):
        middle = (at[0] + 4.0 * sign * side[0], at[1] + 4.0 * sign * side[1])
        ends = [(middle[0] + half * s * along[0], middle[1] + half * s * along[1]) for s in (-1.0, 1.0)]
        sheet.figure.line(ends, SUPPORT)
        for k in (-1.0, 0.0, 1.0):
            foot = (middle[0] + k * half * along[0], middle[1] + k * half * along[1])
            tip = (foot[0] + sign * 3.5 * side[0] + 2.0 * along[0], foot[1] + sign * 3.5 * side[1] + 2.0 * along[1])
            sheet.figure.line([foot, tip], HATCH)


def arm(joint: Joint, stage: SpaceStage, sheet: ScenePaper) -> None:
    """The light rod from the axis of what carries a body to where it holds that."""
    carrier = joint.carrier.owner
    bases = [stage.held_at(other) for other in stage.joints(carrier)] or [stage.solids[carrier].place]
    ends = [on_paper(bases[0], sheet), on_paper(stage.held_at(joint), sheet)]
    if math.dist(*ends) > 2.0:
        sheet.figure.line(ends, STRING)


# floors and axes


def draw_floors(stage: SpaceStage, sheet: ScenePaper) -> None:
    """A piece of the surface on which a body rolls or lies, or of the level under what stands on a point."""
    for name in stage.solids:
        for joint in stage.joints(name):
            if not (joint.rolls or joint.flat) or joint.carrier.owner in stage.solids:
                continue
            solid = stage.solids[name]
            out = outward(joint, stage)
            low = min((inner_product(point, out) for piece in solid.pieces for point in piece.points), default=0.0)
            foot = sum_of(solid.place, scaled(low - inner_product(solid.place, out), out))
            gone = [less(stage.solids[name].place, solid.place) for _ in stage.moments()]
            foot = sum_of(foot, *(scaled(0.5, end) for end in (gone[0], gone[-1])))
            reach = max(math.dist(arrow, scaled(0.5, gone[-1])) for arrow in gone)
            floor_patch(foot, out, reach + FLOOR * max(solid.size, 0.4 * stage.whole), sheet)


def outward(joint: Joint, stage: SpaceStage) -> Arrow:
    surface = next((item for item in stage.problem.surfaces if item.name == joint.carrier.owner), None)
    if surface is None or joint.carrier.owner in GROUND:
        return Z
    return (stage.value(surface.normal.cos()), 0.0, stage.value(surface.normal.sin()))


def floor_patch(foot: Arrow, out: Arrow, size: float, sheet: ScenePaper) -> None:
    side: Arrow = (0.0, 1.0, 0.0)
    along = normed(crossed(side, out))
    corners = [
        sum_of(foot, scaled(a * size, along), scaled(b * size, side)) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    sheet.figure.line([on_paper(corner, sheet) for corner in corners], EARTH, closed=True)
    sheet.figure.line([on_paper(corner, sheet) for corner in corners], HATCH, closed=True)


def draw_axes(stage: SpaceStage, sheet: ScenePaper) -> None:
    """x, y and z at the point that is held at rest, where there is one, else in a corner."""
    held = [
        stage.held_at(joint)
        for joint in stage.rig.joints.values()
        if joint.carrier.owner not in stage.solids
        and not joint.rolls
        and not joint.flat
        and joint.body.owner in stage.solids
    ]
    size = AXES * max((solid.size for solid in stage.solids.values()), default=1.0)
    if len(held) == 1:
        origin, long = held[0], 2.0 * size + 18.0 / sheet.scale
    else:
        points = [
            seen(point)
            for _ in stage.moments()
            for solid in stage.solids.values()
            for piece in solid.pieces
            for point in piece.points
        ]
        long = 26.0 / sheet.scale
        left = min((x for x, _ in points), default=0.0) - 2.0 * long
        low = min((y for _, y in points), default=0.0) + 0.6 * long
        from rotsolve.draw.space.view import RIGHT, UP

        origin = sum_of(scaled(left, RIGHT), scaled(low, UP), scaled(-1e3 * size, TOWARDS))
    for name, way in zip("xyz", ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), Z), strict=True):
        start, tip = on_paper(origin, sheet), on_paper(sum_of(origin, scaled(long, way)), sheet)
        sheet.figure.line([start, tip], THIN_AXIS, heads=">")
        direction = seen(way)
        sheet.letters.name(letter(name), tip, direction, 2.0, "faint")


from rotsolve.draw.paper.figure import DIMENSION as THIN_AXIS  # noqa: E402

__all__ = ["arrow_length", "draw_space"]
