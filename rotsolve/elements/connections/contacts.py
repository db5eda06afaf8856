"""Contacts: a body on a surface, with or without friction, sliding or rolling."""

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
class Friction:
    """Friction of a contact: `none`, one coefficient, static and kinetic, or `any` (rough enough; the engine decides)."""

    kind: str = "none"  # none | coefficient | any
    static: Formula | None = None
    kinetic: Formula | None = None


@dataclass(frozen=True)
class Contact(Connection):
    word = "contact"
    about = "a body lies on, slides along or rolls on a surface or another body"
    quantities = ("force", "normal_force", "friction_force", "friction", "torque", "angle", "work", "power", "impulse")
    words = ("rolls", "slips", "leaves", "sticks")
    contact: tuple[PointRef, ...] = key("points", "[body, surface]", count=(2, 2), required=True, example="[block, ramp]")
    friction: Friction = key(
        "friction", "`none`, a coefficient, {static: , kinetic: }, or `any`", default=Friction(), letter="mu", limits="nonnegative"
    )


@dataclass(frozen=True)
class Rolls(Connection):
    word = "rolls"
    about = "a wheel rolls without slipping on a surface, or on several that join smoothly"
    quantities = ("force", "normal_force", "friction_force", "friction", "torque", "angle", "work", "power", "impulse")
    words = ("rolls", "slips", "leaves", "sticks")
    rolls: tuple[PointRef, ...] = key("points", "[wheel, surface, …]", count=(2, 10), required=True, example="[ball, floor]")
