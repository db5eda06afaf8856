"""Solids: what a body looks like in its own axes in space: faces that may be seen, and edges, by the shape of it and of its parts."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import product
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.confirm.space.arrows import Arrow, Turned, Z, normed, scaled, sum_of, times_arrow
from rotsolve.confirm.space.masses import axis_told, placing_of, spot_in_body
from rotsolve.draw.plane.places.kinds import row_for
from rotsolve.draw.plane.places.outlines import Value, lamina_outline, stepped
from rotsolve.draw.plane.places.outlines import as_number as as_formula
from rotsolve.draw.space.view import ring
from rotsolve.elements.shapes import shape_of
from rotsolve.elements.shapes.half import Hemisphere
from rotsolve.elements.shapes.integrated import Graded, Lamina, Revolution
from rotsolve.elements.shapes.round import Annulus, Cylinder, CylindricalShell, Disc, Ring, Sphere, SphericalShell
from rotsolve.elements.shapes.solid import Cone, Cuboid, Ellipsoid
from rotsolve.elements.shapes.thin import Arc, Particle, Rod
from rotsolve.language.bodies import Body, Part
from rotsolve.language.shape import Shape

BANDS = 36  # of a ball from pole to pole: enough for its outline to look round
THIN, LONG = 0.86, 1.0  # the inner edge of a thin ring; a length that is left open, in radii
TOP, AXLE = (
    0.55,
    0.5,
)  # of a body of which only an axis is told: radius of its disc and half length of its axle, in the scene's measure


class Piece(Struct, frozen=True):
    """A part of a body in its own axes. What its kind means:

    `face`: a flat side, filled, with the way out of it in `way` where it has only one; `hull`: what is filled is all that its points
    hide; `edge`: a line; `rod`: a stout one; `dot`: a point; `hole`: a flat side that shows the paper;
    `mark`: a line on a flat side.
    """

    kind: str
    points: tuple[Arrow, ...]
    way: Arrow | None = None

    def turned(self, rows: Turned, place: Arrow) -> Piece:
        """Turned about the origin, then moved."""
        points = tuple(sum_of(place, times_arrow(rows, point)) for point in self.points)
        return replace(self, points=points, way=None if self.way is None else times_arrow(rows, self.way))


Shown = Iterator[Piece]


def face(points: Sequence[Arrow], way: Arrow | None = None) -> Piece:
    return Piece("face", tuple(points), way)


def particle_solid(shape: Particle, value: Value) -> Shown:
    yield Piece("dot", ((value(shape.radius), 0.0, 0.0),))


def rod_solid(shape: Rod, value: Value) -> Shown:
    half = value(shape.extent()) / 2
    yield Piece("rod", ((-half, 0.0, 0.0), (half, 0.0, 0.0)))


def arc_solid(shape: Arc, value: Value) -> Shown:
    half = value(shape.opening) / 2 if shape.opening is not None else 1.0
    radius = value(shape.radius) if shape.radius is not None else 1.0
    yield Piece("rod", tuple(ring((0.0, 0.0, 0.0), Z, radius, -half, half)))


def disc_solid(shape: Disc, value: Value) -> Shown:
    if shape.radius is not None:
        yield face(ring((0.0, 0.0, 0.0), Z, value(shape.radius)))


def ring_solid(shape: Ring | Annulus, value: Value) -> Shown:
    """A flat ring; what is behind shows through it."""
    radii = dict(getattr(shape, "radii", ()))
    outer = radii.get("outer") or getattr(shape, "radius", None)
    if outer is not None:
        yield face(ring((0.0, 0.0, 0.0), Z, value(outer)))
        inner = value(radii["inner"]) if "inner" in radii else THIN * value(outer)
        yield Piece("hole", tuple(ring((0.0, 0.0, 0.0), Z, inner)))


def drum(radius: float, length: float) -> Shown:
    """A cylinder along z: all that its two ends hide, and the end that is seen."""
    ends = [(0.0, 0.0, side * length / 2) for side in (-1.0, 1.0)]
    rings = [ring(end, Z, radius) for end in ends]
    yield Piece("hull", (*rings[0], *rings[1]))
    yield face(rings[0], (0.0, 0.0, -1.0))
    yield face(rings[1], Z)


def cylinder_solid(shape: Cylinder | CylindricalShell, value: Value) -> Shown:
    radii = dict(getattr(shape, "radii", ()))
    outer = radii.get("outer") or shape.radius
    if outer is None:
        return
    radius = value(outer)
    length = value(shape.length) if shape.length is not None else LONG * radius
    yield from drum(radius, length)


def tube_solid(shape: CylindricalShell, value: Value) -> Shown:
    """A cylinder with a hole in the end that is seen."""
    yield from cylinder_solid(shape, value)
    radii = dict(shape.radii)
    outer = radii.get("outer") or shape.radius
    if outer is not None:
        radius = value(outer)
        length = value(shape.length) if shape.length is not None else LONG * radius
        inner = value(radii["inner"]) if "inner" in radii else THIN * radius
        for side in (-1.0, 1.0):
            yield Piece("hole", tuple(ring((0.0, 0.0, side * length / 2), Z, inner)), (0.0, 0.0, side))


def sphere_solid(shape: Sphere | SphericalShell, value: Value) -> Shown:
    radii = dict(getattr(shape, "radii", ()))
    outer = radii.get("outer") or shape.radius
    if outer is not None:
        yield from ball((value(outer),) * 3)


def hemisphere_solid(shape: Hemisphere, value: Value) -> Shown:
    """Half a ball: all that it hides, and its flat side."""
    if shape.radius is not None:
        radius = value(shape.radius)
        heights = [radius * math.sin(math.pi / 2 * k / BANDS) for k in range(BANDS)]
        rings = [ring((x, 0.0, 0.0), (1.0, 0.0, 0.0), math.sqrt(radius**2 - x**2)) for x in heights]
        yield Piece("hull", (*(point for places in rings for point in places), (radius, 0.0, 0.0)))
        yield face(rings[0], (-1.0, 0.0, 0.0))


def ball(axes: Sequence[float]) -> Shown:
    """An ellipsoid: all that it hides, and its equator."""
    a, b, c = axes
    around = [
        (a * math.cos(t) * math.cos(p), b * math.cos(t) * math.sin(p), c * math.sin(t))
        for t in (math.pi * (k / BANDS - 0.5) for k in range(BANDS + 1))
        for p in (math.pi * k / BANDS for k in range(2 * BANDS))
    ]
    yield Piece("hull", tuple(around))
    yield Piece("front", tuple((a * x, b * y, 0.0) for x, y, _ in ring((0.0, 0.0, 0.0), Z, 1.0)))


def cone_solid(shape: Cone, value: Value) -> Shown:
    if shape.radius is None or shape.length is None:
        return
    base, tip = ring((0.0, 0.0, 0.0), Z, value(shape.radius)), (0.0, 0.0, value(shape.length))
    yield Piece("hull", (*base, tip))
    yield face(base, (0.0, 0.0, -1.0))


def cuboid_solid(shape: Cuboid, value: Value) -> Shown:
    half = [value(side) / 2 for side in shape.sides]
    for k, side in product(range(3), (-1.0, 1.0)):
        i, j = (k + 1) % 3, (k + 2) % 3
        corners = []
        for p, q in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            corner = [0.0, 0.0, 0.0]
            corner[k], corner[i], corner[j] = side * half[k], p * half[i], q * half[j]
            corners.append((corner[0], corner[1], corner[2]))
        way = [0.0, 0.0, 0.0]
        way[k] = side
        yield face(corners, (way[0], way[1], way[2]))


def ellipsoid_solid(shape: Ellipsoid, value: Value) -> Shown:
    yield from ball([value(side) for side in shape.sides])


def lamina_solid(shape: Lamina, value: Value) -> Shown:
    yield from (face([(x, y, 0.0) for x, y in outline.points]) for outline in lamina_outline(shape, value))


def revolution_solid(shape: Revolution, value: Value) -> Shown:
    """Its profile turned about z."""
    along, radius = shape.profile
    name, heights = along.variable.name, stepped(value(along.lower), value(along.upper))
    sizes = [value(radius.upper.substitute({name: as_formula(z)})) for z in heights]
    rings = [ring((0.0, 0.0, z), Z, size) for z, size in zip(heights, sizes, strict=True) if size > 0.0]
    yield Piece("hull", tuple(point for places in rings for point in places))
    yield face(rings[0], (0.0, 0.0, -1.0))
    yield face(rings[-1], Z)


def graded_solid(shape: Graded, value: Value) -> Shown:
    yield from shape_pieces(shape.shape, value)


def corners_solid(shape: Shape, value: Value) -> Shown:
    corners = [(value(x), value(y), 0.0) for x, y in shape.outline()]
    if corners:
        yield face(corners)


SOLIDS: dict[type[Shape], Callable[[Any, Value], Shown]] = {
    Particle: particle_solid,
    Rod: rod_solid,
    Arc: arc_solid,
    Disc: disc_solid,
    Ring: ring_solid,
    Annulus: ring_solid,
    Cylinder: cylinder_solid,
    CylindricalShell: tube_solid,
    Sphere: sphere_solid,
    SphericalShell: sphere_solid,
    Hemisphere: hemisphere_solid,
    Cone: cone_solid,
    Cuboid: cuboid_solid,
    Ellipsoid: ellipsoid_solid,
    Lamina: lamina_solid,
    Revolution: revolution_solid,
    Graded: graded_solid,
    Shape: corners_solid,
}


def shape_pieces(shape: Shape, value: Value) -> Shown:
    """What a shape looks like, by the nearest of its classes that has a row."""
    draw = row_for(type(shape), SOLIDS)
    yield from draw(shape, value) if draw is not None else ()


def body_pieces(body: Body, value: Value) -> Shown:
    """A body by its shape, its parts and its holes; nothing of one of which no size is told."""
    if body.shape is not None:
        yield from shape_pieces(body.shape, value)
    yield from light_spokes(body, value)
    for part in body.parts:
        yield from part_pieces(part, value)
    for hole in body.holes:
        yield from (replace(piece, kind="hole") for piece in part_pieces(hole, value) if piece.kind == "face")


def part_pieces(part: Part, value: Value) -> Shown:
    """A part at its place; one of which no size is told is a point."""
    rows, place = placing_of(part, value)
    shown = list(body_pieces(part.body, value)) or [Piece("dot", ((0.0, 0.0, 0.0),))]
    yield from (piece.turned(rows, place) for piece in shown)


def light_spokes(body: Body, value: Value) -> Shown:
    """The light rods from its middle to the balls and points of which a body consists."""
    spots = [placing_of(part, value)[1] for part in body.parts]
    loose = all(shape_of(part.body).pointlike or shape_of(part.body).spherical for part in body.parts)
    if body.shape is None and loose and len(spots) > 1:
        if len(spots) == 2:
            yield Piece("edge", (spots[0], spots[1]))
        else:
            yield from (Piece("edge", ((0.0, 0.0, 0.0), spot)) for spot in spots)


def plain_solid(body: Body, value: Value, whole: float, axis: Arrow | None) -> Shown:
    """What is drawn for a body of which only inertia is told: a disc on an axle along its axis, else a ball that has none."""
    reach = [spot_in_body(body, name, value) for name, _ in body.points]
    size = max((math.hypot(*spot) for spot in reach), default=0.0) or whole
    way = axis_told(body, value) or axis
    if way is None:
        yield from ball([0.8 * AXLE * size, 0.62 * AXLE * size, 0.45 * AXLE * size])
        return
    yield face(ring((0.0, 0.0, 0.0), way, TOP * size))
    yield Piece("edge", (scaled(-AXLE * size, normed(way)), scaled(AXLE * size, normed(way))))
