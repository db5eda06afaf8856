"""Within: points of a rod, `rod.at(x)`, that lie beyond its ends."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rotsolve.algebra.certified.witness import note
from rotsolve.core.faults import Fault
from rotsolve.elements.shapes import Rod
from rotsolve.language.problem import Problem, points_of
from rotsolve.language.words import quoted
from rotsolve.scene.values.rough import size

TOLERANCE = 1e-12


def beyond_ends(problem: Problem, numbers: Mapping[str, float]) -> Iterator[Fault]:
    """One fault for each point that its rod does not reach."""
    rods = {body.name: body.shape.length for body in problem.bodies if isinstance(body.shape, Rod)}
    known = {name: size(length, numbers) for name, length in rods.items() if length is not None}
    lengths = {name: number for name, number in known.items() if number is not None}
    parts = (problem.connections, problem.actions, problem.states, problem.events, problem.finds)
    for ref in dict.fromkeys(points_of(parts)):
        place = None if ref.argument is None else size(ref.argument, numbers)
        length = rods.get(ref.owner)
        if place is not None and length is not None and ref.argument is not None:
            note(length - ref.argument)
        if place is not None and ref.point == "at" and place > lengths.get(ref.owner, place) * (1 + TOLERANCE):
            help = f"the rod is {lengths[ref.owner]:g} m long, and x is counted from its start"
            yield Fault(
                f"{quoted(ref.owner)} ends before this point, {place:g} m from its start", ref.span, help, "limits"
            )
