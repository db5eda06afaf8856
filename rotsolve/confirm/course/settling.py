"""Settling: where bodies in balance stand, if nothing tells: they are let go as drawn, and go where they are pushed until nothing does."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.node import Node
from rotsolve.confirm.instant import placed

TRIES, FIRST, MOST = 200, 0.1, 0.3  # steps; the size of the first one, and of the largest (rad, m)
ALIKE, SAME = (
    8,
    1e-12,
)  # steps over which accelerations change by no more than this share of themselves: they always stay so
FIXED = 1e-6  # share of a step by which nothing moves that is told
STILL, DONE = 1e-5, 1e-10  # accelerations that are none, as shares of g: at first, and where a step may end


class Adrift(NotConfirmed):
    """What is said to be in balance is pushed as much wherever it gets to."""


def settled(at: Node) -> Node | None:
    """The instant at which nothing pushes any more, by steps q̈ s with the s of Barzilai and Borwein; the same where nothing pushes now.

    A stable place: from an unstable one the way leads off. None where what is told lets nothing move; Adrift where what pushes never
    changes, NotConfirmed where there is no end.
    """
    try:
        push = at.pushes
    except NotConfirmed:
        return at
    size = max(at.model.gravity, 1.0)
    if largest(push) < STILL * size:
        return at
    step, alike = FIRST / largest(push), 0
    kept = {key: row.gap for key, row in at.moment.rows.items() if not row.hard}
    for _ in range(TRIES):
        step = min(step, MOST / largest(push))
        moved = replace(at.placed, q=[place + step * rate for place, rate in zip(at.placed.q, push, strict=True)])
        other = Node(at.model, placed(at.model, moved, kept=kept), at.budget)
        way = [new - old for new, old in zip(other.placed.q, at.placed.q, strict=True)]
        if largest(way) < FIXED * step * largest(push):
            return None
        change = [new - old for new, old in zip(other.pushes, push, strict=True)]
        at, push = other, other.pushes
        if largest(push) < DONE * size:
            at.settled = True
            return at
        alike = alike + 1 if largest(change) <= SAME * largest(push) else 0
        if alike == ALIKE:
            raise Adrift(f"`{at.model.acting.state.name}` is not in balance as it stands")
        back = -sum(a * b for a, b in zip(way, change, strict=True))
        step = sum(part * part for part in way) / back if back > 0 else 2 * step
    raise NotConfirmed(f"nothing tells where it is in balance at `{at.model.acting.state.name}`")


def as_it_went(at: Node, before: Node) -> Node:
    """An instant in balance at which what nothing holds or pushes, and nothing has been joined to, is as fast as it was before."""
    acting = at.model.acting
    refs = [ref for item in (*acting.connections, *acting.actions) for ref in item.touches()]
    refs += [ref for event in acting.joined() for ref in event.joined()]
    free = at.model.seats.keys() & before.model.seats.keys() - {ref.owner for ref in refs}
    speed = list(at.placed.speed)
    for name in free:
        own, earlier = at.model.seats[name], before.model.seats[name]
        speed[own.first : own.turn + 1] = before.placed.speed[earlier.first : earlier.turn + 1]
    return Node(at.model, replace(at.placed, speed=speed), at.budget) if speed != list(at.placed.speed) else at


def largest(values: Sequence[float]) -> float:
    return max(map(abs, values), default=0.0)
