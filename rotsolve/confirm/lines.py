"""Lines: what the lines of a state say about places and rates, as equations of the coordinates."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import on_rim, radius_of
from rotsolve.confirm.jet import Jet, Slope, arctangent, cosine, distance, merged, sine
from rotsolve.confirm.pose import Pair, Pose, Way, along, load
from rotsolve.confirm.rows import Grip, Row
from rotsolve.confirm.sides import from_middle, gone_down, on_round_side, on_side, way_round
from rotsolve.confirm.signs import RIGHT, UP, carrier_travels, round_way, surface_of, taken_from_under
from rotsolve.elements.asked import is_curved, is_drapes, is_touch
from rotsolve.language.bodies import PointRef
from rotsolve.language.problem import Condition, Path

if TYPE_CHECKING:
    from rotsolve.confirm.known import Known
    from rotsolve.elements.connections.touch import Touch
    from rotsolve.elements.surfaces import Curved


class Stated(Struct, frozen=True):
    """A line as an equation: a place (`gap` is to become 0 along `slope`), or a rate (slope · q̇ = speed), of which one that is `sized`
    tells the size alone: where other lines tell all rates in it, it has their sense."""

    slope: Slope
    gap: float | None
    speed: float | None
    path: str = ""
    sized: bool = False


EXTREMES = ("largest", "smallest")
ELSEWHERE = (  # what lines say that is no place and no rate at the instant itself
    "mass", "inertia", "gyration", "time", "swing_period", "frequency", "angular_frequency", "acceleration",
    "angular_acceleration", "force", "tension", "torque", "normal_force", "friction_force", "friction", "impulse", "",
)  # fmt: skip


def told(model: Known, pose: Pose, sticking: dict[str, Row | Grip]) -> Iterator[Stated]:
    """All lines of the model's state."""
    state = model.acting.state
    if state.balance or state.steady:
        yield from resting(model, tuple(model.seats))
    for line in state.conditions:
        if line.rest:
            if line.owner in ("all", ""):
                yield from resting(model, tuple(model.seats))
            elif (away := from_axis(line.owner, pose, model)) is not None:  # what rides rests on what carries it
                yield Stated(away.slope, None, 0.0)
            else:
                yield from resting(model, (line.owner,))
        elif line.word in ("rolls", "sticks"):
            grip = sticking.get(line.owner or (line.path.owner if line.path else ""))
            if isinstance(grip, Grip):
                yield Stated(grip.row.slope, None, grip.row.speed)
        elif line.path is not None and line.word in EXTREMES:
            yield from at_extreme(line.path, pose, model)
        elif line.path is not None and line.value is not None:
            yield from valued(line, line.path, model.value(line.value), pose, model)


def resting(model: Known, names: Sequence[str]) -> Iterator[Stated]:
    for name in names:
        if name in model.seats:
            yield from (
                Stated({index: 1.0}, None, 0.0) for index in range(model.seats[name].first, model.seats[name].turn + 1)
            )


def at_extreme(path: Path, pose: Pose, model: Known) -> Iterator[Stated]:
    """What is largest or smallest does not change just then."""
    if path.quantity in ("angle", "rotation", "displacement", "height", "position", "elongation", "length"):
        place = placed_value(path, pose, model)
        if place is not None:
            yield Stated(place.slope, None, 0.0)


def valued(line: Condition, path: Path, value: float, pose: Pose, model: Known) -> Iterator[Stated]:
    """A quantity has a value."""
    name = f"{path.owner}.{path.quantity}"
    away = from_axis(path.owner, pose, model) if path.quantity == "radius" else None
    if away is not None:
        yield Stated(away.slope, away.value - value, None, name)
    if path.quantity in ELSEWHERE or path.quantity in ("elongation", "radius"):
        return
    if path.quantity == "length" and pose.offsets.get(path.owner) is None:
        return
    if path.quantity in ("rotation", "displacement") and pose.origin is pose.q:  # at the first state they are 0
        return
    rate = rate_of(path, pose, model)
    if rate is not None:
        slope, sign = rate
        yield Stated(slope, None, goal_of(path, value) * sign, name, sized=path.quantity in SIZED)
        return
    place = placed_value(path, pose, model)
    if place is None and path.quantity == "length":
        return
    if place is None:
        raise NotConfirmed(f"a state that tells `{name}`")
    gap = place.value - value
    if path.quantity == "angle" and path.owner not in model.seats and not wound_by(path.owner, model):
        gap = math.remainder(gap, 2 * math.pi)
    yield Stated(place.slope, gap, None, name)


SIZED = ("speed", "kinetic_energy")  # what tells how fast, and not which way


def goal_of(path: Path, value: float) -> float:
    """What a rate is to become by a line: of a period 2 π/T, of a kinetic energy √(2 K)."""
    if path.quantity == "kinetic_energy":
        return math.sqrt(max(2.0 * value, 0.0))
    return 2 * math.pi / value if path.quantity == "period" else value


def placed_value(path: Path, pose: Pose, model: Known) -> Jet | None:
    """A place that a path speaks of."""
    if path.owner in model.seats and (path.quantity, path.point) == ("displacement", "cm") and path.component:
        axis = RIGHT if path.component == "x" else UP
        return along(pose.moved(path.owner, model.seats[path.owner].rigid.centre), axis)
    if path.owner in model.seats and path.point is None:
        seat, sign = model.seats[path.owner], model.sense(path.owner)
        if path.quantity == "angle":
            return pose.turn(path.owner) + model.lean(path.owner)
        if path.quantity == "rotation":
            return (pose.turn(path.owner) - pose.origin[seat.turn]) * float(sign)
        spot = model.travelling(path.owner)
        place = pose.place(path.owner, spot)
        if path.quantity == "displacement":
            way = {"x": RIGHT, "y": UP}.get(path.component or "") or model.line(path.owner)
            return along(pose.moved(path.owner, spot), way) if way is not None else arc(path.owner, pose, model)
        if path.quantity == "position":
            return place["xy".index(path.component or "x")]
        if path.quantity == "height":
            return height(path.owner, pose, model)
        if path.quantity == "radius":
            return from_axis(path.owner, pose, model)
        return None
    contact = next((item for item in model.acting.connections if item.name == path.owner), None)
    if path.quantity == "displacement" and (item := on_side(path.owner, model)) is not None:
        return gone_down(item, pose, model, gone=True)
    if is_drapes(contact) and path.quantity == "length":
        from rotsolve.confirm.carried import hanging

        return hanging(contact, pose, model) + pose.offsets.get(contact.name, 0.0)
    if is_touch(contact) and path.quantity == "angle":
        surface = surface_of(contact, model)
        if is_curved(surface):
            x, y = from_middle(contact, pose, model)
            return arctangent(y, x)
    if path.quantity == "angle" and (wound := wound_by(path.owner, model)):
        return twist(wound, pose, model)
    if contact is not None and path.quantity in ("angle", "rotation"):
        owners = [ref.owner for ref in contact.between() or contact.joint() or contact.fixed_points()]
        owners = [owner for owner in owners if owner in model.seats]
        if len(owners) == 1:
            return pose.turn(owners[0]) + model.lean(owners[0])
        if len(owners) == 2:
            return (pose.turn(owners[1]) - pose.turn(owners[0])) * float(model.sense(owners[1]))
    return None


def wound_by(name: str, model: Known) -> list[str]:
    """The bodies that a wire winds; none of what is no wire."""
    items = (item for item in model.acting.connections if item.name == name)
    return [ref.owner for item in items for ref in item.winds() if ref.owner in model.seats]


def twist(wound: Sequence[str], pose: Pose, model: Known) -> Jet:
    """The angle of the body that a wire winds; of two that of the last less that of the first."""
    angles = [pose.turn(name) + model.lean(name) for name in wound]
    return angles[-1] - angles[0] if len(angles) == 2 else angles[0]


def once_round(path: Path, model: Known) -> float | None:
    """How much a place on a curved surface grows on the way once round it, where it reads as it began; None of other places."""
    contact = next((item for item in model.acting.connections if item.name == path.owner), None)
    if path.quantity == "angle" and is_touch(contact):
        return 2 * math.pi
    found = bent(path.owner, model) if path.quantity == "displacement" and path.component is None else None
    return 2 * math.pi * circle_of(found, model) if found is not None else None


def from_axis(name: str, pose: Pose, model: Known) -> Jet | None:
    """How far from the axis a body is that rides on another; right on the axis it goes out along the line of what carries it."""
    for item in model.acting.connections:
        ride = item.ride()
        if ride is not None and ride.rider.owner == name:
            x, y = pose.place(name, model.seats[name].rigid.centre)
            u, w = pose.place(ride.carrier.owner, model.axis(ride.carrier.owner))
            if x.value != u.value or y.value != w.value:
                return distance(x - u, y - w)
            turn = pose.turn(ride.carrier.owner)
            return (x - u) * cosine(turn) + (y - w) * sine(turn)
    return None


def bent(name: str, model: Known) -> tuple[Touch, Curved] | None:
    """The contact by which a body is on a curved surface of known form that does not move."""
    found = on_curve(name, model)
    return None if found is None or found[0].side is not None else found


def on_curve(name: str, model: Known) -> tuple[Touch, Curved] | None:
    """The contact by which a body is on a curved surface of known form."""
    for item in model.acting.connections:
        if is_touch(item) and item.lying() == name:
            surface = surface_of(item, model)
            if is_curved(surface) and surface.radius() is not None and not carrier_travels(item, model):
                return item, surface
    return None


def onward(name: str, pose: Pose, model: Known) -> Way | None:
    """The way in which a body travels just now: along the curved surface on which it is, else along its line."""
    found = bent(name, model)
    if found is None:
        return model.line(name)
    x, y = (part.value for part in from_middle(found[0], pose, model))
    size, sign = math.hypot(x, y), round_way(found[1], model.body(name).moves)
    return (-y * sign / size, x * sign / size)


def left_from(name: str, model: Known) -> tuple[Touch, Curved] | None:
    """The contact by which a body that flies now was on a curved surface of known form."""
    lying = {item.lying() for item in model.acting.connections}
    for item in taken_from_under(model) if name not in lying else ():
        names = {ref.owner for ref in item.places()} | ({item.side.name} if item.side is not None else set())
        places = [surface for surface in model.problem.surfaces if surface.name in names]
        curved = [surface for surface in places if is_curved(surface) and surface.radius() is not None]
        if item.lying() == name and curved:
            return item, curved[0]
    return None


def circle_of(found: tuple[Touch, Curved], model: Known) -> float:
    """The radius of the circle on which the centre of a body goes."""
    item, surface = found
    ref, size = item.pair()[0], surface.radius()
    body = model.body(ref.owner)
    rim = (radius_of(body, ref.point, model.value) or 0.0) if on_rim(body, ref.point) else 0.0
    return (model.value(size) if size is not None else 0.0) + (rim if surface.outside else -rim)


def height(name: str, pose: Pose, model: Known) -> Jet | None:
    """Of a body on a curved surface, or that has left one: above the centre of a dome, above the lowest place in a bowl."""
    found = on_curve(name, model) or left_from(name, model)
    if found is None:
        return None
    return from_middle(found[0], pose, model)[1] + (0.0 if found[1].outside else circle_of(found, model))


def arc(name: str, pose: Pose, model: Known) -> Jet | None:
    """The way along a curved surface, positive as the body moves."""
    found = bent(name, model)
    if found is None:
        return None
    x, y = pose.place(name, (0.0, 0.0))
    seat = model.seats[name]
    began = math.atan2(pose.origin[seat.first + 1], pose.origin[seat.first])
    return (arctangent(y, x) - began) * (circle_of(found, model) * round_way(found[1], model.body(name).moves))


def rate_of(path: Path, pose: Pose, model: Known) -> tuple[Slope, float] | None:
    """A rate that a path speaks of: slope · q̇ is sign times it."""
    word, name = path.quantity, path.owner
    if name in model.seats:
        if word in ("angular_velocity", "period") and path.point is None:
            return {model.seats[name].turn: 1.0}, float(1 if path.component == "z" else model.sense(name))
        if word in ("velocity", "speed"):
            place = pointed(path, pose, model)
            way = direction(path, place, pose, model)
            return None if way is None else (load(place, way), 1.0)
        return momentum_rate(path, pose, model)
    if word == "velocity" and (sliding := on_side(name, model)) is not None:
        return gone_down(sliding, pose, model).slope, 1.0
    if word == "velocity" and (rounding := on_round_side(name, model)) is not None:
        return load(from_middle(rounding, pose, model), way_round(rounding, pose, model)), 1.0
    if word == "angular_velocity":
        item = next((item for item in model.acting.connections if item.name == name), None)
        owners = [ref.owner for ref in (item.between() or item.touches()) if ref.owner in model.seats] if item else []
        if item is not None and item.between():
            turns = [model.seats[owner].turn for owner in owners]
            return {turns[1]: 1.0, turns[0]: -1.0}, float(model.sense(owners[1]))
        if owners:
            return {model.seats[owners[-1]].turn: 1.0}, float(model.sense(owners[-1]))
    return None


def momentum_rate(path: Path, pose: Pose, model: Known) -> tuple[Slope, float] | None:
    """Of a body p along its way, L about its axis or its centre of mass, or √(2 K), where its turn or its travel alone makes that."""
    name, seat = path.owner, model.seats[path.owner]
    if path.point is not None:
        return None
    centre = pose.place(name, seat.rigid.centre)
    if path.quantity == "momentum":
        way = {"x": RIGHT, "y": UP}.get(path.component or "") or model.way(name)
        return None if way is None else (merged(load(centre, way), seat.rigid.mass, {}, 0.0), 1.0)
    inertia, arm = seat.rigid.inertia, (0.0, 0.0)
    if name in model.held:
        x, y = pose.place(name, model.axis(name))
        arm = centre[0].value - x.value, centre[1].value - y.value
    if path.quantity == "angular_momentum" and path.component in (None, "z"):
        across = load(centre, (-arm[1] * seat.rigid.mass, arm[0] * seat.rigid.mass))
        return merged({seat.turn: inertia}, 1.0, across, 1.0), float(model.sense(name))
    if path.quantity != "kinetic_energy":
        return None
    if name in model.held:
        about_axis = inertia + seat.rigid.mass * (arm[0] ** 2 + arm[1] ** 2)
        return {seat.turn: math.sqrt(about_axis)}, float(model.sense(name))
    straight = model.way(name) if not model.turns(name) else None
    return None if straight is None else (merged(load(centre, straight), math.sqrt(seat.rigid.mass), {}, 0.0), 1.0)


def pointed(path: Path, pose: Pose, model: Known) -> Pair:
    """The place of the point that a path names; of a body as a whole the one that travels."""
    if path.point is None:
        return pose.place(path.owner, model.travelling(path.owner))
    return model.place(PointRef(path.owner, path.point, path.argument), pose)


def direction(path: Path, place: Pair, pose: Pose, model: Known) -> tuple[float, float] | None:
    """Along which a velocity counts: its component, the body's line, the circle that it goes on, else the turn about the axis."""
    fixed = {"x": RIGHT, "y": UP}.get(path.component or "")
    if fixed is not None:
        return fixed
    if path.component == "radial":
        away = from_axis(path.owner, pose, model)
        first = model.seats[path.owner].first
        return None if away is None else (away.slope.get(first, 0.0), away.slope.get(first + 1, 0.0))
    way = model.way(path.owner)
    if way is not None and path.point is None:
        return way
    if bent(path.owner, model) is not None and path.point is None:
        return onward(path.owner, pose, model)
    if path.owner in model.held:
        x, y = (part.value for part in pose.place(path.owner, model.axis(path.owner)))
        arm, sign = (place[0].value - x, place[1].value - y), model.sense(path.owner)
        size = math.hypot(*arm)
        if size:
            outward = arm[0] / size, arm[1] / size
            return (-sign * outward[1], sign * outward[0]) if path.component != "normal" else None
    return way
