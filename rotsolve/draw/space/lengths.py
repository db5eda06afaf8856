"""Lengths in space: where places are on paper, and radii, lengths and sides of bodies, with their letters."""

from __future__ import annotations

import math

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.confirm.space.arrows import (
    Arrow,
    inner_product,
    less,
    normed,
    scaled,
    sum_of,
)
from rotsolve.draw.paper.figure import DIMENSION, SOLID, Point
from rotsolve.draw.paper.lettering import Words, letter
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.draw.plane.signs.wording import told_as
from rotsolve.draw.space.stage import FAULTS, DrawnSolid, SpaceStage
from rotsolve.draw.space.view import seen
from rotsolve.elements.shapes import shape_of

NARROW = 7.0  # points below which a length has no room for its letter


def paper(place: Arrow, sheet: ScenePaper) -> Point:
    return sheet.at(seen(place))


def space_words(value: Formula | None, stage: SpaceStage) -> Words | None:
    return told_as(value, stage.problem)


def draw_space_lengths(solid: DrawnSolid, stage: SpaceStage, sheet: ScenePaper) -> None:
    """Radii, lengths and sides."""
    shape = shape_of(solid.body)
    origin = (
        less(solid.place, along_body(solid, stage.rig.solid(solid.name).centre)) if known(solid, stage) else solid.place
    )
    radius = getattr(shape, "radius", None) if not shape.pointlike else None
    words = space_words(radius, stage)
    if radius is not None and words is not None:
        mark_length(
            origin,
            sum_of(origin, along_body(solid, scaled(stage.value(radius), rim_way(shape.spherical)))),
            words,
            sheet,
        )
    reach = shape.reach() if shape.slender else None
    words = space_words(reach, stage)
    if reach is not None and words is not None:
        half = stage.value(reach) / 2
        ends = [paper(sum_of(origin, along_body(solid, (side * half, 0.0, 0.0))), sheet) for side in (-1.0, 1.0)]
        if math.dist(*ends) > NARROW:
            sheet.dimension(ends[0], ends[1], words, 13.0)
    draw_box_sides(solid, origin, stage, sheet)


def known(solid: DrawnSolid, stage: SpaceStage) -> bool:
    try:
        return stage.rig.solid(solid.name) is not None
    except FAULTS:
        return False


def rim_way(spherical: bool) -> Arrow:
    return normed((0.3, 0.9, 0.3)) if spherical else normed((-0.35, 0.94, 0.0))


def along_body(solid: DrawnSolid, arrow: Arrow) -> Arrow:
    """An arrow of a body's own axes, in space."""
    rows = solid.rows
    return (inner_product(rows[0], arrow), inner_product(rows[1], arrow), inner_product(rows[2], arrow))


def mark_length(start: Arrow, end: Arrow, words: Words, sheet: ScenePaper) -> None:
    """An arrow from one place to another with a letter beside its middle."""
    first, second = paper(start, sheet), paper(end, sheet)
    if math.dist(first, second) < NARROW:
        return
    sheet.figure.line([first, second], DIMENSION, heads=">")
    middle = (0.45 * first[0] + 0.55 * second[0], 0.45 * first[1] + 0.55 * second[1])
    sheet.letters.name(words, middle, (-(second[1] - first[1]), second[0] - first[0]), 1.5)


def draw_box_sides(solid: DrawnSolid, origin: Arrow, stage: SpaceStage, sheet: ScenePaper) -> None:
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
        words = space_words(side, stage)
        if words is None:
            continue
        first, second = (paper(sum_of(origin, along_body(solid, place)), sheet) for place in (start, end))
        middle = ((first[0] + second[0]) / 2, (first[1] + second[1]) / 2)
        centre = paper(origin, sheet)
        sheet.letters.name(words, middle, (middle[0] - centre[0], middle[1] - centre[1]), 2.0)


def draw_points(solid: DrawnSolid, stage: SpaceStage, sheet: ScenePaper) -> None:
    """Points of a body that joints or actions name: how far they are from its centre where one letter says that; their own letters."""
    used = {
        ref.point
        for item in (*stage.problem.connections, *stage.problem.actions)
        for ref in item.touches()
        if ref.owner == solid.name
    }
    for name, at in solid.body.points:
        if name not in used:
            continue
        arms = [part for part in at if part != ZERO]
        place = sum_of(own_origin(solid, stage), along_body(solid, three_numbers(at, stage)))
        words = space_words(abs_of(arms[0], stage), stage) if len(arms) == 1 else None
        if words is not None:
            mark_length(own_origin(solid, stage), place, words, sheet)
        if len(name) <= 2:
            sheet.figure.circle(paper(place, sheet), 1.6, SOLID)
            sheet.letters.name(letter(name), paper(place, sheet), (-0.7, -0.7), 2.5)


def own_origin(solid: DrawnSolid, stage: SpaceStage) -> Arrow:
    """The origin of a body's own axes."""
    return (
        less(solid.place, along_body(solid, stage.rig.solid(solid.name).centre)) if known(solid, stage) else solid.place
    )


def three_numbers(at: tuple[Formula, ...], stage: SpaceStage) -> Arrow:
    x, y, *rest = (stage.value(part) for part in at)
    return x, y, rest[0] if rest else 0.0


def abs_of(value: Formula, stage: SpaceStage) -> Formula:
    """A length without its sign."""
    from rotsolve.algebra.formula import Negative, negate

    return negate(value) if isinstance(value, Negative) else value
