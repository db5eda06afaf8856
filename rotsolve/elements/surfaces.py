"""Surfaces that bodies touch: level floor, slope, wall, corner, hollow and dome."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.heading import DOWN, LEFT, RIGHT, UP, Heading, heading
from rotsolve.scene.keys import key


@dataclass(frozen=True)
class Surface:
    """Base of all surfaces."""

    word: ClassVar[str] = ""
    about: ClassVar[str] = ""
    later: ClassVar[bool] = False
    name: str = ""

    @property
    def normal(self) -> Heading:
        """Direction out of the surface."""
        return UP

    def travel(self, moves: str | None) -> tuple[Heading, str]:
        """Direction in which a body moves along the surface for a declared word, and how to say it."""
        word = moves if moves in ("left", "right") else "right"
        return (RIGHT if word == "right" else LEFT), word


@dataclass(frozen=True)
class Level(Surface):
    word = "level"
    about = "a level surface: `floor: level`"


@dataclass(frozen=True)
class Slope(Surface):
    word = "slope"
    about = "a plane at an angle to the level, falling towards `down`"
    slope: Formula | None = key(
        "quantity", "angle to the level", dimension="angle", letter="theta", required=True, example="beta"
    )
    down: str = key("choice", "the side to which it falls", choices=("left", "right"), default="right")

    @property
    def downhill(self) -> Heading:
        angle = heading(self.slope or ZERO)
        return -angle if self.down == "right" else angle.turned(180)

    @property
    def normal(self) -> Heading:
        return self.downhill.turned(90 if self.down == "right" else -90)

    def travel(self, moves: str | None) -> tuple[Heading, str]:
        """`up` and `down` mean along the slope; so do the sides to which it rises and falls."""
        if moves == "down" or moves == self.down:
            return self.downhill, "down the slope"
        return self.downhill.turned(180), "up the slope"


@dataclass(frozen=True)
class Wall(Surface):
    word = "wall"
    about = "a vertical wall on the left or right of the scene"
    wall: str = key("choice", "the side on which it stands", choices=("left", "right"), required=True)

    @property
    def normal(self) -> Heading:
        return RIGHT if self.wall == "left" else LEFT

    def travel(self, moves: str | None) -> tuple[Heading, str]:
        word = moves if moves in ("up", "down") else "up"
        return (UP if word == "up" else DOWN), word


@dataclass(frozen=True)
class Step(Surface):
    word = "corner"
    about = "an edge that a body leans on or climbs: `step: {corner: [x, y]}`"
    later = True
    corner: tuple[Formula, Formula] | None = key("place", "where the edge is", letter="x", required=True)


@dataclass(frozen=True)
class Hollow(Surface):
    word = "hollow"
    about = "the inside of a round bowl"
    later = True
    hollow: Formula | None = key("quantity", "radius", dimension="length", letter="R", limits="positive", required=True)


@dataclass(frozen=True)
class Dome(Surface):
    word = "dome"
    about = "the outside of a round hill"
    later = True
    dome: Formula | None = key("quantity", "radius", dimension="length", letter="R", limits="positive", required=True)


@dataclass(frozen=True)
class Track(Surface):
    word = "profile unknown"
    about = "a smooth track of which only heights matter: `track: profile unknown`"
    later = True


SURFACES: tuple[type[Surface], ...] = (Level, Slope, Wall, Step, Hollow, Dome, Track)
