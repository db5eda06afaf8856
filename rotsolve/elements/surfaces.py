"""Surfaces that bodies touch: level floor, slope, wall, corner, hollow and dome."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from rotsolve.algebra.formula import PI, ZERO, Formula, add, call, negate
from rotsolve.core.limits import Limit
from rotsolve.core.vectors.heading import DOWN, LEFT, RIGHT, UP, Heading, heading
from rotsolve.language.bodies import Surface
from rotsolve.language.keys import amount, key


def key_of_bearer() -> Any:
    """The key of a surface that is a side of a body, and goes with it."""
    help = "the body of which it is a side, and with which it goes; without it, it is fixed"
    return key("name", help, default=None, refers=("body",), plane=True, example="block")


class Level(Surface, frozen=True):
    word = "level"
    about = "a level surface: `floor: level`"
    spatial = True
    level = True
    away = "up"
    into = "down"


class Slope(Surface, frozen=True):
    word = "slope"
    spatial = True
    slanted = True
    away = "perpendicular to the slope"
    about = "a plane at an angle to the level, falling towards `down`"
    slope: Formula | None = amount("angle to the level", "angle", "theta", "acute", required=True, example="30 deg")
    down: str = key("choice", "the side to which it falls", choices=("left", "right"), default="right")
    of: str | None = key_of_bearer()

    def tilt(self) -> Formula | None:
        return self.slope

    def bearer(self) -> str:
        return self.of or ""

    @property
    def downhill(self) -> Heading:
        angle = heading(self.slope or ZERO)
        return -angle if self.down == "right" else angle.turned(180)

    @property
    def normal(self) -> Heading:
        return self.downhill.turned(90 if self.down == "right" else -90)

    def ways(self) -> tuple[str, ...]:
        return ("up", "down", "left", "right")

    def travel(self, moves: str | None) -> tuple[Heading, str]:
        """`up` and `down` mean along the slope; so do the sides to which it rises and falls."""
        if moves == "down" or moves == self.down:
            return self.downhill, "down the slope"
        return self.downhill.turned(180), "up the slope"


class Wall(Surface, frozen=True):
    word = "wall"
    about = "a vertical wall on the left or right of the scene"
    upright = True
    wall: str = key("choice", "the side on which it stands", choices=("left", "right"), required=True)

    @property
    def normal(self) -> Heading:
        return RIGHT if self.wall == "left" else LEFT

    def ways(self) -> tuple[str, ...]:
        return ("up", "down")

    def travel(self, moves: str | None) -> tuple[Heading, str]:
        word = moves if moves in ("up", "down") else "up"
        return (UP if word == "up" else DOWN), word


class Curved(Surface, frozen=True):
    """Base of surfaces round which a body travels: its place is the angle of the touching radius, from the rightward horizontal."""

    curved = True
    outside: ClassVar[bool] = True

    def radius(self) -> Formula | None:
        """Radius of the surface; None where it is not known."""
        return None

    def facing(self, angle: Heading) -> Heading:
        """Direction out of the surface where the touching radius has an angle."""
        return angle if self.outside else angle.turned(180)

    def circle(self, rim: Formula) -> Formula | None:
        """Radius of the circle on which the centre of a body with a rim moves: R + r outside, R − r inside."""
        radius = self.radius()
        return None if radius is None else add(radius, rim if self.outside else negate(rim))

    def base(self, circle: Formula) -> Formula:
        """Height of the circle's centre above the level from which heights count: the lowest place in a bowl, else that centre."""
        return ZERO if self.outside else circle

    def way(self, moves: str | None) -> int:
        """Sense of the positive travel: right over the top of a hill is clockwise, right through the bottom of a bowl is not."""
        right = -1 if self.outside else 1
        return -right if moves == "left" else right

    def rooms(self, name: str, rim: Formula, flat: bool) -> Iterator[Limit]:
        """Lengths that must be positive for a body to fit; a corner is as high as it may be above no floor."""
        circle, height = self.circle(rim), self.height()
        if circle is not None and not self.outside:
            yield Limit(circle, f"`{name}` does not fit into `{self.name}`", strict=True)
        if flat and height is not None:
            yield Limit(rim - height, f"`{name}` is too small to climb `{self.name}`", strict=True)

    def met(self, rim: Formula) -> Formula | None:
        """Angle at which a wheel on the level floor touches it, where that is settled by its place."""
        return None


class Corner(Curved, frozen=True):
    """A corner is a hill of no radius: the centre of a wheel on it moves on a circle as large as the wheel."""

    word = "corner"
    held_at = "corner"
    about = "an edge at a height above the floor, which a wheel climbs or rolls off: `step: {corner: h, side: right}`"
    corner: Formula | None = amount(
        "height of the edge above the floor", "length", "h", "positive", required=True, example="10 cm"
    )
    side: str = key("choice", "the side of the wheel on which it is", choices=("left", "right"), default="right")

    def radius(self) -> Formula | None:
        return ZERO

    def height(self) -> Formula | None:
        return self.corner

    def met(self, rim: Formula) -> Formula | None:
        """The corner is h above the floor and so r − h below the wheel's centre."""
        rise = call("asin", (rim - (self.corner or ZERO)) / rim)
        return rise if self.side == "left" else add(PI, negate(rise))


class Hollow(Curved, frozen=True):
    word = "hollow"
    away = "towards the centre"
    into = "away from the centre"
    about = "the inside of a round bowl or loop"
    outside = False
    hollow: Formula | None = amount("radius", "length", "R", "positive", required=True)
    of: str | None = key_of_bearer()

    def radius(self) -> Formula | None:
        return self.hollow

    def bearer(self) -> str:
        return self.of or ""


class Wire(Curved, frozen=True):
    word = "wire"
    away = "towards the centre"
    into = "away from the centre"
    about = "a round wire on which a bead is threaded, so that it is held on both sides"
    outside = False
    two_sided = True
    wire: Formula | None = amount("radius", "length", "R", "positive", required=True)
    of: str | None = key_of_bearer()

    def radius(self) -> Formula | None:
        return self.wire

    def bearer(self) -> str:
        return self.of or ""


class Dome(Curved, frozen=True):
    word = "dome"
    away = "outward"
    into = "towards the centre"
    about = "the outside of a round hill"
    dome: Formula | None = amount("radius", "length", "R", "positive", required=True)
    of: str | None = key_of_bearer()

    def radius(self) -> Formula | None:
        return self.dome

    def bearer(self) -> str:
        return self.of or ""


class Post(Surface, frozen=True):
    word = "post"
    about = "a fixed rough post, peg or beam round which a rope runs: `bollard: post`"
    post = True

    def ways(self) -> tuple[str, ...]:
        return ()


class Track(Curved, frozen=True):
    word = "profile unknown"
    about = "a smooth track of which only heights matter: `track: profile unknown`"
