"""Rolled on: a ball that rolls on a floor or a slope, with its weight alone on it, some time after a state.

Its weight acts at its centre and its inertia is the same about all directions, so that force and angular acceleration stay:
ω = ω₀ + α t along each direction of space, and its centre goes r = r₀ + v₀ t + ½ a t² (Routh, Advanced Rigid Dynamics, §231).
"""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import HALF, Formula, add, multiply
from rotsolve.core.equation import IN_TIME, Equation
from rotsolve.core.vectors.triple import AXES, NOTHING, Triple, scaled_by, vector_sum
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.moment import SpaceMoment


def rolls_evenly(before: SpaceLaws, name: str) -> bool:
    """Whether a ball rolls on ground that is at rest, about its centre of mass, and nothing but its weight acts on it besides."""
    held, moment = before.moment.held, before.moment
    joint = held.rolling(name)
    if joint is None or joint.carrier.owner in held.bodies or held.problem.gravity_in:
        return False
    touching = [one for one in held.joints if name in (one.body.owner, one.carrier.owner)]
    acted = any(ref.owner == name for action in before.pushes.actions for ref in action.touches())
    alone = touching == [joint] and not acted and not held.bodies[name].moved
    return alone and moment.seen_from_space(name) and all(map(held.vanishes, moment.arm(joint.body)))


def rolled_rates(name: str, before: SpaceLaws, later: SpaceMoment, time: Formula) -> Iterator[Equation]:
    """ω = ω₀ + α t, along the directions of space."""
    start = before.moment.attitude(name)
    for axis, rate, faster, end in zip(AXES, start.omega, start.alpha, later.attitude(name).omega, strict=True):
        gained = add(rate, multiply(faster, time))
        if end != gained:
            words = f"constant angular acceleration, ω = ω₀ + α t, along {axis}"
            yield IN_TIME.equation(end, gained, later.when, (name,), words=words)


def rolled_way(name: str, before: SpaceLaws, time: Formula) -> Triple:
    """v₀ t + ½ a t² of its centre."""
    velocity, acceleration = (before.moment.of_centre(name, word) for word in ("velocity", "acceleration"))
    gone = scaled_by(time, velocity)
    half = multiply(HALF, multiply(time, time))
    return gone if acceleration == NOTHING else vector_sum(gone, scaled_by(half, acceleration))
