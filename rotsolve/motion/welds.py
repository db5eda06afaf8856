"""Welds: bodies that are joined are one: which of them stands for all, and where each of the others sits in its axes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ONE, ZERO
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, Heading, Vector
from rotsolve.language.bodies import PointRef
from rotsolve.motion.rigid import RigidPiece, tidy

Pair = tuple[PointRef, PointRef]
Rank = tuple[bool, ...]


class Member(Struct, frozen=True):
    """Where a body sits in the axes of its `host`, which stands for all that are joined to it: turned, and moved to a place."""

    name: str
    host: str
    at: Vector = NOWHERE
    turned: Heading = RIGHT

    def place(self, own: Vector) -> Vector:
        """A place in the body's own axes as one in those of its host."""
        own = own if self.turned == RIGHT else own.rotated(self.turned)
        return self.at + own if self.at.parts else own

    def piece(self, own: RigidPiece) -> RigidPiece:
        """A piece of the body as one of all that are joined."""
        if self.turned == RIGHT:
            return replace(own, at=tidy(self.place(own.at)))
        moved = own.moved(self.turned, self.at, ZERO, ONE)
        return replace(moved, at=tidy(moved.at))


def seated(
    pairs: Sequence[Pair],
    rank: Callable[[str], Rank],
    locate: Callable[[PointRef], Vector],
    turned: Callable[[str, str], Heading],
) -> dict[str, Member]:
    """The seats of all bodies that others stand for, nearest to their host first, by name.

    Of bodies that are joined the one of the highest `rank` stands for all, of several the last-named. `locate` tells where a point is in
    its body's own axes, `turned` how far the second of two bodies that meet is turned against the first.
    """
    named = {ref.owner: place for place, ref in enumerate(ref for pair in pairs for ref in pair)}
    meetings: dict[str, list[Pair]] = {}
    for first, second in pairs:
        meetings.setdefault(first.owner, []).append((first, second))
        meetings.setdefault(second.owner, []).append((second, first))
    seats: dict[str, Member] = {}

    def around(seat: Member) -> Iterator[Member]:
        """Those that meet a body, and those behind them."""
        for here, there in meetings[seat.name]:
            if there.owner not in placed:
                placed.add(there.owner)
                heading = seat.turned + turned(seat.name, there.owner)
                behind = Member(there.owner, seat.host, turned=heading)
                at = seat.place(locate(here)) - behind.place(locate(there))
                behind = Member(there.owner, seat.host, at, heading)
                yield behind
                yield from around(behind)

    placed: set[str] = set()
    for host in sorted(named, key=lambda name: (rank(name), named[name]), reverse=True):
        if host not in placed:
            placed.add(host)
            seats |= {seat.name: seat for seat in around(Member(host, host))}
    return seats
