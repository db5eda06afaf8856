"""Senses: the positive way and turn of each body that declares one, and the velocities that a state tells."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

from rotsolve.algebra.formula import Negative, negate
from rotsolve.draw.paper.figure import HATCH, SENSE, SPIN, Box, Point, arc_points, quarter, shifted_by, unit_of
from rotsolve.draw.paper.labels import crosses, straight_pieces
from rotsolve.draw.paper.lettering import Words
from rotsolve.draw.plane.places.bodies import Figured
from rotsolve.draw.plane.places.contacts import normal_sign
from rotsolve.draw.plane.places.kinds import curve_radius
from rotsolve.draw.plane.places.overlaps import hull, meet
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.signs.ground import told_words
from rotsolve.draw.plane.signs.sheet import ARROW, ScenePaper
from rotsolve.draw.plane.signs.sides import body_middle, outer_side, runs_back, told_of
from rotsolve.elements.shapes import shape_of
from rotsolve.language.problem import Condition

SENSE_ARC = 0.85  # radians of a round arrow
CLEAR, STEPS = 1.5, 6  # points of room round an arrow; steps in which a straight one is looked at


def draw_senses(stage: PlaneStage, sheet: ScenePaper) -> None:
    """The positive way of each body that declares one, and velocities that the state tells."""
    for body in stage.bodies.values():
        if not body.seen:
            continue
        speeds = {line.path.quantity: line for line in told_of(body.name, stage) if line.path is not None}
        draw_travel(body, speeds.get("velocity") or speeds.get("speed"), stage, sheet)
        draw_turn(body, speeds.get("angular_velocity"), stage, sheet)


def draw_travel(body: Figured, speed: Condition | None, stage: PlaneStage, sheet: ScenePaper) -> None:
    """An arrow beside a body along its positive way; with a letter, and in another colour, where its velocity is told."""
    way = stage.model.line(body.name)
    if way is None and speed is not None and speed.path is not None and speed.path.component:
        way = {"x": (1.0, 0.0), "y": (0.0, 1.0)}.get(speed.path.component)
    on_curve = way is None and body.body.moves is not None and body.name not in stage.model.held
    if on_curve:
        way = curve_way(body, stage)
    if way is None or (body.body.moves is None and speed is None):
        return
    back = speed is not None and speed.value is not None and runs_back(speed.value, stage)
    way = (-way[0], -way[1]) if back else way
    at, side = sheet.at(body.place), side_of_way(body, way, stage)
    role = SPIN if speed is not None else SENSE
    starts = [ahead_of(body, way, at, sheet)] if speed is not None else []
    starts += [beside_way(body, way, side, at, sheet), beside_way(body, way, (-side[0], -side[1]), at, sheet)]
    starts += [up_to_back(body, way, at, sheet), ahead_of(body, way, at, sheet), shifted_by(at, way, -ARROW / 2)]
    start = freest([[start, shifted_by(start, way, ARROW)] for start in starts], body, stage, sheet)[0]
    sheet.arrow(start, way, ARROW, role, speed_words(speed, stage))


def ahead_of(body: Figured, way: Point, at: Point, sheet: ScenePaper) -> Point:
    """Where an arrow begins that goes on from the edge of a body."""
    return shifted_by(at, way, sheet.scale * body.reach(way) + 5.0)


def up_to_back(body: Figured, way: Point, at: Point, sheet: ScenePaper) -> Point:
    """Where an arrow begins that comes up to the back of a body."""
    return shifted_by(at, way, -sheet.scale * body.reach((-way[0], -way[1])) - 5.0 - ARROW)


def beside_way(body: Figured, way: Point, side: Point, at: Point, sheet: ScenePaper) -> Point:
    """Where an arrow begins that runs along one side of a body."""
    return shifted_by(shifted_by(at, side, sheet.scale * body.reach(side) + 8.0), way, -ARROW / 2)


def freest(courses: Sequence[list[Point]], body: Figured, stage: PlaneStage, sheet: ScenePaper) -> list[Point]:
    """The first of the courses of an arrow that meets fewest lines and no other body."""
    lines = [
        piece
        for mark in sheet.figure.marks
        if mark.role.ink not in ("", "faint") and mark.role is not HATCH
        for piece in straight_pieces(mark)
    ]
    others = [
        hull([sheet.at(point) for point in one.bound()])
        for one in stage.bodies.values()
        if one is not body and one.seen
    ]

    def met(course: list[Point]) -> int:
        """How many of its steps meet something."""
        rooms = [around_step(one, other) for one, other in itertools.pairwise(steps_of_course(course))]
        return sum(
            any(crosses(piece, room) for piece in lines) or any(meet(around_corners(room), one) for one in others)
            for room in rooms
        )

    return min(courses, key=met)


def steps_of_course(course: list[Point]) -> list[Point]:
    """A course in steps: a straight one in several."""
    if len(course) > 2:
        return course
    (ax, ay), (bx, by) = course
    return [(ax + (bx - ax) * k / STEPS, ay + (by - ay) * k / STEPS) for k in range(STEPS + 1)]


def around_step(one: Point, other: Point) -> Box:
    """The room of a step."""
    (ax, ay), (bx, by) = one, other
    return min(ax, bx) - CLEAR, min(ay, by) - CLEAR, max(ax, bx) + CLEAR, max(ay, by) + CLEAR


def around_corners(box: Box) -> list[Point]:
    """The corners of a box, counterclockwise."""
    left, low, right, high = box
    return [(left, low), (right, low), (right, high), (left, high)]


def speed_words(speed: Condition | None, stage: PlaneStage) -> Words | None:
    """The size of a velocity, which its arrow points along."""
    if speed is None or speed.value is None:
        return None
    value = speed.value
    return told_words(stage, negate(value) if runs_back(value, stage) and isinstance(value, Negative) else value)


def curve_way(body: Figured, stage: PlaneStage) -> Point | None:
    """The positive way along a curved surface where a body lies."""
    for item in stage.kinds.contacts:
        if item.lying() == body.name and item.places()[0].owner in stage.surfaces:
            lying_on = stage.surfaces[item.places()[0].owner][0]
            if curve_radius(lying_on) is None:
                return (-1.0, 0.0) if body.body.moves == "left" else (1.0, 0.0)
            for surface, where in stage.surfaces.values():
                if curve_radius(surface) is not None:
                    x, y = (part.at(stage.found) for part in where)
                    out = unit_of((body.place[0] - x, body.place[1] - y))
                    (u, w), sense = quarter(out), normal_sign(surface) * (1.0 if body.body.moves == "left" else -1.0)
                    return u * sense, w * sense
    return None


def side_of_way(body: Figured, way: Point, stage: PlaneStage) -> Point:
    """The side of a body on which the arrow of its way goes: outwards beside what hangs, above what lies."""
    side = quarter(way)
    if abs(way[1]) > 0.9:
        out = outer_side(body, stage)
        return side if side[0] * out[0] > 0 else (-side[0], -side[1])
    return side if side[1] > 0 else (-side[0], -side[1])


def draw_turn(body: Figured, speed: Condition | None, stage: PlaneStage, sheet: ScenePaper) -> None:
    """A round arrow along the positive turn; with a letter where the angular velocity is told."""
    if body.body.turns is None and speed is None:
        return
    sense = float(stage.model.sense(body.name))
    role = SPIN if speed is not None else SENSE
    words = speed_words(speed, stage)
    sense *= -1.0 if speed is not None and speed.value is not None and runs_back(speed.value, stage) else 1.0
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
    middle = math.radians(52.0 if outer_side(body, stage)[0] > 0 else 128.0)
    x, y = sheet.at(body_middle(body))
    if math.dist((x, y), centre) > 0.3 * radius:
        middle = math.atan2(y - centre[1], x - centre[0]) - 0.2
    elif body.outlines[0].radius is None:  # above the upper edge of what has corners
        middle, radius = math.pi / 2, sheet.scale * body.reach((0.0, 1.0)) + 10.0
    turn = max(0.5, min(1.2, 30.0 / radius))
    middles = [middle, math.pi - middle, *(middle + off for off in (-0.6, 0.6, -1.2, 1.2))]
    courses = [arc_points(centre, radius, middle - turn / 2, middle + turn / 2) for middle in middles]
    middle = middles[courses.index(freest(courses, body, stage, sheet))]
    sheet.round_arrow(centre, radius, middle - sense * turn / 2, sense * turn, role, words)
