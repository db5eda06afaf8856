"""Far out: whether what slides on what is led evenly, or turns freely, has gone so far that it comes back to no place near its start.

What drives it there goes by its place to a power that far out is the greatest: outward and ever faster, it stays so.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rotsolve.language.problem import Condition

if TYPE_CHECKING:
    from rotsolve.confirm.space.flight import Flight

FAR = 1e3  # times the places of which the scene tells
PLACE, RATE = 5, 11  # where the way along a slide stands among the numbers of a body, and its rate


def gone_for_good(flight: Flight, line: Condition, one: list[float], other: list[float]) -> bool:
    """Whether the body of a line about its place on a slide goes outward ever faster between two moments, far beyond what is told."""
    path = line.path
    if path is None or path.quantity != "position" or path.owner not in flight.guided or flight.rig.problem.actions:
        return False
    if len(flight.guided[path.owner].sliding) != 1 or line.value is None:
        return False
    size = len(one) // len(flight.rig.bodies)
    begin = size * list(flight.rig.bodies).index(path.owner)
    place, before, now = other[begin + PLACE], one[begin + RATE], other[begin + RATE]
    if not (place * now > 0.0 and (now - before) * now > 0.0):
        return False
    told = flight.rig.value(line.value)
    scale = abs(told) + abs(
        told + flight.gap_of(line)(flight.start)
    )  # where it is to come, and where it was at the start
    return scale > 0.0 and abs(place) > FAR * scale
