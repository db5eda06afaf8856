"""Rig: a scene in space in numbers: its solids, what holds them, and what a state tells of them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from functools import cached_property
from typing import Any

from msgspec.structs import replace

from rotsolve.algebra.formula import ONE, Formula, formula
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.jet import Jet
from rotsolve.confirm.numbers import value_of
from rotsolve.confirm.space.arrows import (
    ALONG,
    STILL,
    Arrow,
    Turned,
    arrow_length,
    crossed,
    less,
    normed,
    product_of,
    rotation_about,
    rows_back,
)
from rotsolve.confirm.space.masses import (
    Solid,
    about_point,
    axis_told,
    is_symmetric,
    matrix,
    solid_of,
    spot_in_body,
    total_rows,
)
from rotsolve.confirm.space.principal import moments_and_axes
from rotsolve.core.symbols import TIME
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.language.joints import joints_at
from rotsolve.language.problem import ANY_TIME, Condition, Problem, State

AXES = ("x", "y", "z")
NODAL = ("precession_angle", "tilt", "spin_angle", "precession", "nutation", "spin", "axial_rate")
ANGLES, RATES = NODAL[:3], NODAL[3:6]
TOLD_RATES = ("angular_velocity", "velocity", "nutation")  # of which what is kept on the way tells the squares
ROUND_MOMENTUM = {"precession", "spin"}  # which a free body has about its angular momentum where no tilt is told
TRAVEL = ("position", "velocity", "acceleration")
THIN = 1e-12  # of the largest moment of inertia: none
NOW = 0.37  # seconds: the time at which what is a formula of time is looked at, where no state tells another
Told = Mapping[tuple[str, str, str], float]  # (state, body, quantity): answers that are put in for what no line tells


class Rig:
    """The bodies and joints of a problem at one set of numbers for its letters, with the joints that events up to a state have brought."""

    def __init__(self, problem: Problem, numbers: Mapping[str, float], state: str = "") -> None:
        self.problem = problem
        self.numbers: dict[str, Any] = {TIME: NOW, **numbers}
        self.bodies = {body.name: body for body in problem.bodies}
        self.seats: dict[
            str, Turned
        ] = {}  # how bodies that an event has joined to others are turned along the axes of these
        self._solids: dict[str, Solid] = {}
        self._idle: dict[str, list[Arrow]] = {}
        self.joints = {joint.owner: self.about_line(joint) for joint in joints_at(problem, state)}
        others = (item for item in problem.connections if item.motor_in_space() is None)
        tied = (item.coupling_in_space() for item in problem.connections)
        self.couplings = {item.owner: item for item in tied if item is not None}
        unknown = [item for item in others if item.name not in {*self.joints, *self.couplings}]
        if unknown:
            raise NotConfirmed(f"`{unknown[0].name}`: what a `{unknown[0].word}` does in space")

    def about_line(self, joint: Joint) -> Joint:
        """A joint that holds two points as a hinge along the line through both."""
        if joint.through is None:
            return joint
        x, y, z = (formula(Fraction(part)) for part in less(self.spot(joint.through), self.spot(joint.body)))
        return replace(joint, turning=((x, y, z),))

    # numbers

    def value(self, formula: Formula) -> float:
        return float(value_of(formula, self.numbers))

    def over_time(self, formula: Formula) -> tuple[float, float, float]:
        """A formula of time, its rate and the rate of that."""
        found = value_of(formula, {**self.numbers, TIME: Jet(self.numbers[TIME], 1.0)})
        return (found.value, found.rate, found.bend) if isinstance(found, Jet) else (float(found), 0.0, 0.0)

    def arrow(self, parts: tuple[Formula, ...]) -> Arrow:
        x, y, z = (self.value(part) for part in parts)
        return (x, y, z)

    @cached_property
    def gravity(self) -> float:
        return 0.0 if self.problem.gravity is None else self.value(self.problem.gravity)

    @cached_property
    def about_momentum(self) -> frozenset[str]:
        """The bodies that nothing holds and of which the states tell no more than the rates about their angular momentum."""
        words: dict[str, set[str]] = {}
        for path in (line.path for state in self.problem.states for line in state.conditions):
            if path is not None and path.quantity in NODAL:
                words.setdefault(path.owner, set()).add(path.quantity)
        held = {joint.body.owner for joint in self.joints.values()}
        steady = any(state.steady for state in self.problem.states)
        return frozenset(
            name for name, told in words.items() if not steady and name not in held and told <= ROUND_MOMENTUM
        )

    # bodies

    def solid(self, name: str) -> Solid:
        if name not in self._solids:
            self._solids[name] = solid_of(self.bodies[name], self.value)
        return self._solids[name]

    def idle(self, name: str) -> list[Arrow]:
        """The own directions of a body about which it has no inertia, so that nothing tells how it turns about them: a thin rod's; of
        what is held at rest at a point, those through that; of what turns with another body, as clamped to it, none; of a bar between two
        balls or collars that through both.
        """
        if name not in self._idle and self.turns_with_another(name):
            self._idle[name] = []
        if name not in self._idle and self.ends(name):
            self._idle[name] = [normed(self.drawn_way(self.ends(name)))]
        if name not in self._idle:
            own, joint = self.solid(name), self.on_ground(name)
            arm = STILL if joint is None else less(own.centre, self.spot(joint.body))
            found = moments_and_axes(total_rows(own.tensor, about_point(own.mass, arm)))
            self._idle[name] = [way for moment, way in found if moment <= THIN * found[-1][0]]
        return self._idle[name]

    def turns_with_another(self, name: str) -> bool:
        """Whether a joint between two bodies, unless it is a ball, ties how a body turns to how the other one does; not of what is led."""
        for joint in self.joints.values():
            pair = {joint.body.owner, joint.carrier.owner}
            tied = name in pair and pair <= self.bodies.keys() and not (joint.free or touching(joint))
            if tied and not any(self.bodies[one].moved for one in pair):
                return True
        return False

    def spot(self, ref: PointRef) -> Arrow:
        """Where a point is in the axes of its body, from the centre."""
        body = self.bodies[ref.owner]
        return spot_in_body(body, ref.point, self.value, ref.argument)

    def axis(self, name: str) -> Arrow | None:
        """The axis of a body: as the scene tells it, else one about which it is symmetric."""
        body = self.bodies[name]
        told = axis_told(body, self.value)
        if told is not None:
            return told
        found = [way for way in (2, 0, 1) if self.symmetric(name, way)]
        own = self.solid(name)
        if own.whole and not any(map(any, own.tensor)):  # of what has no inertia it is the axis of its shape
            form = matrix(shape_of(body).tensor(ONE), self.value)
            found = [way for way in found if is_symmetric(form, STILL, way)] or found
        return ALONG[found[0]] if found else None

    def symmetric(self, name: str, way: int) -> bool:
        own = self.solid(name)
        return not own.whole or is_symmetric(own.tensor, own.centre, way)

    def leans_round(self, joint: Joint) -> bool:
        """Whether the mass of a body, or of what it carries, lies otherwise once it has turned by a right angle about its joint's axis."""
        carried = (item for item in self.joints.values() if item.carrier.owner == joint.body.owner)
        if any(not self.round_line(joint, item) for item in carried):
            return True
        own, way = self.solid(joint.body.owner), way_along(self, joint.turning[0])
        arm, turn = less(own.centre, self.spot(joint.body)), rotation_about(way, math.pi / 2)
        rows = total_rows(own.tensor, about_point(own.mass, arm))
        turned = product_of(product_of(turn, rows), rows_back(turn))
        size = max(abs(part) for row in rows for part in row) or 1.0
        off = arrow_length(crossed(way, arm))
        gaps = [abs(a - b) for one, other in zip(rows, turned, strict=True) for a, b in zip(one, other, strict=True)]
        return max(gaps) > 1e-9 * size or off > 1e-9 * (1.0 + arrow_length(arm))

    def round_line(self, joint: Joint, carried: Joint) -> bool:
        """Whether what is carried is a wheel about the line on which its carrier is hinged."""
        if not carried.aligned or self.axis(carried.body.owner) is None:
            return False
        way, off = way_along(self, joint.turning[0]), less(self.spot(carried.carrier), self.spot(joint.body))
        across = crossed(way_along(self, carried.turning[0]), way), crossed(off, way)
        return all(arrow_length(part) <= 1e-9 * (1.0 + arrow_length(off)) for part in across)

    def main(self, name: str) -> Joint | None:
        """The joint that tells how a body is turned: the first that holds a point of it, not one on which it only rolls."""
        own = (joint for joint in self.joints.values() if joint.body.owner == name and not touching(joint))
        return next(own, None)

    def line(self, name: str) -> Arrow | None:
        """The direction through the two points of a body that balls hold, in its own axes; None where there are not two."""
        balls = [joint for joint in self.joints.values() if joint.body.owner == name and joint.free]
        grounded = [self.bodies.get(joint.carrier.owner) is None and not joint.sliding for joint in balls]
        return normed(self.drawn_way(balls)) if grounded == [True, True] else None

    def ends(self, name: str) -> list[Joint]:
        """The two balls or collars between which a bar is held that closes a linkage; none of other bodies."""
        found = [joint for joint in self.joints.values() if joint.body.owner == name and joint.free]
        return found if len(found) == 2 and self.line(name) is None else []

    def drawn_way(self, joints: list[Joint]) -> Arrow:
        """The way between the points of a body that two joints hold, in its own axes."""
        return less(self.spot(joints[1].body), self.spot(joints[0].body))

    def carrier(self, name: str) -> str:
        """The body that carries another; '' for what the ground holds, or nothing."""
        joint = self.main(name)
        return joint.carrier.owner if joint is not None and joint.carrier.owner in self.bodies else ""

    def on_ground(self, name: str) -> Joint | None:
        """The joint that holds a point of a body at rest."""
        joint = self.main(name)
        return joint if joint is not None and joint.carrier.owner not in self.bodies and not joint.sliding else None

    def on_unturned(self, name: str) -> Joint | None:
        """The joint that holds a point of a body at rest, or one of what is led along and does not turn."""
        joint = self.main(name)
        led = joint is not None and not joint.sliding and self.led_evenly(joint.carrier.owner)
        return joint if led else self.on_ground(name)

    def led_evenly(self, name: str) -> bool:
        """Whether a body is led along, with an acceleration that stays, and does not turn."""
        body = self.bodies.get(name)
        if body is None or not body.moved or self.main(name) is not None:
            return False
        evenly = all(kind in TRAVEL and TIME not in part.symbols() for kind, _, part in body.moved)
        return evenly and all(joint.body.owner != name for joint in self.joints.values())

    def led(self, name: str, kinds: tuple[str, str, str]) -> tuple[Arrow | None, Arrow] | None:
        """A prescribed rate and its own rate, by whichever of a place, its rate and the rate of that the scene prescribes."""
        parts = {(kind, axis): part for kind, axis, part in self.bodies[name].moved}
        rate: Arrow | None = None
        second: Arrow | None = None
        for back, kind in enumerate(kinds):
            found = [parts.get((kind, axis)) for axis in AXES]
            if any(part is not None for part in found):
                curves = [(0.0, 0.0, 0.0) if part is None else self.over_time(part) for part in found]
                columns = [(column[0], column[1], column[2]) for column in zip(*curves, strict=True)]
                rate, second = (columns[1 - back] if back < 2 else rate), columns[2 - back]
        return None if second is None else (rate, second)


class Lines:
    """What a state tells, and the answers that are put in for what it does not."""

    def __init__(self, rig: Rig, state: State | None, told: Told) -> None:
        self.rig, self.state = rig, state
        self.name = "" if state is None else state.name
        self.put = told
        self.lines: list[Condition] = (
            [] if state is None else [line for line in state.conditions if line.path is not None]
        )
        self.nodding: set[str] = set()  # bodies that are spoken of by their tilt, beside those of its lines
        self.steady = state is not None and state.steady
        self.balance = state is not None and state.balance

    @cached_property
    def later(self) -> bool:
        """Whether time has passed since the first state, at which all stands as it is drawn: through a blow none does."""
        names, name = [state.name for state in self.rig.problem.states], self.name
        before = {event.to: event.from_ or "" for event in self.rig.problem.events}
        while name in before:
            name = before[name]
        return name in (*names[1:], ANY_TIME)

    def line(self, owner: str, word: str, component: str = "", point: str | None = None) -> Condition | None:
        for line in self.lines:
            path = line.path
            if path is not None and (path.owner, path.quantity, path.component or "", path.point) == (
                owner,
                word,
                component,
                point,
            ):
                return line
        return None

    def of(self, owner: str) -> list[Condition]:
        """The lines about a body or an element."""
        return [line for line in self.lines if line.path is not None and line.path.owner == owner]

    def told(self, owner: str, word: str) -> float | None:
        """The number of a quantity of a body or a joint at this state."""
        line = self.line(owner, word)
        if line is not None and line.value is not None:
            return self.rig.value(line.value)
        return self.put.get((self.name, owner, word))

    def arrow_told(self, owner: str, word: str, point: str | None = None) -> tuple[Arrow, str, str] | None:
        """The components of a vector, the name of their axes, and to what they are relative."""
        lines = [self.line(owner, word, axis, point) for axis in AXES]
        found = [line for line in lines if line is not None]
        if not found:
            return None
        x, y, z = (0.0 if line is None or line.value is None else self.rig.value(line.value) for line in lines)
        return (x, y, z), found[0].axes, found[0].relative

    def rests(self, owner: str) -> bool:
        if self.balance:
            return True
        conditions = () if self.state is None else self.state.conditions
        return any(line.rest and line.owner in ("", "all", owner) for line in conditions)

    def nods(self, name: str) -> bool:
        """Whether the state speaks of a body's tilt, precession or spin."""
        spoken = any(line.path is not None and line.path.quantity in NODAL for line in self.of(name))
        return name in self.nodding or (spoken and name not in self.rig.about_momentum)


def touching(joint: Joint) -> bool:
    """Whether a joint lets a body touch a surface without holding a point of it."""
    return joint.rolls or joint.flat


def way_along(rig: Rig, parts: tuple[Formula, ...]) -> Arrow:
    """A unit vector."""
    return normed(rig.arrow(parts))


def is_told_rate(line: Condition) -> bool:
    """Whether a line tells a rate of which what is kept on the way tells the square alone."""
    return line.path is not None and line.path.quantity in TOLD_RATES
