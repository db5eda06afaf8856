"""Coming: whether the motion of a scene in space comes to a later state: the rates that it would have there are real, and those on the way;
and whether there is a steady one where a state says so.

A kinetic energy, or a force, may have a number at a place to which nothing gets: by the energy it would be less than nothing there. And
what swings on a hinge may have to pass its highest place before.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import TYPE_CHECKING, cast

from rotsolve.algebra.formula import Symbol
from rotsolve.core.faults import NoSteadyMotion, Unsolvable
from rotsolve.core.symbols import has_quantities
from rotsolve.language.block import asked_parts, names_of_parts, speaks_of_all
from rotsolve.motion.timeline import Interval
from rotsolve.search.answers import NoAnswer
from rotsolve.search.search import Search, is_unreal

if TYPE_CHECKING:
    from rotsolve.space.laws import SpaceLaws
    from rotsolve.space.scene import SpaceEquations

STEADY = ("precession",)  # with which a state is steady
COMING = ("angular_velocity", "nutation")  # the rates with which a body comes to an angle or a tilt


def not_come_to(search: Search) -> Iterator[Unsolvable]:
    """Why the motion does not come to a later state, or no state is steady, where what is asked there does not show it."""
    problem = search.scene.configuration.problem
    whole = any(speaks_of_all(term.path) for find in problem.finds for term in find.terms)
    asked = names_of_parts(problem) if whole else asked_parts(problem)
    for state in problem.states:
        if state.steady:
            yield from without_rates(state.name, STEADY, search, asked)
    timeline = search.scene.configuration.timeline
    for interval in timeline.intervals:
        if interval.event is None and interval.end in dynamics_of(search) and not timeline.at_rest(interval):
            yield from without_rates(interval.end, COMING, search)
            yield from below_summit(interval, search)
            yield from in_equilibrium(interval, search)
            yield from off_its_way(interval, search)


def in_equilibrium(interval: Interval, search: Search) -> Iterator[Unsolvable]:
    """The bodies on hinges, or at a fixed point, that are at rest where nothing turns them, and never come to another angle, or tilt."""
    from rotsolve.space.summit import stays_put, stays_upright

    configuration, dynamics = search.scene.configuration, dynamics_of(search)
    for body in configuration.problem.bodies:
        for word, stays in (("angle", stays_put), ("tilt", stays_upright)):
            first, last = (dynamics[state].moment.stood(body.name, word) for state in (interval.start, interval.end))
            if first is None or last is None or search.numbers.side(last - first) in (0, None):
                continue
            if stays(body.name, dynamics[interval.start], search.numbers.side):
                why = f"`{body.name}` is at rest there in equilibrium, and stays so"
                yield never_there(interval.start, interval.end, why, search)


def off_its_way(interval: Interval, search: Search) -> Iterator[Unsolvable]:
    """What sets out away from a place for ever, turns back before it, or rests in balance, on a joint of whatever carries it."""
    lines = search.scene.configuration.timeline.state(interval.end).conditions
    if any(line.path is not None and line.path.quantity in ("angle", "position") for line in lines):
        from rotsolve.search.ways_on_joints import barred_ways

        yield from barred_ways(interval, search)


def dynamics_of(search: Search) -> Mapping[str, SpaceLaws]:
    """The laws at each state of a scene in space."""
    return cast("SpaceEquations", search.scene).dynamics


def without_rates(
    state: str, kinds: tuple[str, ...], search: Search, asked: Collection[str] | None = None
) -> Iterator[Unsolvable]:
    """The rates at a state that have no real value, of the bodies on which it hangs what is asked."""
    registry, aside, problem = search.scene.registry, search.apart(), search.scene.configuration.problem
    for name, item in list(registry.quantities.items()):
        if item.kind not in kinds or item.component or item.when != state:
            continue
        if asked is not None and item.owner not in asked:
            continue
        rate = registry.ask(item)
        letter = rate.name if isinstance(rate, Symbol) and rate.name in problem.sought else name
        if letter != name or has_quantities(search.solver.with_found(rate)):
            try:
                value = aside.value_of(letter)
                if value is not None and is_unreal(value, aside):
                    yield never_comes(state, search)
            except NoSteadyMotion as error:
                yield error
            except NoAnswer as error:
                if error.equation is not None:
                    from rotsolve.search.explain import contradicted

                    yield contradicted(aside.planner.pool[error.equation], search.scene)
            except Unsolvable:  # several steady motions are possible, of which none is meant
                continue


def never_comes(state: str, search: Search) -> Unsolvable:
    """That a motion does not come to a state, since a rate would be the root of less than nothing there."""
    before = search.scene.configuration.timeline.before(state)
    why = "a rate there would be the root of a negative number"
    return never_there(before.start if before else state, state, why, search)


def never_there(start: str, end: str, why: str, search: Search) -> Unsolvable:
    """That a motion does not get from a state to another."""
    from rotsolve.search.explain import unreachable

    configuration = search.scene.configuration
    return unreachable(configuration.problem, start, end, configuration.timeline.state(end).span, why)


def below_summit(interval: Interval, search: Search) -> Iterator[Unsolvable]:
    """The bodies on hinges that would have to pass their highest place on the way, and have not the energy for it, or that turn the other
    way, and have it."""
    from rotsolve.space.summit import summit_of

    numbers, configuration = search.numbers, search.scene.configuration
    before, after = (dynamics_of(search)[state] for state in (interval.start, interval.end))
    for body in configuration.problem.bodies:
        found = summit_of(body.name, before, after, numbers.side)
        if found is None:
            continue
        ends = found.start, found.end
        backwards = numbers.side(ends[1] - ends[0]) == -1
        counts = [numbers.whole(-end if backwards else end) for end in ends]
        left = search.apart().settled(found.left)
        if left is None:
            continue
        rate = search.apart().settled(found.rate)
        away = rate is not None and numbers.signs.of_sizes(rate) == (1 if backwards else -1)
        if away and numbers.side(left) in (0, 1):
            why = f"`{body.name}` turns the other way, and has the energy to pass its highest place ever again"
            yield never_there(interval.start, interval.end, why, search)
        elif None not in counts and counts[0] != counts[1] and numbers.side(left) == -1:
            why = f"`{body.name}` would have to pass its highest place on the way, and turns back before"
            yield never_there(interval.start, interval.end, why, search)
