"""Endings: where the laws of a phase end before it does: what slides stops, what slips begins to roll, what turns comes to rest.

From there on a phase of its own begins, at a state that the scene does not name; its bodies go on as friction lets them.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, negate
from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import CONSTANT, POSITION, RATE, TIME, has_quantities, is_quantity
from rotsolve.core.writing import spoken
from rotsolve.language.problem import Condition, Path, Problem, State
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.rubs import BACK, FORWARD, TURNS_BACK, Rub, rubs_at
from rotsolve.motion.timeline import OPEN, Interval
from rotsolve.search.answers import NoAnswer, unsolvable
from rotsolve.search.consistency import KnownBalls, no_way
from rotsolve.search.search import Search, asked_letter

MOST = 12  # states that are opened in one scene


class Ending(Struct, frozen=True):
    """What ends in a phase before it does: the lines that hold then, and the senses in which all that rubs goes on."""

    interval: Interval
    lines: tuple[Condition, ...]
    senses: tuple[tuple[str, int], ...]
    name: str
    words: str


class Endings(Struct, dict=True):
    """Looks through the phases of a search, as far as it has come; `stuck` where it found no answer."""

    search: Search
    stuck: bool = False

    def __post_init__(self) -> None:
        self.scene, self.numbers = self.search.scene, self.search.numbers
        self.configuration = self.scene.configuration
        self.aside: Search | None = None

    def first(self) -> Ending | None:
        """The first phase that its laws do not describe up to its end, with what ends them."""
        for interval in self.configuration.timeline.intervals:
            found = (self.within(interval) or self.turning(interval)) if interval.event is None else None
            if found is not None:
                return found
        return None

    def turning(self, interval: Interval) -> Ending | None:
        """The moment at which a motion that goes by its place turns back, where it has to before the phase ends."""
        passage = self.scene.passages[interval.name]
        if all(travel.pace != POSITION for travel in passage.travels):
            return None
        from rotsolve.search.turning import NEVER, turned_on_way

        found, timeline = turned_on_way(passage, self.settled, self.search), self.configuration.timeline
        if timeline.state(interval.end).opened or found is None:
            if self.stuck and timeline.state(interval.end).opened:
                raise never_reached(
                    interval, self.configuration, "it sets out the other way, and nothing brings it back so far"
                )
            return None
        travel, how = found
        if how == NEVER or timeline.state(interval.start).opened:
            why = f"{spoken(travel.body)} comes to rest before, and turns back"
            raise never_reached(interval, self.configuration, why)
        word = "velocity" if travel.kind == "line" else "angular_velocity"
        senses = tuple((rub.name, 0) for rub in rubs_at(self.configuration, interval.start))
        line = Condition(Path(travel.body, word), ZERO)
        return Ending(interval, (line,), senses, "turn", f"{spoken(travel.body)} turns back")

    def within(self, interval: Interval) -> Ending | None:
        """What ends first in a phase, where that is before the phase does."""
        rubbing = [(rub, self.sense(rub)) for rub in rubs_at(self.configuration, interval.start)]
        resting = self.resting_first(interval, rubbing) or self.turned(interval, rubbing)
        if not resting or self.said(interval, resting):
            return None
        senses = tuple((rub.name, 0 if rub in resting else sense) for rub, sense in rubbing)
        words = " and ".join(dict.fromkeys(words_for(rub, self.search) for rub in resting))
        name = "rest" if all(stops(rub, self.search) for rub in resting) else "hold"
        return Ending(interval, tuple(map(resting_line, resting)), senses, name, words)

    def resting_first(self, interval: Interval, rubbing: Sequence[tuple[Rub, int]]) -> tuple[Rub, ...]:
        """Of what slows down steadily, that which comes to rest before the phase ends, and before the others."""
        ends = [(rub, at) for rub, sense in rubbing if sense and (at := self.moment(rub, sense)) is not None]
        if not ends:
            return ()
        first = ends[0][1]
        for _, at in ends[1:]:
            first = at if self.numbers.side(at - first) == -1 else first
        resting = tuple(rub for rub, at in ends if self.numbers.side(at - first) == 0)
        return resting if self.passed(interval, first) else ()

    def turned(self, interval: Interval, rubbing: Sequence[tuple[Rub, int]]) -> tuple[Rub, ...]:
        """What slows down in another way, and by its laws would go backwards where the phase ends: it comes to rest before."""
        found = []
        for rub, sense in rubbing:
            if sense and self.configuration.pace(rub.body, rub.state) in (TIME, RATE) and interval.end != OPEN:
                ends = (self.settled(rub.rate(self.scene.instant(at))) for at in (interval.start, interval.end))
                sides = [None if rate is None else self.side(rate) for rate in ends]
                if sides[0] in (0, sense) and sides[1] == -sense:
                    found.append(rub)
        if len(found) > 1:
            names = " and ".join(spoken(rub.name) for rub in found)
            raise unsolvable(
                self.configuration.problem, f"which of {names} comes to rest first is not told by closed forms"
            )
        return tuple(found)

    def sense(self, rub: Rub) -> int:
        """The sense in which it slips or turns in its phase; 0 where it sticks or is held."""
        default = "" if rub.item is None else "sticks"
        mode = self.scene.modes.get(rub.key, default)
        return {FORWARD: 1, BACK: -1, "": 1, TURNS_BACK: -1}.get(mode, 0)

    def moment(self, rub: Rub, sense: int) -> Formula | None:
        """How long after the start of its phase it comes to rest, −v/v̇ of its slip; None where it does not, or numbers do not tell."""
        if self.configuration.pace(rub.body, rub.state) != CONSTANT:
            return None
        instant = self.scene.instant(rub.state)
        speed, gain = (self.settled(rub.rate(instant, acceleration=later)) for later in (False, True))
        if speed is None or gain is None or self.side(speed) != sense or self.side(gain) != -sense:
            return None
        return simplify(negate(speed) / gain, order=self.configuration.order)

    def side(self, value: Formula) -> int | None:
        return self.numbers.side(value)

    def settled(self, value: Formula | None) -> Formula | None:
        """A value with all that the answers and the laws tell of its letters."""
        if value is None:
            return None
        found = self.search.solver.with_found(value)
        if not has_quantities(found):
            return found
        self.aside = self.aside or self.search.apart(careful=True)
        return self.aside.settled(found)

    def said(self, interval: Interval, resting: tuple[Rub, ...]) -> bool:
        """Whether the state at the end of a phase says itself that one of them has come to rest."""
        end = self.configuration.timeline.state(interval.end)
        said = {
            line.path.owner for line in end.conditions if line.path is not None and line.word in ("rolls", "sticks")
        }
        at_rest = {name for name, sense in end.senses if not sense}
        return any(rub.owner in said or rub.name in at_rest for rub in resting)

    def passed(self, interval: Interval, at: Formula) -> bool:
        """Whether a phase lasts for longer than that; one whose end is not found is taken to, where there is no answer else."""
        duration = self.settled(self.scene.passages[interval.name].duration)
        if duration is None:
            return self.stuck or interval.end == OPEN
        return self.side(duration - at) == 1 or self.side(duration) == -1


def never_reached(interval: Interval, configuration: Configuration, why: str) -> Unsolvable:
    """A state to which the motion never gets, and why."""
    start, end = configuration.timeline.told(interval)
    span = configuration.timeline.state(end).span
    from rotsolve.search.explain import clash

    return clash(configuration.problem, f"`{end}` is never reached from `{start}`", span, why)


def not_in_time(search: Search, numbers: KnownBalls) -> None:
    """Refuse a state to which a body does not come by its steady acceleration: what tells that is a condition in letters."""
    endings = Endings(search)
    for interval in endings.configuration.timeline.intervals:
        passage = search.scene.passages.get(interval.name)
        for travel in passage.travels if passage is not None and no_way(passage, numbers) else ():
            told = [endings.settled(value) for value in (travel.before, travel.acceleration, travel.change)]
            sides = [endings.side(value) for value in told if value is not None]
            if travel.pace == CONSTANT and len(sides) == 3:
                where = "there" if sides[2] else "back"
                why = f"{spoken(travel.body)} does not come {where}"
                raise never_reached(interval, endings.configuration, why)


def tell_openings(search: Search) -> None:
    """Work out how long it takes to the states that the scene does not name, and how fast all moves then: the next phase begins so."""
    for interval in search.scene.configuration.timeline.intervals:
        if search.scene.configuration.timeline.state(interval.end).opened:
            tell_ends(search, interval)


def tell_ends(search: Search, interval: Interval) -> None:
    """The speeds at both ends of a phase, and how long it takes, as far as the laws of a search tell them."""
    passage = search.scene.passages[interval.name]
    speeds = [speed for travel in passage.travels for speed in (travel.before, travel.after)]
    for value in (*speeds[::2], passage.duration, *speeds[1::2]):
        if is_quantity(value) and value.name not in search.solver.solved:
            with suppress(NoAnswer):
                search.answer(asked_letter(value.name), aside=True)


def stops(rub: Rub, search: Search) -> bool:
    """Whether a body stands where it no longer slips: unless it rolls, or something carries it."""
    if rub.item is None:
        return True
    wheel = search.scene.instant(rub.state).is_round(rub.body)
    return rub.contact is not None and not (wheel or rub.contact.carrier(search.scene.configuration))


def words_for(rub: Rub, search: Search) -> str:
    """What happens, in words: "stone comes to rest", "ball no longer slips"."""
    slider = rub.body if rub.contact is not None else rub.name
    return f"{spoken(rub.body)} comes to rest" if stops(rub, search) else f"{spoken(slider)} no longer slips"


def with_state_at(problem: Problem, ending: Ending) -> Problem:
    """The problem with a state of its own at which a phase ends before its time."""
    states = problem.states or (State(""),)
    if sum(bool(state.opened) for state in states) == MOST:
        raise unsolvable(problem, f"what rubs starts and stops more than {MOST} times: that is not followed further")
    place = next(number for number, state in enumerate(states) if state.name == ending.interval.start) + 1
    state = State(free_name(ending.name, problem), ending.lines, opened=ending.words, senses=ending.senses)
    return replace(problem, states=(*states[:place], state, *states[place:]))


def resting_line(rub: Rub) -> Condition:
    """What a state says of what has come to rest."""
    if rub.item is None:
        return Condition(Path(rub.body, "angular_velocity"), ZERO)
    return Condition(Path(rub.owner, ""), word="sticks")


def free_name(word: str, problem: Problem) -> str:
    """A name for a state that nothing else has."""
    named = (problem.states, problem.events, problem.phases, problem.bodies, problem.connections, problem.actions)
    taken = {item.name for items in named for item in items}
    numbered = (f"{word}{number}" for number in range(2, len(taken) + 3))
    return next(name for name in (word, *numbered) if name not in taken)
