"""Lines of states in space as equations: what no moment puts in by itself, as forces and energies, and what nothing else has read."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rotsolve.algebra.formula import add, negate
from rotsolve.core.equation import CONDITION, Equation
from rotsolve.core.faults import Unsolvable
from rotsolve.core.remembered import forgetting
from rotsolve.core.symbols import is_key
from rotsolve.core.writing import in_direction
from rotsolve.language.problem import Term
from rotsolve.paths.meaning import NotYet, Unclear, label_of
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.moment import SpaceMoment

States = Mapping[str, SpaceLaws]  # what the laws speak of at each state

PUSHING = ("force", "torque")
TOLD_OF_BODIES = ("kinetic_energy", "energy", "speed", "momentum")


def told_of_forces(laws: SpaceLaws, states: States) -> Iterator[Equation]:
    """What a state tells of forces and couples, energies and the like, as an equation each: nothing else would put it in."""
    moment, bodies = laws.moment, laws.moment.held.bodies
    for number, line in enumerate(moment.state.conditions):
        path, value = line.path, line.value
        told = TOLD_OF_BODIES if path is not None and path.owner in bodies else PUSHING
        if path is None or value is None or path.quantity not in told:
            continue
        yield from line_as_equation(number, laws, states)


def told_unread(laws: SpaceLaws, states: States) -> Iterator[Equation]:
    """What a state tells that no law has read, as how a point moves just after a blow, where it can be asked for as well.

    Of a vector some components may be told already.
    """
    moment, telling = laws.moment, set()
    refuse_rest_in_time(moment)
    for number, line in enumerate(moment.state.conditions):
        if line.path is None or line.value is None or not line.path.owner:
            continue
        by_time = moment.told_by_time(line.path.owner, line.path.quantity)
        if number in moment.used and not by_time:
            continue
        before = set(moment.used)
        with forgetting(moment, laws):
            try:
                *others, told = line_as_equation(number, laws, states)
            except (Unsolvable, NotYet, Unclear):  # it stays unread, and is refused as such
                moment.used = before
                continue
        tells = tells_something(told, moment)
        differs = not moment.held.vanishes(add(told.left, negate(told.right)))
        if by_time and differs and not tells:
            moment.refuse_told_in_time(line.path.owner, line)
        if tells or differs:
            telling.add(line.span)
            yield from (*others, told)
        else:  # it is told already, or is what tells it: then whoever asks for that reads it
            moment.used = before
    for number, line in enumerate(moment.state.conditions):
        if line.whole and line.span in telling:
            moment.used.add(number)


def refuse_rest_in_time(moment: SpaceMoment) -> None:
    """Refuse `at rest` of a body at a state to which a steady precession leads it."""
    for line in (line for line in moment.state.conditions if line.rest):
        for name in moment.held.order:
            if line.owner in ("", "all", name) and moment.told_by_time(name, "precession"):
                moment.refuse_told_in_time(name, line)


def tells_something(equation: Equation, moment: SpaceMoment) -> bool:
    """Whether an equation tells something that is not given."""
    asked = {given.name for given in moment.held.problem.givens if given.asked}
    return any(is_key(letter) or letter in asked for letter in equation.symbols())


def line_as_equation(number: int, laws: SpaceLaws, states: States) -> Iterator[Equation]:
    """A line of a state as an equation for what it is about, with the laws that tell that."""
    from rotsolve.space.reader import SpaceReader, plainly_named

    moment, line = laws.moment, laws.moment.state.conditions[number]
    path, value = line.path, line.value
    assert path is not None and value is not None
    along = line.axes or (line.relative if line.relative in moment.held.bodies else None)
    term = Term(path, axes=along, relative=line.relative or None)
    meaning = SpaceReader(laws, states, moment.held.problem).meaning(path, term)
    yield from meaning.laws
    words = in_direction(label_of(plainly_named(path), term), path.component or "", in_space=True)
    moment.used.add(number)
    yield CONDITION.equation(meaning.formula, value, moment.when, words=f", {words}")
