"""Faces: what rubs over a whole face, by a sum of its own over pieces: of what lies on a table, and of what is pressed together."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import Spot, part_of, radius_of
from rotsolve.confirm.constraints import Held
from rotsolve.confirm.jet import merged
from rotsolve.confirm.pose import Pose, load
from rotsolve.confirm.rows import Grip, Row, held
from rotsolve.confirm.strings import end_along
from rotsolve.elements.shapes import shape_of
from rotsolve.elements.shapes.round import Ring
from rotsolve.language.bodies import PointRef

if TYPE_CHECKING:
    from rotsolve.confirm.known import Known
    from rotsolve.elements.connections.flat import Laid
    from rotsolve.elements.connections.rubbing import Clutch
    from rotsolve.elements.connections.strings import String

FAR_ROUND = 10.0  # μ φ beyond which T₂/T₁ = e^(−μ φ) is lost beside 1
ROUND, RINGS = 12, 8  # pieces into which a ring is cut; rings of a face that is pressed

Weighed = tuple[Spot, float]


def laid(item: Laid, pose: Pose, model: Known) -> Held:
    """Friction on each piece, square to its arm from the axis: all of it is one grip, as large as the weight allows."""
    name = item.contact[0].owner
    body, seat = model.body(name), model.seats[name]
    if model.problem.gravity is None:
        raise NotConfirmed(f"nothing presses `{name}` on what it lies on")
    carrier = next((other for other in model.joined_to(name) if other in model.held), name)
    u, w = pose.place(carrier, model.axis(carrier))
    if item.spins:  # in place: how its centre is pushed then is told by the pieces
        yield from (Row(item.name, axis, place.slope, 0.0, None, {}) for axis, place in (("x", u), ("y", w)))
    column: dict[int, float] = {}
    for spot, share in weighed_pieces(item, model):
        x, y = pose.place(name, spot)
        away = math.hypot(x.value - u.value, y.value - w.value)
        if away > 0.0:
            way = -(y.value - w.value) / away, (x.value - u.value) / away
            column = merged(column, 1.0, load((x, y), way), share)
    weight = seat.rigid.mass * model.value(model.problem.gravity)
    static, kinetic = (
        weight * model.value(size) if size is not None else 0.0
        for size in (item.friction.static, item.friction.kinetic)
    )
    if body.count > 1:
        raise NotConfirmed(f"where each of `{name}` lies")
    row = held(item.name, "torque", pose.turn(carrier), pose)
    yield Grip(f"{item.name}.{carrier}", replace(row, column=column), static, kinetic)


def weighed_pieces(item: Laid, model: Known) -> Iterator[Weighed]:
    """Pieces of what lies on a table, in its own axes, with their shares of its mass."""
    name = item.contact[0].owner
    body, shape = model.body(name), shape_of(model.body(name))
    if shape.pointlike:
        yield model.seats[name].rigid.centre, 1.0
    elif shape.slender:
        yield from of_line(item, model)
    else:
        outer = radius_of(body, None, model.value)
        if outer is None or not (shape.face() is not None):
            raise NotConfirmed(f"how `{name}` is spread over what it lies on")
        walls = dict(getattr(shape, "radii", ()))
        thin = isinstance(shape, Ring) and not walls
        yield from of_rings(outer if thin else model.value(walls["inner"]) if walls else 0.0, outer)


def of_line(item: Laid, model: Known) -> Iterator[Weighed]:
    """Pieces of a rod, cut at its axis too, so that each of its two sides is summed up exactly."""
    name = item.contact[0].owner
    reach = shape_of(model.body(name)).reach()
    half = model.value(reach) / 2 if reach is not None else 0.0
    axis = model.axis(name)[0]
    edges = [-half, axis, half] if -half < axis < half else [-half, half]
    for low, high in pairwise(edges):
        yield ((low + high) / 2, 0.0), (high - low) / (2 * half)


def of_rings(inner: float, outer: float) -> Iterator[Weighed]:
    """Pieces of rings round the middle, by the two points of Gauss's rule, exact for what goes as r²; a thin ring is one."""
    width = (outer - inner) / 2
    if width <= 0.0:
        yield from pieces_round(outer, 1.0)
        return
    for side in (-1.0, 1.0):
        r = inner + width * (1.0 + side / math.sqrt(3.0))
        yield from pieces_round(r, 2.0 * r * width / (outer**2 - inner**2))


def pieces_round(r: float, share: float) -> Iterator[Weighed]:
    """A ring cut into equal pieces."""
    for k in range(ROUND):
        angle = 2.0 * math.pi * k / ROUND
        yield (r * math.cos(angle), r * math.sin(angle)), share / ROUND


def plates(item: Clutch, model: Known) -> float:
    """The torque of plates: over their own face where it is told, else over what both of them have."""
    if item.radii or item.radius is not None:
        return collar(item, model)
    edges = [face_of_plate(ref, model) for ref in item.clutch]
    return torque_of_rings(item, max(edges[0][0], edges[1][0]), edges[0][1], model)


def collar(item: Any, model: Known) -> float:
    """The torque of a face of which the radii are told."""
    if item.radius is not None:
        return torque_of_rings(item, 0.0, model.value(item.radius), model)
    walls = {word: model.value(size) for word, size in item.radii}
    return torque_of_rings(item, walls["inner"], walls["outer"], model)


def torque_of_rings(item: Any, inner: float, outer: float, model: Known) -> float:
    """Σ μ r ΔN over rings, by the two points of Gauss's rule on each of many: the pressure tells how the force is shared among them.

    On a cone a ring of the force ΔF along the axis is pressed by ΔF/sin β.
    """
    if item.press is None or item.friction is None:
        raise NotConfirmed(f"nothing tells how hard `{item.name}` is pressed")
    force = model.value(item.press) / (math.sin(model.value(item.cone)) if item.cone is not None else 1.0)
    if outer - inner < 1e-12 * outer:
        return model.value(item.friction) * force * outer
    width, arms, shares = (outer - inner) / RINGS, 0.0, 0.0
    for k in range(RINGS):
        for side in (-1.0, 1.0):
            r = inner + width * (k + 0.5 + side / math.sqrt(12.0))
            share = r * (1.0 / r if item.uniform == "wear" else 1.0)  # the pressure, times the ring's circumference
            arms, shares = arms + share * r, shares + share
    return model.value(item.friction) * force * arms / shares


def face_of_plate(ref: PointRef, model: Known) -> tuple[float, float]:
    """Inner and outer edge of the face of a plate."""
    body = model.body(ref.owner)
    part = part_of(body, ref.point)
    body, point = (body, ref.point) if part is None else (part.body, None)
    outer = radius_of(body, point, model.value) or 0.0
    walls = dict(getattr(body.shape, "radii", ()))
    thin = isinstance(body.shape, Ring) and not walls
    return (outer if thin else model.value(walls["inner"]) if "inner" in walls else 0.0), outer


def rope_on_post(item: String, pose: Pose, model: Known) -> Held:
    """A rope round a post: with T₁ = N + f and T₂ = N − f it slips at f = N tanh(μ φ/2), where T₁/T₂ = e^(μ φ).

    N keeps both parts of one length in all; f, which sticks or slips, keeps each as it is.
    """
    if item.friction is None or item.wrap is None:
        raise NotConfirmed(f"nothing tells how `{item.name}` runs round its post")
    before, after = model.legs(item)
    if before.along is None or after.along is None:
        raise NotConfirmed(f"`{item.name}` runs from a place")
    one = end_along(before.first, before.sides[0], before.along, pose, model) * -1.0
    two = end_along(after.second, after.sides[1], after.along, pose, model)
    around = model.value(item.friction) * model.value(item.wrap)
    if around > FAR_ROUND:
        raise NotConfirmed(f"`{item.name}` holds more by its friction than numbers tell")
    limit = math.tanh(around / 2.0)
    yield held(item.name, "tension", one + two, pose, pull=True)
    yield Grip(item.name, held(item.name, "friction", two - one, pose), limit, limit, (item.name, "tension"))
