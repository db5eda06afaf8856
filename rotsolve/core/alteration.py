"""Alteration: what is changed on purpose in the facts and equations of a scene, such as the mistake of a student."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from msgspec import Struct

from rotsolve.core.equation import Equation
from rotsolve.core.facts import Facts
from rotsolve.core.passage import Encounter


class Alteration(Struct, frozen=True):
    """Other facts at every moment, other laws through an event, and another equation for each one (None leaves it out)."""

    facts: Callable[[Facts], Facts] | None = None
    event: Callable[[Encounter, str], Iterable[Equation]] | None = None
    equation: Callable[[Equation], Equation | None] | None = None

    def rewritten(self, equations: Iterable[Equation]) -> list[Equation]:
        """The equations as they are changed, without those that are left out."""
        if self.equation is None:
            return list(equations)
        return [changed for one in equations if (changed := self.equation(one)) is not None]
