"""Alone: the rates of bodies on which nothing but their weight acts, each unheld or on a ball joint on the ground, written out.

I α = I ω × ω + s × m g about the ball, whose arm s leads to the centre of mass; unheld about the centre of mass, which falls with g. The
equations of a rig say the same, but set up and eliminated at every look they take some seven times as long: on the way of a body that
tumbles or nods for long that is most of a run.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce

from rotsolve.confirm.space.arrows import (
    STILL,
    Arrow,
    Turned,
    crossed,
    less,
    rows_back,
    scaled,
    sum_of,
    times_arrow,
)
from rotsolve.confirm.space.efforts import DOWN
from rotsolve.confirm.space.masses import about_point, outer, total_rows
from rotsolve.confirm.space.principal import moments_and_axes
from rotsolve.confirm.space.rig import THIN, Rig

Gains = Callable[[str, Turned, Arrow], tuple[Arrow, Arrow]]


def gains_alone(rig: Rig) -> Gains | None:
    """α and the acceleration of the centre of mass by a body's name, its rotation and ω; None where anything else holds or drives one."""
    arms = arms_alone(rig)
    if arms is None:
        return None
    tensors: dict[str, Turned] = {}
    inverses: dict[str, Turned] = {}
    for name in rig.bodies:
        own = rig.solid(name)
        tensor = total_rows(own.tensor, about_point(own.mass, arms.get(name, STILL)))
        if own.mass <= 0.0:
            return None
        tensors[name], inverses[name] = tensor, inverted_tensor(tensor)
    fall = scaled(rig.gravity, DOWN)

    def gains(name: str, rows: Turned, omega: Arrow) -> tuple[Arrow, Arrow]:
        back = rows_back(rows)
        own = times_arrow(back, omega)  # in the body's own axes, in which its tensor stays
        moment, arm = crossed(times_arrow(tensors[name], own), own), arms.get(name)
        if arm is None:
            return times_arrow(rows, times_arrow(inverses[name], moment)), fall
        weight = scaled(rig.solid(name).mass, times_arrow(back, fall))
        gain = times_arrow(inverses[name], sum_of(moment, crossed(arm, weight)))
        centre = sum_of(crossed(gain, arm), crossed(own, crossed(own, arm)))
        return times_arrow(rows, gain), times_arrow(rows, centre)

    return gains


def arms_alone(rig: Rig) -> dict[str, Arrow] | None:
    """Of the bodies on ball joints the arms from there to their centres of mass; None where anything else holds or drives a body."""
    if rig.problem.actions or any(body.moved for body in rig.bodies.values()):
        return None
    arms: dict[str, Arrow] = {}
    for joint in rig.joints.values():
        name = joint.body.owner
        if not joint.free or joint.sliding or joint.rolls or joint.carrier.owner in rig.bodies or name in arms:
            return None
        arms[name] = less(rig.solid(name).centre, rig.spot(joint.body))
    return arms


def inverted_tensor(rows: Turned) -> Turned:
    """The inverse of a tensor, Σ n nᵀ/I over its principal axes; of those without inertia, about which a thin rod turns as it did, none."""
    found = moments_and_axes(rows)
    most = max(moment for moment, _ in found)
    parts = [outer(1.0 / moment, way) for moment, way in found if moment > THIN * most]
    return reduce(total_rows, parts, (STILL, STILL, STILL))
