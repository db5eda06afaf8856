"""Sides: how what lies on a flat side of a body that travels slides along that side, as seen from the body."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from rotsolve.confirm.jet import Jet
from rotsolve.confirm.pose import Pair, Pose, Way, along
from rotsolve.confirm.signs import level_named, surface_of, taken_aside, travel
from rotsolve.elements.asked import is_curved, is_touch
from rotsolve.language.bodies import PointRef

if TYPE_CHECKING:
    from rotsolve.confirm.known import Known
    from rotsolve.elements.connections.touch import Touch


def on_side(name: str, model: Known) -> Touch | None:
    """The contact of that name, where it lays a body on a flat side that goes another way than along itself."""
    item = next((item for item in model.acting.connections if item.name == name), None)
    if not is_touch(item) or item.side is None or is_curved(item.side):
        return None
    return item if taken_aside(item, item.side, model) else None


def from_middle(item: Touch, pose: Pose, model: Known) -> Pair:
    """Where a body on a curved surface is from the middle of that: the origin, the centre of mass of the body whose side it is, or the
    centre of the round body on which it lies."""
    x, y = pose.place(item.lying(), (0.0, 0.0))
    under = item.pair()[1].owner
    if under not in model.seats:
        return x, y
    spot = model.seats[under].rigid.centre if item.side is not None else model.spot(PointRef(under))
    u, w = pose.place(under, spot)
    return x - u, y - w


def on_round_side(name: str, model: Known) -> Touch | None:
    """The contact of that name, where it lays a body on a round side of another one."""
    item = next((item for item in model.acting.connections if item.name == name), None)
    return item if is_touch(item) and is_curved(item.side) else None


def way_round(item: Touch, pose: Pose, model: Known) -> Way:
    """The way along a round side that counts as positive where a body is: to the right over the top, or through the lowest place."""
    x, y = (part.value for part in from_middle(item, pose, model))
    size = math.hypot(x, y) or 1.0
    outside = is_curved(item.side) and item.side.outside
    return (y / size, -x / size) if outside else (-y / size, x / size)


def gone_down(item: Touch, pose: Pose, model: Known, *, gone: bool = False) -> Jet:
    """How far down the side a body is from the centre of mass of what it lies on, but for a constant; how far it has `gone` that way."""
    own, under = item.lying(), item.pair()[1].owner
    spots = ((own, model.travelling(own)), (under, model.seats[under].rigid.centre))
    (x, y), (u, w) = ((pose.moved if gone else pose.place)(name, spot) for name, spot in spots)
    return along((x - u, y - w), travel(surface_of(item, model) or level_named(under), "down", model))
