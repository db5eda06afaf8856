"""Constraints: what each connection holds, as functions of places. A connection without a row here is refused."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.jet import Jet
from rotsolve.confirm.pose import Pair, Pose, Way, along, turned
from rotsolve.confirm.rows import Grip, Row, held
from rotsolve.confirm.signs import GROUND, RIGHT, carrier_of, normal, rests, surface_of
from rotsolve.core.drive import BY_INERTIA, TURNING
from rotsolve.elements.asked import derives_from, home_of_kind, is_curved, is_touch
from rotsolve.elements.connections.supports import Axle, Driven, Hinge, Mounted, Weld
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Connection

if TYPE_CHECKING:
    from rotsolve.confirm.known import Known

Held = Iterator[Row | Grip]
Rows = Callable[[Any, "Pose", "Known"], Held]


def held_by(model: Known, pose: Pose) -> Held:
    """All that connections, joints that events have made, and lines of travel hold."""
    for item in model.acting.connections:
        yield from rows_of(type(item))(item, pose, model)
    for event in model.acting.joined():
        yield from together(event.name, event.joined(), pose, model, offset=True)
    for name in model.guided:
        across = turned(model.line(name) or RIGHT)
        yield held(name, "line", along(pose.place(name, model.seats[name].rigid.centre), across), pose)
        if not model.turns(name) and model.seats[name].rigid.inertia > 0.0:
            yield held(name, "turn", pose.turn(name), pose)


def rows_of(kind: type[Connection]) -> Rows:
    """What a connection of a kind holds; the rows of what few scenes have are loaded where one has it."""
    found = plain_rows(kind)
    if found is not None:
        return found
    from rotsolve.confirm.couplings import COUPLINGS

    return COUPLINGS.get(home_of_kind(kind), refused)


def plain_rows(kind: type[Connection]) -> Rows | None:
    """What a connection of a kind that most scenes have holds, which loads nothing by itself."""
    if derives_from(kind, "connections.touch", "Touch"):
        from rotsolve.confirm.touches import TOUCHES

        return TOUCHES.get(kind)
    if derives_from(kind, "connections.strings", "String"):
        from rotsolve.confirm.strings import STRINGS

        return STRINGS.get(kind)
    return ROWS.get(kind)


def refused(item: Connection, pose: Pose, model: Known) -> Held:
    raise NotConfirmed(f"`{item.name}`: the assembly has no rows for `{item.word}`")


def place_of(ref: PointRef, pose: Pose, model: Known) -> Pair:
    """Where a point is; what does not turn with a wheel (its top) is the point as drawn."""
    if ref.place is not None:
        x, y = (Jet(model.value(part)) for part in ref.place)
        return x, y
    if ref.owner not in model.seats:
        return Jet(0.0), Jet(0.0)
    return pose.place(ref.owner, model.drawn(ref))


def tied_at(ref: PointRef, pose: Pose, model: Known) -> Pair:
    """Where a string, a spring or a surface meets a body: at a named point, else in the middle of it."""
    if ref.place is not None or ref.owner not in model.seats:
        return place_of(ref, pose, model)
    return pose.place(ref.owner, model.tied(ref))


def hinge(item: Hinge, pose: Pose, model: Known) -> Held:
    """A point stays where it is, or goes with the point of another body."""
    x, y = place_of(item.hinge[-1], pose, model)
    carrier = item.hinge[0] if len(item.hinge) > 1 and item.hinge[0].owner not in GROUND else None
    if carrier is not None:
        u, w = place_of(carrier, pose, model)
        x, y = x - u, y - w
    yield held(item.name, "x", x, pose, hard=carrier is not None)
    yield held(item.name, "y", y, pose, hard=carrier is not None)
    yield from driven(item, (item.hinge[-1],), carrier, pose, model)


def axle(item: Axle, pose: Pose, model: Known) -> Held:
    """The centres of wheels stay where they are, or go with the body that carries them."""
    carrier = carrier_of(item, model)
    wheels = tuple(ref for ref in item.axle if ref is not carrier)
    for ref in wheels:
        x, y = place_of(ref, pose, model)
        if carrier is not None:
            u, w = place_of(carrier, pose, model)
            x, y = x - u, y - w
        tail = f"_{ref.owner}" if len(item.axle) > 1 else ""
        yield held(item.name, f"x{tail}", x, pose, hard=carrier is not None)
        yield held(item.name, f"y{tail}", y, pose, hard=carrier is not None)
    yield from driven(item, wheels, carrier, pose, model)


def driven(item: Driven, refs: tuple[PointRef, ...], carrier: PointRef | None, pose: Pose, model: Known) -> Held:
    """A turn that is given as a function of time, and friction of the axis: a couple of limited size."""
    for ref in dict.fromkeys(ref.owner for ref in refs):
        turn = pose.turn(ref) - (pose.turn(carrier.owner) if carrier is not None else 0.0)
        given = [(word, getattr(item, word)) for word in TURNING if getattr(item, word) is not None]
        for word, value in given:
            sign = 1 if word == "angle" else model.sense(ref)
            coordinate = turn + model.lean(ref) if word == "angle" else turn
            row = prescribed(item.name, f"torque_{ref}", coordinate, TURNING.index(word), sign, value, pose, model)
            yield row if word == given[-1][0] else replace(row, kind=f"{word}_{ref}", bend=None)
        for word, value in ((word, getattr(item, word)) for word in BY_INERTIA):
            if value is not None:
                from rotsolve.confirm.couplings import led_by_inertia

                yield led_by_inertia(item.name, ref, word, value, pose, model)
        if item.rubbing():
            size = rubs_with(item, pose, model)
            yield Grip(f"{item.name}.{ref}", held(item.name, f"torque_{ref}", turn, pose), size, size)


def rubs_with(item: Driven, pose: Pose, model: Known) -> float:
    """The torque with which an axis rubs: told, or of a collar that is pressed on its bearing."""
    if item.friction_torque is not None:
        return model.now(item.friction_torque, pose)
    from rotsolve.confirm.faces import collar

    return collar(item, model)


def prescribed(
    owner: str, kind: str, coordinate: Jet, order: int, sign: int, value: Formula, pose: Pose, model: Known
) -> Row:
    """A coordinate, its rate or its acceleration is a given function of time."""
    target = model.running(value, pose)
    if not isinstance(target, Jet):
        target = Jet(target)
    if order == 0:
        return held(owner, kind, coordinate - target, pose, hard=True)
    slope = coordinate.slope
    if order == 1:
        return Row(owner, kind, slope, sign * target.value, sign * target.rate - coordinate.bend, slope)
    return Row(owner, kind, slope, None, sign * target.value - coordinate.bend, slope)


def weld(item: Weld, pose: Pose, model: Known) -> Held:
    yield from together(item.name, item.weld, pose, model, offset=False)


def together(owner: str, refs: tuple[PointRef, ...], pose: Pose, model: Known, *, offset: bool) -> Held:
    """Two bodies are one: their points meet, and they turn as one; `offset`, where they meet at any angle."""
    first, second = refs
    (x, y), (u, w) = (
        met_at(owner, ref, pose, model) if offset else place_of(ref, pose, model) for ref in (second, first)
    )
    turn = pose.turn(second.owner) - pose.turn(first.owner)
    apart = None if offset else model.told_apart(first.owner, second.owner)
    points, gap = not (offset and model.bodily(refs)), (x - u, y - w)
    way = led_apart(first.owner, second.owner, model)
    twist = held(owner, "torque", turn - (apart or 0.0), pose, hard=not offset)
    if way is not None:
        yield held(owner, "along", along(gap, way), pose, hard=points)
        yield replace(held(owner, "across", along(gap, turned(way)), pose, hard=points), loose=True)
        yield replace(twist, loose=True)
        return
    yield held(owner, "x", gap[0], pose, hard=points)
    yield held(owner, "y", gap[1], pose, hard=points)
    yield twist


def led_apart(first: str, second: str, model: Known) -> Way | None:
    """The way along which two joined bodies go that lie on flat surfaces, each on one of its own, none that is one with them turning.

    Each is carried by what it lies on, which keeps it from turning too: only what acts along the way goes from one to the other.
    """
    group = model.joined_to(first)
    lying = [item for item in model.acting.connections if is_touch(item) and item.lying() in group]
    if not {first, second} <= {item.lying() for item in lying} or any(map(model.turns, group)):
        return None
    surfaces = [surface_of(item, model) if rests(item, model) else None for item in lying]
    if any(surface is None or is_curved(surface) for surface in surfaces):
        return None
    (x, y), *others = (turned(normal(surface, model)) for surface in surfaces if surface is not None)
    return (x, y) if all(abs(x * w - y * u) < 1e-9 for u, w in others) else None


def met_at(owner: str, ref: PointRef, pose: Pose, model: Known) -> Pair:
    """Where bodies met in an event: the point of a rim that was in that direction then."""
    now = pose.q[model.seats[ref.owner].turn]
    return pose.place(ref.owner, model.meeting(ref, pose.offsets.get(f"{owner}.{ref.owner}", now)))


ROWS: dict[type[Connection], Rows] = {  # of what most scenes have
    Hinge: hinge,
    Axle: axle,
    Mounted: axle,
    Weld: weld,
}
