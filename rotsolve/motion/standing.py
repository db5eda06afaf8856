"""Standing: how bodies stand at one moment: what their angles are, on which lines they travel, and the letters for that."""

from __future__ import annotations

from collections.abc import Container, Mapping
from functools import cached_property
from typing import TYPE_CHECKING

from msgspec import Struct, field

from rotsolve.algebra.formula import ZERO, Formula, Symbol, add, negate
from rotsolve.core.drive import TRAVELLING, TURNING, Drive
from rotsolve.core.facts import signed
from rotsolve.core.faults import Unsolvable
from rotsolve.core.quantity import PLANE, QUANTITIES
from rotsolve.core.registry import Registry, SceneQuantity
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import COURSE, GENERIC, VIRTUAL, paths_in, rub_key
from rotsolve.core.vectors.heading import (
    RIGHT,
    TURNS,
    WORDS,
    Heading,
    Vector,
    heading,
    opposite,
)
from rotsolve.elements.shapes import rim_radius, shape_of
from rotsolve.language.bodies import PointRef
from rotsolve.language.keys import varying_values
from rotsolve.motion.rigid import Frame, locate, rim_ways, tidy

if TYPE_CHECKING:
    from rotsolve.language.bodies import Orbit
    from rotsolve.language.problem import Body, Path
    from rotsolve.motion.configuration import Configuration


TURNED = ("angle", "rotation", "turns")
FOLLOWED = ("position", "displacement", "velocity", "acceleration", "momentum", "force")
SIZES = ("speed", "kinetic_energy", "power", "instantaneous_centre")  # which on a fixed axis are the same all round


class Standing(Struct, frozen=True, dict=True):
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

    def turn_span(self, name: str) -> str:
        """The same of its angular acceleration."""
        own = self.configuration.turn_span(name, self.state)
        return self.when if self.generic and own == self.state else own

    def body(self, name: str) -> Body:
        return self.configuration.body(name, self.state)

    def host(self, name: str) -> str:
        return self.configuration.host(name, self.state)

    def frame(self, name: str) -> Frame:
        return self.configuration.frame(name, self.state)

    def weightless(self, name: str) -> bool:
        """Whether a body has no inertia against turning about its reference."""
        own = self.frame(name)
        return all(
            piece.moment == ZERO and (piece.mass == ZERO or not tidy(piece.at - own.reference).parts)
            for piece in own.pieces
        )

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

    def coordinate(self, name: str) -> Symbol:
        """The letter of a variable of integration."""
        return self.registry.coordinate(name)

    def held_by_friction(self, owner: str, when: str, words: tuple[str, str]) -> tuple[Formula, int]:
        """The friction that holds a contact, as large as it takes, and its sense: +1 where it is drawn by the first of two words, as it is
        unless the numbers tell that it acts the other way."""
        turned = owner in self.configuration.forward
        ways = (words[1], words[0]) if turned else words
        return self.ask("friction_force", owner, when=when, words=ways), -1 if turned else 1

    def sense(self, name: str) -> int:
        """+1 where a body's positive turn is counterclockwise, −1 where it is clockwise."""
        return self.configuration.sense(name, self.state)

    def turn_words(self, name: str) -> tuple[str, str]:
        return TURNS if self.sense(name) > 0 else (TURNS[1], TURNS[0])

    def rate(self, word: str, name: str) -> Formula:
        """Angular velocity or acceleration of a body, counted along its positive sense; of what is held still none in thought either."""
        thought_of = (self.generic and self.mark != GENERIC) or (self.virtual and word == "angular_velocity")
        if thought_of and self.held_still(name):
            return ZERO
        when = self.turn_span(name) if word == "angular_acceleration" else self.moving
        return self.ask(word, name, when=when, words=self.turn_words(name))

    def held_still(self, name: str) -> bool:
        """Whether it is given that a body does not turn."""
        drives = self.configuration.drives(name, self.state)
        return any(drive.kinds == TURNING and drive.holds_still for drive in drives)

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

    @property
    def in_balance(self) -> bool:
        """Whether the state says that all stands in balance."""
        return self.configuration.timeline.state(self.state).balance

    def says_to_stick(self, name: str) -> bool:
        """Whether the scene begins with what is said to stick there, or in balance: then friction has to suffice for it."""
        state = self.configuration.timeline.state(self.state)
        first = self.configuration.timeline.states[0].name == state.name
        paths = [line.path for line in state.conditions if line.word == "sticks"]
        return state.balance or (first and any(path is not None and path.owner == name for path in paths))

    def orientation(self, name: str) -> Heading:
        """How far a body's own axes are turned in space: by its angle, or not at all where it stands as drawn."""
        angle = self.angle(name)
        return RIGHT if angle is None else heading(angle) - self.offset(name)

    @remembered
    def offset(self, name: str) -> Heading:
        """Direction, in a body's own axes, that the letter of its angle measures.

        That of its `angle`; of one that stands for others, which are all turned by one angle, that of the first rod whose angle the scene
        speaks of, where it is no rod itself; its own axis where the centre of mass lies at an angle that is told by letters alone, save
        where it swings.
        """
        if not shape_of(self.body(name)).slender:
            for seat in self.configuration.cluster(name, self.state):
                if shape_of(self.body(seat.name)).slender and self._speaks_of("angle", seat.name):
                    return seat.turned
        measured = self._measured(name)
        return measured if not measured.terms or self.configuration.mentions.swings else RIGHT

    def _measured(self, name: str) -> Heading:
        """Direction that the angle of a body measures, in the axes of the one that stands for it: a rod's start to end, of what is held
        by a hinge or rolls from there to the centre of mass of all that is welded to it, else its own axis to the right."""
        seat = self.configuration.seat(name, self.state)
        hung, own = self.configuration.hung(name, self.state), self.frame(seat.host)
        if shape_of(self.body(name)).slender or (seat.host != name and hung is None):
            return seat.turned
        arm = own.cm
        if hung is not None:
            arm = tidy(own.reference + own.cm - seat.place(locate(self.body(name), hung)))
        elif any(
            event.joined() for event in self.configuration.events(self.state)
        ):  # which turn no angle by being joined
            welded = self.configuration.frame(name, self.configuration.timeline.states[0].name)
            arm = tidy(welded.reference + welded.cm - own.reference)
        return self.configuration.direction(arm, name) if arm.parts else RIGHT

    def measured_aside(self, name: str) -> bool:
        """Whether the angle of a body is that of the direction to a common centre of mass which lies aside of its own axis."""
        seat, hung = self.configuration.seat(name, self.state), self.configuration.hung(name, self.state)
        own = shape_of(self.body(name)).slender or (seat.host != name and hung is None)
        return not own and self._measured(name) != RIGHT

    def angle(self, name: str) -> Formula | None:
        """The angle of a body; None where the scene never speaks of it and it stands as drawn or looks the same all round."""
        return self.ask("angle", name, words=TURNS) if self.follows_angle(name) else None

    def angle_of(self, name: str) -> Formula:
        """The angle of a body, which may be part of another: that of all, and how far it is turned against it."""
        host = self.host(name)
        letter, apart = self.ask("angle", host, words=TURNS), self._measured(name) - self.offset(host)
        return letter if apart == RIGHT else add(letter, apart.formula())

    def rate_of(self, word: str, name: str) -> Formula:
        """Angular velocity or acceleration of a body, which may be part of another, counted along its own positive sense."""
        return self.as_counted(self.rate(word, self.host(name)), name)

    def as_counted(self, turn: Formula, name: str) -> Formula:
        """A turn of all that is joined to a body, counted along that body's own positive sense."""
        return signed(turn, self.sense(self.host(name)) * self.sense(name))

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
        told = self.speaks_of_angle(name) or self.follows_marks(name) or self.tilts(name) or self.carries_round(name)
        if not (rod and self.configuration.heavy) and not told:
            return False
        return rod or not self.stands_as_drawn(name)

    def tilts(self, name: str) -> bool:
        """Whether what acts on a body that turns about another point than its centre of mass gets another arm on the way."""
        configuration = self.configuration
        bound = configuration.heavy or configuration.hung(name, self.state) is not None
        return self._time_passes() and bound and configuration.eccentric(name, self.state)

    def _time_passes(self) -> bool:
        """Whether there is more than blows between the states."""
        return any(interval.event is None for interval in self.configuration.timeline.intervals)

    def drawn_at_first(self, name: str) -> bool:
        """Whether a body stands as drawn at the first state, since nothing tells how it stands; a rod may stand anyhow."""
        asked = (term.path for find in self.configuration.problem.finds for term in find.terms)
        if any(
            path.quantity == "angle" and self.host(path.owner) == name
            for path in asked
            if path.owner in self.configuration.bodies
        ):
            return False
        slender, problem = shape_of(self.body(name)).slender, self.configuration.problem
        held = any(state.balance or state.steady for state in problem.states)
        if self.wound(name) and not slender and not held:
            return not any(self.configuration.mentions.says(state.name, name, "angle") for state in problem.states)
        tilts = self.tilts(name) and not slender
        return tilts or self.follows_marks(name) or self.leant_on(name) or self.carries_round(name)

    def weight_swings(self, name: str) -> bool:
        """Whether this is a moment of swings or their equilibrium, and the weight of what is hinged or rolls has an arm that turns."""
        swinging = self.generic and self.mark != GENERIC and self.configuration.heavy
        return swinging and self.configuration.eccentric(name, self.state)

    def speaks_of_angle(self, name: str) -> bool:
        """Whether the scene speaks of the angle of a body or of what is joined to it, drives it, or lets something vary with it."""
        configuration = self.configuration
        problem, carried = configuration.problem, configuration.carried(name, self.state)
        if any(self._speaks_of("angle", item) for item in carried):
            return True
        if any(drive.word == "angle" for drive in configuration.drives(name, self.state)) or self.leant_on(name):
            return True
        if self.wound(name):
            return True
        values = (value for item in (*problem.connections, *problem.actions) for value in varying_values(item))
        return any(owner in carried and word == "angle" for value in values for _, owner, word in paths_in(value))

    def _speaks_of(self, word: str, name: str) -> bool:
        """Whether a state or question speaks of a quantity of a body, not of a point of it."""
        paths = self.configuration.mentions.paths
        return any((path.owner, path.quantity) == (name, word) and not path.point for path in paths)

    def wound(self, name: str) -> bool:
        """Whether a wire turns a body, or what is joined to it, back by its angle."""
        carried = self.configuration.carried(name, self.state)
        return any(ref.owner in carried for item in self.configuration.connections(self.state) for ref in item.winds())

    def leant_on(self, name: str) -> bool:
        """Whether something pulls on a body in a direction that does not turn with the arm, from one state to another; the angle of a rod
        that weighs is always looked at."""
        configuration = self.configuration
        if len(configuration.timeline.states) < 2:
            return False
        rod = configuration.heavy and shape_of(self.body(name)).slender
        items = configuration.actions(self.state) if rod else configuration.acting(self.state)
        return any(name in item.leans(configuration, self.state) for item in items)

    def carries_round(self, name: str) -> bool:
        """Whether from one state to another a body takes along, round the point about which it turns, a joint with another."""
        configuration, carried = self.configuration, self.configuration.carried(name, self.state)
        joints = (item.joint() for item in configuration.connections(self.state) if not item.fixed_points())
        held = (ref for refs in joints for ref in refs if ref.owner in carried)
        return len(configuration.timeline.states) > 1 and any(
            configuration.swings_round(ref, self.state) for ref in held
        )

    def follows_marks(self, name: str) -> bool:
        """Whether the scene follows a mark on a body, or on one that is joined to it, round the point about which it turns.

        So does the force of what holds it at another point than its centre of mass. Where no state tells how far that turns, sizes are
        spoken of as it is drawn, and between blows components too.
        """
        configuration, carried = self.configuration, self.configuration.carried(name, self.state)
        if len(configuration.timeline.states) < 2:
            return False
        if self._asks_within(carried) and configuration.pivot(name, self.state) is None:
            return configuration.can_turn(name, self.state)
        terms = [term for find in configuration.problem.finds for term in find.terms]
        turning = [term for term in terms if term.path.owner in carried and self._turns_with(term.path, name)]
        paths = [term.path for term in turning]
        asked = [PointRef(path.owner, path.point, path.argument) for path in paths]
        whose = (*carried, "")  # all together have an angular momentum about a point too
        asked += [
            term.about for term in terms if term.about and term.about.owner in carried and term.path.owner in whose
        ]
        told = any(
            configuration.mentions.says(state.name, item, *TURNED)
            for state in configuration.timeline.states
            for item in carried
        )
        told |= self._time_passes() and any(term.path.component or term.modifier == "mean" for term in turning)
        if self._asks_of_joint(name, carried):
            return True
        unknown = self.frame(name).cm.parts and not shape_of(self.body(name)).slender and not told
        return not unknown and any(map(self._goes_round, asked))

    def _turns_with(self, path: Path, name: str) -> bool:
        """Whether a quantity goes by how its body is turned: about a fixed axis sizes, and parts along the way, do not."""
        if self.configuration.pivot(name, self.state) is None:
            return path.quantity in FOLLOWED + SIZES
        return path.quantity in FOLLOWED and path.component in (None, *PLANE)

    def _asks_of_joint(self, name: str, carried: Container[str]) -> bool:
        """Whether a question asks for a component in space of the force at which a body is held, whose centre of mass goes round, or with
        which bodies that go round together hold each other."""
        configuration = self.configuration
        items = configuration.connections(self.state)
        held = {item.name for item in items for ref in item.fixed_points() if ref.owner in carried}
        if not configuration.eccentric(name, self.state):
            held = set()
        held |= {item.name for item in items if item.joined() and item.joined()[0].owner in carried}
        paths = (term.path for find in configuration.problem.finds for term in find.terms if term.modifier != "size of")
        forces = [path for path in paths if path.owner in held and path.quantity == "force"]
        return self._time_passes() and any(path.component in (None, *PLANE) for path in forces)

    def _asks_within(self, carried: Container[str]) -> bool:
        """Whether a question asks with what force bodies that are one hold each other, which goes round with them."""
        joints = (item for item in self.configuration.connections(self.state) if item.joined())
        welds = {item.name for item in joints if item.joined()[0].owner in carried}
        paths = (term.path for find in self.configuration.problem.finds for term in find.terms)
        return any(path.owner in welds and path.quantity == "force" for path in paths)

    def _goes_round(self, ref: PointRef) -> bool:
        """Whether a point of which a question speaks goes round another; names of rims are directions in space from their centre."""
        on_rim = ref.point in rim_ways(self.body(ref.owner))
        place = PointRef(ref.owner, "center" if on_rim else ref.point or "cm", ref.argument)
        return self.configuration.swings_round(place, self.state)

    def stands_as_drawn(self, name: str) -> bool:
        """Whether a body slides along as it is drawn, with nothing said of its angle at any state at which it can't turn either."""
        configuration = self.configuration
        still = [state.name for state in configuration.timeline.states if not configuration.can_turn(name, state.name)]
        return self.never_turns(name) and not any(configuration.mentions.says(state, name, "angle") for state in still)

    def never_turns(self, name: str) -> bool:
        """Whether a body slides along a line and does not turn."""
        return self.travels_on_line(name) and not self.configuration.can_turn(name, self.state)

    def travels_on_line(self, name: str) -> bool:
        """Whether a body travels along a line."""
        return self.line(name) is not None

    def line(self, name: str) -> tuple[Heading, str] | None:
        """Direction of travel of a body that moves along a line or circle, and the words for its positive sense."""
        orbit = self.orbit(name)
        if orbit is None:
            return self.configuration.line(name, self.state)
        return heading(self.place_on(orbit)).turned(90 * orbit.way), orbit.words

    def line_of(self, name: str) -> tuple[Heading, str] | None:
        """The line along which a body travels, also as part of another, in its own positive sense where it says one."""
        host = self.host(name)
        line = self.line(host)
        moves = self.body(name).moves if line is not None and host != name else None
        if line is None or moves is None:
            return line
        question = f"which way along its line `{name}` counts as positive"
        ahead = (line[0] - WORDS[moves]).cos()
        forward = self.configuration.certain_sign(ahead, question, self.body(name).span)
        return line if forward > 0 else (line[0].turned(180), opposite(line[1])) if forward else None

    def as_travelled(self, way: Formula, name: str) -> Formula:
        """What all that is joined to a body travels, counted along that body's own positive sense."""
        line, own = self.line(self.host(name)), self.line_of(name)
        if own is None and line is not None:
            message = f"`{name}` moves across the way that it `moves`"
            raise Unsolvable(message, span=self.body(name).span, help="ask for its velocity by `x` and `y`")
        return way if own == line else negate(way)

    def orbit(self, name: str) -> Orbit | None:
        return self.configuration.orbit(name, self.state)

    def place_on(self, orbit: Orbit) -> Formula:
        """The angle that tells where on its circle a body is."""
        return self.ask("angle", orbit.owner, words=TURNS)

    def is_round(self, name: str) -> bool:
        return name in self.configuration.bodies and rim_radius(self.body(name), None) is not None

    def travel(self, word: str, name: str, words: str) -> Formula:
        """Velocity or acceleration along a body's line, counted along its positive sense."""
        when = self.span(name) if word == "acceleration" else self.moving
        return self.ask(word, name, when=when, words=(words, opposite(words)))

    def component(self, word: str, name: str, axis: str) -> Formula:
        when = self.span(name) if word == "acceleration" else self.moving
        words = ("right", "left") if axis == "x" else ("up", "down")
        return self.ask(word, name, when=when, component=axis, words=words)
