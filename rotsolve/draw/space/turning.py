"""Turning: what turns a body in space, as a state tells it: ω about a joint, precession and spin, and the tilt with its cone."""

from __future__ import annotations

import math

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.confirm.space.arrows import (
    Arrow,
    Z,
    arrow_length,
    crossed,
    inner_product,
    less,
    normed,
    scaled,
    sum_of,
)
from rotsolve.draw.paper.figure import DIMENSION, GHOST, SENSE, SPIN
from rotsolve.draw.paper.lettering import Words, letter
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.draw.space.lengths import abs_of, along_body, paper, space_words
from rotsolve.draw.space.stage import FAULTS, DrawnSolid, SpaceStage
from rotsolve.draw.space.view import ring
from rotsolve.language.bodies import Joint

ARROW, FORCED = 34.0, 40.0  # points of an arrow
SENSE_TURN = 4.6  # radians of a round arrow


def draw_turning(solid: DrawnSolid, stage: SpaceStage, sheet: ScenePaper) -> None:
    """What turns a body: the rate about its joint, its precession and spin with its tilt, or the components of ω that are told."""
    for joint in stage.joints(solid.name):
        drive = dict(joint.drive)
        rate = drive.get("angular_velocity")
        rate = (
            rate
            if rate is not None
            else value_told(joint.owner, "angular_velocity", stage) or value_told(solid.name, "angular_velocity", stage)
        )
        way = stage.way(joint)
        if rate is not None and way is not None and stage_sign(rate, stage):
            draw_rate(joint, normed(way), rate, solid, stage, sheet)
    if stage.lines.nods(solid.name):
        draw_nodding(solid, stage, sheet)
    told_omega = stage.lines.arrow_told(solid.name, "angular_velocity")
    if told_omega is not None and arrow_length(told_omega[0]) > 0.0:
        omega = told_omega[0] if told_omega[1] in ("", "space") else along_body(solid, told_omega[0])
        draw_omega(solid.place, normed(omega), letter("omega"), solid, sheet)


def value_told(owner: str, word: str, stage: SpaceStage) -> Formula | None:
    line = stage.lines.line(owner, word)
    return line.value if line is not None else None


def stage_sign(value: Formula, stage: SpaceStage) -> float:
    """The sign of a value, 1 of one that nothing tells."""
    try:
        return stage.value(value)
    except FAULTS:
        return 1.0


def draw_rate(joint: Joint, way: Arrow, rate: Formula, solid: DrawnSolid, stage: SpaceStage, sheet: ScenePaper) -> None:
    """A round arrow about an axis beyond the body, with the rate."""
    sign = 1.0 if stage_sign(rate, stage) > 0.0 else -1.0
    ahead = scaled(1.16 * max(solid.size, 0.3 * stage.whole), way)
    round_arrow(sum_of(stage.held_at(joint), ahead), scaled(sign, way), space_words(abs_of(rate, stage), stage), sheet)


def round_arrow(
    centre: Arrow, way: Arrow, words: Words | None, sheet: ScenePaper, radius: float = 11.0, role: object = SPIN
) -> None:
    """A round arrow about a direction in space, counterclockwise as seen against it."""
    points = [paper(point, sheet) for point in ring(centre, way, radius / sheet.scale, -0.4, SENSE_TURN)]
    sheet.figure.line(points, SPIN if role is SPIN else SENSE, heads=">")
    if words is not None:
        middle = paper(centre, sheet)
        right = max(points, key=lambda point: point[0])
        sheet.letters.name(
            words, middle, (right[0] - middle[0] + 1.0, 0.3), max(right[0] - middle[0], 4.0) + 3.0, SPIN.ink
        )


def draw_omega(start: Arrow, way: Arrow, words: Words, solid: DrawnSolid, sheet: ScenePaper) -> None:
    """An arrow in space out of a body."""
    first = paper(start, sheet)
    tip = paper(sum_of(start, scaled(solid.size + ARROW / sheet.scale, way)), sheet)
    sheet.figure.line([first, tip], SPIN, heads=">")
    sheet.letters.name(words, tip, (tip[0] - first[0], tip[1] - first[1] + 0.1), 3.0, SPIN.ink)


def draw_nodding(solid: DrawnSolid, stage: SpaceStage, sheet: ScenePaper) -> None:
    """The tilt from the upright, the cone on which the axis goes round, and the round arrows of precession and spin."""
    axis = stage.axis(solid.name)
    if axis is None:
        return
    axis = normed(axis)
    pivot = next((stage.held_at(joint) for joint in stage.joints(solid.name) if not joint.rolls), solid.place)
    long = max(
        math.dist(pivot, solid.place) + 1.15 * max(spread_along(solid, axis), 0.4 * solid.size), 0.9 * solid.size
    )
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
        draw_tilt(pivot, axis, 0.42 * long, value_told(solid.name, "tilt", stage), stage, sheet)
    for word, letter_of, centre, way in (
        ("precession", "precession", upright, Z),
        ("spin", "spin", tip, stage.axis(solid.name) or axis),
        ("axial_rate", "axial_rate", tip, stage.axis(solid.name) or axis),
    ):
        value = value_told(solid.name, word, stage)
        asked = asked_as(solid.name, word, stage)
        if value is not None and (not (own_value := stage_sign(value, stage)) or own_value == 0.0):
            continue
        if value is not None or asked is not None:
            sign = 1.0 if value is None or stage_sign(value, stage) > 0.0 else -1.0
            words = space_words(abs_of(value, stage), stage) if value is not None else letter(asked or letter_of)
            round_arrow(centre, scaled(sign, normed(way)), words, sheet)


def spread_along(solid: DrawnSolid, axis: Arrow) -> float:
    """How far a body goes along a direction from its centre of mass."""
    return max(
        (abs(inner_product(less(point, solid.place), axis)) for piece in solid.pieces for point in piece.points),
        default=0.0,
    )


def asked_as(name: str, word: str, stage: SpaceStage) -> str | None:
    """The name under which the scene asks for a quantity of a body."""
    for find in stage.problem.finds:
        if len(find.terms) == 1 and find.formula == Symbol("#0"):
            path = find.terms[0].path
            if (path.owner, path.quantity) == (name, word):
                return find.name
    return None


def draw_tilt(
    pivot: Arrow, axis: Arrow, radius: float, value: Formula | None, stage: SpaceStage, sheet: ScenePaper
) -> None:
    """The arc from the upright to the axis, with its letter."""
    words = space_words(value, stage) if value is not None else letter("theta")
    if words is None or (value is not None and not value.symbols() and abs(stage.value(value) - math.pi / 2) < 1e-9):
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
