"""Rubs: all that can stick or slip in a scene: contacts, two bodies that rub on each other, wheels on rubbing axles and under brakes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.core.symbols import rub_key
from rotsolve.language.elements import Connection

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.motion.configuration import Configuration
    from rotsolve.motion.instant import Instant

FORWARD, BACK, STICKS = "slips", "slips back", "sticks"
TURNS_BACK, HOLDS = "turns back", "holds"
AT_MOST = " at most"  # a trial with as much friction as there can be before it slips


class Rub(Struct, frozen=True):
    """A contact, two bodies that rub on each other, or a wheel on a rubbing axle or under a brake, in the phase that starts at a state."""

    owner: str  # the element that rubs
    body: str
    state: str
    contact: Connection | None = None
    pair: Connection | None = None  # two bodies that slip on each other

    def mode(self, sense: int) -> str:
        """The mode for motion along the positive sense, against it, or none."""
        if self.contact is None and self.pair is None:
            return {1: "", -1: TURNS_BACK, 0: HOLDS}[sense]
        return {1: FORWARD, -1: BACK, 0: STICKS}[sense]

    @property
    def name(self) -> str:
        """What it is, whatever the state from which it is looked at."""
        return self.owner if self.contact is not None or self.pair is not None else f"{self.owner}.{self.body}"

    @property
    def key(self) -> str:
        return rub_key(self.name, self.state)

    def rate(self, instant: Instant, *, acceleration: bool = False) -> Formula | None:
        """Speed or acceleration along the positive sense: of the touching point, of one body on another, or of the wheel's turn."""
        item = self.contact or self.pair
        if item is None:
            return instant.rate("angular_acceleration" if acceleration else "angular_velocity", self.body)
        return item.slip(instant, acceleration=acceleration)


def rubs(configuration: Configuration) -> tuple[Rub, ...]:
    """All that rubs, phase by phase."""
    found: dict[str, Rub] = {}
    timeline = configuration.timeline
    for state in timeline.states:
        if timeline.phase_of(state.name) is None and len(timeline.states) > 1:
            continue  # in an event alone a finite force does nothing
        for rub in rubs_at(configuration, configuration.phase_start(state.name)):
            found.setdefault(rub.key, rub)
    return tuple(found.values())


def rubs_at(configuration: Configuration, state: str) -> Iterator[Rub]:
    for item in configuration.acting(state):
        if isinstance(item, Connection) and item.rubs():
            name, contact = configuration.host(item.slider().owner, state), item if item.lying() else None
            yield Rub(item.name, name, state, contact, None if contact else item)
        for ref in item.brakes():
            name = configuration.host(ref.owner, state)
            yield Rub(item.name, name, state)
