"""On the way: what only pushes or pulls, in a phase whose forces vary with time or place, where it does so least between the ends.

That a string is taut as a force begins and as it ends does not say that it is so while the force swells, nor that of a load on a wheel
which a lump speeds up where it is level. Drag has most to say at the ends of a phase: what friction holds has to be held up to there, also
where it slips from then on, and what slips has to slip up to there.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import ceil, floor

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate, period_of
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import ZERO, Call, Formula, Symbol, negate
from rotsolve.core.derivation import Words
from rotsolve.core.facts import ON_THE_WAY, Requirement, signed
from rotsolve.core.passage import Passage, Travel
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import MIXED, POSITION, RATE, TIME, has_quantities
from rotsolve.core.writing import spoken
from rotsolve.laws.energy import conservation
from rotsolve.laws.table import OverPhase
from rotsolve.motion.passages import passage as passage_between
from rotsolve.motion.rubs import BACK, FORWARD, STICKS, rubs_at
from rotsolve.motion.timeline import OPEN, Interval
from rotsolve.paths.meaning import NotYet
from rotsolve.questions.functions_of_time import Beside
from rotsolve.search.search import Search

MOST_PLACES = 12  # within one phase


class Running(Struct, frozen=True):
    """What runs in a phase, the time or a coordinate, and its values at both ends in order."""

    letter: str
    low: Formula
    high: Formula


class Least(Struct, frozen=True):
    """A requirement at each place within a phase at which it has least to spare; None where neither laws nor letters tell these."""

    interval: Interval
    need: Requirement
    found: tuple[Requirement, ...] | None


def least_pushes(search: Search) -> Iterator[tuple[str, tuple[Requirement, ...]]]:
    """By the state at the end of a phase that forces and tensions are not negative where they are least within it."""
    for least in pushes_on_the_way(search):
        yield least.interval.end, least.found or ()


def untold_pushes(search: Search) -> Iterator[tuple[str, Words]]:
    """What letters leave open of a phase: whether a string stays taut on the way, or friction suffices. Numbers are followed in time."""
    givens = search.scene.configuration.problem.givens
    open_ = any(given.value is None and not (given.asked or given.automatic) for given in givens)
    for least in pushes_on_the_way(search) if open_ else ():
        if least.found is None and (least.need.kind.grips or least.interval.end != OPEN):  # else `lasting` looks at it
            what = (
                f"{spoken(least.need.owner)} {least.need.otherwise}" if least.need.kind.grips else least.need.otherwise
            )
            way = f"on the way from {spoken(least.interval.start)} to {spoken(least.interval.end)}"
            yield least.need.owner, (f"whether {what} {way}",)
    yield from untold_slips(search) if open_ else ()


@remembered
def pushes_on_the_way(search: Search) -> tuple[Least, ...]:
    """What only pushes or pulls in each phase whose forces vary; of letters also what grips, which numbers are followed to."""
    found: list[Least] = []
    for name, passage in search.scene.passages.items():
        interval = search.scene.configuration.timeline.interval(name)
        if interval is None or not (running_letter(passage) or goes_by_speed(passage)):
            continue
        beside = Beside(informed(search, passage, interval).settled, search.signs)
        for need in passage.midst.requirements:
            if not need.kind.placed and (search.signs.trials or not need.kind.grips):
                found.append(Least(interval, need, least_of(need, passage, interval, search, beside)))
    return tuple(found)


def informed(search: Search, passage: Passage, interval: Interval) -> Search:
    """A search beside one that knows too how fast all moves at any place of a phase: K₁ + U₁ + W = K + U, from its start up to there."""
    other, scene = search.apart(), search.scene
    if running_letter(passage) not in ("", TIME):
        start = (scene.instant(interval.start), passage.start)
        place = (scene.instant(interval.start, generic=True), passage.midst)
        so_far = passage_between(interval, start, place, place)
        works = tuple(work if work.spelled is None else replace(work, amount=work.spelled) for work in so_far.works)
        over = OverPhase(replace(so_far, works=works), interval.name, (), passage.midst, {}, {})
        for kept in conservation(over):
            other.planner.extend(kept)
    return other


def least_of(
    need: Requirement, passage: Passage, interval: Interval, search: Search, beside: Beside
) -> tuple[Requirement, ...] | None:
    """A requirement at each place within a phase at which it has least to spare; None where the laws or the letters do not tell that."""
    letter, margin = running_letter(passage), beside.settle(need.left - need.right)
    if margin is None:
        return None
    if not letter:
        return at_the_end(need, margin, passage, interval, search, beside)
    if letter not in margin.symbols():
        return ()
    in_time = simplify(margin.substitute({letter: Symbol(TIME)}))  # Beside looks at functions of time
    try:
        running = running_in(passage, interval, search, beside)
        found = None if running is None else list(least_values(in_time, running, beside))
        opened = bool(search.scene.configuration.timeline.state(interval.end).opened)
        if found is not None and running is not None and letter == TIME and opened:
            found.append(
                simplify(in_time.substitute({TIME: running.high}))
            )  # just before, where rest may turn friction round
    except (NotYet, ZeroDivisionError):  # nothing presses without bound: there its form has no value
        return None
    words = f"{need.otherwise} on the way to"
    return (
        None
        if found is None
        else tuple(Requirement(need.owner, ON_THE_WAY, least, ZERO, need.kept, words) for least in found)
    )


def at_the_end(
    need: Requirement, margin: Formula, passage: Passage, interval: Interval, search: Search, beside: Beside
) -> tuple[Requirement, ...] | None:
    """A requirement with the forces of a phase that go by speeds, at its end, where these are largest or smallest; None where untold.

    Nothing of the last state, whose forces are those, and which is looked at as such.
    """
    moving = {travel.moving.name: travel for travel in passage.travels if isinstance(travel.moving, Symbol)}
    own = [name for name in moving if name in margin.symbols()]
    if not own:
        return ()
    single = len(own) == 1 and TIME not in margin.symbols()
    humps = least_at_speeds(margin, own[0], moving[own[0]], beside) if single else None
    speeds = {name: travel.after for name, travel in moving.items()}
    ending = beside.settle(margin.substitute({**speeds, TIME: search.scene.instant(interval.end).time()}))
    if humps is None or ending is None or has_quantities(ending):
        return None
    least = humps if search.scene.configuration.timeline.after(interval.end) is None else [*humps, ending]
    who, how = (f"{spoken(need.owner)} ", "does not slip on the way") if need.kind.grips else ("", need.kept)
    words = f"{who}{need.otherwise} on the way to"
    return tuple(Requirement(need.owner, ON_THE_WAY, value, ZERO, f"{who}{how}", words) for value in least)


def least_at_speeds(margin: Formula, speed: str, travel: Travel, beside: Beside) -> list[Formula] | None:
    """The values of a margin that goes by one speed where it is least between those at both ends of a phase; None where untold."""
    running = margin.substitute({speed: Symbol(TIME)})  # Beside looks at functions of that
    if all(TIME not in differentiate(simplify(side), TIME).symbols() for side in without_size(running)):
        return []  # it only grows, or falls
    first, last = told(travel.before, beside), told(travel.after, beside)
    if first is None or last is None:
        return None
    try:
        low, high = (first, last) if beside.side(last - first) > 0 else (last, first)
        return list(least_values(simplify(running), Running(TIME, low, high), beside))
    except (NotYet, ZeroDivisionError):
        return None


def without_size(margin: Formula) -> list[Formula]:
    """A margin a − |b| as a − b and a + b, of which it is the smaller one; any other as it is."""
    sizes = [node for node in margin.walk("abs") if isinstance(node, Call) and node.function == "abs"]
    if len(sizes) != 1:
        return [margin]
    size, inside = sizes[0], sizes[0].arguments[0]

    def put(way: Formula) -> Formula:
        return margin.transform(lambda node: way if node == size else node, "abs")

    return [put(inside), put(negate(inside))]


def untold_slips(search: Search) -> Iterator[tuple[str, Words]]:
    """What slips in a phase whose forces vary, and is not told to slip as fast or slower up to its end: it may stick on the way."""
    scene = search.scene
    for name, passage in scene.passages.items():
        interval = scene.configuration.timeline.interval(name)
        if interval is None or interval.end == OPEN or not goes_by_speed(passage):
            continue
        lines = scene.configuration.timeline.state(interval.end).conditions
        told_to_stick = {
            line.path.owner for line in lines if line.path is not None and line.word in ("rolls", "sticks")
        }
        for rub in rubs_at(scene.configuration, interval.start):
            if scene.modes.get(rub.key, STICKS) in (FORWARD, BACK) and rub.owner not in told_to_stick:
                rate = rub.rate(scene.instant(interval.end))
                if rate is None or search.apart().settled(rate) is None:
                    way = f"on the way from {spoken(interval.start)} to {spoken(interval.end)}"
                    yield rub.owner, (f"whether {spoken(rub.owner)} stops slipping {way}",)


def goes_by_speed(passage: Passage) -> bool:
    """Whether forces vary with a speed in a phase."""
    return any(travel.pace in (RATE, MIXED) for travel in passage.travels)


def running_letter(passage: Passage) -> str:
    """The letter of what runs in a phase: the time, else the coordinate by which its forces go; '' where nothing does."""
    if any(travel.pace == TIME for travel in passage.travels):
        return TIME
    places = (travel.coordinate for travel in passage.travels if travel.pace == POSITION)
    return next((place.name for place in places if isinstance(place, Symbol)), "")


def running_in(passage: Passage, interval: Interval, search: Search, beside: Beside) -> Running | None:
    """What runs in a phase, between its ends in order; None where nothing tells them."""
    letter = running_letter(passage)
    if letter == TIME:
        clock = [told(search.scene.instant(state).time(), beside) for state in (interval.start, interval.end)]
        return None if clock[0] is None or clock[1] is None else Running(TIME, clock[0], clock[1])
    for travel in passage.travels:
        if travel.coordinate == Symbol(letter) and travel.start is not None and travel.end is not None:
            start, end = (told(signed(value, travel.sense), beside) for value in (travel.start, travel.end))
            if start is None or end is None:
                return None
            return Running(letter, start, end) if beside.side(end - start) > 0 else Running(letter, end, start)
    return None


def told(value: Formula, beside: Beside) -> Formula | None:
    """An end as the laws tell it; as a number where all its letters have one."""
    found = beside.settle(value)
    number = None if found is None else found.substitute(dict(beside.signs.values))
    return found if number is None or number.symbols() else number


def least_values(margin: Formula, running: Running, beside: Beside) -> Iterator[Formula]:
    """The values of a running margin where it is least within a phase; none where letters alone tell that it is positive there."""
    slope = simplify(differentiate(margin, TIME))
    if margin.symbols() - set(beside.values) - {TIME} or beside.signs.by_letters(slope) is not None:
        return
    bend = differentiate(slope, TIME)
    places = solve_polynomial(slope, TIME) or solve_trig(slope, TIME)
    period = period_of(slope, TIME)
    doubtful = [place for place in places if may_be_least(margin, bend, place, beside)]
    if places and not doubtful:
        return
    if not places and period is not None:
        raise NotYet("where it is least has no closed form")
    for mark in zeros_between(slope, doubtful, period, running, beside):
        least = simplify(margin.substitute({TIME: mark}))
        if beside.signs.by_letters(least) != 1 and beside.side(bend.substitute({TIME: mark})) == 1:
            yield least


def may_be_least(margin: Formula, bend: Formula, place: Formula, beside: Beside) -> bool:
    """Whether letters leave it open that a margin is least at a place, and not positive there."""
    if beside.signs.by_letters(simplify(bend.substitute({TIME: place}))) == -1:
        return False  # largest there
    return beside.signs.by_letters(simplify(margin.substitute({TIME: place}))) != 1


def zeros_between(
    slope: Formula, places: list[Formula], period: Formula | None, running: Running, beside: Beside
) -> list[Formula]:
    """The zeros of a slope between the ends of a way, at these places and whole periods from them; of a slope without period all."""
    if period is None:
        return beside.zeros(slope, running.low, running.high)
    found: list[Formula] = []
    for place in places:
        first, last = (beside.number((end - place) / period) for end in (running.low, running.high))
        repeats = range(ceil(first) - 1, floor(last) + 2)  # with those next to the ends, which letters may let in
        if len(repeats) > MOST_PLACES:
            raise NotYet("it is least at too many places")
        found += [simplify(place + number * period) for number in repeats]
    inner = [mark for mark in found if beside.side(mark - running.low) == 1 == beside.side(running.high - mark)]
    return list(dict.fromkeys(inner))
