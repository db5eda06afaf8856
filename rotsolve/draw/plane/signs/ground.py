"""Ground: how surfaces are drawn, as long as what lies on them needs, up to where strings leave them over a wheel."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.confirm.bodies import radius_of
from rotsolve.confirm.signs import normal, surface_of, uphill
from rotsolve.draw.paper.figure import GROUND, STRING, SURFACE, Point, arc_points, shifted_by
from rotsolve.draw.paper.lettering import Words
from rotsolve.draw.plane.places.kinds import by_kind, edge_height, row_for
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.draw.plane.signs.wording import told_as
from rotsolve.elements.connections.touch import Touch
from rotsolve.elements.shapes import shape_of
from rotsolve.elements.surfaces import Corner, Curved, Dome, Hollow, Level, Slope, Track, Wall, Wire
from rotsolve.language.bodies import Surface

BEYOND, SHORT = 24.0, 3.0  # points of a surface beyond what lies on it; between its edge and a wheel
DEEP = 34.0  # of the side of a table that is seen
RUN_OUT = 200.0  # of a slope beyond what lies on it, at most
ANCHOR = 66.0  # from a body to the ground to which a spring ties it
ARC = 30.0  # radius of the arc of an angle
CROSSED = 0.02  # of the measure of a scene, by which a body must be on both sides of a wall to lie across it


def told_words(stage: PlaneStage, value: Formula | None) -> Words | None:
    """A size in its letter, or as it is written where it is a number."""
    return told_as(value, stage.model.problem)


def lying_on(name: str, stage: PlaneStage) -> Iterator[Touch]:
    """The contacts of bodies with a surface."""
    for item in stage.kinds.contacts:
        surface = surface_of(item, stage.model)
        if surface is None or surface.name != name or item.lying() not in stage.bodies:
            continue
        if item.places()[0].owner not in stage.bodies:
            yield item


def surface_extent(
    surface: Surface, along: Point, stage: PlaneStage, sheet: ScenePaper
) -> tuple[float, float, bool, bool]:
    """From where to where along a flat surface it is drawn, on paper; and whether it ends in an edge at either end."""
    bounds = []
    for _ in stage.moments():
        for x, y in map(sheet.at, lying_points(surface, stage)):
            bounds.append(x * along[0] + y * along[1])
    for ref in anchored(surface, stage):
        x, y = sheet.at(stage.bodies[ref].place)
        bounds.append(x * along[0] + y * along[1] - ANCHOR)
    bounds = bounds or [0.0]
    low, high = min(bounds) - BEYOND, max(bounds) + BEYOND
    edges = [False, False]
    for centre, radius, upwards in wheels_beyond(surface, along, stage):
        edge = sheet.scale * (centre[0] * along[0] + centre[1] * along[1])
        room = sheet.scale * radius + SHORT
        if upwards:
            high, edges[1] = edge - room, True
        else:
            low, edges[0] = edge + room, True
    return low, high, edges[0], edges[1]


def lying_points(surface: Surface, stage: PlaneStage) -> Iterator[Point]:
    """The points under which a surface has to be: those of all that lies on it, of a rod where it touches."""
    for item in lying_on(surface.name, stage):
        body = stage.bodies[item.lying()]
        if props(item, stage):
            continue
        touching = stage.point(item.pair()[0])
        rod = shape_of(body.body).slender
        yield from body.bound() if not rod or touching is None else [touching]


def anchored(surface: Surface, stage: PlaneStage) -> Iterator[str]:
    """The bodies on a surface that a spring ties to the ground on their left."""
    lying = {item.lying() for item in lying_on(surface.name, stage)}
    for item in stage.kinds.springs:
        if item.spring[0].owner not in stage.bodies and item.spring[1].owner in lying:
            yield item.spring[1].owner


def props(item: Touch, stage: PlaneStage) -> bool:
    """Whether a contact holds a level rod at one of its points: a trestle, no floor."""
    body = stage.bodies[item.lying()]
    level = shape_of(body.body).slender and abs(math.sin(body.turn)) < 0.05
    return level and item.pair()[0].point not in (None, "center", "cm")


def wheels_beyond(surface: Surface, along: Point, stage: PlaneStage) -> Iterator[tuple[Point, float, bool]]:
    """The wheels over which strings leave a surface: centre, radius, and whether that is on the way `along`."""
    lying = {item.lying() for item in lying_on(surface.name, stage)}
    for _, _, leg in stage.legs():
        for ref, wheel, sign in ((leg.first, leg.second, 1.0), (leg.second, leg.first, -1.0)):
            if ref.owner not in lying or leg.along is None or wheel.owner not in stage.bodies or wheel.owner in lying:
                continue
            ahead = sign * (leg.along[0] * along[0] + leg.along[1] * along[1])
            if abs(ahead) > 0.99 and leg.sides[1 if sign > 0 else 0]:
                radius = radius_of(stage.model.body(wheel.owner), wheel.point, stage.value) or 0.0
                whole = radius_of(stage.model.body(wheel.owner), None, stage.value) or radius
                yield stage.bodies[wheel.owner].place, max(radius, whole), ahead > 0


def flat_ends(
    surface: Surface, level: float, along: Point, out: Point, stage: PlaneStage, sheet: ScenePaper
) -> tuple[Point, Point]:
    """The ends of a flat surface on paper."""
    low, high, _, _ = surface_extent(surface, along, stage, sheet)
    foot = (out[0] * level * sheet.scale, out[1] * level * sheet.scale)
    return shifted_by(foot, along, low), shifted_by(foot, along, high)


def level_surface(surface: Level, where: float, stage: PlaneStage, sheet: ScenePaper) -> None:
    """A floor as far as the walls and edges that stand on it; a table has sides where strings leave it."""
    low, high, left_edge, right_edge = surface_extent(surface, (1.0, 0.0), stage, sheet)
    y = where * sheet.scale
    lying = list(lying_on(surface.name, stage))
    for item in lying:
        if props(item, stage):
            place = stage.point(item.pair()[0])
            sheet.prop(sheet.at(place) if place is not None else (0.0, y))
    if lying and all(props(item, stage) for item in lying):
        return
    for x, right in standing_walls(stage):
        x *= sheet.scale
        low, high = (low, x) if right else (x, high)
    points = [(low, y), (high, y)]
    for place, height, right in edges_above(stage):
        x, up = place[0] * sheet.scale, height * sheet.scale
        points = (
            [(low, y), (x, y), (x, y + up), (max(high, x + 2 * BEYOND), y + up)]
            if right
            else [(min(low, x - 2 * BEYOND), y + up), (x, y + up), (x, y), (high, y)]
        )
    points = [(low, y - DEEP)] * left_edge + points + [(high, y - DEEP)] * right_edge
    sheet.hatched(points)
    stage.drawn_ground += points


def standing_walls(stage: PlaneStage) -> Iterator[tuple[float, bool]]:
    """Where walls stand, and whether on the right: their level counts out of them."""
    for surface, where in stage.surfaces.values():
        if surface.upright:
            out = normal(surface, stage.model)[0]
            x = where.at(stage.found) * out
            if clear_below(x, stage):
                yield x, out < 0.0


def clear_below(x: float, stage: PlaneStage) -> bool:
    """Whether a wall goes down to the floor: where no body lies across it."""
    least = CROSSED * stage.sizes.whole
    spans = [[across for across, _ in body.bound()] for body in stage.bodies.values() if body.seen]
    return not any(min(xs) < x - least and x + least < max(xs) for xs in spans if xs)


def edges_above(stage: PlaneStage) -> Iterator[tuple[Point, float, bool]]:
    """The edges that are climbed: where, how high above the floor, and whether to the right."""
    for surface, where in stage.surfaces.values():
        height = edge_height(surface)
        if height is not None:
            yield stage.middle(where), stage.value(height), getattr(surface, "side", "right") == "right"


def draw_slope(surface: Slope, where: float, stage: PlaneStage, sheet: ScenePaper) -> None:
    """A wedge with its angle at the foot."""
    out, up = normal(surface, stage.model), uphill(surface, stage.model)
    foot, top = flat_ends(surface, where, up, out, stage, sheet)
    strung = any(True for _ in wheels_beyond(surface, up, stage))
    foot = shifted_by(
        foot, up, -(BEYOND if strung else min(max(2 * BEYOND, 0.9 * (math.dist(foot, top) - 2 * BEYOND)), RUN_OUT))
    )
    right = up[0] > 0
    if abs(up[1]) < 1e-6:
        sheet.hatched([foot, top] if right else [top, foot])
        return
    base = (top[0], foot[1])
    sheet.figure.line([foot, top, base], GROUND, closed=True)
    sheet.figure.line([foot, top, base], SURFACE)
    sheet.hatched([foot, base] if right else [base, foot])
    words = told_words(stage, surface.slope)
    angle = math.atan2(abs(up[1]), abs(up[0]))
    long = min(ARC + 8.0, 0.5 * math.dist(foot, base))
    if words is not None:
        sheet.angle(foot, long, *((0.0, angle) if right else (math.pi, math.pi - angle)), words)
    stage.drawn_ground += [foot, top, base]


def wall(surface: Wall, where: float, stage: PlaneStage, sheet: ScenePaper) -> None:
    """A wall, down to the floor where there is one."""
    out = normal(surface, stage.model)
    low, high, _, _ = surface_extent(surface, (0.0, 1.0), stage, sheet)
    down = clear_below(where * out[0], stage)
    for other, level in stage.surfaces.values():
        if other.level and down:
            low = level.at(stage.found) * sheet.scale
    low, high = (low, high) if down else (low + BEYOND, high)  # what lies across it is below
    x = where * out[0] * sheet.scale
    sheet.hatched([(x, high), (x, low)] if out[0] > 0 else [(x, low), (x, high)])
    stage.drawn_ground += [(x, low), (x, high)]


def step(surface: Corner, where: Point, stage: PlaneStage, sheet: ScenePaper) -> None:
    """An edge, drawn by the floor below it where there is one; its height is told."""
    x, y = sheet.at(where)
    right, height = surface.side == "right", stage.value(surface.corner) * sheet.scale if surface.corner else 0.0
    end = 2 * BEYOND if right else -2 * BEYOND
    if not any(other.level for other, _ in stage.surfaces.values()):
        points = [(x, y - height), (x, y), (x + end, y)]
        sheet.hatched(points if right else points[::-1])
    words = told_words(stage, surface.corner)
    if words is not None and height > 4.0:
        feet = ((x, y - height), (x, y))
        sheet.dimension(*feet, words, -0.7 * abs(end) if right else 0.7 * abs(end))
    stage.drawn_ground += [(x, y - height), (x + end, y)]


def bowl(surface: Hollow, where: Point, stage: PlaneStage, sheet: ScenePaper) -> None:
    """The lower half of a circle, or all of it where a body goes over its top."""
    round_curve(surface, where, stage, sheet, loops(surface, stage))


def draw_wire(surface: Wire, where: Point, stage: PlaneStage, sheet: ScenePaper) -> None:
    """A ring of wire, without ground behind it."""
    centre, radius = sheet.at(where), stage.value(surface.radius() or ZERO) * sheet.scale
    sheet.figure.line(arc_points(centre, radius, -math.pi / 2, 1.5 * math.pi), STRING)
    words = told_words(stage, surface.radius())
    if words is not None:
        sheet.radius(centre, radius, clear_way(surface, centre, stage, sheet), words)
        sheet.hub(centre)


def loops(surface: Curved, stage: PlaneStage) -> bool:
    """Whether a state speaks of a place in the upper half of a hollow, or the track leads into it from elsewhere."""
    for item in by_kind(stage.model.problem.connections).contacts:
        if any(ref.owner == surface.name for ref in item.places()):
            if len(item.places()) > 1:
                return True
            for state in stage.model.problem.states:
                for line in state.conditions:
                    path = line.path
                    if (
                        path is not None
                        and path.owner == item.name
                        and path.quantity == "angle"
                        and line.value is not None
                    ) and math.sin(stage.value(line.value)) > 0.05:
                        return True
    return False


def round_curve(surface: Curved, where: Point, stage: PlaneStage, sheet: ScenePaper, whole: bool) -> None:
    size = surface.radius()
    if size is None:
        return
    centre, radius = sheet.at(where), stage.value(size) * sheet.scale
    start, end = (
        (-math.pi / 2, 1.5 * math.pi) if whole else (0.0, math.pi) if surface.outside else (math.pi, 2 * math.pi)
    )
    points = arc_points(centre, radius, start, end)
    sheet.hatched(points, 1 if surface.outside else -1)
    if surface.outside and not whole:
        sheet.figure.line([*points], GROUND, closed=True)
        sheet.hatched([(centre[0] - radius - BEYOND, centre[1]), (centre[0] + radius + BEYOND, centre[1])])
    words = told_words(stage, size)
    if words is not None:
        way = clear_way(surface, centre, stage, sheet)
        sheet.radius(centre, radius, way, words)
        sheet.hub(centre)
    stage.drawn_ground += points


def clear_way(surface: Curved, centre: Point, stage: PlaneStage, sheet: ScenePaper) -> float:
    """The direction of a radius, in radians, that is farthest from the bodies on the surface."""
    taken = []
    for item in lying_on(surface.name, stage):
        x, y = sheet.at(stage.bodies[item.lying()].place)
        taken.append(math.atan2(y - centre[1], x - centre[0]))
    ways = [math.radians(way) for way in ((155.0, 35.0, 120.0) if surface.outside else (215.0, 325.0, 250.0))]
    return max(
        ways, key=lambda way: min((abs(math.remainder(way - other, 2 * math.pi)) for other in taken), default=0.0)
    )


def hill(surface: Dome, where: Point, stage: PlaneStage, sheet: ScenePaper) -> None:
    """The upper half of a circle on the ground."""
    round_curve(surface, where, stage, sheet, False)


def track(surface: Track, where: Point, stage: PlaneStage, sheet: ScenePaper) -> None:
    """A curve that falls away from under the body: only its heights matter."""
    for item in stage.kinds.contacts:
        if surface.name not in {ref.owner for ref in item.places()}:
            continue
        body = stage.bodies[item.lying()]
        low = sheet.scale * body.reach((0.0, -1.0))
        x, y = sheet.at(body.place)
        right = -1.0 if body.body.moves == "left" else 1.0
        wide, deep = max(110.0, sheet.scale * 2.0 * stage.sizes.whole), max(60.0, sheet.scale * 1.2 * stage.sizes.whole)
        meets = stage.loop_foot
        if meets is not None:
            foot = sheet.at(meets)
            wide, deep = abs(foot[0] - x), y - low - foot[1]
        curve = [(x - right * 14.0, y - low + 0.5)]
        curve += [
            (x + right * wide * t, y - low - deep * (1 - math.cos(math.pi * t)) / 2)
            for t in (k / 24 for k in range(25))
        ]
        sheet.hatched(curve if right > 0 else curve[::-1])
        stage.drawn_ground += curve


SURFACES: dict[type[Surface], Callable[[Any, Any, PlaneStage, ScenePaper], None]] = {
    Level: level_surface,
    Slope: draw_slope,
    Wall: wall,
    Corner: step,
    Hollow: bowl,
    Wire: draw_wire,
    Dome: hill,
    Track: track,
}


def draw_surfaces(stage: PlaneStage, sheet: ScenePaper) -> None:
    """All surfaces on which something lies."""
    for surface, where in stage.surfaces.values():
        draw = row_for(type(surface), SURFACES)
        if draw is None:
            continue
        found = tuple(part.at(stage.found) for part in where) if isinstance(where, tuple) else where.at(stage.found)
        draw(surface, found, stage, sheet)
