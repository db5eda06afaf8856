"""Weight that turns with a body: g along its own −z, as a plumb line on the earth hangs, and how what nothing holds falls by that.

In space −g ẑ′ goes round the axis n of the body at its steady rate Ω: with k = ẑ′ at first, p = (n·k) n, u = k − p and q = n × k,
ẑ′ = p + u cos Ω t + q sin Ω t, so that the velocity loses g (p t + u sin Ω t/Ω + q (1 − cos Ω t)/Ω) and the place
g (½ p t² + u (1 − cos Ω t)/Ω² + q (Ω t − sin Ω t)/Ω²). In the axes of the body that is r̈ = −g ẑ′ − 2 Ω × ṙ − Ω × (Ω × r) with
r from its axis (Goldstein, Poole & Safko, Classical Mechanics, §4.10; Marion & Thornton, Classical Dynamics, §10.4).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.formula import HALF, ONE, ZERO, Formula, add, multiply, negate
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import heading
from rotsolve.core.vectors.triple import (
    NOTHING,
    Triple,
    Z,
    cross_product,
    dot_product,
    scaled_by,
    vector_sum,
    way_between,
)
from rotsolve.space.attitude import IN_SPACE

if TYPE_CHECKING:
    from rotsolve.space.arrangement import JointedBodies
    from rotsolve.space.moment import SpaceMoment

HELP = "leave `in: {}` out of `gravity`: then it keeps its direction in space"


def refuse_weight_in_frame(held: JointedBodies) -> None:
    """Refuse weight that turns with what is not driven steadily on the ground, and with joints that hold what it pulls."""
    frame = held.problem.gravity_in
    joint = held.main(frame)
    steady = joint is not None and joint.turning and joint.carrier.owner not in held.bodies
    if joint is None or not steady or "angular_velocity" not in dict(joint.drive) or not held.driven_evenly(joint):
        message = f"gravity turns with `{frame}`, and no hinge on the ground turns that at a steady `angular_velocity`"
        help = f"`hinge: {frame}.P, along: [0, cos(lambda), sin(lambda)], angular_velocity: w`"
        raise Unsolvable(message, span=held.bodies[frame].span, help=help)
    for other in held.joints:
        for name in {other.body.owner, other.carrier.owner} & held.bodies.keys() - {frame}:
            if held.mass(name) != ZERO:
                message = f"`{other.owner}` holds `{name}`, whose weight turns with `{frame}`: that is not solved"
                help = f"`rotsolve simulate` follows it; {HELP.format(frame)}"
                raise Unsolvable(message, span=other.body.span, help=help)


class Falling(Struct, frozen=True):
    """How weight that turns with a body lets fall what nothing holds, from a moment on, for a unit of g."""

    along: Triple  # the part of ẑ′ along the axis, which stays
    across: Triple
    square: Triple
    rate: Formula

    def speed(self, time: Formula) -> Triple:
        """∫ ẑ′ dt."""
        angle = heading(multiply(self.rate, time))
        return self.mixed(time, angle.sin() / self.rate, add(ONE, negate(angle.cos())) / self.rate)

    def way(self, time: Formula) -> Triple:
        """∫∫ ẑ′ dt dt."""
        turned, squared = multiply(self.rate, time), multiply(self.rate, self.rate)
        angle = heading(turned)
        gone = add(ONE, negate(angle.cos())) / squared, add(turned, negate(angle.sin())) / squared
        return self.mixed(multiply(HALF, multiply(time, time)), *gone)

    def mixed(self, along: Formula, across: Formula, square: Formula) -> Triple:
        return vector_sum(scaled_by(along, self.along), scaled_by(across, self.across), scaled_by(square, self.square))


def falling_from(moment: SpaceMoment) -> Falling:
    """How weight that turns with a body lets things fall from a moment on."""
    frame = moment.held.problem.gravity_in
    joint = moment.held.main(frame)
    assert joint is not None
    rate, up = moment.rate_on(frame, joint), moment.own_axes(frame).to(IN_SPACE, Z)
    if moment.held.vanishes(rate):
        return Falling(up, NOTHING, NOTHING, ONE)
    way = moment.axes(frame).to(IN_SPACE, moment.direction(frame, joint))
    along = scaled_by(dot_product(way, up), way)
    return Falling(along, way_between(along, up), cross_product(way, up), rate)
