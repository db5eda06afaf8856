"""Strings: what a string holds: its legs keep their length together, and it can only pull."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import radius_of
from rotsolve.confirm.constraints import Held, Rows, tied_at
from rotsolve.confirm.jet import Jet, distance
from rotsolve.confirm.pose import Pose, along
from rotsolve.confirm.rows import held
from rotsolve.elements.connections.strings import String
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Connection

if TYPE_CHECKING:
    from rotsolve.confirm.known import Known


def string(item: String, pose: Pose, model: Known) -> Held:
    """The ends of each leg move equally fast along it, a wheel's rim with it; it can only pull."""
    if item.friction is not None:
        from rotsolve.confirm.faces import rope_on_post

        yield from rope_on_post(item, pose, model)
        return
    for number, leg in enumerate(model.legs(item)):
        if leg.along is None:
            ends = [tied_at(ref, pose, model) for ref in (leg.first, leg.second)]
            if any(leg.sides):
                raise NotConfirmed(f"`{item.name}` runs from a place to a rim")
            length = distance(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1])
        else:
            length = Jet(0.0)
            for ref, side, sign in ((leg.first, leg.sides[0], -1.0), (leg.second, leg.sides[1], 1.0)):
                if ref.owner in model.seats:
                    length = length + end_along(ref, side, leg.along, pose, model) * sign
        yield held(item.name, f"tension{number}", length, pose, pull=True)


def end_along(ref: PointRef, side: int, way: tuple[float, float], pose: Pose, model: Known) -> Jet:
    """How far the end of a leg is along its direction: v · way of a rim is that of its centre and ∓ R ω."""
    if not side:
        return along(tied_at(ref, pose, model), way)
    radius = radius_of(model.body(ref.owner), ref.point, model.value) or 0.0
    return along(pose.place(ref.owner, model.spot(ref)), way) - pose.turn(ref.owner) * (side * radius)


STRINGS: dict[type[Connection], Rows] = {String: string}
