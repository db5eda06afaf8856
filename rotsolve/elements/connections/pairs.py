"""Pairs: what holds a body in space beside a hinge or an axle: balls, clamps, slides, sleeves and screws, the lower pairs of mechanisms."""

from __future__ import annotations

from typing import ClassVar

from rotsolve.algebra.formula import Formula
from rotsolve.elements.connections.supports import Axis, carrier_and_point
from rotsolve.language.bodies import Coupling, Joint, PointRef
from rotsolve.language.elements import Connection
from rotsolve.language.keys import amount, key

HELD = "the point held, or [carrier, body]"
Direction = tuple[Formula, Formula, Formula]


class LowerPair(Connection, frozen=True):
    """Base of what lets a body of a scene in space move in some ways only."""

    quantities: ClassVar[tuple[str, ...]] = ("force", "torque", "impulse", "angular_impulse", "freedoms")
    planar = False
    spatial = True

    def ways(self) -> tuple[PointRef, PointRef]:
        """What carries the body, and the point held."""
        return carrier_and_point(getattr(self, self.word))


class Ball(LowerPair, frozen=True):
    word = "ball"
    about = "holds a point of a body in place; the body turns about it in space"
    ball: tuple[PointRef, ...] = key("points", HELD, count=(1, 2), required=True, example="top.tip")

    def joint_in_space(self) -> Joint:
        return Joint(self.name, *self.ways(), free=True)


class Clamp(LowerPair, frozen=True):
    word = "clamp"
    about = "holds a point of a body and its direction, or makes it one with another body"
    clamp: tuple[PointRef, ...] = key("points", HELD, count=(1, 2), required=True, example="beam.start")

    def joint_in_space(self) -> Joint:
        return Joint(self.name, *self.ways())


class Along(LowerPair, frozen=True):
    """Base of the pairs that have a direction."""

    along: Axis = key("axis in space", "its direction, in the axes of what carries it", required=True, example="z")

    @property
    def direction(self) -> Direction:
        x, y, z = self.along
        return (x, y, z)


class Slide(Along, frozen=True):
    word = "slide"
    about = "a prismatic pair: the body slides along a direction and does not turn"
    slide: tuple[PointRef, ...] = key("points", HELD, count=(1, 2), required=True, example="piston")

    def joint_in_space(self) -> Joint:
        return Joint(self.name, *self.ways(), sliding=(self.direction,))


class Collar(Along, frozen=True):
    word = "collar"
    about = "a ball on a guide: the point held slides along a line, and the body turns about it in space"
    collar: tuple[PointRef, ...] = key("points", HELD, count=(1, 2), required=True, example="bar.start")

    def joint_in_space(self) -> Joint:
        return Joint(self.name, *self.ways(), sliding=(self.direction,), free=True)


class Sleeve(Along, frozen=True):
    word = "sleeve"
    about = "a cylindrical pair: the body slides along an axis and turns about it"
    sleeve: tuple[PointRef, ...] = key("points", HELD, count=(1, 2), required=True, example="collar")

    def joint_in_space(self) -> Joint:
        return Joint(self.name, *self.ways(), turning=(self.direction,), sliding=(self.direction,))


class Screw(Along, frozen=True):
    word = "screw"
    about = "a screw pair: the body turns about an axis and goes `pitch` along it in one turn"
    screw: tuple[PointRef, ...] = key("points", HELD, count=(1, 2), required=True, example="nut")
    pitch: Formula | None = amount("way along the axis in one turn", "length", "p", required=True, example="2 mm")

    def joint_in_space(self) -> Joint:
        return Joint(self.name, *self.ways(), turning=(self.direction,), sliding=(self.direction,), pitch=self.pitch)


class Universal(Connection, frozen=True):
    """Hooke's joint: ω₂ (1 − (c · n₂)²) = ω₁ n₁ · n₂, c along the arm in the fork of the first shaft."""

    word = "universal"
    about = "Hooke's joint between two shafts at an angle, each on a `hinge` of its own: it passes on a couple, and no force"
    quantities: ClassVar[tuple[str, ...]] = ("torque",)
    planar = False
    spatial = True
    universal: tuple[PointRef, ...] = key("points", "the two shafts", count=(2, 2), required=True, example="[one, two]")
    along: Axis = key(
        "axis in space", "the arm of the cross in the first shaft, in the axes of that", required=True, example="z"
    )

    def coupling_in_space(self) -> Coupling:
        (first, second), (x, y, z) = self.universal, self.along
        return Coupling(self.name, first, second, (x, y, z))
