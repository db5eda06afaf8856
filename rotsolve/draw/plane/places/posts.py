"""Posts: where the fixed posts stand round which ropes run, so that both strands touch them."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING

from rotsolve.confirm.pose import Way
from rotsolve.draw.paper.figure import Point, quarter
from rotsolve.language.bodies import PointRef

if TYPE_CHECKING:
    from rotsolve.draw.plane.places.stage import PlaneStage

STOUT = 0.7  # radius of a post, in blocks


def is_post_of(ref: PointRef, stage: PlaneStage) -> bool:
    """Whether a string runs round what a point names, which does not move."""
    surface = stage.model.surfaces.get(ref.owner)
    return surface is not None and surface.post


def post_radius(stage: PlaneStage) -> float:
    """The radius of a post: as wide as what hangs on both sides of it needs."""
    return STOUT * stage.sizes.block


def touched_at(ref: PointRef, way: Way, stage: PlaneStage) -> Point:
    """From the middle of a post to where a strand along a direction touches it."""
    x, y = quarter(way)
    size = -turn_round(ref.owner, stage) * post_radius(stage)
    return size * x, size * y


def turn_round(name: str, stage: PlaneStage) -> int:
    """Which way a rope runs round a post, −1 clockwise as over a beam; the shorter way, where its strands have different directions."""
    for item in stage.kinds.strings:
        for before, after in itertools.pairwise(stage.model.legs(item)):
            if before.second.owner == name and before.along is not None and after.along is not None:
                (ax, ay), (bx, by) = before.along, after.along
                return 1 if ax * by - ay * bx > 1e-9 else -1
    return -1
