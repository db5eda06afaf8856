"""Contacts: how what lies on something lies there: on a level or slope, round a curve, on another body, or only later."""

from __future__ import annotations

import math

from rotsolve.confirm.bodies import on_rim, part_of
from rotsolve.confirm.pose import turned
from rotsolve.confirm.signs import normal, rests, surface_of
from rotsolve.draw.paper.figure import Point
from rotsolve.draw.plane.places.equations import Affine, Place, gap_between_places, part_along, place_off
from rotsolve.draw.plane.places.kinds import by_kind, curve_radius, edge_height
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.elements.connections.touch import Touch
from rotsolve.language.bodies import PointRef, Surface

FAINT = 0.1  # of a wish beside others
ASIDE = 0.15  # of the opening of a round side, by which its middle is drawn beside where it touches
AHEAD, BELOW = (
    2.0,
    1.3,
)  # of what a body will touch: how far an edge is on its way, how low a level is, in its half size
SPREAD, APART = (
    1.2,
    1.3,
)  # of rollers under a plank: how far the outer ones are apart, in its half length, and at least, in their radii
ONWARD, LOWER = 2.6, 0.6  # of a loop from where a track begins, in its radius


def lay(item: Touch, stage: PlaneStage) -> None:
    """A body on what it touches."""
    ref, under = item.pair()[:2]
    surface = surface_of(item, stage.model)
    if item.leaning:
        from rotsolve.draw.plane.places.leaned import lay_leaned

        lay_leaned(item, stage)
    elif under.owner in stage.bodies and ref.owner in stage.model.held:
        stage.wheels.append((ref, under))
    elif surface is not None and surface.curved:
        lay_round(item, surface, stage)
    elif surface is not None:
        lay_flat(item, surface, stage)


def lay_flat(item: Touch, surface: Surface, stage: PlaneStage) -> None:
    """On a flat surface, whose level is one for all that lie on it; or on the back of a body."""
    ref, under = item.pair()[:2]
    out, wheel = normal(surface, stage.model), rolling_rim(item, stage)
    down, spot = wheel if wheel is not None else (0.0, stage.model.tied(ref))
    set_on_its_bow(item, out, stage)
    low = stage.place_of(ref.owner, spot)
    if wheel is None and rests(item, stage.model):
        down, low = stage.bodies[ref.owner].reach((-out[0], -out[1])), stage.origin(ref.owner)
    if under.owner in stage.bodies:
        back, gap = stage.bodies[under.owner].reach(out), gap_between_places(stage.origin(under.owner), low)
        stage.layout.equal(part_along(gap, out), back + down)
        stage.layout.equal(part_along(gap, turned(out)), beside_others(item, out, stage), FAINT)
        return
    stage.layout.equal(part_along(low, out).plus(level_of(surface, stage), -1.0), down)


def beside_others(item: Touch, out: Point, stage: PlaneStage) -> float:
    """How far from the middle of what lies on several bodies one of them is: rollers stand apart, from left to right as they are named."""
    ref, under = item.pair()[:2]
    below = [other.pair()[1].owner for other in stage.kinds.contacts if other.lying() == ref.owner]
    below = [owner for owner in below if owner in stage.bodies]
    ahead = turned(out, -1)
    wide = 2 * APART * stage.bodies[under.owner].reach(ahead)
    step = max(SPREAD * stage.bodies[ref.owner].reach(ahead) / max(len(below) - 1, 1), wide)
    return (below.index(under.owner) - (len(below) - 1) / 2) * step


def set_on_its_bow(item: Touch, out: Point, stage: PlaneStage) -> None:
    """What is round on one side only, and of which nothing tells how it stands, is turned so that it lies on that, a little aside."""
    body, rocks = stage.bodies[item.lying()], stage.model.rocking(item.lying(), item)
    down = math.atan2(-out[1], -out[0])
    if rocks is not None and rocks.spare(down - body.turn) < 0.0:
        body.turn = down - (rocks.first + rocks.last) / 2 - ASIDE * (rocks.last - rocks.first)


def level_of(surface: Surface, stage: PlaneStage) -> Affine:
    """How far out along its normal a flat surface is."""
    if surface.name not in stage.surfaces:
        stage.surfaces[surface.name] = (surface, stage.layout.unknown())
    level: Affine = stage.surfaces[surface.name][1]
    return level


def middle_unknown(surface: Surface, stage: PlaneStage) -> Place:
    """The middle of a curved surface."""
    if surface.name not in stage.surfaces:
        stage.surfaces[surface.name] = (surface, (stage.layout.unknown(), stage.layout.unknown()))
    middle: Place = stage.surfaces[surface.name][1]
    return middle


def rolling_rim(item: Touch, stage: PlaneStage) -> tuple[float, Point] | None:
    """The radius of what rolls, and its centre."""
    ref = item.pair()[0]
    body, radius = stage.model.body(ref.owner), stage.rim(ref)
    rocks = stage.model.rocking(ref.owner, item)
    if rocks is not None:
        return rocks.radius, stage.model.spot(ref if ref.point else PointRef(ref.owner))
    if not (on_rim(body, ref.point) or (ref.point in ("bottom", "center") and radius is not None)):
        return None
    part = ref.point if part_of(body, ref.point) else None
    return radius or 0.0, stage.model.spot(PointRef(ref.owner, part))


def lay_round(item: Touch, surface: Surface, stage: PlaneStage) -> None:
    """On a curved surface at the angle that the assembly tells; where its form is not known, at its beginning."""
    name, size = item.lying(), curve_radius(surface)
    under, body = item.pair()[1].owner, stage.bodies[item.lying()]
    carried = under in stage.bodies
    if carried and item.side is None:
        centre = stage.place_of(under, stage.model.spot(PointRef(under)))
    else:
        centre = stage.origin(under) if carried else middle_unknown(surface, stage)
    if size is None:
        stage.layout.meet(centre, stage.origin(name))
        lead_on(item, name, stage)
        return
    rim = rolling_rim(item, stage)
    radius = rim[0] if rim is not None else body.reach((0.0, -1.0)) if body.block else 0.0
    x, y = stage.drawn_at(name)
    u, w = stage.drawn_at(under) if carried else (0.0, 0.0)
    angle = math.atan2(y - w, x - u)
    outside = normal_sign(surface)
    circle = stage.value(size) + outside * radius
    stage.layout.meet(place_off(centre, (circle * math.cos(angle), circle * math.sin(angle))), stage.origin(name))
    if rim is None and body.block:
        body.turn = angle - outside * math.pi / 2
    height = edge_height(surface)
    if height is not None:
        set_foot(name, centre, stage.value(height), stage)


def normal_sign(surface: Surface) -> float:
    """+1 of a hill, on whose outside bodies lie, −1 of a bowl."""
    return 1.0 if getattr(surface, "outside", True) else -1.0


def lead_on(item: Touch, name: str, stage: PlaneStage) -> None:
    """A bowl or loop into which a track leads is further on and lower."""
    for ref in item.places():
        later = stage.model.surfaces.get(ref.owner)
        size = curve_radius(later) if later is not None else None
        if later is None or size is None:
            continue
        radius = stage.value(size)
        right = -1.0 if stage.bodies[name].body.moves == "left" else 1.0
        made = middle_unknown(later, stage)
        stage.layout.meet(place_off(stage.origin(name), (right * ONWARD * radius, -LOWER * radius)), made)
        stage.foot = (made, radius)


def set_foot(name: str, edge: Place, height: float, stage: PlaneStage) -> None:
    """The floor before an edge, where another contact of the body names it."""
    for other in stage.kinds.contacts:
        level = surface_of(other, stage.model) if other.lying() == name else None
        if level is not None and not level.curved:
            stage.layout.equal(edge[1].plus(level_of(level, stage), -1.0), height)


def lay_later(stage: PlaneStage) -> None:
    """What a body will touch only later: an edge ahead on its way, a level a little below it."""
    for item in by_kind(stage.model.problem.connections).contacts:
        if item in stage.kinds.contacts or item.lying() not in stage.bodies:
            continue
        body, origin = stage.bodies[item.lying()], stage.origin(item.lying())
        for ref in item.places():
            surface = stage.model.surfaces.get(ref.owner)
            if surface is None or surface.name in stage.surfaces:
                continue
            height = edge_height(surface)
            if height is not None:
                right = getattr(surface, "side", "right") == "right"
                ahead = (AHEAD if right else -AHEAD) * body.reach((1.0, 0.0))
                rise = stage.value(height) - body.reach((0.0, -1.0))
                stage.layout.meet(place_off(origin, (ahead, rise)), middle_unknown(surface, stage))
            elif surface.level:
                level = level_of(surface, stage)
                stage.layout.equal(level.plus(origin[1], -1.0), -BELOW * body.reach((0.0, -1.0)))
