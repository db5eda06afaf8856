"""Within: points of a rod, `rod.at(x)`, that lie beyond its ends."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rotsolve.core.faults import Fault
from rotsolve.elements.shapes import Rod
from rotsolve.scene.model import Problem, points_of
from rotsolve.scene.values.rough import rough
from rotsolve.scene.words import quoted

TOLERANCE = 1e-12


def beyond_ends(problem: Problem, numbers: Mapping[str, float]) -> Iterator[Fault]:
    """One fault for each point that its rod does not reach."""
    lengths: dict[str, float] = {}
    for body in problem.bodies:
        length = body.shape.length if isinstance(body.shape, Rod) else None
        size = None if length is None else rough(length, numbers)
        if size is not None:
            lengths[body.name] = size
    parts = (problem.connections, problem.actions, problem.states, problem.events, problem.finds)
    for ref in dict.fromkeys(points_of(parts)):
        place = None if ref.argument is None else rough(ref.argument, numbers)
        if place is not None and ref.point == "at" and place > lengths.get(ref.owner, place) * (1 + TOLERANCE):
            help = f"the rod is {lengths[ref.owner]:g} m long, and x is counted from its start"
            yield Fault(
                f"{quoted(ref.owner)} ends before this point, {place:g} m from its start", ref.span, help, "limits"
            )
