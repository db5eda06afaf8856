"""Lasting: how long functions of time hold where no state ends them: what only pulls or presses has to go on doing so.

`T: rope.tension at any time` of a scene with one state is the tension for as long as the rope is taut.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

from rotsolve.algebra.calculus.derivative import differentiate, period_of
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.core.derivation import Words
from rotsolve.core.facts import ON_THE_WAY, Requirement
from rotsolve.core.symbols import TIME
from rotsolve.core.writing import spoken
from rotsolve.derivation.letters import Letters
from rotsolve.derivation.on_the_way import Running, least_values, told
from rotsolve.language.problem import TimeValue
from rotsolve.motion.rubs import rubs_at
from rotsolve.motion.timeline import OPEN, Interval
from rotsolve.paths.meaning import NotYet
from rotsolve.questions.functions_of_time import Beside
from rotsolve.search.search import Search

Margins = Iterator[tuple[Interval, Requirement, Formula]]


def margins_in_time(search: Search, beside: Beside, *, ended: bool) -> Margins:
    """What only pushes or pulls in the last phase, of which functions of time are asked, as such a function; of one that is `ended` too."""
    timeline = search.scene.configuration.timeline
    interval = timeline.intervals[-1] if timeline.intervals else None
    if interval is None or interval.event is not None or not (ended or interval.end == OPEN):
        return
    for need in search.scene.passages[interval.name].midst.requirements:
        margin = None if need.kind.grips or need.kind.placed else beside.settle(need.left - need.right)
        if margin is not None and TIME in margin.symbols() and margin.symbols() <= {*beside.values, TIME}:
            yield interval, need, margin


def lasting(search: Search, moment: TimeValue | None) -> Iterator[tuple[str, tuple[Requirement, ...]]]:
    """By the state from which the last phase goes on, that what pushes or pulls does so up to the moment at which functions of time are
    evaluated; of no moment in particular, that it always does where that swings."""
    beside = Beside(search.apart().settled, search.signs)
    for interval, need, margin in margins_in_time(search, beside, ended=moment is not None):
        begun = told(search.scene.instant(interval.start).time(), beside)
        if begun is None or (moment is not None and beside.side(moment.value - begun) != 1):
            continue
        when = "at some time after" if moment is None else f"by t = {moment.text}, on the way from"
        for least in least_of_swing(margin) if moment is None else least_up_to(moment.value, margin, begun, beside):
            words = f"{need.otherwise} {when}"
            yield interval.start, (Requirement(need.owner, ON_THE_WAY, least, ZERO, need.kept, words),)


def least_up_to(end: Formula, margin: Formula, begun: Formula, beside: Beside) -> Iterator[Formula]:
    """A margin at the end of a time, and where it is least before, as far as that is told."""
    yield simplify(margin.substitute({TIME: end}))
    with suppress(NotYet):
        yield from least_values(margin, Running(TIME, begun, end), beside)


def least_of_swing(margin: Formula) -> list[Formula]:
    """The values of a margin that swings where its slope vanishes."""
    if period_of(margin, TIME) is None:
        return []
    places = solve_trig(simplify(differentiate(margin, TIME)), TIME)
    return [simplify(margin.substitute({TIME: place})) for place in places]


def endings_told(search: Search, letters: Letters) -> Iterator[tuple[str, Words]]:
    """The time at which a string goes slack or a body lifts off, up to which functions of time hold, or that it isn't told; that it isn't
    told whether something that rubs comes to rest."""
    yield from untold_rests(search)
    beside = Beside(search.apart().settled, search.signs)
    for interval, need, margin in margins_in_time(search, beside, ended=False):
        begun = told(search.scene.instant(interval.start).time(), beside)
        if begun is None or beside.signs.by_letters(margin) == 1 or least_of_swing(margin):
            continue
        try:
            first = first_fall(margin, begun, beside)
        except NotYet:
            yield need.owner, (f"whether {need.otherwise} at some time after {spoken(interval.start)}",)
            continue
        if first is not None:
            time = (
                letters.printed(Symbol(TIME)),
                " = ",
                letters.printed(simplify(first, positive=search.solver.positive)),
            )
            yield need.owner, (need.otherwise, " at ", *time, ": what is told of any time holds up to then")


def untold_rests(search: Search) -> Iterator[tuple[str, Words]]:
    """What slides or turns against friction in the last phase, whose forces vary in time so that nothing tells whether it comes to rest."""
    configuration = search.scene.configuration
    interval = next(iter(configuration.timeline.intervals[-1:]), None)
    if interval is None or interval.end != OPEN:
        return
    for rub in rubs_at(configuration, interval.start):
        if configuration.pace(rub.body, rub.state) != TIME:
            continue
        from rotsolve.search.endings import Endings

        endings = Endings(search)
        sense = endings.sense(rub)
        if sense and endings.stops_ever(interval, rub, sense) is None:
            yield rub.owner, (f"whether {spoken(rub.body)} comes to rest at some time after {spoken(interval.start)}",)


def first_fall(margin: Formula, begun: Formula, beside: Beside) -> Formula | None:
    """The first time after the start at which a margin becomes negative; None where it never does."""
    roots = solve_polynomial(margin, TIME)
    if not roots:
        raise NotYet("a margin has no zero in closed form")
    slope = simplify(differentiate(margin, TIME))
    later = [root for root in roots if beside.side(root - begun) == 1]
    first: Formula | None = None
    for root in later:
        falls = beside.side(slope.substitute({TIME: root})) == -1
        if falls and (first is None or beside.side(first - root) == 1):
            first = root
    return first
