"""Following: the course of a scene from state to state: each state is the next instant at which all its lines hold."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import as_dense
from rotsolve.confirm.course.node import Astray, Budget, Node
from rotsolve.confirm.instant import STICKS, NoWay, placed
from rotsolve.confirm.model import Model
from rotsolve.confirm.numbers import value_of
from rotsolve.core.symbols import TIME
from rotsolve.elements.asked import is_touch
from rotsolve.elements.shapes import shape_of
from rotsolve.language.elements import Event
from rotsolve.language.problem import Problem, State

if TYPE_CHECKING:
    from rotsolve.confirm.course.blows import Blow
    from rotsolve.confirm.course.laps import FollowedPhase


BESIDE = 1e-3  # share of a letter, or in SI units where it is none, by which another one lies beside it
WITHIN = (0.5, 0.2, 0.8)  # parts of a step at which it is looked at whether something tips over


class Broken(NotConfirmed):
    """An answer with which a line of a state, or its own condition, does not hold."""


class Unbalanced(Broken):
    """A state that is said to be in balance, and is not where it is told to stand."""


class Course:
    """The states of a scene in order; each is worked out when someone asks, from the one before.

    The forces of the last state are those of what comes then, or, where it is taken as an `ending`, those of the phase that it ends.
    What nothing tells of the first state is at rest, or, with a `stir`, something else.
    """

    def __init__(
        self,
        problem: Problem,
        numbers: Mapping[str, float],
        budget: Budget,
        *,
        ending: bool = False,
        stir: float = 0.0,
    ) -> None:
        self.problem, self.budget, self.ending, self.stir = problem, budget, ending, stir
        self.letters: dict[str, Any] = {**problem.values, **numbers}
        self.numbers = numbers
        self.states = problem.states or (State(""),)
        self.names = [state.name for state in self.states]
        self._nodes: dict[str, Node | NotConfirmed] = {}
        self._untimed: set[str] = set()  # what was reached by its energy, without steps in time
        self._lost: dict[str, NotConfirmed] = {}  # of these what steps in time do not reach
        self._phases: dict[str, FollowedPhase] = {}  # by the state at which each begins
        self._blows: dict[str, Blow] = {}  # by the state to which each leads
        self._models: dict[str, Model] = {}

    def model(self, name: str) -> Model:
        if name not in self._models:
            self._models[name] = Model(self.problem, self.numbers, name)
        return self._models[name]

    def value(self, formula: Formula) -> float:
        """The number of a formula of givens."""
        return float(value_of(formula, self.letters))

    def node(self, name: str) -> Node:
        """The instant of a state."""
        if name not in self._nodes:
            try:
                self._nodes[name] = node = self._reached(self.names.index(name))
                self._standing(node, self._blows.get(name))
                self._sticking(node)
            except NotConfirmed as reason:
                self._nodes[name] = reason
        found = self._nodes[name]
        if isinstance(found, NotConfirmed):
            raise found
        return found

    @cached_property
    def standing(self) -> bool:
        """Whether something stands with corners, or lies with ends, on something; what sees to it is loaded only then."""
        whole = [part for body in self.problem.bodies for part in (body, *(part.body for part in body.parts))]
        touches = any(is_touch(item) for item in self.problem.connections)
        if not touches or not any(shape_of(body).outline() for body in whole):
            return False
        from rotsolve.confirm.course.tipping import all_stands

        return any(True for state in self.states for _ in all_stands(self.model(state.name)))

    def _standing(self, node: Node, blow: Blow | None) -> None:
        """Whether all that stands with corners on something stays on them, through a blow too."""
        if self.standing:
            from rotsolve.confirm.course.tipping import check_standing, check_struck

            if blow is not None:
                check_struck(blow)
            check_standing(node)

    def _sticking(self, node: Node) -> None:
        """Whether what a state says to stick or to roll goes on so; right before a blow it has no time to slip."""
        state = node.model.acting.state
        held = next((line for line in state.conditions if line.word in ("sticks", "rolls")), None)
        if held is None or any(event.from_ == state.name for event in self.problem.events):
            return
        try:
            _ = node.moment
        except NoWay:
            from rotsolve.confirm.course.astray import SlipsOn

            raise SlipsOn(held.path.owner if held.path is not None else held.owner, state.name) from None

    def _standing_between(self, phase: FollowedPhase) -> None:
        """The same within the steps from one state to the next."""
        if self.standing:
            from rotsolve.confirm.course.tipping import check_standing

            for lap in phase.laps:
                for part in WITHIN if len(lap.step.pushes) > 1 else WITHIN[:1]:
                    check_standing(lap.at(part))

    def _reached(self, number: int) -> Node:
        """A state by its event from the one before; by its own lines where it is the first or in balance; else by following the motion."""
        state = self.states[number]
        model = self.model(state.name)
        event = self.event(self.names[number - 1], state.name) if number else None
        if event is None and (number == 0 or state.balance or state.steady):
            alone = self._met(self._alone(model), number)
            return self._gone_on(alone, number) if number and not self.states[number - 1].stands else alone
        before = self.node(self.names[number - 1])
        if event is not None:
            return self._struck(before, event, model, state)
        earlier = self._phases.get(self.names[number - 2]) if number > 1 else None
        if earlier is not None and (name := earlier.creeping()):
            raise NotConfirmed(f"`{name}` comes to `{self.names[number - 1]}` ever more slowly")
        from rotsolve.confirm.course.energy import by_energy

        found = None if before.adrift or self.standing else by_energy(before, state)
        if found is not None:
            self._untimed.add(state.name)
            return Node(model, found.placed, self.budget)
        from rotsolve.confirm.course.phase import followed, stays

        first = self._begun(number - 1)
        if stays(first, state):
            self._untimed.add(state.name)
            return Node(model, first.placed, self.budget)
        phase = followed(self._set_out(first, state), state)
        self._standing_between(phase)
        self._phases[self.names[number - 1]] = phase
        last = self.ending and number == len(self.states) - 1
        return Node(model, phase.end.placed, self.budget, phase.modes if last else None)

    def _set_out(self, first: Node, state: State) -> Node:
        """The instant from which a motion is followed; what the least push drives comes to its next state nobody knows when."""
        lines = state.conditions
        places = (line for line in lines if line.path is not None and line.path.quantity == "angle")
        if len(lines) > 1 or not (any(line.word == "leaves" for line in lines) or any(places)):
            return first
        from rotsolve.confirm.course.nudged import barely_moving

        found = barely_moving(first, state)
        if found is not None:
            self._untimed.add(state.name)
            self._lost[state.name] = NotConfirmed(f"the least push decides when `{state.name}` is")
        return found or first

    def _begun(self, number: int) -> Node:
        """The state from which a motion is followed: reached by steps in time, unless nothing there goes by the clock."""
        name = self.names[number]
        try:
            return self.timed(name)
        except NotConfirmed:
            timed = any(TIME in action.strength().symbols() for action in self.problem.actions)
            if timed or not (self.event(self.names[number - 1], name) if number else None):
                raise
            return self.node(name)

    def _gone_on(self, node: Node, number: int) -> Node:
        """A balance to which a motion leads: what nothing holds there goes on evenly."""
        from rotsolve.confirm.course.settling import as_it_went

        return as_it_went(node, self.node(self.names[number - 1]))

    def _met(self, node: Node, number: int) -> Node:
        """The first state right before an event that joins bodies: what flies towards the others is where they meet."""
        event = self.event(*self.names[:2]) if number == 0 and len(self.names) > 1 else None
        if event is None or not event.joined():
            return node
        from rotsolve.confirm.blow import met

        q = met(self.model(self.names[1]), node.placed, event).q
        return Node(node.model, replace(node.placed, q=q), self.budget)

    def timed(self, name: str) -> Node:
        """The instant of a state, reached by steps in time."""
        for number, state in enumerate(self.states[: self.names.index(name) + 1]):
            self.node(state.name)  # anew where steps in time have just led to the one before it
            if state.name not in self._untimed:
                continue
            if state.name in self._lost:
                raise self._lost[state.name]
            from rotsolve.confirm.course.phase import followed

            before = self.names[number - 1]
            try:
                self._phases[before] = phase = followed(self.node(before), state)
            except NotConfirmed as reason:
                self._lost[state.name] = reason
                raise
            self._untimed.discard(state.name)
            self._nodes[state.name] = Node(self.model(state.name), phase.end.placed, self.budget)
            for later in self.names[number + 1 :]:
                self._nodes.pop(later, None)
                self._untimed.discard(later)
        return self.node(name)

    def _alone(self, model: Model) -> Node:
        told = model.acting.state.time_told if model.acting.state.name == self.names[0] else None
        at = placed(model, time=0.0 if told is None else model.value(told), stir=self.stir)
        if at.clash:
            raise NotConfirmed("what the state says can not be fulfilled")
        first = Node(model, at, self.budget)
        for line in model.acting.state.conditions:
            path = line.path
            if path is not None and path.point is None and path.quantity == "velocity" and path.owner in model.seats:
                first.line(path.owner)  # refuses what two points of a body may mean
        if model.acting.state.steady and any(abs(rate) > 1e-5 * max(model.gravity, 1.0) for rate in first.moment.rates):
            raise NotConfirmed("how bodies stand that are steady it does not find")
        if not model.acting.state.balance:
            return first
        bare = self._without_leaving(first)
        if bare is not None:
            return bare
        from rotsolve.confirm.course.settling import settled

        rest = settled(first)
        if rest is None:
            raise Unbalanced(f"`{model.acting.state.name}` is not in balance")
        return rest

    def _without_leaving(self, first: Node) -> Node | None:
        """The instant without what the state says to push no more, where nothing tells how much it does: the rest alone balances then."""
        from rotsolve.confirm.course.gauges import line_owner

        state = first.model.acting.state
        leaving = {line_owner(line) for line in state.conditions if line.word in ("leaves", "slack")}
        if not leaving.intersection(owner for owner, _ in first.moment.open_reactions):
            return None
        left = tuple(item for item in self.problem.connections if item.name not in leaving)
        bare = Node(Model(replace(self.problem, connections=left), self.numbers, state.name), first.placed, self.budget)
        if any(abs(rate) > 1e-5 * max(bare.model.gravity, 1.0) for rate in bare.moment.rates):
            raise Unbalanced(f"`{state.name}` is not in balance")
        return bare

    def _struck(self, before: Node, event: Event, model: Model, state: State) -> Node:
        from rotsolve.confirm.course.blows import Blow

        if before.model.acting.state.balance:
            for owner in before.moment.unheld:
                raise Astray(f"`{owner}` lets go at `{before.model.acting.state.name}`: there is no balance")
        blow = Blow(before, event, model)
        self._blows[state.name] = blow
        check_lines(state, blow.after, before)
        return blow.after

    def event(self, first: str, last: str) -> Event | None:
        if not self.problem.events:
            return None
        from rotsolve.elements.at_once import event_between

        return event_between(self.problem.events, first, last)

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
        """How long it takes from one state to a later one; over phases that were followed that is told without the clock."""
        try:
            return self.timed(end).time - self.timed(start).time
        except NotConfirmed:
            self.node(end)
            names = self.names[self.names.index(start) : self.names.index(end) + 1]
            ways = [pair for pair in pairwise(names) if self.event(*pair) is None]
            if any(first not in self._phases for first, _ in ways):
                raise
            return sum(self._phases[first].end.time - self._phases[first].laps[0].at(0.0).time for first, _ in ways)

    def blow(self, start: str, end: str) -> Blow | None:
        """What the event between two neighbouring states did; None where none joins them."""
        self.node(end)
        return self._blows.get(end) if self.event(start, end) is not None else None

    def idle_event(self) -> bool:
        """Whether nothing changes in some event: a blow that is none, as one root of its equations mostly is."""
        blows = [self.blow(event.from_, event.to) for event in self.problem.events if event.from_ and event.to]
        told = [(blow.before.placed.speed, blow.after.placed.speed) for blow in blows if blow is not None]
        return any(all(abs(a - b) <= 1e-9 * max(1.0, abs(a)) for a, b in zip(*ends, strict=True)) for ends in told)

    def brought(self, start: str, end: str) -> list[tuple[Node, Node]]:
        """The instants before the events between two states, each with what the event joins as it was put before and where it meets."""
        names = self.names[self.names.index(start) : self.names.index(end) + 1]
        blows = [blow for pair in pairwise(names) if (blow := self.blow(*pair)) is not None and blow.event.joined()]
        return [(blow.before, blow.joining) for blow in blows]

    def settle(self, name: str) -> None:
        """All states are reached with the number of a letter that is asked for, and not with another one."""
        if name not in self.numbers:
            raise NotConfirmed(f"`{name}` has no number")
        try:
            self.hold()
        except Broken as reason:
            raise Broken(f"with it {reason}") from None
        size = abs(self.numbers[name]) or 1.0
        for step in (BESIDE * size, -BESIDE * size):
            other = Course(self.problem, {**self.numbers, name: self.numbers[name] + step}, self.budget)
            try:
                other.hold()
            except NotConfirmed:
                continue
            raise NotConfirmed(f"the lines of the states do not tell `{name}`")

    def hold(self) -> None:
        """NotConfirmed where a line of a state does not hold, nothing balances that should, or a mass is not that of its density."""
        for body in self.problem.bodies:
            if body.density is not None and not as_dense(body, self.value):
                raise Broken(f"`{body.name}` has not the mass that its density tells")
        for state in self.states:
            at = self.node(state.name)
            if state.balance:
                size = max(self.model(state.name).gravity, 1.0)
                if any(abs(rate) > 1e-5 * size for rate in at.moment.rates):
                    raise Broken(f"`{state.name}` is not in balance")
            check_lines(state, at, self.node(self.names[max(0, self.names.index(state.name) - 1)]))

    def varies(self, start: str, end: str) -> bool:
        """Whether accelerations or forces change on the way between two neighbouring states."""
        self.timed(end)
        phase = self._phases.get(start)
        return phase is not None and any(len(lap.step.pushes) > 1 for lap in phase.laps)

    def way(self) -> tuple[tuple[str, tuple[tuple[str, str], ...]], ...]:
        """How what rubs sticks and slips, at the states and on the ways between them, as far as they have been worked out."""
        nodes = ((name, node) for name, node in self._nodes.items() if isinstance(node, Node))
        known = [(name, [node.moment.modes]) for name, node in nodes if "moment" in vars(node)]
        known += [(name, [*(lap.modes for lap in phase.laps), phase.modes]) for name, phase in self._phases.items()]
        told = [(name, tuple(sorted(one.items()))) for name, modes in known for one in modes]
        return tuple(dict.fromkeys(told))

    def slips(self) -> str:
        """What first slips in another way, on the way between two states, in words; '' where nothing does."""
        for start, phase in self._phases.items():
            modes = [*(lap.modes for lap in phase.laps), phase.modes]
            for one, other in pairwise(modes):
                name = next((name for name, mode in other.items() if one.get(name, mode) != mode), None)
                if name is not None:
                    begins = "begins to slip" if one[name] == STICKS else "slips the other way"
                    what = "stops slipping" if other[name] == STICKS else begins
                    end = self.names[self.names.index(start) + 1]
                    return f"`{name.partition('.')[0]}` {what} on the way from `{start}` to `{end}`"
        return ""

    def holds_at_last(self) -> bool:
        """Whether what slips up to the last state does otherwise from there on: forces and accelerations there are those from then on."""
        phase = self._phases.get(self.names[-2]) if len(self.names) > 1 else None
        modes = {} if phase is None else self.node(self.names[-1]).moment.modes
        before = {} if phase is None else phase.modes
        return any(before.get(name, STICKS) not in (STICKS, mode) for name, mode in modes.items())

    def integral(self, start: str, end: str, rate: Callable[[Node], float]) -> tuple[float, float]:
        """∫ rate dt from one state to a later one, and ∫ |rate| dt."""
        self.timed(end)
        names = self.names[self.names.index(start) : self.names.index(end)]
        parts = [self._phases[name].integral(rate) for name in names if name in self._phases]
        return sum(part for part, _ in parts), sum(size for _, size in parts)


def check_lines(state: State, at: Node, before: Node) -> None:
    """Broken where a line of a state does not hold."""
    from rotsolve.confirm.course.gauges import HOLDS, gauges

    for gauge in gauges(state, at.model, before):
        if not gauge.passing and abs(gauge.value(at)) > HOLDS * gauge.size:
            raise Broken(f"`{gauge.words}` is not so at `{state.name}`")
