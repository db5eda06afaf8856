"""Rigs: what holds the bodies of a scene in space at each of its states, and at which time: events bring joints on the way."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from functools import cached_property

from rotsolve.algebra.formula import Formula
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.space.arrows import Turned, product_of, rows_back
from rotsolve.confirm.space.rig import Rig
from rotsolve.confirm.space.stance import Stance
from rotsolve.core.symbols import TIME
from rotsolve.language.bodies import Joint
from rotsolve.language.elements import Event
from rotsolve.language.joints import events_up_to
from rotsolve.language.problem import Problem, State

OPEN = "the equations of all bodies leave it open"


class Rigs(ABC):
    """The rigs of a scene at one set of numbers, by its states."""

    def __init__(self, problem: Problem, numbers: Mapping[str, float]) -> None:
        self.problem = problem
        self.rig = Rig(problem, numbers)
        self._rigs: dict[str, Rig] = {}

    @abstractmethod
    def stance_at(self, name: str | None) -> Stance:
        """How all bodies stand at a state."""

    def state(self, name: str | None) -> State | None:
        states = self.problem.states
        if name is None and len(states) > 1:
            raise NotConfirmed("at which state it is asked")
        if name is None:
            return states[0] if states else None
        return next(state for state in states if state.name == name)

    def rig_at(self, state: State | None) -> Rig:
        """The rig at the time of a state, where it is told; of a scene that names no state at 0, as at its first one."""
        clock, since = (0.0, self.rig) if state is None else (self.clock(state), self.rig_since(state.name))
        if clock is None:
            return since
        found = Rig(self.problem, {**self.rig.numbers, TIME: clock}, "" if state is None else state.name)
        found.seats = since.seats
        return found

    def rig_since(self, name: str) -> Rig:
        """The rig with the joints that events up to a state have brought, and bodies as they stood when they met."""
        if name not in self._rigs:
            joined = Rig(self.problem, self.rig.numbers, name)
            self._rigs[name] = self.rig if joined.joints == self.rig.joints else joined
            for event in events_up_to(self.problem, name):
                joint = joined.joints.get(event.name)
                if joint is not None and any(map(any, joined.solid(joint.body.owner).tensor)):
                    joined.seats |= self.met(event, joint)
        return self._rigs[name]

    def met(self, event: Event, joint: Joint) -> dict[str, Turned]:
        """How a body that an event joins to another one is turned along the axes of that."""
        carrier, name = joint.carrier.owner, joint.body.owner
        if carrier not in self.rig.bodies:
            return {}
        stance = self.stance_at(event.from_)
        if stance.open:
            raise NotConfirmed(OPEN)
        return {name: product_of(rows_back(stance.turned(carrier)), stance.turned(name))}

    def clock(self, state: State) -> float | None:
        """The running time at a state: through a blow as before, else so long after the state before as it tells; at the first one as
        told, else 0."""
        told, states = time_after(state), self.problem.states
        event = self.event_to(state.name)
        if event is not None:
            return self.clock(next(item for item in states if item.name == event.from_))
        start = self.clock(states[states.index(state) - 1]) if state is not states[0] else 0.0
        if told is None or start is None:
            return 0.0 if state is states[0] else None
        return start + self.rig.value(told)

    @cached_property
    def driven(self) -> bool:
        """Whether all bodies move as they are told to."""
        driven = {joint.body.owner for joint in self.rig.joints.values() if joint.drive}
        return all(name in driven or body.moved for name, body in self.rig.bodies.items())

    @property
    def follows(self) -> bool:
        """Whether motions from state to state are followed: not where a motor gives what it takes."""
        return not any(joint.motor for joint in self.rig.joints.values())

    def by_time(self, name: str | None) -> bool:
        """Whether the time from the state before tells how all moves at a later state, which is not driven."""
        names = [state.name for state in self.problem.states]
        place = names.index(name) if name in names else 0
        if not place or self.event_to(names[place]) is not None or self.driven:
            return False
        return time_after(self.problem.states[place]) is not None

    def tells_in_time(self, name: str | None) -> bool:
        """Whether a later state tells more than the time that leads to it: all else is to be held against where that leads."""
        state = next((state for state in self.problem.states[1:] if state.name == name), None)
        if state is None or self.event_to(state.name) is not None or time_after(state) is None:
            return False
        return any(line.path is None or line.path.quantity != "time" for line in state.conditions)

    def event_to(self, name: str) -> Event | None:
        """The event that leads to a state."""
        return next((item for item in self.problem.events if item.to == name), None)


def time_after(state: State) -> Formula | None:
    """The time that a state tells: a later one how long after the state before it is."""
    lines = (line for line in state.conditions if line.path is not None and line.path.quantity == "time")
    return next((line.value for line in lines), None)
