"""Undriven: where a state tells an acceleration of a body that nothing gives it, what would: a force or couple that is as large as it
takes, a hinge that drives it, or the motion as one by which it is led along.

Each is tried before it is printed: with it the scene has answers to all that it asks.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.dimension import FORCE, TORQUE
from rotsolve.core.faults import CONTRADICTORY, Fault
from rotsolve.core.letters import Given
from rotsolve.core.vectors.triple import AXES
from rotsolve.elements.actions import AppliedCouple, AppliedForce
from rotsolve.language.bodies import PointRef
from rotsolve.language.problem import Condition, Problem
from rotsolve.overtold import Solve, StatedQuantity, confirmed_answers, told_numbers, what_else_makes
from rotsolve.scene.elements import ANY

Trial = tuple[str, Problem]  # what to change, in words, and the problem as it is then
DRIVEN_BY: dict[str, Any] = {"acceleration": AppliedForce, "angular_acceleration": AppliedCouple}
RATES = {"acceleration": "velocity", "angular_acceleration": "angular_velocity"}
DIMENSIONS = {"force": FORCE, "couple": TORQUE}
DRIVE = "drive"  # what the force or couple is called
GROUND = ("", "ground", "ceiling")  # owners of points that no body has


def undriven(fault: Fault, problem: Problem, solve: Solve) -> Fault | None:
    """A contradiction as what it is where something that drives a body cures it: nothing gives it what is told; None of others."""
    for told in told_numbers(problem):
        trials = (by_a_force, by_its_hinge, by_leading) if told.path.quantity in DRIVEN_BY else ()
        found = [next((words for words, own in way(told, problem) if answers_all(own, solve)), "") for way in trials]
        if any(found):
            at = f"`{told.state.name}`" if told.state.name else "the state"
            message = f"the data contradict each other: nothing drives `{told.path.owner}` as {at} tells"
            would, cure = what_else_makes(told, problem, solve), ", or ".join(filter(None, found))
            help = f"{would}; to have it so, {cure}" if would else cure
            return replace(fault, message=message, span=told.lines[0].span, help=help, kind=CONTRADICTORY)
    return None


def by_a_force(told: StatedQuantity, problem: Problem) -> Iterator[Trial]:
    """A force or couple that gives a body its acceleration, also without what else a state tells of how it moves."""
    path, kind = told.path, DRIVEN_BY[told.path.quantity]
    name = DRIVE if all(item.name != DRIVE for item in problem.actions) else f"{DRIVE}_of_{path.owner}"
    letter = Given(f"{name}_{kind.word}", None, DIMENSIONS[kind.word], asked=True, automatic=True)
    size = ANY if problem.space else Symbol(letter.name)
    action = kind(name=name, on=PointRef(path.owner, path.point), **{kind.word: size})
    givens = problem.givens if problem.space else (*problem.givens, letter)
    whole = replace(problem, actions=(*problem.actions, action), givens=givens)
    place, strength = ".".join(filter(None, (path.owner, path.point))), ANY if problem.space else "unknown"
    words = f"let a {kind.word} do it, `actions: {{{name}: {{{kind.word}: {strength}, on: {place}}}}}`"
    yield words, whole
    yield from without_rate(words, whole, told)


def without_rate(words: str, problem: Problem, told: StatedQuantity) -> Iterator[Trial]:
    """The same without the velocity that a state tells of a body, where nothing hangs on it."""
    rate = RATES[told.path.quantity]
    if any(tells_any(line, told.path.owner, (rate,)) for state in problem.states for line in state.conditions):
        yield f"{words}, and leave `{told.path.owner}.{rate}` out", without_told(problem, told.path.owner, (rate,))


def by_its_hinge(told: StatedQuantity, problem: Problem) -> Iterator[Trial]:
    """The hinge of a body as one that drives it with the acceleration that a state tells."""
    path, value = told.path, told.lines[0].value
    for item in problem.connections if path.point is None and len(told.lines) == 1 else ():
        held = item.touches()[-1:]
        if path.quantity in item.declared and held and held[0].owner == path.owner:
            others = (replace(own, **{path.quantity: value}) if own is item else own for own in problem.connections)
            trial = replace(without_told(problem, path.owner, (path.quantity,)), connections=tuple(others))
            yield (
                f"write `{path.quantity}: {as_scene_writes(value, problem)}` in `{item.name}`, not in the state",
                trial,
            )


def by_leading(told: StatedQuantity, problem: Problem) -> Iterator[Trial]:
    """A body that is led along with the acceleration that a state tells, with what holds it to the ground, or without that."""
    owner, word = told.path.owner, told.path.quantity
    parts = [(word, (line.path.component or "").split()[-1:], line.value) for line in told.lines if line.path]
    if told.path.point is not None or [axis for _, axis, _ in parts] != [[axis] for axis in AXES] or told.lines[0].axes:
        return
    vector = ", ".join(as_scene_writes(value, problem) for _, _, value in parts)
    words = f"lead it along: write `{word}: [{vector}]` in the body `{owner}`, not in the state"
    moved = tuple((word, *axis, value) for word, axis, value in parts)
    bodies = tuple(
        replace(body, moved=(*body.moved, *moved)) if body.name == owner else body for body in problem.bodies
    )
    whole = replace(without_told(problem, owner, (word,)), bodies=bodies)
    yield words, whole
    yield from without_rate(words, whole, told)
    held = [item.name for item in problem.connections if {ref.owner for ref in item.touches()} <= {owner, *GROUND}]
    if held:
        left = " and ".join(f"`{name}`" for name in held)
        kept = tuple(item for item in problem.connections if item.name not in held)
        free = replace(whole, connections=kept)
        yield f"{words}, and leave {left} out", free
        yield f"{words}, and leave {left} and `{owner}.{RATES[word]}` out", without_told(free, owner, (RATES[word],))


def as_scene_writes(value: Formula | None, problem: Problem) -> str:
    """A value as the scene writes it: a number in place that has been given a letter as that number."""
    own = next((given for given in problem.givens if value == Symbol(given.name)), None)
    if own is not None and own.automatic and own.text:
        return own.text
    return "0" if value is None else to_text(value, unicode=False)


def without_told(problem: Problem, owner: str, words: tuple[str, ...]) -> Problem:
    """A problem in whose states some quantities of a body are not told."""
    states = tuple(
        replace(state, conditions=tuple(line for line in state.conditions if not tells_any(line, owner, words)))
        for state in problem.states
    )
    return replace(problem, states=states)


def tells_any(line: Condition, owner: str, words: tuple[str, ...]) -> bool:
    """Whether a line tells one of some quantities of a body."""
    return line.path is not None and line.path.owner == owner and line.path.quantity in words


def answers_all(problem: Problem, solve: Solve) -> bool:
    """Whether a problem has answers to all that it asks, which its assembly confirms."""
    answers = {answer.name for answer in confirmed_answers(problem, solve)}
    return answers >= {find.group for find in problem.finds}
