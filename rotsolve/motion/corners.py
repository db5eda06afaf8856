"""Corners: the outermost points of a body with sides, and where they are told: on a slope only where a state says how the body stands."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rotsolve.algebra.formula import ZERO
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import Vector
from rotsolve.elements.shapes import shape_of
from rotsolve.motion.rigid import part_frame, place

if TYPE_CHECKING:
    from rotsolve.language.bodies import Body, PointRef
    from rotsolve.motion.configuration import Configuration


def corners_of(body: Body) -> tuple[Vector, ...]:
    """The corners and ends of a body and of its parts, in its own axes."""
    own = tuple(place(spot) for spot in shape_of(body).outline())
    frames = ((part_frame(part), part.body) for part in body.parts)
    return (*own, *(spot.rotated(way) + origin for (way, origin), part in frames for spot in corners_of(part)))


def untold_on_a_slope(name: str, state: str, configuration: Configuration) -> bool:
    """Whether a body with corners travels along a slope, and no state says its angle: where its points are nothing tells."""
    body, line = configuration.bodies[name], configuration.line(name, state)
    if line is None or ZERO in (line[0].sin(), line[0].cos()) or len(corners_of(body)) < 2:
        return False
    states = configuration.timeline.states
    return not any(configuration.mentions.says(item.name, name, "angle") for item in states)


def refuse_untold(ref: PointRef, state: str, configuration: Configuration) -> None:
    """Refuse a point of a body that lies on a slope where it matters how it stands there, and nothing tells."""
    middle = ref.point in (None, "center", "cm")
    if ref.owner in configuration.bodies and not middle and untold_on_a_slope(ref.owner, state, configuration):
        message = f"how `{ref.owner}` stands on its slope nothing tells, and so where `{ref.owner}.{ref.point}` is"
        help = f"tell `{ref.owner}.angle` in a state: minus the angle of a slope that falls to the right where it lies flat on it"
        problem = configuration.problem
        raise Unsolvable(message, span=ref.span, help=help, lines=problem.lines, file=problem.file)
