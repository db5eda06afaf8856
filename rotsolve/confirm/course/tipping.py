"""Tipping: whether what stands with two corners on something level stays on both: where the force from below would have to act."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.confirm.course.node import Astray, Node
from rotsolve.confirm.model import Model
from rotsolve.confirm.signs import rests, surface_of
from rotsolve.elements.connections.touch import Touch
from rotsolve.elements.shapes import shape_of
from rotsolve.elements.surfaces import Level
from rotsolve.language.bodies import PointRef


class Stand(Struct, frozen=True):
    """A contact on which a body with corners stands, and its corners."""

    name: str
    body: str
    corners: tuple[PointRef, ...]


def all_stands(model: Model) -> list[Stand]:
    """What stands on something level by itself; what carries another body has that somewhere on its back."""
    touches = [item for item in model.acting.connections if isinstance(item, Touch)]
    carriers = {item.pair()[1].owner for item in touches}
    found = []
    for item in touches:
        name = item.lying()
        corners = [point for point in shape_of(model.body(name)).points if point.startswith("corner")]
        if corners and name not in carriers and rests(item, model) and isinstance(surface_of(item, model), Level):
            found.append(Stand(item.name, name, tuple(PointRef(name, point) for point in corners)))
    return found


def room_on_base(stand: Stand, at: Node) -> tuple[float, float] | None:
    """How far the force from below is from the nearer corner of the base, and how wide that is: x F_y − y F_x is its torque."""
    spots = [[part.value for part in at.model.place(corner, at.pose)] for corner in stand.corners]
    low, size = min(y for _, y in spots), max(abs(x - other) for x, _ in spots for other, _ in spots)
    base = [x for x, y in spots if y - low < 1e-9 * size]
    seat = at.model.seats[stand.body]
    x, y = (part.value for part in at.pose.place(stand.body, seat.rigid.centre))
    forces = [
        sum(load.get(seat.first + k, 0.0) for owner, _, load in at.loads if owner == stand.name) for k in range(3)
    ]
    if len(base) < 2 or forces[1] <= 0.0:
        return None
    where = x + (forces[2] + (low - y) * forces[0]) / forces[1]
    return min(where - min(base), max(base) - where), max(base) - min(base)


def check_standing(at: Node) -> None:
    """Astray where something would tip over."""
    for stand in all_stands(at.model):
        found = room_on_base(stand, at)
        if found is not None and found[0] < -1e-7 * found[1]:
            raise Astray(f"`{stand.body}` tips over: the force of `{stand.name}` would have to act beside its base")
