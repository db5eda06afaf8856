"""Elements: what can be read of a connection, an action or a spring at one instant: what it does along each coordinate tells all."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import radius_of
from rotsolve.confirm.course.reading import (
    NATURAL,
    Reckoned,
    component_of,
    cross,
    number,
    of_body,
    point_place,
    scalar,
    second_rate,
    values,
)
from rotsolve.confirm.lines import twist, wound_by
from rotsolve.confirm.pose import Way
from rotsolve.confirm.sides import from_middle, gone_down, on_round_side, on_side, way_round
from rotsolve.elements.asked import is_band, is_belt, is_gear, is_string, is_touch
from rotsolve.elements.connections.supports import Rides
from rotsolve.language.elements import ActingElement
from rotsolve.language.problem import Path, Term

if TYPE_CHECKING:
    from rotsolve.confirm.course.node import Node
    from rotsolve.confirm.jet import Slope
    from rotsolve.elements.actions import Band


def element(at: Node, name: str) -> ActingElement:
    """The connection or action of that name that acts just now."""
    acting = at.model.acting
    found = next((item for item in (*acting.connections, *acting.actions) if item.name == name), None)
    if found is None:
        raise NotConfirmed(f"`{name}` does not act there")
    return found


def loads(at: Node, name: str, *kinds: str) -> list[Slope]:
    """What an element does along each coordinate, row by row; of some kinds of rows where they are named."""
    found = [load for owner, kind, load in at.loads if owner == name and (not kinds or kind in kinds)]
    if not found:
        raise NotConfirmed(f"`{name}` does nothing there")
    return found


def on_body(at: Node, body: str, parts: Iterable[Slope]) -> tuple[Way, float]:
    """Force, and torque about the centre of mass, on a body."""
    first = at.model.seats[body].first
    x, y, turn = (math.fsum(part.get(first + k, 0.0) for part in parts) for k in range(3))
    return (x, y), turn


def last_body(at: Node, name: str) -> str:
    """The body that an element names last."""
    named = [ref.owner for ref in element(at, name).touches() if ref.owner in at.model.seats]
    if not named:
        raise NotConfirmed(f"`{name}` acts on no body")
    return named[-1]


def tension(at: Node, path: Path, term: Term | None) -> Reckoned:
    """Of the leg that leaves the body that is named, towards the next; one for all legs where they are the same."""
    item = element(at, path.owner)
    if is_band(item):
        return other_end(at, item)
    sizes = [size for owner, kind, size in at.sizes if owner == path.owner and kind.startswith("tension")]
    if not sizes:
        raise NotConfirmed(f"the tension of `{path.owner}`")
    if path.point is not None and is_string(item):
        places = [number for number, ref in enumerate(item.string) if path.point in (ref.owner, ref.point)]
        if not places:
            raise NotConfirmed(f"`{path.owner}` does not touch `{path.point}`")
        if item.friction is not None:  # of the rope at either side of its post what it does there
            end = item.string[0 if places[0] == 0 else -1].owner
            return number(math.hypot(*on_body(at, end, loads(at, path.owner))[0]))
        return number(sizes[min(places[0], len(sizes) - 1)], max(map(abs, sizes)))
    if max(sizes) - min(sizes) > 1e-6 * max(map(abs, sizes), default=1.0):
        raise NotConfirmed(f"the tension of `{path.owner}` is not the same throughout")
    return number(sizes[0])


def other_end(at: Node, item: Band) -> Reckoned:
    """The tension at the end of a band that is held: its torque on the drum is the difference of both, times the radius."""
    body, ref = last_body(at, item.name), item.on
    radius = radius_of(at.model.body(body), ref.point if ref is not None else None, at.model.value) or 0.0
    if item.band is None or radius == 0.0:
        raise NotConfirmed(f"the tension of `{item.name}`")
    drawn, pull = (1 if item.direction == "counterclockwise" else -1), at.model.value(item.band)
    return number(pull - drawn * on_body(at, body, loads(at, item.name))[1] / radius, pull)


def normal_force(at: Node, path: Path, term: Term | None) -> Reckoned:
    """The push of a surface; on what slides along a body that turns that across it, counterclockwise positive."""
    if isinstance(item := element(at, path.owner), Rides):
        turn = at.pose.turn(item.rides[1].owner).value
        way, _ = on_body(at, item.rides[0].owner, loads(at, path.owner, "across"))
        return number(scalar(way, (-math.sin(turn), math.cos(turn))), math.hypot(*way))
    at.told(path.owner, "normal")
    sizes = [size for owner, kind, size in at.sizes if owner == path.owner and kind == "normal"]
    if not sizes:
        return number(math.hypot(*on_body(at, last_body(at, path.owner), loads(at, path.owner, "press"))[0]))
    return number(sizes[0])


def friction_force(at: Node, path: Path, term: Term | None) -> Reckoned:
    """Its size, and which way it points on the body that the contact names first."""
    if isinstance(item := element(at, path.owner), Rides):
        return number(math.hypot(*on_body(at, item.rides[0].owner, loads(at, path.owner))[0]))
    sticks = (path.owner, "friction") in at.moment.reactions  # what slips is told by its push
    at.told(path.owner, *(("friction",) if sticks else ("friction", "normal")))
    sizes = [size for owner, kind, size in at.sizes if owner == path.owner and kind == "friction"]
    if not sizes and any((owner, kind) == (path.owner, "torque") for owner, kind, _ in at.sizes):
        raise NotConfirmed(f"what the friction of `{path.owner}`, spread over a face, is in all")
    normal = [size for owner, kind, size in at.sizes if owner == path.owner and kind == "normal"]
    found = number(abs(sizes[0]) if sizes else 0.0, abs(normal[0]) if normal else 0.0, sized=True)
    first = [ref.owner for ref in element(at, path.owner).touches() if ref.owner in at.model.seats][:1]
    rubbing = [load for owner, kind, load in at.loads if owner == path.owner and kind == "friction"]
    way = on_body(at, first[0], rubbing)[0] if first and rubbing else None
    return replace(found, way=way)


def force(at: Node, path: Path, term: Term | None) -> Reckoned:
    """On the last-named body: its components, its size, or its parts across the arm and inwards; of belts and gears that at the rims."""
    at.told(path.owner)
    item = element(at, path.owner)
    if is_belt(item) or is_gear(item):
        sizes = [abs(size) for owner, kind, size in at.sizes if owner == path.owner and kind.startswith("force")]
        if len(sizes) != 1:
            raise NotConfirmed(f"the force of `{path.owner}` is not the same throughout")
        return number(sizes[0], sized=True)
    body = last_body(at, path.owner)
    way, _ = on_body(at, body, loads(at, path.owner))
    if path.component not in NATURAL:
        return component_of(way, path.component)
    held, centre = at.axis(body), point_place(at, body, "cm")
    if held is None:
        raise NotConfirmed("a tangential part without an axis")
    (x, y), (u, w) = values(centre), values(held)
    size = math.hypot(x - u, y - w)
    if size == 0.0:
        raise NotConfirmed("a tangential part without an arm")
    out = ((x - u) / size, (y - w) / size)
    if path.component == "normal":
        return number(-scalar(way, out), math.hypot(*way))
    return number(cross(out, way) * at.model.sense(body), math.hypot(*way))


def torque(at: Node, path: Path, term: Term | None) -> Reckoned:
    """On the last-named body about its axis or its centre of mass, along its positive turn."""
    body = last_body(at, path.owner)
    item = element(at, path.owner)
    named = [part for owner, kind, part in at.loads if owner == path.owner and kind.startswith("torque")]
    parts = named if named and not is_touch(item) else loads(at, path.owner)
    way, twist = on_body(at, body, parts)
    centre, middle = values(point_place(at, body, "cm")), at.reference(body, term)
    arm = (centre[0] - middle[0], centre[1] - middle[1])
    return number((twist + cross(arm, way)) * at.model.sense(body), abs(twist) + math.hypot(*arm) * math.hypot(*way))


def power(at: Node, path: Path, term: Term | None) -> Reckoned:
    """What it does along each coordinate, times the rate of that."""
    speed = at.pose.speed
    parts = [part * speed[index] for load in loads(at, path.owner) for index, part in load.items()]
    return number(math.fsum(parts), max(map(abs, parts), default=0.0))


def elongation(at: Node, path: Path, term: Term | None) -> Reckoned:
    return number(at.stretched(path.owner))


def potential_energy(at: Node, path: Path, term: Term | None) -> Reckoned:
    """½ k e² of a spring, ½ κ θ² of a wire."""
    return number(at.stored(path.owner))


def turning(at: Node, path: Path, term: Term | None) -> Reckoned:
    """Where on a curved surface a body touches it; how far a wire is twisted; how the last body turns against the first, else how the body
    turns that is held."""
    item = element(at, path.owner)
    if is_touch(item) and path.quantity == "angle":
        return Reckoned({"": at.touching_angle(item)}, 1.0, period=2 * math.pi)
    if path.quantity == "angle" and (wound := wound_by(path.owner, at.model)):
        return number(twist(wound, at.pose, at.model).value, 1.0)
    between = item.between() if hasattr(item, "between") else ()
    if between and path.quantity != "angle":
        first, last = (at.pose.turn(ref.owner) for ref in between)
        rates = [turn.rate if path.quantity == "angular_velocity" else second_rate(turn, at) for turn in (first, last)]
        return number((rates[1] - rates[0]) * at.model.sense(between[1].owner), max(map(abs, rates)))
    return of_body(at, Path(last_body(at, path.owner), path.quantity), term)


def sliding_down(at: Node, path: Path, term: Term | None) -> Reckoned:
    """How fast a body slides down a side of another one, as seen from that; or the rate of that."""
    item, rounding = on_side(path.owner, at.model), on_round_side(path.owner, at.model)
    if rounding is not None and path.quantity == "velocity" and path.component is None:
        place = from_middle(rounding, at.pose, at.model)
        return number(scalar((place[0].rate, place[1].rate), way_round(rounding, at.pose, at.model)))
    if item is None or path.component is not None:
        raise NotConfirmed(f"the {path.quantity} of `{path.owner}`")
    found = gone_down(item, at.pose, at.model)
    return number(found.rate if path.quantity == "velocity" else second_rate(found, at))


Reading = Callable[["Node", Path, "Term | None"], Reckoned]
OF_ELEMENTS: dict[str, Reading] = {
    "tension": tension,
    "normal_force": normal_force,
    "friction_force": friction_force,
    "force": force,
    "torque": torque,
    "power": power,
    "elongation": elongation,
    "potential_energy": potential_energy,
    "velocity": sliding_down,
    "acceleration": sliding_down,
    **dict.fromkeys(("angle", "angular_velocity", "angular_acceleration"), turning),
}
