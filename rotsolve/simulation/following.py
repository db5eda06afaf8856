"""Following: a motion through all that happens on the way: each event ends one system of equations and begins the next."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence

from msgspec import Struct, field

from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.flints import fmpq
from rotsolve.algebra.tape import Exact
from rotsolve.core.symbols import TIME
from rotsolve.language.problem import State
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.rubs import rubs
from rotsolve.paths.meaning import NotYet
from rotsolve.simulation.beginning import scene_at, scene_from
from rotsolve.simulation.bounded import (
    FLOAT_BITS,
    SAFETY,
    Regime,
    States,
    Times,
    Tolerances,
    Unsettled,
    farthest,
    follow_regime,
    measure_bounds,
    start_of,
)
from rotsolve.simulation.compiling import compiled
from rotsolve.simulation.system import PlanarSystem, Readout, System
from rotsolve.simulation.tape import Scalar
from rotsolve.simulation.watches import BREAKS, REACHED, SLIPS, TURNS, Watch, is_told, place_on_tape, watches

READING_BITS = 192
STEPS_LEAVE_OUT = 100.0  # times their tolerance: how far an event may be from its moment by what the steps leave out
CROWD = 2000  # events before a motion is given up


class Occurrence(Struct, frozen=True):
    """Something that happens: when, how far that may be from the true moment, and what it is."""

    time: float
    bound: float
    what: str
    state: str = ""  # the state of the scene that is reached


class Followed(Struct):
    """A motion as far as it was followed; `ended` says why not further."""

    regimes: list[Regime] = field(default_factory=list)
    events: list[Occurrence] = field(default_factory=list)
    ended: str = ""
    sought: str = ""  # the last state of the scene that was looked for


class Follower(Struct, dict=True):
    """Follows a scene from its first state on."""

    configuration: Configuration
    until: float
    tolerances: Tolerances
    tell: Callable[[float], None] = lambda part: None  # is told which part has been followed

    def __post_init__(self) -> None:
        begins = self.configuration.timeline.states[0]
        if begins.time_told is not None:
            raise NotYet("a motion is followed from t = 0 on", begins.span, "leave out the `time` of the first state")
        first = self.configuration.timeline.after(begins.name)
        if first is not None and first.event is not None:
            raise NotYet(f"the motion begins with the event `{first.name}`, which is not simulated yet")
        self.found = Followed()
        self.ahead = list(self.configuration.timeline.states[1:])
        self.arrange()

    def arrange(self) -> None:
        """Takes the scene as it is at first."""
        self.scene = scene_from(self.configuration, self.configuration.timeline.states[0].name)
        self.modes = self.decided(self.scene)
        # of this scene, as it goes on from others: it sticks and slips again and again
        self.systems: dict[object, PlanarSystem] = {}

    def followed(self) -> Followed:
        """The motion up to the end asked for, or to where it can not go on."""
        system = self.begun()
        states = start_of(system, self.tolerances)
        times: Times = (0.0,) * len(states)
        since = self._coordinates(system, [item.start for item in system.variables], 0.0)
        sides: Sequence[Mapping[Watch, int]] = [{} for _ in states]
        while not self.found.ended and len(self.found.events) < CROWD:
            try:
                watched = self.looked_for(system, self.ahead[0] if self.ahead else None, since)
            except NotYet as error:
                if not self.found.regimes:
                    raise
                self.found.ended = str(error)
                break
            self.found.sought = next((item.what for item in watched if item.kind == REACHED), self.found.sought)
            part = follow_regime(system, times, states, self.until, self.tolerances, watched, sides, self.tell)
            self._enter(part)
            if part.hit is None:
                return self.found
            states, times = part.last, part.ends
            if part.hit.watch.kind == REACHED or part.hit.also:
                since = self._coordinates(system, states[0], times[0])
            before, watch = system, part.hit.watch
            for _ in part.hit.also:
                self._reconfigured(self.ahead.pop(0))
            system, states = self._after(watch, part, states, times)
            sides = part.sides if system is before else [{} for _ in states]
        if not self.found.ended:
            raise Unsettled(times[0])
        return self.found

    def begun(self) -> System:
        """The system of its first state."""
        return compiled(self.scene, self.modes)

    def looked_for(self, system: System, ahead: State | None, since: Mapping[str, Exact]) -> list[Watch]:
        """All that may happen in a system, the next state of the scene among it."""
        assert isinstance(system, PlanarSystem)
        return watches(system, self.modes, ahead, since)

    def decided(self, scene: Configuration, at_rest: Collection[str] = ()) -> dict[str, str]:
        """Which contacts stick and which slip, decided as for any scene that starts so."""
        if not rubs(scene):
            return {}
        from rotsolve.search.friction import decide

        return decide(scene, at_rest).modes

    def _enter(self, part: Regime) -> None:
        """A part that has been followed, with what ends it; bounds never shrink from one part to the next."""
        before = dict.fromkeys((item.name for item in part.system.variables), 0.0)
        if self.found.regimes:
            last = self.found.regimes[-1]
            before.update(zip((item.name for item in last.system.variables), last.bounds[-1], strict=True))
        with Precision(self.tolerances.bits):
            measure_bounds(part, [before[item.name] for item in part.system.variables])
        self.found.regimes.append(part)
        bound = SAFETY * farthest(part.ends[0], part.ends[1:]) + 4 * 2.0**-52 * part.ends[0]
        for watch in (part.hit.watch, *part.hit.also) if part.hit is not None else ():
            if watch.kind != TURNS:
                state = watch.what if watch.kind == REACHED else ""
                self.found.events.append(Occurrence(part.ends[0], bound, watch.what, state))

    def _after(self, hit: Watch, part: Regime, states: States, times: Times) -> tuple[System, States]:
        """The system that follows an event at the end of a part, and the states of all runs in its numbers."""
        system = part.system
        if hit.kind == BREAKS:
            self.found.ended = f"{hit.what}: what comes after that is not followed"
        if hit.kind in (BREAKS, TURNS) or (hit.kind == REACHED and not self._reconfigured(self.ahead.pop(0))):
            return system, states
        if hit.kind == SLIPS and hit.rub is not None:
            self.modes = {**self.modes, hit.rub.key: hit.mode}
        else:
            numbers = {name: float(ball.mid()) for name, ball in self._read(system, states[0], times[0]).items()}
            self.modes = self.decided(scene_at(self.scene, times[0], numbers), self._at_rest(part, hit))
        following = self._going_on(system)
        carried = (self._carried(system, following, state, time) for state, time in zip(states, times, strict=True))
        return following, tuple(carried)

    def _going_on(self, system: System) -> System:
        """The system that goes on from another one; it depends on that one's coordinates and their origins alone."""
        key = (tuple(sorted(self.modes.items())), tuple((item.letter, item.origin) for item in system.variables))
        if key not in self.systems:
            assert isinstance(system, PlanarSystem)
            self.systems[key] = compiled(self.scene, self.modes, system)
        return self.systems[key]

    def _at_rest(self, part: Regime, hit: Watch) -> set[str]:
        """What rubs without slipping at the end of a part: what has just stopped, and what slips no more by all that its numbers tell."""
        first, last = self._slips(part, part.runs[0].pieces[-1].start), self._slips(part, part.ends[0])
        left_out = STEPS_LEAVE_OUT * self.tolerances.main
        resting = {name for name, slip in last.items() if abs(slip).lower() <= left_out * abs(first[name]).upper()}
        return resting | ({hit.rub.name} if hit.rub is not None else set())

    def _slips(self, part: Regime, time: float) -> dict[str, Scalar]:
        """How fast all that rubs slips at a moment, where the laws tell it."""
        system = part.system
        assert isinstance(system, PlanarSystem)
        with Precision(max(READING_BITS, 2 * self.tolerances.bits)):
            slips = {rub.name: rub.rate(system.moment) for rub in rubs(system.moment.configuration)}
            places = {
                name: place_on_tape(system, slip) for name, slip in slips.items() if slip and is_told(system, slip)
            }
            return Readout(system, places).read(time, part.state(time))

    def _reconfigured(self, state: State) -> bool:
        """Whether something else acts from a state on that is reached; an event that it starts is not followed."""
        after = self.configuration.timeline.after(state.name)
        if after is not None and after.event is not None:
            self.found.ended = f"`{after.name}` happens at `{state.name}`: what comes after that is not followed"
            return False
        scene = scene_from(self.configuration, state.name)
        old, new = self.scene.problem, scene.problem
        changed = (old.connections, old.actions) != (new.connections, new.actions)
        if changed:
            self.scene = scene
            self.systems.clear()
        return changed

    def _coordinates(self, system: System, state: Sequence[Scalar], time: float) -> dict[str, Exact]:
        """The time and the places at a moment, where a state that is still ahead may count from them."""
        if not self.ahead:
            return {}
        places = {name: ball.mid() for name, ball in self._read(system, state, time).items()}
        return {**places, TIME: fmpq(*time.as_integer_ratio())}

    def _read(self, system: System, state: Sequence[Scalar], time: float) -> Mapping[str, Scalar]:
        with Precision(max(READING_BITS, 2 * self.tolerances.bits)):
            return Readout(system, system.outputs).read(time, state)

    def _carried(self, system: System, following: System, state: Sequence[Scalar], time: float) -> list[Scalar]:
        """The state at an event in the numbers of the system that follows."""
        own = {item.letter: number for item, number in zip(system.variables, state, strict=True)}
        read = self._read(system, state, time)
        floats = self.tolerances.bits == FLOAT_BITS
        for item in following.variables:
            if item.letter not in own:
                middle = read[item.name].mid()
                own[item.letter] = float(middle) if floats else middle
        return [own[item.letter] for item in following.variables]
