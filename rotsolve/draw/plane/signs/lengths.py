"""Lengths: radii, lengths and sides of bodies, and places on rods, with their letters."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rotsolve.algebra.formula import Formula
from rotsolve.confirm.bodies import frame, rocker
from rotsolve.draw.paper.figure import Point, quarter, ray, shifted_by
from rotsolve.draw.paper.lettering import letter
from rotsolve.draw.plane.places.bodies import Figured
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.signs.ground import told_words
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.draw.plane.signs.sides import open_side, velocity_way
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import Body, Part, PointRef

RADII = (35.0, 145.0, 80.0, 205.0, 325.0)  # directions in which radii are drawn, in degrees
NARROW = 9.0  # points below which a radius has no room for its letter
SPACE = 17.0
OUT = 0.75  # of the opening of a round side, at which its radius is drawn


def draw_lengths(stage: PlaneStage, sheet: ScenePaper) -> None:
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


def draw_radii(body: Figured, stage: PlaneStage, sheet: ScenePaper) -> None:
    told_radii = {rim: bow_way(body.body, None, stage) for rim in rims_of(body.body)}
    for part in (*body.body.parts, *body.body.holes):
        spot, _ = frame(part, stage.value)
        told_radii |= {rim: bow_way(body.body, part.body.name, stage) for rim in rims_of(part.body, spot)}
    for number, ((radius, spot), own) in enumerate(told_radii.items()):
        words, size = told_words(stage, radius), stage.value(radius) * sheet.scale
        if words is not None and size > NARROW and body.seen:
            way = math.radians(RADII[number % len(RADII)]) if own is None else body.turn + own
            sheet.radius(sheet.at(body.spot(spot)), size, way, words)


def bow_way(body: Body, part: str | None, stage: PlaneStage) -> float | None:
    """The direction, in a body's own axes, in which the radius of what is round on one side only is drawn."""
    rocks = rocker(body, part, stage.value)
    return None if rocks is None else rocks.first + OUT * (rocks.last - rocks.first)


def draw_sides(body: Figured, stage: PlaneStage, sheet: ScenePaper) -> None:
    """The length of a rod; width and height of a box."""
    shape = shape_of(body.body)
    parts = [
        (shape, (0.0, 0.0), 0.0),
        *((shape_of(part.body), *frame(part, stage.value)) for part in rods_of(body.body)),
    ]
    seen = [words for radius, _ in rims_of(body.body) if (words := told_words(stage, radius)) is not None]
    for own, spot, turn in parts:
        reach = own.reach() if own.slender else None
        words = told_words(stage, reach)
        if reach is not None and words is not None:
            half = stage.value(reach) / 2
            ends = [sheet.at(body.spot(shifted_by(spot, ray(turn), side * half))) for side in (-1.0, 1.0)]
            if words in seen:
                continue
            seen.append(words)
            side = open_side(body, stage) if own is shape else (0.0, 1.0)
            along = (ends[1][0] - ends[0][0], ends[1][1] - ends[0][1])
            left = quarter(along)[0] * side[0] + quarter(along)[1] * side[1] > 0
            sheet.dimension(ends[0], ends[1], words, -SPACE if left else SPACE)
    sides = getattr(shape, "sides", ())
    corners = shape.outline()
    if len(corners) == 4 and len(sides) >= 2:
        places = [sheet.at(body.spot((stage.value(x), stage.value(y)))) for x, y in corners]
        ahead = velocity_way(body, stage)
        pairs = ((2, 3) if ahead[1] < -0.5 else (0, 1), (3, 0) if ahead[0] > 0.5 else (1, 2))
        for side, (first, second) in zip(sides, pairs, strict=False):
            words = told_words(stage, side)
            if words is not None:
                sheet.dimension(places[first], places[second], words, -SPACE * 0.8)


def rods_of(body: Body) -> Iterator[Part]:
    return (part for part in body.parts if shape_of(part.body).slender)


def draw_places(body: Figured, stage: PlaneStage, sheet: ScenePaper) -> None:
    """How far from the start of a rod something is at `rod.at(x)`; points that the scene names by a letter."""
    seen: set[Formula] = set()
    for ref in mentioned(body.name, stage):
        words = told_words(stage, ref.argument)
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


def mentioned(name: str, stage: PlaneStage) -> Iterator[PointRef]:
    """The points of a body that connections and actions name."""
    for item in (*stage.model.acting.connections, *stage.model.acting.actions):
        yield from (ref for ref in item.touches() if ref.owner == name)
