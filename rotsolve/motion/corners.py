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


def untold_on_a_slope(name: str, state: str, configuration: Configuration) -> str:
    """The body with corners that a body is, or is joined to, where that travels along a slope and no state says its angle; else ''."""
    host = configuration.host(name, state)
    line, members = configuration.line(host, state), configuration.carried(host, state)
    if line is None or ZERO in (line[0].sin(), line[0].cos()):
        return ""
    says, states = configuration.mentions.says, configuration.timeline.states
    if any(says(item.name, member, "angle") for item in states for member in members):
        return ""
    return next((member for member in members if len(corners_of(configuration.bodies[member])) > 1), "")


def refuse_untold(ref: PointRef, state: str, configuration: Configuration) -> None:
    """Refuse a point of what lies on a slope, save the middle of one body, where it matters how that stands there and nothing tells."""
    standing = untold_on_a_slope(ref.owner, state, configuration) if ref.owner in configuration.bodies else ""
    alone = standing and {*configuration.carried(configuration.host(ref.owner, state), state)} == {ref.owner}
    if not standing or (alone and ref.point in (None, "center", "cm")):
        return
    spot = ref.owner if ref.point is None else f"{ref.owner}.{ref.point}"
    message = f"how `{standing}` stands on its slope nothing tells, and so where `{spot}` is"
    help = f"tell `{standing}.angle` in a state: minus the angle of a slope that falls to the right where it lies flat on it"
    problem = configuration.problem
    raise Unsolvable(message, span=ref.span, help=help, lines=problem.lines, file=problem.file)
