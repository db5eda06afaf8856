"""Routing: how a string runs, as docs/signs.md says: drawn from left to right, over its pulleys or under those that are named."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

from rotsolve.confirm.bodies import on_rim, radius_of
from rotsolve.confirm.pose import StringPart, Way, turned
from rotsolve.confirm.signs import DOWN, RIGHT, UP, WORDS, line, mover, normal, surface_of, uphill
from rotsolve.elements.asked import is_slope, is_touch, is_wall
from rotsolve.elements.connections.strings import String
from rotsolve.elements.connections.supports import Hinge
from rotsolve.language.bodies import PointRef

if TYPE_CHECKING:
    from rotsolve.confirm.known import Known


def legs(item: String, model: Known) -> list[StringPart]:
    """All legs of a string."""
    ways = [direction(item, index, model) for index in range(len(item.string) - 1)]
    sides = [side(item, index, ways, model) for index in range(len(item.string))]
    return [
        StringPart(first, second, ways[index], (sides[index], sides[index + 1]))
        for index, (first, second) in enumerate(pairwise(item.string))
    ]


def direction(item: String, index: int, model: Known) -> Way | None:
    """The direction of a leg: what is told of either end, of a body that hangs or lies before a wheel that goes along."""
    first, second = item.string[index], item.string[index + 1]
    if told_apart(first, second, model):
        return None
    ends = [(index, index + 1, 1.0), (index + 1, index, -1.0)]
    for rule in (declared, supported, abreast, pulled, wheeled, turned_aside, as_carrier):
        for here, there, sign in ends:
            way = rule(item, here, there, model)
            if way is not None:
                return (sign * way[0], sign * way[1])
    return RIGHT


def told_apart(first: PointRef, second: PointRef, model: Known) -> bool:
    """Whether places tell the direction: one end is a place of the scene, or a hinge joins the two bodies."""
    if first.place is not None or second.place is not None:
        return True
    joints = ({ref.owner for ref in item.hinge} for item in model.acting.connections if isinstance(item, Hinge))
    return {first.owner, second.owner} in joints


def declared(item: String, here: int, there: int, model: Known) -> Way | None:
    """As `pulls` or `along` says."""
    ref, neighbour = item.string[here], item.string[there]
    word = dict(item.pulls).get(ref.owner)
    if word is not None:
        slope = lain_on(ref.owner, model) if word in ("up", "down") else None
        if is_slope(slope):  # along the slope
            x, y = uphill(slope, model)
            return (x, y) if word == "up" else (-x, -y)
        return WORDS[word]
    surface = model.surfaces.get(item.along or "")
    if surface is None:
        return None
    up = uphill(surface, model)
    on = [end.owner in model.seats and parallel(line_led(end.owner, model), up) for end in (ref, neighbour)]
    if sum(on) != 1:  # two that lie on it are drawn from left to right
        return None
    return up if on[0] else (-up[0], -up[1])


def line_led(name: str, model: Known) -> Way | None:
    """The positive direction of a body's travel, or of that of what carries it."""
    return line(mover(name, model), model)


def parallel(one: Way | None, other: Way) -> bool:
    return one is not None and abs(one[0] * other[1] - one[1] * other[0]) < 1e-9


def abreast(item: String, here: int, there: int, model: Known) -> Way | None:
    """Two bodies that travel along one line that is not upright: the earlier-named stands on the left."""
    ends = (0, len(item.string) - 1)
    if any(wraps(item.string[index], model) and index not in ends for index in (here, there)):
        return None
    ways = [
        line_led(item.string[index].owner, model) for index in (here, there) if item.string[index].owner in model.seats
    ]
    way = ways[0] if len(ways) == 2 else None
    if way is None or not parallel(ways[1], way) or abs(way[0]) < 1e-9:
        return None
    ahead = (way[0] > 0) == (there > here)
    return way if ahead else (-way[0], -way[1])


def supported(item: String, here: int, there: int, model: Known) -> Way | None:
    """Down from the ceiling, away from a wall."""
    owner = item.string[here].owner
    if owner == "ceiling":
        return DOWN
    surface = model.surfaces.get(owner)
    return normal(surface, model) if is_wall(surface) else None


def pulled(item: String, here: int, there: int, model: Known) -> Way | None:
    """A body on a slope is pulled up that, one on the level towards its neighbour in the list, a hanging one up."""
    ref = item.string[here]
    if ref.owner not in model.seats:
        return None
    way = line(ref.owner, model)
    if way is None:
        return None
    slope = lain_on(ref.owner, model)
    if is_slope(slope):
        return uphill(slope, model)
    if abs(way[1]) < 1e-9:
        return RIGHT if there > here else (-1.0, 0.0)
    if wraps(ref, model):
        return None
    return DOWN if slung(item, there, model) or (there > here and below(item, there, model)) else UP


def turned_aside(item: String, here: int, there: int, model: Known) -> Way | None:
    """A point of a turning body off its axis is pulled up, down by what hangs from it."""
    ref = item.string[here]
    turns = ref.owner in model.seats and line(ref.owner, model) is None and held_aside(ref, model)
    return (DOWN if below(item, there, model) else UP) if turns and not wraps(ref, model) else None


def as_carrier(item: String, here: int, there: int, model: Known) -> Way | None:
    """What another body carries is pulled as that is: up a slope, on the level towards its neighbour in the list, else up."""
    owner = item.string[here].owner
    way = line_led(owner, model) if owner in model.seats and line(owner, model) is None else None
    if way is None:
        return None
    slope = lain_on(owner, model)
    if is_slope(slope):
        return uphill(slope, model)
    return UP if abs(way[1]) > 1e-9 else RIGHT if there > here else (-1.0, 0.0)


def slung(item: String, index: int, model: Known) -> bool:
    """Whether a wheel between the ends of a string, which passes under it, travels up and down: its neighbours are above it."""
    ref, between = item.string[index], 0 < index < len(item.string) - 1
    way = line(ref.owner, model) if between and ref.owner in item.under and wraps(ref, model) else None
    return way is not None and abs(way[1]) > 1e-9


def held_aside(ref: PointRef, model: Known) -> bool:
    """Whether it is a point of a turning body off its axis."""
    return model.upright and ref.point not in (None, "rim", "center")


def below(item: String, there: int, model: Known) -> bool:
    """Whether a neighbour hangs there: it travels, and the string does not go round it."""
    ref = item.string[there]
    return ref.owner in model.seats and not wraps(ref, model) and line(ref.owner, model) is not None


def wheeled(item: String, here: int, there: int, model: Known) -> Way | None:
    """A wheel that travels up and down is pulled up where the string passes under it, or ends at it; down where it passes over."""
    ref = item.string[here]
    way = line(ref.owner, model) if ref.owner in model.seats else None
    if way is None or not wraps(ref, model):
        return None
    ends = (0, len(item.string) - 1)
    if here in ends:  # of two wheels on which it ends the first hangs higher
        both = there in ends and wraps(item.string[there], model) and line(item.string[there].owner, model) is not None
        return DOWN if both and there > here else UP
    return UP if ref.owner in item.under else DOWN


def lain_on(name: str, model: Known) -> object:
    """The surface on which a body lies, or what carries it."""
    own = mover(name, model)
    found = (item for item in model.acting.connections if is_touch(item) and item.lying() == own)
    return next((surface_of(item, model) for item in found), None)


def wraps(ref: PointRef, model: Known) -> bool:
    """Whether the string runs on a rim there."""
    return ref.owner in model.seats and on_rim(model.body(ref.owner), ref.point)


def side(item: String, index: int, ways: list[Way | None], model: Known) -> int:
    """+1 where the running string turns a wheel clockwise: over it towards the right, or under it towards the left."""
    ref = item.string[index]
    if not wraps(ref, model):
        return 0
    near = [way for way in ways[max(index - 1, 0) : index + 1] if way is not None]
    leftward = any(way[0] < -1e-9 for way in near)
    return -1 if (ref.owner in item.under) != leftward else 1


def rim_arm(ref: PointRef, way: Way, sign: int, model: Known) -> Way:
    """From the centre of a wheel to where a leg meets it: on the left of the running string where that turns it clockwise."""
    radius = radius_of(model.body(ref.owner), ref.point, model.value) or 0.0
    x, y = turned(way, sign)
    return radius * x, radius * y
