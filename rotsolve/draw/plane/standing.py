"""Standing as found: how bodies stand at a state that does not tell it, by the answers of the scene."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Number, Symbol
from rotsolve.confirm.model import Model
from rotsolve.draw.plane.places.numbers import numbers_for
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Condition, Path, Problem, State

if TYPE_CHECKING:
    from rotsolve.search.acting import ActingWays

ANGLE = "angle"


def as_found(problem: Problem, state: str, scene: SceneEquations, ways: ActingWays | None) -> Problem:
    """The scene for a stage: with the angles at a state and the letters that are asked for as the answers have them."""
    givens = []
    for given in problem.givens:
        asked = ways is not None and given.asked and given.trial is None
        size = ways.number(Symbol(given.name)) if ways is not None and asked else None
        givens.append(given if size is None else replace(given, trial=Number(Fraction(size))))
    angles = (*angles_kept(state, scene), *angles_found(state, scene, ways))
    states = [told_too(item, angles) if item.name == state else item for item in problem.states]
    return replace(problem, givens=tuple(givens), states=tuple(states))


def told_too(state: State, angles: tuple[Condition, ...]) -> State:
    """A state that tells some angles more."""
    told = {line.path.owner for line in state.conditions if is_angle_told(line) and line.path is not None}
    more = tuple(line for line in angles if line.path is not None and line.path.owner not in told)
    return replace(state, conditions=(*state.conditions, *more))


def is_angle_told(line: Condition) -> bool:
    """Whether a line of a state tells an angle."""
    return line.path is not None and line.path.quantity == ANGLE and line.value is not None


def angles_kept(state: str, scene: SceneEquations) -> Iterator[Condition]:
    """The angles that the states before the events tell which have led to a state: nothing has turned in these, but what holds a body may
    be another then, and so from where its angle is told."""
    timeline, configuration = scene.configuration.timeline, scene.configuration
    before, now = timeline.before(state), None
    while before is not None and before.event is not None:
        then = None
        for line in filter(is_angle_told, timeline.state(before.start).conditions):
            if line.path is None or line.value is None:
                continue
            if line.path.owner not in configuration.bodies:
                yield line
                continue
            then = then or Model(configuration.problem, numbers_for(configuration), before.start)
            now = now or Model(configuration.problem, numbers_for(configuration), state)
            other = now.lean(line.path.owner) - then.lean(line.path.owner)
            yield replace(line, value=line.value + Number(Fraction(other))) if other else line
        before = timeline.before(before.start)


def angles_found(state: str, scene: SceneEquations, ways: ActingWays | None) -> Iterator[Condition]:
    """The angles on which it hangs where forces act at a state, and which way, as far as the answers tell them."""
    if ways is None:
        return
    quantities = scene.registry.quantities
    for key in sorted(letters_of_arms(state, scene)):
        quantity = quantities.get(key)
        if quantity is not None and quantity.kind == ANGLE and not quantity.component:
            size = ways.number(Symbol(key))
            if size is not None:
                yield Condition(Path(quantity.owner, ANGLE), Number(Fraction(size)))


def letters_of_arms(state: str, scene: SceneEquations) -> set[str]:
    """The letters of the directions and arms of all forces at a state."""
    forces = [force for body in scene.facts(state).bodies for force in body.forces]
    parts = [part for force in forces for vector in (force.direction, force.arm) for part in vector.parts]
    formulas: list[Formula] = [part for size, heading in parts for part in (size, heading.formula())]
    return {name for formula in formulas for name in formula.symbols()}
