"""Springs and torsion springs."""

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
class Spring(Connection):
    word = "spring"
    about = "an ideal spring between two points"
    quantities = ("force", "elongation", "potential_energy", "work", "power", "length", "stiffness")
    spring: tuple[PointRef, ...] = key("points", "its two ends", count=(2, 2), required=True, example="[ground, block]")
    stiffness: Formula | None = key("quantity", "stiffness", dimension="stiffness", letter="k", limits="positive", default=None)
    rest_length: Formula | None = key("quantity", "length without force", dimension="length", letter="L", limits="nonnegative", default=None)


@dataclass(frozen=True)
class Torsion(Connection):
    word = "torsion"
    about = "a torsion spring or wire that turns a body back"
    quantities = ("torque", "potential_energy", "work", "power", "angle")
    torsion: tuple[PointRef, ...] = key("points", "the body, or two bodies", count=(1, 2), required=True, example="disc")
    stiffness: Formula | None = key(
        "quantity", "torque per angle", dimension="torsional stiffness", letter="kappa", limits="positive", default=None
    )
    rest_angle: Formula | None = key("quantity", "angle without torque", dimension="angle", letter="theta", default=None)
