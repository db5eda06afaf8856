"""Reading: what a path of the language is at one instant of the course: of a point, of a body, of the whole scene.

Everything is read from places: a velocity is the rate of a place, an acceleration the rate of that, an energy the sum over the bodies.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from msgspec import Struct

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import radius_of
from rotsolve.confirm.carried import about_shaft
from rotsolve.confirm.course.node import Node
from rotsolve.confirm.jet import Jet
from rotsolve.confirm.pose import Pair, Way, turned
from rotsolve.language.bodies import PointRef
from rotsolve.language.problem import Path, Term

NATURAL = ("tangential", "normal")


class Reckoned(Struct, frozen=True):
    """Numbers of the assembly by the names of their parts, '' for the whole; the size of what they are made of; of a choice a word."""

    values: dict[str, float]
    size: float = 1e-4
    word: str = ""
    sized: bool = False  # whether its sign says nothing: only the size is compared

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
    """The part along the positive turn about a fixed axis, else along the point's own velocity; the part towards the centre."""
    place, held = point_place(at, path.owner, path.point, path.argument), at.axis(path.owner)
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
        ahead = turned(out, at.model.sense(path.owner)) if held is not None else at.line(path.owner) or turned(out)
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
    return number(at.angle(path.owner), 1.0)


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


def kinetic_energy(at: Node, path: Path, term: Term | None) -> Reckoned:
    """½ m v² + ½ I ω²: of the body alone."""
    rigid = at.model.seats[path.owner].rigid
    speed, spin = rates(point_place(at, path.owner, "cm")), at.pose.turn(path.owner).rate
    travel, turning = 0.5 * rigid.mass * scalar(speed, speed), 0.5 * rigid.inertia * spin * spin
    if path.owner in at.model.whirled:
        turning += 0.5 * at.model.whirled[path.owner] ** 2 * about_shaft(path.owner, at.model, at.pose)
    if path.component == "rotational":
        return number(travel + turning if at.axis(path.owner) is not None else turning)
    return number(travel if path.component == "translational" else travel + turning)


def height_energy(at: Node, path: Path, term: Term | None) -> Reckoned:
    """m g y: only differences count."""
    rigid = at.model.seats[path.owner].rigid
    return number(rigid.mass * at.model.gravity * point_place(at, path.owner, "cm")[1].value)


def body_energy(at: Node, path: Path, term: Term | None) -> Reckoned:
    return number(kinetic_energy(at, path, term).number + height_energy(at, path, term).number)


def momentum(at: Node, path: Path, term: Term | None) -> Reckoned:
    """m v: along the line of travel where there is one."""
    mass, speed = at.model.seats[path.owner].rigid.mass, rates(point_place(at, path.owner, "cm"))
    way = (mass * speed[0], mass * speed[1])
    line = at.line(path.owner)
    if path.component is None and line is not None:
        return number(scalar(way, line), math.hypot(*way))
    return component_of(way, path.component)


def angular_momentum(at: Node, path: Path, term: Term | None) -> Reckoned:
    """r × m v + I ω about a named point, else about the axis or the centre of mass; along the positive turn."""
    if path.component not in (None, "z") or path.point is not None:
        raise NotConfirmed("an angular momentum in space, or that of a part")
    rigid, centre = at.model.seats[path.owner].rigid, point_place(at, path.owner, "cm")
    middle = at.reference(path.owner, term)
    arm = (centre[0].value - middle[0], centre[1].value - middle[1])
    orbital = rigid.mass * cross(arm, rates(centre))
    spin = rigid.inertia * at.pose.turn(path.owner).rate
    return number((orbital + spin) * at.model.sense(path.owner), abs(orbital) + abs(spin))


def net_force(at: Node, path: Path, term: Term | None) -> Reckoned:
    """m a of the centre of mass, or the weight alone."""
    rigid = at.model.seats[path.owner].rigid
    way = bends(point_place(at, path.owner, "cm"), at)
    if path.component == "gravity":
        return vector((0.0, -rigid.mass * at.model.gravity))
    if path.component in NATURAL:
        found = natural(at, Path(path.owner, "force", "cm", component=path.component), way)
        return number(rigid.mass * found.number, rigid.mass * found.size)
    return component_of((rigid.mass * way[0], rigid.mass * way[1]), None if path.component == "net" else path.component)


def torque(at: Node, path: Path, term: Term | None) -> Reckoned:
    """Of all forces, d(r × m v + I ω)/dt about a point that stays, or of the weight alone."""
    rigid, centre = at.model.seats[path.owner].rigid, point_place(at, path.owner, "cm")
    middle = at.reference(path.owner, term)
    arm = (centre[0].value - middle[0], centre[1].value - middle[1])
    if path.component == "gravity":
        found = -arm[0] * rigid.mass * at.model.gravity
    elif path.component not in (None, "net"):
        raise NotConfirmed(f"the torque of `{path.component}` alone")
    else:
        push = bends(centre, at)
        found = rigid.mass * cross(arm, push) + rigid.inertia * second_rate(at.pose.turn(path.owner), at)
    return number(found * counted(at, path), rigid.mass * at.model.gravity * math.hypot(*arm))


def power(at: Node, path: Path, term: Term | None) -> Reckoned:
    """m a · v + I α ω, or that of the weight alone."""
    rigid, centre = at.model.seats[path.owner].rigid, point_place(at, path.owner, "cm")
    speed = rates(centre)
    if path.component == "gravity":
        return number(-rigid.mass * at.model.gravity * speed[1])
    if path.component not in (None, "net"):
        raise NotConfirmed(f"the power of `{path.component}` alone")
    turn = at.pose.turn(path.owner)
    return number(rigid.mass * scalar(bends(centre, at), speed) + rigid.inertia * second_rate(turn, at) * turn.rate)


def instantaneous_centre(at: Node, path: Path, term: Term | None) -> Reckoned:
    """From the centre of mass, where v + ω × r = 0."""
    speed, spin = rates(point_place(at, path.owner, "cm")), at.pose.turn(path.owner).rate
    if spin == 0.0:
        raise NotConfirmed("a body that does not turn has no instantaneous centre")
    return component_of((-speed[1] / spin, speed[0] / spin), path.component)


def period(at: Node, path: Path, term: Term | None) -> Reckoned:
    return number(2 * math.pi / abs(at.pose.turn(path.owner).rate))


def own_data(at: Node, path: Path, term: Term | None) -> Reckoned:
    """Mass, radius or length of a body; of what rides on another its distance from the axis."""
    if path.quantity == "mass":
        return number(at.model.seats[path.owner].rigid.mass)
    body = at.model.body(path.owner)
    if path.quantity == "radius":
        radius = radius_of(body, None, at.model.value)
        if radius is None and body.shape is not None and getattr(body.shape, "radius", None) is not None:
            radius = at.model.value(body.shape.radius)
        if radius is not None:
            return number(radius)
    length = getattr(body.shape, "length", None)
    if path.quantity == "length" and length is not None:
        return number(at.model.value(length))
    raise NotConfirmed(f"the {path.quantity} of `{path.owner}`")


def inertia(at: Node, path: Path, term: Term | None) -> Reckoned:
    """About the centre of mass, or I + m d² about a named point; the radius of gyration √(I/m)."""
    if (term is not None and term.along is not None) or path.point is not None:
        raise NotConfirmed("a moment of inertia about an axis in the plane, or of a part")
    rigid, moment = at.model.seats[path.owner].rigid, at.model.seats[path.owner].rigid.inertia
    if term is not None and term.about is not None:
        middle, centre = at.reference(path.owner, term), values(point_place(at, path.owner, "cm"))
        moment += rigid.mass * ((centre[0] - middle[0]) ** 2 + (centre[1] - middle[1]) ** 2)
    return number(moment if path.quantity == "inertia" else math.sqrt(moment / rigid.mass))


def body_height(at: Node, path: Path, term: Term | None) -> Reckoned:
    return number(at.height(path.owner))


Reading = Callable[[Node, Path, "Term | None"], Reckoned]
OF_BODIES: dict[str, Reading] = {
    **dict.fromkeys(("velocity", "speed", "acceleration"), point_motion),
    "position": position,
    "angle": angle,
    **dict.fromkeys(("angular_velocity", "angular_acceleration"), angular),
    "kinetic_energy": kinetic_energy,
    "potential_energy": height_energy,
    "energy": body_energy,
    "momentum": momentum,
    "angular_momentum": angular_momentum,
    "force": net_force,
    "torque": torque,
    "power": power,
    "instantaneous_centre": instantaneous_centre,
    "period": period,
    "height": body_height,
    **dict.fromkeys(("inertia", "gyration"), inertia),
    **dict.fromkeys(("mass", "radius", "length"), own_data),
}
