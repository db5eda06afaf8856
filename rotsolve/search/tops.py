"""Tops: the highest place of a loop on the way of what slides or rolls inside it, where the loop presses least and has to press still."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import HALF, PI, Formula
from rotsolve.core.derivation import Words
from rotsolve.core.passage import Travel
from rotsolve.core.symbols import has_quantities
from rotsolve.core.writing import spoken
from rotsolve.language.bodies import Orbit
from rotsolve.language.problem import Condition, Path
from rotsolve.motion.timeline import OPEN, Interval
from rotsolve.search.numbers import Numbers
from rotsolve.search.search import Search

Settling = Callable[[Formula | None], Formula | None]  # with all that answers and laws tell
TURN = 2 * PI


def top_passed(interval: Interval, search: Search, settled: Settling, numbers: Numbers) -> tuple[str, Condition] | None:
    """What passes a highest place within a phase, and the line that tells that place; None where nothing does, or no laws tell it."""
    start, end = (search.scene.instant(state) for state in (interval.start, interval.end))
    for travel, circle in inside_loops(interval, search):
        last, before = settled(end.place_on(circle)), start.orbit(travel.body)
        if before is None or last is None or has_quantities(last):
            continue
        if before == circle:
            first = settled(start.place_on(circle))
            rates = settled(travel.before), settled(travel.initial)
            top = top_between(first, last, circle.way * numbers.sign(rates), numbers)
        else:
            rate = settled(travel.after)
            back = rate is not None and numbers.side(rate) == -1
            top = top_led_over(last, -circle.way if back else circle.way, numbers)
        if top is not None:
            return travel.body, Condition(Path(circle.owner, "angle"), simplify(top))
    return None


def inside_loops(interval: Interval, search: Search) -> Iterator[tuple[Travel, Orbit]]:
    """The bodies that are inside a loop at the end of a phase, each with the circle of its centre."""
    end = search.scene.instant(interval.end)
    for travel in search.scene.passages[interval.name].travels:
        circle = end.orbit(travel.body) if travel.kind == "line" else None
        if circle is not None and circle.hollow and circle.radius is not None:
            yield travel, circle


def top_between(first: Formula | None, last: Formula, sense: int, numbers: Numbers) -> Formula | None:
    """The first highest place, 90° and whole turns, between two places on a loop."""
    ahead = numbers.side(last - first) if first is not None and not has_quantities(first) else None
    if first is None or not ahead or ahead != sense:
        return None  # else it comes there the other way round: places are told up to whole turns
    tops = [HALF * PI + turns * TURN for turns in (range(-2, 3) if ahead > 0 else range(2, -3, -1))]
    return next((top for top in tops if numbers.side(top - first) == ahead == numbers.side(last - top)), None)


def top_led_over(last: Formula, sense: int, numbers: Numbers) -> Formula | None:
    """The last highest place before a place on a loop into which a track leads at its lowest place; none in the first half turn from there.

    What is told as if it were behind that lowest place, −90°, is so up to whole turns.
    """
    gone = sense * (last + HALF * PI)
    if numbers.side(gone) == -1:
        gone = next((more for turns in range(1, 4) if numbers.side(more := gone + turns * TURN) != -1), gone)
    return last - sense * (gone - PI) if numbers.side(gone - PI) == 1 else None


def untold_tops(search: Search) -> Iterator[tuple[str, Words]]:
    """Whether what comes to an angle in letters inside a loop leaves it before: nothing tells whether it passes the highest place."""
    for interval in search.scene.configuration.timeline.intervals:
        for travel, circle in inside_loops(interval, search) if interval.event is None and interval.end != OPEN else ():
            place = search.solver.with_found(search.scene.instant(interval.end).place_on(circle))
            if search.signs.lacking(place):
                way = f"on the way from {spoken(interval.start)} to {spoken(interval.end)}"
                yield circle.owner, (f"whether {spoken(travel.body)} leaves the surface {way}",)
