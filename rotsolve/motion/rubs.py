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
    from rotsolve.motion.timeline import Interval

FORWARD, BACK, STICKS = "slips", "slips back", "sticks"
TURNS_BACK, HOLDS = "turns back", "holds"
AT_MOST = " at most"  # a trial with as much friction as there can be before it slips


class Rub(Struct, frozen=True):
    """A contact, two bodies that rub on each other, or a wheel on a rubbing axle or under a brake, in the phase that starts at a state."""

    owner: str  # the element that rubs
    body: str
    state: str
    item: Connection | None = None  # what slips: a contact, or two bodies that rub on each other

    @property
    def contact(self) -> Connection | None:
        """The contact, if it is one: its friction is limited by the push."""
        return self.item if self.item is not None and self.item.lying() else None

    def mode(self, sense: int) -> str:
        """The mode for motion along the positive sense, against it, or none."""
        if self.item is None:
            return {1: "", -1: TURNS_BACK, 0: HOLDS}[sense]
        return {1: FORWARD, -1: BACK, 0: STICKS}[sense]

    @property
    def name(self) -> str:
        """What it is, whatever the state from which it is looked at."""
        return self.owner if self.item is not None else f"{self.owner}.{self.body}"

    @property
    def key(self) -> str:
        return rub_key(self.name, self.state)

    def rate(self, instant: Instant, *, acceleration: bool = False) -> Formula | None:
        """Speed or acceleration along the positive sense: of the touching point, of one body on another, or of the wheel's turn."""
        if self.item is None:
            return instant.rate("angular_acceleration" if acceleration else "angular_velocity", self.body)
        return self.item.slip(instant, acceleration=acceleration)

    def drift(self, instant: Instant) -> Formula | None:
        """Speed of the body along its line (a wheel's contact slides with it), of one body on another, or of the wheel's turn."""
        return self.rate(instant) if self.item is None else self.item.drift(instant)


def against_most(mode: str) -> str:
    """A mode with as much friction as there can be before it slips, where that is less while it slips."""
    return mode + AT_MOST if mode in (FORWARD, BACK) else mode


def rubs(configuration: Configuration) -> tuple[Rub, ...]:
    """All that rubs, phase by phase."""
    found: dict[str, Rub] = {}
    timeline = configuration.timeline
    for state in timeline.states:
        for rub in rubs_at(configuration, configuration.phase_start(state.name)):
            found.setdefault(rub.key, rub)
    return tuple(found.values())


def rough_blows(configuration: Configuration) -> tuple[Interval, ...]:
    """The events in which a body strikes what it may slip on, in the order of time."""
    return tuple(item for item in configuration.timeline.intervals if item.event is not None and item.event.rubs())


def in_one_body(item: Connection, configuration: Configuration, state: str) -> bool:
    """Whether what an element touches are several parts of one body, which do not slip on each other."""
    touched = {ref.owner for ref in item.touches()}
    inside = len(touched) > 1 and touched <= configuration.bodies.keys()
    return inside and len({configuration.host(name, state) for name in touched}) == 1


def rubs_at(configuration: Configuration, state: str) -> Iterator[Rub]:
    for item in configuration.acting(state):
        if isinstance(item, Connection) and item.rubs() and not in_one_body(item, configuration, state):
            yield Rub(item.name, configuration.host(item.slider().owner, state), state, item)
        for ref in item.brakes():
            yield Rub(item.name, configuration.host(ref.owner, state), state)
