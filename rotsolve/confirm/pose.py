"""Pose: where all bodies are and how they move at one instant, as jets of the coordinates: x, y of a centre of mass, and the angle."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from msgspec import Struct

from rotsolve.confirm.bodies import Rigid, Spot
from rotsolve.confirm.jet import Jet, Slope, cosine, merged, sine
from rotsolve.language.bodies import PointRef

PER_BODY = 3
Pair = tuple[Jet, Jet]
Way = tuple[float, float]
EMPTY: Mapping[str, float] = {}


class Seat(Struct, frozen=True):
    """A body with the number of the first of its coordinates."""

    rigid: Rigid
    first: int

    @property
    def turn(self) -> int:
        return self.first + 2


class StringPart(Struct, frozen=True):
    """A straight part of a string: its ends, its direction where the language tells it (None: from end to end), and on which side of
    the running string the centre of a wheel at either end is: +1 right (turned clockwise), −1 left, 0 tied to a point."""

    first: PointRef
    second: PointRef
    along: Way | None
    sides: tuple[int, int]


class Pose:
    """All places, as jets, of bodies with coordinates `q` that change at the rates `speed`, at a time."""

    def __init__(
        self,
        seats: dict[str, Seat],
        q: Sequence[float],
        speed: Sequence[float],
        time: float = 0.0,
        offsets: Mapping[str, float] = EMPTY,
        origin: Sequence[float] | None = None,
    ) -> None:
        self.seats, self.q, self.speed, self.offsets = seats, q, speed, offsets
        self.time = Jet(time, 1.0)
        self.origin = (
            q if origin is None else origin
        )  # the places at the first state, from which rotation and displacement count
        self._axes: dict[str, Pair] = {}

    def coordinate(self, index: int) -> Jet:
        return Jet(self.q[index], self.speed[index], 0.0, {index: 1.0})

    def turn(self, name: str) -> Jet:
        """How far a body is turned from the way it is drawn."""
        return self.coordinate(self.seats[name].turn)

    def place(self, name: str, spot: Spot) -> Pair:
        """Where a point of a body is, x + R(θ) (spot − centre of mass)."""
        rigid, first = self.seats[name].rigid, self.seats[name].first
        x, y = self.coordinate(first), self.coordinate(first + 1)
        u, w = spot[0] - rigid.centre[0], spot[1] - rigid.centre[1]
        if u == 0.0 and w == 0.0:
            return x, y
        axes = self._axes.get(name)
        if axes is None:
            turn = self.turn(name)
            axes = self._axes[name] = (cosine(turn), sine(turn))
        c, s = axes
        return x + c * u - s * w, y + s * u + c * w

    def moved(self, name: str, spot: Spot) -> Pair:
        """How far a point of a body has come since the first state."""
        x, y = self.place(name, spot)
        first = Pose(self.seats, self.origin, self.speed).place(name, spot)
        return x - first[0].value, y - first[1].value

    def spatial(self, name: str, spot: Spot, arm: Way) -> Spot:
        """The point of a body that is just now at a distance, in space, from another of its points."""
        angle = self.q[self.seats[name].turn]
        c, s = math.cos(angle), math.sin(angle)
        return spot[0] + c * arm[0] + s * arm[1], spot[1] - s * arm[0] + c * arm[1]


def along(place: Pair, way: Way) -> Jet:
    """The component of a place along a direction that stays."""
    return place[0] * way[0] + place[1] * way[1]


def load(place: Pair, force: Way) -> Slope:
    """What a force at a place does along each coordinate: F · ∂r/∂q."""
    return merged(place[0].slope, force[0], place[1].slope, force[1])


def turned(way: Way, quarter: int = 1) -> Way:
    """The direction a quarter turn counterclockwise, or clockwise."""
    return (-way[1], way[0]) if quarter > 0 else (way[1], -way[0])


def heading(angle: float) -> Way:
    return math.cos(angle), math.sin(angle)
