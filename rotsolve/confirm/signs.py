"""Signs: which way is positive, as docs/signs.md says: the lines along which bodies travel, their turns, and the normals of surfaces."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import Formula
from rotsolve.confirm.bodies import is_round, on_rim
from rotsolve.confirm.pose import Way, heading, turned
from rotsolve.elements.asked import (
    is_curved,
    is_drapes,
    is_level_surface,
    is_slope,
    is_spring,
    is_string,
    is_touch,
    is_wall,
)
from rotsolve.elements.connections.supports import Axle, Hinge, Shaft
from rotsolve.elements.shapes import rim_radius, rims
from rotsolve.language.bodies import PointRef, Surface
from rotsolve.language.elements import Connection

if TYPE_CHECKING:
    from rotsolve.confirm.known import Known
    from rotsolve.elements.connections.touch import Touch
    from rotsolve.elements.surfaces import Curved

WORDS: dict[str, Way] = {"right": (1.0, 0.0), "up": (0.0, 1.0), "left": (-1.0, 0.0), "down": (0.0, -1.0)}
RIGHT, UP, LEFT, DOWN = WORDS.values()
GROUND = ("ground", "ceiling")


def normal(surface: Surface, model: Known) -> Way:
    """Out of a flat surface."""
    if is_wall(surface):
        return RIGHT if surface.wall == "left" else LEFT
    if is_slope(surface) and surface.slope is not None:
        angle = model.value(surface.slope)
        return heading(math.pi / 2 + (angle if surface.down == "left" else -angle))
    return UP


def uphill(surface: Surface, model: Known) -> Way:
    """The way up a slope or a wall; on the level to the right."""
    out = normal(surface, model)
    if is_wall(surface):
        return UP
    return turned(out, 1 if is_slope(surface) and surface.down == "right" else -1)


def travel(surface: Surface, moves: str | None, model: Known) -> Way:
    """Positive way along a flat surface: as declared, else right or up; on a slope `up`, `down` and the sides mean along it."""
    ahead = uphill(surface, model)
    back = {"left"} if is_level_surface(surface) else {"down"}
    if is_slope(surface):
        back = {"down", surface.down}
    return (-ahead[0], -ahead[1]) if moves in back else ahead


def rests(item: Touch, model: Known) -> bool:
    """Whether a body lies or rolls there, and does not just lean on it with a point."""
    ref = item.pair()[0]
    body = model.body(ref.owner)
    return not item.leaning and (
        ref.point in (None, "bottom", "center", "cm") or on_rim(body, ref.point) or bool(model.rocking(body.name, item))
    )


def surface_of(item: Touch, model: Known) -> Surface | None:
    """The surface on which a contact holds a body: of several the curved one where the state speaks of the contact's angle, or that it
    leaves; the back of another body lies as what that lies on; of a rod that leans with its side none."""
    if item.leaning:
        return None
    under = item.pair()[1]
    if item.side is not None:
        return item.side
    if under.owner in model.acting.bodies:
        if (bent := rim_under(item, model)) is not None:
            return bent
        for other in model.acting.connections:
            if is_touch(other) and other.lying() == under.owner and other is not item:
                return surface_of(other, model)
        return level_named(under.owner)
    found = [model.surfaces[ref.owner] for ref in item.places() if ref.owner in model.surfaces]
    if len(found) > 1 and any(
        line.path is not None and line.path.owner == item.name for line in model.acting.state.conditions
    ):
        return next((surface for surface in found if is_curved(surface) and surface.radius() is not None), None)
    return found[0] if found else level_named("ground")


def level_named(name: str) -> Surface:
    """The level surface of that name."""
    from rotsolve.elements.surfaces import Level

    return Level(name)


def rim_under(item: Touch, model: Known) -> Curved | None:
    """The rim of a round body on which, or in which, a ball or a particle lies; None where nothing round does."""
    from rotsolve.elements.surfaces import Dome, Hollow

    own, under = item.pair()[:2]
    body, carrier, inside = model.body(own.owner), model.body(under.owner), bool(item.on_inside())
    if not (is_round(carrier) and (is_round(body) or (body.shape is not None and body.shape.pointlike))):
        return None
    inner = [radius for name, radius in rims(carrier).items() if name == "inner" and inside and under.point is None]
    radius = inner[0] if inner else rim_radius(carrier, under.point)
    return Hollow(under.owner, radius) if inside else Dome(under.owner, radius)


def carrier_travels(item: Touch, model: Known) -> bool:
    """Whether a contact is with a round body that no fixed axle holds."""
    under = item.pair()[1].owner
    return item.side is None and under in model.seats and under not in model.held


def grounded(model: Known) -> dict[str, tuple[str, PointRef]]:
    """By body that an axle, a hinge or a shaft holds to the ground: the name of that, and the point held."""
    found: dict[str, tuple[str, PointRef]] = {}
    for item in model.acting.connections:
        refs: tuple[PointRef, ...] = ()
        if isinstance(item, Hinge) and (len(item.hinge) == 1 or item.hinge[0].owner in GROUND):
            refs = item.hinge[-1:]
        elif isinstance(item, Axle) and carrier_of(item, model) is None:
            refs = item.axle
        elif isinstance(item, Shaft):
            refs = item.shaft
        for ref in refs:
            found.setdefault(ref.owner, (item.name, ref))
    return found


def carrier_of(item: Axle, model: Known) -> PointRef | None:
    """The body that carries an axle: one of several that something else leads; None where the axle is fixed."""
    if len(item.axle) == 1:
        return None
    beside = frozenset({item.name})
    return next((ref for ref in item.axle if ref.owner in model.seats and led_on(ref.owner, ref, beside, model)), None)


def led_on(name: str, at: PointRef | None, beside: frozenset[str], model: Known) -> bool:
    """Whether a body `moves`, lies on something, hangs from its centre, or goes with one that does; not by what is `beside`.

    What holds its point `at`, and nothing else of it, does not lead it; nor does a body that a hinge hangs on it.
    """
    body = model.body(name)
    if body.moves is not None or any(way for _, way, _ in body.moved):
        return True
    for item in model.acting.connections:
        if item.name in beside:
            continue
        if is_touch(item) and item.lying() == name and not on_wheel(item, model):
            return True
        ends = (item.string[0], item.string[-1]) if is_string(item) else getattr(item, "spring", ())
        if not is_round(body) and any(own.owner == name and own.point in (None, "center") for own in ends):
            return True
        for own, carrier in carried_by(item, name, beside, model):
            here = at is not None and (own.point or "center", own.argument) == (at.point or "center", at.argument)
            if carrier is None and not here:
                return True
            if carrier is not None and led_on(carrier.owner, carrier if here else None, beside | {item.name}, model):
                return True
    return False


def on_wheel(item: Touch, model: Known) -> bool:
    """Whether a body lies on the rim of a wheel."""
    under = item.pair()[1].owner
    return under in model.seats and is_round(model.body(under))


def carried_by(
    item: Connection, name: str, beside: frozenset[str], model: Known
) -> Iterator[tuple[PointRef, PointRef | None]]:
    """The points of a body that a connection holds, each with that of the body that carries it; None for the ground."""
    if isinstance(item, Hinge) and item.hinge[-1].owner == name:
        apart = len(item.hinge) > 1 and item.hinge[0].owner in model.seats
        yield item.hinge[-1], item.hinge[0] if apart else None
    elif isinstance(item, Shaft) and item.shaft[0].owner == name:
        yield item.shaft[0], None
    elif isinstance(item, Axle):
        others = [ref for ref in item.axle if ref.owner in model.seats and ref.owner != name]
        mounts = [ref for ref in others if led_on(ref.owner, ref, beside | {item.name}, model)]
        for own in item.axle:  # an axle that several share aside of a body's centre is one that the body carries
            if own.owner == name and (mounts or len(item.axle) == 1 or own.point in (None, "center", "cm")):
                yield own, mounts[0] if mounts else None
    elif item.joined():
        first, second = item.joined()
        yield from ((own, other) for own, other in ((first, second), (second, first)) if own.owner == name)


def carriers(model: Known) -> dict[str, str]:
    """What carries each body that a hinge or an axle hangs from another one."""
    found: dict[str, str] = {}
    for item in model.acting.connections:
        for ref in item.touches() if isinstance(item, (Hinge, Axle)) and len(item.touches()) > 1 else ():
            held = carried_by(item, ref.owner, frozenset(), model) if ref.owner in model.seats else ()
            found.update((ref.owner, carrier.owner) for _, carrier in held if carrier is not None)
    return found


def mover(name: str, model: Known) -> str:
    """The body along whose line another one travels: what carries it by a joint, and so on, else itself."""
    seen = [name]
    while (carrier := model.carriers.get(seen[-1], seen[-1])) not in seen:
        seen.append(carrier)
    return seen[-1]


def taken_from_under(model: Known) -> list[Touch]:
    """The contacts that an event up to now has cut or removed: what lay on them is led by nothing since."""
    names = {
        name for event in model.acting.past for name in getattr(event, "cuts", ()) or getattr(event, "removes", ())
    }
    return [item for item in model.problem.connections if is_touch(item) and item.name in names]


def line(name: str, model: Known) -> Way | None:
    """The positive direction of a body's travel: on what it lies, as it `moves`, up where it hangs; None where it is free."""
    if name in model.held:
        return None
    body = model.body(name)
    bent = False
    for item in model.acting.connections:
        if is_touch(item) and item.lying() == name and rests(item, model):
            surface = surface_of(item, model)
            if surface is not None and not is_curved(surface) and not taken_aside(item, surface, model):
                return travel(surface, body.moves, model)
            bent = True
        if is_drapes(item) and item.drapes[0].owner == name:
            return LEFT if body.moves == "left" else RIGHT
    if bent:
        return None
    if body.moves and name not in {item.lying() for item in taken_from_under(model)}:
        return WORDS[body.moves]
    return UP if model.upright and hangs(name, model) else None


def taken_aside(item: Touch, surface: Surface, model: Known) -> bool:
    """Whether the body whose side that is goes another way than along it."""
    own, out = None if item.side is None else model.way(item.pair()[1].owner), normal(surface, model)
    return item.side is not None and (own is None or abs(own[0] * out[0] + own[1] * out[1]) > 1e-12)


def hangs(name: str, model: Known) -> bool:
    """Whether a body hangs from a string or spring by its centre, or a wheel in a string under it, and no other body carries it."""
    for item in model.acting.connections:
        refs: tuple[PointRef, ...] = ()
        if is_string(item):
            refs = (item.string[0], item.string[-1])
            if name in item.under and name not in {ref.owner for ref in refs}:
                return mover(name, model) == name
        elif is_spring(item):
            refs = item.spring
        elif is_drapes(item):
            refs = item.drapes[2:]
        if any(ref.owner == name and ref.point in (None, "center") for ref in refs):
            return mover(name, model) == name
    return False


def sense(name: str, model: Known) -> int:
    """+1 where a body's positive turn is counterclockwise: as declared, else the way it rolls as it travels, else counterclockwise."""
    body = model.body(name)
    if body.turns:
        return 1 if body.turns == "counterclockwise" else -1
    begun = {found for event in model.problem.events for found in event.begins()}
    late = [item for item in model.problem.connections if item.name in begun]
    for item in (*model.acting.connections, *late, *taken_from_under(model)):
        if is_touch(item) and item.lying() == name and rests(item, model):
            surface = surface_of(item, model)
            if is_curved(surface) and carrier_travels(item, model):
                continue
            if is_curved(surface):
                return round_way(surface, body.moves) * (1 if surface.outside else -1)
            if surface is not None and name not in model.held:
                moves = "down" if taken_aside(item, surface, model) else body.moves
                ahead, right = travel(surface, moves, model), turned(normal(surface, model), -1)
                return -1 if ahead[0] * right[0] + ahead[1] * right[1] > 0 else 1
        if is_drapes(item) and item.drapes[1].owner == name:
            return 1 if model.body(item.drapes[0].owner).moves == "left" else -1
    return 1


def round_way(surface: Curved, moves: str | None) -> int:
    """Positive travel round a curved surface: to the right over the top of a dome (clockwise) or through the bottom of a bowl."""
    right = -1 if surface.outside else 1
    return -right if moves == "left" else right


def pointing(direction: str | Formula | tuple[Formula, Formula], model: Known) -> Way:
    """Unit vector of a direction: a word, components or an angle."""
    if isinstance(direction, str):
        return WORDS[direction]
    if isinstance(direction, tuple):
        x, y = (model.value(part) for part in direction)
        size = math.hypot(x, y)
        return x / size, y / size
    return heading(model.value(direction))
