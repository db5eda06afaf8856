"""Arrangement: a problem in time: what is there and acts at which state, and what is known of its letters."""

from __future__ import annotations

from functools import cached_property, partial
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.sign import ACUTE, SignOracle
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.faults import Span, Unsolvable
from rotsolve.core.letters import letter_order
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import is_key
from rotsolve.language.bodies import Body, Ride, Surface
from rotsolve.language.elements import Action, Connection, Event
from rotsolve.language.problem import Problem
from rotsolve.motion.owndata import Version, versions
from rotsolve.motion.positive import is_angle, positive_letters
from rotsolve.motion.timeline import Mentions, Timeline, absent, begun, left_at, let_off, timeline

if TYPE_CHECKING:
    from rotsolve.core.passage import Alteration


class Arrangement(Struct, frozen=True, dict=True):
    """A problem with its timeline; answers what is connected to what at each state.

    `alteration` is what is changed on purpose in what the laws say of it; nothing, save where a mistake is looked for.
    `forward` names what holds a body by a friction that acts, by its numbers, the way in which that is counted, not against it.
    """

    problem: Problem
    alteration: Alteration | None = None
    forward: frozenset[str] = frozenset()

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
        return SignOracle(
            self.problem.values, self.positive, partial(limits_of_letters, self.problem), trials=self.problem.trials
        )

    def certain_sign(self, value: Formula, question: str, span: Span | None = None) -> int:
        """The sign on which it hangs what the scene is: answers the `question`, which is refused by name where nothing tells it.

        With what is asked for it is that which it has for a positive number, or for an acute angle; `supposed` holds it against the answer.
        """
        sign = self.signs.decide(value)
        if sign is None:
            asked = {item.name: ACUTE if is_angle(item) else "positive" for item in self.problem.givens if item.asked}
            if asked.keys() & value.symbols():
                sign = replace(self.signs, limits=lambda: {**self.signs.limits(), **asked}).by_letters(value)
            if sign is not None:
                self.supposed[value] = sign, question, span
                return sign
            sign = self.signs.side_at_trial(value)
            if sign is None:
                raise self.undecided(value, question, span)
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

    def altered(self, name: str, start: str, end: str) -> bool:
        """Whether a body's own data differ between two states."""
        return self._versions[start][name] != self._versions[end][name]

    @cached_property
    def surfaces(self) -> dict[str, Surface]:
        return {surface.name: surface for surface in self.problem.surfaces}

    @cached_property
    def _absent(self) -> dict[str, frozenset[str]]:
        return absent(self.problem, self.timeline)

    @cached_property
    def left(self) -> dict[str, tuple[Connection, ...]]:
        """By event: the contacts that bodies leave in it, since they go round with what they are joined to."""
        timeline, gone = self.timeline, self._absent
        events = (item for item in timeline.intervals if item.event is not None)
        return {item.name: left_at(item, self.problem, timeline, gone[item.start]) for item in events}

    @cached_property
    def begun(self) -> tuple[Connection, ...]:
        """The connections that events begin."""
        return begun(self.problem)

    @cached_property
    def held(self) -> dict[str, str]:
        """By body that an axle or hinge holds from the start: what that is called."""
        return {ref.owner: item.name for item in self.problem.connections for ref in item.fixed_points()}

    def throughout(self, name: str) -> tuple[str, ...]:
        """All states, where a connection acts at each of them; else none."""
        states = tuple(state.name for state in self.timeline.states)
        return states if all(self.connection(name, state) is not None for state in states) else ()

    @remembered
    def connections(self, state: str) -> tuple[Connection, ...]:
        """Connections that act at a state, those too by which events hold bodies; none of a body that is taken away, save an axle for
        the others on it."""
        phase = self.timeline.phase_of(state)
        gone = self._absent[state] | frozenset(phase.without if phase is not None else ())
        added = [item for event in self.events(state) for item in event.adds()]
        acting = (*[item for item in self.problem.connections if item.name not in gone], *added)
        away = gone & self.bodies.keys()
        return (
            tuple(item for item in acting if item.axial or not away & {ref.owner for ref in item.touches()})
            if away
            else acting
        )

    def connection(self, name: str, state: str) -> Connection | None:
        """The connection of that name, where it acts at a state."""
        return next((item for item in self.connections(state) if item.name == name), None)

    def events(self, state: str) -> list[Event]:
        """What has happened up to a state."""
        passed = self.timeline.intervals[: self.timeline.order[state]]
        return [event for interval in passed if interval.event is not None for event in interval.event.each()]

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

    @remembered
    def let_off(self, state: str) -> tuple[Connection, ...]:
        """The contacts on which bodies lay up to an event before a state."""
        return let_off(self.events(state), self.problem.connections)

    def acting(self, state: str) -> tuple[Connection | Action, ...]:
        """All that acts on bodies at a state."""
        return (*self.connections(state), *self.actions(state))

    def rides(self, state: str) -> tuple[Ride, ...]:
        """The bodies that slide along others at a state."""
        return tuple(ride for item in self.connections(state) if (ride := item.ride()) is not None)

    def ride(self, name: str, state: str) -> Ride | None:
        """How a body slides along another, with which it turns."""
        return next((item for item in self.rides(state) if item.rider.owner == name), None)

    @property
    def heavy(self) -> bool:
        """Whether weight acts in the plane of motion."""
        return self.problem.gravity not in (None, ZERO) and self.problem.plane == "vertical"

    def phase_start(self, state: str) -> str:
        """The state at which the phase of a state starts, or the state itself."""
        phase = self.timeline.phase_of(state)
        return phase.start if phase is not None else state


def limits_of_letters(problem: Problem) -> dict[str, str]:
    """What the keys of a scene say of the values of letters; what reads it is loaded when it is asked for."""
    from rotsolve.language.limited import limited_letters

    return limited_letters(problem)
