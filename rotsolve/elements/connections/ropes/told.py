"""Told: the direction of a pull in the words of a free-body diagram."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rotsolve.core.vectors.directions import along_text, opposite
from rotsolve.core.vectors.heading import Vector
from rotsolve.elements.sides import rough

if TYPE_CHECKING:
    from rotsolve.motion.instant import Instant


def told_along(push: Vector, name: str, instant: Instant) -> str:
    """A pull along the line on which a body travels, in the words of that line: ", up the slope"."""
    line = instant.line(instant.host(name))
    if line is None or len(push.parts) != 1:
        return ""
    gap = push.parts[0][1] - line[0]
    if gap.terms or gap.degrees % 180:
        return ""
    return f", {line[1]}" if gap.degrees % 360 == 0 else f", {opposite(line[1])}"


def said(push: Vector, arm: Vector, kind: str) -> str:
    """How a pull is told: its direction for what travels, its turn for what is held on an axis."""
    direction = along_text(push.parts[0][1]) if len(push.parts) == 1 else ""
    if kind == "axis" and arm.parts:
        turn = rough(arm.cross(push))
        sense = "" if abs(turn) < 1e-12 else ", turning it counterclockwise" if turn > 0 else ", turning it clockwise"
        return (f" {direction}" if direction and not sense else "") + sense
    return f", {direction}" if direction else ", along the string"
