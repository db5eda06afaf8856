"""Solid shapes beside cylinders and spheres: cone, box, ellipsoid."""

from __future__ import annotations

from fractions import Fraction

from msgspec.structs import replace

from rotsolve.algebra.formula import ONE, PI, ZERO, Formula, Number
from rotsolve.core.slicing import Range, Slicing, coordinate, on_axis, on_line
from rotsolve.core.vectors.tensor import InertiaTensor, round_about
from rotsolve.language.keys import key
from rotsolve.language.shape import Place, Shape, corners_of_box, extent


class Cone(Shape, frozen=True):
    word = "cone"
    symmetry_axis = "z"
    about = (
        "uniform solid cone seen along its axis, with the middle of its base at the centre and its tip at z = length"
    )
    points = ("tip", "base", "center")
    spread = "volume"
    flat = False
    radius: Formula | None = extent("radius of the base", "R")
    length: Formula | None = extent("height from base to tip", "h")

    def moment(self, mass: Formula) -> Formula:
        """3 M R²/10."""
        return Number(Fraction(3, 10)) * mass * (self.radius or ZERO) ** 2

    def tensor(self, mass: Formula) -> InertiaTensor:
        """3 M (4 R² + h²)/80 across the axis, through the centre of mass."""
        across = Number(Fraction(3, 80)) * mass * (4 * (self.radius or ZERO) ** 2 + (self.length or ZERO) ** 2)
        return round_about("z", self.moment(mass), across)

    def slicing(self) -> Slicing:
        """Discs of radius R u/h and thickness du, u from the tip towards the base (z = −u from the tip)."""
        u, radius, length = coordinate("u"), self.radius or ZERO, self.length or ZERO
        ring = radius * u / length
        element = ("discs of radius ", ring, " and thickness d", u, ", ", u, " from the tip")
        discs = on_axis(element, Range(u, ZERO, length), PI * ring**2, (ring**2 / 4, ring**2 / 4))
        return replace(discs, centre=(ZERO, ZERO, -u), origin=(ZERO, ZERO, length), at="tip")

    def rise(self, point: str = "cm") -> Formula:
        length = self.length or ZERO
        return {"cm": length / 4, "tip": length}.get(point, ZERO)

    def measure(self) -> Formula:
        return Number(Fraction(1, 3)) * PI * (self.radius or ZERO) ** 2 * (self.length or ZERO)

    @property
    def outer(self) -> Formula | None:
        return None


def three(help: str) -> tuple[Formula, ...]:
    """The field of three lengths along x, y and z."""
    lengths = {"dimension": "length", "letter": "a b c", "limits": "positive", "count": (3, 3)}
    declared: tuple[Formula, ...] = key("quantities", help, default=(), required=True, **lengths)
    return declared


def of_squares(part: Formula, sides: tuple[Formula, ...]) -> InertiaTensor:
    """A part of the mass times the sum of the squares of the two lengths across each axis."""
    a, b, c = (side**2 for side in sides)
    return InertiaTensor(part * (b + c), part * (a + c), part * (a + b))


class Cuboid(Shape, frozen=True):
    word = "cuboid"
    regular = "cube"
    backed = True
    about = "uniform box: width along x, height along y, depth along z"
    spread = "volume"
    flat = False
    sides: tuple[Formula, ...] = three("width, height and depth")

    def moment(self, mass: Formula) -> Formula:
        """M (a² + b²)/12."""
        return self.tensor(mass).zz

    def tensor(self, mass: Formula) -> InertiaTensor:
        """M (b² + c²)/12 about x, and likewise."""
        return of_squares(Number(Fraction(1, 12)) * mass, self.sides)

    def slicing(self) -> Slicing:
        """Plates of thickness dx."""
        x, (a, b, c) = coordinate("x"), self.sides
        element = ("plates of area ", b * c, " and thickness d", x)
        return on_line(element, Range(x, -a / 2, a / 2), b * c, (b**2 / 12, c**2 / 12))

    def box(self) -> tuple[Formula, ...]:
        return self.sides[:2]

    def outline(self) -> tuple[Place, ...]:
        return corners_of_box(*self.sides[:2])

    def depth(self) -> Formula | None:
        return self.sides[2]

    def measure(self) -> Formula:
        a, b, c = self.sides
        return a * b * c


class Ellipsoid(Shape, frozen=True):
    word = "ellipsoid"
    about = "uniform ellipsoid: half axes along x, y and z"
    spread = "volume"
    flat = False
    sides: tuple[Formula, ...] = three("three half axes")

    def moment(self, mass: Formula) -> Formula:
        """M (a² + b²)/5."""
        return self.tensor(mass).zz

    def tensor(self, mass: Formula) -> InertiaTensor:
        """M (b² + c²)/5 about x, and likewise."""
        return of_squares(Number(Fraction(1, 5)) * mass, self.sides)

    def slicing(self) -> Slicing:
        """Elliptic discs of thickness dz, with half axes smaller than a and b by √(1 − z²/c²)."""
        z, (a, b, c) = coordinate("z"), self.sides
        share = ONE - z**2 / c**2
        element = ("elliptic discs of area ", PI * a * b * share, " and thickness d", z)
        return on_axis(element, Range(z, -c, c), PI * a * b * share, (a**2 * share / 4, b**2 * share / 4))

    def measure(self) -> Formula:
        a, b, c = self.sides
        return Number(Fraction(4, 3)) * PI * a * b * c
