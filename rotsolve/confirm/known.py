"""Known: what parts of the assembly see of the model of a scene: numbers, bodies with coordinates, what acts, which way is positive."""

from __future__ import annotations

from typing import NamedTuple, Protocol

from rotsolve.algebra.formula import Formula
from rotsolve.confirm.bodies import Spot
from rotsolve.confirm.inforce import InForce
from rotsolve.confirm.jet import Jet
from rotsolve.confirm.pose import Pair, Pose, Seat, Way
from rotsolve.elements.connections.strings import String
from rotsolve.language.bodies import Body, PointRef, Surface
from rotsolve.language.problem import Problem


class StringPart(NamedTuple):
    """A straight part of a string: its ends, its direction where the language tells it (None: from end to end), and on which side of
    the running string the centre of a wheel at either end is: +1 right (turned clockwise), −1 left, 0 tied to a point."""

    first: PointRef
    second: PointRef
    along: Way | None
    sides: tuple[int, int]


class Known(Protocol):
    """A model as its parts see it."""

    problem: Problem
    acting: InForce
    surfaces: dict[str, Surface]
    seats: dict[str, Seat]
    size: int
    gravity: float
    upright: bool
    held: dict[str, tuple[str, PointRef]]

    @property
    def masses(self) -> list[float]: ...
    @property
    def hung(self) -> frozenset[str]: ...
    @property
    def guided(self) -> tuple[str, ...]: ...
    @property
    def unions(self) -> list[tuple[str, str]]: ...

    def value(self, formula: Formula) -> float: ...
    def running(self, formula: Formula, pose: Pose) -> Jet | float: ...
    def now(self, formula: Formula, pose: Pose) -> float: ...
    def body(self, name: str) -> Body: ...
    def line(self, name: str) -> Way | None: ...
    def sense(self, name: str) -> int: ...
    def legs(self, item: String) -> list[StringPart]: ...
    def bodily(self, refs: tuple[PointRef, ...]) -> bool: ...
    def told_apart(self, first: str, second: str) -> float | None: ...
    def lean(self, name: str) -> float: ...
    def axis(self, name: str) -> Spot: ...
    def spot(self, ref: PointRef) -> Spot: ...
    def drawn(self, ref: PointRef) -> Spot: ...
    def place(self, ref: PointRef, pose: Pose) -> Pair: ...
