"""Flat shapes with corners: rectangle, triangle, polygon; what a polygon's area and moments are by sums over its edges."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Number, call, multiply, negate, total
from rotsolve.core.limits import Limit
from rotsolve.core.slicing import Range, Slicing, coordinate, on_line
from rotsolve.core.vectors.tensor import InertiaTensor
from rotsolve.language.keys import key
from rotsolve.language.shape import Place, Shape, corners_of_box


class Rectangle(Shape, frozen=True):
    word = "rectangle"
    backed = True
    spread = "surface"
    about = "thin uniform rectangle; corners counterclockwise from the lower left: corner1 … corner4"
    points = ("center", "corner1", "corner2", "corner3", "corner4")
    coordinates = ("x",)
    sides: tuple[Formula, ...] = key(
        "quantities",
        "width and height",
        dimension="length",
        letter="a b",
        limits="positive",
        count=(2, 2),
        default=(),
        required=True,
    )

    def moment(self, mass: Formula) -> Formula:
        """M (a² + b²)/12."""
        width, height = self.sides
        return Number(Fraction(1, 12)) * mass * (width**2 + height**2)

    def tensor(self, mass: Formula) -> InertiaTensor:
        """M b²/12, M a²/12 and their sum."""
        width, height = self.sides
        twelfth = Number(Fraction(1, 12)) * mass
        return InertiaTensor(twelfth * height**2, twelfth * width**2, self.moment(mass))

    def slicing(self) -> Slicing:
        """Strips of width dx."""
        x, (width, height) = coordinate("x"), self.sides
        element = ("strips of height ", height, " and width d", x)
        return on_line(element, Range(x, -width / 2, width / 2), height, (height**2 / 12, ZERO))

    def measure(self) -> Formula:
        return self.sides[0] * self.sides[1]

    def box(self) -> tuple[Formula, ...]:
        return self.sides

    def outline(self) -> tuple[Place, ...]:
        return corners_of_box(*self.sides)

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        return dict(zip(self.points[1:], self.outline(), strict=True)).get(point, (ZERO, ZERO))


class Cornered(Shape, frozen=True):
    """Base of what is known by the places of its corners, as sums over its edges."""

    spread = "surface"

    def vertices(self) -> tuple[Place, ...]:
        """The corners in order."""
        raise NotImplementedError

    def moment(self, mass: Formula) -> Formula:
        """By the shoelace formula."""
        return polygon_moment(self.vertices(), mass)

    def tensor(self, mass: Formula) -> InertiaTensor:
        """From the means of x², y² and x y about the centroid: I_xx = M y², I_yy = M x², I_xy = −M x y."""
        xx, yy, xy = polygon_products(self.vertices(), mass)
        return InertiaTensor(yy, xx, self.moment(mass), negate(xy))

    def outline(self) -> tuple[Place, ...]:
        return self.vertices()

    def centroid(self) -> Place:
        return polygon_centroid(self.vertices())

    def measure(self) -> Formula:
        """A = ½ Σ p × q."""
        return simplify(total([spanned for _, _, spanned in edges_of(self.vertices())]) / 2)

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        """The place of `corner1`, `corner2`, …; the centre of mass for any other point."""
        corners, number = self.vertices(), point.removeprefix("corner")
        return corners[int(number) - 1] if number.isdigit() and 0 < int(number) <= len(corners) else self.centroid()


class Triangle(Cornered, frozen=True):
    word = "triangle"
    about = "thin uniform triangle: its three `corners`, or its three `sides` (corner1 to corner2 along +x first)"
    points = ("corner1", "corner2", "corner3")
    closing = ("sides", "corners")
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
        "corners", "three corners", letter="x", count=(3, 3), default=(), example="[[0, 0], [b, 0], [0, h]]"
    )

    def rooms(self) -> Iterator[Limit]:
        """Each side is shorter than the other two together."""
        words = "the longest side of a triangle must be shorter than the other two together"
        whole = total(self.sides)
        yield from (Limit(simplify(whole - 2 * side), words, strict=True) for side in dict.fromkeys(self.sides))

    def moment(self, mass: Formula) -> Formula:
        """M (a² + b² + c²)/36."""
        if self.corners:
            return super().moment(mass)
        a, b, c = self.sides
        return mass * (a**2 + b**2 + c**2) / 36

    def slicing(self) -> Slicing:
        """Strips parallel to the side opposite the first corner, at the part u of the way from that corner to it."""
        u, (apex, *others) = coordinate("u"), self.vertices()
        (ax, ay), (bx, by) = ((x - apex[0], y - apex[1]) for x, y in others)
        mx, my, wx, wy = (simplify(part) for part in ((ax + bx) / 2, (ay + by) / 2, bx - ax, by - ay))
        squares = (
            simplify(mx**2 + wx**2 / 12),
            simplify(my**2 + wy**2 / 12),
            ZERO,
            simplify(mx * my + wx * wy / 12),
            ZERO,
            ZERO,
        )
        return Slicing(
            ("strips parallel to a side, at the part ", u, " of the way from the opposite corner"),
            (Range(u, ZERO, ONE),),
            2 * self.measure() * u,
            (u * mx, u * my, ZERO),
            tuple(multiply(u**2, square) for square in squares),
            (*apex, ZERO),
            "corner1",
        )

    def vertices(self) -> tuple[Place, ...]:
        """The three corners; from three sides the first lies along +x: x₃ = (a² + c² − b²)/(2 a)."""
        if self.corners:
            return self.corners
        a, b, c = self.sides
        x = (a**2 + c**2 - b**2) / (2 * a)
        return ((ZERO, ZERO), (a, ZERO), (x, call("sqrt", c**2 - x**2)))


class Polygon(Cornered, frozen=True):
    word = "polygon"
    about = "thin uniform polygon by its corners in order: corner1, corner2, …"
    points = ()
    corners: tuple[Place, ...] = key(
        "corners",
        "corners in order",
        letter="x",
        count=(3, 40),
        default=(),
        required=True,
        example="[[0, 0], [b, 0], [b, h]]",
    )

    def vertices(self) -> tuple[Place, ...]:
        return self.corners


def edges_of(corners: tuple[Place, ...]) -> list[tuple[Place, Place, Formula]]:
    """The edges of a polygon with twice the signed area of the triangle that each spans with the origin."""
    pairs = zip(corners, (*corners[1:], corners[0]), strict=True)
    return [(p, q, p[0] * q[1] - q[0] * p[1]) for p, q in pairs]


def polygon_centroid(corners: tuple[Place, ...]) -> Place:
    """Σ (p + q) (p × q)/(6 A), the shoelace formula."""
    around = edges_of(corners)
    six = 3 * total([spanned for _, _, spanned in around])
    x, y = (simplify(total([(p[axis] + q[axis]) * spanned for p, q, spanned in around]) / six) for axis in (0, 1))
    return (x, y)


def polygon_moment(corners: tuple[Place, ...], mass: Formula) -> Formula:
    """M Σ (p·p + p·q + q·q) (p × q)/(6 Σ p × q), about the origin, less M d² of the centroid."""
    around = edges_of(corners)
    origin = total([(dot(p, p) + dot(p, q) + dot(q, q)) * spanned for p, q, spanned in around])
    centre = polygon_centroid(corners)
    return mass * simplify(origin / (6 * total([spanned for _, _, spanned in around])) - dot(centre, centre))


def polygon_products(corners: tuple[Place, ...], mass: Formula) -> tuple[Formula, Formula, Formula]:
    """M times the means of x², y² and x y about the centroid (C. Steger, On the Calculation of Arbitrary Moments of Polygons)."""
    around, centre = edges_of(corners), polygon_centroid(corners)
    whole = total([spanned for _, _, spanned in around])

    def mean(i: int, j: int) -> Formula:
        terms = [(2 * p[i] * p[j] + p[i] * q[j] + q[i] * p[j] + 2 * q[i] * q[j]) * spanned for p, q, spanned in around]
        return mass * simplify(total(terms) / (12 * whole) - centre[i] * centre[j])

    return mean(0, 0), mean(1, 1), mean(0, 1)


def dot(p: Place, q: Place) -> Formula:
    """p · q."""
    return p[0] * q[0] + p[1] * q[1]
