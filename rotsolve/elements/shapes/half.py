"""Half balls, solid and hollow, seen from the side: their flat side runs along their y axis, and the round one looks along +x."""

from __future__ import annotations

from fractions import Fraction

from rotsolve.algebra.formula import PI, ZERO, Formula, Number, call
from rotsolve.core.slicing import Range, Slicing, coordinate, on_line
from rotsolve.core.vectors.tensor import InertiaTensor, round_about
from rotsolve.language.shape import Bow, Place, Shape, extent


class Hemisphere(Shape, frozen=True):
    word = "hemisphere"
    noun = "solid hemisphere"
    about = "uniform solid half ball seen from the side, symmetric about its +x axis; `center` is the ball's, on the flat side"
    symmetry_axis = "x"
    spread = "volume"
    flat = False
    radius: Formula | None = extent("radius of the ball", "R")

    def moment(self, mass: Formula) -> Formula:
        """⅖ M R² about the centre of the ball, less M (⅜ R)²."""
        return Number(Fraction(83, 320)) * mass * (self.radius or ZERO) ** 2

    def tensor(self, mass: Formula) -> InertiaTensor:
        """⅖ M R² about the axis of symmetry."""
        return round_about("x", Number(Fraction(2, 5)) * mass * (self.radius or ZERO) ** 2, self.moment(mass))

    def slicing(self) -> Slicing:
        """Discs of radius √(R² − x²) and thickness dx."""
        x, radius = coordinate("x"), self.radius or ZERO
        square = radius**2 - x**2
        element = ("discs of radius ", call("sqrt", square), " and thickness d", x)
        return on_line(element, Range(x, ZERO, radius), PI * square, (square / 4, square / 4))

    def centroid(self) -> Place:
        """⅜ R from the centre of the ball."""
        return (Number(Fraction(3, 8)) * (self.radius or ZERO), ZERO)

    def measure(self) -> Formula:
        return Number(Fraction(2, 3)) * PI * (self.radius or ZERO) ** 3

    def bow(self) -> Bow:
        return Bow(self.radius or ZERO, -PI / 2, PI / 2)


class HemisphericalShell(Hemisphere, frozen=True):
    word = "hemispherical shell"
    noun = "hemispherical shell"
    about = "thin-walled hollow half ball seen from the side, symmetric about its +x axis; `center` is the ball's"
    spread = "surface"

    def moment(self, mass: Formula) -> Formula:
        """⅔ M R² about the centre of the ball, less M (½ R)²."""
        return Number(Fraction(5, 12)) * mass * (self.radius or ZERO) ** 2

    def tensor(self, mass: Formula) -> InertiaTensor:
        """⅔ M R² about the axis of symmetry."""
        return round_about("x", Number(Fraction(2, 3)) * mass * (self.radius or ZERO) ** 2, self.moment(mass))

    def slicing(self) -> Slicing:
        """Rings of radius √(R² − x²), of which each dx has the same area 2π R dx."""
        x, radius = coordinate("x"), self.radius or ZERO
        square = radius**2 - x**2
        element = ("rings of radius ", call("sqrt", square), " and area ", 2 * PI * radius, " d", x)
        return on_line(element, Range(x, ZERO, radius), 2 * PI * radius, (square / 2, square / 2))

    def centroid(self) -> Place:
        """½ R from the centre of the ball."""
        return ((self.radius or ZERO) / 2, ZERO)

    def measure(self) -> Formula:
        return 2 * PI * (self.radius or ZERO) ** 2
