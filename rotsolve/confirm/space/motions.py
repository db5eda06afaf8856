"""Motions: the ways in which all moves at each state of a scene in space, by its lines, by blows, or by following the motion to it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import partial
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed, TooFar, Unfit
from rotsolve.confirm.course.sizes import letters_open
from rotsolve.confirm.space.arriving import ROUND_THE_AXIS, hold_lines
from rotsolve.confirm.space.arrows import arrow_length, less
from rotsolve.confirm.space.readings import Reading
from rotsolve.confirm.space.rig import NODAL, NOW, Lines, Told, is_told_rate
from rotsolve.confirm.space.rigs import OPEN, Rigs, time_after
from rotsolve.confirm.space.stance import Stance
from rotsolve.confirm.space.ties import ROUND, SPEED, TURNING
from rotsolve.confirm.space.worlds import Manner, World, manners_of
from rotsolve.language.elements import Event
from rotsolve.language.problem import ANY_TIME, EXTREMES, Condition, Find, Path, Problem, State, Term

if TYPE_CHECKING:
    from rotsolve.confirm.space.flight import Flight

AGREE = 1e-7  # of the larger of two numbers that are one
HOLDS = 1e-7  # what may be left of equations that hold, beside the largest number in them
TIED = (
    *NODAL,
    "angle",
    "angular_velocity",
    "angular_acceleration",
    "velocity",
    "acceleration",
    "position",
    "vertical",
    "time",
)
READ = (
    "force",
    "torque",
    "momentum",
    "angular_momentum",
    "kinetic_energy",
    "energy",
    "speed",
    "impulse",
    "angular_impulse",
)  # lines held against worlds
OF_MASS = ("inertia_tensor", "inertia", "principal_moments", "mass")  # what a body has however it moves
HANGING = "rates that nothing tells, beside what is asked"
SEVERAL = "several motions fit its state"
BROKEN = "the lines of its state do not go together"
NO_WAY = "no steady motion has these numbers"
CHANGE, LOST, SIZE_OF_CHANGE = "change of", "lost", "size of change of"
PATHS = "what happens between two states in space"


class LeftOpen(NotConfirmed):
    """What the lines of a state do not tell, so that only the motion may that leads to it."""


class WaysOfMoving(Rigs):
    """The ways in which all moves at one set of numbers; `put` are answers in place of what no line of a state tells."""

    def __init__(self, problem: Problem, numbers: Mapping[str, float], put: Told) -> None:
        super().__init__(problem, numbers)
        self.put, self.finely = put, False  # whether motions are followed as nearly as floats allow
        self._ways: dict[str, list[Manner]] = {}
        self._kept: dict[str, Any] = {}  # what comes of following a motion, or why nothing does

    def ways(self, name: str | None) -> list[Manner]:
        """The ways in which all moves at a state, in which all its lines hold."""
        key = name or ""
        if key not in self._ways:
            state = self.state(name)
            found = self._found(state)
            if state is not None:
                self.check_senses(state)
            self._ways[key] = found
        return self._ways[key]

    def check_senses(self, state: State) -> None:
        """Refuse rates that a later state tells in a sense in which the motion from the one before never comes there: what is kept on the
        way knows their squares alone."""
        place = self.problem.states.index(state)
        rated = any(
            is_told_rate(line) and self.rig.value(line.value) for line in state.conditions if line.value is not None
        )
        if (
            not (place and rated and self.follows)
            or state.steady
            or self.event_to(state.name) is not None
            or self.by_time(state.name)
        ):
            return
        from rotsolve.confirm.space.flight import SIGNS

        for flight in () if self.driven else self.flights_as_told(self.problem.states[place - 1], state):
            flight.exact = SIGNS
            flight.arrival(signs=True)

    def stance_at(self, name: str | None) -> Stance:
        return self.ways(name)[0].worlds[0].stance

    def steady_ways(self, name: str | None) -> list[Manner]:
        """All steady motions at a state, whichever it chooses itself: among them a question for the largest or the smallest looks."""
        state = self.state(name)
        return self._found(state, chosen=False) if state is not None and state.steady else self.ways(name)

    def _found(self, state: State | None, *, chosen: bool = True) -> list[Manner]:
        event = None if state is None else self.event_to(state.name)
        rig = self.rig_at(state)
        found = manners_of(rig, state, self.put) if event is None else self.struck(event, state, self.ways(event.from_))
        if not found:
            raise Unfit(NO_WAY)
        held = [way for way in found if way.clash <= HOLDS]
        lines = () if state is None else state.conditions
        for line in (line for line in lines if line.path is not None and (chosen or line.word not in EXTREMES)):
            held = list(self.fitting(held, line))
        if not held:
            raise Unfit(BROKEN)
        return held

    def slowest(self, find: Find) -> int | None:
        """Which of the ways at the state of a question is that of the slowest precession, which a fast spin has; None of others."""
        at = next((term.at for term in find.terms), None) or next((state.name for state in self.problem.states), None)
        ways = self.ways(at)
        lines = ways[0].worlds[0].stance.lines
        leaning = [Path(name, "precession") for name in self.rig.bodies if lines.nods(name)]
        rates = [max((abs(told_by(way, Term(path))) for path in leaning), default=0.0) for way in ways]
        return rates.index(min(rates)) if leaning else None

    def struck(self, event: Event, state: State | None, before: list[Manner]) -> list[Manner]:
        """The ways in which all moves just after a blow."""
        from rotsolve.confirm.space.passing import after_blow

        rig = self.rig_since(event.to or "")
        return [after_blow(rig, event, way, state, self.put) for way in before]

    def followed(self, name: str | None) -> list[Manner]:
        """The way in which all moves at a state to which the motion leads from the one before."""
        key = f"{name} by motion"
        names = [state.name for state in self.problem.states]
        place = names.index(name) if name in names else 0
        if not place or any(phase.without for phase in self.problem.phases):
            raise LeftOpen(OPEN)
        state, event = self.problem.states[place], self.event_to(names[place])
        if event is not None:
            return self.struck(event, state, self.followed(event.from_))
        told = time_after(state)
        passed = None if told is None else self.rig.value(told)
        try:
            ways = [self.kept(key, lambda: self.led_to(names[place - 1], state, passed))]
            self.check_letters(names[place - 1], state)
            return ways
        except NotConfirmed as reason:
            if self.tells_in_time(name):  # by what stays its lines would be taken as they are
                raise
            with suppress(NotConfirmed):
                found: list[Manner] = self.kept(
                    f"{name} by what stays", partial(self.by_what_stays, names[place - 1], state)
                )
                return found
            raise reason

    def check_letters(self, before: str, state: State) -> None:
        """Refuse what sets out away from its state while letters have no numbers: whether it turns back hangs on them."""
        from rotsolve.confirm.space.kept import sets_out_away

        if letters_open(self.problem) and any(
            sets_out_away(self.rig_since(before), world, state) for way in self.ways(before) for world in way.worlds
        ):
            raise NotConfirmed("it sets out away from its state, and whether it turns back hangs on letters")

    def by_what_stays(self, before: str, state: State) -> list[Manner]:
        """The ways in which all moves at a later state, by what stays on the way, where that is too long to be followed."""
        from rotsolve.confirm.space.kept import kept_manners

        starts = [by_velocities(way.worlds) for way in self.ways(before)]
        if len(starts) != 1 or len(starts[0]) != 1 or starts[0][0].stance.open:
            raise NotConfirmed(SEVERAL)
        return kept_manners(self.rig_since(before), starts[0][0], state, self.put)

    def kept(self, key: str, follow: Callable[[], Any]) -> Any:
        """What comes of following a motion, which is done once."""
        if key not in self._kept:
            try:
                self._kept[key] = follow()
            except (NotConfirmed, Unfit) as reason:
                self._kept[key] = reason
        found = self._kept[key]
        if isinstance(found, (NotConfirmed, Unfit)):
            raise found
        return found

    def running(self, phase: str | None) -> list[Manner]:
        """The way in which all moves at the time at which functions of time are looked at, in a phase or in the only one."""
        states = self.problem.states
        start = next((item.start for item in self.problem.phases if item.name == phase), None)
        begin = next((item for item in states if item.name == start), states[0] if states else None)
        clock = None if begin is None else self.clock(begin)
        if begin is None or clock is None or (phase is not None and start is None):
            raise NotConfirmed("a function of time")
        end = next(iter(states[states.index(begin) + 1 :]), None)
        over = None if end is None else self.clock(end)
        if not clock <= NOW <= (NOW if over is None else over):
            raise NotConfirmed("a function of time, in a phase at other times than are looked at")
        return [self.kept(f"{begin.name} on", lambda: self.led_on(begin.name, State(ANY_TIME), NOW - clock))]

    def led_to(self, name: str, state: State, passed: float | None) -> Manner:
        """Where the motion from one state leads at a later one; Unfit where what that tells beside its time does not hold there."""
        way, before = self.led_on(name, state, passed), self.state(name)
        if passed is not None and before is not None:
            hold_lines(self.rig_since(name), way.worlds, state, partial(self.whole_turns, before, passed=passed))
        return way

    def whole_turns(self, before: State, line: Condition, gap: float, passed: float) -> float:
        """By how much an angle round an axis is off, with the whole turns that a steady motion from a state that tells it makes in a time;
        of all else as it is."""
        path = line.path
        if path is None or path.quantity not in ROUND_THE_AXIS or not before.steady or line.value is None:
            return gap
        begun = Lines(self.rig, before, {}).line(path.owner, path.quantity)
        if begun is None or begun.value is None:
            return gap
        rate = told_by(self.ways(before.name)[0], Term(replace(path, quantity=ROUND_THE_AXIS[path.quantity])))
        counted = self.rig.value(begun.value) + rate * passed - self.rig.value(line.value)
        return gap + ROUND * round((counted - gap) / ROUND)

    def led_on(self, name: str, state: State, passed: float | None) -> Manner:
        """Where the motion from one state leads: to a later one, or for a time; by every choice of what is open, where time alone tells."""
        if passed is not None and self.driven:
            from rotsolve.confirm.space.led import manner_as_led

            way = manner_as_led(self, name, state, passed)
            if way is not None:
                return way
        return Manner(tuple(flight.arrival() for flight in self.flights(name, state, passed)), 0.0)

    def flights(self, name: str, state: State, passed: float | None) -> list[Flight]:
        """The motions from one state on."""
        from rotsolve.confirm.space.flight import Flight

        before = self.ways(name)
        if len(before) == 1 and len(by_velocities(before[0].worlds)) > 1:
            try:
                before = self.followed(name)
            except LeftOpen:
                if passed is None and not travelling_alike(before[0].worlds):
                    raise
        if len(before) != 1:
            raise NotConfirmed(SEVERAL)
        several = passed is not None or len(by_velocities(before[0].worlds)) > 1
        starts = by_velocities(before[0].worlds)[: 2 if several else 1]
        return [Flight(self.rig_since(name), world, state, passed, finely=self.finely) for world in starts]

    def flights_as_told(self, before: State, state: State) -> list[Flight]:
        """The motion from one state to the next, by choices of what nothing tells; nothing where what is told leaves several."""
        try:
            return self.flights(before.name, state, None)
        except TooFar:
            raise
        except NotConfirmed:
            return []

    def lasting(self, start: str, end: str) -> float:
        """The time from one state to a later one, by the motion from each to the next."""
        states = [state.name for state in self.problem.states]
        names = states[states.index(start) : states.index(end) + 1]
        if not names or any(event.from_ in names[:-1] for event in self.problem.events):
            raise NotConfirmed(PATHS)
        return float(sum(self.kept(" to ".join(way), partial(self.way_time, *way)) for way in pairwise(names)))

    def gone_round(self, start: str, end: str, name: str) -> float | None:
        """How far the axis of a body goes round the vertical from one state to a later one; None where the states tell it."""
        states = [state.name for state in self.problem.states]
        names = states[states.index(start) : states.index(end) + 1]
        lines = (line.path for state in self.problem.states for line in state.conditions if state.name in names)
        words = {path.quantity for path in lines if path is not None}
        if {"precession_angle", "time"} & words or any(event.from_ in names[:-1] for event in self.problem.events):
            return None
        return float(
            sum(self.kept(" round to ".join(way), partial(self.way_round, name, *way)) for way in pairwise(names))
        )

    def way_round(self, name: str, start: str, end: str) -> float:
        state = self.state(end)
        assert state is not None
        (flight,) = self.flights(start, state, None)
        flight.counted = name
        flight.arrival()
        return flight.gone

    def way_time(self, start: str, end: str) -> float:
        state = self.state(end)
        assert state is not None
        told = time_after(state)
        if told is not None:
            return self.rig.value(told)
        (flight,) = self.flights(start, state, None)
        flight.arrival()
        return flight.clock

    def fitting(self, ways: Sequence[Manner], line: Condition) -> Iterator[Manner]:
        """The ways in which a line holds."""
        assert line.path is not None
        if line.word in EXTREMES:
            numbers = [Reading(way.worlds[0]).number(Term(line.path)) for way in ways]
            least = min(numbers, default=0.0) if line.word == "smallest" else max(numbers, default=0.0)
            yield from (way for way, number in zip(ways, numbers, strict=True) if number == least)
        elif line.path.quantity in TIED and not (
            line.path.quantity in NODAL and line.path.owner in self.rig.about_momentum
        ):
            yield from ways
        elif line.path.quantity not in (*READ, *NODAL) or line.value is None or line.relative:
            raise NotConfirmed(f"a line about `{line.path.quantity}`")
        else:
            told = self.rig.value(line.value)
            for way in ways:
                number = told_by(way, Term(line.path, axes=line.axes or None))
                if abs(number - told) <= AGREE * max(abs(told), abs(number), 1e-3):
                    yield way


def by_velocities(worlds: Sequence[World]) -> list[World]:
    """One world of each choice of velocities."""
    return list({id(world.now): world for world in reversed(worlds)}.values())[::-1]


def travelling_alike(worlds: Sequence[World]) -> bool:
    """Whether worlds differ in nothing but a velocity that all bodies have more, so that all goes on in the same way."""
    first, *others = by_velocities(worlds)
    names = list(first.stance.rig.bodies)
    for other in others:
        more = [less(other.now.arrow(SPEED, name), first.now.arrow(SPEED, name)) for name in names]
        turned = [less(other.now.arrow(TURNING, name), first.now.arrow(TURNING, name)) for name in names]
        if any(arrow_length(way) > AGREE for way in turned):
            return False
        if any(arrow_length(less(way, more[0])) > AGREE * (1.0 + arrow_length(more[0])) for way in more):
            return False
    return True


def told_by(way: Manner, term: Term) -> float:
    """The number of a term in all worlds of a way; NotConfirmed where they differ, since they differ in nothing that is told."""
    readings = [Reading(world) for world in way.worlds]
    numbers = [reading.number(term) for reading in readings]
    if len(numbers) > 1 and max(numbers) - min(numbers) > AGREE * max(reading.size(term) for reading in readings):
        raise LeftOpen(OPEN)
    return numbers[0]
