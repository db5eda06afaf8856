"""Thin shapes: a particle, a rod, an arc of wire."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from rotsolve.algebra.formula import ZERO, Formula, Number, call
from rotsolve.elements.shapes.shape import Place, Shape, extent
from rotsolve.scene.keys import key


@dataclass(frozen=True)
class Particle(Shape):
    word = "particle"
    about = "all mass in one point; with `radius`, so far from its `center`, round which it goes on an axle or on what it rides"
    radius: Formula = key(
        "quantity",
        "distance from the centre of its circle",
        dimension="length",
        letter="r",
        limits="positive",
        default=ZERO,
    )

    def centroid(self) -> Place:
        return (self.radius, ZERO)

    @property
    def outer(self) -> Formula | None:
        """A particle has no rim."""
        return None

    def slender(self, mass: Formula) -> Formula | None:
        return ZERO


@dataclass(frozen=True)
class Rod(Shape):
    word = "rod"
    about = "thin uniform rod; `rod.at(x)` is the point at x from its start"
    points = ("start", "center", "end")
    length: Formula | None = extent("length", "L")

    def moment(self, mass: Formula) -> Formula:
        """M L²/12."""
        return Number(Fraction(1, 12)) * mass * self.extent() ** 2

    def slender(self, mass: Formula) -> Formula | None:
        """M L²/12: all of it lies along x."""
        return self.moment(mass)

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
class Rope(Shape):
    word = "rope"
    about = "uniform heavy rope or chain that bends freely; `drapes` says what it hangs over"
    points = ()
    rigid = False
    length: Formula | None = extent("length", "L")


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
        """M (R² − x²), x the centre of mass from the circle's centre: M R² about that centre, less M x²."""
        radius, (x, _) = self.radius or ZERO, self.centroid()
        return mass * (radius**2 - x**2)

    def centroid(self) -> Place:
        """R sin(θ/2)/(θ/2) from the circle's centre, along the axis of symmetry."""
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
