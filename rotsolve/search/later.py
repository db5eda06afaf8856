"""Later: the equations of what comes behind all that states tell but by the clock: they tell nothing of what was before.

A block leaves a dome and flies on for a second: its flight says nothing of where it leaves, though its equations outnumber their unknowns.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import Formula
from rotsolve.core.symbols import is_key, key_of
from rotsolve.language.problem import State
from rotsolve.search.planning import OF_ONE_MOMENT

if TYPE_CHECKING:
    from rotsolve.core.equation import Equation
    from rotsolve.motion.configuration import Configuration
    from rotsolve.motion.timeline import Timeline


def later_on(meaning: Formula, configuration: Configuration, pool: Sequence[Equation]) -> set[int]:
    """The equations, by their place in the pool, of what is behind the letters of a formula and of which only times are told."""
    timeline, problem = configuration.timeline, configuration.problem
    if problem.space:  # there the laws of a motion in time tell it from its start on
        return set()
    telling = [number for number, state in enumerate(timeline.states) if tells(state)]
    last = max(telling, default=0)
    if last == len(timeline.states) - 1 or problem.sought or any(find.where is not None for find in problem.finds):
        return set()
    own = [number_of_state(key_of(name).when, timeline) for name in meaning.symbols() if is_key(name)]
    last = max([last, *own]) if own and min(own) >= 0 else len(timeline.states)
    while last < len(timeline.intervals) and timeline.intervals[last].event is not None:
        last += 1  # a blow from there on belongs to it
    begun = (
        {phase.name for phase in timeline.intervals if timeline.order[phase.start] == last}
        if momentary(meaning)
        else set()
    )
    return {
        index
        for index, law in enumerate(pool)
        if number_of_state(law.section, timeline) > last and law.section not in begun
    }


def momentary(meaning: Formula) -> bool:
    """Whether a formula speaks of accelerations or forces, which the laws of the phase that begins there tell as well."""
    return any(key_of(name).kind in OF_ONE_MOMENT for name in meaning.symbols() if is_key(name))


def tells(state: State) -> bool:
    """Whether a state says more than when it is."""
    lines = [line for line in state.conditions if line.path is None or line.path.quantity != "time"]
    return bool(lines) or state.balance or state.steady


def number_of_state(section: str, timeline: Timeline) -> int:
    """The number of the state at which something is, or to which a phase or an event leads; −1 of what is there all the time."""
    if section in timeline.order:
        return timeline.order[section]
    interval = timeline.interval(section)
    return timeline.order[interval.end] if interval is not None else -1
