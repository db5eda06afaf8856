"""Turning: where a motion that goes by its place turns back before it gets to a state, or never gets there.

Its speed at any place tells: ½ v² = ½ v₀² + ∫ a ds. It goes on one way as long as that is positive.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.calculus.integral import integrate_by_hand
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.certified.rootfind import real_roots
from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig
from rotsolve.algebra.formula import HALF, PI, ZERO, Formula, Integral, Number, Symbol
from rotsolve.core.equation import NEWTON
from rotsolve.core.facts import signed
from rotsolve.core.faults import UNSOLVED
from rotsolve.core.passage import Passage, Travel
from rotsolve.core.symbols import POSITION, has_quantities, is_quantity
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Condition, State
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.timeline import Interval
from rotsolve.search.answers import unsolvable
from rotsolve.search.openings import tell_openings
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search

Settled = Callable[["Formula | None"], "Formula | None"]
ONWARD, BACK, NEVER = "onward", "back", "never"
CLOSE = 1e-6  # how far places in the case looked at may be apart that are the same


class Way(Struct, frozen=True):
    """A coordinate along a phase, by its positive sense: where it starts and ends, its first speed, and which way it sets out."""

    travel: Travel
    start: Formula
    end: Formula
    speed: Formula
    sets_out: int


def turned_on_way(
    passage: Passage, settled: Settled, search: Search, *, stuck: bool = False
) -> tuple[Travel, str] | None:
    """A coordinate that does not go straight from one end of a phase to the other, and whether it has to turn back or never arrives.

    Which way it goes at the end tells that only where it has an answer, not where it is `stuck`.
    """
    for travel in passage.travels:
        way = way_of(travel, settled, search) if travel.pace == POSITION else None
        if way is None or not way.sets_out:
            continue
        ahead = search.numbers.side(way.end - way.start)
        timed = not has_quantities(passage.times[1])  # up to a told time it is followed to and fro
        if ahead not in (None, way.sets_out) or (not timed and not stuck and goes_back(way, settled, search)):
            return travel, BACK
        if stopped(way, search) or falls_short(way, search):
            return travel, NEVER
    return None


def goes_back(way: Way, settled: Settled, search: Search) -> bool:
    """Whether a coordinate goes the other way at the end of its phase than it set out."""
    speed = settled(way.travel.after)
    return speed is not None and search.numbers.side(speed) == -way.sets_out


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
    """Whether ½ v₀² + ∫ a ds is not positive at a place between the ends where it is smallest: where a vanishes."""
    travel, pull = way.travel, pull_on(way, search)
    if pull is None or not isinstance(travel.coordinate, Symbol):
        return False
    ends = (signed(way.start, travel.sense), signed(way.end, travel.sense))
    if any(map(has_quantities, ends)):
        return False
    letters = {name for value in (pull, *ends) for name in value.symbols()} - {travel.coordinate.name}
    return (barred_in_letters if letters - search.values.keys() else barred)(PushedWay(way, pull, *ends), search)


class PushedWay(Struct, frozen=True):
    """A way with the acceleration by the place, and the places of both ends."""

    way: Way
    pull: Formula
    start: Formula
    end: Formula

    @property
    def letter(self) -> str:
        """The letter of the place."""
        assert isinstance(self.way.travel.coordinate, Symbol)
        return self.way.travel.coordinate.name

    def vanishing(self, values: Mapping[str, Formula]) -> list[float]:
        """Where the acceleration vanishes between the ends, by numbers of all letters; Undefined where they do not tell."""
        forward = self.way.sets_out * self.way.travel.sense > 0
        low, high = (self.start, self.end) if forward else (self.end, self.start)
        return [root.float for root in real_roots(self.pull, self.letter, values, low, high).roots]

    def places_in_letters(self, search: Search) -> list[Formula]:
        """Where the acceleration vanishes, as far as that has a closed form; of angles once round each way too."""
        order, positive = search.solver.order, search.solver.positive
        roots = solve_polynomial(self.pull, self.letter, order=order, positive=positive)
        if roots:
            return roots
        angles = solve_trig(self.pull, self.letter, order=order, positive=positive)
        return [root + turn for root in angles for turn in (-2 * PI, ZERO, 2 * PI)]


def barred(pushed: PushedWay, search: Search) -> bool:
    """By numbers."""
    try:
        for place in pushed.vanishing(search.values):
            gained = Integral(pushed.pull, pushed.letter, pushed.start, Number(Fraction(place)))
            if (evaluate(HALF * pushed.way.speed**2 + gained, search.values, digits=8).sign or 0) < 0:
                return True
    except (Undefined, ZeroDivisionError):
        pass
    return False


def barred_in_letters(pushed: PushedWay, search: Search) -> bool:
    """In letters, where the places have closed forms: that one lies between the ends, and is got past, is a condition of the case."""
    side, positive = search.numbers.side, search.solver.positive
    ahead = pushed.way.sets_out * pushed.way.travel.sense
    roots = pushed.places_in_letters(search)
    if unaccounted(pushed, roots, search):
        problem, name = search.scene.configuration.problem, pushed.way.travel.body
        message = f"in letters nothing tells whether `{name}` gets past the place at which it is slowest: not solved"
        span = search.scene.configuration.bodies[name].span
        raise unsolvable(problem, message, span, "give numbers to the letters", kind=UNSOLVED)
    for root in roots:
        turns = differentiate(pushed.pull, pushed.letter).substitute({pushed.letter: root})
        if side(turns) == -1:  # it is fastest there
            continue
        if side((root - pushed.start) * ahead) != 1 or side((pushed.end - root) * ahead) != 1:
            continue
        gained = integrate_by_hand(pushed.pull, pushed.letter, pushed.start, root, positive=positive)
        if gained is not None and not has_quantities(gained) and side(HALF * pushed.way.speed**2 + gained) != 1:
            return True
    return False


def unaccounted(pushed: PushedWay, known: Sequence[Formula], search: Search) -> bool:
    """Whether the acceleration vanishes somewhere else between the ends, with the numbers of the case that is looked at."""
    values = {**search.values, **search.signs.trials}
    try:
        places = [evaluate(end, values).float for end in (pushed.start, pushed.end)]
        found = pushed.vanishing(values)
    except (Undefined, ValueError, ZeroDivisionError):
        return False
    for root in known if found else ():
        with suppress(Undefined, ValueError, ZeroDivisionError):
            places.append(evaluate(root, values).float)
    return any(all(abs(one - other) > CLOSE for other in places) for one in found)
