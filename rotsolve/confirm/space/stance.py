"""Stance: how all bodies of a rig stand at one state: their rotations and places, and the directions of their joints.

Euler angles are z-x-z: φ about the vertical, the tilt θ from it to the body's axis e₃ about the level line of nodes e₁, ψ about e₃.
"""

from __future__ import annotations

import math

from msgspec import Struct

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.space.arrows import (
    ALONG,
    STILL,
    TINY,
    Arrow,
    Turned,
    X,
    Z,
    arrow_length,
    crossed,
    inner_product,
    least_turn,
    less,
    normed,
    product_of,
    rotation_about,
    rows_back,
    scaled,
    sum_of,
    times_arrow,
)
from rotsolve.confirm.space.masses import turned_together
from rotsolve.confirm.space.rig import Lines, Rig, way_along
from rotsolve.elements.shapes import rim_radius, rolling_shape, shape_of
from rotsolve.language.bodies import Coupling, Joint, PointRef

SIDES = {"bottom": 1.0, "top": -1.0}
ON_AXIS = 1e-9  # how nearly two directions are one
ASKEW = (2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0)  # a direction that means nothing


class Nodes(Struct, frozen=True):
    """The directions about which φ, θ and ψ turn a body: up, the line of nodes, its axis."""

    up: Arrow
    first: Arrow
    third: Arrow


class Stance:
    """All rotations and places at a state; `open` are bodies of which nothing tells how they stand, each turned by some number."""

    def __init__(self, rig: Rig, lines: Lines, guess: float = 0.7) -> None:
        self.rig, self.lines, self.guess = rig, lines, guess
        self.open: set[str] = set()
        self.put_so: set[str] = set()  # bodies of which it is said how they are turned
        self.swung: dict[
            str, float
        ] = {}  # how far bodies are turned about their hinges, where a way is followed or a blow keeps it
        self.slid: dict[str, Arrow] = {}  # where the points of bodies on slides are, from where they are held, likewise
        self._turned: dict[str, Turned] = {}
        self._places: dict[str, Arrow] = {}

    # rotations

    def turned(self, name: str) -> Turned:
        """The rows that turn a body's own components into those of space."""
        if name not in self._turned:
            self._turned[name] = self._turn(name)
        return self._turned[name]

    def put(self, name: str, rows: Turned, place: Arrow | None = None) -> None:
        """Have a body turned in some way and at some place, whatever is told."""
        self._turned[name] = rows
        self.put_so.add(name)
        if place is not None:
            self._places[name] = place

    def base(self, joint: Joint) -> Turned:
        """How what carries a joint is turned."""
        return self.turned(joint.carrier.owner) if joint.carrier.owner in self.rig.bodies else ALONG

    def _turn(self, name: str) -> Turned:
        drawn, joint = turned_together(self.rig.bodies[name].turned, self.rig.value), self.rig.main(name)
        if joint is None or joint.free:
            line = self.rig.line(name)
            if joint is not None and line is not None:
                return product_of(product_of(self.base(joint), drawn), rotation_about(line, self.angle(joint)))
            ends = self.rig.ends(name)
            if ends:
                return least_turn(normed(self.rig.drawn_way(ends)), normed(less(*map(self.held_at, ends[::-1]))))
            upright = self.lines.arrow_told(name, "vertical")
            if upright is not None:
                return least_turn(normed(upright[0]), Z)
            return self._nodding(name) if self.lines.nods(name) else self._anyhow(name, drawn)
        base = self.base(joint)
        if not joint.turning:
            return product_of(base, self.rig.seats.get(name, drawn))
        way, angle = way_along(self.rig, joint.turning[0]), self.angle(joint)
        if not joint.aligned:
            if joint.sliding:  # its direction is in the axes of what carries it
                return product_of(product_of(base, rotation_about(way, angle)), drawn)
            return product_of(product_of(base, drawn), rotation_about(way, angle))
        return product_of(product_of(base, rotation_about(way, angle)), self._on_axle(name, way, drawn))

    def _anyhow(self, name: str, drawn: Turned) -> Turned:
        """A body that may turn about any axis: as it is drawn until time has passed, and in a steady state, which not all stances allow."""
        if not self.lines.later or self.lines.steady:
            return drawn
        self.open.add(name)
        return product_of(rotation_about(ASKEW, self.guess), drawn)

    def _on_axle(self, name: str, way: Arrow, drawn: Turned) -> Turned:
        """A body on an axle: as it is drawn, or with its axis put along the axle."""
        axis = self.rig.axis(name)
        if axis is None:
            return drawn
        own = times_arrow(drawn, axis)
        if arrow_length(crossed(own, way)) < ON_AXIS and inner_product(own, way) > 0.0:
            return drawn
        if drawn != ALONG:
            raise NotConfirmed(f"`{name}` is turned and put on an axle that is not along its axis")
        return least_turn(axis, way)

    def angle(self, joint: Joint) -> float:
        """How far a body is turned about its hinge or axle from how it is drawn."""
        drive = dict(joint.drive)
        if "angle" in drive:
            return self.rig.over_time(drive["angle"])[0]
        for item in self.rig.couplings.values():
            if item.second.owner == joint.body.owner:
                return self.tied_angle(item)
        told = (self.lines.told(owner, "angle") for owner in (joint.body.owner, joint.owner))
        angle = next((angle for angle in told if angle is not None), None)
        if angle is None and self.lines.later:
            self.open.add(joint.body.owner)
            return self.guess
        return angle or 0.0

    def tied_angle(self, item: Coupling) -> float:
        """How far the second shaft of a universal joint is turned: with e its arm as drawn, e cos φ + n × e sin φ is square to c now."""
        own = normed(self.rig.arrow(item.arm))
        (drawn, _), (_, way) = (self.shaft_drawn(ref.owner) for ref in (item.first, item.second))
        start, arm = crossed(way, times_arrow(drawn, own)), times_arrow(self.turned(item.first.owner), own)
        return math.atan2(inner_product(arm, start), -inner_product(arm, crossed(way, start)))

    def shaft_drawn(self, name: str) -> tuple[Turned, Arrow]:
        """How a body on a hinge or an axle of the ground stands before it is turned about that, and the axis in space."""
        joint, drawn = self.rig.main(name), turned_together(self.rig.bodies[name].turned, self.rig.value)
        if joint is None or not joint.turning:
            raise NotConfirmed("a universal joint of what is on no hinge")
        way = way_along(self.rig, joint.turning[0])
        return (self._on_axle(name, way, drawn), way) if joint.aligned else (drawn, times_arrow(drawn, way))

    def arms(self, item: Coupling) -> tuple[Arrow, Arrow]:
        """The two arms of the cross of a universal joint, in space."""
        first = times_arrow(self.turned(item.first.owner), normed(self.rig.arrow(item.arm)))
        return first, normed(crossed(self.shaft_drawn(item.second.owner)[1], first))

    def euler(self, name: str) -> tuple[float, float, float]:
        """φ, θ and ψ; φ = ψ = 0 where nothing tells them."""
        if name in self.put_so:
            return euler_of(self.turned(name), put_third(self.rig.axis(name) or Z))
        phi, tilt, psi = (self.lines.told(name, word) for word in ("precession_angle", "tilt", "spin_angle"))
        if tilt is None:
            self.open.add(name)
            tilt = self.guess
        return phi or 0.0, tilt, psi or 0.0

    def _nodding(self, name: str) -> Turned:
        axis = self.rig.axis(name)
        if axis is None:
            raise NotConfirmed(f"`{name}` has no axis that tilts")
        phi, tilt, psi = self.euler(name)
        rows = product_of(rotation_about(Z, phi), product_of(rotation_about(X, tilt), rotation_about(Z, psi)))
        return product_of(rows, put_third(axis))

    def nodes(self, name: str) -> Nodes:
        """The line of nodes and the axis of a body, in space."""
        axis = self.rig.axis(name)
        if axis is None:
            raise NotConfirmed(f"`{name}` has no axis that tilts")
        third = times_arrow(self.turned(name), axis)
        level = crossed(Z, third)
        if self.lines.nods(name) and name not in self.put_so:
            level = times_arrow(rotation_about(Z, self.euler(name)[0]), X)
        elif arrow_length(level) < TINY:
            raise NotConfirmed(f"the axis of `{name}` is upright: it has no line of nodes")
        return Nodes(Z, normed(level), third)

    def node_axes(self, name: str) -> Turned:
        """The rows that turn components along the node axes into those of space."""
        nodes = self.nodes(name)
        return rows_back((nodes.first, crossed(nodes.third, nodes.first), nodes.third))

    def way(self, joint: Joint) -> Arrow:
        """The direction of a joint's axis in space."""
        own = way_along(self.rig, (joint.turning or joint.sliding)[0])
        if joint.aligned or joint.sliding:
            return times_arrow(self.base(joint), own)
        return times_arrow(self.turned(joint.body.owner), own)

    # places

    def arm(self, ref: PointRef) -> Arrow:
        """A point from the centre of mass of its body, in space; the top of a round one is its highest place, whatever of it is there."""
        side = SIDES.get(ref.point or "")
        if side and shape_of(self.rig.bodies[ref.owner]).round:
            return self.lowest_of(ref.owner, side)
        off = less(self.rig.spot(ref), self.rig.solid(ref.owner).centre)
        return times_arrow(self.turned(ref.owner), off)

    def place(self, name: str) -> Arrow:
        """The centre of mass of a body."""
        if name not in self._places:
            self._places[name] = self._place(name)
        return self._places[name]

    def _place(self, name: str) -> Arrow:
        joint, told = self.rig.main(name), self.lines.arrow_told(name, "position")
        if joint is not None and name in self.slid:
            off = less(times_arrow(self.base(joint), self.slid[name]), self.arm(joint.body))
            return sum_of(self.held_at(joint), off)
        if joint is not None and (told is None or not joint.sliding):
            held = less(self.held_at(joint), self.arm(joint.body))
            if not joint.sliding or not self.lines.later:
                return held
            self.open.add(name)  # how far it has slid
            return sum_of(held, scaled(self.guess, self.way(joint)))
        if told is not None and told[2]:
            return sum_of(self.origin(told[2]), times_arrow(self.turned(told[2]), told[0]))
        if told is not None:
            return told[0]
        led = {axis: part for word, axis, part in self.rig.bodies[name].moved if word == "position"}
        x, y, z = (self.rig.over_time(led[axis])[0] if axis in led else 0.0 for axis in ("x", "y", "z"))
        lying = next((item for item in self.rig.joints.values() if item.rolls and item.body.owner == name), None)
        return (x, y, z) if lying is None else (x, y, -self.lowest(lying)[2])

    def origin(self, frame: str) -> Arrow:
        """From where places relative to a body count: the point at which a joint holds it, else its centre of mass."""
        held = self.rig.main(frame)
        return self.place(frame) if held is None else sum_of(self.place(frame), self.arm(held.body))

    def carried_at(self, joint: Joint) -> Arrow:
        """Where a joint holds its body, from the centre of mass of what carries it: of what slides where it is."""
        if not joint.sliding:
            return self.arm(joint.carrier)
        return less(self.point(joint.body), self.place(joint.carrier.owner))

    def held_at(self, joint: Joint) -> Arrow:
        """Where a joint holds a point: a place of the ground, or a point of what carries it."""
        if joint.carrier.owner in self.rig.bodies:
            return sum_of(self.place(joint.carrier.owner), self.arm(joint.carrier))
        return STILL if joint.carrier.place is None else self.rig.arrow(joint.carrier.place)

    def point(self, ref: PointRef) -> Arrow:
        """Where a point of a body is."""
        return sum_of(self.place(ref.owner), self.arm(ref))

    def apart(self) -> list[float]:
        """By how much the places that hold the ends of each bar are farther apart than it is long, as shares of that."""
        found = []
        for ends in filter(None, map(self.rig.ends, self.rig.bodies)):
            way = less(*map(self.held_at, ends[::-1]))
            found.append(arrow_length(way) / arrow_length(self.rig.drawn_way(ends)) - 1.0)
        return found

    # rolling

    def outward(self, joint: Joint) -> Arrow:
        """The direction out of the surface on which a body rolls: of a slope, or the z axis of another body."""
        carrier = joint.carrier.owner
        if carrier in self.rig.bodies:
            return times_arrow(self.turned(carrier), Z)
        surface = next((item for item in self.rig.problem.surfaces if item.name == carrier), None)
        if surface is None:
            return Z
        return (self.rig.value(surface.normal.cos()), 0.0, self.rig.value(surface.normal.sin()))

    def lowest(self, joint: Joint) -> Arrow:
        """Where a round body touches the surface below it, from its centre of mass."""
        name, out = joint.body.owner, self.outward(joint)
        radius, third, off = self.round(name)
        if third is None:
            return sum_of(off, scaled(-radius, out))
        if arrow_length(less(out, Z)) > ON_AXIS:
            raise NotConfirmed(f"where `{name}` touches what is not level")
        return self.lowest_of(name)

    def lowest_of(self, name: str, side: float = 1.0) -> Arrow:
        """The lowest point of a round body, or with −1 the highest."""
        radius, third, off = self.round(name)
        return sum_of(off, scaled(side * radius, scaled(-1.0, Z) if third is None else level_part(name, third)))

    def lowest_rate(self, joint: Joint, omega: Arrow, below: Arrow) -> Arrow:
        """How fast it goes along, seen from the centre of mass; `below` is the angular velocity of what is touched."""
        radius, third, off = self.round(joint.body.owner)
        result = crossed(omega, off)
        if third is None:
            return sum_of(result, crossed(below, scaled(-radius, self.outward(joint))))
        turning = crossed(omega, third)  # d/dt of down = −(ẑ − (ẑ·e) e)/√(1 − (ẑ·e)²)
        up, rate, size = third[2], turning[2], (1.0 - third[2] ** 2) ** 0.5
        grown = sum_of(scaled(rate, third), scaled(up, turning))
        shrunk = scaled(-up * rate / size**2, less(Z, scaled(up, third)))
        return sum_of(result, scaled(radius / size, sum_of(grown, shrunk)))

    def round(self, name: str) -> tuple[float, Arrow | None, Arrow]:
        """The radius with which a body rolls, the axis of the circle (none of a ball), and its middle from the centre of mass."""
        body = self.rig.bodies[name]
        rolling = next((item for item in self.rig.joints.values() if item.rolls and item.body.owner == name), None)
        point = None if rolling is None else rolling.body.point
        shape = rolling_shape(body, point)
        radius = rim_radius(body, point) or getattr(shape, "radius", None)
        if radius is None or shape is None:
            raise NotConfirmed(f"with what `{name}` rolls")
        middle = self.arm(PointRef(name, "center") if rolling is None or point is None else rolling.body)
        if shape.spherical:
            return self.rig.value(radius), None, middle
        return self.rig.value(radius), times_arrow(self.turned(name), self.rig.axis(name) or Z), middle


def euler_of(rows: Turned, permuted: Turned) -> tuple[float, float, float]:
    """φ, θ and ψ of a rotation; φ is all of it where the axis is upright."""
    (a, _, c), (d, _, f), (g, h, i) = product_of(rows, rows_back(permuted))
    if math.hypot(c, f) < TINY:
        return math.atan2(d, a), math.atan2(math.hypot(c, f), i), 0.0
    return math.atan2(c, -f), math.atan2(math.hypot(c, f), i), math.atan2(g, h)


def level_part(name: str, third: Arrow) -> Arrow:
    """The unit vector down within a plane square to the axis of a body."""
    down = less(scaled(third[2], third), Z)
    if arrow_length(down) < ON_AXIS:
        raise NotConfirmed(f"`{name}` lies flat there, and touches along its whole rim")
    return normed(down)


def put_third(axis: Arrow) -> Turned:
    """The even permutation of its own axes that puts a body's axis along the third one."""
    way = max(range(3), key=lambda k: inner_product(axis, ALONG[k]))
    return (ALONG[(way + 1) % 3], ALONG[(way + 2) % 3], ALONG[way])
