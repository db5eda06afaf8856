"""Ghosts: how bodies stand at a later state, dashed, where that is told by an angle or a way."""

from __future__ import annotations

import math

from rotsolve.draw.paper.figure import Point, shifted_by
from rotsolve.draw.plane.places.bodies import Figured
from rotsolve.draw.plane.places.outlines import spun
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.signs.ground import told_words
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.language.problem import Condition

BESIDE = 11.0  # from a body to the line that tells how far it goes
LEAST = 0.06  # radians by which a body must be turned for that to be seen


def draw_ghosts(stage: PlaneStage, sheet: ScenePaper) -> None:
    """The next state that tells of each body how it stands then."""
    acting = stage.model.acting
    drawn: set[str] = set()
    for state in acting.states[acting.index + 1 :]:
        for line in state.conditions:
            path = line.path
            if path is None or path.owner not in stage.bodies or path.owner in drawn or line.value is None:
                continue
            body = stage.bodies[path.owner]
            if (path.quantity == "angle" and path.point is None and draw_turned(body, line, stage, sheet)) or (
                path.quantity == "displacement" and path.component is None and draw_moved(body, line, stage, sheet)
            ):
                drawn.add(path.owner)


def draw_turned(body: Figured, line: Condition, stage: PlaneStage, sheet: ScenePaper) -> bool:
    """A body that is held, turned about its hinge."""
    if line.value is None or body.name not in stage.model.held:
        return False
    more = stage.value(line.value) - stage.model.lean(body.name) - stage.q[stage.model.seats[body.name].turn]
    if abs(math.remainder(more, 2 * math.pi)) < LEAST:
        return False
    spot = stage.model.drawn(stage.model.held[body.name][1])
    pivot = body.spot(spot)
    for outline in body.outlines:
        arm = spun(spot, body.turn + more)
        sheet.outline(outline.turned((pivot[0] - arm[0], pivot[1] - arm[1]), body.turn + more), ghost=True)
    return True


def draw_moved(body: Figured, line: Condition, stage: PlaneStage, sheet: ScenePaper) -> bool:
    """A body that travels along a line, further on, with how far that is."""
    way = stage.model.line(body.name)
    words = told_words(stage, line.value)
    if way is None or line.value is None or words is None:
        return False
    long = stage.value(line.value)
    if not room_for(long, stage):
        return False
    for outline in body.shown():
        sheet.outline(outline.turned((way[0] * long, way[1] * long), 0.0), ghost=True)
    side: Point = (way[1], -way[0])
    if abs(way[1]) < 0.9 and side[1] < 0:
        side = (-side[0], -side[1])
    start = sheet.at(shifted_by(body.place, side, body.reach(side)))
    left = side[0] * -way[1] + side[1] * way[0] > 0
    sheet.dimension(start, shifted_by(start, way, long * sheet.scale), words, BESIDE if left else -BESIDE)
    return True


def room_for(long: float, stage: PlaneStage) -> bool:
    """Whether a way fits on the paper beside the bodies."""
    points = [point for body in stage.bodies.values() for point in body.bound()]
    xs, ys = [x for x, _ in points], [y for _, y in points]
    whole = max(max(xs) - min(xs), max(ys) - min(ys), 1e-12)
    return 0.08 * whole < abs(long) < 1.1 * whole
