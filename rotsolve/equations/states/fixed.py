"""Fixed: the letters that take their values from what a scene states, and stand in no equation after that."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.registry import SEPARATOR, Registry
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.instant import Instant


class Fixed(Struct, frozen=True):
    """Enters values into the registry; every instant is made anew, since it puts in what is fixed by then."""

    configuration: Configuration
    registry: Registry
    modes: Mapping[str, str]

    def instant(self, state: str, *, generic: bool = False) -> Instant:
        return Instant(self.configuration, self.registry, state, generic, self.modes)

    def fix(self, letter: Formula, value: Formula) -> None:
        """Give a letter its value; what is no letter of the laws is known already."""
        if isinstance(letter, Symbol) and SEPARATOR in letter.name and letter != value:
            self.registry.known[letter.name] = value

    def rates(self, instant: Instant, name: str) -> list[Formula]:
        """The velocity letters of a body at an instant."""
        motion, line = instant.motion(name), instant.line(name)
        rates: list[Formula] = []
        if motion.kind == "line":
            rates.append(instant.travel("velocity", name, line[1] if line else ""))
        elif motion.kind == "plane":
            rates += [instant.component("velocity", name, axis) for axis in "xy"]
        if motion.turns:
            rates.append(instant.rate("angular_velocity", name))
        return rates
