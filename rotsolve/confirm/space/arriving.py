"""Arriving: what a state tells beside its time, held against where the motion leads in that time.

The time alone says how all stands and moves then, so that each other line is a statement about it, which holds or does not.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

from rotsolve.confirm import NotConfirmed, Unfit
from rotsolve.confirm.space.arrows import arrow_length
from rotsolve.confirm.space.readings import Reading
from rotsolve.confirm.space.rig import Rig
from rotsolve.confirm.space.ties import ROUND, SPEED, TURNING
from rotsolve.confirm.space.worlds import World
from rotsolve.core.quantity import DIRECTED
from rotsolve.language.problem import Condition, State, Term

HOLDS = 2e-6  # of the size of what a line tells
LEAST = 1e-3  # a size beside which rounding counts
ROUND_THE_AXIS = {
    "precession_angle": "precession",
    "spin_angle": "spin",
}  # angles told to whole turns here: their rates
Counting = Callable[[Condition, float], float]
MOVING = (SPEED, TURNING)


def hold_lines(rig: Rig, worlds: Sequence[World], state: State, counted: Counting) -> None:
    """Refuse a state of which a line does not hold in the worlds to which the time leads that it tells, with whole turns `counted`."""
    from rotsolve.confirm.space.flight import line_in_words

    for world in worlds:
        for line, gap, size in gaps_at(rig, world, state):
            if abs(counted(line, gap)) > HOLDS * max(size, LEAST):
                raise Unfit(f"{line_in_words(line)} at `{state.name}` does not follow from the time that has passed")


def gaps_at(rig: Rig, world: World, state: State) -> Iterator[tuple[Condition, float, float]]:
    """The lines of a state beside its time, by how much each is not so in a world, and how large what it tells is."""
    from rotsolve.confirm.space.flight import Flight

    for line in state.conditions:
        if line.rest:
            names = [name for name in rig.bodies if line.owner in ("", "all", name)]
            yield from ((line, arrow_length(world.now.arrow(kind, name)), 0.0) for name in names for kind in MOVING)
        elif line.path is None or line.path.quantity == "time":
            continue
        elif line.path.quantity in DIRECTED:
            yield line, *gap_of_vector(rig, world, line)
        else:
            gap = Flight(rig, world, state).gap_of(line)(world)
            told = 0.0 if line.value is None else abs(rig.value(line.value))
            turned = line.path.quantity in ROUND_THE_AXIS
            yield line, math.remainder(gap, ROUND) if turned else gap, told


def gap_of_vector(rig: Rig, world: World, line: Condition) -> tuple[float, float]:
    """By how much a component of a vector is not as told, and how large the vector is."""
    assert line.path is not None
    if line.value is None:
        raise NotConfirmed(f"a line about `{line.path.quantity}` on the way")
    term = Term(line.path, axes=line.axes or line.relative or None, relative=line.relative or None)
    reading = Reading(world)
    return reading.number(term) - rig.value(line.value), reading.size(term)
