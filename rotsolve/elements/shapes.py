"""Shapes of bodies: how mass is spread. A size that the scene leaves out is None."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import ClassVar

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import PI, ZERO, Formula, Number, call, total
from rotsolve.scene.keys import key

Place = tuple[Formula, Formula]
WHEEL = ("center", "rim", "top", "bottom")


def extent(help: str, letter: str, **limits: object) -> Formula | None:
    return key("quantity", help, dimension="length", letter=letter, limits="positive", default=None, **limits)  # type: ignore[no-any-return]


@dataclass(frozen=True)
class Shape:
    """Base of all shapes. `points` are the names of its points, beside `cm` and those that the scene names."""

    word: ClassVar[str] = ""
    about: ClassVar[str] = ""
    points: ClassVar[tuple[str, ...]] = ("center",)
    later: ClassVar[bool] = False

    def moment(self, mass: Formula) -> Formula:
        """Moment of inertia about the centre of mass, axis square to the plane."""
        return ZERO

    def centroid(self) -> Place:
        """Centre of mass in the body's axes."""
        return (ZERO, ZERO)

    def measure(self) -> Formula:
        """Length, area or volume, by which a uniform density is multiplied."""
        raise NotImplementedError(f"a {self.word} has no extent")

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        """Place of a named point in the body's axes; a round body's rim points are directions in space, hence not here."""
        return (ZERO, ZERO)

    @property
    def outer(self) -> Formula | None:
        """Radius of the rim of a round shape."""
        return getattr(self, "radius", None)


@dataclass(frozen=True)
class Particle(Shape):
    word = "particle"
    about = "all mass in one point"


@dataclass(frozen=True)
class Rod(Shape):
    word = "rod"
    about = "thin uniform rod; `rod.at(x)` is the point at x from its start"
    points = ("start", "center", "end")
    length: Formula | None = extent("length", "L")

    def moment(self, mass: Formula) -> Formula:
        return Number(Fraction(1, 12)) * mass * self.extent() ** 2

    def measure(self) -> Formula:
        return self.extent()

    def extent(self) -> Formula:
        return self.length or ZERO

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        half = self.extent() / 2
        if point == "at" and argument is not None:
            return (argument - half, ZERO)
        return ({"start": -half, "end": half}.get(point, ZERO), ZERO)


@dataclass(frozen=True)
class Arc(Shape):
    word = "arc"
    about = "thin uniform wire along an arc of a circle, symmetric about its +x axis; `center` is the circle's"
    points = ("center", "start", "middle", "end")
    radius: Formula | None = extent("radius of the circle", "R")
    opening: Formula | None = key(
        "quantity",
        "angle that the arc spans",
        dimension="angle",
        letter="theta",
        limits="positive",
        default=None,
        required=True,
    )

    def moment(self, mass: Formula) -> Formula:
        radius, (x, _) = self.radius or ZERO, self.centroid()
        return mass * (radius**2 - x**2)

    def centroid(self) -> Place:
        radius, half = self.radius or ZERO, (self.opening or ZERO) / 2
        return (radius * call("sin", half) / half, ZERO)

    def measure(self) -> Formula:
        return (self.radius or ZERO) * (self.opening or ZERO)

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        radius, half = self.radius or ZERO, (self.opening or ZERO) / 2
        side = {"start": -half, "end": half}.get(point)
        if side is None:
            return (radius if point == "middle" else ZERO, ZERO)
        return (radius * call("cos", side), radius * call("sin", side))


@dataclass(frozen=True)
class Disc(Shape):
    word = "disc"
    about = "uniform solid disc"
    points = WHEEL
    radius: Formula | None = extent("radius", "R")

    def moment(self, mass: Formula) -> Formula:
        return Number(Fraction(1, 2)) * mass * (self.radius or ZERO) ** 2

    def measure(self) -> Formula:
        return PI * (self.radius or ZERO) ** 2


@dataclass(frozen=True)
class Ring(Shape):
    word = "ring"
    about = "thin uniform ring or hoop"
    points = WHEEL
    radius: Formula | None = extent("radius", "R")

    def moment(self, mass: Formula) -> Formula:
        return mass * (self.radius or ZERO) ** 2

    def measure(self) -> Formula:
        return Number(Fraction(2)) * PI * (self.radius or ZERO)


@dataclass(frozen=True)
class Annulus(Shape):
    word = "annulus"
    about = "flat disc with a round hole in its middle: `radii: {inner: r, outer: R}`"
    points = (*WHEEL, "inner", "outer")
    radii: tuple[tuple[str, Formula], ...] = key(
        "radii", "inner and outer radius", default=(), choices=("inner", "outer")
    )

    def moment(self, mass: Formula) -> Formula:
        inner, outer = _walls(self.radii)
        return Number(Fraction(1, 2)) * mass * (inner**2 + outer**2)

    def measure(self) -> Formula:
        inner, outer = _walls(self.radii)
        return PI * (outer**2 - inner**2)

    @property
    def outer(self) -> Formula | None:
        return _walls(self.radii)[1]


@dataclass(frozen=True)
class Rectangle(Shape):
    word = "rectangle"
    about = "thin uniform rectangle; corners counterclockwise from the lower left: corner1 … corner4"
    points = ("center", "corner1", "corner2", "corner3", "corner4")
    sides: tuple[Formula, ...] = key(
        "quantities", "width and height", dimension="length", letter="a b", limits="positive", count=(2, 2), default=()
    )

    def moment(self, mass: Formula) -> Formula:
        width, height = self.sides
        return Number(Fraction(1, 12)) * mass * (width**2 + height**2)

    def measure(self) -> Formula:
        return self.sides[0] * self.sides[1]

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        width, height = self.sides[0] / 2, self.sides[1] / 2
        places = {
            "corner1": (-width, -height),
            "corner2": (width, -height),
            "corner3": (width, height),
            "corner4": (-width, height),
        }
        return places.get(point, (ZERO, ZERO))


@dataclass(frozen=True)
class Triangle(Shape):
    word = "triangle"
    about = "thin uniform triangle: its three `corners`, or its three `sides` (corner1 to corner2 along +x first)"
    points = ("corner1", "corner2", "corner3")
    sides: tuple[Formula, ...] = key(
        "quantities",
        "three sides, in order",
        dimension="length",
        letter="a b c",
        limits="positive",
        count=(3, 3),
        default=(),
    )
    corners: tuple[Place, ...] = key(
        "places", "three corners", letter="x", count=(3, 3), default=(), example="[[0, 0], [b, 0], [0, h]]"
    )

    def moment(self, mass: Formula) -> Formula:
        if self.corners:
            return _polygon_moment(self.corners, mass)
        a, b, c = self.sides
        return mass * (a**2 + b**2 + c**2) / 36

    def centroid(self) -> Place:
        return _polygon_centroid(self.vertices())

    def measure(self) -> Formula:
        return _polygon_area(self.vertices())

    def vertices(self) -> tuple[Place, ...]:
        """The three corners; from three sides the first lies along +x: x₃ = (a² + c² − b²)/(2 a)."""
        if self.corners:
            return self.corners
        a, b, c = self.sides
        x = (a**2 + c**2 - b**2) / (2 * a)
        return ((ZERO, ZERO), (a, ZERO), (x, call("sqrt", c**2 - x**2)))

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        return _corner(self.vertices(), point, self.centroid())


@dataclass(frozen=True)
class Polygon(Shape):
    word = "polygon"
    about = "thin uniform polygon by its corners in order: corner1, corner2, …"
    points = ()
    corners: tuple[Place, ...] = key("places", "corners in order", letter="x", count=(3, 40), default=(), required=True)

    def moment(self, mass: Formula) -> Formula:
        return _polygon_moment(self.corners, mass)

    def centroid(self) -> Place:
        return _polygon_centroid(self.corners)

    def measure(self) -> Formula:
        return _polygon_area(self.corners)

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        return _corner(self.corners, point, self.centroid())


@dataclass(frozen=True)
class Cylinder(Shape):
    word = "cylinder"
    about = "uniform solid cylinder seen along its axis"
    points = WHEEL
    radius: Formula | None = extent("radius", "R")
    length: Formula | None = extent("length along the axis; no matter in the plane", "L")

    def moment(self, mass: Formula) -> Formula:
        return Number(Fraction(1, 2)) * mass * (self.radius or ZERO) ** 2

    def measure(self) -> Formula:
        return PI * (self.radius or ZERO) ** 2


@dataclass(frozen=True)
class CylindricalShell(Shape):
    word = "cylindrical shell"
    about = "thin-walled tube seen along its axis; thick-walled with `radii: {inner: r, outer: R}`"
    points = (*WHEEL, "inner", "outer")
    radius: Formula | None = extent("radius", "R")
    radii: tuple[tuple[str, Formula], ...] = key(
        "radii", "inner and outer radius", default=(), choices=("inner", "outer")
    )
    length: Formula | None = extent("length along the axis; no matter in the plane", "L")

    def moment(self, mass: Formula) -> Formula:
        if self.radii:
            inner, outer = _walls(self.radii)
            return Number(Fraction(1, 2)) * mass * (inner**2 + outer**2)
        return mass * (self.radius or ZERO) ** 2

    def measure(self) -> Formula:
        if self.radii:
            inner, outer = _walls(self.radii)
            return PI * (outer**2 - inner**2)
        return Number(Fraction(2)) * PI * (self.radius or ZERO)

    @property
    def outer(self) -> Formula | None:
        return _walls(self.radii)[1] if self.radii else self.radius


@dataclass(frozen=True)
class Sphere(Shape):
    word = "sphere"
    about = "uniform solid sphere"
    points = WHEEL
    radius: Formula | None = extent("radius", "R")

    def moment(self, mass: Formula) -> Formula:
        return Number(Fraction(2, 5)) * mass * (self.radius or ZERO) ** 2

    def measure(self) -> Formula:
        return Number(Fraction(4, 3)) * PI * (self.radius or ZERO) ** 3


@dataclass(frozen=True)
class SphericalShell(Shape):
    word = "spherical shell"
    about = "thin-walled hollow sphere; thick-walled with `radii: {inner: r, outer: R}`"
    points = (*WHEEL, "inner", "outer")
    radius: Formula | None = extent("radius", "R")
    radii: tuple[tuple[str, Formula], ...] = key(
        "radii", "inner and outer radius", default=(), choices=("inner", "outer")
    )

    def moment(self, mass: Formula) -> Formula:
        if self.radii:
            inner, outer = _walls(self.radii)
            return Number(Fraction(2, 5)) * mass * (outer**5 - inner**5) / (outer**3 - inner**3)
        return Number(Fraction(2, 3)) * mass * (self.radius or ZERO) ** 2

    def measure(self) -> Formula:
        if self.radii:
            inner, outer = _walls(self.radii)
            return Number(Fraction(4, 3)) * PI * (outer**3 - inner**3)
        return Number(Fraction(4)) * PI * (self.radius or ZERO) ** 2

    @property
    def outer(self) -> Formula | None:
        return _walls(self.radii)[1] if self.radii else self.radius


@dataclass(frozen=True)
class Cone(Shape):
    word = "cone"
    about = "uniform solid cone"
    points = ("tip", "base", "center")
    later = True
    radius: Formula | None = extent("radius of the base", "R")
    length: Formula | None = extent("height from base to tip", "h")


@dataclass(frozen=True)
class Cuboid(Shape):
    word = "cuboid"
    about = "uniform box"
    later = True
    sides: tuple[Formula, ...] = key(
        "quantities", "three edges", dimension="length", letter="a b c", limits="positive", count=(3, 3), default=()
    )


@dataclass(frozen=True)
class Ellipsoid(Shape):
    word = "ellipsoid"
    about = "uniform ellipsoid"
    later = True
    sides: tuple[Formula, ...] = key(
        "quantities", "three half axes", dimension="length", letter="a b c", limits="positive", count=(3, 3), default=()
    )


def _walls(radii: tuple[tuple[str, Formula], ...]) -> tuple[Formula, Formula]:
    sizes = dict(radii)
    return sizes.get("inner", ZERO), sizes.get("outer", ZERO)


def _corner(corners: tuple[Place, ...], point: str, centre: Place) -> Place:
    number = point.removeprefix("corner")
    return corners[int(number) - 1] if number.isdigit() and 0 < int(number) <= len(corners) else centre


def _edges(corners: tuple[Place, ...]) -> list[tuple[Place, Place, Formula]]:
    """The edges of a polygon with twice the signed area of the triangle that each spans with the origin."""
    pairs = zip(corners, (*corners[1:], corners[0]), strict=True)
    return [(p, q, p[0] * q[1] - q[0] * p[1]) for p, q in pairs]


def _polygon_area(corners: tuple[Place, ...]) -> Formula:
    return simplify(total([area for _, _, area in _edges(corners)]) / 2)


def _polygon_centroid(corners: tuple[Place, ...]) -> Place:
    """Σ (p + q) (p × q)/(6 A), the shoelace formula."""
    edges = _edges(corners)
    six = 3 * total([area for _, _, area in edges])
    x, y = (simplify(total([(p[axis] + q[axis]) * area for p, q, area in edges]) / six) for axis in (0, 1))
    return (x, y)


def _polygon_moment(corners: tuple[Place, ...], mass: Formula) -> Formula:
    """M Σ (p·p + p·q + q·q) (p × q)/(6 Σ p × q), about the origin, less M d² of the centroid."""
    edges = _edges(corners)
    origin = total([(_dot(p, p) + _dot(p, q) + _dot(q, q)) * area for p, q, area in edges])
    centre = _polygon_centroid(corners)
    return mass * simplify(origin / (6 * total([area for _, _, area in edges])) - _dot(centre, centre))


def _dot(p: Place, q: Place) -> Formula:
    return p[0] * q[0] + p[1] * q[1]


SHAPES: tuple[type[Shape], ...] = (
    Particle,
    Rod,
    Arc,
    Disc,
    Ring,
    Annulus,
    Rectangle,
    Triangle,
    Polygon,
    Cylinder,
    CylindricalShell,
    Sphere,
    SphericalShell,
    Cone,
    Cuboid,
    Ellipsoid,
)
