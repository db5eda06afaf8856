"""Reading: what a path of the language is at one instant of the course: how a point or a body moves.

Everything is read from places: a velocity is the rate of a place, an acceleration the rate of that.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from msgspec import Struct

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.node import Node
from rotsolve.confirm.jet import Jet
from rotsolve.confirm.pose import Pair, Way, turned
from rotsolve.core.writing import spoken
from rotsolve.language.bodies import PointRef
from rotsolve.language.problem import Path, Term

NATURAL = ("tangential", "normal")


class Reckoned(Struct, frozen=True):
    """Numbers of the assembly by the names of their parts, '' for the whole; the size of what they are made of; of a choice a word."""

    values: dict[str, float]
    size: float = 1e-4
    word: str = ""
    sized: bool = False  # whether its sign says nothing: only the size is compared
    period: float = 0.0  # numbers so far apart are the same: a place round a circle tells no turns
    way: Way | None = None  # where it points that is told by its size and a word

    @property
    def number(self) -> float:
        return self.values[""]


def number(value: float, size: float = 1e-4, *, sized: bool = False) -> Reckoned:
    return Reckoned({"": value}, max(size, 1e-4), sized=sized)


def vector(way: Way) -> Reckoned:
    """A vector by its size and its components."""
    return Reckoned({"": math.hypot(*way), "x": way[0], "y": way[1]}, math.hypot(*way) + 1e-4)


def component_of(way: Way, component: str | None) -> Reckoned:
    """A vector, or one of its components x and y."""
    if component in ("x", "y"):
        return number(way[0 if component == "x" else 1], math.hypot(*way))
    if component is None:
        return vector(way)
    raise NotConfirmed(f"a component `{component}`")


def scalar(a: Way, b: Way) -> float:
    return a[0] * b[0] + a[1] * b[1]


def cross(a: Way, b: Way) -> float:
    return a[0] * b[1] - a[1] * b[0]


# places


def point_place(at: Node, owner: str, point: str | None, argument: object = None) -> Pair:
    """The place of a point of a body, of the one that travels where none is named; a rim's point is a place in space."""
    if point is None:
        return at.pose.place(owner, at.model.travelling(owner))
    return at.model.place(PointRef(owner, point, argument), at.pose)  # type: ignore[arg-type]


def values(pair: Pair) -> Way:
    return pair[0].value, pair[1].value


def rates(pair: Pair) -> Way:
    return pair[0].rate, pair[1].rate


def bends(pair: Pair, at: Node) -> Way:
    return second_rate(pair[0], at), second_rate(pair[1], at)


def second_rate(jet: Jet, at: Node) -> float:
    """The second rate in time of a function of the places, slope · q̈ + bend."""
    return at.bend(jet)


def motion(at: Node, path: Path) -> Way:
    """Velocity or acceleration of the point that a path names, in the picture; what goes round a shaft has Ω² x towards that."""
    place, round_ = point_place(at, path.owner, path.point, path.argument), at.model.whirled.get(path.owner, 0.0)
    if path.quantity != "acceleration":
        return rates(place)
    x, y = bends(place, at)
    return x - round_**2 * place[0].value, y


def point_motion(at: Node, path: Path, term: Term | None) -> Reckoned:
    """Velocity, speed or acceleration of a point; of a body that travels along a line, along that."""
    way = motion(at, path)
    line = at.line(path.owner) if path.point is None else None
    if path.quantity == "speed":
        across = at.model.whirled.get(path.owner, 0.0) * point_place(at, path.owner, path.point, path.argument)[0].value
        return number(math.hypot(*way, across))
    if path.component in ("x", "y"):
        return component_of(way, path.component)
    if path.component in NATURAL or path.component == "radial":
        return natural(at, path, way)
    if line is not None and path.component is None:
        return number(scalar(way, line), math.hypot(*way))
    return component_of(way, path.component)


def natural(at: Node, path: Path, way: Way) -> Reckoned:
    """The part along the positive turn about a fixed axis, for what rides that of its carrier, else along the point's own velocity; the
    part towards the centre."""
    turning = (at.carrier(path.owner) if path.point is None else None) or path.owner
    place, held = point_place(at, path.owner, path.point, path.argument), at.axis(turning)
    if path.component == "radial":
        return radial(at, path)
    centre = at.orbit_centre(path.owner) if path.point is None else None
    if held is not None or centre is not None:
        middle = values(held) if held is not None else centre
        assert middle is not None
        here = values(place)
        arm = (here[0] - middle[0], here[1] - middle[1])
        size = math.hypot(*arm)
        if size == 0.0:
            return number(0.0)
        out = (arm[0] / size, arm[1] / size)
        if path.component == "normal":
            return number(-scalar(way, out), math.hypot(*way))
        ahead = turned(out, at.model.sense(turning)) if held is not None else at.line(path.owner) or turned(out)
        return number(scalar(way, ahead), math.hypot(*way))
    speed = rates(place)
    size = math.hypot(*speed)
    if size < 1e-12:
        raise NotConfirmed("the path of a point at rest has no direction")
    ahead = (speed[0] / size, speed[1] / size)
    if path.component == "tangential":
        return number(scalar(way, ahead), math.hypot(*way))
    return number(abs(cross(ahead, way)), math.hypot(*way))


def radial(at: Node, path: Path) -> Reckoned:
    """How fast what rides on another body goes outwards."""
    carrier = at.carrier(path.owner)
    if carrier is None:
        raise NotConfirmed("a radial part of what rides on nothing")
    mine, axis = point_place(at, path.owner, "cm"), at.axis(carrier)
    if axis is None:
        raise NotConfirmed("a radial part about no axis")
    arm = (mine[0] - axis[0], mine[1] - axis[1])
    here, rate = values(arm), rates(arm)
    return number(scalar(here, rate) / math.hypot(*here), math.hypot(*rate))


def position(at: Node, path: Path, term: Term | None) -> Reckoned:
    return component_of(values(point_place(at, path.owner, path.point, path.argument)), path.component)


# bodies


def angle(at: Node, path: Path, term: Term | None) -> Reckoned:
    """Of what has settled, and has come there by no way, the one next to 0; a wire counts the turns."""
    found = at.angle(path.owner)
    counted_by_none = at.settled and not any(item.winds() for item in at.model.acting.connections)
    return number(math.remainder(found, math.tau) if counted_by_none else found, 1.0)


def angular(at: Node, path: Path, term: Term | None) -> Reckoned:
    """ω or α along the positive turn; counterclockwise, about z, where that is asked."""
    turn = at.pose.turn(path.owner)
    rate = turn.rate if path.quantity == "angular_velocity" else second_rate(turn, at)
    if path.component in ("x", "y"):
        return number(0.0)
    return number(rate * counted(at, path), abs(turn.rate))


def counted(at: Node, path: Path) -> int:
    """+1 where a quantity about z counts counterclockwise."""
    return 1 if path.component == "z" else at.model.sense(path.owner)


Reading = Callable[[Node, Path, "Term | None"], Reckoned]
OF_MOTION: dict[str, Reading] = {
    **dict.fromkeys(("velocity", "speed", "acceleration"), point_motion),
    "position": position,
    "angle": angle,
    **dict.fromkeys(("angular_velocity", "angular_acceleration"), angular),
}


def of_body(at: Node, path: Path, term: Term | None) -> Reckoned:
    """The meaning of a path of a body; what hangs on its mass, or is its own, is loaded where someone asks."""
    function = OF_MOTION.get(path.quantity)
    if function is None:
        from rotsolve.confirm.course.mechanics import OF_BODIES

        function = OF_BODIES.get(path.quantity)
    if function is None:
        raise NotConfirmed(f"{spoken(path.quantity)} of a body")
    return function(at, path, term)
