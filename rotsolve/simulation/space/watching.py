"""Watching in space: the states of a scene that a motion comes to, and a floor that it leaves."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rotsolve.algebra.formula import Formula, negate
from rotsolve.algebra.tape import HALF, ONE, Exact
from rotsolve.core.vectors.heading import heading
from rotsolve.core.writing import spoken
from rotsolve.language.problem import EXTREMES, Condition, State
from rotsolve.paths.meaning import NotYet
from rotsolve.simulation.series import rough_value
from rotsolve.simulation.space.compiling import SpaceSystem
from rotsolve.simulation.space.outputs import Tilting
from rotsolve.simulation.watches import BREAKS, REACHED, Watch, changing, time_gone


def watches_in_space(system: SpaceSystem, ahead: State | None, since: Mapping[str, Exact]) -> list[Watch]:
    """All that may happen in a system; `ahead` is the state of the scene that comes next, `since` what was told at the last one."""
    return changing(system, list(of_floors(system)), [] if ahead is None else list(coming(ahead, system, since)))


def of_floors(system: SpaceSystem) -> Iterator[Watch]:
    """What rolls leaves its floor where that would have to pull; a wheel falls flat where its tilt comes to 0° or 180°."""
    moment, starts = system.moment, {item.letter: item.start for item in system.variables}
    for need in system.laws.pushes.needs():
        joint = moment.held.joint(need.owner)
        assert joint is not None
        name, floor = joint.body.owner, joint.carrier.owner
        place = system.tape.formula(need.left, system.letters)
        if rough_value(system.tape, place, starts) < 0:
            raise NotYet(f"`{floor}` would have to pull `{name}` at first: it does not roll there", joint.body.span)
        yield Watch(BREAKS, place, f"{spoken(name)} leaves `{floor}`")
        if moment.nods(name):
            sine = heading(moment.nodding(name).angles[1]).sin()
            yield Watch(BREAKS, system.tape.formula(sine, system.letters), f"{spoken(name)} falls flat on `{floor}`")


def coming(state: State, system: SpaceSystem, since: Mapping[str, Exact]) -> Iterator[Watch]:
    """When a state is reached: where the first of its lines that tells a single number holds."""
    for line in state.conditions:
        place = gap_in_space(line, system, since)
        if place is not None:
            yield Watch(REACHED, place, state.name, falls=line.word in EXTREMES)
            return


def gap_in_space(line: Condition, system: SpaceSystem, since: Mapping[str, Exact]) -> int | None:
    """The place of what is zero where a line holds; where a tilt is largest or smallest, of what falls through zero."""
    path, tape = line.path, system.tape
    if path is None or path.component or path.point or line.axes or line.relative:
        return None
    if path.quantity == "time" and line.value is not None:
        return time_gone(line.value, system, since)
    if path.quantity == "tilt" and system.moment.held.axis(path.owner) is not None:
        return tape.formula(gap_of_tilt(line, Tilting(system.moment, path.owner)), system.letters)
    if line.value is None:
        return None
    place = system.outputs.get(f"{path.owner}.{path.quantity}")
    if place is None:
        return None
    beyond = tape.sum([(place, ONE), (tape.formula(line.value, system.letters), -ONE)])
    turned = path.quantity == "angle"  # one of the places on its circle
    return tape.function("sin", tape.scaled(beyond, HALF)) if turned else beyond


def gap_of_tilt(line: Condition, tilting: Tilting) -> Formula:
    """cos θ₀ − cos θ; sin θ times the rate at which it comes to its largest or smallest."""
    if line.value is not None:
        return heading(line.value).cos() - tilting.height
    return tilting.sinking if line.word == "largest" else negate(tilting.sinking)
