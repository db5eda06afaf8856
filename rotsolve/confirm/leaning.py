"""Leaning: a rod stays on an edge, or on something round: its line is as far from the middle of that as the radius, (C − O) · n = R."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.confirm.bodies import radius_of
from rotsolve.confirm.constraints import Held
from rotsolve.confirm.jet import Jet, cosine, sine
from rotsolve.confirm.pose import Pair, Pose, Way, along, turned
from rotsolve.confirm.rows import held
from rotsolve.confirm.touches import friction
from rotsolve.elements.connections.leaning import Leans
from rotsolve.elements.shapes import shape_of
from rotsolve.elements.surfaces import Corner
from rotsolve.language.bodies import PointRef

if TYPE_CHECKING:
    from rotsolve.confirm.known import Known


def leaning_rows(item: Leans, pose: Pose, model: Known) -> Held:
    """The line of a rod touches what it leans on, which pushes it away; friction acts along it, at the place where they touch."""
    own, under = item.contact
    turn, rigid = pose.turn(own.owner), model.seats[own.owner].rigid
    c, s = cosine(turn), sine(turn)
    side = pushed_side(item, c.value, s.value, pose, model)
    middle, radius = middle_of(item, (-s.value * side, c.value * side), pose, model)
    place = pose.place(own.owner, rigid.centre)
    x, y = place[0] - middle[0], place[1] - middle[1]
    yield held(item.name, "normal", (y * c - x * s) * side - radius, pose, hard=True, push=True)
    if own.point is not None:
        u, w = pose.place(own.owner, model.drawn(own))
        told = held(item.name, "along", (u - middle[0]) * c + (w - middle[1]) * s, pose, hard=True)
        yield replace(told, loose=True)
    feet = [
        (other.touches()[0], other.places()[0].owner)
        for other in model.acting.connections
        if other.lying() == own.owner
    ]
    for foot, floor in feet:
        low = floor_of(item, floor, middle, radius, pose, model)
        if low is not None and foot.point in ("start", "end"):
            stands = pose.place(foot.owner, model.drawn(foot))[1] - low
            yield replace(held(item.name, "height", stands, pose, hard=True), loose=True)
    ahead = (c.value * side, s.value * side)
    out = turned(ahead)
    reach = -(x.value * c.value + y.value * s.value)
    u, w = pose.place(own.owner, (rigid.centre[0] + reach, rigid.centre[1]))
    if radius and under.owner in model.seats:
        rim = pose.spatial(under.owner, model.spot(PointRef(under.owner)), (radius * out[0], radius * out[1]))
        middle = pose.place(under.owner, rim)
    yield from friction(item, along((u - middle[0], w - middle[1]), ahead), pose, model)


def middle_of(item: Leans, out: Way, pose: Pose, model: Known) -> tuple[Pair, float]:
    """An edge, or the centre of what is round, with its radius; what is fixed is at the origin, of several each further
    one where the rod touches it."""
    own, under = item.contact
    if under.owner not in model.seats:
        size = getattr(model.surfaces[under.owner], "radius", lambda: None)()
        radius = model.value(size) if size is not None else 0.0
        others = (
            other
            for other in model.acting.connections
            if isinstance(other, Leans) and other.contact[0].owner == own.owner
        )
        if own.point is None or next(others) is item:
            return (Jet(0.0), Jet(0.0)), radius
        x, y = pose.place(own.owner, model.drawn(own))
        return (Jet(x.value - radius * out[0]), Jet(y.value - radius * out[1])), radius
    if under.point is not None and under.point.startswith("corner"):
        return pose.place(under.owner, model.drawn(under)), 0.0
    radius = radius_of(model.body(under.owner), under.point, model.value) or 0.0
    return pose.place(under.owner, model.spot(PointRef(under.owner))), radius


def pushed_side(item: Leans, c: float, s: float, pose: Pose, model: Known) -> float:
    """+1 where the rod is pushed to the left of the way from its start to its end: away from the body behind an edge, else up."""
    under = item.contact[1]
    away = (0.0, 1.0)
    surface = model.surfaces.get(under.owner)
    if isinstance(surface, Corner):
        away = (-1.0 if surface.side == "right" else 1.0, 1.0)
    elif under.owner in model.seats and shape_of(model.body(under.owner)).points[1:2] == ("corner1",):
        (x, y), (u, w) = (
            pose.place(under.owner, spot) for spot in (model.drawn(under), model.seats[under.owner].rigid.centre)
        )
        away = x.value - u.value, y.value - w.value
    return -1.0 if away[1] * c - away[0] * s < 0.0 else 1.0


def floor_of(item: Leans, floor: str, middle: Pair, radius: float, pose: Pose, model: Known) -> Jet | None:
    """The height of the floor on which its foot and what it leans on stand; None where nothing tells it."""
    under = item.contact[1]
    if floor not in model.surfaces or not model.surfaces[floor].level:
        return None
    surface = model.surfaces.get(under.owner)
    if isinstance(surface, Corner) and surface.corner is not None:
        return middle[1] - model.value(surface.corner)
    beds = [other.places()[0].owner for other in model.acting.connections if other.lying() == under.owner]
    if under.owner not in model.seats or beds != [floor]:
        return None
    if radius:
        return middle[1] - radius
    turn = pose.turn(under.owner).value
    return pose.place(under.owner, model.drawn(PointRef(under.owner, "corner1")))[1] if math.sin(turn) == 0.0 else None
