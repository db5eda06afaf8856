"""Tipping: whether what stands on something flat stays on its base, under forces and blows: where the push from below would have to act."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import outline_of
from rotsolve.confirm.course.node import Astray, Node
from rotsolve.confirm.model import Model
from rotsolve.confirm.pose import Way
from rotsolve.confirm.signs import rests, surface_of
from rotsolve.elements.asked import is_touch

if TYPE_CHECKING:
    from rotsolve.confirm.course.blows import Blow

LEVEL = 1e-9  # of its size: how far corners of one base lie apart
BESIDE = 1e-7  # of all that is pushed: how far beside a base rounding may put a force


class Stand(Struct, frozen=True):
    """A contact on which a body with corners stands, those, in its axes, and the contacts of what it carries somewhere on its back."""

    name: str
    body: str
    corners: tuple[Way, ...]
    carried: tuple[str, ...]


class Push(Struct, frozen=True):
    """What a contact gives a body, with its torque about the centre of mass; `normal` is the way in which it pushes, `loads` are the
    forces of what lies on its back."""

    normal: Way
    force: Way
    torque: float
    loads: tuple[Way, ...]


def all_stands(model: Model) -> Iterator[Stand]:
    """What stands on something flat."""
    touches = [item for item in model.acting.connections if is_touch(item)]
    for item in touches:
        name, surface = item.lying(), surface_of(item, model)
        if surface is not None and not surface.curved and rests(item, model):
            corners = outline_of(model.body(name), model.value)
            carried = tuple(other.name for other in touches if other.pair()[1].owner == name)
            if len(corners) > 1:
                yield Stand(item.name, name, tuple(corners), carried)


def tips(stand: Stand, at: Node, push: Push) -> bool:
    """Whether s of the force on the base, s N = τ − d f, is beyond its corners; d is how far below the centre of mass the base is.

    As a contact says nothing of how a body is turned, one on a slope lies along it; nor of where on its back something lies: it tips over
    where it does so wherever that is.
    """
    (nx, ny), seat = push.normal, at.model.seats[stand.body]
    slanted = abs(nx) > LEVEL
    across, up = ((1.0, 0.0), (0.0, 1.0)) if slanted else ((ny, -nx), (nx, ny))
    places = [spot if slanted else place_of(stand.body, spot, at) for spot in (seat.rigid.centre, *stand.corners)]
    (x, y), *corners = places
    spots = [((a - x) * across[0] + (b - y) * across[1], (a - x) * up[0] + (b - y) * up[1]) for a, b in corners]
    (low, high), size = outermost(rise for _, rise in spots), max(math.dist(one, spots[0]) for one in spots)
    base = [along for along, rise in spots if rise - low < LEVEL * size]
    (normal, drag), *loads = [(x * nx + y * ny, x * ny - y * nx) for x, y in (push.force, *push.loads)]
    if len(base) < 2 or normal < 0.0:
        return False
    back = outermost(along for along, _ in spots)
    least = most = push.torque + low * drag
    for press, pull in loads:  # its torque s p − h f about the centre of mass is one more that the base has to hold
        ends = [high * pull - along * press for along in back]
        least, most = least + min(ends), most + max(ends)
    rounding = BESIDE * size * (normal + abs(drag) + (abs(least) + abs(most)) / size)
    return most < min(base) * normal - rounding or least > max(base) * normal + rounding


def outermost(values: Iterable[float]) -> tuple[float, float]:
    found = list(values)
    return min(found), max(found)


def place_of(body: str, spot: Way, at: Node) -> Way:
    x, y = at.pose.place(body, spot)
    return x.value, y.value


def check_standing(at: Node) -> None:
    """Astray where something would tip over."""
    for stand in all_stands(at.model):
        first = at.model.seats[stand.body].first
        own = [load for owner, _, load in at.loads if owner == stand.name]
        normal = next((load for owner, kind, load in at.loads if (owner, kind) == (stand.name, "normal")), {})
        sums = [sum(load.get(first + k, 0.0) for load in own) for k in range(3)]
        above = [[load for owner, _, load in at.loads if owner == name] for name in stand.carried]
        loads = [tuple(sum(load.get(first + k, 0.0) for load in several) for k in range(2)) for several in above]
        way = way_of_load(normal, first)
        if way is None:
            continue
        others = (load for owner, _, load in at.loads if owner not in (stand.name, *stand.carried))
        if abs(way[0]) > LEVEL and any(load.get(first + 2) for load in others):
            raise NotConfirmed(f"whether `{stand.body}` tips over on its slope")
        if tips(stand, at, Push(way, (sums[0], sums[1]), sums[2], tuple((x, y) for x, y in loads))):
            raise Astray(f"`{stand.body}` tips over: the force of `{stand.name}` would have to act beside its base")


def check_struck(blow: Blow) -> None:
    """Astray where a blow would tip something over: what it stands on gives no impulse beside its base, and none that pulls."""
    struck = blow.struck
    for stand in all_stands(blow.after.model):
        way = way_of_load(struck.columns.get((stand.name, "normal"), {}), blow.after.model.seats[stand.body].first)
        if way is None or any(owner in (stand.name, *stand.carried) for owner, _ in struck.open):
            continue
        force, torque = blow.on_body(stand.name, stand.body)
        loads = tuple(blow.on_body(name, stand.body)[0] for name in stand.carried)
        if tips(stand, blow.after, Push(way, force, torque, loads)):
            raise Astray(f"`{stand.body}` tips over in `{blow.event.name}`: `{stand.name}` would have to hold it down")


def way_of_load(load: Mapping[int, float], first: int) -> Way | None:
    """The way of a load on a body; None where there is none."""
    x, y = load.get(first, 0.0), load.get(first + 1, 0.0)
    size = math.hypot(x, y)
    return (x / size, y / size) if size else None
