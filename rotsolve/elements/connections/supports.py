"""Supports: hinges, axles and welds hold bodies to the ground or to each other."""

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
class Driven(Connection):
    """Base of what turns a body by itself: a rate given as a value or a formula of `time`."""

    friction_torque: Formula | None = key(
        "quantity", "friction torque, against the motion", dimension="torque", letter="tau", limits="nonnegative", default=None
    )
    angle: Formula | None = key("quantity", "driven angle", dimension="angle", letter="theta", varies=True, default=None)
    angular_velocity: Formula | None = key(
        "quantity", "driven angular velocity", dimension="angular velocity", letter="omega", varies=True, default=None
    )
    angular_acceleration: Formula | None = key(
        "quantity", "driven angular acceleration", dimension="angular acceleration", letter="alpha", varies=True, default=None
    )


@dataclass(frozen=True)
class Hinge(Driven):
    """A point of a body held to the ground, or to a point of another body; it turns freely about it."""

    word = "hinge"
    about = "holds a point of a body to the ground, or to a point of another body; the body turns freely about it"
    quantities = ("force", "torque", "angle", "angular_velocity", "angular_acceleration", "impulse", "work", "power")
    hinge: tuple[PointRef, ...] = key("points", "the point held, or [carrier, body]", count=(1, 2), required=True, example="rod.start")
    along: tuple[Formula, ...] = key("vector", "direction of the axis, in space", default=(), later=True)


@dataclass(frozen=True)
class Axle(Driven):
    word = "axle"
    about = "a fixed axis through the centre of a wheel, or of several that turn freely on it"
    quantities = ("force", "torque", "angle", "angular_velocity", "angular_acceleration", "impulse", "work", "power")
    axle: tuple[PointRef, ...] = key("points", "the wheel, or wheels", count=(1, 20), required=True, example="disc")


@dataclass(frozen=True)
class Ball(Connection):
    word = "ball"
    about = "holds a point of a body in place; the body turns about it in space"
    quantities = ("force", "impulse")
    later = True
    ball: tuple[PointRef, ...] = key("points", "the point held, or [carrier, body]", count=(1, 2), required=True, example="top.tip")


@dataclass(frozen=True)
class Clamp(Connection):
    word = "clamp"
    about = "holds a point of a body and its direction"
    quantities = ("force", "torque")
    later = True
    clamp: tuple[PointRef, ...] = key("points", "the point held, or [carrier, body]", count=(1, 2), required=True, example="beam.start")


@dataclass(frozen=True)
class Weld(Connection):
    word = "weld"
    about = "makes two bodies one"
    quantities = ("force", "torque")
    weld: tuple[PointRef, ...] = key("points", "the two bodies", count=(2, 2), required=True, example="[drum, rod.end]")


@dataclass(frozen=True)
class Rides(Connection):
    word = "rides"
    about = "a body slides along another and turns with it"
    quantities = ("force", "normal_force", "work", "power")
    later = True
    rides: tuple[PointRef, ...] = key("points", "[bead, bar]", count=(2, 2), required=True, example="[bead, bar]")
