"""Endings: where the laws of a phase end before it does: what slides stops, what slips begins to roll, what turns comes to rest.

From there on a phase of its own begins, at a state that the scene does not name; its bodies go on as friction lets them.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import HALF, PI, ZERO, Formula, negate
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.faults import UNSOLVED, NeverReached, Unsolvable
from rotsolve.core.passage import Travel
from rotsolve.core.symbols import CONSTANT, POSITION, RATE, TIME, has_quantities
from rotsolve.core.writing import spoken
from rotsolve.language.problem import Condition, Path
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.hereafter import asks_forces_at_last
from rotsolve.motion.rubs import BACK, FORWARD, TURNS_BACK, Rub, rubs_at
from rotsolve.motion.timeline import OPEN, Interval
from rotsolve.paths.meaning import NotYet
from rotsolve.search.answers import unsolvable
from rotsolve.search.consistency import KnownBalls, no_way, values_sought_once
from rotsolve.search.openings import Ending, moving_words, resting_line, slider_of, stops, turning_line, words_for
from rotsolve.search.search import Search

if TYPE_CHECKING:
    from rotsolve.search.holding import InTime, Slipping

MOST_TURNS = 4  # of them those at which a swing that rubs turns back: each of its half swings is solved on its own
GROWS = {"largest": 1, "smallest": -1}
SIMULATE = "`rotsolve simulate` follows it; or let the scene end before that"


Stopping = tuple[tuple[Rub, ...], "Formula | None"]  # what comes to rest, and when on the clock, where that is told


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
            ways = (self.within, self.turning, self.swinging, self.over_the_top) if interval.event is None else ()
            found = next(filter(None, (way(interval) for way in ways)), None)
            if found is not None:
                return found
        return None

    def held_at_last(self) -> tuple[tuple[str, int], ...]:
        """The senses in which what rubs goes on from the last state, where some of it comes to rest exactly there and forces are asked,
        which are those from then on; nothing otherwise."""
        if self.stuck or not asks_forces_at_last(self.configuration):
            return ()
        last = self.configuration.timeline.intervals[-1]
        senses = [(rub, self.sense(rub)) for rub in rubs_at(self.configuration, last.start)]
        held = [rub for rub, sense in senses if sense and self.rests_at(rub, last.end)]
        return tuple((rub.name, 0 if rub in held else sense) for rub, sense in senses) if held else ()

    def rests_at(self, rub: Rub, state: str) -> bool:
        """Whether something that slips or turns does not at a state, exactly."""
        rate = self.settled(rub.rate(self.scene.instant(state)))
        return rate is not None and self.side(rate) == 0

    def turning(self, interval: Interval) -> Ending | None:
        """The moment at which a motion that goes by its place turns back, where it has to before the phase ends."""
        passage = self.scene.passages[interval.name]
        if all(travel.pace != POSITION for travel in passage.travels):
            return None
        from rotsolve.search.turning import NEVER, turned_on_way

        other = self.other_extreme(interval)
        if other is not None:
            return other
        timeline = self.configuration.timeline
        found = turned_on_way(passage, self.settled, self.search, stuck=self.stuck)
        if self.stuck and timeline.state(timeline.told(interval)[1]).time_told is not None:
            return None  # a time comes, wherever that leads
        if timeline.state(interval.end).opened or found is None:
            if found is not None and self.nowhere(found[0]):
                why = f"{spoken(found[0].body)} stays where it turns back"
                raise never_reached(timeline.intervals[-1], self.configuration, why)
            away = found is not None and found[1] != NEVER  # where it would turn back lies behind it
            if timeline.state(interval.end).opened and (self.stuck or away):
                raise never_reached(
                    interval, self.configuration, "it sets out the other way, and nothing brings it back so far"
                )
            return None
        travel, how = found
        if how == NEVER or timeline.state(interval.start).opened:
            why = f"{spoken(travel.body)} comes to rest before, and turns back"
            raise never_reached(interval, self.configuration, why)
        senses = tuple((rub.name, 0) for rub in rubs_at(self.configuration, interval.start))
        return Ending(interval, (turning_line(travel),), senses, "turn", f"{spoken(travel.body)} turns back")

    def other_extreme(self, interval: Interval) -> Ending | None:
        """Where what is to come to its largest place sets out towards the smallest one: it turns back there, or the other way round."""
        timeline = self.configuration.timeline
        if timeline.state(interval.start).opened or timeline.state(interval.end).opened:
            return None
        for line in timeline.state(interval.end).conditions:
            path, grows = line.path, GROWS.get(line.word or "", 0)
            for travel in self.scene.passages[interval.name].travels if path is not None and grows else ():
                own = path is not None and self.places(path, travel, interval.end)
                speed = self.settled(travel.before) if own else None
                counted = travel.sense if path is not None and path.quantity == "angle" else 1
                if speed is not None and self.side(speed) == -grows * counted:
                    senses = tuple((rub.name, 0) for rub in rubs_at(self.configuration, interval.start))
                    words = f"{spoken(travel.body)} turns back"
                    return Ending(interval, (turning_line(travel),), senses, "turn", words)
        return None

    def places(self, path: Path, travel: Travel, state: str) -> bool:
        """Whether a path is the place along which a travel goes: of a body, or of the wire that turns it back."""
        item, host = self.configuration.connection(path.owner, state), self.configuration.host
        owners = [ref.owner for ref in item.winds()] if item is not None else [path.owner]
        if path.point is not None or path.component is not None or travel.pace != POSITION:
            return False
        if path.quantity == "angle":
            return travel.kind == "turn" and [host(name, state) for name in owners] == [travel.body]
        words = ("rotation", "turns") if travel.kind == "turn" else ("displacement",)
        return path.quantity in words and path.owner == travel.body

    def over_the_top(self, interval: Interval) -> Ending | None:
        """The highest place of a hollow surface between both ends of a phase: there it presses least, and has to press still."""
        start, end = (self.scene.instant(state) for state in (interval.start, interval.end))
        for travel in self.scene.passages[interval.name].travels if not self.stuck else ():
            circle = end.orbit(travel.body) if travel.kind == "line" else None
            if circle is None or not circle.hollow or circle.radius is None or start.orbit(travel.body) != circle:
                continue
            places = [self.settled(at.place_on(circle)) for at in (start, end)]
            if any(place is None or has_quantities(place) for place in places):
                continue
            first, last = (place for place in places if place is not None)
            ahead = self.side(last - first)
            if ahead != circle.way * self.numbers.sign((self.settled(travel.before), self.settled(travel.initial))):
                continue  # it comes there the other way round: places are told up to whole turns
            tops = [HALF * PI * (1 + 4 * turns) for turns in (range(-2, 3) if ahead != -1 else range(2, -3, -1))]
            top = next((top for top in tops if self.side(top - first) == ahead == self.side(last - top)), None)
            if ahead and top is not None:
                senses = tuple((rub.name, self.sense(rub)) for rub in rubs_at(self.configuration, interval.start))
                line = Condition(Path(circle.owner, "angle"), simplify(top))
                return Ending(interval, (line,), senses, "top", f"{spoken(travel.body)} passes the highest place")
        return None

    def nowhere(self, travel: Travel) -> bool:
        """Whether a motion that sets out would have to turn back at once, since what is said of later states holds it at its start."""
        speed, gone = self.settled(travel.before), self.settled(travel.change)
        return speed is not None and gone is not None and bool(self.side(speed)) and self.side(gone) == 0

    def swinging(self, interval: Interval) -> Ending | None:
        """The moment at which a motion that goes by its place and rubs turns back, and its friction with it, before a time that is told."""
        rubbing = [(rub, self.sense(rub)) for rub in rubs_at(self.configuration, interval.start)]
        moving = [rub for rub, sense in rubbing if sense and self.configuration.pace(rub.body, rub.state) == POSITION]
        end = self.configuration.timeline.state(interval.end)
        timed = any(line.path is not None and line.path.quantity == "time" for line in end.conditions)
        if self.stuck or not moving or not timed:
            return None
        from rotsolve.search.turning import time_to_turn

        passage, body = self.scene.passages[interval.name], moving[0].body
        travel = next((item for item in passage.travels if item.body == body and item.pace == POSITION), None)
        if travel is None:
            return None
        line, words = turning_line(travel), f"{spoken(body)} turns back"
        lasts = time_to_turn(interval, line, self.search)
        left = self.settled(self.scene.instant(interval.end).time() - self.clock(interval.start))
        if lasts is None or left is None:
            return None
        if self.side(lasts) is None:
            error = NotYet("the numbers do not tell it", help="name a state before that")
            raise self.not_told(interval, f"when {spoken(body)} turns back", error)
        if self.side(lasts) != 1 or self.side(left - lasts) != 1:
            return None
        if self.search.signs.lacking(left - lasts):
            error = NotYet(f"{words}, and its friction with it", help="give numbers to the letters")
            raise self.not_told(interval, "in letters the motion", error)
        if sum(state.opened == words for state in self.configuration.timeline.states) == MOST_TURNS:
            error = NotYet(f"{words} more than {MOST_TURNS} times, and its friction with it", help=SIMULATE)
            raise self.not_told(interval, "the motion", error)
        tied = self.configuration.component(body, interval.start)
        senses = tuple((rub.name, 0 if rub.body in tied else sense) for rub, sense in rubbing)
        return Ending(interval, (line,), senses, "turn", words)

    def within(self, interval: Interval) -> Ending | None:
        """What ends first in a phase, where that is before the phase does."""
        rubbing = [(rub, self.sense(rub)) for rub in rubs_at(self.configuration, interval.start)]
        self.check_straight(interval, rubbing)
        resting, at = self.resting_first(interval, rubbing)
        if not resting:
            resting, at = self.turned(interval, rubbing)
        begun = {name for name, sense in self.configuration.timeline.state(interval.end).senses if sense}
        slipping = self.slipping(interval, [rub for rub, sense in rubbing if not sense and rub.name not in begun])
        if slipping is not None and not (
            resting and self.sooner(at or self.rest_of(interval, resting[0]), slipping.at)
        ):
            return self.beginning(interval, rubbing, slipping)
        if not resting or self.said(interval, resting):
            return None
        self.check_closed(interval, resting)
        senses = tuple((rub.name, 0 if rub in resting else sense) for rub, sense in rubbing)
        words = " and ".join(dict.fromkeys(words_for(rub, self.search) for rub in resting))
        name = "rest" if all(stops(rub, self.search) for rub in resting) else "hold"
        return Ending(interval, tuple(map(resting_line, resting)), senses, name, words)

    def beginning(self, interval: Interval, rubbing: Sequence[tuple[Rub, int]], slipping: Slipping) -> Ending:
        """The state at which something begins to slip: a time on the clock since the last state of which the scene speaks."""
        begin = {rub.name: sense for rub, sense in slipping.senses.items()}
        senses = tuple((rub.name, begin.get(rub.name, sense)) for rub, sense in rubbing)
        if self.side(slipping.at - self.clock(interval.start)) == 0:  # it does so where the phase begins
            return Ending(interval, (), senses, "", "")
        told = self.clock(self.configuration.timeline.told(interval)[0])
        line = Condition(Path("", "time"), simplify(slipping.at - told, order=self.configuration.order))
        moving = [rub for rub, sense in slipping.senses.items() if sense]
        words = " and ".join(dict.fromkeys(moving_words(rub, self.search) for rub in moving))
        words = f"{words} at t = {to_text(simplify(slipping.at, order=self.configuration.order))}"
        return Ending(interval, (line,), senses, "slip" if moving[0].item is not None else "go", words)

    def check_closed(self, interval: Interval, resting: Sequence[Rub]) -> None:
        """What comes to rest on a rubbing axle at a time without a closed form is not followed further."""
        for rub in resting:
            timed = rub.item is None and self.configuration.pace(rub.body, rub.state) == TIME
            course = self.course(interval) if timed else None
            speed = self.settled(rub.rate(self.scene.instant(interval.start)))
            if course is not None and not course.has_closed_form(rub, speed):
                start, end = self.configuration.timeline.told(interval)
                message = f"{spoken(rub.body)} comes to rest on the way from `{start}` to `{end}`, at a time without a closed form"
                span, help = self.configuration.timeline.state(end).span, "let the scene end before that"
                message += ": what it does then is not solved"
                raise unsolvable(self.configuration.problem, message, span, help, kind=UNSOLVED)

    def check_straight(self, interval: Interval, rubbing: Sequence[tuple[Rub, int]]) -> None:
        """What sets out at a speed that is sought goes as its friction says: not back by the end of a phase, nor the other way."""
        senses = {rub.body: sense for rub, sense in rubbing if sense and stops(rub, self.search)}
        for travel in self.scene.passages[interval.name].travels:
            sought = {
                name
                for name in travel.before.symbols()
                if name in self.search.givens and self.search.givens[name].asked
            }
            if travel.body not in senses or not (sought or self.settled(travel.before) is None):
                continue
            gone, ended = (self.settled(value) for value in (travel.change, travel.after))
            sides = [None if value is None else self.side(value) for value in (gone, ended)]
            start, end = self.configuration.timeline.told(interval)
            how, help = "", ""
            if {*sides} == {1, -1}:
                how, help = "comes back", f"name where it turns back as a state between `{start}` and `{end}`"
            elif sides[0] == -senses[travel.body]:
                how, help = "goes the other way", "let its `moves` or `turns` say the way in which it sets out"
            if how:
                message = f"{spoken(travel.body)} {how} to `{end}`, and how fast it sets out is sought: its friction is not solved"
                raise unsolvable(self.configuration.problem, message, self.configuration.timeline.state(end).span, help)

    def clock(self, state: str) -> Formula:
        """The time on the clock at a state, as far as it is told."""
        time = self.scene.instant(state).time()
        return self.settled(time) or time

    def slipping(self, interval: Interval, held: Sequence[Rub]) -> Slipping | None:
        """What friction holds at first, and not until the phase ends."""
        held = [rub for rub in held if self.configuration.pace(rub.body, rub.state) == TIME]
        course = self.course(interval) if held else None
        if course is None:
            return None
        try:
            return course.slipping(held)
        except NotYet as error:
            names = " and ".join(dict.fromkeys(f"`{rub.owner}`" for rub in held))
            raise self.not_told(interval, f"when friction of {names} gives way, if it does,", error) from None

    def course(self, interval: Interval) -> InTime | None:
        """A phase whose forces vary in time; None where nothing tells when it begins."""
        from rotsolve.questions.functions_of_time import Beside
        from rotsolve.search.holding import InTime

        start, end = (self.settled(self.scene.instant(state).time()) for state in (interval.start, interval.end))
        beside = Beside(self.settled, self.search.signs)
        return InTime(self.search, beside, start, end) if start is not None else None

    def sooner(self, at: Formula | None, other: Formula) -> bool:
        """Whether what comes to rest does so before something else begins to slip."""
        if at is None:
            why = "whether something comes to rest or begins to slip first is not told by closed forms"
            raise unsolvable(self.configuration.problem, why, kind=UNSOLVED)
        return self.side(other - at) != -1

    def resting_first(self, interval: Interval, rubbing: Sequence[tuple[Rub, int]]) -> Stopping:
        """Of what slows down steadily, that which comes to rest before the phase ends, and before the others."""
        ends = [(rub, at) for rub, sense in rubbing if sense and (at := self.moment(rub, sense, interval)) is not None]
        if not ends:
            return (), None
        first = ends[0][1]
        for _, at in ends[1:]:
            first = at if self.numbers.side(at - first) == -1 else first
        resting = tuple(rub for rub, at in ends if self.numbers.side(at - first) == 0)
        later = any(self.numbers.side(at - first) == 1 for rub, at in ends if self.rests_at_end(interval, rub))
        return (resting, self.clock(interval.start) + first) if later or self.passed(interval, first) else ((), None)

    def turned(self, interval: Interval, rubbing: Sequence[tuple[Rub, int]]) -> Stopping:
        """What slows down in another way, and by its laws would go backwards before the phase ends: it comes to rest before."""
        moving = [(rub, sense) for rub, sense in rubbing if sense and not self.said(interval, (rub,))]
        found = [rub for rub, sense in moving if self.turns_back(interval, rub, sense)]
        if len(found) < 2:
            return tuple(found), None
        ends = [(rub, self.rest_of(interval, rub)) for rub in found]
        times = [at for _, at in ends if at is not None]
        if len(times) < len(ends):
            names = " and ".join(spoken(rub.name) for rub in found)
            why = f"which of {names} comes to rest first is not told by closed forms"
            raise unsolvable(self.configuration.problem, why, kind=UNSOLVED)
        first = times[self.numbers.least(times)]
        return tuple(rub for rub, at in ends if at is not None and self.side(at - first) == 0), first

    def turns_back(self, interval: Interval, rub: Rub, sense: int) -> bool:
        """Whether something would go backwards before a phase ends."""
        pace = self.configuration.pace(rub.body, rub.state)
        if pace not in (TIME, RATE) or interval.end == OPEN:
            return pace == TIME and bool(self.stops_ever(interval, rub, sense))
        start, end = (self.settled(rub.rate(self.scene.instant(at))) for at in (interval.start, interval.end))
        sides = [None if rate is None else self.side(rate) for rate in (start, end)]
        if sides[0] in (0, sense) and sides[1] == -sense:
            return True
        course = self.course(interval) if pace == TIME else None
        try:
            return course is not None and course.comes_back(rub, sense, start)
        except NotYet as error:
            raise self.not_told(interval, f"whether {spoken(rub.body)} comes to rest", error) from None

    def stops_ever(self, interval: Interval, rub: Rub, sense: int) -> bool | None:
        """Whether something comes to rest at some time of a phase that no state ends; None where that is not told."""
        course = self.course(interval)
        with suppress(NotYet):
            begun = self.settled(rub.rate(self.scene.instant(interval.start)))
            return course is not None and course.stops_ever(rub, sense, begun)
        return None

    def not_told(self, interval: Interval, what: str, error: NotYet) -> Unsolvable:
        """What is not solved of a phase, at its place in the file."""
        start, end = self.configuration.timeline.told(interval)
        message = f"{what} from `{start}` to `{end}` is not solved: {error}"
        span = self.configuration.timeline.state(end).span
        return unsolvable(self.configuration.problem, message, span, error.help)

    def rest_of(self, interval: Interval, rub: Rub) -> Formula | None:
        """When on the clock something comes to rest that slows down as forces vary in time; None where that is not told."""
        course = self.course(interval) if self.configuration.pace(rub.body, rub.state) == TIME else None
        if course is not None:
            with suppress(NotYet):
                return course.rests_at(rub, self.settled(rub.rate(self.scene.instant(interval.start))))
        return None

    def sense(self, rub: Rub) -> int:
        """The sense in which it slips or turns in its phase; 0 where it sticks or is held."""
        default = "" if rub.item is None else "sticks"
        mode = self.scene.modes.get(rub.key, default)
        return {FORWARD: 1, BACK: -1, "": 1, TURNS_BACK: -1}.get(mode, 0)

    def moment(self, rub: Rub, sense: int, interval: Interval) -> Formula | None:
        """How long after the start of its phase it comes to rest, −v/v̇ of its slip; None where it does not, or numbers do not tell.

        NeverReached where the end of the phase says that it has, and its slip stays as it is.
        """
        if self.configuration.pace(rub.body, rub.state) != CONSTANT:
            return None
        instant = self.scene.instant(rub.state)
        speed, gain = (self.settled(rub.rate(instant, acceleration=later)) for later in (False, True))
        if speed is None or gain is None or self.side(speed) != sense:
            return None
        if self.side(gain) == 0 and self.said(interval, (rub,)):
            raise never_reached(interval, self.configuration, f"{slider_of(rub)} goes on to slip as fast as it does")
        if self.side(gain) != -sense:
            return None
        return simplify(negate(speed) / gain, order=self.configuration.order)

    def side(self, value: Formula) -> int | None:
        return self.numbers.side(value)

    def settled(self, value: Formula | None) -> Formula | None:
        """A value with all that the answers and the laws tell of its letters, a letter that a question seeks among them."""
        if value is None:
            return None
        found: Formula | None = self.search.solver.with_found(value)
        if found is not None and has_quantities(found):
            self.aside = self.aside or self.search.apart(careful=True)
            found = self.aside.settled(found)
        return None if found is None else found.substitute(values_sought_once(self.search))

    def said(self, interval: Interval, resting: tuple[Rub, ...]) -> bool:
        """Whether the state at the end of a phase says itself that one of them has come to rest."""
        end = self.configuration.timeline.state(interval.end)
        said = {
            line.path.owner for line in end.conditions if line.path is not None and line.word in ("rolls", "sticks")
        }
        at_rest = {name for name, sense in end.senses if not sense}
        return any(rub.owner in said or rub.name in at_rest for rub in resting)

    def rests_at_end(self, interval: Interval, rub: Rub) -> bool:
        """Whether the lines of the state at the end of a phase tell that its body rests there: the phase lasts until the last that does."""
        lines = self.configuration.timeline.state(interval.end).conditions
        still = {line.owner for line in lines if line.rest}
        rates = [line.path for line in lines if line.path is not None and line.value == ZERO]
        still |= {path.owner for path in rates if path.quantity in ("velocity", "angular_velocity")}
        return not still.isdisjoint({"all", rub.body})

    def passed(self, interval: Interval, at: Formula) -> bool:
        """Whether a phase lasts for longer than that; one whose end is not found is taken to, where there is no answer else."""
        duration = self.settled(self.scene.passages[interval.name].duration)
        if duration is None:
            return self.stuck or interval.end == OPEN
        return self.side(duration - at) == 1 or self.side(duration) == -1


def never_reached(interval: Interval, configuration: Configuration, why: str, *, sure: bool = False) -> NeverReached:
    """A state to which the motion never gets, and why."""
    start, end = configuration.timeline.told(interval)
    span = configuration.timeline.state(end).span
    from rotsolve.search.explain import unreachable

    refusal = unreachable(configuration.problem, start, end, span, why)
    refusal.sure = sure
    return refusal


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
