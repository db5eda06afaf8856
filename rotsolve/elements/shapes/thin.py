"""Thin shapes: a particle, a rod, an arc of wire."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import PI, ZERO, Formula, Number, call
from rotsolve.core.limits import Limit
from rotsolve.core.vectors.tensor import InertiaTensor
from rotsolve.core.vectors.tensor import Place as Spot
from rotsolve.language.keys import amount
from rotsolve.language.shape import Bow, Place, Shape, extent

if TYPE_CHECKING:
    from rotsolve.core.slicing import Slicing


class Particle(Shape, frozen=True):
    word = "particle"
    backed = True
    pointlike = True
    about = "all mass in one point; with `radius`, so far from its `center`, round which it goes on an axle or on what it rides"
    radius: Formula = amount("distance from the centre of its circle", "length", "r", "positive", default=ZERO)

    def centroid(self) -> Place:
        return (self.radius, ZERO)

    @property
    def outer(self) -> Formula | None:
        """A particle has no rim."""
        return None


class Rod(Shape, frozen=True):
    word = "rod"
    symmetry_axis = "x"
    backed = True
    about = "thin uniform rod; `rod.at(x)` is the point at x from its start"
    points = ("start", "center", "end")
    spread = "line"
    slender = True
    coordinates = ("x",)
    length: Formula | None = extent("length", "L")

    def moment(self, mass: Formula) -> Formula:
        """M L²/12."""
        return Number(Fraction(1, 12)) * mass * self.extent() ** 2

    def tensor(self, mass: Formula) -> InertiaTensor:
        """Along x: M L²/12 about y and z, nothing about itself."""
        return InertiaTensor(yy=self.moment(mass), zz=self.moment(mass))

    def slicing(self) -> Slicing:
        """Pieces of length dx, x from the start."""
        from rotsolve.core.slicing import Range, coordinate, on_line

        x = coordinate("x")
        return replace(
            on_line(("pieces of length d", x), Range(x, ZERO, self.extent())), origin=self.begin(), at="start"
        )

    def begin(self) -> Spot:
        return (-self.extent() / 2, ZERO, ZERO)

    def measure(self) -> Formula:
        return self.extent()

    def extent(self) -> Formula:
        return self.length or ZERO

    def reach(self) -> Formula | None:
        return self.length

    def outline(self) -> tuple[Place, ...]:
        return (self.locate("start"), self.locate("end"))

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        half = halved(self.extent())
        if point == "at" and argument is not None:
            return (argument - half, ZERO)
        return ({"start": -half, "end": half}.get(point, ZERO), ZERO)


def halved(whole: Formula) -> Formula:
    """L/2 as it is, and of 2 a just a."""
    return min((whole / 2, simplify(whole / 2)), key=length)


class Rope(Shape, frozen=True):
    word = "rope"
    about = "uniform heavy rope or chain that bends freely; `drapes` says what it hangs over"
    points = ()
    rigid = False
    length: Formula | None = extent("length", "L")


class Arc(Shape, frozen=True):
    word = "arc"
    about = "thin uniform wire along an arc of a circle, symmetric about its +x axis; `center` is the circle's"
    points = ("center", "start", "middle", "end")
    spread = "line"
    coordinates = ("phi",)
    radius: Formula | None = extent("radius of the circle", "R")
    opening: Formula | None = amount(
        "angle that the arc spans", "angle", "theta", "positive", default=None, required=True
    )

    def rooms(self) -> Iterator[Limit]:
        if self.opening is not None:
            yield Limit(2 * PI - self.opening, "an arc goes once round at most")

    def moment(self, mass: Formula) -> Formula:
        """M (R² − x²), x the centre of mass from the circle's centre: M R² about that centre, less M x²."""
        radius, (x, _) = self.radius or ZERO, self.centroid()
        return mass * (radius**2 - x**2)

    def tensor(self, mass: Formula) -> InertiaTensor:
        """½ M R² (1 ∓ sin θ/θ) about the circle's x and y axes, the second less M x² of the centre of mass."""
        radius, opening, (x, _) = self.radius or ZERO, self.opening or ZERO, self.centroid()
        half, share = mass * radius**2 / 2, call("sin", opening) / opening
        return InertiaTensor(half * (1 - share), half * (1 + share) - mass * x**2, self.moment(mass))

    def slicing(self) -> Slicing:
        """Pieces of length R dφ, φ from the axis of symmetry."""
        from rotsolve.core.slicing import Range, Slicing, coordinate

        phi, radius, half = coordinate("phi"), self.radius or ZERO, simplify((self.opening or ZERO) / 2)
        x, y = radius * call("cos", phi), radius * call("sin", phi)
        element = ("pieces of length ", radius, " d", phi)
        return Slicing(element, (Range(phi, -half, half),), radius, (x, y, ZERO), (x**2, y**2, ZERO, x * y, ZERO, ZERO))

    def centroid(self) -> Place:
        """R sin(θ/2)/(θ/2) from the circle's centre, along the axis of symmetry."""
        radius, half = self.radius or ZERO, (self.opening or ZERO) / 2
        return (radius * call("sin", half) / half, ZERO)

    def measure(self) -> Formula:
        return (self.radius or ZERO) * (self.opening or ZERO)

    def bow(self) -> Bow:
        half = (self.opening or ZERO) / 2
        return Bow(self.radius or ZERO, -half, half)

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        radius, half = self.radius or ZERO, (self.opening or ZERO) / 2
        side = {"start": -half, "end": half}.get(point)
        if side is None:
            return (radius if point == "middle" else ZERO, ZERO)
        return (radius * call("cos", side), radius * call("sin", side))
