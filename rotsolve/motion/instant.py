"""Instant: bodies at one moment, as elements see them: points, velocities, accelerations and the letters for them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.core.drive import TURNING
from rotsolve.core.facts import Bend, Motion, signed
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import GENERIC, NEAR, REST, TIME, paths_in
from rotsolve.core.vectors.heading import (
    NOWHERE,
    TURNS,
    Heading,
    Vector,
    cartesian,
    heading,
    opposite,
    unit,
    vector,
)
from rotsolve.elements.shapes import rim_radius
from rotsolve.motion.rigid import locate, polar, rim_centre, rim_ways, tidy
from rotsolve.motion.standing import Standing

if TYPE_CHECKING:
    from rotsolve.language.bodies import Orbit
    from rotsolve.language.problem import PointRef


class Instant(Standing, frozen=True, dict=True):
    """One moment of a configuration, as elements see it: where points are, and how bodies move."""

    def point(self, ref: PointRef) -> Vector:
        """A point of a body from its host's reference point, in space."""
        host, body = self.host(ref.owner), self.body(ref.owner)
        seat, ways, radius = self.configuration.seat(ref.owner, self.state), rim_ways(body), rim_radius(body, ref.point)
        held = ref.point in ways and (ref.owner, ref.point) in self.configuration.marks(self.state)
        if ref.point in ways and radius is not None and not held:
            return self._from_reference(host, seat.place(NOWHERE)) + vector(radius, ways[ref.point])
        return self.mark_of(ref)

    def mark_of(self, ref: PointRef) -> Vector:
        """A point that is fixed to its body, from its host's reference point, in space: of a rim that which was there as drawn."""
        place = self.configuration.seat(ref.owner, self.state).place(locate(self.body(ref.owner), ref))
        return self._from_reference(self.host(ref.owner), place)

    def hub(self, ref: PointRef) -> Vector:
        """The centre of the rim that a point names, from its host's reference point, in space."""
        seat = self.configuration.seat(ref.owner, self.state)
        return self._from_reference(seat.host, seat.place(rim_centre(self.body(ref.owner), ref.point)))

    def pointing(self, name: str, way: Heading) -> Vector:
        """A direction of a body's own axes, in space."""
        seat = self.configuration.seat(name, self.state)
        turned = seat.place(unit(way)) - seat.place(NOWHERE)
        return polar(tidy(turned)).rotated(self.orientation(seat.host))

    def _from_reference(self, name: str, place_in_body: Vector) -> Vector:
        return polar(tidy(place_in_body - self.frame(name).reference)).rotated(self.orientation(name))

    def motion(self, name: str) -> Motion:
        """How a body moves at this moment."""
        return self._motion(self.host(name))

    @remembered
    def _motion(self, name: str) -> Motion:
        """On an axis, along a line, or freely in the plane."""
        configuration, sense = self.configuration, self.sense(name)
        if configuration.pivot(name, self.state) is not None:
            spin, rate = (signed(self.rate(word, name), sense) for word in TURNING[1:])
            own = self.orientation(name)
            round_ = configuration.whirl(name, self.state)
            return Motion("axis", spin=spin, spin_rate=rate, sense=sense, turns=True, orientation=own, whirl=round_)
        line, orbit = self.line(name), self.orbit(name)
        turns = configuration.can_turn(name, self.state)
        spin, rate = (signed(self.rate(word, name), sense) if turns else ZERO for word in TURNING[1:])
        if line is not None:
            direction, words = line
            velocity = vector(self.travel("velocity", name, words), direction)
            acceleration = vector(self.travel("acceleration", name, words), direction)
            bend = self.bend(orbit) if orbit is not None else None
            if bend is not None:  # v²/r towards the centre
                square = self.travel("velocity", name, words) ** 2
                acceleration = acceleration + vector(square / bend.radius, bend.outward.turned(180))
            own = self.orientation(name)
            return Motion("line", velocity, acceleration, spin, rate, sense, turns, direction, own, bend=bend)
        velocity = cartesian(*(self.component("velocity", name, axis) for axis in "xy"))
        acceleration = cartesian(*(self.component("acceleration", name, axis) for axis in "xy"))
        return Motion("plane", velocity, acceleration, spin, rate, sense, turns, None, self.orientation(name))

    def bend(self, orbit: Orbit) -> Bend | None:
        """The circle of a body's centre at this moment; None on a track of which only heights are known."""
        return Bend(orbit.radius, heading(self.place_on(orbit))) if orbit.radius is not None else None

    def velocity(self, ref: PointRef) -> Vector:
        """Velocity of a point; at rest for the ground."""
        if ref.owner not in self.configuration.bodies:
            return NOWHERE
        return self.motion(ref.owner).velocity_of(self.point(ref))

    def velocity_at(self, host: str, place: Vector) -> Vector:
        """Velocity of a place in the axes of a body that stands for itself."""
        return self.motion(host).velocity_of(self._from_reference(host, place))

    def acceleration(self, ref: PointRef) -> Vector:
        if ref.owner not in self.configuration.bodies:
            return NOWHERE
        return self.motion(ref.owner).acceleration_of(self.point(ref))

    def outward(self, rider: str) -> Formula:
        """Speed along the body on which it slides, away from the axis; a rider that is held has none."""
        ride = self.configuration.ride(rider, self.state)
        if ride is None or not ride.free:
            return ZERO
        return self.ask("velocity", rider, when=self.moving, component="radial", words=("outwards", "inwards"))

    def time(self) -> Formula:
        """The running time at this moment: the letter `time` in the midst of a phase."""
        return Symbol("time") if self.generic else self.ask("time", "")

    def now(self, value: Formula) -> Formula:
        """A value that varies, in the letters of this moment for `time` and for paths of bodies."""
        if not value.symbols():
            return value
        letters = {name: self.spoken_of(word, owner) for name, owner, word in paths_in(value)}
        return value.substitute({**letters, TIME: self.time()})

    def spoken_of(self, word: str, name: str) -> Formula:
        """Place or rate of a body, which may be part of another, as the scene speaks of it."""
        host = self.host(name)
        if word == "angle":
            return self.angle_of(name)
        if host == name:
            return self.variable(word, name)
        letter = self.variable(word, host)
        if word in ("rotation", "angular_velocity"):
            return self.as_counted(letter, name)
        return self.as_travelled(letter, name)

    def variable(self, word: str, name: str) -> Formula:
        """Place or rate of a body, along its declared sense; even at a moment of a motion only thought of, the real rate."""
        match word:
            case "angle":
                return self.ask("angle", name, words=TURNS)
            case "angular_velocity":
                return self.ask(word, name, when=self.when, words=self.turn_words(name))
            case "velocity":
                return self.ask(word, name, when=self.when, words=self.line_words(name))
            case _:
                return self.since_first(word, name)

    def since_first(self, word: str, name: str) -> Formula:
        """Rotation or displacement since the first state: the sum over the phases gone by; in the midst of a phase a running letter; near
        an equilibrium also how far that is from its state, where it is worked out, and how far it is displaced from there."""
        words = self.turn_words(name) if word == "rotation" else self.line_words(name)
        timeline = self.configuration.timeline
        if self.generic and self.mark in (REST, NEAR):
            moments = [] if self.in_balance else [REST + self.state]
            moments += [self.when] if self.mark == NEAR else []
            gone = (self.ask(word, name, when=when, words=words) for when in moments)
            return sum(gone, start=replace(self, generic=False).since_first(word, name))
        if self.generic:
            return self.ask(word, name, when=GENERIC + timeline.states[0].name, words=words)
        result: Formula = ZERO
        for interval in timeline.between(timeline.states[0].name, self.state):
            if interval.event is None:
                result = result + self.ask(word, name, when=interval.name, words=words)
        return result

    def line_words(self, name: str) -> tuple[str, str]:
        """The words for the two senses in which a body travels along its line."""
        line = self.line(name)
        return (line[1], opposite(line[1])) if line else ("", "")
