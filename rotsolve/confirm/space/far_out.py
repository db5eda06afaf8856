"""Far out: whether what slides on what is led evenly, or turns freely, has gone so far that it comes back to no place near its start, and
how long a step may be on the way to where it is told.

What drives it there goes by its place to a power that far out is the greatest: outward and ever faster, it stays so.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from rotsolve.confirm.space.arrows import arrow_length
from rotsolve.confirm.space.ties import SLIDES
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


def rates_of_way(flight: Flight) -> Iterator[float]:
    """u/d and √(u̇/d) of what slides in space, d the way to where the later state tells it to be."""
    start = flight.start
    for line in flight.state.conditions:
        joint = None if line.path is None else flight.guided.get(line.path.owner)
        if joint is None or joint.carrier.owner in flight.rig.bodies:
            continue
        way = off_in_space(flight, line)
        if way:
            yield arrow_length(start.now.arrow(SLIDES, joint.owner)) / way
            yield math.sqrt(arrow_length(start.found.arrow(SLIDES, joint.owner)) / way)


def off_in_space(flight: Flight, line: Condition) -> float:
    """How far a component of a place is at the start from where a line tells it; 0 of all else."""
    place = line.path is not None and line.path.quantity == "position" and not line.relative
    return abs(flight.gap_of(line)(flight.start)) if place and line.value is not None else 0.0
