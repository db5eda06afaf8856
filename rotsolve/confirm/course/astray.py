"""Astray: why the motion does not come to a state as the scene says: what lets go, turns back, or meets again on the way."""

from __future__ import annotations

from rotsolve.confirm.course.node import Astray, Node
from rotsolve.confirm.rows import EDGE

TOUCHING = 1e-9  # metres: at the blow itself they are not yet through each other


class LetsGo(Astray):
    """What only pushes or pulls would have to do the opposite on the way, or touch with an end of a round side."""

    def __init__(self, kind: str, owner: str, first: str, last: str) -> None:
        super().__init__(f"{letting_go(kind, owner)} on the way from `{first}` to `{last}`")


def letting_go(kind: str, owner: str) -> str:
    """What becomes of a touch or a string that holds no longer, by what of it gives way."""
    return f"`{owner}` {'is at an end of its round side' if kind.endswith(EDGE) else 'lets go'}"


class GivesWay(Astray):
    """What sticks would begin to slip on the way from a place where the least push decides, so that no steps tell how it goes on."""

    def __init__(self, owner: str, first: str, last: str) -> None:
        super().__init__(f"`{owner}` begins to slip on the way from `{first}` to `{last}`")


class SlipsOn(Astray):
    """What a state says to stick or to roll would slip on, or the other way, from there."""

    def __init__(self, owner: str, state: str) -> None:
        self.owner = owner
        super().__init__(f"`{owner}` would slip on from `{state}`")


class MeetAgain(Astray):
    """Two bodies that bounced off each other would go through each other on the way."""

    def __init__(self, pair: tuple[str, str], first: str, last: str) -> None:
        super().__init__(f"`{pair[0]}` and `{pair[1]}` meet again on the way from `{first}` to `{last}`")


def spaces(at: Node, *, rods: bool = False) -> dict[tuple[str, str], tuple[float, float]]:
    """How far apart those are that have bounced off each other, each with what it is small against; rods too, if that is asked."""
    found = {}
    for met in at.placed.met:
        if met.rod is not None and not rods:
            continue
        from rotsolve.confirm.course.meeting import clearance

        gap = clearance(met, at.pose)
        found[met.pair] = (gap + TOUCHING, abs(gap + met.apart) + abs(met.apart) + TOUCHING)
    return found


def check_apart(at: Node, last: str) -> None:
    """MeetAgain where bodies have gone through each other."""
    for pair, (gap, size) in spaces(at, rods=True).items():
        if gap < -1e-6 * size:
            raise MeetAgain(pair, at.model.acting.state.name, last)
