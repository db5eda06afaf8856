"""Timeline: the named instants of a scene in order, the phases and events between neighbours, and what does not act at each state."""

from __future__ import annotations

from functools import cached_property
from itertools import pairwise

from msgspec import Struct

from rotsolve.language.elements import Connection, Event
from rotsolve.language.problem import Problem, State

OPEN = "later on"  # the end of the phase that a single state starts, where a function of time is asked for


class Interval(Struct, frozen=True):
    """What lies between two neighbouring states: a phase of motion, or an event that takes no time."""

    name: str
    start: str
    end: str
    event: Event | None = None
    without: tuple[str, ...] = ()


class Timeline(Struct, frozen=True, dict=True):
    """States and intervals in order; a scene without states has one nameless instant."""

    states: tuple[State, ...]
    intervals: tuple[Interval, ...]

    @property
    def named(self) -> tuple[str, ...]:
        """The states that the scene speaks of."""
        return tuple(state.name for state in self.states if state.name != OPEN)

    @cached_property
    def order(self) -> dict[str, int]:
        return {state.name: index for index, state in enumerate(self.states)}

    def state(self, name: str) -> State:
        return self.states[self.order[name]]

    def between(self, start: str, end: str) -> tuple[Interval, ...]:
        """The intervals from one state to a later one."""
        return self.intervals[self.order[start] : self.order[end]]

    def after(self, state: str) -> Interval | None:
        index = self.order[state]
        return self.intervals[index] if index < len(self.intervals) else None

    def before(self, state: str) -> Interval | None:
        index = self.order[state]
        return self.intervals[index - 1] if index else None

    def interval(self, name: str) -> Interval | None:
        return next((interval for interval in self.intervals if interval.name == name), None)

    def phase_of(self, state: str) -> Interval | None:
        """The phase whose motion a state belongs to: the one that it starts, else the one that it ends."""
        for interval in (self.after(state), self.before(state)):
            if interval is not None and interval.event is None:
                return interval
        return None


def timeline(problem: Problem) -> Timeline:
    """The timeline of a problem: neighbouring states are joined by a phase unless an event joins them."""
    states = problem.states or (State(""),)
    if len(states) == 1 and any(find.runs for find in problem.finds):
        states = (*states, State(OPEN))
    intervals = []
    for before, after in pairwise(states):
        event = next((item for item in problem.events if (item.from_, item.to) == (before.name, after.name)), None)
        phase = next((phase for phase in problem.phases if (phase.start, phase.end) == (before.name, after.name)), None)
        name = (event.name if event else "") or (phase.name if phase else f"{before.name} to {after.name}")
        intervals.append(Interval(name, before.name, after.name, event, phase.without if phase else ()))
    return Timeline(tuple(states), tuple(intervals))


def absent(problem: Problem, timeline: Timeline) -> dict[str, frozenset[str]]:
    """By state: what events have taken away, and the connections that one has yet to begin."""
    gone = frozenset(item.name for item in begun(problem))
    result = {timeline.states[0].name: gone}
    for interval in timeline.intervals:
        if interval.event is not None:
            gone = gone.union(interval.event.ends(problem.connections)).difference(interval.event.begins())
        result[interval.end] = gone
    return result


def begun(problem: Problem) -> tuple[Connection, ...]:
    """The connections that events begin."""
    names = {name for event in problem.events for name in event.begins()}
    return tuple(item for item in problem.connections if item.name in names)
