"""Flat shapes with corners: rectangle, triangle, polygon."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from rotsolve.algebra.formula import ZERO, Formula, Number, call
from rotsolve.elements.shapes import shoelace
from rotsolve.elements.shapes.shape import Place, Shape
from rotsolve.scene.keys import key


@dataclass(frozen=True)
class Rectangle(Shape):
    word = "rectangle"
    about = "thin uniform rectangle; corners counterclockwise from the lower left: corner1 … corner4"
    points = ("center", "corner1", "corner2", "corner3", "corner4")
    sides: tuple[Formula, ...] = key(
        "quantities", "width and height", dimension="length", letter="a b", limits="positive", count=(2, 2), default=()
    )

    def moment(self, mass: Formula) -> Formula:
        """M (a² + b²)/12."""
        width, height = self.sides
        return Number(Fraction(1, 12)) * mass * (width**2 + height**2)

    def slender(self, mass: Formula) -> Formula | None:
        """M (a² − b²)/12."""
        width, height = self.sides
        return Number(Fraction(1, 12)) * mass * (width**2 - height**2)

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
        """M (a² + b² + c²)/36."""
        if self.corners:
            return shoelace.moment(self.corners, mass)
        a, b, c = self.sides
        return mass * (a**2 + b**2 + c**2) / 36

    def centroid(self) -> Place:
        return shoelace.centroid(self.vertices())

    def measure(self) -> Formula:
        return shoelace.area(self.vertices())

    def vertices(self) -> tuple[Place, ...]:
        """The three corners; from three sides the first lies along +x: x₃ = (a² + c² − b²)/(2 a)."""
        if self.corners:
            return self.corners
        a, b, c = self.sides
        x = (a**2 + c**2 - b**2) / (2 * a)
        return ((ZERO, ZERO), (a, ZERO), (x, call("sqrt", c**2 - x**2)))

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        return corner(self.vertices(), point, self.centroid())


@dataclass(frozen=True)
class Polygon(Shape):
    word = "polygon"
    about = "thin uniform polygon by its corners in order: corner1, corner2, …"
    points = ()
    corners: tuple[Place, ...] = key("places", "corners in order", letter="x", count=(3, 40), default=(), required=True)

    def moment(self, mass: Formula) -> Formula:
        """By the shoelace formula."""
        return shoelace.moment(self.corners, mass)

    def centroid(self) -> Place:
        return shoelace.centroid(self.corners)

    def measure(self) -> Formula:
        return shoelace.area(self.corners)

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        return corner(self.corners, point, self.centroid())


def corner(corners: tuple[Place, ...], point: str, centre: Place) -> Place:
    """The place of `corner1`, `corner2`, …; the centre of mass for any other point."""
    number = point.removeprefix("corner")
    return corners[int(number) - 1] if number.isdigit() and 0 < int(number) <= len(corners) else centre
