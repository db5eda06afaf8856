"""Freedoms: in how many independent ways something may move: the rank of the twists that its joints let it have.

A twist is a velocity of the point held and an angular velocity, six numbers; what several joints hold has the twists that all of them let.
"""

from __future__ import annotations

from collections.abc import Sequence

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.linear import solved_generally
from rotsolve.confirm.space.arrows import ALONG, STILL, Arrow, normed, scaled
from rotsolve.confirm.space.rig import Rig
from rotsolve.confirm.space.ties import ROUND
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import Joint
from rotsolve.language.problem import Path

Twist = tuple[float, ...]  # velocity, angular velocity


def freedoms(rig: Rig, path: Path) -> float:
    """Of a body that nothing else moves, or of what a joint lets its body do."""
    if path.owner in rig.joints:
        twists = twists_of(rig, rig.joints[path.owner])
    elif path.owner in rig.bodies:
        own = [joint for joint in rig.joints.values() if joint.body.owner == path.owner]
        line = rig.line(path.owner)
        if line is not None and len(own) == 2:
            return 0.0 if path.component == "translations" else 1.0
        if len(own) > 1 or any(joint.carrier.owner in rig.bodies for joint in own):
            raise NotConfirmed("the freedoms of what several joints hold, or another body carries")
        twists = twists_of(rig, own[0]) if own else [as_twist(way, STILL) for way in ALONG]
        if not own and not point(rig, path.owner):
            twists += [as_twist(STILL, way) for way in ALONG]
    else:
        raise NotConfirmed("the freedoms of the whole scene")
    half = {"translations": slice(0, 3), "rotations": slice(3, 6)}.get(path.component or "", slice(0, 6))
    return float(independent([one[half] for one in twists]))


def point(rig: Rig, name: str) -> bool:
    """Whether a body is a mere point, which does not turn."""
    solid = rig.solid(name)
    return shape_of(rig.bodies[name]).pointlike and solid.whole and not any(map(any, solid.tensor))


def twists_of(rig: Rig, joint: Joint) -> list[Twist]:
    """Independent twists that a joint lets its body have."""
    if joint.flat:
        return [as_twist(ALONG[0], STILL), as_twist(ALONG[1], STILL), as_twist(STILL, ALONG[2])]
    if joint.rolls:
        raise NotConfirmed("the freedoms of what rolls")
    turns = ALONG if joint.free else [normed(rig.arrow(way)) for way in joint.turning]
    slides = [normed(rig.arrow(way)) for way in joint.sliding]
    if joint.pitch is not None:
        lead = rig.value(joint.pitch) / ROUND
        return [as_twist(scaled(lead, turns[0]), turns[0])]
    return [*(as_twist(way, STILL) for way in slides), *(as_twist(STILL, way) for way in turns)]


def as_twist(velocity: Arrow, turning: Arrow) -> Twist:
    return (*velocity, *turning)


def independent(rows: Sequence[Twist]) -> int:
    """How many of them are independent."""
    width = len(rows[0]) if rows else 0
    found = solved_generally(
        [{k: part for k, part in enumerate(row) if part} for row in rows], [0.0] * len(rows), width
    )
    return width - len(found.free)
