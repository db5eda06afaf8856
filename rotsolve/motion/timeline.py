"""Timeline: the named instants of a scene in order, what lies between neighbours, what acts at none, and what the scene speaks of."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import pairwise

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.faults import Span
from rotsolve.core.quantity import INSIDE, MEAN_OF, OSCILLATING
from rotsolve.language.elements import Connection, Event
from rotsolve.language.problem import Path, Problem, State, Term, references

OPEN = "later on"  # the end of the phase that a single state starts, where a function of time is asked for


class Interval(Struct, frozen=True):
    """What lies between two neighbouring states: a phase of motion, or an event that takes no time."""

    name: str
    start: str
    end: str
    event: Event | None = None
    without: tuple[str, ...] = ()
    whole: str = ""  # the phase of the scene of which it is a part

    @property
    def names(self) -> tuple[str, ...]:
        """What it is called, and what happens in it."""
        return (self.name, *(item.name for item in (self.event.each() if self.event is not None else ())))


class Timeline(Struct, frozen=True, dict=True):
    """States and intervals in order; a scene without states has one nameless instant."""

    states: tuple[State, ...]
    intervals: tuple[Interval, ...]

    @property
    def named(self) -> tuple[str, ...]:
        """The states that the scene speaks of."""
        return tuple(state.name for state in self.states if state.name != OPEN and not state.opened)

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
        """That of a name; of several events at once by the name of each."""
        return next((interval for interval in self.intervals if name in interval.names), None)

    def at_rest(self, interval: Interval) -> bool:
        """Whether no motion leads from one state to the next, since all stands still at both: each is a case of its own."""
        return interval.event is None and all(self.state(name).stands for name in (interval.start, interval.end))

    def since(self, state: str) -> tuple[Interval, ...]:
        """The intervals that lead to a state from the one before that the scene speaks of."""
        index = last = self.order[state]
        while index and (index == last or self.states[index].opened):
            index -= 1
        return self.intervals[index:last]

    def told(self, interval: Interval) -> tuple[str, str]:
        """The states before and after an interval of which the scene speaks."""
        first, last = self.order[interval.start], self.order[interval.end]
        while self.states[first].opened:
            first -= 1
        while self.states[last].opened:
            last += 1
        return self.states[first].name, self.states[last].name

    def whole(self, name: str) -> tuple[str, str] | None:
        """The states from and to which a phase or event lasts; a phase also where its laws end before it does."""
        parts = [interval for interval in self.intervals if name == interval.whole or name in interval.names]
        return (parts[0].start, parts[-1].end) if parts else None

    def phase_of(self, state: str) -> Interval | None:
        """The phase whose motion a state belongs to: the one that it starts, else the one that it ends."""
        for interval in (self.after(state), self.before(state)):
            if interval is not None and interval.event is None:
                return interval
        return None


def timeline(problem: Problem) -> Timeline:
    """The timeline of a problem: neighbouring states are joined by a phase unless an event joins them."""
    states = problem.states or (State(""),)
    if sum(not state.opened for state in states) == 1 and any(find.runs for find in problem.finds):
        states = (*states, State(OPEN))
    intervals = []
    for number, (before, after) in enumerate(pairwise(states)):
        event = event_from(problem, before.name, after.name)
        if event is not None:
            intervals.append(Interval(event.name or f"{before.name} to {after.name}", before.name, after.name, event))
            continue
        first = next(state.name for state in reversed(states[: number + 1]) if not state.opened)
        last = next((state.name for state in states[number + 1 :] if not state.opened), after.name)
        phase = next((phase for phase in problem.phases if (phase.start, phase.end) == (first, last)), None)
        without, whole = (phase.without, phase.name) if phase else ((), f"{first} to {last}")
        parted = (first, last) != (before.name, after.name)
        name = f"{before.name} to {after.name}" if parted else whole
        intervals.append(Interval(name, before.name, after.name, None, without, whole if parted else ""))
    return Timeline(tuple(states), tuple(intervals))


def event_from(problem: Problem, first: str, last: str) -> Event | None:
    """What happens from one state to the next."""
    if not problem.events:
        return None
    from rotsolve.elements.at_once import event_between

    return event_between(problem.events, first, last)


def absent(problem: Problem, timeline: Timeline) -> dict[str, frozenset[str]]:
    """By state: what events have taken away, and the connections that one has yet to begin."""
    gone = frozenset(item.name for item in begun(problem))
    result = {timeline.states[0].name: gone}
    for interval in timeline.intervals:
        if interval.event is not None:
            left = (item.name for item in left_at(interval, problem, timeline, gone))
            gone = gone.union(interval.event.ends(problem.connections), left).difference(interval.event.begins())
        result[interval.end] = gone
    return result


def left_at(interval: Interval, problem: Problem, timeline: Timeline, gone: frozenset[str]) -> tuple[Connection, ...]:
    """The contacts that bodies leave in an event, of those that are not `gone` before it: as they go round with what they are joined to, or
    about a point that is suddenly held."""
    from rotsolve.motion.lifted import lifted

    if interval.event is None:
        return ()
    earlier = timeline.intervals[: timeline.order[interval.start]]
    present = [item for item in problem.connections if item.name not in gone]
    held = interval.event.ends(present) if interval.event.adds() or interval.event.begins() else ()
    about_it = [item for item in present if item.name in held and item.lying()]
    return (*lifted(interval.event, present, [item.event for item in earlier if item.event is not None]), *about_it)


def let_off(events: Sequence[Event], connections: Sequence[Connection]) -> tuple[Connection, ...]:
    """The contacts on which bodies lay before they were taken away."""
    gone = {name for event in events if event.lets_fly for name in event.ends(connections)}
    return tuple(item for item in connections if item.name in gone and item.lying())


def begun(problem: Problem) -> tuple[Connection, ...]:
    """The connections that events begin."""
    names = {name for event in problem.events for name in event.begins()}
    return tuple(item for item in problem.connections if item.name in names)


MEAN = ("mean", "speed")
RUNNING = ("total", "largest", "smallest")  # what a quantity does on its way is asked


def asks_integral(term: Term) -> bool:
    """Whether a mean is asked of which the laws have no sum: it is an integral over the quantity, at any moment of its phases."""
    return term.modifier == "mean" and (isinstance(term.by, Path) or term.path.quantity not in MEAN_OF)


class Mentions(Struct, frozen=True, dict=True):
    """The quantities that a problem's states and questions name."""

    problem: Problem
    timeline: Timeline

    @cached_property
    def functions(self) -> bool:
        """Whether the scene asks for a function of time."""
        return any(find.runs for find in self.problem.finds)

    @cached_property
    def runs(self) -> bool:
        """Whether what it asks takes the laws at any moment of a phase: functions of time, whole ways, extremes."""
        terms = [term for find in self.problem.finds for term in find.terms if find.where is None]
        return self.functions or any(
            term.modifier in RUNNING
            or term.path.quantity == "distance"
            or (term.modifier, term.path.quantity) == MEAN
            or asks_integral(term)
            for term in terms
        )

    def says(self, state: str, owner: str, *words: str) -> bool:
        """Whether a state speaks of a quantity of an element, or says a word about it."""
        lines = self.timeline.state(state).conditions
        said = ({line.path.quantity, line.word} for line in lines if line.path is not None and line.path.owner == owner)
        return any(found & set(words) for found in said)

    def told(self, state: str, owner: str, word: str) -> Formula | None:
        """The value that a state gives to a quantity of a body."""
        lines = self.timeline.state(state).conditions
        paths = ((line.value, line.path) for line in lines if line.path is not None and line.path.point is None)
        return next((value for value, path in paths if (path.owner, path.quantity) == (owner, word)), None)

    def values(self, owner: str, word: str) -> Iterator[Formula]:
        """The values that states tell of a quantity of an element."""
        for line in (line for state in self.timeline.states for line in state.conditions):
            if (
                line.path is not None
                and line.value is not None
                and (line.path.owner, line.path.quantity) == (owner, word)
            ):
                yield line.value

    def untold(self, owner: str, word: str) -> tuple[str, Span | None] | None:
        """The first later state that says nothing of a quantity of an element, with its place."""
        silent = (state for state in self.timeline.states[1:] if not self.says(state.name, owner, word))
        return next(((state.name, state.span) for state in silent), None)

    def asks(self, owner: str, word: str) -> bool:
        """Whether the scene asks for, or states, a quantity of an element."""
        return any(path.owner == owner and path.quantity == word for path in self.paths)

    @cached_property
    def paths(self) -> tuple[Path, ...]:
        """All quantities that the states and questions speak of, those of conditions too."""
        spoken_of = references((self.problem.states, self.problem.finds))
        return tuple(path for path in spoken_of if isinstance(path, Path))

    @cached_property
    def swings(self) -> bool:
        """Whether the scene speaks of a period or frequency of swings."""
        return any(path.quantity in OSCILLATING for path in self.paths)

    @cached_property
    def cuts(self) -> dict[str, Path]:
        """The points at which the scene asks what acts inside a rod, by the index that their letters get."""
        found: dict[tuple[str, str | None, Formula | None], Path] = {}
        for path in self.paths:
            if path.quantity in INSIDE:
                found.setdefault((path.owner, path.point, path.argument), path)
        letters = [path.argument.name if isinstance(path.argument, Symbol) else "cut" for path in found.values()]
        return {
            letter if letters.count(letter) == 1 else f"{letter}{number}": path
            for number, (letter, path) in enumerate(zip(letters, found.values(), strict=True), 1)
        }
