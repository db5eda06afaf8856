"""Marks in space: names, weights and what the actions exert, beside lengths and what turns."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rotsolve.algebra.formula import Formula
from rotsolve.confirm.space.arrows import (
    Arrow,
    arrow_length,
    normed,
    scaled,
    sum_of,
)
from rotsolve.draw.paper.figure import FORCE, Point
from rotsolve.draw.paper.lettering import Words, formula_words, prose
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.draw.plane.signs.wording import named_in
from rotsolve.draw.space.lengths import draw_points, draw_space_lengths, paper, space_words
from rotsolve.draw.space.stage import FAULTS, DrawnSolid, SpaceStage
from rotsolve.draw.space.turning import draw_turning, round_arrow
from rotsolve.draw.space.view import seen

ARROW, FORCED = 34.0, 40.0  # points of an arrow


def draw_marks(stage: SpaceStage, sheet: ScenePaper) -> None:
    """All of them."""
    for solid in stage.solids.values():
        draw_space_lengths(solid, stage, sheet)
        draw_points(solid, stage, sheet)
        draw_turning(solid, stage, sheet)
        draw_weight(solid, stage, sheet)
        draw_name(solid, stage, sheet)
    draw_space_actions(stage, sheet)


def draw_name(solid: DrawnSolid, stage: SpaceStage, sheet: ScenePaper) -> None:
    """The letter of its mass, else its name, beside it."""
    points = [paper(point, sheet) for piece in solid.pieces for point in piece.points]
    if not points:
        return
    way = (0.8, -0.6)
    edge = max(points, key=lambda point: point[0] * way[0] + point[1] * way[1])
    sheet.letters.name(named_in(solid.body, stage.problem), edge, way, 3.0, tag=solid.name)


def draw_weight(solid: DrawnSolid, stage: SpaceStage, sheet: ScenePaper) -> None:
    """The weight of a body, down from its centre of mass; none that turns with a body."""
    body, gravity = solid.body, stage.problem.gravity
    if gravity is None or stage.problem.gravity_in or body.mass is None or not solid.pieces:
        return
    try:
        if stage.rig.gravity == 0.0 or stage.value(body.mass) == 0.0:
            return
    except FAULTS:
        return
    words = space_words(body.mass, stage)
    if words is None:
        return
    weight = prose("weight") if words.prose else formula_words(body.mass * gravity)
    sheet.arrow(paper(solid.place, sheet), (0.0, -1.0), FORCED, FORCE, weight)


def draw_space_actions(stage: SpaceStage, sheet: ScenePaper) -> None:
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
                sheet.arrow(first, flat_unit(flat), long, FORCE, words)


def flat_unit(flat: Point) -> Point:
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
            yield normed(stage.rig.arrow(way)), space_words(size, stage)
    except FAULTS:
        return
