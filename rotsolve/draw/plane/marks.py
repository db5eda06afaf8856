"""Marks: names, lengths, angles and senses of bodies, with their letters."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.confirm.bodies import frame
from rotsolve.core.vectors.heading import Heading, heading
from rotsolve.core.writing import spoken
from rotsolve.draw.paper.figure import AXIS, SENSE, SPIN, Point, moved, polar, quarter, unit_of
from rotsolve.draw.paper.lettering import Words, formula, letter, prose
from rotsolve.draw.plane.bodies import Figured
from rotsolve.draw.plane.ground import told
from rotsolve.draw.plane.sheet import ARROW, Sheet
from rotsolve.draw.plane.stage import Stage
from rotsolve.elements.connections.touch import Touch
from rotsolve.elements.shapes import shape_of
from rotsolve.elements.surfaces import Curved
from rotsolve.language.bodies import Body, Part, PointRef
from rotsolve.language.problem import Condition, Path

RADII = (35.0, 145.0, 80.0, 205.0, 325.0)  # directions in which radii are drawn, in degrees
ARC, NEXT = 26.0, 9.0  # radius of the first arc of an angle, and how much larger the next one is
SENSE_ARC = 0.85  # radians of a round arrow
NARROW = 9.0  # points below which a radius has no room for its letter


def named(body: Body, stage: Stage) -> Words:
    """What a body is called: by the letter of its mass or moment of inertia where the scene has one, else by its name."""
    given = {item.name: item for item in stage.model.problem.givens}
    for value in (body.mass, body.inertia):
        letters = value.symbols() if value is not None else ()
        if value is not None and letters and not any(given[name].automatic for name in letters if name in given):
            return formula(value)
    return prose(spoken(body.name).removeprefix("the "))


def draw_names(stage: Stage, sheet: Sheet) -> None:
    """The name of each body: within a block, else beside the body."""
    for body in stage.bodies.values():
        words = named(body.body, stage)
        at = sheet.at(body.place)
        points = [sheet.at(point) for point in body.bound()]
        if body.block:
            sheet.letters.name(words, at, outside(body, stage), sheet.scale * body.reach(outside(body, stage)) + 3.0, inside=True)
        elif points:
            middle = (sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points))
            way = beside(body, stage)
            reach = max((x - middle[0]) * way[0] + (y - middle[1]) * way[1] for x, y in points)
            sheet.letters.name(words, middle, way, max(reach, 3.0) + 3.0)


def outside(body: Figured, stage: Stage) -> Point:
    """The side on which a body has most room: away from the middle of all."""
    xs = [other.place[0] for other in stage.bodies.values()]
    return (1.0, 0.0) if body.place[0] >= sum(xs) / len(xs) - 1e-9 else (-1.0, 0.0)


def beside(body: Figured, stage: Stage) -> Point:
    """Across a rod, above it; of other bodies down to the right."""
    if shape_of(body.body).slender:
        x, y = quarter(polar(body.turn))
        return (x, y) if y > 0.02 or (abs(y) <= 0.02 and x > 0) else (-x, -y)
    return (0.75, -0.65) if outside(body, stage)[0] > 0 else (-0.75, -0.65)


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
    for own, spot, turn in parts:
        reach = own.reach() if own.slender else None
        words = told(stage, reach)
        if reach is not None and words is not None:
            half = stage.value(reach) / 2
            ends = [sheet.at(body.spot(moved(spot, polar(turn), side * half))) for side in (-1.0, 1.0)]
            sheet.dimension(*ends, words, -SPACE if upwards(ends) else SPACE)
    sides = getattr(shape, "sides", ())
    corners = shape.outline()
    if len(corners) == 4 and len(sides) >= 2:
        places = [sheet.at(body.spot((stage.value(x), stage.value(y)))) for x, y in corners]
        for side, (first, second) in zip(sides, ((0, 1), (1, 2)), strict=False):
            words = told(stage, side)
            if words is not None:
                sheet.dimension(places[first], places[second], words, -SPACE * 0.8)


SPACE = 17.0


def rods_of(body: Body) -> Iterator[Part]:
    return (part for part in body.parts if shape_of(part.body).slender)


def upwards(ends: list[Point]) -> bool:
    """Whether the left of the way from one end to another is above it, or on the left of an upright one."""
    (ax, _), (bx, _) = ends
    return bx >= ax - 0.5


def draw_places(body: Figured, stage: Stage, sheet: Sheet) -> None:
    """How far from the start of a rod something is at `rod.at(x)`; points that the scene names by a letter."""
    seen: set[Formula] = set()
    for ref in mentioned(body.name, stage):
        words = told(stage, ref.argument)
        if ref.argument is None or words is None or ref.argument in seen:
            continue
        seen.add(ref.argument)
        start = sheet.at(body.spot(stage.model.spot(PointRef(body.name, "start"))))
        sheet.dimension(start, sheet.at(body.spot(stage.model.spot(ref))), words, SPACE * (0.9 + 0.75 * (len(seen) - 1)))
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
    at = sheet.at(body.place)
    role = SPIN if speed is not None else SENSE
    words = told(stage, speed.value) if speed is not None else None
    if speed is not None:
        reach = sheet.scale * body.reach(way) + 5.0
        sheet.arrow(moved(at, way, reach), way, ARROW, role, words)
        return
    side = side_of_way(body, way, stage)
    off = sheet.scale * body.reach(side) + 8.0
    start = moved(moved(at, side, off), way, -ARROW / 2)
    sheet.arrow(start, way, ARROW, role, words)


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
    words = told(stage, speed.value) if speed is not None else None
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
    turn = max(0.5, min(1.2, 30.0 / radius))
    middle = math.radians(52.0 if outside(body, stage)[0] > 0 else 128.0)
    sheet.round_arrow(centre, radius, middle - sense * turn / 2, sense * turn, role, words)


