"""Ways on joints: whether what turns on a hinge or goes along a slide, alone or carried, comes to where a later state has it.

It sets out as it moves, else as it is driven; where it is at rest and nothing drives it, it stays. Towards a place it gets where what is
left of its energy is positive all the way; away from one it has to turn back first, where nothing is left. Angles count on beyond whole
turns. By numbers this is looked at between the places where nothing drives it; in letters where these have closed forms, as conditions.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, cast

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.certified.rootfind import real_roots
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import ONE, PI, ZERO, Formula, Integral, Number, call
from rotsolve.core.faults import NeverReached
from rotsolve.core.letters import letters_of
from rotsolve.core.symbols import has_quantities, is_key, key_of
from rotsolve.core.ways import PLACE, WayEnd, WayOnJoint
from rotsolve.motion.timeline import Interval
from rotsolve.search.search import Search

if TYPE_CHECKING:
    from rotsolve.space.scene import SpaceEquations

TURN = 2 * PI
FAR = 1000  # times the way told, or a metre where it leads back: what has not turned back there on a slide does not
MOST_POWER = 8  # of a place up to which energies are polynomials
SHARE = 1e-12  # of the energies on the way: less than this is nothing
LOOKS = 64  # places on a way at which it is looked besides
AWAY = "`{}` sets out the other way, and never turns back"
BARRED = "`{}` turns back before"
ONWARD = "`{}` passes there in the other sense, and never turns back"
CREEPS = "`{}` would come to rest there in balance: it comes ever nearer, and never there"
BALANCED = "`{}` is at rest in balance, and stays so"


def barred_ways(interval: Interval, search: Search) -> Iterator[NeverReached]:
    """The places of bodies on joints in space to which they do not come in a phase."""
    for way in ways_of_phase(interval, search):
        yield from barred_way(way, interval, search)


def barred_way(way: WayOnJoint, interval: Interval, search: Search) -> Iterator[NeverReached]:
    """That a body does not come to the end of its way, if it does not."""
    configuration = search.scene.configuration
    looked = way_looked_at(way, search)
    why = "" if looked is None else looked.objection()
    if why and not (why == CREEPS and is_limit_sought(way, interval, search)):
        from rotsolve.search.endings import never_reached

        yield never_reached(interval, configuration, why.format(way.body), sure=True)


def is_limit_sought(way: WayOnJoint, interval: Interval, search: Search) -> bool:
    """Whether a state tells that a body comes to rest there, and a letter is sought by which it set out, its rate, or what is told of a
    state or an event before: with the value that just gets it there."""
    problem, timeline = search.scene.configuration.problem, search.scene.configuration.timeline
    begun = timeline.order[interval.start]
    events = tuple(
        event for event in problem.events if event.to in timeline.order and timeline.order[event.to] <= begun
    )
    told = set(letters_of((events, tuple(state.conditions for state in timeline.states[: begun + 1]))))
    setting = told if open_(way.rate) else way.rate.symbols()
    return way.last == ZERO and not problem.sought.isdisjoint(setting)


def only_sense(name: str, roots: Sequence[Formula], search: Search) -> int | None:
    """Which of several roots for a rate is that with which alone the motion comes to where a later state tells it; None of all else."""
    from rotsolve.space.roots import rate_told_by

    told = rate_told_by(name, search.scene, components=True)
    phases = search.scene.configuration.timeline.intervals if told is not None else ()
    for interval in (phase for phase in phases if told is not None and phase.end == key_of(told).when):
        for way in ways_of_phase(interval, search):
            if way.last is None or name not in way.last.symbols() or name in way.end.symbols():
                continue
            looked = [way_looked_at(replace(way, last=way.last.substitute({name: root})), search) for root in roots]
            coming = [k for k, one in enumerate(looked) if one is None or not one.objection()]
            return coming[0] if len(coming) == 1 else None
    return None


def ways_of_phase(interval: Interval, search: Search) -> Iterator[WayOnJoint]:
    """The ways of bodies on joints in a phase; none in an event."""
    from rotsolve.space.ways import ways_on_joints

    if interval.event is None:
        yield from ways_on_joints(cast("SpaceEquations", search.scene), interval)


def sense_set_out(name: str, roots: Sequence[Formula], search: Search) -> int | None:
    """Which of several roots for a rate just after an event is that with which alone the motion comes to where the phase from there
    ends, or ever nearer to it; None of all else."""
    timeline, when = search.scene.configuration.timeline, key_of(name).when if is_key(name) else None
    after = {interval.end for interval in timeline.intervals if interval.event is not None}
    for interval in (phase for phase in timeline.intervals if phase.start == when and when in after):
        for way in ways_of_phase(interval, search):
            if name not in way.rate.symbols() or name in way.end.symbols():
                continue
            looked = [way_looked_at(with_rate(way, {name: root}), search) for root in roots]
            coming = [k for k, one in enumerate(looked) if one is None or one.objection() in ("", CREEPS)]
            return coming[0] if len(coming) == 1 else None
    return None


def with_rate(way: WayOnJoint, found: dict[str, Formula]) -> WayOnJoint:
    """A way with a letter for its rate put in."""
    rate, gap, effort = (value.substitute(found) for value in (way.rate, way.gap, way.effort))
    return replace(way, rate=rate, gap=gap, effort=effort)


def way_looked_at(way: WayOnJoint, search: Search) -> LookedAt | None:
    """A way of which all is known but its place, if it leads elsewhere, or back."""
    from rotsolve.search.endings import Endings

    settled = Endings(search).settled
    known = [settled(value) for value in (way.start, way.end, way.rate, way.gap, way.effort)]
    start, end, rate, gap, effort = known
    if start is None or end is None or rate is None or gap is None or effort is None or any(map(open_, known)):
        return None
    last = None if open_(way.last) else settled(way.last)  # else its sense is that of the way
    found = WayOnJoint(way.body, way.turning, start, end, rate, gap, effort, way.ends, None if open_(last) else last)
    letters = {name for value in (*known, found.last) if value is not None for name in value.symbols()} - {PLACE}
    side = search.numbers.side
    ahead = side(simplify(end - start))
    if ahead == 0 and way.ends != (None, None):
        ahead = -(side(rate) or 0)
    elif ahead == 0 and found.last is not None:
        ahead = side(rate)  # so it has to come back
    return LookedAt(found, search, ahead, letters <= search.values.keys()) if ahead else None


def open_(value: Formula | None) -> bool:
    return value is None or has_quantities(value)


class LookedAt(Struct, frozen=True, dict=True):
    """A way that leads `ahead`, looked at by numbers, else in letters."""

    way: WayOnJoint
    search: Search
    ahead: int
    numeric: bool

    def objection(self) -> str:
        """Why it does not come to its end, or not in the sense that is told there; nothing where it does, or the letters do not tell."""
        side, way = self.search.numbers.side, self.way
        sets_out = side(way.rate)
        at_rest = sets_out == 0
        if at_rest:
            sets_out = side(simplify(way.pull.substitute({PLACE: way.start})))
        if sets_out == 0:
            return BALANCED
        if sets_out == -self.ahead and (at_rest or self.turns_back(way.start, -self.ahead) is False):
            off = self.off(-self.ahead)
            return AWAY if off is None else off.words
        if sets_out and self.least(way.start, self.ahead, way.end) in (0, -1):
            return BARRED
        if self.comes_to_rest_in_balance():
            return CREEPS
        against = way.last is not None and side(way.last) == -self.ahead
        return ONWARD if against and self.turns_back(way.end, self.ahead) is False else ""

    def comes_to_rest_in_balance(self) -> bool:
        """Whether nothing is left of its energy at the end of its way, and nothing drives it there: as (q − q₁)² it takes for ever."""
        way = self.way
        pull = simplify(way.pull.substitute({PLACE: way.end}))
        drives = self.side(pull * (way.end - way.start) if self.numeric else pull)
        return drives == 0 and self.side(way.left_at(way.end)) == 0

    def off(self, sense: int) -> WayEnd | None:
        """Where it runs off that goes on in a sense."""
        return self.way.ends[sense > 0]

    def turns_back(self, place: Formula, sense: int) -> bool | None:
        """Whether what goes through a place in a sense comes back: on a hinge within a turn, or since each turn takes of its energy."""
        way = self.way
        if not way.turning:
            far = self.far_off(place, sense)
            return None if far is None else far == -1
        turned = place + sense * TURN
        lost = self.side(way.left_at(turned) - way.left_at(place))
        least = self.least(place, sense, turned)
        return None if lost is None or least is None else lost == -1 or least == -1

    def far_off(self, place: Formula, sense: int) -> int | None:
        """The sign of what is least on a slide however far it goes on from a place in a sense."""
        off = self.off(sense)
        if off is not None:
            last = self.side(self.way.left_at(off.place))
            return -1 if last == -1 or self.least(place, sense, off.place) == -1 else None if last is None else 0
        if self.numeric:
            gone = call("abs", self.way.end - self.way.start)
            return self.least(place, sense, place + sense * FAR * (gone if self.search.numbers.side(gone) else ONE))
        power, lead = 0, self.way.gap
        while PLACE in lead.symbols() and power < MOST_POWER:
            power, lead = power + 1, simplify(differentiate(lead, PLACE))
        if PLACE in lead.symbols() or self.way.effort != ZERO:
            return None
        return -1 if self.side(lead) == -(sense**power) else self.least(place, sense, None)

    def least(self, start: Formula, sense: int, stop: Formula | None) -> int | None:
        """The sign of what is left where it is least from one place to another, or beyond the one; None where that is not told."""
        places = self.looks(start, stop) if self.numeric and stop is not None else self.slowest()
        if places is None:
            return None
        signs = [
            self.side(self.way.left_at(place))
            for place in places
            if self.numeric or self.between(place, start, sense, stop)
        ]
        return None if None in signs else min((sign for sign in signs if sign is not None), default=1)

    def between(self, place: Formula, start: Formula, sense: int, stop: Formula | None) -> bool:
        """Whether it is slowest at a place beyond one, and before another, in letters."""
        side = self.search.numbers.side
        if side(simplify(differentiate(self.way.pull, PLACE).substitute({PLACE: place}))) == -1:
            return False  # it is fastest there
        gone = side(simplify((place - start) * sense)) == 1
        return gone and (stop is None or side(simplify((stop - place) * sense)) == 1)

    def slowest(self) -> list[Formula] | None:
        """Where nothing drives it and it is slowest, as far as that has a closed form; of angles once round each way too."""
        pull, solver = self.way.pull, self.search.solver
        if PLACE not in pull.symbols():
            return []
        roots = solve_polynomial(pull, PLACE, order=solver.order, positive=solver.positive)
        if not roots:
            angles = solve_trig(pull, PLACE, order=solver.order, positive=solver.positive)
            roots = [root + turn for root in angles for turn in (-TURN, ZERO, TURN)]
        return roots or None

    def looks(self, start: Formula, stop: Formula) -> list[Formula]:
        """Places from one to another at which it is looked, by numbers: those at which nothing drives it among them."""
        ends = [self.search.numbers.of(end) or 0.0 for end in (start, stop)]
        shares = [(k / LOOKS) ** (1 if self.way.turning or stop is self.way.end else 4) for k in range(1, LOOKS)]
        places = [ends[0] + share * (ends[1] - ends[0]) for share in shares]
        low, high = sorted((start, stop), key=lambda end: self.search.numbers.of(end) or 0.0)
        with suppress(Undefined, ZeroDivisionError):
            places += [root.float for root in real_roots(self.way.pull, PLACE, self.search.values, low, high).roots]
        return [Number(Fraction(place)) for place in places]

    def side(self, value: Formula) -> int | None:
        """The sign of what is left; by numbers one that is nothing but for rounding is 0."""
        if not self.numeric:
            return None if value.holds(Integral) else self.search.numbers.side(simplify(value))
        number = self.search.numbers.of(value)
        return None if number is None else 0 if abs(number) <= SHARE * self.size else 1 if number > 0 else -1

    @cached_property
    def size(self) -> float:
        """How large energies are on the way, by numbers."""
        ends = (
            self.search.numbers.of(self.way.left_at(self.way.start)),
            self.search.numbers.of(self.way.pull.substitute({PLACE: self.way.start}) * (self.way.end - self.way.start)),
        )
        return sum(abs(end or 0.0) for end in ends)
