"""Sided: what a body is drawn as of which only its sides are told: a wedge by its slopes, a hill or a bowl by a round side."""

from __future__ import annotations

import math
from collections.abc import Sequence

from rotsolve.draw.plane.places.kinds import curve_radius
from rotsolve.draw.plane.places.outlines import BodyOutline, Value, disc, polygon
from rotsolve.language.bodies import Surface

LONG = 3.8  # of a slope, in the width of a block
AROUND = 32  # points of half a circle
RIM, THICK, WALL = (
    1.14,
    1.12,
    0.94,
)  # of a bowl: half its width, its depth; of a wire: its inner radius; all in the radius
FOOT = 0.55, 0.14  # of what holds a wire: half its width, its height, in the radius


def sided_outline(sides: Sequence[Surface], value: Value, block: float) -> tuple[BodyOutline, ...]:
    """A round side about the origin, else the slopes that fall to the right and to the left of one top."""
    for side in sides:
        size = curve_radius(side)
        if size is not None:
            return round_body(side, value(size))
    tilts = [(side, side.tilt()) for side in sides[::-1]]
    angles = {getattr(side, "down", "right"): value(tilt) for side, tilt in tilts if tilt is not None}
    high = min(LONG * block * math.sin(angle) for angle in angles.values())
    right, left = (high / math.tan(angles[down]) if down in angles else 0.0 for down in ("right", "left"))
    middle, third = (right - left) / 3, high / 3
    return (polygon([(-left - middle, -third), (right - middle, -third), (-middle, high - third)]),)


def round_body(side: Surface, radius: float) -> tuple[BodyOutline, ...]:
    """Half a disc under a dome, a block with a round hollow, a ring on a foot."""
    half = [math.pi * k / AROUND for k in range(AROUND + 1)]
    if side.two_sided:
        wide, low, deep = FOOT[0] * radius, -radius, -(1 + FOOT[1]) * radius
        foot = polygon([(-wide, deep), (wide, deep), (wide, low), (-wide, low)])
        return disc(radius), disc(WALL * radius, cut=True), foot
    if getattr(side, "outside", True):
        return (polygon([(radius * math.cos(t), radius * math.sin(t)) for t in half]),)
    inside = [(-radius * math.cos(t), -radius * math.sin(t)) for t in half]
    wide, deep = RIM * radius, -THICK * radius
    return (polygon([(-wide, 0.0), *inside, (wide, 0.0), (wide, deep), (-wide, deep)]),)
