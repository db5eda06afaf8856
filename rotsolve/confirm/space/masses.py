"""Masses in space: how the mass of a body is spread, Σ m, Σ m r and Σ m r rᵀ, from which its centre and its inertia tensor follow.

I = (trace S) 1 − S with S = Σ m r rᵀ about the centre of mass; products of inertia are −Σ m x y.
"""

from __future__ import annotations

import math
from typing import Any

from msgspec import Struct

from rotsolve.algebra.formula import ONE, Formula, Symbol
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import Value, share_cut_out
from rotsolve.confirm.space.arrows import (
    ALONG,
    STILL,
    Arrow,
    Turned,
    X,
    Z,
    least_turn,
    less,
    normed,
    product_of,
    rotation_about,
    scaled,
    seen_from,
    sum_of,
    times_arrow,
)
from rotsolve.core.vectors.tensor import InertiaTensor
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import Body, Part, Turn

MADE_UP = "share across its axis"  # of the moment about it, where a scene tells no more than that: what hangs on it has no number
ACROSS = 0.6180339887  # this share, unless numbers say another one


class Matter(Struct, frozen=True):
    """Σ m, Σ m r and Σ m r rᵀ about the origin of the body's axes: what adds up over pieces."""

    whole: float
    first: Arrow
    second: Turned

    def plus(self, other: Matter, sign: float = 1.0) -> Matter:
        second = tuple(sum_of(a, scaled(sign, b)) for a, b in zip(self.second, other.second, strict=True))
        first = sum_of(self.first, scaled(sign, other.first))
        return Matter(self.whole + sign * other.whole, first, second)  # type: ignore[arg-type]

    def placed(self, turn: Turned, place: Arrow) -> Matter:
        """Turned about the origin, and then moved by a vector."""
        first, own = times_arrow(turn, self.first), seen_from(turn, self.second)
        rows = [
            sum_of(own[k], scaled(first[k], place), scaled(place[k], first), scaled(self.whole * place[k], place))
            for k in range(3)
        ]
        return Matter(self.whole, sum_of(first, scaled(self.whole, place)), (rows[0], rows[1], rows[2]))


NO_MATTER = Matter(0.0, STILL, (STILL, STILL, STILL))


class Solid(Struct, frozen=True):
    """A body as the assembly in space knows it: mass, centre of mass and tensor about that, in its own axes from its centre.

    `whole` is whether the scene tells all of the tensor, not only the moment about one axis.
    """

    body: Body
    mass: float
    centre: Arrow
    tensor: Turned
    whole: bool


def solid_of(body: Body, value: Value) -> Solid:
    """Mass, centre of mass and inertia tensor about that."""
    if body.tensor is not None:
        mass, about = mass_told(body, value), told_about(body, value)
        shift = about_point(mass, about)
        return Solid(body, mass, STILL, difference(matrix(body.tensor, value), shift), True)
    matter = spread_of(body, value)
    if matter.whole <= 0.0:
        return Solid(body, 0.0, STILL, (STILL, STILL, STILL), True)
    centre = scaled(1.0 / matter.whole, matter.first)
    central = Matter(matter.whole, STILL, difference(matter.second, outer(matter.whole, centre)))
    return Solid(body, matter.whole, centre, tensor_of(central.second), body.inertia is None and body.gyration is None)


def told_about(body: Body, value: Value) -> Arrow:
    """The point about which the scene tells a body's inertia."""
    return STILL if body.inertia_about in (None, "cm", "center") else spot_in_body(body, body.inertia_about, value)


def mass_told(body: Body, value: Value) -> float:
    if body.mass is None:
        raise NotConfirmed(f"the mass of `{body.name}` has no number")
    return value(body.mass)


def spread_of(body: Body, value: Value) -> Matter:
    """Of the body's own shape, its parts, less its holes."""
    if body.count > 1:
        raise NotConfirmed("how identical bodies stand in space")
    total = of_shape(body, value)
    for part in body.parts:
        total = total.plus(spread_of_part(part, value).placed(*placing_of(part, value)))
    for hole in body.holes:
        total = total.plus(cut_out(hole, body, value), -1.0)
    return total


def spread_of_part(part: Part, value: Value) -> Matter:
    """Of a part; a rod is as long as its ends are apart, whatever length it has been given: M d²/12, and M = λ d."""
    body = part.body
    if part.start is None or part.end is None or body.shape is None or body.shape.graded:
        return spread_of(body, value)
    length = math.dist(three_of(part.start, value), three_of(part.end, value))
    mass = mass_told(body, value) if body.density is None else value(body.density) * length
    if body.inertia is not None or body.gyration is not None:
        return Matter(mass, STILL, second_of(of_one_moment(body, mass, value)))
    across = mass * length**2 / 12
    return Matter(mass, STILL, second_of(((0.0, 0.0, 0.0), (0.0, across, 0.0), (0.0, 0.0, across))))


def of_shape(body: Body, value: Value) -> Matter:
    """Of the body's shape, without parts and holes."""
    if body.mass is None and body.parts and body.shape is None:
        return NO_MATTER
    mass = mass_told(body, value)
    if body.holes and body.shape is not None:
        mass /= 1.0 - sum(share_cut_out(hole, body, value) for hole in body.holes)
    if not mass:
        return NO_MATTER
    shape = shape_of(body)
    if body.tensor is not None:
        raise NotConfirmed("a tensor that is told of a part")
    if body.inertia is not None or body.gyration is not None:
        tensor = of_one_moment(body, mass, value)
    else:
        tensor = matrix(shape.tensor(ONE), value, mass)
    x, y = (value(item) for item in shape.centroid())
    centre = (x, y, value(shape.rise()))
    return Matter(mass, STILL, second_of(tensor)).placed(ALONG, centre)


def of_one_moment(body: Body, mass: float, value: Value) -> Turned:
    """The tensor about the centre of mass where only the moment about the body's axis is told: what is across it is made up."""
    axial = mass * value(body.gyration) ** 2 if body.gyration is not None else value(body.inertia or ONE)
    axis = axis_told(body, value) or Z
    about = told_about(body, value)
    off = less(about, scaled(sum(a * b for a, b in zip(about, axis, strict=True)), axis))
    axial -= mass * sum(part * part for part in off)
    across = axial * share_across(value)
    rows = [sum_of(scaled(across, ALONG[k]), scaled((axial - across) * axis[k], axis)) for k in range(3)]
    return (rows[0], rows[1], rows[2])


def share_across(value: Value) -> float:
    """What is made up for the moment across an axis, as a share of that about it."""
    try:
        return value(Symbol(MADE_UP))
    except NotConfirmed:
        return ACROSS


def axis_told(body: Body, value: Value) -> Arrow | None:
    """The symmetry axis that the scene gives a body."""
    if not body.axis:
        return None
    x, y, z = (value(part) for part in body.axis)
    return normed((x, y, z))


def cut_out(hole: Part, body: Body, value: Value) -> Matter:
    """What is cut out: the material that the hole would hold, where its mass is not given."""
    turn, place = placing_of(hole, value)
    if hole.body.mass is not None or body.mass is None:
        return spread_of_part(hole, value).placed(turn, place)
    shape, cut = shape_of(body), shape_of(hole.body)
    if cut.flat and not shape.flat:
        raise NotConfirmed("how deep a hole is")
    shares = [share_cut_out(other, body, value) for other in body.holes]
    mass = value(body.mass) * share_cut_out(hole, body, value) / (1.0 - sum(shares))
    tensor = matrix(cut.tensor(ONE), value, mass)
    x, y = (value(item) for item in cut.centroid())
    return Matter(mass, STILL, second_of(tensor)).placed(ALONG, (x, y, value(cut.rise()))).placed(turn, place)


def placing_of(part: Part, value: Value) -> tuple[Turned, Arrow]:
    """How a part is turned in the axes of the whole, and where its centre is."""
    turn = turned_together(part.turned, value)
    if part.angle is not None:
        turn = product_of(turn, rotation_about(Z, value(part.angle)))
    if part.start is not None and part.end is not None:
        start, end = (three_of(item, value) for item in (part.start, part.end))
        return product_of(turn, least_turn(X, normed(less(end, start)))), scaled(0.5, sum_of(start, end))
    reach = part.body.shape.reach() if part.start is not None and part.body.shape is not None else None
    if part.start is not None and reach is not None:
        return turn, sum_of(three_of(part.start, value), times_arrow(turn, (value(reach) / 2, 0.0, 0.0)))
    return turn, STILL if part.at is None else three_of(part.at, value)


def turned_together(turns: tuple[Turn, ...], value: Value) -> Turned:
    """The rotation that several come to, one after the other about axes that stay."""
    rows = ALONG
    for item in turns:
        x, y, z = (value(part) for part in item.about)
        rows = product_of(rotation_about((x, y, z), value(item.by)), rows)
    return rows


def three_of(at: tuple[Any, ...], value: Value) -> Arrow:
    x, y, *rest = (value(item) for item in at)
    return (x, y, rest[0] if rest else 0.0)


def spot_in_body(body: Body, point: str | None, value: Value, argument: Formula | None = None) -> Arrow:
    """Where a point is in the body's axes, from its centre."""
    if point in (None, "center"):
        return STILL
    if point == "cm":
        return solid_of(body, value).centre
    for name, at in body.points:
        if name == point:
            return three_of(at, value)
    for part in body.parts:
        if part.body.name == point:
            return placing_of(part, value)[1]
    shape = shape_of(body)
    if shape.round and argument is None:
        raise NotConfirmed(f"where `{body.name}.{point}` is in space")
    x, y = shape.locate(point, argument)
    return (value(x), value(y), value(shape.rise(point)))


# matrices


def matrix(tensor: InertiaTensor, value: Value, mass: float = 1.0) -> Turned:
    """The rows of a tensor, or of one of a unit of mass."""
    xx, yy, zz, xy, yz, zx = (mass * value(tensor.entry(name)) for name in ("xx", "yy", "zz", "xy", "yz", "zx"))
    return ((xx, xy, zx), (xy, yy, yz), (zx, yz, zz))


def scaled_rows(factor: float, rows: Turned) -> Turned:
    return (scaled(factor, rows[0]), scaled(factor, rows[1]), scaled(factor, rows[2]))


def difference(one: Turned, other: Turned) -> Turned:
    return (less(one[0], other[0]), less(one[1], other[1]), less(one[2], other[2]))


def total_rows(one: Turned, other: Turned) -> Turned:
    return (sum_of(one[0], other[0]), sum_of(one[1], other[1]), sum_of(one[2], other[2]))


def outer(mass: float, d: Arrow) -> Turned:
    """m d dᵀ."""
    return (scaled(mass * d[0], d), scaled(mass * d[1], d), scaled(mass * d[2], d))


def tensor_of(second: Turned) -> Turned:
    """(trace S) 1 − S."""
    trace = second[0][0] + second[1][1] + second[2][2]
    return difference(scaled_rows(trace, ALONG), second)


def second_of(tensor: Turned) -> Turned:
    """½ (trace I) 1 − I, the other way round."""
    trace = tensor[0][0] + tensor[1][1] + tensor[2][2]
    return difference(scaled_rows(trace / 2, ALONG), tensor)


def about_point(mass: float, d: Arrow) -> Turned:
    """M (d² 1 − d dᵀ): what a tensor grows by from the centre of mass to a point."""
    return tensor_of(outer(mass, d))


def is_symmetric(tensor: Turned, centre: Arrow, way: int) -> bool:
    """Whether a tensor is the same about all directions across one of its own axes, and the centre of mass lies on that."""
    i, j = (way + 1) % 3, (way + 2) % 3
    size = max(abs(part) for row in tensor for part in row) or 1.0
    gaps = (tensor[i][i] - tensor[j][j], tensor[0][1], tensor[1][2], tensor[2][0])
    beside = math.hypot(centre[i], centre[j])
    return all(abs(gap) <= 1e-9 * size for gap in gaps) and beside <= 1e-9 * (1.0 + abs(centre[way]))
