"""Material: the lengths, areas or volumes by which a body and its holes share one material, and how deep a hole goes.

A body of mass M of which holes take away V_h of its V has the density M/(V − Σ V_h). Cylinders as long as each other are compared by the
areas that are seen along them, all else by what it fills: a bore through a box by π r² c.
"""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula
from rotsolve.core.faults import Unsolvable
from rotsolve.language.bodies import Body, Part
from rotsolve.language.shape import Shape

SEEN = {"volume": "surface", "surface": "line"}  # what is seen of something along its axis
CUT = {"surface": "volume", "line": "surface"}  # what something flat cuts out of something deep


def bored(hole: Part, whole: Shape | None) -> Part:
    """A hole as deep as what it is bored through, where nobody says otherwise."""
    cut, depth = hole.body.shape, whole.depth() if whole is not None else None
    if cut is None or depth is None or hole.turned or not cut.seen or cut.depth() is not None:
        return hole
    return replace(hole, body=replace(hole.body, shape=replace(cut, **{"length": depth})))


def amounts(body: Body) -> tuple[Formula, ...]:
    """Length, area or volume of a body's shape without its holes, and of each hole: all of one kind.

    Raises `Unsolvable` where a hole is of another kind than its body, TypeError where a size is not told.
    """
    whole = body.shape
    assert whole is not None
    holes = [bored(hole, whole) for hole in body.holes]
    cuts = [hole.body.shape for hole in holes if hole.body.shape is not None]
    seen = whole.flat or (whole.seen and all(cut.flat or (cut.seen and cut.depth() == whole.depth()) for cut in cuts))
    own = (measured_over(whole, seen), whole.measure()) if seen else filled(whole, whole)
    found = [own[1]]
    for hole, cut in zip(holes, cuts, strict=True):
        if not seen and cut.seen and cut.depth() is None:
            message = f"how long the hole `{hole.body.name}` is nothing tells"
            raise Unsolvable(message, span=hole.body.span or body.span, help="say its `length`")
        kind, size = (measured_over(cut, seen), cut.measure()) if seen else filled(cut, whole)
        if kind != own[0] or (hole.turned and cut.flat):
            message = f"how much of `{body.name}` the hole `{hole.body.name}` takes away nothing tells"
            help = f"a {cut.word} is cut out of a {whole.word}: say it by a shape of the same kind"
            raise Unsolvable(message, span=hole.body.span or body.span, help=help)
        found.append(size)
    return tuple(found)


def measured_over(shape: Shape, seen: bool) -> str:
    """Over what the measure of a shape is: line, surface, volume."""
    return SEEN.get(shape.spread, "") if shape.seen and seen else shape.spread


def filled(shape: Shape, whole: Shape) -> tuple[str, Formula]:
    """What a shape fills, of what kind that is; something flat goes through all of the body."""
    depth = whole.depth()
    if shape.flat and depth is not None:
        return CUT.get(shape.spread, ""), shape.measure() * depth
    if shape.seen and shape.depth() is None:
        raise TypeError(f"how long a {shape.word} is")
    return shape.spread, shape.content()
