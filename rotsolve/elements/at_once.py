"""At once: several blows between the same two states, all in one instant; with restitution each parts e times as fast as it came."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations

from rotsolve.algebra.formula import ZERO
from rotsolve.core.derivation import Words
from rotsolve.core.facts import MEETS, PUSHES, Couple, Requirement, Rule
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import RIGHT, UP
from rotsolve.core.writing import and_joined, spoken
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Connection, Event, Moment


class AtOnce(Event, frozen=True):
    """Blows that are one event: their impulses act together, and each may change what the others do."""

    about = "several blows act at once"
    parts: tuple[Event, ...] = ()

    @property
    def heats(self) -> bool:  # type: ignore[override]
        return all(item.heats for item in self.parts)

    def each(self) -> tuple[Event, ...]:
        return self.parts

    def told(self) -> Words:
        return (f"{and_joined([spoken(item.name) for item in self.parts])} at once",)

    def points(self, connections: Sequence[Connection]) -> tuple[PointRef, ...]:
        return tuple(ref for item in self.parts for ref in item.points(connections))

    def twists(self, body: str, instant: Moment) -> tuple[Couple, ...]:
        return tuple(twist for item in self.parts for twist in item.twists(body, instant))

    def rules(self, before: Moment, after: Moment) -> Iterator[Rule]:
        for item in self.parts:
            yield from item.rules(before, after)

    def needs(self, before: Moment, after: Moment) -> Iterator[Requirement]:
        """What each needs, and that each comes together and pushes: of several a hard one may take the push from another."""
        from rotsolve.elements.collisions import Bounces

        hits = [item for item in self.parts if item.closing(before, after) is not None]
        for one, other in combinations(hits, 2):
            check_places_apart(one, other, before)
        for item in self.parts:
            yield from item.needs(before, after)
        for item in hits:
            yield from pushing(item, before, after)
            yield from (item.passive(before, after) if isinstance(item, Bounces) else ())

    def no_torque(self, instant: Moment) -> str:
        return "the blows there have no arm"


def check_places_apart(one: Event, other: Event, before: Moment) -> None:
    """Two blows of the same bodies along one line are at different places: of one place nothing tells how they share it."""
    places = [{ref.owner: before.point(ref) for ref in item.points(())} for item in (one, other)]
    ways = [way for item in (one, other) for _, way in item.axes(before)]
    if places[0].keys() != places[1].keys() or (ways[0] - ways[-1]).sin() != ZERO:
        return
    gaps = [(place - places[1][name]).along(axis) for name, place in places[0].items() for axis in (RIGHT, UP)]
    if all(before.configuration.signs.by_numbers(gap) == 0 for gap in gaps):
        names = " and ".join(f"`{name}`" for name in places[0])
        message = f"`{one.name}` and `{other.name}` strike {names} at one place: nothing tells what each gives"
        raise Unsolvable(message, span=other.points(())[0].span, help="leave one of them out")


def pushing(item: Event, before: Moment, after: Moment) -> Iterator[Requirement]:
    """Of one of several blows: the two come together, u² > 0, since no e tells what passes through what rests against each other; and they
    push each other, J u > 0, J along the line on the second of them."""
    came, _ = item.closing(before, after) or (ZERO, ZERO)
    names = " and ".join(map(spoken, item.met()))
    yield Requirement(item.name, MEETS, came**2, ZERO, "", f"{names} rest against each other")
    sign = before.configuration.signs.sign(came)
    size = item.push(before)
    left = size * (sign or came)
    yield Requirement(
        item.name, PUSHES, left, ZERO, f"{names} push each other", f"{names} would have to pull each other"
    )


def as_one_event(events: Iterable[Event]) -> Event | None:
    """The one event that several between the same states are; None of none."""
    found = tuple(events)
    if len(found) < 2:
        return found[0] if found else None
    return AtOnce(and_joined([item.name for item in found]), found[0].from_, found[0].to, found)


def event_between(events: Iterable[Event], first: str, last: str) -> Event | None:
    """What happens from one state to the next."""
    return as_one_event(item for item in events if (item.from_, item.to) == (first, last))
