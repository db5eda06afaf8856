"""Shafts: a hinge on an upright shaft that turns steadily, and takes the plane of the picture with it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.facts import Turntable
from rotsolve.elements.connections.connection import Connection, Fact
from rotsolve.elements.connections.supports import reaction
from rotsolve.language.keys import key
from rotsolve.language.problem import PointRef

if TYPE_CHECKING:
    from rotsolve.motion.instant import Instant


class Shaft(Connection, frozen=True):
    word = "shaft"
    about = "hinges a point of a body to an upright shaft that turns steadily; the picture is the upright plane that turns with it"
    quantities = ("force", "angle")
    shaft: tuple[PointRef, ...] = key("points", "the point held", count=(1, 1), required=True, example="rod.start")
    turning: Formula | None = key(
        "quantity",
        "angular velocity of the shaft",
        dimension="angular velocity",
        letter="Omega",
        limits="positive",
        required=True,
        default=None,
    )
    distance: Formula | None = key(
        "quantity",
        "how far to the right of the axis the hinge is",
        dimension="length",
        letter="b",
        limits="nonnegative",
        default=None,
    )

    def fixed_points(self) -> tuple[PointRef, ...]:
        return self.shaft

    def facts(self, instant: Instant) -> Iterator[Fact]:
        yield from reaction(self.name, "hinge", self.shaft[0], instant)
        name = instant.host(self.shaft[0].owner)
        yield Turntable(self.name, name, self.turning or ZERO, self.distance or ZERO)
