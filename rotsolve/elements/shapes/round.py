"""Round shapes: discs, rings, cylinders and spheres, solid or with walls."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from rotsolve.algebra.formula import PI, ZERO, Formula, Number
from rotsolve.elements.shapes.shape import WHEEL, Shape, extent
from rotsolve.scene.keys import key

Radii = tuple[tuple[str, Formula], ...]


@dataclass(frozen=True)
class Disc(Shape):
    word = "disc"
    about = "uniform solid disc"
    points = WHEEL
    radius: Formula | None = extent("radius", "R")

    def moment(self, mass: Formula) -> Formula:
        """½ M R²."""
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
        """M R²."""
        return mass * (self.radius or ZERO) ** 2

    def measure(self) -> Formula:
        return Number(Fraction(2)) * PI * (self.radius or ZERO)


@dataclass(frozen=True)
class Annulus(Shape):
    word = "annulus"
    about = "flat disc with a round hole in its middle: `radii: {inner: r, outer: R}`"
    points = (*WHEEL, "inner", "outer")
    radii: Radii = key("radii", "inner and outer radius", default=(), choices=("inner", "outer"))

    def moment(self, mass: Formula) -> Formula:
        """½ M (r² + R²)."""
        inner, outer = walls(self.radii)
        return Number(Fraction(1, 2)) * mass * (inner**2 + outer**2)

    def measure(self) -> Formula:
        inner, outer = walls(self.radii)
        return PI * (outer**2 - inner**2)

    @property
    def outer(self) -> Formula | None:
        return walls(self.radii)[1]


@dataclass(frozen=True)
class Cylinder(Disc):
    """A disc as far as its axis is concerned."""

    word = "cylinder"
    about = "uniform solid cylinder seen along its axis"
    length: Formula | None = extent("length along the axis; no matter in the plane", "L")


@dataclass(frozen=True)
class CylindricalShell(Ring):
    """A ring as far as its axis is concerned, an annulus where its wall is thick."""

    word = "cylindrical shell"
    about = "thin-walled tube seen along its axis; thick-walled with `radii: {inner: r, outer: R}`"
    points = (*WHEEL, "inner", "outer")
    radii: Radii = key("radii", "inner and outer radius", default=(), choices=("inner", "outer"))
    length: Formula | None = extent("length along the axis; no matter in the plane", "L")

    def moment(self, mass: Formula) -> Formula:
        """M R² of a thin wall, ½ M (r² + R²) of a thick one."""
        return Annulus(self.radii).moment(mass) if self.radii else Ring(self.radius).moment(mass)

    def measure(self) -> Formula:
        return Annulus(self.radii).measure() if self.radii else Ring(self.radius).measure()

    @property
    def outer(self) -> Formula | None:
        return Annulus(self.radii).outer if self.radii else self.radius


@dataclass(frozen=True)
class Sphere(Shape):
    word = "sphere"
    about = "uniform solid sphere"
    points = WHEEL
    radius: Formula | None = extent("radius", "R")

    def moment(self, mass: Formula) -> Formula:
        """⅖ M R²."""
        return Number(Fraction(2, 5)) * mass * (self.radius or ZERO) ** 2

    def measure(self) -> Formula:
        return Number(Fraction(4, 3)) * PI * (self.radius or ZERO) ** 3


@dataclass(frozen=True)
class SphericalShell(Shape):
    word = "spherical shell"
    about = "thin-walled hollow sphere; thick-walled with `radii: {inner: r, outer: R}`"
    points = (*WHEEL, "inner", "outer")
    radius: Formula | None = extent("radius", "R")
    radii: Radii = key("radii", "inner and outer radius", default=(), choices=("inner", "outer"))

    def moment(self, mass: Formula) -> Formula:
        """⅔ M R² of a thin wall, ⅖ M (R⁵ − r⁵)/(R³ − r³) of a thick one."""
        if self.radii:
            inner, outer = walls(self.radii)
            return Number(Fraction(2, 5)) * mass * (outer**5 - inner**5) / (outer**3 - inner**3)
        return Number(Fraction(2, 3)) * mass * (self.radius or ZERO) ** 2

    def measure(self) -> Formula:
        if self.radii:
            inner, outer = walls(self.radii)
            return Number(Fraction(4, 3)) * PI * (outer**3 - inner**3)
        return Number(Fraction(4)) * PI * (self.radius or ZERO) ** 2

    @property
    def outer(self) -> Formula | None:
        return walls(self.radii)[1] if self.radii else self.radius


def walls(radii: Radii) -> tuple[Formula, Formula]:
    """Inner and outer radius."""
    sizes = dict(radii)
    return sizes.get("inner", ZERO), sizes.get("outer", ZERO)
