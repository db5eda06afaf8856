"""Outlines: what a body looks like in its own axes, by the shape of it, of its parts and of its holes. Lengths in metres."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Number
from rotsolve.confirm.bodies import frame
from rotsolve.confirm.numbers import value_of
from rotsolve.draw.paper.figure import Point, ray, shifted_by
from rotsolve.draw.plane.places.kinds import row_for
from rotsolve.elements.shapes import shape_of
from rotsolve.elements.shapes.flat import Cornered, Rectangle
from rotsolve.elements.shapes.half import Hemisphere, HemisphericalShell
from rotsolve.elements.shapes.integrated import Graded, Integrated, Lamina
from rotsolve.elements.shapes.round import Annulus, CylindricalShell, Disc, Ring, Sphere, SphericalShell
from rotsolve.elements.shapes.solid import Cone, Cuboid, Ellipsoid
from rotsolve.elements.shapes.thin import Arc, Particle, Rod, Rope
from rotsolve.language.bodies import Body, Part
from rotsolve.language.shape import Shape

WALL = 0.88  # the inner edge of a thin ring beside its outer one
AROUND = 72  # points of a circle that is taken as a polygon
STEPS = 48  # of a curve
Value = Callable[[Formula], float]


class BodyOutline(Struct, frozen=True):
    """A closed or open line in a body's own axes; or a circle of a radius about its only point, a dot where that is 0.

    A `slender` one is as thick as paper makes it, a `light` one a thin line; what is `cut` out shows the paper.
    """

    points: tuple[Point, ...]
    radius: float | None = None
    slender: bool = False
    cut: bool = False
    light: bool = False

    def turned(self, by: Point, angle: float) -> BodyOutline:
        """Turned about the origin, then moved."""
        return replace(self, points=tuple(shifted_by(by, spun(point, angle)) for point in self.points))

    def around(self) -> tuple[Point, ...]:
        """The points that bound it."""
        if self.radius is None:
            return self.points
        return tuple(
            shifted_by(self.points[0], ray(2 * math.pi * k / AROUND, self.radius))
            for k in range(AROUND if self.radius else 1)
        )


Shown = Iterator[BodyOutline]


def spun(point: Point, angle: float) -> Point:
    c, s = math.cos(angle), math.sin(angle)
    return c * point[0] - s * point[1], s * point[0] + c * point[1]


def disc(radius: float, *, cut: bool = False) -> BodyOutline:
    """A circle about the origin."""
    return BodyOutline(((0.0, 0.0),), radius, cut=cut)


def polygon(points: Sequence[Point]) -> BodyOutline:
    return BodyOutline(tuple(points))


def box(width: float, height: float) -> BodyOutline:
    """A rectangle about the origin."""
    x, y = width / 2, height / 2
    return polygon([(-x, -y), (x, -y), (x, y), (-x, y)])


DOT = disc(0.0)


def particle_outline(shape: Particle, value: Value) -> Shown:
    yield BodyOutline(((value(shape.radius), 0.0),), 0.0)


def rod_outline(shape: Rod, value: Value) -> Shown:
    half = value(shape.extent()) / 2
    yield BodyOutline(((-half, 0.0), (half, 0.0)), slender=True)


def rope_outline(shape: Rope, value: Value) -> Shown:
    """What it hangs over tells where it runs."""
    return iter(())


def arc_outline(shape: Arc, value: Value) -> Shown:
    radius, half = (value(part) if part is not None else 1.0 for part in (shape.radius, shape.opening))
    half /= 2
    yield BodyOutline(tuple(ray(half * (2 * k / STEPS - 1), radius) for k in range(STEPS + 1)), slender=True)


def hemisphere_outline(shape: Hemisphere, value: Value) -> Shown:
    """Seen from the side: half a disc."""
    if shape.radius is not None:
        radius = value(shape.radius)
        yield polygon([ray(math.pi * (k / AROUND - 0.5), radius) for k in range(AROUND + 1)])


def bowl_outline(shape: HemisphericalShell, value: Value) -> Shown:
    """Cut open: half a ring."""
    if shape.radius is not None:
        sides = [(1.0, range(AROUND + 1)), (WALL, range(AROUND, -1, -1))]
        radius = value(shape.radius)
        yield polygon([ray(math.pi * (k / AROUND - 0.5), share * radius) for share, steps in sides for k in steps])


def disc_outline(shape: Disc | Sphere, value: Value) -> Shown:
    if shape.radius is not None:
        yield disc(value(shape.radius))


def walls_outline(shape: Ring | Annulus | SphericalShell | CylindricalShell, value: Value) -> Shown:
    """A ring, or a shell cut open: between two radii where they are told."""
    radii = dict(getattr(shape, "radii", ()))
    outer = radii.get("outer") or getattr(shape, "radius", None)
    if outer is None:
        return
    yield disc(value(outer))
    yield disc(value(radii["inner"]) if "inner" in radii else WALL * value(outer), cut=True)


def corners_outline(shape: Shape, value: Value) -> Shown:
    yield polygon([(value(x), value(y)) for x, y in shape.outline()])


def cone_outline(shape: Cone, value: Value) -> Shown:
    """Seen along its axis."""
    if shape.radius is not None:
        yield disc(value(shape.radius))
        yield disc(0.0)


def ellipsoid_outline(shape: Ellipsoid, value: Value) -> Shown:
    a, b = (value(side) for side in shape.sides[:2])
    angles = (2 * math.pi * k / AROUND for k in range(AROUND))
    yield polygon([(a * math.cos(angle), b * math.sin(angle)) for angle in angles])


def lamina_outline(shape: Lamina, value: Value) -> Shown:
    """Along the lower limit of the inner coordinate, and back along the upper one."""
    outer, inner = sorted(shape.region, key=lambda item: item.variable.name[1:] not in ("x", "phi"))
    if inner.variable.name in (outer.lower - outer.upper).symbols():
        outer, inner = inner, outer
    first, last = value(outer.lower), value(outer.upper)
    steps = stepped(first, last)
    name = outer.variable.name
    sides = [
        [(step, float(value(end.substitute({name: as_number(step)})))) for step in steps]
        for end in (inner.lower, inner.upper)
    ]
    round_about = {outer.variable.name[1:], inner.variable.name[1:]} == {"r", "phi"}
    places = [*sides[0], *reversed(sides[1])]
    if outer.variable.name[1:] in ("y", "phi"):
        places = [(second, one) for one, second in places]
    yield polygon([ray(angle, size) for size, angle in places] if round_about else places)


def stepped(first: float, last: float) -> list[float]:
    """Numbers from one to another, which keep so far inside that no rounding leads beyond."""
    inside = 1e-9 * (last - first)
    shares = (
        (1 - math.cos(math.pi * k / STEPS)) / 2 for k in range(STEPS + 1)
    )  # closer at the ends, where curves are steep
    return [first + inside + (last - first - 2 * inside) * share for share in shares]


def as_number(value: float) -> Formula:
    """A number as a formula."""
    return Number(Fraction(value))


def integrated_outline(shape: Integrated, value: Value) -> Shown:
    """Seen along its axis: as large as it is anywhere."""
    along, radius = shape.profile
    name, low, high = along.variable.name, value(along.lower), value(along.upper)
    sizes = [value(radius.upper.substitute({name: as_number(step)})) for step in stepped(low, high)]
    yield disc(max(sizes))


def graded_outline(shape: Graded, value: Value) -> Shown:
    yield from shape_outlines(shape.shape, value)


OUTLINES: dict[type[Shape], Callable[[Any, Value], Shown]] = {
    Particle: particle_outline,
    Rod: rod_outline,
    Rope: rope_outline,
    Arc: arc_outline,
    Disc: disc_outline,
    Sphere: disc_outline,
    Hemisphere: hemisphere_outline,
    HemisphericalShell: bowl_outline,
    Ring: walls_outline,
    Annulus: walls_outline,
    SphericalShell: walls_outline,
    CylindricalShell: walls_outline,
    Rectangle: corners_outline,
    Cornered: corners_outline,
    Cuboid: corners_outline,
    Cone: cone_outline,
    Ellipsoid: ellipsoid_outline,
    Lamina: lamina_outline,
    Graded: graded_outline,
    Integrated: integrated_outline,
    Shape: corners_outline,
}


def shape_outlines(shape: Shape, value: Value) -> Shown:
    """What a shape looks like, by the nearest of its classes that has a row."""
    draw = row_for(type(shape), OUTLINES)
    yield from draw(shape, value) if draw is not None else ()


def body_outlines(body: Body, value: Value) -> Shown:
    """A body by its shape, its rims (the largest first), its parts and its holes; nothing of one of which no size is told."""
    if body.shape is not None:
        yield from shape_outlines(body.shape, value)
    rims = [size for _, size in body.radii] + ([body.radius] if body.radius is not None and body.shape is None else [])
    for radius in sorted(map(value, rims), reverse=True):
        yield disc(radius)
    yield from light_frame(body, value)
    for part in body.parts:
        yield from part_outlines(part, value)
    for hole in body.holes:
        yield from (replace(one, cut=True) for one in part_outlines(hole, value))


def light_frame(body: Body, value: Value) -> Shown:
    """The light rods that hold apart the balls and points of which a body consists."""
    spots = [frame(part, value)[0] for part in body.parts]
    if (
        body.shape is not None
        or len(spots) < 2
        or any(shape_of(part.body).slender or part.body.parts for part in body.parts)
    ):
        return
    if all(shape_of(part.body).pointlike or shape_of(part.body).round for part in body.parts):
        middle = (sum(x for x, _ in spots) / len(spots), sum(y for _, y in spots) / len(spots))
        around = sorted(spots, key=lambda spot: math.atan2(spot[1] - middle[1], spot[0] - middle[0]))
        yield BodyOutline((*around, around[0]), light=True)


def part_outlines(part: Part, value: Value) -> Shown:
    """A part at its place; one of which no size is told is a dot."""
    spot, turn = frame(part, value)
    shown = list(body_outlines(part.body, value)) or [DOT]
    yield from (one.turned(spot, turn) for one in shown)


def value_function(numbers: dict[str, float]) -> Value:
    """What gives the number of a formula."""
    return lambda formula: float(value_of(formula, numbers))
