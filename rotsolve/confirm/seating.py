"""Seating: a first guess of where bodies are: turned as the state says, each joined to its neighbour, what is held at the origin."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from rotsolve.confirm.bodies import radius_of
from rotsolve.confirm.lines import circle_of, on_curve
from rotsolve.confirm.pose import Way
from rotsolve.confirm.signs import GROUND, carrier_of
from rotsolve.elements.asked import is_belt, is_gear
from rotsolve.elements.connections.supports import Axle, Hinge
from rotsolve.language.bodies import PointRef

if TYPE_CHECKING:
    from rotsolve.confirm.known import Known
    from rotsolve.elements.connections.touch import Touch
    from rotsolve.elements.surfaces import Curved

Joint = tuple[PointRef, PointRef]


def seated(model: Known) -> list[float]:
    """Coordinates to begin with."""
    q = [0.0] * model.size
    turns = turned_as_told(model)
    for name, seat in model.seats.items():
        q[seat.turn] = turns.get(name, 0.0)
    joints, known = joints_of(model), set()
    for name in model.held:
        put(name, model.axis(name), (0.0, 0.0), q, model)
        known.add(name)
    for number, name in enumerate(model.seats):
        if name in known:
            continue
        found = on_curve(name, model)
        if found is not None and found[0].side is None:
            put_on_curve(found, (0.0, 0.0), q, model)
            known.add(name)
        elif not any(name in (one.owner, two.owner) for one, two in joints):
            put(name, model.seats[name].rigid.centre, (float(number + 1), 0.0), q, model)
            known.add(name)
    spread_out(joints, known, q, model)
    for name in model.seats:  # what lies on a side of a body goes where that is
        found = on_curve(name, model)
        if found is not None and found[0].side is not None:
            under = found[0].pair()[1].owner
            put_on_curve(found, where(under, model.seats[under].rigid.centre, q, model), q, model)
    return q


def put_on_curve(found: tuple[Touch, Curved], middle: Way, q: list[float], model: Known) -> None:
    """Moves a body to where it is on a curved surface round a middle."""
    angle, circle = told_angle(found[0].name, model), circle_of(found, model)
    if angle is None:
        angle = beside(found[1], circle, model)
    place = (middle[0] + circle * math.cos(angle), middle[1] + circle * math.sin(angle))
    put(found[0].lying(), (0.0, 0.0), place, q, model)


def spread_out(joints: list[Joint], known: set[str], q: list[float], model: Known) -> None:
    """Places each body at one that is placed and to which it is joined; where none is, the first that is left."""
    while len(known) < len(model.seats):
        for one, two in joints:
            for there, here in ((one, two), (two, one)):
                if there.owner in known and here.owner not in known:
                    at = where(there.owner, model.drawn(there), q, model)
                    put(here.owner, model.drawn(here), (at[0] + gap(one, two, model), at[1]), q, model)
                    known.add(here.owner)
                    break
            else:
                continue
            break
        else:
            known.add(next(name for name in model.seats if name not in known))


def gap(one: PointRef, two: PointRef, model: Known) -> float:
    """How far apart two wheels that mesh are."""
    for item in model.acting.connections:
        if is_gear(item) and item.gear == (one, two):
            first, second = (radius_of(model.body(ref.owner), ref.point, model.value) or 0.0 for ref in item.gear)
            return abs(first - second) if item.inside else first + second
    return 0.0


def joints_of(model: Known) -> list[Joint]:
    """The points of two bodies that are at one place; wheels that mesh last."""
    found: list[Joint] = []
    for item in model.acting.connections:
        if isinstance(item, Hinge) and len(item.hinge) == 2 and item.hinge[0].owner not in GROUND:
            if item.hinge[0].place is None:
                found.append((item.hinge[0], item.hinge[1]))
        elif isinstance(item, Axle):
            carrier = carrier_of(item, model)
            found += [(carrier, ref) for ref in item.axle if carrier is not None and ref is not carrier]
        elif item.joined():
            found.append((item.joined()[0], item.joined()[1]))
    riders = [ride for item in model.acting.connections if (ride := item.ride()) is not None]
    found += [(model.axis_of(ride.carrier), PointRef(ride.rider.owner)) for ride in riders]
    found += [(event.joined()[0], event.joined()[1]) for event in model.acting.joined()]
    for event in model.problem.events:  # what is to meet stands where it will
        points = event.points(model.problem.connections)
        if event.from_ == model.acting.state.name and len(points) == 2:
            found.append((points[0], points[1]))
    found += [(item.gear[0], item.gear[1]) for item in model.acting.connections if is_gear(item)]
    for item in model.acting.connections:
        if is_belt(item):
            found += list(zip(item.belt, item.belt[1:], strict=False))
    return found


def turned_as_told(model: Known) -> dict[str, float]:
    """The turns that the state's angles tell, of welded bodies also by those of the others."""
    turns: dict[str, float] = {}
    for line in model.acting.state.conditions:
        path = line.path
        if path is not None and path.quantity == "angle" and path.owner in model.seats and line.value is not None:
            turns[path.owner] = model.value(line.value) - model.lean(path.owner)
    rides = [ride for item in model.acting.connections if (ride := item.ride()) is not None]
    for ride in rides:
        turns[ride.rider.owner] = turns.get(ride.carrier.owner, 0.0)
    for _ in model.unions:
        for first, second in model.unions:
            apart = model.told_apart(first, second) or 0.0
            if first in turns and second not in turns:
                turns[second] = turns[first] + apart
            elif second in turns and first not in turns:
                turns[first] = turns[second] - apart
    return turns


def beside(surface: Curved, circle: float, model: Known) -> float:
    """Where a body is on a curved surface that no line tells: on the floor before a corner, on top of a dome, deep in a bowl."""
    edge = surface.height()
    if edge is None:
        return math.pi / 2 if surface.outside else -math.pi / 2
    rise = math.asin(max(-1.0, min(1.0, (circle - model.value(edge)) / circle)))
    return rise if getattr(surface, "side", "right") == "left" else math.pi - rise


def told_angle(owner: str, model: Known) -> float | None:
    """The angle of a contact that the state tells."""
    for line in model.acting.state.conditions:
        path = line.path
        if path is not None and path.owner == owner and path.quantity == "angle" and line.value is not None:
            return model.value(line.value)
    return None


def put(name: str, spot: Way, place: Way, q: list[float], model: Known) -> None:
    """Moves a body so that a point of it is at a place."""
    at = where(name, spot, q, model)
    first = model.seats[name].first
    q[first] += place[0] - at[0]
    q[first + 1] += place[1] - at[1]


def where(name: str, spot: Way, q: list[float], model: Known) -> Way:
    """Where a point of a body is."""
    rigid, first = model.seats[name].rigid, model.seats[name].first
    u, w = spot[0] - rigid.centre[0], spot[1] - rigid.centre[1]
    c, s = math.cos(q[first + 2]), math.sin(q[first + 2])
    return q[first] + c * u - s * w, q[first + 1] + s * u + c * w
