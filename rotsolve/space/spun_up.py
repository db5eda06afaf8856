"""Spun up: a body on a hinge of the ground of which the angular acceleration stays, with all that it carries.

About the axis n of the hinge n · L = I φ̇ + Σ C ω₃ cos β: with what is clamped to the body going round as one with it, and wheels on its
axles the same all round these, I stays; so does ω₃ of a wheel that turns freely, and one that is driven changes it evenly. Where the torque
about n stays, so does φ̈ (Goldstein, Poole & Safko, Classical Mechanics, §5.1). A wheel that rolls on the ground as it is carried about the
vertical has ω₃ in a fixed ratio to φ̇, and no power: ½ I φ̇² grows by the work of the couple.
"""

from __future__ import annotations

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.symbols import TIME, has_quantities
from rotsolve.core.vectors.triple import NOTHING, Triple, cross_product, rotated, scaled_by, vector_sum, way_between
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.space.attitude import IN_SPACE
from rotsolve.space.inertia import CM
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.places import reference_place
from rotsolve.space.working import carried_with, driving, keeps_axial_rate, lone_wheel, on_wheel_at_rest


def faster_evenly(before: SpaceLaws, name: str) -> Formula | None:
    """φ̈ of a body on a hinge of the ground, where it stays: 0 where nothing turns that; None where it may change."""
    held, moment = before.moment.held, before.moment
    joint, own = held.main(name), held.of_body(name)
    if (
        joint is None
        or not before.fixed(name)
        or held.bodies[name].moved
        or (len(own) > 1 and own != held.supports(name))
    ):
        return None
    if any(one.powered or one.rolls or one.flat for one in own):
        return None
    carried = carried_with(before, name, spins_evenly)
    if carried is None or (not is_upright(before, name, joint) and not weighs_evenly(before, name, joint, carried)):
        return None
    members = (name, *(one.body.owner for one in carried if not held.wheel(one.body.owner)))
    couples = [push for member in members for push in before.pushes.on(member) if push.owner in driving(before)]
    if any(push.force != NOTHING or any(map(has_quantities, push.couple)) for push in couples):
        return None
    strengths = [
        action.strength() for action in before.pushes.actions if action.name in {push.owner for push in couples}
    ]
    if any(map(goes_by_time, strengths)):
        return None
    pushed = bool(couples) or any("angular_acceleration" in dict(one.drive) for one in carried)
    return moment.driven(name, joint, "angular_velocity")[1] if pushed else ZERO


def spins_evenly(laws: SpaceLaws, joint: Joint) -> bool:
    """Whether a joint is the axle of a wheel that turns freely, or with a rate or an angular acceleration that stays, or rolls."""
    if joint.drive:
        return lone_wheel(laws, joint) and even_drive(joint) is not None
    acted = any(ref.owner == joint.body.owner for action in laws.pushes.actions for ref in action.touches())
    return keeps_axial_rate(laws, joint) or (on_wheel_at_rest(laws, joint) and not acted)


def even_drive(joint: Joint) -> Formula | None:
    """0 of a hinge that is driven with a constant angular velocity, α of one with a constant angular acceleration; None of others."""
    if len(joint.drive) != 1 or goes_by_time(joint.drive[0][1]):
        return None
    ((word, value),) = joint.drive
    return {"angular_velocity": ZERO, "angular_acceleration": value}.get(word)


def goes_by_time(value: Formula | Triple | str) -> bool:
    """Whether a value goes by the running time."""
    parts = () if isinstance(value, str) else value if isinstance(value, tuple) else (value,)
    return any(TIME in part.symbols() for part in parts)


def is_upright(before: SpaceLaws, name: str, joint: Joint) -> bool:
    """Whether the axis of a hinge is vertical, or nothing weighs."""
    moment = before.moment
    along = rotated(moment.turned(name), moment.direction(name, joint))
    return before.pushes.gravity is None or all(map(moment.held.vanishes, along[:2]))


def weighs_evenly(before: SpaceLaws, name: str, joint: Joint, carried: list[Joint]) -> bool:
    """Whether the weights of a body on a hinge and of all that it carries have no torque about that however it is turned."""
    moment, held = before.moment, before.moment.held
    hinge = reference_place(moment, name)
    moments = [
        scaled_by(
            held.mass(one), way_between(hinge, vector_sum(reference_place(moment, one), centre_from(before, one)))
        )
        for one in (name, *(one.body.owner for one in carried))
    ]
    way = moment.axes(name).to(IN_SPACE, moment.direction(name, joint))
    rolling = any(other.rolls for one in carried for other in held.of_body(one.body.owner))
    return not rolling and all(map(held.vanishes, cross_product(way, vector_sum(*moments))))


def centre_from(before: SpaceLaws, name: str) -> Triple:
    """The centre of mass of a body from its reference, in space."""
    return before.moment.axes(name).to(IN_SPACE, before.moment.arm(PointRef(name, CM)))
