"""Bodies in numbers: mass, centre of mass and moment of inertia, and where their points are, in their own axes."""

from __future__ import annotations

import math
from collections.abc import Callable

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ONE, Formula
from rotsolve.confirm import NotConfirmed
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import Body, Part

Value = Callable[[Formula], float]
Spot = tuple[float, float]
ALIKE = 1e-6  # by how much of itself a mass may differ from what its density makes of it
SPATIAL = {
    "rim": (1.0, 0.0),
    "top": (0.0, 1.0),
    "bottom": (0.0, -1.0),
}  # points of a round body that do not turn with it


class Mass(Struct, frozen=True):
    """Σ m, Σ m r and Σ (I + m r²), about the origin of the body's axes: what adds up over pieces."""

    whole: float
    x: float
    y: float
    about: float

    def plus(self, other: Mass, sign: float = 1.0) -> Mass:
        return Mass(
            self.whole + sign * other.whole,
            self.x + sign * other.x,
            self.y + sign * other.y,
            self.about + sign * other.about,
        )

    def moved(self, spot: Spot, turn: float) -> Mass:
        """Turned about the origin, and then moved by a vector."""
        c, s, (u, w) = math.cos(turn), math.sin(turn), spot
        x, y = c * self.x - s * self.y, s * self.x + c * self.y
        return Mass(
            self.whole,
            x + self.whole * u,
            y + self.whole * w,
            self.about + 2 * (x * u + y * w) + self.whole * (u * u + w * w),
        )


class Rigid(Struct, frozen=True):
    """A body as the assembly knows it; `centre` is its centre of mass in its own axes, whose origin is its geometric centre."""

    name: str
    body: Body
    mass: float
    centre: Spot
    inertia: float


def rigid(body: Body, value: Value) -> Rigid:
    """Mass, centre of mass, and moment of inertia about that."""
    mass = spread(body, value)
    if mass.whole == 0.0:
        spot = tuple(value(part) for part in shape_of(body).centroid())
        return Rigid(body.name, body, 0.0, (spot[0], spot[1]), own_inertia(body, 0.0, value))
    x, y = mass.x / mass.whole, mass.y / mass.whole
    return Rigid(body.name, body, mass.whole, (x, y), max(mass.about - mass.whole * (x * x + y * y), 0.0))


def spread(body: Body, value: Value) -> Mass:
    """How the mass of a body is spread: of its own shape, its parts, less its holes; all of that `count` times round the centre."""
    total = own(body, value)
    for part in body.parts:
        total = total.plus(spread(part.body, value).moved(*frame(part, value)))
    for hole in body.holes:
        total = total.plus(hollow(hole, body, value), -1.0)
    if body.count > 1:
        n = float(body.count)
        return Mass(n * total.whole, 0.0, 0.0, n * total.about)
    return total


def own(body: Body, value: Value) -> Mass:
    """Of the body's shape, without parts and holes."""
    if body.mass is None:
        if body.parts and body.shape is None:
            return Mass(0.0, 0.0, 0.0, 0.0)
        raise NotConfirmed(f"the mass of `{body.name}` has no number")
    mass = value(body.mass)
    if not as_dense(body, value):
        raise NotConfirmed(f"`{body.name}` has not the mass that its density tells")
    if body.holes and body.shape is not None:
        mass /= 1.0 - sum(share_cut_out(hole, body, value) for hole in body.holes)
    x, y = (value(part) for part in shape_of(body).centroid())
    return Mass(mass, mass * x, mass * y, own_inertia(body, mass, value) + mass * (x * x + y * y))


def as_dense(body: Body, value: Value) -> bool:
    """Whether a body that has a density has the mass that this and its size make."""
    shape = shape_of(body)
    if body.mass is None or body.density is None or body.holes:
        return True
    mass = value(body.mass)
    made = value(shape.measure()) if shape.graded else value(body.density) * value(shape.content())
    return abs(made - mass) <= ALIKE * abs(mass)


def own_inertia(body: Body, mass: float, value: Value) -> float:
    """About its own centre of mass: as given, else by its shape."""
    if body.inertia is not None:
        return value(body.inertia)
    if body.gyration is not None:
        return mass * value(body.gyration) ** 2
    return mass * value(shape_of(body).moment(ONE)) if mass else 0.0


def hollow(hole: Part, body: Body, value: Value) -> Mass:
    """What is cut out: the material that the hole would hold, where its mass is not given."""
    spot, turn = frame(hole, value)
    if hole.body.mass is not None or body.mass is None:
        return spread(hole.body, value).moved(spot, turn)
    shares = [share_cut_out(other, body, value) for other in body.holes]
    mass = value(body.mass) * share_cut_out(hole, body, value) / (1.0 - sum(shares))
    x, y = (value(part) for part in shape_of(hole.body).centroid())
    moment = mass * value(shape_of(hole.body).moment(ONE))
    return Mass(mass, mass * x, mass * y, moment + mass * (x * x + y * y)).moved(spot, turn)


def share_cut_out(hole: Part, body: Body, value: Value) -> float:
    """The part of a body without holes that one takes away: of what is as deep as the body by the areas, of others by what they fill."""
    cut, whole = shape_of(hole.body), shape_of(body)
    sizes = [getattr(shape, "length", None) for shape in (cut, whole)]
    box: tuple[Formula, ...] = getattr(whole, "sides", ())
    if whole.flat or (whole.seen and (cut.flat or (cut.seen and sizes[0] == sizes[1]))):
        return value(cut.measure()) / value(whole.measure())
    room = value(cut.measure()) * value(box[2]) if cut.flat and len(box) == 3 else value(cut.content())
    return room / value(whole.content())


def frame(part: Part, value: Value) -> tuple[Spot, float]:
    """Where a part's centre is in the axes of the whole, and how far it is turned."""
    if part.start is not None and part.end is not None:
        (ax, ay), (bx, by) = (tuple(value(item) for item in end) for end in (part.start, part.end))
        return ((ax + bx) / 2, (ay + by) / 2), math.atan2(by - ay, bx - ax)
    turn = value(part.angle) if part.angle is not None else 0.0
    reach = part.body.shape.reach() if part.start is not None and part.body.shape is not None else None
    if part.start is not None and reach is not None:
        half = value(reach) / 2
        x, y = (value(item) for item in part.start)
        return (x + half * math.cos(turn), y + half * math.sin(turn)), turn
    if part.at is None:
        return (0.0, 0.0), turn
    return (value(part.at[0]), value(part.at[1])), turn


def outline_of(body: Body, value: Value) -> list[Spot]:
    """The corners and ends of a body and of its parts, in its own axes."""
    own = [(value(x), value(y)) for x, y in shape_of(body).outline()]
    for part in body.parts:
        (left, low), turn = frame(part, value)
        across, up = math.cos(turn), math.sin(turn)
        own += [(left + x * across - y * up, low + x * up + y * across) for x, y in outline_of(part.body, value)]
    return own


def part_of(body: Body, point: str | None) -> Part | None:
    return next((part for part in body.parts if part.body.name == point), None)


def spot_of(item: Rigid, point: str | None, argument: Formula | None, value: Value) -> Spot:
    """Where a point is in the body's axes; of what does not turn with it (the top of a wheel), its centre."""
    body = item.body
    if point == "cm":
        return item.centre
    if point is None:
        return (0.0, 0.0)
    for name, at in body.points:
        if name == point:
            return value(at[0]), value(at[1])
    part = part_of(body, point)
    if part is not None:
        return frame(part, value)[0]
    if side_of(body, point) is not None:
        return (0.0, 0.0)
    x, y = shape_of(body).locate(point, argument)
    return value(x), value(y)


def radius_of(body: Body, point: str | None, value: Value) -> float | None:
    """The radius of the rim that a point names: one of `radii`, that of a part, else the body's own; None where it has none."""
    shape = shape_of(body)
    radii = dict((*body.radii, *getattr(shape, "radii", ())))
    part = part_of(body, point)
    if part is not None:
        return radius_of(part.body, None, value)
    found = radii.get(point) if point else None
    found = found or shape.outer or body.radius
    found = found or (
        body.radii[-1][1] if body.radii else None
    )  # of several only whether there is one: what touches a rim names it
    return None if found is None else value(found)


class Rocker(Struct, frozen=True):
    """What is round on one side alone: its radius, and from where to where that side goes, as angles in the axes of its body."""

    radius: float
    first: float
    last: float

    def spare(self, way: float) -> float:
        """How far inside its round side a direction of the body's axes is: cos of the angle to the middle less that of half its opening."""
        middle, half = (self.first + self.last) / 2, (self.last - self.first) / 2
        return math.cos(way - middle) - math.cos(half)


def rocker(body: Body, point: str | None, value: Value) -> Rocker | None:
    """The round side of a body, or of the part of it that a point names."""
    part = part_of(body, point)
    if part is None and point is not None:
        return None
    bow = shape_of(body if part is None else part.body).bow()
    if bow is None:
        return None
    turn = 0.0 if part is None else frame(part, value)[1]
    return Rocker(value(bow.radius), value(bow.first) + turn, value(bow.last) + turn)


def is_round(body: Body) -> bool:
    """Whether it looks like a circle: its shape does, or it has a radius without a shape."""
    if body.shape is not None and not body.shape.pointlike:
        return "rim" in body.shape.points
    return body.radius is not None or bool(body.radii)


def side_of(body: Body, point: str | None) -> Spot | None:
    """The side on which a point of a rim is: that of a rim as a whole is the one on the right; None of any other point."""
    if point in SPATIAL:
        return SPATIAL[point] if is_round(body) or body.radius is not None else None
    names = {name for name, _ in (*body.radii, *getattr(shape_of(body), "radii", ()))}
    return SPATIAL["rim"] if point in names else None


def on_rim(body: Body, point: str | None) -> bool:
    """Whether a point names a rim as a whole, on which a string or a surface finds its own place: `wheel`, `wheel.rim`, `drum.big`."""
    part = part_of(body, point)
    if part is not None:
        return is_round(part.body)
    if not is_round(body):
        return False
    names = {name for name, _ in (*body.radii, *getattr(shape_of(body), "radii", ()))}
    return point is None or point == "rim" or point in names


def as_one(body: Body, free: bool) -> Body:
    """Riders that slide freely and symmetrically move as one of the mass of all."""
    if not free or body.count == 1 or body.mass is None:
        return body
    whole: Body = replace(body, mass=body.mass * body.count, count=1)
    return whole
