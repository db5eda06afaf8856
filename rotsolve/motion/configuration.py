"""Configuration: which connections act at which state, which bodies are joined into one, and how each can move."""

from __future__ import annotations

from functools import cached_property, partial
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.sign import ACUTE, SignOracle
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.drive import TURNING, Drive, along_line
from rotsolve.core.faults import Span, Unsolvable
from rotsolve.core.letters import letter_order
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import UNKNOWN, combined, is_key
from rotsolve.core.vectors.heading import UP, WORDS, Heading
from rotsolve.elements.shapes import rim_radius
from rotsolve.language.bodies import Body, Orbit, PointRef, Ride, Surface
from rotsolve.language.elements import Action, Connection, Event
from rotsolve.language.problem import Problem
from rotsolve.motion.members import Member, rider, welded
from rotsolve.motion.owndata import Version, versions
from rotsolve.motion.positive import is_angle, limited_letters, positive_letters
from rotsolve.motion.rigid import Frame, centre_of_mass, locate, pieces, polar, tidy
from rotsolve.motion.timeline import Mentions, Timeline, absent, begun, timeline

if TYPE_CHECKING:
    from rotsolve.core.passage import Alteration


class Configuration(Struct, frozen=True, dict=True):
    """A problem with its timeline; answers what is connected to what at each state.

    `alteration` is what is changed on purpose in what the laws say of it; nothing, save where a mistake is looked for.
    """

    problem: Problem
    alteration: Alteration | None = None

    @cached_property
    def timeline(self) -> Timeline:
        return timeline(self.problem)

    @cached_property
    def mentions(self) -> Mentions:
        return Mentions(self.problem, self.timeline)

    @cached_property
    def order(self) -> tuple[str, ...]:
        """Letters in the order in which a textbook writes them in a product."""
        return letter_order((given.name, given.dimension) for given in self.problem.givens)

    @cached_property
    def positive(self) -> frozenset[str]:
        """Givens that are surely positive."""
        return positive_letters(self.problem.givens)

    @cached_property
    def signs(self) -> SignOracle:
        """What tells the sign of a formula of givens."""
        return SignOracle(self.problem.values, self.positive, partial(limited_letters, self.problem))

    def certain_sign(self, value: Formula, question: str, span: Span | None = None) -> int:
        """The sign on which it hangs what the scene is: answers the `question`, which is refused by name where nothing tells it.

        With what is asked for it is that which it has for a positive number, or for an acute angle; `supposed` holds it against the answer.
        """
        sign = self.signs.decide(value)
        if sign is None:
            asked = {item.name: ACUTE if is_angle(item) else "positive" for item in self.problem.givens if item.asked}
            if asked.keys() & value.symbols():
                sign = replace(self.signs, limits=lambda: {**self.signs.limits(), **asked}).by_letters(value)
            if sign is None:
                raise self.undecided(value, question, span)
            self.supposed[value] = sign, question, span
        return sign

    def undecided(self, value: Formula, question: str, span: Span | None) -> Unsolvable:
        """A question that hangs on the sign of a formula in which letters lack a value."""
        names = " and ".join(f"`{name}`" for name in self.signs.lacking(value) if not is_key(name))
        help = f"give a number to {names}" if names else ""
        return Unsolvable(
            f"{question} can not be told", span=span, help=help, lines=self.problem.lines, file=self.problem.file
        )

    @cached_property
    def supposed(self) -> dict[Formula, tuple[int, str, Span | None]]:
        """The signs that only hold for some answers, with the questions that they answer."""
        return {}

    @cached_property
    def bodies(self) -> dict[str, Body]:
        return {body.name: body for body in self.problem.bodies}

    @cached_property
    def _versions(self) -> dict[str, dict[str, Version]]:
        laid = [body.name for body in self.problem.bodies if self.laid(body.name)]
        return versions(self.problem.bodies, self.timeline.states, laid)

    def laid(self, name: str) -> bool:
        """Whether a body lays itself out along a surface."""
        return name in self._laid

    @cached_property
    def _laid(self) -> frozenset[str]:
        named = ((item, ref.owner) for item in self.problem.connections for ref in item.touches())
        return frozenset(name for item, name in named if name in self.bodies and item.lays(self.bodies[name]))

    def body(self, name: str, state: str) -> Body:
        """A body with the mass, size and moment of inertia that it has at a state."""
        return self._versions[state][name].body

    def since(self, name: str, state: str) -> str:
        """The state from which a body and all that it carries have their data; empty where these never change."""
        since = (self._versions[state][item].since for item in self.carried(name, state))
        return max(since, key=lambda name: self.timeline.order.get(name, -1))

    def altered(self, name: str, start: str, end: str) -> bool:
        """Whether a body's own data differ between two states."""
        return self._versions[start][name] != self._versions[end][name]

    def changing(self, name: str, state: str) -> bool:
        """Whether the data of a body, or of what it carries, change in the phase of a state; what slides freely always goes on."""
        phase = self.timeline.phase_of(state)
        if any(item.free and item.carrier.owner == name for item in self.rides(state)) or self.laid(name):
            return True
        return phase is not None and self.since(name, phase.start) != self.since(name, phase.end)

    @cached_property
    def surfaces(self) -> dict[str, Surface]:
        return {surface.name: surface for surface in self.problem.surfaces}

    @cached_property
    def _absent(self) -> dict[str, frozenset[str]]:
        return absent(self.problem, self.timeline)

    @cached_property
    def begun(self) -> tuple[Connection, ...]:
        """The connections that events begin."""
        return begun(self.problem)

    @cached_property
    def held(self) -> dict[str, str]:
        """By body that an axle or hinge holds from the start: what that is called."""
        return {ref.owner: item.name for item in self.problem.connections for ref in item.fixed_points()}

    @remembered
    def connections(self, state: str) -> tuple[Connection, ...]:
        """Connections that act at a state, those too by which events hold bodies."""
        after = self.timeline.after(state)
        gone = self._absent[state] | frozenset(after.without if after and after.event is None else ())
        added = [item for event in self.events(state) for item in event.adds()]
        return (*[item for item in self.problem.connections if item.name not in gone], *added)

    def connection(self, name: str, state: str) -> Connection | None:
        """The connection of that name, where it acts at a state."""
        return next((item for item in self.connections(state) if item.name == name), None)

    def events(self, state: str) -> list[Event]:
        """What has happened up to a state."""
        passed = self.timeline.intervals[: self.timeline.order[state]]
        return [interval.event for interval in passed if interval.event is not None]

    def actions(self, state: str) -> tuple[Action, ...]:
        """Actions that act at a state; one that lasts from one state to another acts from the first until before the last."""
        order, now = self.timeline.order, self.timeline.order[state]
        last = self.timeline.after(state) is None
        result = []
        for item in self.problem.actions:
            if item.name in self._absent[state]:
                continue
            begins = order.get(item.from_ or "", 0)
            ends = order.get(item.to or "", len(order))
            if begins <= now < ends or (last and begins <= now <= ends):
                result.append(item)
        return tuple(result)

    def acting(self, state: str) -> tuple[Connection | Action, ...]:
        """All that acts on bodies at a state."""
        return (*self.connections(state), *self.actions(state))

    def present(self, state: str) -> tuple[Body, ...]:
        """Bodies that are there at a state and stand for themselves (a joined body belongs to its host)."""
        away = self._absent[state] | {member.name for member in self.members(state)}
        return tuple(self.body(body.name, state) for body in self.problem.bodies if body.name not in away)

    @remembered
    def members(self, state: str) -> tuple[Member, ...]:
        """Bodies joined to others by a weld, or by an event up to this state; those that ride on another turn with it."""
        riders = [rider(item, self.pivot(item.carrier.owner, state)) for item in self.rides(state)]
        joined = [item.joined() for item in self.connections(state)]
        joined += [event.joined() for event in self.events(state)]
        pairs = [pair for pair in joined if pair]
        held = frozenset(ref.owner for item in self.connections(state) for ref in item.fixed_points()) if pairs else ()
        return (*riders, *(welded(first, second, held, self.bodies) for first, second in pairs))

    def rides(self, state: str) -> tuple[Ride, ...]:
        """The bodies that slide along others at a state."""
        return tuple(ride for item in self.connections(state) if (ride := item.ride()) is not None)

    def ride(self, name: str, state: str) -> Ride | None:
        """How a body slides along another, with which it turns."""
        return next((item for item in self.rides(state) if item.rider.owner == name), None)

    @remembered
    def host(self, name: str, state: str) -> str:
        """The body that carries `name` at a state: itself, unless joined."""
        hosts = {member.name: member.host for member in self.members(state)}
        while name in hosts:
            name = hosts[name]
        return name

    def cluster(self, host: str, state: str) -> tuple[Member, ...]:
        """All members that a host carries, nearest first."""
        members = self.members(state)
        direct = [member for member in members if member.host == host]
        return tuple(item for member in direct for item in (member, *self.cluster(member.name, state)))

    def carried(self, host: str, state: str) -> tuple[str, ...]:
        """A body and all that it carries, nearest first."""
        return (host, *(member.name for member in self.cluster(host, state)))

    @remembered
    def pivot(self, name: str, state: str) -> PointRef | None:
        """The point of a body that a hinge or axle holds to the ground."""
        held = (ref for item in self.connections(state) for ref in item.fixed_points() if ref.owner == name)
        return next(held, None)

    @remembered
    def hung(self, name: str, state: str) -> PointRef | None:
        """The point of a body at which a hinge or axle hangs it from another one, where no fixed one holds it."""
        if self.pivot(name, state) is not None:
            return None
        return next((ref for item in self.connections(state) for ref in item.joint()[1:] if ref.owner == name), None)

    def axis(self, name: str, state: str) -> str:
        """The support on whose axis a body turns."""
        held = (item for item in self.connections(state) for ref in item.fixed_points() if ref.owner == name)
        return next((item.name for item in held), "")

    def line(self, name: str, state: str) -> tuple[Heading, str] | None:
        """Direction of travel of a body that moves along a line, and the words for its positive sense."""
        body = self.bodies[name]
        if self.pivot(name, state) is not None:
            return None
        for item in self.connections(state):
            track = item.track(body, self, state)
            if track is not None:
                return track
        if self.orbit(name, state) is not None:
            return None
        if body.moves:
            return WORDS[body.moves], body.moves
        hangs = any(item.hangs(body) for item in self.connections(state))
        return (UP, "up") if hangs and self.problem.gravity is not None and self.problem.plane == "vertical" else None

    def drives(self, name: str, state: str) -> tuple[Drive, ...]:
        """The motions of a body that are given from outside."""
        host = self.host(name, state)
        found = tuple(
            Drive(item.name, host, word, function, component, self.sense(host, state))
            for item in self.connections(state)
            for owner, word, component, function in item.prescribes()
            if self.host(owner, state) == host
        )
        if not any(drive.component for drive in found):
            return found
        if self.cluster(host, state):
            raise Unsolvable(
                f"`{host}` is joined to another body: moving it so is not solved yet", span=self.bodies[host].span
            )
        if self.pivot(host, state) is not None:
            said = f"`{host}` is held by an axle or hinge: its centre of mass can not be moved as well"
            raise Unsolvable(said, span=self.bodies[host].span, help="give its angle, or its rates")
        line = self.line(host, state)
        return found if line is None else along_line(found, line[0], self.bodies[host].span)

    def sense(self, name: str, state: str) -> int:
        """+1 where a body's positive turn is counterclockwise: as declared, else as its rolling asks, else counterclockwise."""
        turns = self.bodies[name].turns
        if turns:
            return 1 if turns == "counterclockwise" else -1
        items = (*self.connections(state), *self.begun)
        naturals = (item.natural_turn(self.body(name, state), self, state) for item in items)
        return next((natural for natural in naturals if natural), 1)

    def orbit(self, name: str, state: str) -> Orbit | None:
        """The circle on which a body's centre travels: on a curved surface, where no flat one and no pivot holds it."""
        body, items = self.bodies[name], self.connections(state)
        if self.pivot(name, state) is not None or any(item.track(body, self, state) is not None for item in items):
            return None
        return next((orbit for item in items if (orbit := item.orbit(body, self, state)) is not None), None)

    @remembered
    def component(self, name: str, state: str) -> frozenset[str]:
        """All bodies connected to a body, over any number of connections, at a state."""
        host, neighbours = self.host(name, state), self._neighbours(state)
        found, pending = set(), [host]
        while pending:
            current = pending.pop()
            if current not in found:
                found.add(current)
                pending.extend(neighbours.get(current, ()))
        return frozenset(found)

    @remembered
    def _neighbours(self, state: str) -> dict[str, set[str]]:
        """By body: those to which a connection ties it."""
        found: dict[str, set[str]] = {}
        for item in self.connections(state):
            owners = {self.host(ref.owner, state) for ref in item.touches() if ref.owner in self.bodies}
            for owner in owners if not item.independent else ():
                found.setdefault(owner, set()).update(owners)
        return found

    @remembered
    def pace(self, name: str, state: str) -> str:
        """How the acceleration of a body's component varies in the phase of a state (see core.symbols)."""
        component = self.component(name, state)
        paces = [self._own_pace(member, state) for member in component]
        for item in self.acting(state):
            if any(self.host(ref.owner, state) in component for ref in item.touches() if ref.owner in self.bodies):
                paces.append(item.pace(self, state))
        return combined(paces)

    def _own_pace(self, name: str, state: str) -> str:
        if self.changing(name, state):
            return UNKNOWN
        if self.pivot(name, state) is not None:
            return "constant" if self.balanced(name, state) or not self.heavy else "position"
        return "constant"

    @property
    def heavy(self) -> bool:
        """Whether weight acts in the plane of motion."""
        return self.problem.gravity not in (None, ZERO) and self.problem.plane == "vertical"

    def balanced(self, name: str, state: str) -> bool:
        """Whether a body on an axis carries its centre of mass on that axis."""
        return not self.frame(name, state).cm.parts

    @remembered
    def span(self, name: str, state: str) -> str:
        """Where forces and accelerations of a body at a state belong: its phase while they are constant, else the state."""
        phase = self.timeline.phase_of(state)
        if phase is None or self.pace(name, state) != "constant":
            return state
        return phase.name

    def phase_start(self, state: str) -> str:
        """The state at which the phase of a state starts, or the state itself."""
        phase = self.timeline.phase_of(state)
        return phase.start if phase is not None else state

    def can_turn(self, name: str, state: str) -> bool:
        """Whether a body that no axis holds turns: a particle never, a body on a line only if it is round or said to turn."""
        body, own = self.body(name, state), self.frame(name, state)
        turning = body.turns is not None or rim_radius(body, None) is not None
        if any(drive.kinds == TURNING for drive in self.drives(name, state)):
            return True
        if all(piece.moment == ZERO and not tidy(piece.at - own.reference).parts for piece in own.pieces):
            return body.turns is not None and rim_radius(body, None) is not None
        return turning or (self.line(name, state) is None and self.orbit(name, state) is None)

    def swings_round(self, ref: PointRef, state: str) -> bool:
        """Whether a point goes round the reference of its body as that turns."""
        name, own = self.host(ref.owner, state), self.frame(self.host(ref.owner, state), state)
        held = self.pivot(name, state) is not None
        off = name != ref.owner or bool(tidy(locate(self.body(name, state), ref) - own.reference).parts)
        return off and (held or self.can_turn(name, state))

    def driven(self, name: str, state: str) -> bool:
        """Whether a couple acts on a body: a motor, friction in its axle, a belt."""
        turned = any(ref.owner == name for item in self.actions(state) for ref in item.touches())
        held = (item for item in self.connections(state) if any(ref.owner == name for ref in item.touches()))
        return turned or any(item.twists() for item in held)

    @remembered
    def frame(self, name: str, state: str) -> Frame:
        """The rigid body `name` at a state; its reference is the fixed pivot, else the centre of mass."""
        body, pivot = self.body(name, state), self.pivot(name, state)
        items = list(pieces(body))
        for member in self.cluster(name, state):
            if member.host == name:
                base, offset = locate(body, member.at), locate(self.body(member.name, state), member.own)
                own = self.frame(member.name, state).pieces
                items.extend(replace(item, at=tidy(base + item.at - offset)) for item in own)
        centre = centre_of_mass(tuple(items))
        reference = locate(body, pivot) if pivot is not None else centre
        return Frame(tuple(items), reference, polar(tidy(centre - reference)))
