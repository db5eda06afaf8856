"""Marks in space: names and lengths of bodies, forces, and what the scene tells of their turning: ω, precession, spin, and the tilt."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.confirm.space.arrows import STILL, Z, Arrow, arrow_length, crossed, inner_product, less, normed, scaled, sum_of
from rotsolve.draw.paper.figure import DIMENSION, FORCE, GHOST, SENSE, SOLID, SPIN, Point
from rotsolve.draw.paper.lettering import Words, formula, letter, prose
from rotsolve.draw.plane.sheet import Sheet
from rotsolve.draw.plane.wording import named_in, told_in
from rotsolve.draw.space.stage import FAULTS, Solid, SpaceStage
from rotsolve.draw.space.view import ring, seen
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import Joint

ARROW, FORCED = 34.0, 40.0  # points of an arrow
NARROW = 7.0  # points below which a length has no room for its letter
SENSE_TURN = 4.6  # radians of a round arrow


def draw_marks(stage: SpaceStage, sheet: Sheet) -> None:
    """All of them."""
    for solid in stage.solids.values():
        draw_lengths(solid, stage, sheet)
        draw_points(solid, stage, sheet)
        draw_turning(solid, stage, sheet)
        draw_weight(solid, stage, sheet)
        draw_name(solid, stage, sheet)
    draw_actions(stage, sheet)


def paper(place: Arrow, sheet: Sheet) -> Point:
    return sheet.at(seen(place))


def told(value: Formula | None, stage: SpaceStage) -> Words | None:
    return told_in(value, stage.problem)


def draw_name(solid: Solid, stage: SpaceStage, sheet: Sheet) -> None:
    """The letter of its mass, else its name, beside it."""
    points = [paper(point, sheet) for piece in solid.pieces for point in piece.points]
    if not points:
        return
    way = (0.8, -0.6)
    edge = max(points, key=lambda point: point[0] * way[0] + point[1] * way[1])
    sheet.letters.name(named_in(solid.body, stage.problem), edge, way, 3.0)


# lengths


def draw_lengths(solid: Solid, stage: SpaceStage, sheet: Sheet) -> None:
    """Radii, lengths and sides."""
    shape = shape_of(solid.body)
    origin = less(solid.place, own(solid, stage.rig.solid(solid.name).centre)) if known(solid, stage) else solid.place
    radius = getattr(shape, "radius", None) if not shape.pointlike else None
    words = told(radius, stage)
    if radius is not None and words is not None:
        mark_length(origin, sum_of(origin, own(solid, scaled(stage.value(radius), radial(shape.spherical)))), words, sheet)
    reach = shape.reach() if shape.slender else None
    words = told(reach, stage)
    if reach is not None and words is not None:
        half = stage.value(reach) / 2
        ends = [paper(sum_of(origin, own(solid, (side * half, 0.0, 0.0))), sheet) for side in (-1.0, 1.0)]
        if math.dist(*ends) > NARROW:
            sheet.dimension(*ends, words, 13.0)
    draw_sides(solid, origin, stage, sheet)


def known(solid: Solid, stage: SpaceStage) -> bool:
    try:
        return stage.rig.solid(solid.name) is not None
    except FAULTS:
        return False


def radial(spherical: bool) -> Arrow:
    return normed((0.3, 0.9, 0.3)) if spherical else normed((-0.35, 0.94, 0.0))


def own(solid: Solid, arrow: Arrow) -> Arrow:
    """An arrow of a body's own axes, in space."""
    rows = solid.rows
    return (inner_product(rows[0], arrow), inner_product(rows[1], arrow), inner_product(rows[2], arrow))


def mark_length(start: Arrow, end: Arrow, words: Words, sheet: Sheet) -> None:
    """An arrow from one place to another with a letter beside its middle."""
    first, second = paper(start, sheet), paper(end, sheet)
    if math.dist(first, second) < NARROW:
        return
    sheet.figure.line([first, second], DIMENSION, heads=">")
    middle = (0.45 * first[0] + 0.55 * second[0], 0.45 * first[1] + 0.55 * second[1])
    sheet.letters.name(words, middle, (-(second[1] - first[1]), second[0] - first[0]), 1.5)


def draw_sides(solid: Solid, origin: Arrow, stage: SpaceStage, sheet: Sheet) -> None:
    """The sides of a plate or box along edges that are seen."""
    shape = shape_of(solid.body)
    sides: tuple[Formula, ...] = getattr(shape, "sides", ())
    corners = shape.outline()
    if len(corners) != 4 or len(sides) < 2:
        return
    sizes = [stage.value(side) for side in sides]
    a, b, c = (*sizes, 0.0)[:3]
    low = [(a / 2, -b / 2, -c / 2), (a / 2, b / 2, -c / 2)]
    edges = [((-a / 2, b / 2, -c / 2), low[1]), (low[0], low[1]), (low[0], (a / 2, -b / 2, c / 2))]
    for side, (start, end) in zip(sides, edges, strict=False):
        words = told(side, stage)
        if words is None:
            continue
        first, second = (paper(sum_of(origin, own(solid, place)), sheet) for place in (start, end))
        middle = ((first[0] + second[0]) / 2, (first[1] + second[1]) / 2)
        centre = paper(origin, sheet)
        sheet.letters.name(words, middle, (middle[0] - centre[0], middle[1] - centre[1]), 2.0)


def draw_points(solid: Solid, stage: SpaceStage, sheet: Sheet) -> None:
    """Points of a body that joints or actions name: how far they are from its centre where one letter says that; their own letters."""
    used = {ref.point for item in (*stage.problem.connections, *stage.problem.actions) for ref in item.touches() if ref.owner == solid.name}
    for name, at in solid.body.points:
        if name not in used:
            continue
        arms = [part for part in at if part != ZERO]
        place = sum_of(centre_of(solid, stage), own(solid, three(at, stage)))
        words = told(abs_of(arms[0], stage), stage) if len(arms) == 1 else None
        if words is not None:
            mark_length(centre_of(solid, stage), place, words, sheet)
        if len(name) <= 2:
            sheet.figure.circle(paper(place, sheet), 1.6, SOLID)
            sheet.letters.name(letter(name), paper(place, sheet), (-0.7, -0.7), 2.5)


def centre_of(solid: Solid, stage: SpaceStage) -> Arrow:
    """The origin of a body's own axes."""
    return less(solid.place, own(solid, stage.rig.solid(solid.name).centre)) if known(solid, stage) else solid.place


def three(at: tuple[Formula, ...], stage: SpaceStage) -> Arrow:
    x, y, *rest = (stage.value(part) for part in at)
    return x, y, rest[0] if rest else 0.0


def abs_of(value: Formula, stage: SpaceStage) -> Formula:
    """A length without its sign."""
    from rotsolve.algebra.formula import Negative, negate

    return negate(value) if isinstance(value, Negative) else value


# turning


def draw_turning(solid: Solid, stage: SpaceStage, sheet: Sheet) -> None:
    """What turns a body: the rate about its joint, its precession and spin with its tilt, or the components of ω that are told."""
    for joint in stage.joints(solid.name):
        drive = dict(joint.drive)
        rate = drive.get("angular_velocity")
        rate = rate if rate is not None else line_of(joint.owner, "angular_velocity", stage) or line_of(solid.name, "angular_velocity", stage)
        way = stage.way(joint)
        if rate is not None and way is not None and stage_sign(rate, stage):
            turn_about(joint, normed(way), rate, solid, stage, sheet)
    if stage.lines.nods(solid.name):
        draw_nodding(solid, stage, sheet)
    told_omega = stage.lines.arrow_told(solid.name, "angular_velocity")
    if told_omega is not None and arrow_length(told_omega[0]) > 0.0:
        omega = told_omega[0] if told_omega[1] in ("", "space") else own(solid, told_omega[0])
        vector(solid.place, normed(omega), letter("omega"), solid, sheet)


def line_of(owner: str, word: str, stage: SpaceStage) -> Formula | None:
    line = stage.lines.line(owner, word)
    return line.value if line is not None else None


def stage_sign(value: Formula, stage: SpaceStage) -> float:
    """The sign of a value, 1 of one that nothing tells."""
    try:
        return stage.value(value)
    except FAULTS:
        return 1.0


def turn_about(joint: Joint, way: Arrow, rate: Formula, solid: Solid, stage: SpaceStage, sheet: Sheet) -> None:
    """A round arrow about an axis beyond the body, with the rate."""
    sign = 1.0 if stage_sign(rate, stage) > 0.0 else -1.0
    ahead = scaled(1.16 * max(solid.size, 0.3 * stage.whole), way)
    round_arrow(sum_of(stage.held_at(joint), ahead), scaled(sign, way), told(abs_of(rate, stage), stage), sheet)


def round_arrow(centre: Arrow, way: Arrow, words: Words | None, sheet: Sheet, radius: float = 11.0, role: object = SPIN) -> None:
    """A round arrow about a direction in space, counterclockwise as seen against it."""
    points = [paper(point, sheet) for point in ring(centre, way, radius / sheet.scale, -0.4, SENSE_TURN)]
    sheet.figure.line(points, SPIN if role is SPIN else SENSE, heads=">")
    if words is not None:
        middle = paper(centre, sheet)
        right = max(points, key=lambda point: point[0])
        sheet.letters.name(words, middle, (right[0] - middle[0] + 1.0, 0.3), max(right[0] - middle[0], 4.0) + 3.0, SPIN.ink)


def vector(start: Arrow, way: Arrow, words: Words, solid: Solid, sheet: Sheet) -> None:
    """An arrow in space out of a body."""
    first = paper(start, sheet)
    tip = paper(sum_of(start, scaled(solid.size + ARROW / sheet.scale, way)), sheet)
    sheet.figure.line([first, tip], SPIN, heads=">")
    sheet.letters.name(words, tip, (tip[0] - first[0], tip[1] - first[1] + 0.1), 3.0, SPIN.ink)


def draw_nodding(solid: Solid, stage: SpaceStage, sheet: Sheet) -> None:
    """The tilt from the upright, the cone on which the axis goes round, and the round arrows of precession and spin."""
    axis = stage.axis(solid.name)
    if axis is None:
        return
    axis = normed(axis)
    pivot = next((stage.held_at(joint) for joint in stage.joints(solid.name) if not joint.rolls), solid.place)
    long = max(math.dist(pivot, solid.place) + 1.15 * max(spread_along(solid, axis), 0.4 * solid.size), 0.9 * solid.size)
    if inner_product(less(solid.place, pivot), axis) < -1e-9:
        axis = scaled(-1.0, axis)
    tip = sum_of(pivot, scaled(long, axis))
    upright = sum_of(pivot, scaled(long * 1.12, Z))
    across = arrow_length(crossed(Z, axis))
    if across > 0.02:
        level = sum_of(pivot, scaled(long * axis[2], Z))
        if axis[2] > 0.15:
            sheet.figure.line([paper(point, sheet) for point in ring(level, Z, long * across)], GHOST)
        sheet.figure.line([paper(pivot, sheet), paper(upright, sheet)], DIMENSION)
        draw_tilt(pivot, axis, 0.42 * long, line_of(solid.name, "tilt", stage), stage, sheet)
    for word, letter_of, centre, way in (
        ("precession", "precession", upright, Z),
        ("spin", "spin", tip, stage.axis(solid.name) or axis),
        ("axial_rate", "axial_rate", tip, stage.axis(solid.name) or axis),
    ):
        value = line_of(solid.name, word, stage)
        asked = asked_as(solid.name, word, stage)
        if value is not None and (not (own_value := stage_sign(value, stage)) or own_value == 0.0):
            continue
        if value is not None or asked is not None:
            sign = 1.0 if value is None or stage_sign(value, stage) > 0.0 else -1.0
            words = told(abs_of(value, stage), stage) if value is not None else letter(asked or letter_of)
            round_arrow(centre, scaled(sign, normed(way)), words, sheet)


def spread_along(solid: Solid, axis: Arrow) -> float:
    """How far a body goes along a direction from its centre of mass."""
    return max((abs(inner_product(less(point, solid.place), axis)) for piece in solid.pieces for point in piece.points), default=0.0)


def asked_as(name: str, word: str, stage: SpaceStage) -> str | None:
    """The name under which the scene asks for a quantity of a body."""
    for find in stage.problem.finds:
        if len(find.terms) == 1 and find.formula == Symbol("#0"):
            path = find.terms[0].path
            if (path.owner, path.quantity) == (name, word):
                return find.name
    return None


def draw_tilt(pivot: Arrow, axis: Arrow, radius: float, value: Formula | None, stage: SpaceStage, sheet: Sheet) -> None:
    """The arc from the upright to the axis, with its letter."""
    words = told(value, stage) if value is not None else letter("theta")
    if words is None or value is not None and not value.symbols() and abs(stage.value(value) - math.pi / 2) < 1e-9:
        return
    angle = math.acos(max(-1.0, min(1.0, axis[2])))
    side = normed(less(axis, scaled(axis[2], Z)))
    places = [
        sum_of(pivot, scaled(radius * math.cos(angle * k / 16), Z), scaled(radius * math.sin(angle * k / 16), side))
        for k in range(17)
    ]
    points = [paper(place, sheet) for place in places]
    sheet.figure.line(points, DIMENSION)
    origin = paper(pivot, sheet)
    middle = points[8]
    sheet.letters.name(words, middle, (middle[0] - origin[0], middle[1] - origin[1]), 2.0)


# forces


def draw_weight(solid: Solid, stage: SpaceStage, sheet: Sheet) -> None:
    """The weight of a body, down from its centre of mass."""
    body, gravity = solid.body, stage.problem.gravity
    if gravity is None or body.mass is None or not solid.pieces:
        return
    try:
        if stage.rig.gravity == 0.0 or stage.value(body.mass) == 0.0:
            return
    except FAULTS:
        return
    words = told(body.mass, stage)
    if words is None:
        return
    weight = prose("weight") if words.prose else formula(body.mass * gravity)
    sheet.arrow(paper(solid.place, sheet), (0.0, -1.0), FORCED, FORCE, weight)


def draw_actions(stage: SpaceStage, sheet: Sheet) -> None:
    """Forces at their points, and couples about their directions."""
    for action in stage.problem.actions:
        refs = action.touches()
        if not refs or refs[0].owner not in stage.solids:
            continue
        at, size = stage.point(refs[0]), action.strength()
        for way, words in directions(size, getattr(action, "direction", None), stage):
            if action.twists():
                round_arrow(sum_of(at, scaled(0.6 * stage.whole, way)), way, words, sheet)
            else:
                first, flat = paper(at, sheet), seen(way)
                long = FORCED * max(math.hypot(*flat), 0.35)
                sheet.arrow(first, unit(flat), long, FORCE, words)


def unit(flat: Point) -> Point:
    long = math.hypot(*flat) or 1.0
    return flat[0] / long, flat[1] / long


def directions(size: object, way: object, stage: SpaceStage) -> Iterator[tuple[Arrow, Words | None]]:
    """The direction of a force or couple, with its size; of one that is told by components their sum."""
    try:
        if isinstance(size, tuple):
            found = stage.rig.arrow(size)
            if arrow_length(found) > 0.0:
                yield normed(found), None
        elif isinstance(way, tuple) and isinstance(size, Formula):
            yield normed(stage.rig.arrow(way)), told(size, stage)
    except FAULTS:
        return


__all__ = ["STILL", "draw_marks"]
