"""Bodies on paper: what stands for each body, how it is turned, and how large what nobody gave a size is drawn."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from msgspec import Struct

from rotsolve.confirm.bodies import radius_of
from rotsolve.confirm.model import Model
from rotsolve.confirm.seating import turned_as_told
from rotsolve.confirm.signs import normal, rests, surface_of
from rotsolve.draw.paper.figure import Point, shifted_by
from rotsolve.draw.plane.places.kinds import ConnectionKinds, curve_radius
from rotsolve.draw.plane.places.outlines import WALL, BodyOutline, Value, body_outlines, box, disc, polygon, spun
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import Body
from rotsolve.language.elements import Connection

PLANK = 1.5, 0.12  # of what lies on several bodies: width for each of them, and height, in the largest size
BLOCK, CARRIER = (
    (1.0, 0.78),
    (3.6, 0.42),
)  # width and height of a block, and of one on which others lie, in its own measure
OF_WHEEL, OF_ALL = 1.45, 0.3  # of the radius of the smallest wheel with a string, of the largest thing
WHEEL, INNER = 0.5, 0.62  # radius of a wheel of which none is told; of one on the same axle as another
ROOM = 1.7  # of a block in the radius of what rolls down a wedge, by which that is drawn
PLATE = 28  # points of the outline of a body of no told form


class Figured(Struct):
    """A body as it is drawn: its outlines in its own axes, how far it is turned, and where its origin is."""

    name: str
    body: Body
    outlines: tuple[BodyOutline, ...]
    turn: float = 0.0
    place: Point = (0.0, 0.0)
    block: bool = False
    seen: bool = True

    def spot(self, spot: Point) -> Point:
        """Where a point of its own axes is."""
        return shifted_by(self.place, spun(spot, self.turn))

    def shown(self) -> Iterator[BodyOutline]:
        """Its outlines where it stands."""
        return (outline.turned(self.place, self.turn) for outline in self.outlines)

    def bound(self) -> list[Point]:
        """Points that bound it, where it stands."""
        return [point for outline in self.shown() for point in outline.around()]

    def reach(self, way: Point) -> float:
        """How far it goes along a direction from its origin."""
        arms = [spun(point, self.turn) for outline in self.outlines for point in outline.around()]
        return max((x * way[0] + y * way[1] for x, y in arms), default=0.0)

    @property
    def dot(self) -> bool:
        """Whether it is drawn as a point."""
        return all(outline.radius == 0.0 for outline in self.outlines)


class Measures(Struct, frozen=True):
    """Sizes of what nobody gave one: the largest thing of the scene, and the width of a block."""

    whole: float
    block: float


def scene_measures(model: Model, kinds: ConnectionKinds, value: Value) -> Measures:
    """By the sizes that are told."""
    extents, wheels = [], []
    strung = {ref.owner for item in kinds.strings for ref in item.touches()}
    for name in model.seats:
        body = model.body(name)
        points = [point for outline in body_outlines(body, value) for point in outline.around()]
        extents += [extent_across(points)] if points else []
        radii = [value(radius) for _, radius in body.radii]
        radius = shape_of(body).outer or body.radius
        radii += [value(radius)] if radius is not None else []
        wheels += radii if name in strung or body.radii else []
    for surface in model.problem.surfaces:
        radius = curve_radius(surface)
        extents += [value(radius)] if radius is not None else []
    whole = max((size for size in extents if size > 0.0), default=1.0)
    block = OF_WHEEL * min(wheels) if wheels and min(wheels) > 0.05 * whole else OF_ALL * whole
    return Measures(whole, block)


def extent_across(points: Sequence[Point]) -> float:
    """How large something is across."""
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return max(max(xs) - min(xs), max(ys) - min(ys)) if points else 0.0


def figured(
    model: Model, kinds: ConnectionKinds, value: Value, q: Sequence[float], sizes: Measures
) -> dict[str, Figured]:
    """All bodies as they are drawn, turned as they stand."""
    found: dict[str, Figured] = {}
    told = turned_as_told(model)
    for name, seat in model.seats.items():
        body = model.body(name)
        outlines = tuple(body_outlines(body, value))
        turn, block = q[seat.turn], False
        if not outlines:
            outlines, block = plain_outline(name, model, kinds, value, sizes, found)
        if name in model.held and holds_inside(name, kinds):
            outlines = walls_outwards(outlines)
        tilt = None if name in told else lying_tilt(name, model, kinds)
        if tilt is not None and (block or not shape_of(body).slender):
            turn = turn + tilt
        found[name] = Figured(name, body, outlines, turn, block=block, seen=not is_rope(name, kinds))
    return found


def holds_inside(name: str, kinds: ConnectionKinds) -> bool:
    """Whether something rolls or slides on the inside of a body."""
    inner = [item.pair()[1].owner for item in kinds.contacts if item.on_inside()]
    return name in (*inner, *(item.gear[1].owner for item in kinds.gears if item.inside))


def walls_outwards(outlines: tuple[BodyOutline, ...]) -> tuple[BodyOutline, ...]:
    """A ring whose thickness nobody told, with the radius that is told as the inner one, on which something lies."""
    radii = [outline.radius for outline in outlines]
    if len(radii) == 2 and radii[0] and radii[1] == WALL * radii[0]:
        return disc(radii[0] / WALL), disc(radii[0], cut=True)
    return outlines


def is_rope(name: str, kinds: ConnectionKinds) -> bool:
    """Whether something else draws the body: a rope where it hangs."""
    return any(item.drapes[0].owner == name for item in kinds.ropes)


def lying_tilt(name: str, model: Model, kinds: ConnectionKinds) -> float | None:
    """How a body is turned by the flat surface on which it lies; None of one that lies on none, or rolls."""
    for item in kinds.contacts:
        if item.lying() == name and rests(item, model):
            surface = surface_of(item, model)
            if surface is not None and not surface.curved and not model.turns(name):
                x, y = normal(surface, model)
                return math.atan2(y, x) - math.pi / 2
    return None


def threaded(name: str, model: Model, kinds: ConnectionKinds) -> bool:
    """Whether a body is a bead on a wire."""
    places = [surface_of(item, model) for item in kinds.contacts if item.lying() == name]
    return any(surface is not None and surface.two_sided for surface in places)


def plain_outline(
    name: str, model: Model, kinds: ConnectionKinds, value: Value, sizes: Measures, before: dict[str, Figured]
) -> tuple[tuple[BodyOutline, ...], bool]:
    """What is drawn for a body of which no size is told, and whether that is a block."""
    body = model.body(name)
    if is_rope(name, kinds):
        return (), False
    if shape_of(body).pointlike and body.shape is not None:
        return (disc(0.0),), False
    if threaded(name, model, kinds):
        return (disc(0.0),), False
    holding = [item for item in model.acting.connections if name in {ref.owner for ref in item.touches()}]
    if any(item.axial or item.between() or item.winds() for item in holding) and body.shape is None:
        radius = WHEEL * sizes.whole * INNER ** sum(shares_axle(name, other, holding) for other in before)
        return (disc(radius),), False
    if name in model.held:
        return (plate(body, value, sizes),), False
    below = [item.pair()[1].owner for item in kinds.contacts if item.lying() == name]
    if sum(other in model.seats for other in below) > 1:
        return (box(PLANK[0] * len(below) * sizes.whole, PLANK[1] * sizes.whole),), True
    sides = [item.side for item in kinds.contacts if item.side is not None and item.side.bearer() == name]
    if sides and body.shape is None and not body.parts:
        from rotsolve.draw.plane.places.sided import sided_outline

        riders = [item.lying() for item in kinds.contacts if item.side in sides]
        radii = [radius_of(model.body(rider), None, model.value) or 0.0 for rider in riders]
        return sided_outline(sides, value, max(sizes.block, *(ROOM * radius for radius in radii))), not sides[0].curved
    if any(item.pair()[1].owner == name for item in kinds.contacts):
        return (box(CARRIER[0] * sizes.block, CARRIER[1] * sizes.block),), True
    if is_block(body, holding, [item for item in kinds.strings if item in holding]):
        return (box(BLOCK[0] * sizes.block, BLOCK[1] * sizes.block),), True
    if body.inertia is not None and body.shape is None and not holding:
        return (plate(body, value, sizes),), False
    return (plate(body, value, sizes) if body.points else disc(0.0),), False


def shares_axle(name: str, other: str, holding: Sequence[Connection]) -> bool:
    owners = ({ref.owner for ref in item.touches()} for item in holding)
    return any({name, other} <= names for names in owners)


def is_block(body: Body, holding: Sequence[Connection], strings: Sequence[Connection]) -> bool:
    """Whether it lies on something or hangs from something, as a block does; what flies, rides or is joined to a body is a point."""
    if body.shape is not None or body.parts:
        return False
    lying = any(item.lying() == body.name for item in holding)
    tied = any(item.hangs(body) or item.ropes() for item in holding) or (body.moves is not None and bool(holding))
    joined = any(item.joined() or item.ride() is not None or item.joint() for item in holding)
    return (lying or tied or bool(strings)) and not joined


def plate(body: Body, value: Value, sizes: Measures) -> BodyOutline:
    """The outline of a body of which no form is told: a smooth one round its named points."""
    points = [(value(at[0]), value(at[1])) for _, at in body.points] or [(0.0, 0.0)]
    low, high = (min(x for x, _ in points), max(x for x, _ in points))
    down, up = (min(y for _, y in points), max(y for _, y in points))
    room = 0.22 * max(high - low, up - down, sizes.whole if len(points) < 2 else 0.0)
    a, b = (high - low) / 2 + room, (up - down) / 2 + 0.8 * room
    middle = ((low + high) / 2, (down + up) / 2)
    around = (2 * math.pi * k / PLATE for k in range(PLATE))
    return polygon(
        [shifted_by(middle, (a * math.cos(t) * (1 + 0.08 * math.cos(2 * t + 1)), b * math.sin(t))) for t in around]
    )
