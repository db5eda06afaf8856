"""Rows: what a connection holds, as one linear equation of the rates, one of the accelerations, and one reaction; and what may slip."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.confirm.jet import Jet, Slope
from rotsolve.confirm.pose import Pose

EDGE = "edge"  # the kind of what is near an end of a round side


class Row(Struct, frozen=True):
    """slope · q̇ = speed and slope · q̈ = bend, kept up by a reaction λ that acts along `column` on the coordinates.

    `gap` is by how much the places miss, where that matters (`hard`); a `push` can only be positive, as a normal force or a tension.
    `most` is how large all reactions of its owner that have one may be together, as one vector.
    `edge` is how far what touches there is from touching with an end of its round side, as a difference of cosines.
    `loose` marks what holds in places but not in rates: it only says where things are; a
    `speed` or `bend` of None, what tells accelerations alone, or rates alone.
    """

    owner: str
    kind: str
    slope: Slope
    speed: float | None
    bend: float | None
    column: Slope
    gap: float = 0.0
    hard: bool = False
    push: bool = False
    loose: bool = False
    most: float | None = None
    edge: float | None = None

    @property
    def key(self) -> tuple[str, str]:
        return self.owner, self.kind


class Grip(Struct, frozen=True):
    """What sticks (`row` holds, with a reaction of limited size) or slips: limit = coefficient · reaction of `normal`, or a size.

    `static` None is rough enough for anything; `name` is what its mode goes by.
    """

    name: str
    row: Row
    static: float | None
    kinetic: float | None
    normal: tuple[str, str] | None = None


def held(
    owner: str, kind: str, jet: Jet, pose: Pose, *, hard: bool = False, push: bool = False, pull: bool = False
) -> Row:
    """A function of the places (and of time) that stays as it is; a `pull` acts against its slope, as the tension of a string does."""
    own = sum([part * pose.speed[index] for index, part in jet.slope.items()])
    column = {index: -part for index, part in jet.slope.items()} if pull else jet.slope
    return Row(owner, kind, jet.slope, own - jet.rate, -jet.bend, column, jet.value, hard, push or pull)


def unknown(owner: str, kind: str, column: Slope) -> Row:
    """A force as large as it likes, that holds nothing."""
    return Row(owner, kind, {}, 0.0, 0.0, column)
