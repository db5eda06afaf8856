"""Displacements: how far a body, a point of it, or what lies on its side goes in a phase."""

from __future__ import annotations

from rotsolve.algebra.formula import ONE, Formula
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, UP, vector
from rotsolve.language.problem import Path, PointRef
from rotsolve.motion.instant import Instant
from rotsolve.motion.places import gone_along
from rotsolve.motion.timeline import Interval
from rotsolve.motion.travels import displacement, so_far
from rotsolve.paths.meaning import NotYet, path_text


def way(path: Path, name: str, interval: Interval | None, instant: Instant) -> Formula:
    """Displacement along a body's line or a component of it, over a phase, or up to any moment in it where none is named."""
    axis = path.component if path.component in ("x", "y") and instant.motion(name).kind == "plane" else ""
    if path.component and not axis:
        raise NotYet(f"`{path_text(path)}` is not solved yet", help="ask for the displacement along its line")
    gone = (
        so_far("displacement", name, instant, axis) if interval is None else displacement(name, interval, instant, axis)
    )
    return gone if axis else instant.as_travelled(gone, path.owner)


def displacement_over(path: Path, interval: Interval, first: Instant, last: Instant) -> Formula:
    """Displacement of a body's centre of mass over a phase, along its line or in one direction: x₂ − x₁."""
    if path.owner not in first.configuration.bodies:
        return slid_over(path, interval, first, last)
    name, motion = first.host(path.owner), first.motion(path.owner)
    if motion.kind == "plane" and path.component is None:
        message = f"`{path_text(path)}` of what moves freely in the plane has two components"
        raise NotYet(
            message, help=f"tell `{path_text(path)}.x`, `{path_text(path)}.y` or both, `[x, y]`", span=path.span
        )
    if path.component is None and path.point is None:
        return way(path, name, interval, first)
    arm = first.point(PointRef(path.owner, path.point or "cm", path.argument))
    axis = {"x": RIGHT, "y": UP}.get(path.component or "")
    gone = None if axis is None or (motion.turns and arm.parts) else gone_along(name, axis, interval, first, last)
    if gone is None:
        help = "solved is the way of a centre of mass to the right or up, `.x` or `.y`, and that along its line"
        raise NotYet(f"`{path_text(path)}` is not solved yet", help=help, span=path.span)
    return gone


def slid_over(path: Path, interval: Interval, first: Instant, last: Instant) -> Formula:
    """How far what lies on a side of a body slides down that in a phase, as seen from the body: (Δr − Δr_body) · e."""
    item = first.configuration.connection(path.owner, first.state)
    down = item.slides_down(first) if item is not None and path.component is None else None
    if item is None or down is None:
        raise NotYet(f"`{path_text(path)}` is solved of what lies on a side of a body", span=path.span)
    way = NOWHERE
    for name, sign in ((item.lying(), ONE), (item.places()[0].owner, -ONE)):
        for axis in (RIGHT, UP):
            gone = gone_along(first.host(name), axis, interval, first, last)
            if gone is None:
                raise NotYet(f"how far `{name}` goes is not told", span=path.span)
            way = way + vector(sign * gone, axis)
    return way.along(down)
