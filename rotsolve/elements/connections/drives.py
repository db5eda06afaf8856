"""Drives: belts and gears carry rotation from wheel to wheel."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import Formula
from rotsolve.core.facts import Couple, Force, Requirement, Rule
from rotsolve.elements.connections.connection import Connection, Fact
from rotsolve.scene.keys import key
from rotsolve.scene.model import PointRef

if TYPE_CHECKING:
    from rotsolve.motion.instant import Instant



@dataclass(frozen=True)
class Belt(Connection):
    word = "belt"
    about = "a belt or chain round two wheels: they turn the same way, or opposite ways when it is crossed"
    quantities = ("tension", "force", "power", "work")
    belt: tuple[PointRef, ...] = key("points", "the wheels or rims", count=(2, 10), required=True, example="[motor, drum.big]")
    crossed: bool = key("flag", "the belt crosses between the wheels", default=False)


@dataclass(frozen=True)
class Gear(Connection):
    word = "gear"
    about = "two toothed or rubbing wheels: they turn opposite ways without slip"
    quantities = ("force", "torque", "power", "work", "impulse")
    gear: tuple[PointRef, ...] = key("points", "the two wheels or rims", count=(2, 2), required=True, example="[small, large]")
    inside: bool = key("flag", "the first wheel runs inside the second: both turn the same way", default=False)
