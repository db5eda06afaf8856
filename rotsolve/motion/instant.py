"""Instant: bodies at one moment, as elements see them: points, velocities, accelerations and the letters for them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING

from msgspec import Struct, field

from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.core.drive import TRAVELLING, TURNING, Drive
from rotsolve.core.facts import Bend, Motion, signed
from rotsolve.core.quantity import PLANE, QUANTITIES
from rotsolve.core.registry import Registry, SceneQuantity
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import COURSE, GENERIC, TIME, VIRTUAL, paths_in, rub_key
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, TURNS, Heading, Vector, cartesian, heading, opposite, vector
from rotsolve.elements.shapes import rim_radius, shape_of
from rotsolve.language.keys import varying_values
from rotsolve.language.shape import WHEEL
from rotsolve.motion.rigid import ON_RIM, Frame, direction_of, locate, polar, tidy

if TYPE_CHECKING:
    from rotsolve.language.bodies import Orbit
    from rotsolve.language.problem import Body, PointRef
    from rotsolve.motion.configuration import Configuration


STILL = (None, "cm", *WHEEL)  # points that do not turn with a body
FOLLOWED = ("position", "velocity", "acceleration")


class Instant(Struct, frozen=True, dict=True):
    """One moment of a configuration; `generic` is a moment in the midst of the phase that starts at `state`, or with another `mark`
    the equilibrium of its bodies or a moment of their swings about it.

    `modes` says which contacts slip in the phase that starts at a state, by "contact@state": "slips" along the positive travel,
    "slips back" against it. A `virtual`
    moment has the positions and accelerations of its state, but velocities of its own: any small motion that the rules allow.
    """

    configuration: Configuration
    registry: Registry
    state: str
    generic: bool = False
    modes: Mapping[str, str] = field(default_factory=dict)
    virtual: bool = False
    mark: str = GENERIC

    @cached_property
    def when(self) -> str:
        return self.mark + self.state if self.generic else self.state

    @property
    def moving(self) -> str:
        """When the velocities are."""
        return VIRTUAL + self.when if self.virtual else self.when

    def mode(self, contact: str) -> str:
        return self.modes.get(rub_key(contact, self.configuration.phase_start(self.state)), "sticks")

    def span(self, name: str) -> str:
        """Where forces and accelerations of a body belong: to its phase while they are constant, else to this moment."""
        own = self.configuration.span(name, self.state)
        return self.when if self.generic and own == self.state else own

    def body(self, name: str) -> Body:
        return self.configuration.body(name, self.state)

    def host(self, name: str) -> str:
        return self.configuration.host(name, self.state)

    def frame(self, name: str) -> Frame:
        return self.configuration.frame(name, self.state)

    def weightless(self, name: str) -> bool:
        """Whether a body has no inertia against turning."""
        return all(piece.moment == ZERO for piece in self.frame(name).pieces)

    def centre_of_mass(self, name: str) -> Vector:
        """From the reference of a body, while that stands as drawn."""
        return self.frame(name).cm

    def ask(
        self,
        word: str,
        owner: str,
        *,
        when: str | None = None,
        component: str = "",
        words: tuple[str, str] = ("", ""),
        letter: str = "",
    ) -> Formula:
        """The letter of a quantity at this moment, or its value where the scene fixes it."""
        kind = QUANTITIES[word]
        moment = self.when if when is None else when
        quantity = SceneQuantity(word, owner, moment, component, letter or kind.letter, kind.dimension, *words)
        return self.registry.ask(quantity)

    def sense(self, name: str) -> int:
        """+1 where a body's positive turn is counterclockwise, −1 where it is clockwise."""
        return self.configuration.sense(name, self.state)

    def turn_words(self, name: str) -> tuple[str, str]:
        return TURNS if self.sense(name) > 0 else (TURNS[1], TURNS[0])

    def rate(self, word: str, name: str) -> Formula:
        """Angular velocity or acceleration of a body, counted along its positive sense."""
        when = self.span(name) if word == "angular_acceleration" else self.moving
        return self.ask(word, name, when=when, words=self.turn_words(name))

    def driven(self, drive: Drive, word: str) -> Formula:
        """The letter of a coordinate that is given, or of its rate or acceleration."""
        if drive.component:
            return self.component(word, drive.body, drive.component)
        if word in TRAVELLING:
            line = self.line(drive.body)
            return self.travel(word, drive.body, line[1] if line else "")
        if word == "angle":
            return self.ask("angle", drive.body, words=TURNS)
        return self.rate(word, drive.body)

    def orientation(self, name: str) -> Heading:
        """How far a body's own axes are turned in space: by its angle, or not at all where it stands as drawn."""
        angle = self.angle(name)
        return RIGHT if angle is None else heading(angle) - self.offset(name)

    def offset(self, name: str) -> Heading:
        """Direction, in the body's own axes, that its `angle` measures: a rod's start to end, else from hinge to centre of mass."""
        body, own, hung = self.body(name), self.frame(name), self.configuration.hung(name, self.state)
        arm = own.cm if hung is None else tidy(own.reference - locate(body, hung))
        return RIGHT if shape_of(body).slender or not arm.parts else direction_of(arm)

    def angle(self, name: str) -> Formula | None:
        """The angle of a body; None where the scene never speaks of it and it stands as drawn or looks the same all round."""
        return self.ask("angle", name, words=TURNS) if self.follows_angle(name) else None

    @remembered
    def follows_angle(self, name: str) -> bool:
        """Whether the angle of a body matters: of a rod that weighs always, else where the scene speaks of it or follows a mark; of all
        that turns where a motion is followed in time."""
        if self.mark == COURSE:
            held = self.configuration.pivot(name, self.state) is not None
            return held or self.configuration.can_turn(name, self.state)
        rod = shape_of(self.body(name)).slender
        if self.weight_swings(name):
            return True
        if not (rod and self.configuration.heavy) and not (self.speaks_of_angle(name) or self.follows_marks(name)):
            return False
        return rod or not self.stands_as_drawn(name)

    def weight_swings(self, name: str) -> bool:
        """Whether this is a moment of swings or their equilibrium, and the weight of a hinged body has an arm that turns with it."""
        configuration = self.configuration
        hinged = self.generic and self.mark != GENERIC and configuration.pivot(name, self.state) is not None
        return hinged and configuration.heavy and bool(self.frame(name).cm.parts)

    def speaks_of_angle(self, name: str) -> bool:
        """Whether the scene asks for a body's angle, states it, drives it, or lets something vary with it."""
        configuration = self.configuration
        problem, paths = configuration.problem, configuration.mentions.paths
        if any(path.owner == name and path.quantity == "angle" and not path.point for path in paths):
            return True
        if any(drive.word == "angle" for drive in configuration.drives(name, self.state)) or self.leant_on(name):
            return True
        values = (value for item in (*problem.connections, *problem.actions) for value in varying_values(item))
        return any((owner, word) == (name, "angle") for value in values for _, owner, word in paths_in(value))

    def leant_on(self, name: str) -> bool:
        """Whether something pulls on a body in a direction that stays while the arm turns with it, from one state to another."""
        configuration = self.configuration
        several = len(configuration.timeline.states) > 1
        return several and any(
            name in item.leans(configuration, self.state) for item in configuration.actions(self.state)
        )

    def follows_marks(self, name: str) -> bool:
        """Whether the scene follows a mark on a body while it turns about its centre of mass: it stands as drawn at first."""
        configuration, body = self.configuration, self.body(name)
        slanted = self.frame(name).cm.parts and not shape_of(body).slender
        if len(configuration.timeline.states) < 2 or slanted:
            return False
        asked = (term.path for find in configuration.problem.finds for term in find.terms if term.path.owner == name)
        still = (*STILL, *dict(body.radii))
        return any(
            path.point not in still and path.quantity in FOLLOWED and path.component in (None, *PLANE) for path in asked
        )

    def stands_as_drawn(self, name: str) -> bool:
        """Whether a body slides along as it is drawn, with nothing said of its angle."""
        flat = self.travels_on_line(name)
        said = self.configuration.mentions.says
        return flat and not self.configuration.can_turn(name, self.state) and not said(self.state, name, "angle")

    def travels_on_line(self, name: str) -> bool:
        """Whether a body travels along a line."""
        return self.line(name) is not None

    def point(self, ref: PointRef) -> Vector:
        """A point of a body from its host's reference point, in space."""
        host = self.host(ref.owner)
        if host != ref.owner:
            member = next(item for item in self.configuration.cluster(host, self.state) if item.name == ref.owner)
            base = self.point(member.at)
            own = locate(self.body(ref.owner), ref) - locate(self.body(ref.owner), member.own)
            return base + own.rotated(self.orientation(host)) if own.parts else base
        body, pivot = self.body(host), self.configuration.pivot(host, self.state)
        on_rim, radius = {**ON_RIM, **dict.fromkeys(dict(body.radii), RIGHT)}, rim_radius(body, ref.point)
        if ref.point in on_rim and radius is not None and (pivot is None or pivot.point != ref.point):
            return self._from_reference(host, NOWHERE) + vector(radius, on_rim[ref.point])
        return self._from_reference(host, locate(self.body(host), ref))

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
            return Motion("axis", spin=spin, spin_rate=rate, sense=sense, turns=True, orientation=own)
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

    def line(self, name: str) -> tuple[Heading, str] | None:
        """Direction of travel of a body that moves along a line or circle, and the words for its positive sense."""
        orbit = self.orbit(name)
        if orbit is None:
            return self.configuration.line(name, self.state)
        return heading(self.place_on(orbit)).turned(90 * orbit.way), orbit.words

    def orbit(self, name: str) -> Orbit | None:
        return self.configuration.orbit(name, self.state)

    def place_on(self, orbit: Orbit) -> Formula:
        """The angle that tells where on its circle a body is."""
        return self.ask("angle", orbit.owner, words=TURNS)

    def bend(self, orbit: Orbit) -> Bend | None:
        """The circle of a body's centre at this moment; None on a track of which only heights are known."""
        return Bend(orbit.radius, heading(self.place_on(orbit))) if orbit.radius is not None else None

    def travel(self, word: str, name: str, words: str) -> Formula:
        """Velocity or acceleration along a body's line, counted along its positive sense."""
        when = self.span(name) if word == "acceleration" else self.moving
        return self.ask(word, name, when=when, words=(words, opposite(words)))

    def component(self, word: str, name: str, axis: str) -> Formula:
        when = self.span(name) if word == "acceleration" else self.moving
        words = ("right", "left") if axis == "x" else ("up", "down")
        return self.ask(word, name, when=when, component=axis, words=words)

    def velocity(self, ref: PointRef) -> Vector:
        """Velocity of a point; at rest for the ground."""
        if ref.owner not in self.configuration.bodies:
            return NOWHERE
        return self.motion(ref.owner).velocity_of(self.point(ref))

    def acceleration(self, ref: PointRef) -> Vector:
        if ref.owner not in self.configuration.bodies:
            return NOWHERE
        return self.motion(ref.owner).acceleration_of(self.point(ref))

    def is_round(self, name: str) -> bool:
        return name in self.configuration.bodies and rim_radius(self.body(name), None) is not None

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
        letters = {name: self.variable(word, self.host(owner)) for name, owner, word in paths_in(value)}
        return value.substitute({**letters, TIME: self.time()})

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
        """Rotation or displacement since the first state: the sum over the phases gone by; in the midst of a phase a running letter."""
        words = self.turn_words(name) if word == "rotation" else self.line_words(name)
        timeline = self.configuration.timeline
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
