"""Round shapes: disc, ring, annulus, sphere and spherical shell; cylinders, solid or with a wall, seen along their axis z."""

from __future__ import annotations

from fractions import Fraction
from typing import ClassVar

from rotsolve.algebra.formula import PI, ZERO, Formula, Number, call
from rotsolve.core.slicing import Range, Slicing, coordinate, on_axis, round_axis
from rotsolve.core.vectors.tensor import InertiaTensor, round_about
from rotsolve.language.keys import key
from rotsolve.language.shape import WHEEL, Shape, extent

Radii = tuple[tuple[str, Formula], ...]


class Disc(Shape, frozen=True):
    word = "disc"
    symmetry_axis = "z"
    round = True
    noun = "solid disc"
    spread = "surface"
    about = "uniform solid disc"
    points = WHEEL
    wound = True
    coordinates: ClassVar[tuple[str, ...]] = ("r",)
    radius: Formula | None = extent("radius", "R")

    def moment(self, mass: Formula) -> Formula:
        """½ M R²."""
        return Number(Fraction(1, 2)) * mass * (self.radius or ZERO) ** 2

    def tensor(self, mass: Formula) -> InertiaTensor:
        """¼ M R² about a diameter."""
        return round_about("z", self.moment(mass), Number(Fraction(1, 4)) * mass * (self.radius or ZERO) ** 2)

    def slicing(self) -> Slicing:
        """Rings of width dr."""
        return rings(ZERO, self.radius or ZERO)

    def measure(self) -> Formula:
        return PI * (self.radius or ZERO) ** 2

    def face(self) -> tuple[Formula, Formula]:
        return ZERO, self.radius or ZERO


class Ring(Shape, frozen=True):
    word = "ring"
    symmetry_axis = "z"
    spread = "line"
    about = "thin uniform ring or hoop"
    points = WHEEL
    radius: Formula | None = extent("radius", "R")

    def moment(self, mass: Formula) -> Formula:
        """M R²."""
        return mass * (self.radius or ZERO) ** 2

    def tensor(self, mass: Formula) -> InertiaTensor:
        """½ M R² about a diameter."""
        return round_about("z", self.moment(mass), Number(Fraction(1, 2)) * mass * (self.radius or ZERO) ** 2)

    def slicing(self) -> Slicing:
        """Pieces of length R dφ."""
        phi, radius = coordinate("phi"), self.radius or ZERO
        x, y = radius * call("cos", phi), radius * call("sin", phi)
        around = Range(phi, ZERO, 2 * PI)
        element = ("pieces of length ", radius, " d", phi)
        return Slicing(element, (around,), radius, (x, y, ZERO), (x**2, y**2, ZERO, x * y, ZERO, ZERO))

    def measure(self) -> Formula:
        return Number(Fraction(2)) * PI * (self.radius or ZERO)

    def face(self) -> tuple[Formula, Formula]:
        return self.radius or ZERO, self.radius or ZERO


class Annulus(Shape, frozen=True):
    word = "annulus"
    symmetry_axis = "z"
    round = True
    walled = True
    spread = "surface"
    about = "flat disc with a round hole in its middle: `radii: {inner: r, outer: R}`"
    points = (*WHEEL, "inner", "outer")
    coordinates = ("r",)
    radii: Radii = key("radii", "inner and outer radius", limits="positive", required=True, choices=("inner", "outer"))

    def moment(self, mass: Formula) -> Formula:
        """½ M (r² + R²)."""
        inner, outer = walls(self.radii)
        return Number(Fraction(1, 2)) * mass * (inner**2 + outer**2)

    def tensor(self, mass: Formula) -> InertiaTensor:
        """¼ M (r² + R²) about a diameter."""
        inner, outer = walls(self.radii)
        return round_about("z", self.moment(mass), Number(Fraction(1, 4)) * mass * (inner**2 + outer**2))

    def slicing(self) -> Slicing:
        """Rings of width dr."""
        return rings(*walls(self.radii))

    def measure(self) -> Formula:
        inner, outer = walls(self.radii)
        return PI * (outer**2 - inner**2)

    def face(self) -> tuple[Formula, Formula]:
        return walls(self.radii)

    @property
    def outer(self) -> Formula | None:
        return walls(self.radii)[1]


class Sphere(Shape, frozen=True):
    word = "sphere"
    spherical = True
    round = True
    noun = "solid sphere"
    flat = False
    coordinates = ("r",)
    spread = "volume"
    about = "uniform solid sphere"
    points = WHEEL
    radius: Formula | None = extent("radius", "R")

    def moment(self, mass: Formula) -> Formula:
        """⅖ M R²."""
        return Number(Fraction(2, 5)) * mass * (self.radius or ZERO) ** 2

    def tensor(self, mass: Formula) -> InertiaTensor:
        """The same about every diameter."""
        return round_about("z", self.moment(mass), self.moment(mass))

    def slicing(self) -> Slicing:
        """Discs of radius √(R² − z²) and thickness dz."""
        z, radius = coordinate("z"), self.radius or ZERO
        square = radius**2 - z**2
        element = ("discs of radius ", call("sqrt", square), " and thickness d", z)
        return on_axis(element, Range(z, -radius, radius), PI * square, (square / 4, square / 4))

    def layers(self, density: Formula) -> Slicing:
        """A density that varies with the distance from the centre: thin spherical shells."""
        return spheres(ZERO, self.radius or ZERO)

    def measure(self) -> Formula:
        return Number(Fraction(4, 3)) * PI * (self.radius or ZERO) ** 3


class SphericalShell(Shape, frozen=True):
    word = "spherical shell"
    spherical = True
    round = True
    flat = False
    about = "thin-walled hollow sphere; thick-walled with `radii: {inner: r, outer: R}`"
    points = (*WHEEL, "inner", "outer")
    radius: Formula | None = extent("radius", "R")
    radii: Radii = key("radii", "inner and outer radius", limits="positive", default=(), choices=("inner", "outer"))

    def moment(self, mass: Formula) -> Formula:
        """⅔ M R² of a thin wall, ⅖ M (R⁵ − r⁵)/(R³ − r³) of a thick one."""
        if self.radii:
            inner, outer = walls(self.radii)
            return Number(Fraction(2, 5)) * mass * (outer**5 - inner**5) / (outer**3 - inner**3)
        return Number(Fraction(2, 3)) * mass * (self.radius or ZERO) ** 2

    @property
    def spread(self) -> str:  # type: ignore[override]
        return "volume" if self.radii else "surface"

    def tensor(self, mass: Formula) -> InertiaTensor:
        """The same about every diameter."""
        return round_about("z", self.moment(mass), self.moment(mass))

    def slicing(self) -> Slicing:
        """Rings of radius R sin θ round the z axis; of a thick wall thin shells of thickness dr, with ⅔ r² each."""
        if self.radii:
            return spheres(*walls(self.radii))
        theta, radius = coordinate("theta"), self.radius or ZERO
        ring, z = radius * call("sin", theta), radius * call("cos", theta)
        element = ("rings of radius ", ring, " and width ", radius, " d", theta)
        mean = ring**2 / 2
        squares = (mean, mean, z**2, ZERO, ZERO, ZERO)
        return Slicing(element, (Range(theta, ZERO, PI),), 2 * PI * radius * ring, (ZERO, ZERO, z), squares)

    def measure(self) -> Formula:
        if self.radii:
            inner, outer = walls(self.radii)
            return Number(Fraction(4, 3)) * PI * (outer**3 - inner**3)
        return Number(Fraction(4)) * PI * (self.radius or ZERO) ** 2

    @property
    def outer(self) -> Formula | None:
        return walls(self.radii)[1] if self.radii else self.radius


def rings(inner: Formula, outer: Formula) -> Slicing:
    """Rings of radius r and width dr."""
    r = coordinate("r")
    return round_axis(("rings of radius ", r, " and width d", r), Range(r, inner, outer), 2 * PI * r, r**2)


def spheres(inner: Formula, outer: Formula) -> Slicing:
    """Spherical shells of radius r and thickness dr, with x² = y² = z² = ⅓ r² on average."""
    r = coordinate("r")
    mean = Number(Fraction(1, 3)) * r**2
    element = ("spherical shells of radius ", r, " and thickness d", r)
    return round_axis(element, Range(r, inner, outer), 4 * PI * r**2, 2 * mean, mean)


def walls(radii: Radii) -> tuple[Formula, Formula]:
    """Inner and outer radius."""
    sizes = dict(radii)
    return sizes.get("inner", ZERO), sizes.get("outer", ZERO)


class Cylinder(Disc, frozen=True):
    """A disc as far as its axis is concerned."""

    word = "cylinder"
    noun = "solid cylinder"
    about = "uniform solid cylinder seen along its axis"
    spread = "volume"
    flat = False
    seen = True
    length: Formula | None = extent("length along the axis; no matter in the plane", "L")

    def tensor(self, mass: Formula) -> InertiaTensor:
        """M (3 R² + L²)/12 across the axis."""
        across = mass * (3 * (self.radius or ZERO) ** 2 + (self.length or ZERO) ** 2) / 12
        return round_about("z", self.moment(mass), across)

    def slicing(self) -> Slicing:
        """Shells of thickness dr."""
        return shells(ZERO, self.radius or ZERO, self.length or ZERO)

    def depth(self) -> Formula | None:
        return self.length

    def content(self) -> Formula:
        return self.measure() * (self.length or ZERO)


class CylindricalShell(Ring, frozen=True):
    """A ring as far as its axis is concerned, an annulus where its wall is thick."""

    word = "cylindrical shell"
    round = True
    about = "thin-walled tube seen along its axis; thick-walled with `radii: {inner: r, outer: R}`"
    points = (*WHEEL, "inner", "outer")
    flat = False
    seen = True
    coordinates = ()
    radii: Radii = key("radii", "inner and outer radius", limits="positive", default=(), choices=("inner", "outer"))
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

    def face(self) -> tuple[Formula, Formula]:
        return walls(self.radii) if self.radii else Ring(self.radius).face()

    def depth(self) -> Formula | None:
        return self.length

    def content(self) -> Formula:
        return self.measure() * (self.length or ZERO)

    @property
    def outer(self) -> Formula | None:
        return Annulus(self.radii).outer if self.radii else self.radius


def shells(inner: Formula, outer: Formula, length: Formula) -> Slicing:
    """Cylindrical shells of radius r and thickness dr, as long as the whole."""
    r = coordinate("r")
    element = ("cylindrical shells of radius ", r, " and thickness d", r)
    return round_axis(element, Range(r, inner, outer), 2 * PI * r * length, r**2, length**2 / 12)
