"""Lifted: what lies on something and is joined to a body that goes round a hinge or an axle goes round with that, and leaves it."""

from __future__ import annotations

from collections.abc import Sequence

from rotsolve.language.elements import Connection, Event


def lifted(event: Event, present: Sequence[Connection], before: Sequence[Event]) -> tuple[Connection, ...]:
    """The contacts that end with an event: those of what lies on something and is joined to what swings and lies on nothing."""
    if not event.joined():
        return ()
    pairs = [tuple(ref.owner for ref in item.joined()) for item in (*present, *before) if item.joined()]
    first, second = (one_with(ref.owner, pairs) for ref in event.joined())
    for own, other in ((first, second), (second, first)):
        lying = tuple(item for item in present if item.lying() in own)
        if lying and not any(item.lying() in other for item in present) and swings(other, present):
            return lying
    return ()


def one_with(name: str, pairs: Sequence[tuple[str, ...]]) -> frozenset[str]:
    """A body and all that are one with it."""
    found = [name]
    for own in found:
        found += [other for pair in pairs if own in pair for other in pair if other not in found]
    return frozenset(found)


def swings(group: frozenset[str], present: Sequence[Connection]) -> bool:
    """Whether a hinge or axle holds a body to the ground, or to another that carries it or that lies on something."""
    lying = {item.lying() for item in present}
    for item in present:
        owners = [ref.owner for ref in item.joint()]
        if any(ref.owner in group for ref in item.fixed_points()) or group.intersection(owners[1:]):
            return True
        if group.intersection(owners) and lying.intersection(owners):
            return True
    return False
