"""Strings: how strings, springs, belts and heavy ropes run on paper, and what holds their fixed ends and their wheels."""

from __future__ import annotations

import math
from collections.abc import Sequence

from rotsolve.confirm.bodies import radius_of
from rotsolve.confirm.forces import spring_way
from rotsolve.confirm.pose import StringPart
from rotsolve.confirm.routing import rim_arm
from rotsolve.confirm.signs import normal
from rotsolve.core.writing import spoken
from rotsolve.draw.paper.figure import (
    BEHIND,
    GROUND,
    STRING,
    SUPPORT,
    SURFACE,
    THICK,
    Point,
    arc_points,
    quarter,
    ray,
    shifted_by,
    unit_of,
)
from rotsolve.draw.paper.lettering import prose
from rotsolve.draw.plane.places.bodies import Figured
from rotsolve.draw.plane.places.outlines import spun
from rotsolve.draw.plane.places.posts import is_post_of, turn_round
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.signs.ground import told_words
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.draw.plane.signs.wording import named_in
from rotsolve.elements.connections.drapes import Drapes
from rotsolve.elements.connections.drives import Belt
from rotsolve.elements.connections.springs import Spring
from rotsolve.elements.connections.strings import String
from rotsolve.language.bodies import PointRef

LOOSE = 46.0  # points of a string to what is fixed anywhere
COILS, COIL = 8, 4.6  # windings of a spring, and half their width
STRUT = 17.0  # from the rim of a wheel to what holds it
HUNG = 14.0  # from a rope to the line that tells how much of it hangs
LONGEST = 150.0  # of a rope that hangs
ROPE = 3.0  # of a rope that hangs, in the measure of a block, where its length is not told


def leg_ends(name: str, leg: StringPart, stage: PlaneStage, sheet: ScenePaper) -> list[Point]:
    """The ends of a leg on paper; one that is fixed anywhere is straight on from the other."""
    ends: list[Point | None] = []
    for ref, side in ((leg.first, leg.sides[0]), (leg.second, leg.sides[1])):
        ends.append(leg_end(ref, side, leg, stage, sheet))
    x, y = leg.along or (1.0, 0.0)
    first, second = ends
    if first is None and second is not None:
        first = straight_on(name, leg.first, second, (-x, -y), stage, sheet)
    if second is None and first is not None:
        second = straight_on(name, leg.second, first, (x, y), stage, sheet)
    return [first or (0.0, 0.0), second or (0.0, 0.0)]


def straight_on(name: str, ref: PointRef, at: Point, way: Point, stage: PlaneStage, sheet: ScenePaper) -> Point:
    """Where a string to something that is fixed anywhere ends; once for all pictures of a motion."""
    return stage.kept(name, lambda: shifted_by(at, way, free_length(name, ref, at, way, stage, sheet)))


def leg_end(ref: PointRef, side: int, leg: StringPart, stage: PlaneStage, sheet: ScenePaper) -> Point | None:
    """Where a leg meets a wheel, a post or a point."""
    if is_post_of(ref, stage.model) and leg.along is not None:
        return sheet.at(shifted_by(stage.middle(stage.post(ref.owner)), stage.on_post(ref, leg.along)))
    if ref.owner not in stage.bodies or ref.place is not None:
        place = stage.point(ref)
        return None if place is None else sheet.at(place)
    body = stage.bodies[ref.owner]
    if side and leg.along is not None:
        centre = body.spot(stage.model.spot(ref))
        return sheet.at(shifted_by(centre, rim_arm(ref, leg.along, side, stage.model)))
    at, way = sheet.at(body.spot(stage.model.tied(ref))), leg.along
    if not body.block or way is None:
        return at
    sign = 1.0 if ref is leg.first else -1.0
    return shifted_by(at, way, sign * sheet.scale * edge_along(body, (sign * way[0], sign * way[1])))


def edge_along(body: Figured, way: Point) -> float:
    """How far the outside of a block is from its middle, along a direction."""
    x, y = body.outlines[0].points[2]
    own = spun(way, -body.turn)
    return min((size / abs(part) for size, part in ((x, own[0]), (y, own[1])) if abs(part) > 1e-9), default=0.0)


def free_length(name: str, ref: PointRef, at: Point, way: Point, stage: PlaneStage, sheet: ScenePaper) -> float:
    """How long a string is to a wall that stands somewhere, else as long as it looks well; those to a ceiling end at one height."""
    known = stage.surfaces.get(ref.owner)
    if known is not None and not isinstance(known[1], tuple):
        out = normal(known[0], stage.model)
        across = -(way[0] * out[0] + way[1] * out[1])
        level: float = known[1].at(stage.found) * sheet.scale
        gap = at[0] * out[0] + at[1] * out[1] - level
        if across > 0.1 and gap > 0.0:
            return gap / across
    if abs(way[1]) > 0.9:
        seen = [body for body in stage.bodies.values() if body.seen]
        tops = [sheet.at(point)[1] for _ in stage.moments() for body in seen for point in body.bound()]
        end = max(tops) + LOOSE if way[1] > 0 else min(tops) - LOOSE
        return max((end - at[1]) / way[1], LOOSE / 2)
    return LOOSE + stage.longer.get(name, 0.0) * sheet.scale


def draw_string(item: String, stage: PlaneStage, sheet: ScenePaper) -> None:
    """Its legs, what of it lies on the rims between them, and what holds its ends."""
    legs = stage.model.legs(item)
    ends = [leg_ends(f"{item.name} {number}", leg, stage, sheet) for number, leg in enumerate(legs)]
    for leg, (start, end) in zip(legs, ends, strict=True):
        front = any(
            fixed_on_round(ref, side, stage) for ref, side in zip((leg.first, leg.second), leg.sides, strict=True)
        )
        sheet.figure.line([start, end], STRING if front or any(leg.sides) else BEHIND)
    for before, after, leg in zip(ends, ends[1:], legs, strict=False):
        wrapped(leg.second, leg.sides[1], before[1], after[0], stage, sheet)
        if is_post_of(leg.second, stage.model):
            draw_post(leg.second, before[1], after[0], stage, sheet)
    for ref, end, other in ((item.string[0], ends[0][0], ends[0][1]), (item.string[-1], ends[-1][1], ends[-1][0])):
        if ref.owner not in stage.bodies and ref.owner not in stage.surfaces:
            sheet.patch(end, unit_of((other[0] - end[0], other[1] - end[1])))
    for ref in item.string:
        brace(ref, stage, sheet)


def fixed_on_round(ref: PointRef, side: int, stage: PlaneStage) -> bool:
    """Whether a string ends in the middle of a wheel, on which it is seen."""
    return not side and ref.owner in stage.bodies and stage.bodies[ref.owner].outlines[0].radius is not None


def wrapped(ref: PointRef, side: int, start: Point, end: Point, stage: PlaneStage, sheet: ScenePaper) -> None:
    """The part of a string on a rim: clockwise where the running string turns the wheel so."""
    if not side or ref.owner not in stage.bodies:
        return
    centre = sheet.at(stage.bodies[ref.owner].spot(stage.model.spot(ref)))
    first, last = (math.atan2(y - centre[1], x - centre[0]) for x, y in (start, end))
    turn = (first - last) % (2 * math.pi) if side > 0 else (last - first) % (2 * math.pi)
    if turn < 2 * math.pi - 1e-6:
        sheet.figure.line(
            arc_points(centre, math.dist(centre, start), first, first - turn if side > 0 else first + turn), STRING
        )


def draw_post(ref: PointRef, start: Point, end: Point, stage: PlaneStage, sheet: ScenePaper) -> None:
    """A post with the rope on it, all the way round where its strands go on in one line; and what the post is called."""
    centre, turn = sheet.at(stage.middle(stage.post(ref.owner))), turn_round(ref.owner, stage.kinds, stage.model)
    for role in (GROUND, SURFACE):
        sheet.figure.circle(centre, sheet.scale * stage.post_radius, role)
    first, last = (math.atan2(y - centre[1], x - centre[0]) for x, y in (start, end))
    way = turn * ((turn * (last - first) - 1e-6) % (2 * math.pi) + 1e-6)
    sheet.figure.line(arc_points(centre, math.dist(centre, start), first, first + way), STRING)
    sheet.letters.name(prose(spoken(ref.owner)), centre, inside=True, tag=ref.owner)


def brace(ref: PointRef, stage: PlaneStage, sheet: ScenePaper) -> None:
    """What holds the axle of a wheel on which strings run: a strut against their pull, to the ground that is near or to a ceiling."""
    name = ref.owner
    if name not in stage.model.held or name in stage.braced or not stage.model.turns(name):
        return
    stage.braced.add(name)
    centre = sheet.at(stage.bodies[name].spot(stage.model.axis(name)))
    pull = string_pull(name, stage)
    radius = sheet.scale * stage.bodies[name].reach((1.0, 0.0))
    near = [point for point in stage.drawn_ground if math.dist(point, centre) < 1.9 * radius + 12.0]
    if near and abs(pull[0]) > 0.2:
        edge = min(near, key=lambda point: math.dist(point, centre))
        sheet.figure.line(widen(centre, edge), SUPPORT, closed=True)
    else:
        away = (0.0, 1.0) if pull[1] <= 0.1 else (0.0, -1.0)
        if abs(pull[1]) < 0.2 and abs(pull[0]) > 0.5:
            away = (-math.copysign(1.0, pull[0]), 0.0)
        end = shifted_by(centre, away, radius + STRUT)
        sheet.figure.line(widen(centre, end), SUPPORT, closed=True)
        sheet.patch(end, (-away[0], -away[1]), 32.0)
    sheet.hub(centre)


def string_pull(name: str, stage: PlaneStage) -> Point:
    """The direction into which the legs of all strings at a wheel go on the whole."""
    pull = (0.0, 0.0)
    for _, _, leg in stage.legs():
        if leg.along is not None:
            pull = shifted_by(pull, leg.along, (leg.first.owner == name) - (leg.second.owner == name))
    for item in stage.kinds.ropes:
        if item.drapes[1].owner == name:
            pull = shifted_by(pull, (0.0, -1.0))
    return pull


def widen(start: Point, end: Point, half: float = 1.9) -> list[Point]:
    side = quarter(unit_of((end[0] - start[0], end[1] - start[1])))
    return [
        shifted_by(start, side, half),
        shifted_by(end, side, half),
        shifted_by(end, side, -half),
        shifted_by(start, side, -half),
    ]


def draw_spring(item: Spring, stage: PlaneStage, sheet: ScenePaper) -> None:
    """A coil between its ends, with its stiffness."""
    places = [None if (place := spring_place(ref, stage)) is None else sheet.at(place) for ref in item.spring]
    way = spring_way(item, stage.model) if None in places else (1.0, 0.0)
    first, second = places
    back = (-way[0], -way[1])
    if first is None and second is not None:
        second = edge_of(item.spring[1], second, back, stage, sheet)
        first = spring_end(item, item.spring[0], second, back, stage, sheet)
    elif second is None and first is not None:
        first = edge_of(item.spring[0], first, way, stage, sheet)
        second = spring_end(item, item.spring[1], first, way, stage, sheet)
    elif first is not None and second is not None:
        along = unit_of((second[0] - first[0], second[1] - first[1]))
        first = edge_of(item.spring[0], first, along, stage, sheet)
        second = edge_of(item.spring[1], second, (-along[0], -along[1]), stage, sheet)
    if first is None or second is None:
        return
    sheet.figure.line(coil(first, second), STRING)
    for ref, end, other in ((item.spring[0], first, second), (item.spring[1], second, first)):
        if ref.owner not in stage.bodies and ref.owner not in stage.surfaces:
            sheet.patch(end, unit_of((other[0] - end[0], other[1] - end[1])))
    words = told_words(stage, item.stiffness)
    if words is not None:
        along = unit_of((second[0] - first[0], second[1] - first[1]))
        middle = ((first[0] + second[0]) / 2, (first[1] + second[1]) / 2)
        side = quarter(along)
        sheet.letters.name(words, middle, side if side[1] > -0.1 else (-side[0], -side[1]), COIL + 3.0)


def spring_end(item: Spring, ref: PointRef, at: Point, way: Point, stage: PlaneStage, sheet: ScenePaper) -> Point:
    """Where a spring to something that is fixed anywhere ends; once for all pictures of a motion."""
    long = LOOSE + 20.0 + stage.longer.get(item.name, 0.0) * sheet.scale
    if ref.owner in stage.surfaces:
        return stage.kept(item.name, lambda: shifted_by(at, way, free_length(item.name, ref, at, way, stage, sheet)))
    return stage.kept(item.name, lambda: shifted_by(at, way, long))


def spring_place(ref: PointRef, stage: PlaneStage) -> Point | None:
    if ref.owner in stage.bodies:
        return stage.bodies[ref.owner].spot(stage.model.tied(ref))
    return stage.point(ref)


def edge_of(ref: PointRef, at: Point, way: Point, stage: PlaneStage, sheet: ScenePaper) -> Point:
    """Where a spring meets the outside of a block."""
    body = stage.bodies.get(ref.owner)
    return shifted_by(at, way, sheet.scale * edge_along(body, way)) if body is not None and body.block else at


def coil(first: Point, second: Point) -> list[Point]:
    """A zigzag between two points, straight at both ends."""
    along = unit_of((second[0] - first[0], second[1] - first[1]))
    side, long = quarter(along), math.dist(first, second)
    lead = min(8.0, 0.15 * long)
    step = (long - 2 * lead) / (2 * COILS)
    middle = [
        shifted_by(shifted_by(first, along, lead + step * (k + 0.5)), side, COIL if k % 2 else -COIL)
        for k in range(2 * COILS)
    ]
    return [first, shifted_by(first, along, lead), *middle, shifted_by(second, along, -lead), second]


def draw_belt(item: Belt, stage: PlaneStage, sheet: ScenePaper) -> None:
    """The outer tangents of neighbouring wheels, the inner ones where it is crossed, and what lies on the rims."""
    for first, second in zip(item.belt, item.belt[1:], strict=False):
        centres = [sheet.at(stage.bodies[ref.owner].spot(stage.model.spot(ref))) for ref in (first, second)]
        radii = [
            (radius_of(stage.model.body(ref.owner), ref.point, stage.value) or 0.0) * sheet.scale
            for ref in (first, second)
        ]
        for side in (1.0, -1.0):
            sheet.figure.line(tangent(centres, radii, side, item.crossed), STRING)
        for centre in centres:
            sheet.hub(centre)


def tangent(centres: Sequence[Point], radii: Sequence[float], side: float, crossed: bool) -> list[Point]:
    """A common tangent of two circles, on one side of the line between their centres."""
    (ax, ay), (bx, by) = centres
    gap, base = math.dist(*centres), math.atan2(by - ay, bx - ax)
    share = (radii[0] + radii[1] if crossed else radii[0] - radii[1]) / gap
    angle = base + side * math.acos(max(-1.0, min(1.0, share)))
    other = ray(angle + math.pi if crossed else angle, radii[1])
    return [shifted_by(centres[0], ray(angle, radii[0])), shifted_by(centres[1], other)]


def draw_rope(item: Drapes, stage: PlaneStage, sheet: ScenePaper) -> None:
    """A heavy rope where it hangs: over a wheel, a peg or an edge, or down from the drum on which it is wound."""
    rope, over, *tied = item.drapes
    right = -1.0 if stage.model.body(rope.owner).moves == "left" else 1.0
    hanging = rope_lengths(item, stage)
    shrunk = stage.kept(("shrunk", item.name), lambda: min(1.0, LONGEST / max(max(hanging) * sheet.scale, 1e-9)))
    long = [max(12.0, size * sheet.scale * shrunk) for size in hanging]
    if over.owner in stage.bodies:
        centre = sheet.at(stage.bodies[over.owner].place)
        radius = (radius_of(stage.model.body(over.owner), over.point, stage.value) or 0.0) * sheet.scale + 1.5
        stage.braced.discard(over.owner)
        brace(over, stage, sheet)
    else:
        centre, radius = (0.0, 0.0), 5.0
    front = (centre[0] + right * radius, centre[1])
    ends = [(front[0], front[1] - long[0])]
    if over.owner in stage.surfaces or over.owner in stage.model.surfaces:
        table = stage.kept(("table", item.name), lambda: long[1])
        down = lying_rope(front, right, long, table, sheet)
        name_rope(item, (down[0], down[1] + long[0]), down, right, stage, sheet)
        return
    if over.owner not in stage.bodies:
        sheet.figure.circle(centre, radius - 1.5, SUPPORT)
    back = (centre[0] - right * radius, centre[1])
    around = arc_points(centre, radius, 0.0 if right > 0 else math.pi, math.pi if right > 0 else 0.0)
    points = [ends[0], *around, (back[0], back[1] - long[1])] if not item.wound else [ends[0], *around]
    sheet.figure.line(points, THICK)
    name_rope(item, front, ends[0], right, stage, sheet)
    for ref in tied:
        body = stage.bodies[ref.owner]
        low = (ends[0][0] / sheet.scale, ends[0][1] / sheet.scale)
        body.place = shifted_by(low, (0.0, -body.reach((0.0, 1.0))))


def lying_rope(front: Point, right: float, long: Sequence[float], table: float, sheet: ScenePaper) -> Point:
    """A rope that lies on a table, so long, and hangs over its edge; its lower end."""
    edge = (front[0] - right * 5.0, front[1])
    top = [(edge[0] - right * (table + 22.0), edge[1]), edge, (edge[0], edge[1] - 34.0)]
    sheet.hatched(top if right > 0 else top[::-1])
    bend = [
        shifted_by((edge[0], edge[1] - 2.0), ray(a if right > 0 else math.pi - a, 4.5))
        for a in (1.57, 1.2, 0.8, 0.4, 0.0)
    ]
    down = (bend[-1][0], bend[-1][1] - long[0])
    sheet.figure.line([(edge[0] - right * long[1], edge[1] + 2.5), *bend, down], THICK)
    return down


def name_rope(item: Drapes, top: Point, end: Point, right: float, stage: PlaneStage, sheet: ScenePaper) -> None:
    """The letter of a rope beside it, and how much of it hangs where the state tells that."""
    body = stage.model.body(item.drapes[0].owner)
    middle = ((top[0] + end[0]) / 2, (top[1] + end[1]) / 2)
    for line in stage.model.acting.state.conditions:
        path = line.path
        if path is not None and path.owner == item.name and path.quantity == "length":
            words = told_words(stage, line.value)
            if words is not None and math.dist(top, end) > 10.0:
                sheet.dimension(top, end, words, right * HUNG)
    sheet.letters.name(named_in(body, stage.model.problem), middle, (-right, 0.0), 5.0)


def rope_lengths(item: Drapes, stage: PlaneStage) -> list[float]:
    """How much of a rope hangs in front, and how much is behind."""
    shape = stage.model.body(item.drapes[0].owner).shape
    whole = stage.value(shape.length) if shape is not None and getattr(shape, "length", None) is not None else ROPE
    front = 0.6 * whole
    for line in stage.model.acting.state.conditions:
        path = line.path
        if path is not None and path.owner == item.name and path.quantity == "length" and line.value is not None:
            front = stage.value(line.value)
    front = stage.hanging.get(item.name, front)
    return [front, max(whole - front, 0.0)]
