"""Gauges: what the lines of a state say, each as a number that is zero where the line holds."""

from __future__ import annotations

import math
from collections.abc import Callable

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.node import Astray, Node
from rotsolve.confirm.instant import gathered, slip_speed
from rotsolve.confirm.lines import SIZED, from_axis, goal_of, once_round, placed_value, rate_of
from rotsolve.confirm.model import Model
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import Ride
from rotsolve.language.problem import COMES_TO, SETTLES, Condition, Path, State

HOLDS = 1e-6  # how well all lines of a state have to hold at once
OWN = ("mass", "inertia", "gyration", "radius", "length")


class Gauge(Struct, frozen=True):
    """A function of an instant that vanishes where a line holds; `size` is what it is small against.

    `passing` marks one that only tells when it changes its sign, not how far it is from zero; `way` is +1 or −1 for one that has to grow or
    to fall there, as the rate of what is smallest or largest; `rests` one of a rate that is nothing there.
    """

    value: Callable[[Node], float]
    size: float
    words: str
    passing: bool = False
    way: int = 0
    rests: bool = False


def gauges(state: State, model: Model, first: Node) -> list[Gauge]:
    """Of all lines of a state but its time, counted from the node at which the phase began."""
    found = []
    for line in state.conditions:
        if line.rest:
            found.append(resting_gauge(line, model))
        elif line.path is not None and line.path.quantity == "time":
            continue
        elif line.word is not None:
            found.append(word_gauge(line, model, first))
        elif line.path is not None and line.path.quantity in OWN and line.path.owner in model.seats:
            found.append(riding_gauge(line, model))
        elif line.path is not None and line.value is not None:
            found.append(value_gauge(line.path, model.value(line.value), model, first))
    return found


def resting_gauge(line: Condition, model: Model) -> Gauge:
    """The rate along the way in which the bodies go, which changes its sign where they stop; of what turns as it goes that of its turn."""
    names = [line.owner] if line.owner in model.seats else list(model.seats)
    places = [model.seats[name].first + k for name in names for k in range(3)]
    ahead: list[float] = []

    def value(at: Node) -> float:
        speed = [at.placed.speed[index] for index in places]
        if not any(ahead) and any(speed):
            turns = [rate if number % 3 == 2 else 0.0 for number, rate in enumerate(speed)]
            ahead[:] = turns if any(turns) else speed
        size = max(map(abs, ahead), default=0.0) or 1.0
        return sum(a * b for a, b in zip(speed, ahead, strict=False)) / size

    return Gauge(value, 1.0, "at rest", passing=True, rests=True)


def riding_gauge(line: Condition, model: Model) -> Gauge:
    """How far from the axis a body is that slides freely along what carries it; what else changes of a body is not followed."""
    path = line.path
    rides = [ride for item in model.acting.connections if (ride := item.ride()) is not None and ride.free]
    if path is None or line.value is None or path.owner not in [ride.rider.owner for ride in rides]:
        raise NotConfirmed(f"`{path.owner if path is not None else line.owner}` changes on the way")
    owner, far = path.owner, model.value(line.value)

    def gap(at: Node) -> float:
        out = out_on_rod(owner, at)
        away = from_axis(owner, at.pose, at.model) if out is None else None
        return (out or 0.0) - far if away is None else away.value - far

    return Gauge(gap, far, f"{owner}.radius")


def out_on_rod(owner: str, at: Node) -> float | None:
    """How far out from the axis a body is on a rod that begins there, less than nothing beyond it; None on all else."""
    ride = next(ride for item in at.model.acting.connections if (ride := item.ride()) and ride.rider.owner == owner)
    found, axis = along_rod(ride, at), at.model.axis(ride.carrier.owner)[0]
    if found is None or abs(abs(axis) - found[1]) > HOLDS * found[1]:
        return None
    return found[1] - found[0] * axis / found[1]


def along_rod(ride: Ride, at: Node) -> tuple[float, float] | None:
    """How far a body is from the middle of the rod on which it rides, along that, and half the rod's length; None on all else."""
    model, rider, carrier = at.model, ride.rider.owner, ride.carrier.owner
    whole = shape_of(model.body(carrier)).reach()
    if whole is None:
        return None
    half = model.value(whole) / 2
    (x, y), (u, w), (a, b) = (
        at.pose.place(name, spot)
        for name, spot in ((rider, model.seats[rider].rigid.centre), (carrier, (0.0, 0.0)), (carrier, (half, 0.0)))
    )
    return ((x.value - u.value) * (a.value - u.value) + (y.value - w.value) * (b.value - w.value)) / half, half


def check_on_carriers(at: Node) -> None:
    """Astray where a body has slid off an end of the rod on which it rides, or off the rim of what is round."""
    for item in at.model.acting.connections:
        ride = item.ride()
        if ride is not None and ride.free and share_of_way(ride, at) > 1 + HOLDS:
            raise Astray(f"`{ride.rider.owner}` slides off `{ride.carrier.owner}`")


def share_of_way(ride: Ride, at: Node) -> float:
    """How far a body is from the middle of that on which it rides, as a share of the way to where that ends."""
    found, shape = along_rod(ride, at), shape_of(at.model.body(ride.carrier.owner))
    if found is not None:
        return abs(found[0]) / found[1]
    away = from_axis(ride.rider.owner, at.pose, at.model)
    return (
        away.value / at.model.value(shape.outer)
        if away is not None and shape.round and shape.outer is not None
        else 0.0
    )


def word_gauge(line: Condition, model: Model, first: Node) -> Gauge:
    """`rolls`, `sticks`: no slip; `leaves`, `slack`: nothing that pushes or pulls; `largest`: what does not change."""
    owner = line_owner(line)
    if line.word in ("rolls", "sticks"):
        return Gauge(lambda at: slip_of(owner, at), 1.0, f"{owner}: {line.word}")
    if line.word in ("leaves", "slack"):
        return Gauge(lambda at: least(owner, at), 1.0, f"{owner}: {line.word}")
    if line.word == "slips":
        return Gauge(lambda at: clasp(owner, at), 1.0, f"{owner}: {line.word}")
    if line.word in COMES_TO and line.path is not None:
        path = line.path
        falls = line.word == "smallest" or (line.word == SETTLES and rate(path, first) < 0.0)
        way = 1 if falls else -1
        return Gauge(lambda at: rate(path, at), 1.0, f"{path.owner}.{path.quantity}: {line.word}", way=way)
    raise NotConfirmed(f"a state that says `{owner}: {line.word}`")


def line_owner(line: Condition) -> str:
    """The element of which a line of a state says something."""
    return line.owner or (line.path.owner if line.path is not None else "")


def slip_of(owner: str, at: Node) -> float:
    if owner in at.moment.clasped:
        return 0.0
    grips = [grip for grip in gathered(at.model, at.pose)[1] if owner in (grip.name, grip.row.owner)]
    if not grips:
        raise NotConfirmed(f"`{owner}` does not rub")
    return slip_speed(grips[0], at.placed.speed)


def clasp(owner: str, at: Node) -> float:
    """How far what lies on a turning body is from slipping."""
    if owner not in at.moment.clasped:
        raise NotConfirmed(f"a state that says `{owner}: slips`")
    return at.moment.clasped[owner]


def least(owner: str, at: Node) -> float:
    """The smallest of the pushes or pulls of an element; none of what the assembly has left out since it pushes no more."""
    if all(item.name != owner for item in at.model.acting.connections):
        return 0.0
    found = [
        size for (name, kind), size in at.moment.reactions.items() if name == owner and at.moment.rows[name, kind].push
    ]
    if not found:
        raise NotConfirmed(f"`{owner}` neither pushes nor pulls")
    return min(found)


def rate(path: Path, at: Node) -> float:
    """How fast a place changes, or a rate."""
    place = placed_value(path, at.pose, at.model)
    if place is not None:
        return place.rate
    found = rate_of(path, at.pose, at.model)
    if found is None:
        raise NotConfirmed(f"an extreme of `{path.quantity}`")
    return sum([part * at.pushes[index] for index, part in found[0].items()]) * found[1]


def value_gauge(path: Path, value: float, model: Model, first: Node) -> Gauge:
    """A place or a rate has a value; displacement and rotation count from the state before."""
    words = f"{path.owner}.{path.quantity}"

    def gap(at: Node) -> float:
        placed = replace(at.placed, origin=first.placed.q)
        pose = placed.pose(at.model)
        if path.quantity == "elongation":
            return at.stretched(path.owner) - value
        found = rate_of(path, pose, at.model)
        if found is not None:
            slope, sign = found
            speed = sum([part * at.placed.speed[index] for index, part in slope.items()]) * sign
            return abs(speed) - goal_of(path, value) if path.quantity in SIZED else speed - value
        place = placed_value(path, pose, at.model)
        if place is None:
            from rotsolve.confirm.course.asked import reading

            return reading(at, path).number - value
        return place.value - value

    size = max(abs(value), 0.1 if path.quantity in ("displacement", "height", "elongation") else 1.0)
    whole = once_round(path, model)
    counted = gap if whole is None else unwound(gap, begun_at(path, first, gap(first) + value) - value, whole)
    return Gauge(counted, size, words, rests=path.quantity in ("velocity", "angular_velocity") and value == 0.0)


def begun_at(path: Path, first: Node, read: float) -> float:
    """Where a place round a circle begins: as the state before tells it, which counts turns, else as it is read."""
    if path.quantity != "angle":
        return read
    own = (path.owner, path.quantity)
    for line in first.model.acting.state.conditions:
        if line.path is not None and line.value is not None and (line.path.owner, line.path.quantity) == own:
            return first.model.value(line.value)
    return read


def unwound(gap: Callable[[Node], float], begun: float, whole: float) -> Callable[[Node], float]:
    """A gap that reads the same after each whole turn, by the turn on which it began; it jumps as far past its zero as before its start."""
    if abs(begun) >= whole:
        raise NotConfirmed("what goes more than once round")
    middle = begun / 2
    return lambda at: middle + math.remainder(gap(at) - middle, whole)
