"""Solid shapes that no rotation in the plane asks for yet: read and validated, then refused by name."""

from __future__ import annotations

from dataclasses import dataclass

from rotsolve.algebra.formula import Formula
from rotsolve.elements.shapes.shape import Shape, extent
from rotsolve.scene.keys import key


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
