"""Contacts: a body that lies, slides or rolls on a surface with the friction that the scene gives; a roll that lays itself out."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula
from rotsolve.core.facts import Rule
from rotsolve.core.vectors.heading import Vector
from rotsolve.elements.connections.connection import Fact
from rotsolve.elements.connections.touch import Friction, Touch
from rotsolve.elements.surfaces import Surface
from rotsolve.language.keys import key
from rotsolve.language.problem import Body, PointRef

if TYPE_CHECKING:
    from rotsolve.motion.configuration import Configuration
    from rotsolve.motion.instant import Instant


class Contact(Touch, frozen=True):
    word = "contact"
    about = "a body lies on, slides along or rolls on a surface or on a body that travels; or a wheel rubs on another, both on fixed axles"
    contact: tuple[PointRef, ...] = key(
        "points", "[body, surface, …]", count=(2, 10), required=True, example="[block, ramp]"
    )
    friction: Friction = key(
        "friction",
        "`none`, a coefficient, {static: , kinetic: }, or `any`",
        default=Friction(),
        letter="mu",
        limits="nonnegative",
    )
    press: Formula | None = key(
        "quantity",
        "force that presses two wheels together at their rims",
        dimension="force",
        letter="F",
        limits="positive",
        default=None,
    )

    def pair(self) -> tuple[PointRef, ...]:
        return self.contact

    def grip(self) -> Friction:
        return self.friction


class Rolls(Touch, frozen=True):
    word = "rolls"
    about = "a wheel rolls without slipping on a surface, on several that join smoothly, or on a body that travels"
    rolls: tuple[PointRef, ...] = key(
        "points", "[wheel, surface, …]", count=(2, 10), required=True, example="[ball, floor]"
    )

    def pair(self) -> tuple[PointRef, ...]:
        return self.rolls

    def grip(self) -> Friction:
        return Friction("any")


class Unrolls(Touch, frozen=True):
    word = "unrolls"
    about = "a roll, of a carpet say, lays itself out on a level surface; a state says how large its `radius` is still"
    quantities = ("force", "normal_force", "friction_force", "torque")
    words = ()
    unrolls: tuple[PointRef, ...] = key(
        "points", "[roll, surface]", count=(2, 2), required=True, example="[carpet, floor]"
    )

    def pair(self) -> tuple[PointRef, ...]:
        return self.unrolls

    def grip(self) -> Friction:
        return Friction("any")

    def lays(self, body: Body) -> bool:
        return self.unrolls[0].owner == body.name

    def pace(self, configuration: Configuration, state: str) -> str:
        return "position"

    def friction_facts(
        self, instant: Instant, name: str, arm: Vector, surface: Surface, normal: Formula
    ) -> Iterator[Fact]:
        """As of a wheel that rolls, with v = r ω at any moment; for accelerations there is no such rule, since r changes."""
        for fact in super().friction_facts(instant, name, arm, surface, normal):
            yield replace(fact, acceleration=None, linear=False) if isinstance(fact, Rule) else fact
