"""Rolling in space: a round rim that touches a level floor at its lowest point, which is at rest for a moment.

In node axes the lowest point of a rim of radius R about e₃ is −R e₂ from its centre; v = ω × R e₂ of the centre follows, and its
acceleration in axes that turn: (rates of the components) + Ω × v. No component may be integrated: the constraint is nonholonomic.
"""

from __future__ import annotations

from rotsolve.algebra.formula import Formula, negate
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.triple import Triple, Y, Z, cross_product, dot_product, minus, scaled_by, vector_sum
from rotsolve.elements.shapes import rim_radius, shape_of
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.space.attitude import IN_SPACE, NODE, MovingBodies


def rolling_radius(joint: Joint, moment: MovingBodies) -> Formula:
    """The radius of what rolls."""
    radius = rim_radius(moment.held.bodies[joint.body.owner], joint.body.point)
    if radius is None:
        raise Unsolvable(f"`{joint.body.owner}` has no rim on which it could roll", span=joint.body.span)
    return radius


def is_ball(name: str, moment: MovingBodies) -> bool:
    """Whether a body is a sphere, which touches the floor right below its centre however it is turned."""
    body = moment.held.bodies[name]
    return shape_of(body).spherical and not (body.parts or body.holes)


def lowest(joint: Joint, moment: MovingBodies) -> Triple:
    """Where a body touches the floor, from its reference, in its axes: of a thin wheel its lowest point, however it leans."""
    name, radius = joint.body.owner, rolling_radius(joint, moment)
    own, hub = moment.attitude(name), moment.arm(PointRef(name, joint.body.point or "center"))
    if is_ball(name, moment):
        return vector_sum(hub, IN_SPACE.to(own.axes, scaled_by(negate(radius), Z)))
    up = IN_SPACE.to(own.axes, Z)
    about = moment.symmetry_axis(name)
    level = about is not None and moment.held.vanishes(dot_product(up, about))
    thin = shape_of(moment.held.bodies[name]).flat
    if own.axes.name == NODE and (thin or level):
        return vector_sum(hub, scaled_by(negate(radius), Y))
    if not level:
        help = (
            f"tell `{name}.tilt` in the state"
            if thin
            else "solved are thin wheels, balls, and wheels whose axis is level"
        )
        raise Unsolvable(f"where `{name}` touches the floor nothing tells", span=joint.body.span, help=help)
    return vector_sum(hub, scaled_by(negate(radius), up))


def centre_velocity(joint: Joint, moment: MovingBodies) -> Triple:
    """v = −ω × r of the centre, since the point at r is at rest, in the axes of the body."""
    own = moment.attitude(joint.body.owner)
    return minus(cross_product(own.omega, lowest(joint, moment)))


def centre_acceleration(joint: Joint, moment: MovingBodies) -> Triple:
    """The rate of that: r keeps its components in the node axes, and in space below a ball."""
    name = joint.body.owner
    own, arm = moment.attitude(name), lowest(joint, moment)
    if is_ball(name, moment):
        return minus(cross_product(own.alpha, arm))
    return vector_sum(
        minus(cross_product(own.rates, arm)), cross_product(own.axes.rate, centre_velocity(joint, moment))
    )
