"""Following: the course of a scene from state to state: each state is the next instant at which all its lines hold."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.node import Budget, Node
from rotsolve.confirm.course.phase import FollowedPhase, followed
from rotsolve.confirm.instant import placed
from rotsolve.confirm.model import Model
from rotsolve.language.elements import Event
from rotsolve.language.problem import Problem, State


class Course:
    """The states of a scene in order; each is worked out when someone asks, from the one before."""

    def __init__(self, problem: Problem, numbers: Mapping[str, float], budget: Budget) -> None:
        self.problem, self.budget = problem, budget
        self.letters: dict[str, Any] = {**problem.values, **numbers}
        self.numbers = numbers
        self.states = problem.states or (State(""),)
        self.names = [state.name for state in self.states]
        self._nodes: dict[str, Node | NotConfirmed] = {}
        self._phases: dict[str, FollowedPhase] = {}  # by the state at which each begins
        self._blows: dict[str, Any] = {}
        self._models: dict[str, Model] = {}

    def model(self, name: str) -> Model:
        if name not in self._models:
            self._models[name] = Model(self.problem, self.numbers, name)
        return self._models[name]

    def node(self, name: str) -> Node:
        """The instant of a state."""
        if name not in self._nodes:
            try:
                self._nodes[name] = self._reached(self.names.index(name))
            except NotConfirmed as reason:
                self._nodes[name] = reason
        found = self._nodes[name]
        if isinstance(found, NotConfirmed):
            raise found
        return found

    def _reached(self, number: int) -> Node:
        """A state by its own lines where it is the first or in balance; by its event, or by following the motion, from the one before."""
        state = self.states[number]
        model = self.model(state.name)
        if number == 0 or state.balance or state.steady:
            return self._alone(model)
        before = self.node(self.names[number - 1])
        event = self.event(self.names[number - 1], state.name)
        if event is not None:
            return self._struck(before, event, model, state)
        phase = followed(before, state)
        self._phases[self.names[number - 1]] = phase
        return Node(model, phase.end.placed, self.budget)

    def _alone(self, model: Model) -> Node:
        at = placed(model)
        if at.clash:
            raise NotConfirmed("what the state says can not be fulfilled")
        return Node(model, at, self.budget)

    def _struck(self, before: Node, event: Event, model: Model, state: State) -> Node:
        raise NotConfirmed(f"`{event.name}`: a blow")

    def event(self, first: str, last: str) -> Event | None:
        return next((event for event in self.problem.events if (event.from_, event.to) == (first, last)), None)

    def ends(self, name: str) -> tuple[str, str]:
        """The states of a phase or an event by its name."""
        for item in self.problem.phases:
            if item.name == name:
                return item.start, item.end
        for event in self.problem.events:
            if event.name == name and event.from_ is not None and event.to is not None:
                return event.from_, event.to
        raise NotConfirmed(f"`{name}` is no phase and no event")

    def time(self, start: str, end: str) -> float:
        return self.node(end).time - self.node(start).time

    def blow(self, start: str, end: str) -> Any:
        """What the event between two neighbouring states did; None where none joins them."""
        self.node(end)
        return self._blows.get(end) if self.event(start, end) is not None else None

    def settle(self, name: str) -> None:
        """All states are reached with the number of a letter that is asked for, and their lines hold."""
        raise NotConfirmed(f"`{name}` is a letter of the scene")

    def integral(self, start: str, end: str, rate: Callable[[Node], float]) -> tuple[float, float]:
        """∫ rate dt from one state to a later one, and ∫ |rate| dt."""
        self.node(end)
        names = self.names[self.names.index(start) : self.names.index(end)]
        parts = [self._phases[name].integral(rate) for name in names if name in self._phases]
        return sum(part for part, _ in parts), sum(size for _, size in parts)


class Blow(NamedTuple):
    """What an event did."""

    impulses: Mapping[tuple[str, str], float]
