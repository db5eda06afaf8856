"""Posts: where the fixed posts stand round which ropes run, so that both strands touch them."""

from __future__ import annotations

import itertools

from rotsolve.confirm.model import Model
from rotsolve.confirm.pose import Way
from rotsolve.draw.paper.figure import Point, quarter
from rotsolve.draw.plane.places.kinds import ConnectionKinds
from rotsolve.language.bodies import PointRef

STOUT = 0.7  # radius of a post in blocks: as wide as what hangs on both sides of it needs


def is_post_of(ref: PointRef, model: Model) -> bool:
    """Whether a string runs round what a point names, which does not move."""
    surface = model.surfaces.get(ref.owner)
    return surface is not None and surface.post


def touched_at(ref: PointRef, way: Way, radius: float, kinds: ConnectionKinds, model: Model) -> Point:
    """From the middle of a post to where a strand along a direction touches it."""
    x, y = quarter(way)
    size = -turn_round(ref.owner, kinds, model) * radius
    return size * x, size * y


def turn_round(name: str, kinds: ConnectionKinds, model: Model) -> int:
    """Which way a rope runs round a post, −1 clockwise as over a beam; the shorter way, where its strands have different directions."""
    for item in kinds.strings:
        for before, after in itertools.pairwise(model.legs(item)):
            if before.second.owner == name and before.along is not None and after.along is not None:
                (ax, ay), (bx, by) = before.along, after.along
                return 1 if ax * by - ay * bx > 1e-9 else -1
    return -1
