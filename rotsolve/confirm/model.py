"""Model: a scene as read, in numbers, at one of its states: bodies with coordinates, and all that holds and pushes them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cached_property
from itertools import permutations
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import (
    Mass,
    Rigid,
    Rocker,
    Spot,
    as_one,
    is_round,
    on_rim,
    part_of,
    radius_of,
    rigid,
    rocker,
    side_of,
    spot_of,
)
from rotsolve.confirm.inforce import InForce
from rotsolve.confirm.jet import Jet
from rotsolve.confirm.numbers import value_of
from rotsolve.confirm.pose import PER_BODY, Pair, Pose, Seat, StringPart, Way, along
from rotsolve.confirm.signs import carrier_of, carriers, grounded, line, sense
from rotsolve.elements.asked import is_drapes, is_touch
from rotsolve.elements.connections.supports import Axle, Hinge, Shaft
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import Body, PointRef
from rotsolve.language.problem import Problem

if TYPE_CHECKING:
    from rotsolve.elements.connections.strings import String
    from rotsolve.elements.connections.touch import Touch


class Model:
    """What acts at a state (and in the phase that it starts), with numbers for all letters of the scene.

    `problem` is one with letters for what the scene leaves out; `values` has a number for each of them.
    """

    def __init__(self, problem: Problem, values: Mapping[str, float], state: str = "") -> None:
        self.problem = problem
        self.letters: dict[str, Any] = {**problem.values, **values}
        self.acting = InForce(problem, state)
        self.surfaces = {surface.name: surface for surface in problem.surfaces}
        free = {ride.rider.owner for item in problem.connections if (ride := item.ride()) is not None and ride.free}
        bodies = [as_one(body, body.name in free) for body in self.acting.bodies.values()]
        self.seats = {body.name: Seat(self._rigid(body), PER_BODY * k) for k, body in enumerate(bodies)}
        self.size = PER_BODY * len(self.seats)
        self.gravity = (
            self.value(problem.gravity) if problem.gravity is not None and problem.plane == "vertical" else 0.0
        )
        self.upright = self.gravity != 0.0
        self.held = grounded(self)
        self._lines: dict[str, Way | None] = {}
        self._senses: dict[str, int] = {}
        self._legs: dict[str, list[StringPart]] = {}
        self._spots: dict[PointRef, Spot] = {}

    def _rigid(self, body: Body) -> Rigid:
        """Its mass, where that is and how it resists a turn; nothing of what has been taken away."""
        found = rigid(body, self.value)
        return replace(found, mass=0.0, inertia=0.0) if body.name in self.acting.gone else found

    def value(self, formula: Formula) -> float:
        """The number of a formula of givens."""
        return float(value_of(formula, self.letters))

    def running(self, formula: Formula, pose: Pose) -> Jet | float:
        """A value that may vary with `time` and with paths of bodies, at an instant."""
        spoken = [name for name in formula.symbols() if "." in name]
        letters = {**self.letters, "time": pose.time}
        for name in spoken:
            letters[name] = self.path(name, pose)
        found: Jet | float = value_of(formula, letters)
        return found

    def now(self, formula: Formula, pose: Pose) -> float:
        found = self.running(formula, pose) if formula.symbols() else value_of(formula, self.letters)
        return found.value if isinstance(found, Jet) else float(found)

    def path(self, name: str, pose: Pose) -> Jet | float:
        """What `wheel.rotation` within a value stands for: along the positive sense; rotation and displacement since the first state."""
        owner, _, word = name.rpartition(".")
        seat, sign = self.seats[owner], self.sense(owner)
        if word == "angle":
            return pose.turn(owner) + self.lean(owner)
        if word == "rotation":
            return (pose.turn(owner) - pose.origin[seat.turn]) * float(sign)
        if word == "angular_velocity":
            return sign * pose.speed[seat.turn]
        way = self.line(owner) or (1.0, 0.0)
        gone = along(pose.moved(owner, self.travelling(owner)), way)
        if word in ("velocity", "displacement"):
            return gone.rate if word == "velocity" else gone
        raise NotConfirmed(f"a value that varies with `{name}`")

    def body(self, name: str) -> Body:
        return self.acting.bodies[name]

    def line(self, name: str) -> Way | None:
        """The positive direction of a body's travel; None where it is free, or turns about an axis."""
        if name not in self._lines:
            self._lines[name] = self._led(name, None if name in self.diverted else line(name, self))
        return self._lines[name]

    def _led(self, name: str, own: Way | None) -> Way | None:
        """A line of travel, along the surface on which something lies that is joined to the body."""
        lying = {item.lying() for item in self.acting.connections if is_touch(item)}
        if own is None or name in lying:
            return own
        ways = (line(other, self) for other in self.joined_to(name) if other in lying)
        led = next((way for way in ways if way is not None), own)
        return led if led[0] * own[0] + led[1] * own[1] >= 0 else (-led[0], -led[1])

    def way(self, name: str) -> Way | None:
        """The line along which a body travels: its own, else that of what it is joined to, where that does not turn."""
        group = self.joined_to(name)
        if self.line(name) is not None or any(self.turns(other) for other in group):
            return self.line(name)
        return next((way for other in group if (way := self.line(other)) is not None), None)

    def turns(self, name: str) -> bool:
        """Whether a body on a line turns: a round one, or one that is said to."""
        body = self.body(name)
        return body.turns is not None or radius_of(body, None, self.value) is not None or self.rocking(name) is not None

    def joined_to(self, name: str) -> tuple[str, ...]:
        """A body and all that are one with it."""
        group = [name]
        for own in group:
            for pair in self.unions:
                group += [other for other in pair if own in pair and other not in group]
        return tuple(group)

    def sense(self, name: str) -> int:
        """+1 where a body's positive turn is counterclockwise."""
        if name not in self._senses:
            self._senses[name] = sense(name, self)
        return self._senses[name]

    def legs(self, item: String) -> list[StringPart]:
        from rotsolve.confirm.routing import legs

        if item.name not in self._legs:
            self._legs[item.name] = legs(item, self)
        return self._legs[item.name]

    @cached_property
    def whirled(self) -> dict[str, float]:
        """The angular velocity of the upright shaft with which a body goes round: each piece at x has the speed ω x across the picture."""
        if not any(isinstance(item, Shaft) for item in self.acting.connections):
            return {}
        from rotsolve.confirm.carried import whirled

        return whirled(self)

    @cached_property
    def masses(self) -> list[float]:
        """The mass or moment of inertia of each coordinate."""
        return [part for seat in self.seats.values() for part in (seat.rigid.mass, seat.rigid.mass, seat.rigid.inertia)]

    def place(self, ref: PointRef, pose: Pose) -> Pair:
        """Where a point is just now: the rim on the right of a wheel, its top and bottom are those in space."""
        side = side_of(self.body(ref.owner), ref.point)
        if side is not None and (ref.owner, ref.point) in self.marks:
            return pose.place(ref.owner, self.drawn(ref))
        if side is not None:
            radius = radius_of(self.body(ref.owner), ref.point, self.value) or 0.0
            return pose.place(ref.owner, pose.spatial(ref.owner, (0.0, 0.0), (radius * side[0], radius * side[1])))
        return pose.place(ref.owner, self.spot(ref))

    def travelling(self, name: str) -> Spot:
        """The point of a body whose travel its `velocity` is: its centre of mass, of a wheel on a surface its centre."""
        hub = self.rolling(name)
        return self.seats[name].rigid.centre if hub is None else self.spot(hub)

    def rolling(self, name: str) -> PointRef | None:
        """The centre of the rim on which a body lies: that of a part that is named, else its own."""
        body = self.body(name)
        for item in self.acting.connections:
            if item.lying() == name and (
                is_round(body) or (is_touch(item) and (on_rim(body, item.pair()[0].point) or self.rocking(name, item)))
            ):
                part = is_touch(item) and part_of(body, item.pair()[0].point) is not None
                return PointRef(name, item.pair()[0].point if part else None)
        return None

    def rocking(self, name: str, on: Touch | None = None) -> Rocker | None:
        """The round side with which a body lies on something, or on that alone which a contact names."""
        for item in self.acting.connections if on is None else (on,):
            if is_touch(item) and item.lying() == name:
                found = rocker(self.body(name), item.pair()[0].point, self.value)
                if found is not None:
                    return found
        return None

    def tied(self, ref: PointRef) -> Spot:
        """Where what is tied to a body, or lies under it, meets it: a named point as drawn, else its middle."""
        return self.drawn(self.middle(ref))

    def middle(self, ref: PointRef) -> PointRef:
        """The point that a body named alone stands for: its centre; without one, or put together of parts, its centre of mass.

        A particle is where its mass is: what slides on another body is seated at the axis of that.
        """
        body, shape = self.body(ref.owner), shape_of(self.body(ref.owner))
        whole = not (body.parts or body.holes or shape.pointlike)
        centred = is_round(body) or (whole and "center" in shape.points)
        return ref if ref.point is not None or centred else PointRef(ref.owner, "cm")

    def meeting(self, ref: PointRef, turn: float) -> Spot:
        """Where a body that is turned so far is hit: a named point, that of a rim as it is in space, else its centre."""
        side = side_of(self.body(ref.owner), ref.point)
        if side is None or (ref.owner, ref.point) in self.marks:
            return self.drawn(ref)
        radius, c, s = radius_of(self.body(ref.owner), ref.point, self.value) or 0.0, math.cos(turn), math.sin(turn)
        return radius * (c * side[0] + s * side[1]), radius * (c * side[1] - s * side[0])

    @cached_property
    def hung(self) -> frozenset[str]:
        """Ropes, whose weight what they hang over tells, part by part; several riders, whose weights balance."""
        ropes = {item.drapes[0].owner for item in self.acting.connections if is_drapes(item)}
        riders = (
            ride.rider.owner for item in self.acting.connections if (ride := item.ride()) is not None and ride.free
        )
        return frozenset(ropes | {name for name in riders if self.body(name).count > 1})

    @cached_property
    def carriers(self) -> dict[str, str]:
        """What carries each body that a hinge or an axle hangs from another one."""
        return carriers(self)

    @cached_property
    def guided(self) -> tuple[str, ...]:
        """Bodies that travel along a line without a surface that would lead them, and are not joined to what goes another way."""
        touching = {item.lying() for item in self.acting.connections if is_touch(item)}
        lying = {other for name in touching if name in self.seats for other in self.joined_to(name)} | self.hung
        free = {name for name in self.seats if self.line(name) is not None and name not in lying}
        for name in filter(self.turns, free):
            whole, centre = self.welded_mass(name), self.seats[name].rigid.centre
            if math.hypot(whole.x - whole.whole * centre[0], whole.y - whole.whole * centre[1]) > 1e-9 * whole.whole:
                raise NotConfirmed(f"nothing but its word keeps `{name}`, with what is welded to it, on its line")
        return tuple(name for name in self.seats if name in free)

    @cached_property
    def marks(self) -> frozenset[tuple[str, str | None]]:
        """Points of rims that a hinge holds, which turn with the body as other points do."""
        held = [ref for item in self.acting.connections for ref in (*item.joint(), *item.fixed_points())]
        return frozenset((ref.owner, ref.point) for ref in held)

    @cached_property
    def diverted(self) -> frozenset[str]:
        """Bodies that no line leads since an event has joined them to one that goes another way, or to a place that goes round in one.

        The ground goes on bearing what travels on the level."""
        lying = {item.lying() for item in self.acting.connections}
        found: set[str] = set()
        for event in self.acting.joined():
            for ref, other in permutations(event.joined(), 2):
                aside = math.hypot(*self.drawn(other)) > 0.0
                if ref.owner not in lying and other.owner in lying and self.turns(other.owner) and aside:
                    found.add(ref.owner)
        for pair in self.met:
            one, two = (line(name, self) for name in pair)
            if one is None or two is None or abs(one[0] * two[1] - one[1] * two[0]) > 1e-9:
                found |= set() if lying & set(pair) else set(pair) - self._borne(pair)
        return frozenset(found)

    def _borne(self, pair: tuple[str, str]) -> set[str]:
        """The one of two that do not turn which travels on the level, where the ground bears it and what has fallen on it."""
        if not self.upright or any(name in self.held or self.turns(name) for name in pair):
            return set()
        level = {name for name in pair if (way := line(name, self)) is not None and not way[1]}
        return level if len(level) == 1 else set()

    @property
    def met(self) -> list[tuple[str, str]]:
        """The pairs of bodies that events have made one."""
        return [(event.joined()[0].owner, event.joined()[1].owner) for event in self.acting.joined()]

    @cached_property
    def unions(self) -> list[tuple[str, str]]:
        """The pairs of bodies that are one: welded, or joined by an event."""
        welds = [item.joined() for item in self.acting.connections]
        return [(pair[0].owner, pair[1].owner) for pair in welds if pair] + self.met

    def bodily(self, refs: tuple[PointRef, ...]) -> bool:
        """Whether bodies meet as wholes, on an axis that they share or along a line, so that no points need to coincide."""
        return any(ref.point is None for ref in refs)

    def told_apart(self, first: str, second: str) -> float | None:
        """By how much a welded body is turned against the other: nothing, unless they are rods and a state gives the angles of both."""
        if not (shape_of(self.body(first)).slender and shape_of(self.body(second)).slender):
            return None
        for state in self.acting.states:
            angles = {
                line.path.owner: self.value(line.value)
                for line in state.conditions
                if line.path is not None
                and line.path.quantity == "angle"
                and line.value is not None
                and line.path.owner in (first, second)
            }
            if len(angles) == 2:
                return angles[second] - angles[first]
        return None

    def lean(self, name: str) -> float:
        """What a body's `angle` is beyond its turn: that of a rod is its direction, of another body that hangs, or rolls out of balance,
        that from its hinge or its centre to the centre of mass of all that is welded to it."""
        body, pivot = self.body(name), self.pivot(name) or self.rolling(name)
        if shape_of(body).slender or pivot is None:
            return 0.0
        whole, centre = self.welded_mass(name), self.drawn(pivot)
        if whole.whole == 0.0:
            return 0.0
        x, y = whole.x / whole.whole - centre[0], whole.y / whole.whole - centre[1]
        return math.atan2(y, x) if math.hypot(x, y) > 1e-12 else 0.0

    def welded_mass(self, name: str, beside: frozenset[str] = frozenset()) -> Mass:
        """The mass of a body and of all that is welded to it, in its own axes; `beside` are those that are counted already."""
        rigid = self.seats[name].rigid
        total = Mass(rigid.mass, rigid.mass * rigid.centre[0], rigid.mass * rigid.centre[1], 0.0)
        beside = beside | {name}
        for item in self.acting.connections:
            for own, other in permutations(item.joined(), 2):
                if own.owner == name and other.owner not in beside:
                    turn = self.told_apart(name, other.owner) or 0.0
                    (x, y), (u, w) = self.drawn(own), self.drawn(other)
                    c, s = math.cos(turn), math.sin(turn)
                    shift = x - c * u + s * w, y - s * u - c * w
                    total = total.plus(self.welded_mass(other.owner, beside).moved(shift, turn))
        return total

    def pivot(self, name: str) -> PointRef | None:
        """The point of a body that a hinge or axle holds."""
        if name in self.held:
            return self.held[name][1]
        joints = [item.hinge[-1] for item in self.acting.connections if isinstance(item, Hinge)]
        axles = [(item, carrier_of(item, self)) for item in self.acting.connections if isinstance(item, Axle)]
        joints += [ref for item, mount in axles if mount is not None for ref in item.axle if ref != mount]
        return next((ref for ref in joints if ref.owner == name), None)

    def axis(self, name: str) -> Spot:
        """Where a body's axis is in its own axes; its centre of mass where nothing holds it."""
        return self.drawn(self.held[name][1]) if name in self.held else self.seats[name].rigid.centre

    def axis_of(self, ref: PointRef) -> PointRef:
        """The point of a body at its axis; its centre where nothing holds it."""
        return self.held[ref.owner][1] if ref.owner in self.held else PointRef(ref.owner)

    def spot(self, ref: PointRef) -> Spot:
        """Where a point is in its body's axes; the centre, for the rim of a wheel, its top and its bottom."""
        found = self._spots.get(ref)
        if found is None:
            found = self._spots[ref] = spot_of(self.seats[ref.owner].rigid, ref.point, ref.argument, self.value)
        return found

    def drawn(self, ref: PointRef) -> Spot:
        """Where a point is in its body's axes, that of a rim as drawn: the mark that something holds there."""
        side = side_of(self.body(ref.owner), ref.point)
        if side is None:
            return self.spot(ref)
        radius = radius_of(self.body(ref.owner), ref.point, self.value) or 0.0
        return radius * side[0], radius * side[1]
