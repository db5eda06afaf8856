"""Forces: what springs and actions do along each coordinate. An element without a line here is refused."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import Spot, on_rim, radius_of, side_of
from rotsolve.confirm.constraints import tied_at
from rotsolve.confirm.jet import Jet, Slope, distance
from rotsolve.confirm.lines import onward, twist, wound_by
from rotsolve.confirm.pose import Pair, Pose, Way, along, load, turned
from rotsolve.confirm.rows import Grip, held
from rotsolve.confirm.signs import DOWN, LEFT, RIGHT, UP, WORDS, mover, pointing
from rotsolve.elements.asked import home_of_kind, is_drapes, is_spring, is_wall
from rotsolve.elements.connections.supports import Shaft
from rotsolve.language.bodies import PointRef

if TYPE_CHECKING:
    from rotsolve.confirm.known import Known
    from rotsolve.elements.actions import AppliedCouple, AppliedForce, AppliedPower, Band, Press
    from rotsolve.elements.connections.drapes import Drapes
    from rotsolve.elements.connections.drives import MutualDrive
    from rotsolve.elements.connections.rubbing import Rims
    from rotsolve.elements.connections.springs import Spring, Torsion

Pushes = Iterator[tuple[str, Slope] | Grip]
SIDES = (None, "tangential", "clockwise", "counterclockwise")  # directions square to the arm


def forces(model: Known, pose: Pose, without: Collection[str] = ()) -> Pushes:
    """All known forces but the weights, by their owner, and brakes that may hold; `without` those of some elements."""
    for item in (*model.acting.connections, *model.acting.actions):
        line = FORCES.get(home_of_kind(type(item)))
        if line is not None and item.name not in without:
            yield from line(item, pose, model)
    for action in model.acting.actions:
        if home_of_kind(type(action)) not in FORCES:
            raise NotConfirmed(f"`{action.name}`: the assembly has no forces for `{action.word}`")


def spring(item: Spring, pose: Pose, model: Known) -> Pushes:
    """A pull k e on both ends, e how far it is stretched."""
    if item.stiffness is None:
        raise NotConfirmed(f"nothing tells the stiffness of `{item.name}`")
    length = spring_length(item, pose, model)
    rest = pose.offsets.get(item.name)
    if rest is None:
        raise NotConfirmed(f"nothing tells how far `{item.name}` is stretched")
    size = model.value(item.stiffness) * (length.value - rest)
    yield item.name, {index: -size * part for index, part in length.slope.items()}


def spring_length(item: Spring, pose: Pose, model: Known) -> Jet:
    """Its length, but for a constant where places are not told: the distance of its ends, or what they are apart along its direction."""
    placed = any(ref.place is not None for ref in item.spring)
    (x, y), (u, w) = (from_first(ref, pose, model) if placed else tied_at(ref, pose, model) for ref in item.spring)
    if by_places(item, model):
        return distance(u - x, w - y)
    return along((u - x, w - y), spring_way(item, model))


def from_first(ref: PointRef, pose: Pose, model: Known) -> Pair:
    """Where a point is; of what travels on a line from where that is at the first state."""
    if ref.place is None and model.line(ref.owner) is not None:
        return pose.moved(ref.owner, model.tied(ref))
    return tied_at(ref, pose, model)


def by_places(item: Spring, model: Known) -> bool:
    """Whether its length is the distance of its ends: of a place that is named, or of what slides freely along a body."""
    sliding = [
        ride.rider.owner for other in model.acting.connections if (ride := other.ride()) is not None and ride.free
    ]
    return any(ref.place is not None or ref.owner in sliding for ref in item.spring)


def stretched(model: Known, pose: Pose, known: Mapping[str, float]) -> dict[str, float]:
    """The lengths at which springs are without force, from how far a state says that they are stretched; how much of a rope hangs."""
    found = {}
    for item in model.acting.connections:
        if is_drapes(item) and item.name not in known:
            from rotsolve.confirm.carried import hanging

            for line in model.acting.state.conditions:
                path = line.path
                if (
                    path is not None
                    and path.owner == item.name
                    and path.quantity == "length"
                    and line.value is not None
                ):
                    found[item.name] = model.value(line.value) - hanging(item, pose, model).value
        if not is_spring(item) or item.name in known:
            continue
        if item.rest_length is not None and by_places(item, model):
            found[item.name] = model.value(item.rest_length)
            continue
        for line in model.acting.state.conditions:
            path = line.path
            if (
                path is not None
                and path.owner == item.name
                and path.quantity == "elongation"
                and line.value is not None
            ):
                found[item.name] = spring_length(item, pose, model).value - model.value(line.value)
    return found


def spring_way(item: Spring, model: Known) -> Way:
    """As is said; else from a wall out of it, along the line of travel of an end where that is not upright; else from left to right along
    that line, down from the ceiling, up from whatever else it stands on, of two bodies down."""
    if item.direction is not None:
        return WORDS[item.direction]
    first, second = item.spring
    anchor, body = (first, second) if first.owner not in model.seats else (second, first)
    way = next((found for ref in (body, anchor) if (found := end_travel(ref, model)) is not None), None)
    wall = model.surfaces.get(anchor.owner)
    right = way if way is None or way[0] > 0 else (-way[0], -way[1])
    sideways = right is not None and abs(right[0]) > 1e-9
    if is_wall(wall):
        level = right if right is not None and sideways else RIGHT
        outward = level if wall.wall == "left" else (-level[0], -level[1])
    elif right is not None and sideways:
        return right
    else:
        outward = DOWN if anchor.owner == "ceiling" else UP
    return outward if anchor is first else (-outward[0], -outward[1])


def end_travel(ref: PointRef, model: Known) -> Way | None:
    """The line of an end of a spring: its body's, or at the middle of what another body carries that one's."""
    if ref.owner not in model.seats:
        return None
    own = model.line(ref.owner)
    return model.line(mover(ref.owner, model)) if own is None and ref.point in (None, "rim", "center") else own


def torsion(item: Torsion, pose: Pose, model: Known) -> Pushes:
    """−κ (θ − θ₀) on the last-named, the opposite on the other."""
    angle = twist(wound_by(item.name, model), pose, model)
    rest = model.value(item.rest_angle) if item.rest_angle is not None else 0.0
    if item.stiffness is None:
        raise NotConfirmed(f"nothing tells the stiffness of `{item.name}`")
    size = -model.value(item.stiffness) * (angle.value - rest)
    yield item.name, {index: size * part for index, part in angle.slope.items()}


def mutual(item: MutualDrive, pose: Pose, model: Known) -> Pushes:
    """Opposite couples, that on the last-named along its positive turn."""
    if item.couple is not None:
        first, second = (ref.owner for ref in item.drives)
        size = model.now(item.couple, pose) * model.sense(second)
        yield item.name, {model.seats[second].turn: size, model.seats[first].turn: -size}


def pressed(item: Rims, pose: Pose, model: Known) -> Pushes:
    """Two wheels side by side, the second on the right of the first, press each other apart, beside their friction."""
    first, second = (model.seats[ref.owner].first for ref in item.wheels)
    size = model.value(item.press)
    yield f"{item.name}|press", {first: -size, second: size}


def applied(item: AppliedForce, pose: Pose, model: Known) -> Pushes:
    if item.on is None or item.force is None:
        return
    place, way = aimed(item.on, item.direction, pose, model, over=item.over, under=item.under)
    size = model.now(item.force, pose)
    yield item.name, load(pose.place(item.on.owner, place), (size * way[0], size * way[1]))


def aimed(
    on: PointRef, direction: Any, pose: Pose, model: Known, *, over: bool = False, under: bool = False
) -> tuple[Spot, Way]:
    """Where a force or a blow acts, in the body's axes, and its direction: as said, else tangential, else along the body's travel."""
    name = on.owner
    turn = {"clockwise": -1, "counterclockwise": 1}.get(direction, model.sense(name)) if direction in SIDES else 1
    radius = radius_of(model.body(name), on.point, model.value)
    wheel = radius is not None and (on_rim(model.body(name), on.point))
    held = next((other for other in model.joined_to(name) if other in model.held), None)
    if direction in SIDES and (direction is not None or held is not None):
        if wheel:
            return pose.spatial(name, model.spot(on), (radius or 0.0, 0.0)), UP if turn > 0 else DOWN
        spot = model.drawn(on)
        (x, y), (u, w) = pose.place(name, spot), pose.place(held or name, model.axis(held or name))
        arm = x.value - u.value, y.value - w.value
        size = math.hypot(*arm)
        if size == 0.0:
            return spot, onward(name, pose, model) or RIGHT
        return spot, turned((arm[0] / size, arm[1] / size), turn)
    way = pointing(direction, model) if direction is not None else onward(name, pose, model) or RIGHT
    if wheel and (over or under):
        rightward = way[0] > 1e-9 or (abs(way[0]) <= 1e-9 and way[1] < 0)
        outward = turned(way, 1 if rightward == over else -1)
        return pose.spatial(name, model.spot(on), ((radius or 0.0) * outward[0], (radius or 0.0) * outward[1])), way
    side = side_of(model.body(name), on.point)
    if side is not None and radius is not None and (name, on.point) not in model.marks:
        return pose.spatial(name, model.spot(on), (radius * side[0], radius * side[1])), way
    return model.drawn(on), way


def couple(item: AppliedCouple, pose: Pose, model: Known) -> Pushes:
    if item.on is not None and item.couple is not None:
        turn = {"clockwise": -1, "counterclockwise": 1}.get(str(item.direction), model.sense(item.on.owner))
        yield item.name, {model.seats[item.on.owner].turn: turn * model.now(item.couple, pose)}


def press(item: Press, pose: Pose, model: Known) -> Pushes:
    """A push towards the axle from the right, and friction against the turn, which may hold the wheel."""
    if item.on is None or item.press is None or item.friction is None:
        return
    name, size = item.on.owner, model.now(item.press, pose)
    radius = radius_of(model.body(name), item.on.point, model.value) or 0.0
    centre = pose.place(name, model.spot(item.on))
    yield item.name, load(centre, (size * LEFT[0], 0.0))
    limit = model.value(item.friction) * size
    yield Grip(
        f"{item.name}.{name}", held(item.name, "friction", centre[1] + pose.turn(name) * radius, pose), limit, limit
    )


def band(item: Band, pose: Pose, model: Known) -> Pushes:
    """Both ends of a band: T at the other one lies between F e^(−μ φ) and F e^(μ φ), F cosh μφ ± F sinh μφ; the drum slips at either."""
    if item.on is None or item.band is None or item.friction is None or item.wrap is None:
        return
    name, size = item.on.owner, model.value(item.band)
    radius, turn = radius_of(model.body(name), item.on.point, model.value) or 0.0, model.seats[name].turn
    drawn = 1 if item.direction == "counterclockwise" else -1
    around = model.value(item.friction) * model.value(item.wrap)
    yield item.name, {turn: drawn * size * (1.0 - math.cosh(around)) * radius}
    limit = size * math.sinh(around) * radius
    yield Grip(f"{item.name}.{name}", held(item.name, "band", pose.turn(name), pose), limit, limit)


def power(item: AppliedPower, pose: Pose, model: Known) -> Pushes:
    """The couple P/ω."""
    if item.on is None or item.power is None:
        return
    turn = model.seats[item.on.owner].turn
    if pose.speed[turn] == 0.0:
        raise NotConfirmed(f"`{item.name}` has no finite torque on a body at rest")
    yield item.name, {turn: model.now(item.power, pose) / pose.speed[turn]}


def rope_or_shaft(item: Drapes | Shaft, pose: Pose, model: Known) -> Pushes:
    """What a heavy rope and a shaft do, which few scenes have."""
    from rotsolve.confirm.carried import centrifugal, rope_weight

    return centrifugal(item, pose, model) if isinstance(item, Shaft) else rope_weight(item, pose, model)


FORCES: dict[str, Callable[[Any, Pose, Known], Pushes]] = {
    "connections.springs.Spring": spring,
    "connections.springs.Torsion": torsion,
    "connections.drapes.Drapes": rope_or_shaft,
    "connections.supports.Shaft": rope_or_shaft,
    "connections.drives.MutualDrive": mutual,
    "connections.rubbing.Rims": pressed,
    "actions.AppliedForce": applied,
    "actions.AppliedCouple": couple,
    "actions.Press": press,
    "actions.Band": band,
    "actions.AppliedPower": power,
}
