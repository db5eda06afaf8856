"""Work in space: the energy of a body on a hinge that is pushed on the way, carries what is clamped to it, or is carried along.

A couple that stays does the work M · n Δφ about the axis n, a force that stays F · Δr. In axes that go with what carries the hinge, and
that do not turn, −M a acts at the centre of mass as the weight does (Goldstein, Poole & Safko, Classical Mechanics, §1.5 and §4.10).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from rotsolve.algebra.formula import ZERO, Formula, add, multiply, negate
from rotsolve.core.drive import TURNING
from rotsolve.core.equation import CONSERVATION, FROM_STATE_TO_STATE, MOMENTUM, WORK_AND_ENERGY, Equation
from rotsolve.core.symbols import TIME, has_quantities
from rotsolve.core.vectors.triple import NOTHING, Triple, Z, dot_product, scaled_by, vector_sum, way_between
from rotsolve.core.writing import spoken
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.motion.timeline import Interval
from rotsolve.space.attitude import IN_SPACE
from rotsolve.space.energies import energy_of, half_quadratic
from rotsolve.space.inertia import CM
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.places import reference_place
from rotsolve.space.pushes import ForceInSpace


def of_work(name: str, interval: Interval, before: SpaceLaws, after: SpaceLaws) -> Iterator[Equation]:
    """K₁ + U₁ + W = K₂ + U₂ of a body on a hinge, in axes that go with what carries it; not where anything else holds it."""
    held = before.moment.held
    joint = held.main(name)
    if joint is None or held.of_body(name) != (joint,) or not turns_undriven(joint):
        return
    carrier, clamped = held.bodies.get(joint.carrier.owner), carried_with(before, name)
    members = (name, *(clamp.body.owner for clamp in clamped or ()))
    pushes = [
        [push for member in members for push in laws.pushes.on(member) if push.owner in driving(laws)]
        for laws in (before, after)
    ]
    if clamped is None or (carrier is not None and (clamped or not led_evenly(before, carrier.name))):
        return
    if not all(map(keeps, *pushes)):
        return
    work = total_work(name, joint, (before, after), pushes)
    if work is None:
        return
    first, last = (
        sum((energy_of(laws, member) for member in members[1:]), felt_energy(laws, name, joint))
        for laws in (before, after)
    )
    since = "" if carrier is None else f" in axes that go with {carrier.name}, where −M a acts"
    if work == ZERO:
        yield CONSERVATION.equation(first, last, interval.name, members, since=since, form=FROM_STATE_TO_STATE)
    else:
        yield WORK_AND_ENERGY.equation(add(first, work), last, interval.name, members)


def goes_by_itself(laws: SpaceLaws, joint: Joint) -> bool:
    """Whether a joint is the axle of a rotor whose axial rate is kept, or of a wheel that rolls on what is at rest."""
    return keeps_axial_rate(laws, joint) or on_wheel_at_rest(laws, joint)


def carried_with(
    laws: SpaceLaws, name: str, spins: Callable[[SpaceLaws, Joint], bool] = goes_by_itself
) -> list[Joint] | None:
    """The clamps by which bodies are fast on one, and on those, and the axles on which something `spins`.

    None where something else that it carries moves on it, or is held besides.
    """
    held, found = laws.moment.held, []
    for joint in (joint for joint in held.joints if joint.carrier.owner == name):
        moves = joint.turning or joint.sliding or joint.free or joint.rolls or joint.flat or joint.powered
        rotor = spins(laws, joint)
        further = [] if rotor else None if moves else carried_with(laws, joint.body.owner, spins)
        if further is None or not (rotor or held.of_body(joint.body.owner) == (joint,)):
            return None
        found += [joint, *further]
    return found


def keeps_axial_rate(laws: SpaceLaws, joint: Joint) -> bool:
    """Whether a joint is the axle of a rotor that turns freely on it.

    No torque acts along the axle, so that ω along it stays, whatever carries it does (Euler's equation with I₁ = I₂).
    """
    return not joint.powered and lone_wheel(laws, joint)


def lone_wheel(laws: SpaceLaws, joint: Joint) -> bool:
    """Whether a joint is the axle of a wheel that is the same all round it, which carries nothing and on which but its weight nothing
    acts."""
    held, name = laws.moment.held, joint.body.owner
    if not joint.aligned or held.carrier(name) == "" or held.of_body(name) != (joint,):
        return False
    acted = any(ref.owner == name for action in laws.pushes.actions for ref in action.touches())
    carries = any(other.carrier.owner == name for other in held.joints)
    return held.wheel(name) and not (acted or carries)


def on_wheel_at_rest(laws: SpaceLaws, joint: Joint) -> bool:
    """Whether a joint is the axle of a wheel that carries nothing and rolls on what is at rest, which gives it no power there."""
    held, name = laws.moment.held, joint.body.owner
    others = [other for other in held.of_body(name) if other is not joint]
    touching = bool(others) and all(other.rolls and other.carrier.owner not in held.bodies for other in others)
    carries = any(other.carrier.owner == name for other in held.joints)
    return touching and joint.aligned and not joint.powered and held.wheel(name) and not carries


def of_rotor(name: str, interval: Interval, before: SpaceLaws, after: SpaceLaws) -> Iterator[Equation]:
    """ω₃ of a rotor along the axle on which another body carries it, against the ground, which stays."""
    joint = before.moment.held.main(name)
    if joint is None or not keeps_axial_rate(before, joint):
        return
    own = [laws.moment.attitude(name) for laws in (before, after)]
    first, last = (dot_product(item.about, item.omega) for item in own if item.about is not None)
    words = f"ω along its axle, about which no torque acts, {spoken(name)}"
    yield MOMENTUM.equation(first, last, interval.name, (name,), words=words)


def place_from_hinge(laws: SpaceLaws, name: str, push: ForceInSpace) -> Triple:
    """Where a push acts on a body on a hinge, or on what is clamped to it, from the hinge, in space."""
    arm = laws.moment.axes(push.body).to(IN_SPACE, push.arm)
    if push.body == name:
        return arm
    hinge, clamp = (reference_place(laws.moment, one) for one in (name, push.body))
    return vector_sum(way_between(hinge, clamp), arm)


def driving(laws: SpaceLaws) -> frozenset[str]:
    return frozenset(action.name for action in laws.pushes.actions)


def turns_undriven(joint: Joint) -> bool:
    """Whether a joint is a hinge on which its body turns as it is pushed; two bearings push through the axis, and give no power."""
    return bool(joint.turning) and not (joint.powered or joint.sliding or joint.aligned or joint.pitch)


def led_evenly(laws: SpaceLaws, carrier: str) -> bool:
    """Whether a body is led along with an acceleration that stays, and does not turn."""
    moved = laws.moment.held.bodies[carrier].moved
    words = {word for word, _, value in moved if word in TURNING or TIME in value.symbols()}
    return bool(moved) and not words and not laws.moment.held.of_body(carrier)


def keeps(first: ForceInSpace, last: ForceInSpace) -> bool:
    """Whether a push is the same at both ends, whatever the time and however the body has moved."""
    parts = (*first.force, *first.couple)
    level = first.axes == last.axes == IN_SPACE or first.force == NOTHING
    same = (first.force, first.couple) == (last.force, last.couple)
    return level and same and not any(TIME in part.symbols() or has_quantities(part) for part in parts)


def total_work(
    name: str, joint: Joint, ends: tuple[SpaceLaws, SpaceLaws], pushes: list[list[ForceInSpace]]
) -> Formula | None:
    """W = Σ F · Δr + M · n Δφ; None where nothing tells how far the body has turned."""
    work: Formula = ZERO
    angles = [laws.moment.stood(name, "angle") for laws in ends]
    axes = ends[0].moment.axes(name)
    for first, last in zip(*pushes, strict=True):
        if first.couple != NOTHING:
            if angles[0] is None or angles[1] is None:
                return None
            along = dot_product(ends[0].moment.direction(name, joint), first.axes.to(axes, first.couple))
            work = add(work, multiply(along, add(angles[1], negate(angles[0]))))
        if first.force != NOTHING:
            one, other = (place_from_hinge(laws, name, push) for laws, push in zip(ends, (first, last), strict=True))
            work = add(work, dot_product(first.force, way_between(one, other)))
    return work


def felt_energy(laws: SpaceLaws, name: str, joint: Joint) -> Formula:
    """½ ω · I ω about the point held, with M (g ẑ + a) · r of the centre of mass from there."""
    moment, gravity = laws.moment, laws.pushes.gravity
    own = moment.attitude(name)
    carried = joint.carrier.owner in moment.held.bodies
    lift: Triple = NOTHING if gravity is None else scaled_by(gravity, Z)
    if carried:
        lift = vector_sum(lift, own.axes.to(IN_SPACE, moment.reference_acceleration(name)))
    place = own.axes.to(IN_SPACE, moment.arm(PointRef(name, CM)))
    turning = half_quadratic(laws.tensor(name, joint.body.point or "center"), own.omega)
    return add(turning, multiply(moment.held.mass(name), moment.tidy(dot_product(lift, place))))
