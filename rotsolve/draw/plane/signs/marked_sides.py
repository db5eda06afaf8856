"""Marked sides: the angles of slopes that are sides of bodies, and the radii of their round sides."""

from __future__ import annotations

import math

from rotsolve.draw.paper.figure import Point
from rotsolve.draw.plane.places.contacts import normal_sign
from rotsolve.draw.plane.places.kinds import curve_radius
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.signs.ground import ARC, told_words
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.language.bodies import Surface

LEVEL = 1e-3  # of the height of a body, by which a corner is above its foot


def mark_sides(stage: PlaneStage, sheet: ScenePaper) -> None:
    """Each side on which something lies, once."""
    sides = {item.side.name: item.side for item in stage.kinds.contacts if item.side is not None}
    for side in sides.values():
        if side.bearer() in stage.bodies and not side.curved:
            mark_slope(side, stage, sheet)
        elif side.bearer() in stage.bodies:
            mark_round(side, stage, sheet)


def mark_slope(side: Surface, stage: PlaneStage, sheet: ScenePaper) -> None:
    """The angle at the foot to which a body falls, within it."""
    tilt, points = side.tilt(), stage.bodies[side.bearer()].bound()
    words = told_words(stage, tilt)
    if words is None or tilt is None:
        return
    right, low = getattr(side, "down", "right") == "right", min(y for _, y in points)
    feet = [point for point in points if point[1] - low <= LEVEL * (max(y for _, y in points) - low)]
    foot, angle = sheet.at(max(feet) if right else min(feet)), stage.value(tilt)
    sheet.angle(foot, ARC + 8.0, *((math.pi - angle, math.pi) if right else (0.0, angle)), words)


def mark_round(side: Surface, stage: PlaneStage, sheet: ScenePaper) -> None:
    """The radius from the middle, away from what lies there."""
    size = curve_radius(side)
    words = told_words(stage, size)
    if words is None or size is None:
        return
    centre = sheet.at(stage.bodies[side.bearer()].place)
    taken = [way_off(centre, sheet.at(stage.bodies[item.lying()].place)) for item in stage.kinds.contacts if item.side]
    ways = [math.radians(way) for way in ((155.0, 35.0, 120.0) if normal_sign(side) > 0 else (215.0, 325.0, 250.0))]
    way = max(ways, key=lambda one: min(abs(math.remainder(one - other, 2 * math.pi)) for other in taken))
    sheet.radius(centre, stage.value(size) * sheet.scale, way, words)
    sheet.hub(centre)


def way_off(centre: Point, place: Point) -> float:
    """The direction from one place on paper to another."""
    return math.atan2(place[1] - centre[1], place[0] - centre[0])
