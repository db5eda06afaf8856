"""Contact: a body lies on, slides along or rolls on something, with the friction that the scene gives."""

from __future__ import annotations

from rotsolve.algebra.formula import Formula
from rotsolve.elements.connections.contacts.friction import Friction
from rotsolve.elements.connections.contacts.touch import Touch
from rotsolve.language.keys import key
from rotsolve.language.problem import PointRef


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
