"""Members: bodies that are part of another one, joined, welded or riding on it."""

from __future__ import annotations

from collections.abc import Container, Mapping

from msgspec import Struct

from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import Body, PointRef, Ride


class Member(Struct, frozen=True):
    """A body that is part of another (joined or welded): its host, and the host's point where it sits."""

    name: str
    host: str
    at: PointRef
    own: PointRef


def rider(item: Ride, axis: PointRef | None) -> Member:
    """A body that rides on another: its distance is counted from the carrier's axis."""
    own, carrier = item.rider.owner, item.carrier.owner
    return Member(own, carrier, axis or PointRef(carrier, "center"), PointRef(own, "center"))


def welded(first: PointRef, second: PointRef, held: Container[str], bodies: Mapping[str, Body]) -> Member:
    """The joined pair as host and member: a body `held` on an axis, else the extended one, else the last-named is the host."""
    weight = [(ref.owner in held, not shape_of(bodies[ref.owner]).pointlike) for ref in (first, second)]
    member, host = (first, second) if weight[1] >= weight[0] else (second, first)
    return Member(member.owner, host.owner, host, member)
