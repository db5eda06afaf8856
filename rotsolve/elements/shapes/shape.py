"""Shape: base of all shapes: how mass is spread. A size that the scene leaves out is None."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.scene.keys import key

Place = tuple[Formula, Formula]
WHEEL: tuple[str, ...] = ("center", "rim", "top", "bottom")


def extent(help: str, letter: str) -> Formula | None:
    """The field of a length that a shape has."""
    declared: Formula | None = key("quantity", help, dimension="length", letter=letter, limits="positive", default=None)
    return declared


@dataclass(frozen=True)
class Shape:
    """Base of all shapes. `points` are the names of its points, beside `cm` and those that the scene names."""

    word: ClassVar[str] = ""
    about: ClassVar[str] = ""
    points: ClassVar[tuple[str, ...]] = ("center",)
    later: ClassVar[bool] = False
    rigid: ClassVar[bool] = True  # whether it keeps its form, so that it has a moment of inertia

    def moment(self, mass: Formula) -> Formula:
        """Moment of inertia about the centre of mass, axis square to the plane."""
        return ZERO

    def slender(self, mass: Formula) -> Formula | None:
        """∫ (x² − y²) dm about the centre of mass, x and y along the axes of symmetry; 0 for round shapes, None where it is not told."""
        return ZERO if "rim" in self.points else None

    def centroid(self) -> Place:
        """Centre of mass in the body's axes."""
        return (ZERO, ZERO)

    def measure(self) -> Formula:
        """Length, area or volume, by which a uniform density is multiplied."""
        raise NotImplementedError(f"a {self.word} has no extent")

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        """Place of a named point in the body's axes; a round body's rim points are directions in space, hence not here."""
        return (ZERO, ZERO)

    @property
    def outer(self) -> Formula | None:
        """Radius of the rim of a round shape."""
        return getattr(self, "radius", None)
