"""Bases: what lies on something flat with corners does not tip over while the push from below acts between the ends of its base.

Of a body that does not turn all torques about its centre of mass add up to nothing: s N + τ = 0, where s is how far ahead of it N acts.
The assembly that confirms answers has a way of its own (confirm/course/tipping).
"""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ZERO, Formula, negate
from rotsolve.core.facts import STANDS, BodyFacts, Force, Requirement
from rotsolve.core.vectors.heading import RIGHT, UP, Vector
from rotsolve.core.writing import spoken
from rotsolve.motion.corners import corners_of
from rotsolve.motion.instant import Instant


def standings(body: BodyFacts, instant: Instant) -> Iterator[Requirement]:
    """That a body stays on its base: N reaches neither beyond its front nor beyond its back, high N + τ ≥ 0 and −τ − low N ≥ 0.

    Nothing is told of what is joined to others or has something on its back, whose place there nobody says, nor, on a slope, of what a
    force off its centre of mass turns: a scene does not say how it stands there.
    """
    foot = only_foot(body, instant)
    corners = corners_of(instant.body(body.name)) if foot is not None else ()
    if foot is None or len(corners) < 2:
        return
    (_, normal), *more = foot.direction.parts
    level = is_zero((normal - UP).sin())
    others = [item for item in body.acting if item.owner != foot.owner]
    if more or not (level or all(is_zero(body.torque_of(item)) for item in others)):
        return
    seen = seen_from_centre(body.name, corners, instant, level=level)
    across, up = (normal.turned(-90), normal) if level else (RIGHT, UP)
    base = ends_of_base([(spot.along(across), spot.along(up)) for spot in seen], instant)
    if base is None:
        return
    back, front, rise = base
    along = [item.vector.along(normal.turned(-90)) for item in body.forces if item.owner == foot.owner]
    turning = simplify(sum((body.torque_of(item) for item in others), ZERO) - rise * sum(along, ZERO))
    kept, otherwise = f"{spoken(body.name)} stays on its base", f"{spoken(body.name)} tips over at"
    yield Requirement(foot.owner, STANDS, simplify(front * foot.size + turning), ZERO, kept, otherwise)
    yield Requirement(foot.owner, STANDS, simplify(negate(turning) - back * foot.size), ZERO, kept, otherwise)


def only_foot(body: BodyFacts, instant: Instant) -> Force | None:
    """The push from what a body alone lies on, where it is led along a line and nothing else presses it."""
    led = body.motion.kind == "line" and not body.motion.turns and body.motion.bend is None
    pushes = [force for force in body.forces if force.role.presses]
    if not led or len(pushes) != 1 or len(instant.configuration.carried(body.name, instant.state)) > 1:
        return None
    lying = {item.name for item in instant.configuration.connections(instant.state) if item.lying() == body.name}
    return pushes[0] if pushes[0].owner in lying else None


def seen_from_centre(name: str, corners: tuple[Vector, ...], instant: Instant, *, level: bool) -> list[Vector]:
    """The corners from the centre of mass: as the body stands on what is level; along a slope its own x axis is that."""
    frame = instant.frame(name)
    spots = [spot - frame.reference - frame.cm for spot in corners]
    return [spot.rotated(instant.motion(name).orientation) for spot in spots] if level else spots


def ends_of_base(spots: list[tuple[Formula, Formula]], instant: Instant) -> tuple[Formula, Formula, Formula] | None:
    """Back and front of the lowest corners, and how high those are; None where letters do not tell which these are."""
    sign = instant.configuration.signs.sign
    low, base = spots[0], [spots[0]]
    for spot in spots[1:]:
        higher = sign(simplify(spot[1] - low[1]))
        if higher is None:
            return None
        if higher < 0:
            low, base = spot, [spot]
        elif not higher:
            base.append(spot)
    back = front = low[0]
    for along, _ in base[1:]:
        if sign(simplify(along - back)) is None or sign(simplify(along - front)) is None:
            return None
        back = along if sign(simplify(along - back)) == -1 else back
        front = along if sign(simplify(along - front)) == 1 else front
    return (back, front, low[1]) if len(base) > 1 else None
