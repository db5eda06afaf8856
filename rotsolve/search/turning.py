"""Turning: where a motion that goes by its place turns back before it gets to a state, or never gets there.

Its speed at any place tells: ½ v² = ½ v₀² + ∫ a ds. It goes on one way as long as that is positive.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.integral import integrate_by_hand
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.certified.rootfind import real_roots
from rotsolve.algebra.formula import HALF, Formula, Integral, Number, Symbol
from rotsolve.core.equation import NEWTON
from rotsolve.core.facts import signed
from rotsolve.core.passage import Passage, Travel
from rotsolve.core.symbols import POSITION, has_quantities, is_quantity
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Condition, State
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.timeline import Interval
from rotsolve.search.openings import tell_openings
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search

Settled = Callable[["Formula | None"], "Formula | None"]
ONWARD, BACK, NEVER = "onward", "back", "never"


class Way(Struct, frozen=True):
    """A coordinate along a phase, by its positive sense: where it starts and ends, its first speed, and which way it sets out."""

    travel: Travel
    start: Formula
    end: Formula
    speed: Formula
    sets_out: int


def turned_on_way(passage: Passage, settled: Settled, search: Search) -> tuple[Travel, str] | None:
    """A coordinate that does not go straight from one end of a phase to the other, and whether it has to turn back or never arrives."""
    for travel in passage.travels:
        way = way_of(travel, settled, search) if travel.pace == POSITION else None
        if way is None or not way.sets_out:
            continue
        ahead = search.numbers.side(way.end - way.start)
        if ahead != way.sets_out:
            return travel, BACK
        if stopped(way, search) or falls_short(way, search):
            return travel, NEVER
    return None


def way_of(travel: Travel, settled: Settled, search: Search) -> Way | None:
    """The way of a coordinate, where all of it is known in numbers of the scene."""
    if travel.start is None or travel.end is None or not isinstance(travel.coordinate, Symbol):
        return None
    start, end, speed = (settled(value) for value in (travel.start, travel.end, travel.before))
    if start is None or end is None or speed is None:
        return None
    sets_out = search.numbers.side(speed)
    if sets_out == 0:
        push = settled(travel.initial)
        sets_out = search.numbers.side(push) if push is not None else None
    return Way(travel, start, end, speed, sets_out or 0)


def time_to_turn(interval: Interval, line: Condition, search: Search) -> Formula | None:
    """How long a phase would last up to where a line holds, which says that something turns back; None where the laws do not tell it.

    It is asked of a scene of its own that ends there.
    """
    configuration = search.scene.configuration
    problem, timeline = configuration.problem, configuration.timeline
    states = (*timeline.states[: timeline.order[interval.start] + 1], State("#turn", (line,), opened="turns back"))
    names = {state.name for state in states}
    events = tuple(event for event in problem.events if {event.from_, event.to} <= names)
    ended = replace(problem, states=states, events=events, phases=(), finds=())
    own = Search(SceneEquations(Configuration(ended), search.scene.modes), families_for(None), careful=True)
    tell_openings(own)
    passage = next(reversed(own.scene.passages.values()))
    return own.settled(passage.duration)


def pull_on(way: Way, search: Search) -> Formula | None:
    """The acceleration of a coordinate along its way, by its place; None where the laws do not tell it."""
    travel = way.travel
    push = search.beside_by((NEWTON,)).settled(travel.acceleration) if is_quantity(travel.acceleration) else None
    return signed(push * travel.arm, travel.sense) if push is not None else None


def falls_short(way: Way, search: Search) -> bool:
    """Whether ½ v₀² + ∫ a ds is negative at the end; of letters that is a condition of the case."""
    pull, travel = pull_on(way, search), way.travel
    if pull is None or not isinstance(travel.coordinate, Symbol):
        return False
    ends = [signed(place, travel.sense) for place in (way.start, way.end)]
    gained = integrate_by_hand(pull, travel.coordinate.name, *ends, positive=search.solver.positive)
    if gained is None or has_quantities(gained):
        return False
    return search.numbers.side(HALF * way.speed**2 + gained) == -1


def stopped(way: Way, search: Search) -> bool:
    """Whether ½ v₀² + ∫ a ds is negative at a place between the ends where it is smallest: where a vanishes."""
    travel, values, pull = way.travel, search.values, pull_on(way, search)
    if pull is None or not isinstance(travel.coordinate, Symbol):
        return False
    letter = travel.coordinate.name
    ends = [signed(place, travel.sense) for place in (way.start, way.end)]
    if {name for name in pull.symbols() - values.keys() if name != letter} or any(map(has_quantities, ends)):
        return False
    low, high = ends if way.sets_out * travel.sense > 0 else ends[::-1]
    try:
        for root in real_roots(pull, letter, values, low, high).roots:
            gained = Integral(pull, letter, ends[0], Number(Fraction(root.float)))
            if (evaluate(HALF * way.speed**2 + gained, values, digits=8).sign or 0) < 0:
                return True
    except (Undefined, ZeroDivisionError):
        pass
    return False
