"""Marks: names, lengths, angles and senses of bodies, with their letters."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rotsolve.algebra.formula import Formula, Negative, Symbol, negate
from rotsolve.confirm.bodies import frame
from rotsolve.core.vectors.heading import Heading, heading
from rotsolve.draw.paper.figure import AXIS, SENSE, SPIN, Point, moved, polar, quarter, unit_of
from rotsolve.draw.paper.lettering import Words, letter
from rotsolve.draw.plane.bodies import Figured
from rotsolve.draw.plane.ground import told
from rotsolve.draw.plane.sheet import ARROW, Sheet
from rotsolve.draw.plane.stage import Stage
from rotsolve.draw.plane.wording import named_in
from rotsolve.elements.connections.touch import Touch
from rotsolve.elements.shapes import shape_of
from rotsolve.elements.surfaces import Curved
from rotsolve.language.bodies import Body, Part, PointRef
from rotsolve.language.problem import Condition, Path

RADII = (35.0, 145.0, 80.0, 205.0, 325.0)  # directions in which radii are drawn, in degrees
ARC, NEXT = 26.0, 9.0  # radius of the first arc of an angle, and how much larger the next one is
SENSE_ARC = 0.85  # radians of a round arrow
NARROW = 9.0  # points below which a radius has no room for its letter


def draw_names(stage: Stage, sheet: Sheet) -> None:
    """The name of each body: within a block, else beside the body."""
    for body in stage.bodies.values():
        words = named_in(body.body, stage.model.problem)
        at = sheet.at(body.place)
        points = [sheet.at(point) for point in body.bound()]
        if body.block:
            sheet.letters.name(words, at, outside(body, stage), sheet.scale * body.reach(outside(body, stage)) + 3.0, inside=True)
        elif points:
            if broad(body, sheet):
                sheet.letters.name(words, sheet.at(middle_of(body)), (0.5, -0.5), 6.0, inside=True)
                continue
            middle = (sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points))
            way = beside(body, stage)
            if roomy(body, sheet):
                sheet.letters.name(words, moved(sheet.at(body.place), (-0.3, -0.5), inner(body, sheet)), way, 4.0, inside=True)
                continue
            if shape_of(body.body).slender and any(told(stage, ref.argument) for ref in mentioned(body.name, stage)):
                end = sheet.at(body.spot(stage.model.spot(PointRef(body.name, "end"))))
                middle = moved(middle, (end[0] - middle[0], end[1] - middle[1]), 0.75)
            if not shape_of(body.body).slender:
                middle = max(points, key=lambda point: point[0] * way[0] + point[1] * way[1])
            sheet.letters.name(words, middle, way, 6.0)


def middle_of(body: Figured) -> Point:
    """The middle of what bounds a body."""
    points = body.bound()
    return sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points)


def broad(body: Figured, sheet: Sheet) -> bool:
    """Whether a body of straight edges has room for its name within."""
    first = body.outlines[0]
    if first.radius is not None or first.slender or len(first.points) < 3:
        return False
    xs, ys = [x for x, _ in first.points], [y for _, y in first.points]
    return min(max(xs) - min(xs), max(ys) - min(ys)) * sheet.scale > 30.0


def inner(body: Figured, sheet: Sheet) -> float:
    """The radius of a round body on paper."""
    return (body.outlines[0].radius or 0.0) * sheet.scale


def roomy(body: Figured, sheet: Sheet) -> bool:
    """Whether a round body has room for its name within."""
    return inner(body, sheet) > 26.0 and len([1 for outline in body.outlines if outline.radius != 0.0]) == 1


def outside(body: Figured, stage: Stage) -> Point:
    """The side on which a body has most room: away from the middle of all."""
    xs = [other.place[0] for other in stage.bodies.values()]
    return (1.0, 0.0) if body.place[0] >= sum(xs) / len(xs) - 1e-9 else (-1.0, 0.0)


def beside(body: Figured, stage: Stage) -> Point:
    """Across a rod, above it; of other bodies down to the right."""
    if shape_of(body.body).slender:
        return open_side(body, stage)
    return (0.75, -0.65) if outside(body, stage)[0] > 0 else (-0.75, -0.65)


def open_side(body: Figured, stage: Stage) -> Point:
    """The side of a rod for its name: above it, or left of an upright one, save where another body is; its length goes to the other side."""
    x, y = quarter(polar(body.turn))
    side = (x, y) if y > 0.02 or (abs(y) <= 0.02 and x < 0) else (-x, -y)
    others = [other.place for other in stage.bodies.values() if other is not body and other.dot]
    middle = middle_of(body)
    across = [(ox - middle[0]) * side[0] + (oy - middle[1]) * side[1] for ox, oy in others]
    crowded = abs(y) <= 0.02 and any(gap < -0.02 * stage.sizes.whole for gap in across)
    ahead = velocity_way(body, stage)
    crowded = crowded or ahead[0] * side[0] + ahead[1] * side[1] < -0.5
    return (-side[0], -side[1]) if crowded else side


def velocity_way(body: Figured, stage: Stage) -> Point:
    """The direction of a velocity that the state tells of a body; nothing where it tells none."""
    speeds = [line for line in told_of(body.name, stage) if line.path is not None and line.path.quantity in ("velocity", "speed")]
    way = stage.model.line(body.name)
    if not speeds or way is None or speeds[0].value is None:
        return 0.0, 0.0
    return (-way[0], -way[1]) if backwards(speeds[0].value, stage) else way


# lengths


def draw_lengths(stage: Stage, sheet: Sheet) -> None:
    """Radii, lengths and sides of bodies, and places on rods, as far as they have letters or are told."""
    for body in stage.bodies.values():
        draw_radii(body, stage, sheet)
        draw_sides(body, stage, sheet)
        draw_places(body, stage, sheet)


def rims_of(body: Body, at: Point = (0.0, 0.0)) -> Iterator[tuple[Formula, Point]]:
    """All radii of a body, with the middle of each in its own axes."""
    shape = shape_of(body)
    radii = [size for _, size in (*getattr(shape, "radii", ()), *body.radii)]
    single = getattr(shape, "radius", None) if not shape.pointlike and not shape.slender else None
    for radius in (*radii, *(size for size in (single or body.radius,) if size is not None)):
        yield radius, at


def draw_radii(body: Figured, stage: Stage, sheet: Sheet) -> None:
    told_radii = dict.fromkeys(rims_of(body.body))
    for part in (*body.body.parts, *body.body.holes):
        spot, _ = frame(part, stage.value)
        told_radii |= dict.fromkeys(rims_of(part.body, spot))
    for number, (radius, spot) in enumerate(told_radii):
        words, size = told(stage, radius), stage.value(radius) * sheet.scale
        if words is not None and size > NARROW and body.seen:
            sheet.radius(sheet.at(body.spot(spot)), size, math.radians(RADII[number % len(RADII)]), words)


def draw_sides(body: Figured, stage: Stage, sheet: Sheet) -> None:
    """The length of a rod; width and height of a box."""
    shape = shape_of(body.body)
    parts = [(shape, (0.0, 0.0), 0.0), *((shape_of(part.body), *frame(part, stage.value)) for part in rods_of(body.body))]
    seen: list[Words] = []
    for own, spot, turn in parts:
        reach = own.reach() if own.slender else None
        words = told(stage, reach)
        if reach is not None and words is not None:
            half = stage.value(reach) / 2
            ends = [sheet.at(body.spot(moved(spot, polar(turn), side * half))) for side in (-1.0, 1.0)]
            if words in seen:
                continue
            seen.append(words)
            side = open_side(body, stage) if own is shape else (0.0, 1.0)
            along = (ends[1][0] - ends[0][0], ends[1][1] - ends[0][1])
            left = quarter(along)[0] * side[0] + quarter(along)[1] * side[1] > 0
            sheet.dimension(*ends, words, -SPACE if left else SPACE)
    sides = getattr(shape, "sides", ())
    corners = shape.outline()
    if len(corners) == 4 and len(sides) >= 2:
        places = [sheet.at(body.spot((stage.value(x), stage.value(y)))) for x, y in corners]
        ahead = velocity_way(body, stage)
        pairs = ((2, 3) if ahead[1] < -0.5 else (0, 1), (3, 0) if ahead[0] > 0.5 else (1, 2))
        for side, (first, second) in zip(sides, pairs, strict=False):
            words = told(stage, side)
            if words is not None:
                sheet.dimension(places[first], places[second], words, -SPACE * 0.8)


SPACE = 17.0


def rods_of(body: Body) -> Iterator[Part]:
    return (part for part in body.parts if shape_of(part.body).slender)


def draw_places(body: Figured, stage: Stage, sheet: Sheet) -> None:
    """How far from the start of a rod something is at `rod.at(x)`; points that the scene names by a letter."""
    seen: set[Formula] = set()
    for ref in mentioned(body.name, stage):
        words = told(stage, ref.argument)
        if ref.argument is None or words is None or ref.argument in seen:
            continue
        seen.add(ref.argument)
        start = sheet.at(body.spot(stage.model.spot(PointRef(body.name, "start"))))
        sheet.dimension(start, sheet.at(body.spot(stage.model.spot(ref))), words, SPACE * (0.9 + (len(seen) - 1)))
    for name, at in body.body.points:
        if len(name) <= 2:
            place = sheet.at(body.spot((stage.value(at[0]), stage.value(at[1]))))
            sheet.hub(place)
            sheet.letters.name(letter(name), place, (0.6, 0.8), 3.0)


def mentioned(name: str, stage: Stage) -> Iterator[PointRef]:
    """The points of a body that connections and actions name."""
    for item in (*stage.model.acting.connections, *stage.model.acting.actions):
        yield from (ref for ref in item.touches() if ref.owner == name)


# angles


def straight_from(angle: Heading) -> tuple[int, Formula, int] | None:
    """The direction, in quarter turns, from which a letter alone measures an angle, the letter, and its sign."""
    if len(angle.terms) != 1 or angle.degrees % 90:
        return None
    value, factor = angle.terms[0]
    return (int(angle.degrees // 90), value, int(factor)) if factor in (1, -1) else None


def draw_angles(stage: Stage, sheet: Sheet) -> None:
    """The angles that the state tells of bodies, from the level or the upright from which their letters count."""
    count: dict[str, int] = {}
    for line in stage.model.acting.state.conditions:
        path = line.path
        if path is None or path.quantity != "angle" or line.value is None:
            continue
        if path.owner in stage.bodies and path.point is None:
            body = stage.bodies[path.owner]
            vertex = sheet.at(body.spot(vertex_of(path.owner, stage)))
            rod = 2.4 * ARC if not shape_of(body.body).slender else 0.0
            draw_angle(line.value, vertex, ARC + NEXT * count.get(path.owner, 0), stage, sheet, long=rod)
        else:
            draw_contact_angle(path, line.value, stage, sheet)


def vertex_of(name: str, stage: Stage) -> Point:
    """From where the angle of a body is seen: its hinge, the start of a rod, else its centre."""
    pivot = stage.model.pivot(name)
    if pivot is not None:
        return stage.model.drawn(pivot)
    body = stage.model.body(name)
    return stage.model.spot(PointRef(name, "start")) if shape_of(body).slender else (0.0, 0.0)


def draw_angle(value: Formula, vertex: Point, radius: float, stage: Stage, sheet: Sheet, long: float = 0.0) -> None:
    """An arc from the level or the upright to a direction; of a number from the level."""
    own = stage.value(value)
    found = straight_from(heading(value))
    if found is None:
        return
    quarters, part, _ = found
    words = told(stage, part)
    base = quarters * math.pi / 2
    if words is None and isinstance(part, Symbol):
        return
    if abs(own - base) < 0.02 or words is None:
        return
    sheet.figure.line([vertex, moved(vertex, polar(base), radius + 14.0)], AXIS)
    if long:
        sheet.figure.line([vertex, moved(vertex, polar(own), long)], AXIS)
    sheet.angle(vertex, radius, base, own, words)


def draw_contact_angle(path: Path, value: Formula, stage: Stage, sheet: Sheet) -> None:
    """Where on a curved surface a body is: the angle at the centre of that."""
    for item in stage.model.acting.connections:
        if item.name != path.owner or not isinstance(item, Touch):
            continue
        for surface, where in stage.surfaces.values():
            if isinstance(surface, Curved) and isinstance(where, tuple) and surface.radius() is not None:
                x, y = (part.at(stage.found) for part in where)
                centre, body = sheet.at((x, y)), sheet.at(stage.bodies[item.lying()].place)
                sheet.figure.line([centre, body], AXIS)
                draw_angle(value, centre, ARC + 6.0, stage, sheet)


# senses


def draw_senses(stage: Stage, sheet: Sheet) -> None:
    """The positive way of each body that declares one, and velocities that the state tells."""
    for body in stage.bodies.values():
        if not body.seen:
            continue
        speeds = {line.path.quantity: line for line in told_of(body.name, stage) if line.path is not None}
        draw_travel(body, speeds.get("velocity") or speeds.get("speed"), stage, sheet)
        draw_turn(body, speeds.get("angular_velocity"), stage, sheet)


def told_of(name: str, stage: Stage) -> Iterator[Condition]:
    """The lines of the state that tell a rate of a body which is not 0."""
    for line in stage.model.acting.state.conditions:
        if line.path is not None and line.path.owner == name and line.path.point in (None, "cm", "center") and line.value is not None:
            if line.value.symbols() or stage.value(line.value):
                yield line


def draw_travel(body: Figured, speed: Condition | None, stage: Stage, sheet: Sheet) -> None:
    """An arrow beside a body along its positive way; with a letter, and in another colour, where its velocity is told."""
    way = stage.model.line(body.name)
    if way is None and speed is not None and speed.path is not None and speed.path.component:
        way = {"x": (1.0, 0.0), "y": (0.0, 1.0)}.get(speed.path.component)
    on_curve = way is None and body.body.moves is not None and body.name not in stage.model.held
    if on_curve:
        way = curve_way(body, stage)
    if way is None or (body.body.moves is None and speed is None):
        return
    back = speed is not None and speed.value is not None and backwards(speed.value, stage)
    way = (-way[0], -way[1]) if back else way
    at = sheet.at(body.place)
    role = SPIN if speed is not None else SENSE
    words = speed_words(speed, stage)
    if speed is not None:
        reach = sheet.scale * body.reach(way) + 5.0
        sheet.arrow(moved(at, way, reach), way, ARROW, role, words)
        return
    side = side_of_way(body, way, stage)
    off = sheet.scale * body.reach(side) + 8.0
    start = moved(moved(at, side, off), way, -ARROW / 2)
    sheet.arrow(start, way, ARROW, role, words)


def backwards(value: Formula, stage: Stage) -> bool:
    """Whether a velocity is told against the positive sense."""
    return stage.value(value) < 0.0


def speed_words(speed: Condition | None, stage: Stage) -> Words | None:
    """The size of a velocity, which its arrow points along."""
    if speed is None or speed.value is None:
        return None
    value = speed.value
    return told(stage, negate(value) if backwards(value, stage) and isinstance(value, Negative) else value)


def curve_way(body: Figured, stage: Stage) -> Point | None:
    """The positive way along a curved surface where a body lies."""
    for item in stage.model.acting.connections:
        if isinstance(item, Touch) and item.lying() == body.name:
            for surface, where in stage.surfaces.values():
                if isinstance(surface, Curved) and isinstance(where, tuple) and surface.radius() is not None:
                    x, y = (part.at(stage.found) for part in where)
                    out = unit_of((body.place[0] - x, body.place[1] - y))
                    tangent = quarter(out)
                    right = 1.0 if body.body.moves != "left" else -1.0
                    return tangent if tangent[0] * right > 0 else (-tangent[0], -tangent[1])
    return None


def side_of_way(body: Figured, way: Point, stage: Stage) -> Point:
    """The side of a body on which the arrow of its way goes: outwards beside what hangs, above what lies."""
    side = quarter(way)
    if abs(way[1]) > 0.9:
        out = outside(body, stage)
        return side if side[0] * out[0] > 0 else (-side[0], -side[1])
    return side if side[1] > 0 else (-side[0], -side[1])


def draw_turn(body: Figured, speed: Condition | None, stage: Stage, sheet: Sheet) -> None:
    """A round arrow along the positive turn; with a letter where the angular velocity is told."""
    if body.body.turns is None and speed is None:
        return
    sense = float(stage.model.sense(body.name))
    role = SPIN if speed is not None else SENSE
    words = speed_words(speed, stage)
    sense *= -1.0 if speed is not None and speed.value is not None and backwards(speed.value, stage) else 1.0
    pivot = stage.model.pivot(body.name)
    spot = stage.model.drawn(pivot) if pivot is not None else (0.0, 0.0)
    centre = sheet.at(body.spot(spot))
    if shape_of(body.body).slender:
        far = max((sheet.at(point) for point in body.bound()), key=lambda point: math.dist(point, centre))
        radius, start = 0.72 * math.dist(far, centre), math.atan2(far[1] - centre[1], far[0] - centre[0])
        turn = min(SENSE_ARC, 34.0 / max(radius, 1.0))
        sheet.round_arrow(centre, radius, start + sense * 0.25 * turn, sense * turn, role, words)
        return
    radius = max(math.dist(sheet.at(point), centre) for point in body.bound()) + 6.0
    middle = math.radians(52.0 if outside(body, stage)[0] > 0 else 128.0)
    x, y = sheet.at(middle_of(body))
    if math.dist((x, y), centre) > 0.3 * radius:
        middle = math.atan2(y - centre[1], x - centre[0]) - 0.2
    turn = max(0.5, min(1.2, 30.0 / radius))
    sheet.round_arrow(centre, radius, middle - sense * turn / 2, sense * turn, role, words)


