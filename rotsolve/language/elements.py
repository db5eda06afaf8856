"""Elements: the base classes of all that a scene is built of beside its bodies, what they see of it, and what is asked of them.

Each question has a plain default. No element knows where it is asked from: it sees one `Moment` of the scene, and its `Surroundings`.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator, Mapping, Sequence
from typing import Any, ClassVar, Protocol

from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.core.derivation import Words
from rotsolve.core.drive import Drive
from rotsolve.core.facts import CONTACT, BodyFacts, Couple, Force, Motion, Potential, Requirement, Rule, Summed, Whirl
from rotsolve.core.faults import Span, Unsolvable
from rotsolve.core.limits import Limit
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import pace_of
from rotsolve.core.vectors.heading import RIGHT, UP, Heading, Vector, unit
from rotsolve.language.bodies import Body, Coupling, Joint, Orbit, PointRef, Ride, Surface
from rotsolve.language.keys import Element, key

Fact = Force | Couple | Rule | Requirement | Potential | Summed
PlaceOf = Callable[[PointRef], Formula | None]


class SceneElements(Protocol):
    """What a scene declares, as its elements see it."""

    @property
    def connections(self) -> tuple[Connection, ...]: ...
    @property
    def actions(self) -> tuple[Action, ...]: ...
    @property
    def events(self) -> tuple[Event, ...]: ...
    @property
    def bodies(self) -> tuple[Body, ...]: ...
    @property
    def surfaces(self) -> tuple[Surface, ...]: ...
    @property
    def gravity(self) -> Formula | None: ...
    @property
    def states(self) -> tuple[Any, ...]: ...
    @property
    def plane(self) -> str: ...
    @property
    def space(self) -> bool: ...


class Mentioned(Protocol):
    """What the states and questions of a scene speak of."""

    def says(self, state: str, owner: str, *words: str) -> bool: ...
    def asks(self, owner: str, word: str) -> bool: ...
    def values(self, owner: str, word: str) -> Iterator[Formula]: ...
    def untold(self, owner: str, word: str) -> tuple[str, Span | None] | None: ...


class Surroundings(Protocol):
    """The configuration of a scene as its elements see it: what acts at which state, and how bodies can move."""

    @property
    def problem(self) -> SceneElements: ...
    @property
    def bodies(self) -> dict[str, Body]: ...
    @property
    def surfaces(self) -> dict[str, Surface]: ...
    @property
    def held(self) -> dict[str, str]: ...
    @property
    def mentions(self) -> Mentioned: ...
    @property
    def heavy(self) -> bool: ...
    @property
    def order(self) -> tuple[str, ...]: ...
    @property
    def positive(self) -> frozenset[str]: ...
    @property
    def signs(self) -> SignOracle: ...

    def certain_sign(self, value: Formula, question: str, span: Span | None = None) -> int: ...

    def connections(self, state: str) -> tuple[Connection, ...]: ...
    def throughout(self, name: str) -> tuple[str, ...]: ...
    def host(self, name: str, state: str) -> str: ...
    def component(self, name: str, state: str) -> frozenset[str]: ...
    def pivot(self, name: str, state: str) -> PointRef | None: ...
    def pinned(self, name: str, state: str) -> bool: ...
    def line(self, name: str, state: str) -> tuple[Heading, str] | None: ...
    def mover(self, name: str, state: str) -> str: ...
    def drives(self, name: str, state: str) -> tuple[Drive, ...]: ...
    def balanced(self, name: str, state: str) -> bool: ...
    def swings_round(self, ref: PointRef, state: str) -> bool: ...
    def can_turn(self, name: str, state: str) -> bool: ...
    def driven(self, name: str, state: str, by: str) -> bool: ...


class Moment(Protocol):
    """One moment of a scene as its elements see it: where bodies are, how they move, and the letters for that."""

    @property
    def configuration(self) -> Surroundings: ...
    @property
    def state(self) -> str: ...
    @property
    def when(self) -> str: ...
    @property
    def moving(self) -> str: ...
    @property
    def in_balance(self) -> bool: ...
    def says_to_stick(self, name: str) -> bool: ...

    def ask(
        self,
        word: str,
        owner: str,
        *,
        when: str | None = None,
        component: str = "",
        words: tuple[str, str] = ("", ""),
        letter: str = "",
    ) -> Formula: ...
    def coordinate(self, name: str) -> Symbol: ...
    def held_by_friction(self, owner: str, when: str, words: tuple[str, str]) -> tuple[Formula, int]: ...
    def mode(self, contact: str) -> str: ...
    def span(self, name: str) -> str: ...
    def body(self, name: str) -> Body: ...
    def host(self, name: str) -> str: ...
    def angle_of(self, name: str) -> Formula: ...
    def sense(self, name: str) -> int: ...
    def turn_words(self, name: str) -> tuple[str, str]: ...
    def is_round(self, name: str) -> bool: ...
    def weightless(self, name: str) -> bool: ...
    def centre_of_mass(self, name: str) -> Vector: ...
    def motion(self, name: str) -> Motion: ...
    def line(self, name: str) -> tuple[Heading, str] | None: ...
    def orbit(self, name: str) -> Orbit | None: ...
    def point(self, ref: PointRef) -> Vector: ...
    def hub(self, ref: PointRef) -> Vector: ...
    def pointing(self, name: str, way: Heading) -> Vector: ...
    def velocity(self, ref: PointRef) -> Vector: ...
    def acceleration(self, ref: PointRef) -> Vector: ...
    def time(self) -> Formula: ...
    def since_first(self, word: str, name: str) -> Formula: ...
    def now(self, value: Formula) -> Formula: ...


class LetterMaker(Protocol):
    """Makes a letter that no other quantity has, for what the scene leaves out."""

    def make(self, letter: str, owner: str, dimension: str) -> Formula: ...


class ActingElement(Element, frozen=True):
    """Base of all that acts on bodies. `quantities` can be asked of it."""

    instead: ClassVar[str] = ""  # how scenes in space say the same, where they do not have it
    about: ClassVar[str] = ""
    quantities: ClassVar[tuple[str, ...]] = ()
    quantities_in_space: ClassVar[tuple[str, ...]] = ()  # beside these, in scenes in space
    later: ClassVar[bool] = False
    planar: ClassVar[bool] = True  # whether scenes in the plane have it
    spatial: ClassVar[bool] = False  # whether scenes in space do
    spatial_word: ClassVar[str] = ""  # the word that says the same in space, where one does
    name: str = ""

    def check(self, scene: Surroundings) -> None:
        """Refuses by name what the scene can't mean: raises Unsolvable."""

    def touches(self) -> tuple[PointRef, ...]:
        """All points that it names."""
        return ()

    def brakes(self) -> tuple[PointRef, ...]:
        """Bodies against whose turn it rubs, whichever way that is."""
        return ()

    def pace(self, configuration: Surroundings, state: str) -> str:
        """How its forces and rules vary while bodies move (see core.symbols)."""
        return "constant"

    def on_rims(self, scene: Surroundings) -> tuple[PointRef, ...]:
        """The points for which it takes the rim, where they name none."""
        return ()

    def twists(self) -> bool:
        """Whether a couple of it acts on the bodies that it touches."""
        return False

    def leans(self, configuration: Surroundings, state: str) -> tuple[str, ...]:
        """Bodies on which it pulls at a point that goes round as they turn, in a direction that does not turn with them."""
        return ()

    def along_turns(self) -> Iterator[tuple[Formula | None, PointRef]]:
        """Its values that count along a body's positive turn, with the body."""
        return iter(())

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """The forces, couples, rules and requirements that it adds at a moment."""
        return iter(())


ALL_THE_TIME = "what acts does so in all states: begin another scene where it begins or ends, with how all moves then"
SPAN_OF_ACTION: dict[str, Any] = {"refers": ("state",), "plane": True, "instead": ALL_THE_TIME}


class Action(ActingElement, frozen=True):
    """Base of all actions. An action between two states is absent before and after."""

    from_: str | None = key("name", "the state at which it begins", example="start", **SPAN_OF_ACTION)
    to: str | None = key("name", "the state at which it ends", example="end", **SPAN_OF_ACTION)

    def touches(self) -> tuple[PointRef, ...]:
        """The point on which it acts."""
        on = getattr(self, "on", None)
        return (on,) if on is not None else ()

    def strength(self) -> Formula:
        """The force, torque or power, under the key of its word; where it varies, a formula of `time` and of paths of bodies."""
        return getattr(self, self.word, None) or ZERO

    def pace(self, configuration: Surroundings, state: str) -> str:
        return pace_of(self.strength())

    def now(self, instant: Moment) -> Formula:
        """Its strength at a moment."""
        return instant.now(self.strength())


class Connection(ActingElement, frozen=True):
    """Base of all connections. `words` can be said of it in a state.

    `independent` holds several bodies without making one move with the other, `bodily` joins bodies alone and nothing that is fixed,
    `lays_first` names first what it lays on something, `rimmed` runs on the rims of wheels, `repeats` may name a body twice, `guiding`
    takes a body where another one is, `axial` is an axis through the centre of what it holds, `circling` carries that steadily round.
    `kept` are its quantities that events leave.
    """

    words: ClassVar[tuple[str, ...]] = ()
    independent: ClassVar[bool] = False
    bodily: ClassVar[bool] = False
    rimmed: ClassVar[bool] = False
    repeats: ClassVar[bool] = False
    guiding: ClassVar[bool] = False
    axial: ClassVar[bool] = False
    lays_first: ClassVar[bool] = False
    circling: ClassVar[bool] = False
    kept: ClassVar[tuple[str, ...]] = ()

    def check(self, scene: Surroundings) -> None:
        """Two bodies that turn against each other share an axle."""
        if self.between():
            first, second = self.between()
            if scene.held.get(first.owner, first.owner) != scene.held.get(second.owner):
                help, message = (
                    f"give `axle: [{first.owner}, {second.owner}]`",
                    "is solved for two bodies on one axle only",
                )
                raise Unsolvable(f"`{self.word}` {message}", span=second.span, help=help)

    def holds_whatever_it_takes(self) -> bool:  # by friction to which nothing sets a limit
        return False

    def among(self, moving: Container[str]) -> Connection:
        """The connection as it stands among all others, which let the bodies `moving` move where it touches them."""
        return self

    def seen(self, scene: SceneElements, level: Container[str]) -> Connection:
        """The connection as the scene is seen; `level` are the names of what is level in it."""
        return self

    def completed(self, letters: LetterMaker, held: Container[str]) -> Connection:
        """The connection with letters for what the scene leaves out; `held` are the bodies on axles and hinges."""
        return self

    @remembered
    def touches(self) -> tuple[PointRef, ...]:
        return tuple(ref for field in self.pointed for ref in getattr(self, field))

    def between(self) -> tuple[PointRef, ...]:
        """The two bodies, if any, whose turning against each other its angles and angular velocities are."""
        return ()

    def joined(self) -> tuple[PointRef, ...]:
        """The two points, if any, that it joins, so that their bodies are one."""
        return ()

    def joint(self) -> tuple[PointRef, ...]:
        """The points that it keeps at one place, about which their bodies turn."""
        return ()

    def ride(self) -> Ride | None:
        """The body, if any, that slides along another."""
        return None

    def turned(self) -> tuple[str, ...]:
        """The bodies that it turns by their rims, so that they have a radius."""
        return tuple(ref.owner for ref in self.touches()) if self.rimmed else ()

    def on_rims(self, scene: Surroundings) -> tuple[PointRef, ...]:
        return self.touches() if self.rimmed else ()

    def ropes(self) -> tuple[PointRef, ...]:
        """The bodies that it holds although they bend freely."""
        return ()

    def twists(self) -> bool:
        return self.rimmed or bool(self.between() or self.winds())

    def fixed_points(self) -> tuple[PointRef, ...]:
        """Points of bodies that it holds to the ground, so that the body turns about them."""
        return ()

    def track(self, body: Body, configuration: Surroundings, state: str) -> tuple[Heading, str] | None:
        """Line along which it makes a body travel, with the words for the positive sense."""
        return None

    def orbit(self, body: Body, configuration: Surroundings, state: str) -> Orbit | None:
        """Circle along which it makes a body's centre travel."""
        return None

    def winds(self) -> tuple[PointRef, ...]:
        """The bodies that it turns back by their angles."""
        return ()

    def hangs(self, body: Body) -> bool:
        """Whether a body hangs from it, so that it travels up and down."""
        return False

    def whirl(self) -> Whirl | None:
        """How it carries what it holds round an upright axis."""
        return None

    def lays(self, body: Body) -> bool:
        """Whether a body lays itself out along it, layer by layer, so that less and less of it is left to move."""
        return False

    def weighs(self, body: Body) -> bool:
        """Whether it states the weight of a body, part by part."""
        return False

    def natural_turn(self, body: Body, configuration: Surroundings, state: str) -> int:
        """Positive turn of a body that goes with its positive travel: +1 counterclockwise, −1 clockwise, 0 no matter."""
        return 0

    def prescribes(self) -> Iterator[tuple[str, str, str, Formula]]:
        """Motions that it forces on bodies: (body, word, component, formula of `time`)."""
        return iter(())

    def place(self, name: str, way: Heading, instant: Moment, place_of: PlaceOf) -> Formula | None:
        """How far along a direction a body's reference is, where it tells that; `place_of` tells that of other points."""
        return None

    def tension_at(self, name: str, instant: Moment) -> Formula | None:
        """Its tension where it leaves a body, where it has several."""
        return None

    def lying(self) -> str:
        """The body, if any, that it lays on something."""
        return ""

    def rooms(self, scene: Surroundings) -> Iterator[Limit]:
        """What has to be for bodies to fit each other: a wheel is as large as what it climbs, a bead is on its bar."""
        return iter(())

    def places(self) -> tuple[PointRef, ...]:
        """What that body lies on: surfaces in the order in which they join, or a body."""
        return ()

    def carrier(self, configuration: Surroundings) -> str:
        """The body on which it lays another; '' for what does not move."""
        return ""

    def surface(self, configuration: Surroundings, state: str) -> Surface | None:
        """The surface on which it holds a body."""
        return None

    def touching_angle(self, instant: Moment) -> Formula:
        """Angle of the touching radius of a curved surface."""
        raise NotImplementedError

    def touching_arm(self, instant: Moment) -> Vector:
        """From the reference of the body that it lays on something to the point at which they touch."""
        raise NotImplementedError

    def grips(self) -> bool:
        """Whether friction can hold what it lays on something."""
        return False

    def grip_rule(self, instant: Moment) -> Rule | None:
        """No slip at a moment, for a state that says so."""
        return None

    def jolts(self) -> bool:
        """Whether its forces are as large as it takes even in an event."""
        return True

    def first_rate(self) -> tuple[Connection, PointRef, Formula] | None:
        """Of what drives a body with a told rate and an acceleration besides: the same without that rate, what it turns, and the rate."""
        return None

    def joint_in_space(self) -> Joint | None:
        """How it holds a body in space; None for what is no joint."""
        return None

    def coupling_in_space(self) -> Coupling | None:
        """How it ties how two shafts turn in space; None of what does not."""
        return None

    def motor_in_space(self) -> tuple[PointRef, PointRef] | None:
        """What it turns in space as hard as it takes, behind what carries that; None of what is no motor."""
        return None

    def rubs(self) -> bool:
        """Whether one of its bodies can slip, against friction of a size that is known."""
        return False

    def away(self, instant: Moment) -> Heading | None:
        """The direction out of what it lays a body on."""
        return None

    def slider(self) -> PointRef:
        """The body whose slip counts."""
        raise NotImplementedError

    def static(self) -> Formula | None:
        """The coefficient by which a push limits the friction that holds; None where the push has no part in it."""
        return None

    def force_within(self, quantity: str, instant: Moment) -> Formula | None:
        """The letter of a push or a friction within one body, which no free-body diagram has."""
        return None

    def verge(self, instant: Moment) -> tuple[tuple[Formula, Formula, Formula], ...]:
        """What is equal on the point of slipping, in each sense, where no push alone tells it; with what can't be negative then."""
        return ()

    def slip(self, instant: Moment, *, acceleration: bool = False) -> Formula | None:
        """How fast a body slips along the sense that counts as positive, or the rate of that; None where nothing tells the sense."""
        return None

    def slides_down(self, instant: Moment) -> Heading | None:
        """The way along a side of another body that counts as positive for what slides on it, as seen from that body."""
        return None

    def drift(self, instant: Moment) -> Formula | None:
        """How fast that body as a whole goes along; of two that turn on each other, their slip."""
        return self.slip(instant)


class Event(Element, frozen=True):
    """Base of all events: the state before and the state after. `bodily` marks one that is about bodies alone."""

    about: ClassVar[str] = ""
    quantities: ClassVar[tuple[str, ...]] = ()
    quantities_in_space: ClassVar[tuple[str, ...]] = ()
    later: ClassVar[bool] = False
    planar: ClassVar[bool] = True
    spatial: ClassVar[bool] = False
    instead: ClassVar[str] = ""  # how scenes in space say the same, where they do not have it
    at_once: ClassVar[str] = ""  # how scenes in space say that several happen at once
    bodily: ClassVar[bool] = False
    blow: ClassVar[bool] = False  # whether it gives impulses alone, so that several can be at once
    heats: ClassVar[bool] = False  # whether the energy that its bodies lose in it becomes heat
    lets_fly: ClassVar[bool] = False  # whether what lay on what it takes away is led along no line from then on
    name: str = ""
    from_: str | None = key("name", "the state before", default=None, refers=("state",), required=True, example="start")
    to: str | None = key("name", "the state after", default=None, refers=("state",), required=True, example="end")

    def check(self, scene: Surroundings) -> None:
        """Refuses by name what the scene can't mean: raises Unsolvable."""

    def completed(self, bodies: Container[str], surfaces: Mapping[str, Surface]) -> Event:
        """The event as it is among the bodies and surfaces of a scene."""
        return self

    def each(self) -> tuple[Event, ...]:
        """The events that happen in it: itself, of several at once each."""
        return (self,)

    def rubs(self) -> bool:
        """Whether what it strikes may slip, against friction of a size that is known."""
        return False

    def lying(self) -> str:
        """The body that strikes it."""
        return ""

    def met(self) -> tuple[str, ...]:
        """What comes together in it, bodies and what is fixed."""
        return ()

    def bounced_off(self) -> tuple[PointRef, Surface | None] | None:
        """Which point strikes a surface, or something fixed in its way: None for that; nothing where no bounce is told off either."""
        return None

    def of_centres(self) -> Event:
        """The same event as if bodies met with their centres of mass."""
        return self

    def coupled(self, instant: Moment) -> bool:
        """Whether its push alone would already change how the touching point slips."""
        return False

    def slip(self, instant: Moment) -> Formula:
        """How fast the touching point slips on what it strikes."""
        return ZERO

    def push(self, instant: Moment) -> Formula:
        """Its impulse across what it strikes."""
        return ZERO

    def static(self) -> Formula | None:
        """The coefficient by which its push limits the friction that holds."""
        return None

    def left_behind(self, connections: Sequence[Connection]) -> tuple[Connection, ...]:
        """The contacts whose surface is still there for what has left it."""
        return ()

    def barrier(self, before: Moment) -> tuple[PointRef, str, Heading | None] | None:
        """The body that stays in front of what it strikes, what that is, and the direction out of it, None where no one line tells that."""
        return None

    def rules(self, before: Moment, after: Moment) -> Iterator[Rule]:
        """What it ties right after it, and no longer."""
        return iter(())

    def needs(self, before: Moment, after: Moment) -> Iterator[Requirement]:
        """What its blows, and the speeds before and after it, obey."""
        return iter(())

    def no_torque(self, instant: Moment) -> str:
        """Why what acts at its place does not turn bodies about that."""
        return "the blow there has no arm"

    def told(self) -> Words:
        """What happens, as a page says it: "impulse J on rod's end, up"."""
        return ()

    def points(self, connections: Sequence[Connection]) -> tuple[PointRef, ...]:
        """The points that take part, whose bodies and all that is tied to them change their velocities; none where nothing does."""
        return ()

    def begins(self) -> tuple[str, ...]:
        """The connections that act only from it on."""
        return ()

    def ends(self, connections: Sequence[Connection]) -> tuple[str, ...]:
        """What does not act, or is not there, from it on."""
        return ()

    def adds(self) -> tuple[Connection, ...]:
        """Connections that hold bodies from it on."""
        return ()

    def joined(self) -> tuple[PointRef, ...]:
        """The two points, if any, that stay together from it on, so that their bodies are one."""
        return ()

    def blow_in_space(self) -> tuple[PointRef, Formula, tuple[Formula, Formula, Formula]] | None:
        """The point that it strikes in a scene in space, how hard and in which direction; None of what strikes from within."""
        return None

    def joint_in_space(self) -> Joint | None:
        """How it holds a body of a scene in space from then on; None of what holds none, and of bodies that it joins."""
        return None

    def spot(self, ref: PointRef, instant: Moment) -> Vector:
        """Where it acts on the body of a point that takes part, from the body's reference."""
        return instant.point(ref)

    def holds(self, ref: PointRef, instant: Moment) -> str:
        """What the point is called at which it holds a body; '' where it holds none."""
        return ""

    def blows(self, ref: PointRef, body: BodyFacts, instant: Moment) -> Iterator[Force]:
        """The blows on the body of a point that takes part: as large as it takes along each axis, on the last-named along that."""
        last = self.points(instant.configuration.problem.connections)[-1]
        for axis, direction in self.axes(instant):
            size = instant.ask("impulse", self.name, component=axis)
            push, arm = unit(direction if ref == last else direction.turned(180)), self.spot(ref, instant)
            yield Force(self.name, CONTACT, body.name, size, push, arm, "blow", internal=True)

    def axes(self, instant: Moment) -> tuple[tuple[str, Heading], ...]:
        """The directions of its blows, with the component that each is."""
        return (("x", RIGHT), ("y", UP))

    def twists(self, body: str, instant: Moment) -> tuple[Couple, ...]:
        """The angular impulses on a body beside those of its blows, as couples; `internal` where another body has the opposite one."""
        return ()

    def closing(self, before: Moment, after: Moment) -> tuple[Formula, Formula] | None:
        """(speed of approach before, speed of separation after) of two bodies that meet and do not stay together."""
        return None

    def bounce(self, before: Moment, after: Moment) -> tuple[Formula, Formula, Formula] | None:
        """(e, speed of approach before, speed of separation after), where two bodies bounce."""
        return None
