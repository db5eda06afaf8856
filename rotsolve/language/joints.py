"""Joints: all by which connections of a scene in space hold bodies, with the motors that turn some on their axes as hard as it takes."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec.structs import replace

from rotsolve.core.faults import Unsolvable
from rotsolve.language.bodies import Joint
from rotsolve.language.elements import Connection


def joints_in_space(connections: Iterable[Connection]) -> tuple[Joint, ...]:
    """The joints, in the order of the file; refused is a motor between bodies that no hinge or axle joins."""
    connections = tuple(connections)
    found = [joint for item in connections if (joint := item.joint_in_space()) is not None]
    for item in connections:
        pair = item.motor_in_space()
        if pair is None:
            continue
        names = {ref.owner for ref in pair}
        driven = next(
            (joint for joint in found if joint.turning and {joint.carrier.owner, joint.body.owner} == names), None
        )
        if driven is None or driven.drive or driven.pitch is not None:
            carrier, body = (ref.owner for ref in pair)
            message = f"`{item.name}` turns `{body}` on `{carrier}`, and no hinge or axle is there about which it could"
            help = f"join them: `axle: [{carrier}, {body}]` with `along`, and without a motion of its own"
            raise Unsolvable(message, span=pair[1].span, help=help)
        found[found.index(driven)] = replace(driven, motor=True)
    return tuple(found)
