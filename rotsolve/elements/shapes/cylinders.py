"""Cylinders: solid, or with a thin or thick wall. In the plane they are discs, rings and annuli; their axis is z."""

from __future__ import annotations

from fractions import Fraction

from rotsolve.algebra.formula import PI, ZERO, Formula, Number
from rotsolve.core.vectors.tensor import InertiaTensor, round_about
from rotsolve.elements.shapes.round import Annulus, Disc, Radii, Ring, walls
from rotsolve.elements.shapes.shape import WHEEL, extent
from rotsolve.elements.shapes.slicing import Range, Slicing, about_axis, coordinate, on_axis
from rotsolve.language.keys import key


class Cylinder(Disc, frozen=True):
    """A disc as far as its axis is concerned."""

    word = "cylinder"
    about = "uniform solid cylinder seen along its axis"
    spread = "volume"
    flat = False
    length: Formula | None = extent("length along the axis; no matter in the plane", "L")

    def tensor(self, mass: Formula) -> InertiaTensor:
        """M (3 R² + L²)/12 across the axis."""
        across = mass * (3 * (self.radius or ZERO) ** 2 + (self.length or ZERO) ** 2) / 12
        return round_about("z", self.moment(mass), across)

    def slicing(self) -> Slicing:
        """Shells of thickness dr."""
        return shells(ZERO, self.radius or ZERO, self.length or ZERO)

    def content(self) -> Formula:
        return self.measure() * (self.length or ZERO)


class CylindricalShell(Ring, frozen=True):
    """A ring as far as its axis is concerned, an annulus where its wall is thick."""

    word = "cylindrical shell"
    about = "thin-walled tube seen along its axis; thick-walled with `radii: {inner: r, outer: R}`"
    points = (*WHEEL, "inner", "outer")
    flat = False
    coordinates = ()
    radii: Radii = key("radii", "inner and outer radius", default=(), choices=("inner", "outer"))
    length: Formula | None = extent("length along the axis; no matter in the plane", "L")

    @property
    def spread(self) -> str:  # type: ignore[override]
        return "volume" if self.radii else "surface"

    def moment(self, mass: Formula) -> Formula:
        """M R² of a thin wall, ½ M (r² + R²) of a thick one."""
        return Annulus(self.radii).moment(mass) if self.radii else Ring(self.radius).moment(mass)

    def tensor(self, mass: Formula) -> InertiaTensor:
        """M (6 R² + L²)/12 across the axis of a thin wall, M (3 r² + 3 R² + L²)/12 of a thick one."""
        inner, outer = walls(self.radii)
        squares = 3 * (inner**2 + outer**2) if self.radii else 6 * (self.radius or ZERO) ** 2
        return round_about("z", self.moment(mass), mass * (squares + (self.length or ZERO) ** 2) / 12)

    def slicing(self) -> Slicing:
        """Rings of width dz; of a thick wall thin shells of thickness dr."""
        length = self.length or ZERO
        if self.radii:
            return shells(*walls(self.radii), length)
        z, radius = coordinate("z"), self.radius or ZERO
        element = ("rings of radius ", radius, " and width d", z)
        mean = radius**2 / 2
        return on_axis(element, Range(z, -length / 2, length / 2), Number(Fraction(2)) * PI * radius, (mean, mean))

    def measure(self) -> Formula:
        return Annulus(self.radii).measure() if self.radii else Ring(self.radius).measure()

    def content(self) -> Formula:
        return self.measure() * (self.length or ZERO)

    @property
    def outer(self) -> Formula | None:
        return Annulus(self.radii).outer if self.radii else self.radius


def shells(inner: Formula, outer: Formula, length: Formula) -> Slicing:
    """Cylindrical shells of radius r and thickness dr, as long as the whole."""
    r = coordinate("r")
    element = ("cylindrical shells of radius ", r, " and thickness d", r)
    return about_axis(element, Range(r, inner, outer), 2 * PI * r * length, r**2, length**2 / 12)
