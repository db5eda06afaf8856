"""On the way: what only pushes or pulls, in a phase whose forces vary in time, where it does so least between the ends.

That a string is taut as a force begins and as it ends does not say that it is so while the force swells.
"""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.facts import ON_THE_WAY, Requirement
from rotsolve.core.symbols import TIME
from rotsolve.motion.timeline import Interval
from rotsolve.paths.meaning import NotYet
from rotsolve.questions.functions_of_time import Beside
from rotsolve.search.search import Search


def least_pushes(search: Search) -> Iterator[tuple[str, tuple[Requirement, ...]]]:
    """By the state at the end of a phase that forces and tensions are not negative where they are least within it."""
    for name, passage in search.scene.passages.items():
        interval = search.scene.configuration.timeline.interval(name)
        if interval is not None and any(travel.pace == "time" for travel in passage.travels):
            needs = [least for need in passage.midst.requirements for least in least_of(need, interval, search)]
            yield interval.end, tuple(needs)


def least_of(need: Requirement, interval: Interval, search: Search) -> Iterator[Requirement]:
    """A requirement at each time within a phase at which it has least to spare; none where the laws do not tell that."""
    if need.kind.grips or need.kind.placed:
        return
    aside = search.apart()
    margin, *clock = (
        aside.settled(value)
        for value in (
            need.left - need.right,
            *(search.scene.instant(state).time() for state in (interval.start, interval.end)),
        )
    )
    if margin is None or None in clock or TIME not in margin.symbols():
        return
    for least in least_values(simplify(margin), clock, Beside(aside.settled, search.signs)):
        yield Requirement(need.owner, ON_THE_WAY, least, ZERO, need.kept, f"{need.otherwise} on the way to")


def least_values(margin: Formula, clock: list[Formula | None], beside: Beside) -> Iterator[Formula]:
    """The values of a function of time where it is least between two times; none where letters alone tell that it is positive there."""
    start, end = clock
    slope = differentiate(margin, TIME)
    if start is None or end is None or margin.symbols() - set(beside.values) - {TIME} or TIME not in slope.symbols():
        return
    bend = differentiate(slope, TIME)
    places = solve_polynomial(slope, TIME) or solve_trig(slope, TIME)
    if all(beside.signs.by_letters(simplify(bend.substitute({TIME: place}))) == -1 for place in places):
        return  # largest there
    try:
        for mark in beside.zeros(slope, start, end):
            least = simplify(margin.substitute({TIME: mark}))
            if beside.signs.by_letters(least) != 1 and beside.side(bend.substitute({TIME: mark})) == 1:
                yield least
    except NotYet:
        return
