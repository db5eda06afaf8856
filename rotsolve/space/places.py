"""Places in space: where the reference of a body is, as its joints, its state or what leads it tell, or its flight since the first state;
refused by name where nothing does."""

from __future__ import annotations

from rotsolve.algebra.formula import ZERO
from rotsolve.core.vectors.triple import AXES, NOTHING, Triple, minus, scaled_by, triple, unit_along, vector_sum
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.paths.meaning import NotYet
from rotsolve.space.attitude import IN_SPACE
from rotsolve.space.moment import SpaceMoment


def way_to(moment: SpaceMoment, name: str, ref: PointRef) -> Triple:
    """From the reference of a body to a place in space or a point of another body, in the axes of the first: P − r."""
    if ref.place is None:
        refuse_apart(moment, name, ref.owner)
    place = triple(ref.place) if ref.place is not None else point_in_space(moment, ref)
    away = vector_sum(place, minus(reference_place(moment, name)))
    return IN_SPACE.to(moment.axes(name), away)


def refuse_apart(moment: SpaceMoment, one: str, other: str) -> None:
    """Refuse a way between bodies that different joints hold to the ground, where nothing tells how far these are apart."""
    held = moment.held
    joints = []
    for name in (one, other):
        while held.carrier(name):
            name = held.carrier(name)
        joints.append(held.main(name))
    first, last = joints
    if first is None or last is None or first.owner == last.owner:
        return
    if first.carrier.place is None or last.carrier.place is None:
        raise apart_untold(first, last)


def apart_untold(first: Joint, last: Joint) -> NotYet:
    """That nothing tells how far two joints with the ground are apart."""
    message = f"how far `{first.owner}` and `{last.owner}` are apart nothing tells"
    ref = (first if first.carrier.place is None and last.carrier.place is not None else last).body
    point = f"{ref.owner}.{ref.point}" if ref.point else ref.owner
    return NotYet(message, ref.span, f"begin what holds them with their places: `[[x, y, z], {point}]`")


def point_in_space(moment: SpaceMoment, ref: PointRef) -> Triple:
    """A point of a body in space."""
    arm = moment.axes(ref.owner).to(IN_SPACE, moment.arm(PointRef(ref.owner, ref.point or "center", ref.argument)))
    return vector_sum(reference_place(moment, ref.owner), arm)


def reference_place(moment: SpaceMoment, name: str) -> Triple:
    """The point about which a body turns: where its joint holds it, else its centre of mass, of which the state tells the place."""
    joint = moment.held.main(name)
    if joint is not None:
        carrier, gone = joint.carrier, moment.slid_by(joint) if joint.sliding else ZERO
        if carrier.owner in moment.held.bodies:
            arm = moment.axes(carrier.owner).to(IN_SPACE, moment.carried_at(joint))
            return vector_sum(reference_place(moment, carrier.owner), arm)
        start = NOTHING if carrier.place is None else triple(carrier.place)
        return (
            start if gone == ZERO else vector_sum(start, scaled_by(gone, unit_along(joint.sliding[0], moment.positive)))
        )
    led = {axis: value for word, axis, value in moment.held.bodies[name].moved if word == "position"}
    if led:
        return triple([moment.now(led.get(axis, ZERO)) for axis in AXES])
    told = moment.vector_kept(name, "position")
    if told is None:
        return flown_from_told(moment, name)
    place, _, frame = told
    if not frame:
        return place
    return vector_sum(reference_place(moment, frame), moment.own_axes(frame).to(IN_SPACE, place))


def flown_from_told(moment: SpaceMoment, name: str) -> Triple:
    """Where the centre of mass of a free body is, by its flight from a place that a state before tells."""
    if moment.before is not None:
        return reference_place(moment.before, name)
    gone = moment.onward.centre_way(name) if moment.onward is not None else None
    if gone is None or moment.onward is None:
        raise nowhere(moment, name)
    moment.hangs_on_time()
    return vector_sum(reference_place(moment.onward.before.moment, name), gone)


def point_from_start(moment: SpaceMoment, ref: PointRef) -> Triple:
    """A point of a body in space; of a body that nothing holds by its flight too, from the place that is told at first, else from its
    centre of mass there."""
    name = ref.owner
    if moment.held.of_body(name) or moment.held.bodies[name].moved or moment.vector_kept(name, "position") is not None:
        return point_in_space(moment, ref)
    arm = moment.axes(name).to(IN_SPACE, moment.arm(ref))
    return vector_sum(flown_to(moment, name), arm)


def flown_to(moment: SpaceMoment, name: str) -> Triple:
    """Where the centre of mass of a free body is: as told, through a blow as before, else where the time that has passed brings it."""
    if moment.vector_kept(name, "position") is not None:
        return reference_place(moment, name)
    if moment.before is not None:
        return flown_to(moment.before, name)
    if moment.first:
        return NOTHING
    gone = moment.onward.centre_way(name) if moment.onward is not None else None
    if gone is None or moment.onward is None:
        raise nowhere(moment, name)
    moment.hangs_on_time()
    return vector_sum(flown_to(moment.onward.before.moment, name), gone)


def nowhere(moment: SpaceMoment, name: str) -> NotYet:
    """That nothing tells where a body is."""
    return NotYet(
        f"where `{name}` is at `{moment.when}` nothing tells", help=f"tell `{name}.position: [x, y, z]` in the state"
    )
