"""Members: bodies that are part of others, welded to them or riding on them: which is the host, and where the other sits."""

from __future__ import annotations

from collections.abc import Container, Mapping

from msgspec import Struct

from rotsolve.elements.connections import Rides
from rotsolve.elements.rims import shape_of
from rotsolve.language.problem import Body, PointRef


class Member(Struct, frozen=True):
    """A body that is part of another (joined or welded): its host, and the host's point where it sits."""

    name: str
    host: str
    at: PointRef
    own: PointRef


def rider(item: Rides, axis: PointRef | None) -> Member:
    """A body that rides on another: its distance is counted from the carrier's axis."""
    own, carrier = item.rides
    return Member(own.owner, carrier.owner, axis or PointRef(carrier.owner, "center"), PointRef(own.owner, "center"))


def welded(first: PointRef, second: PointRef, held: Container[str], bodies: Mapping[str, Body]) -> Member:
    """The joined pair as host and member: a body `held` on an axis, else the extended one, else the last-named is the host."""
    weight = [(ref.owner in held, shape_of(bodies[ref.owner]).word != "particle") for ref in (first, second)]
    member, host = (first, second) if weight[1] >= weight[0] else (second, first)
    return Member(member.owner, host.owner, host, member)
