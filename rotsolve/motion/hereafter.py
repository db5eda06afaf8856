"""Hereafter: what is asked of the last state where friction changes there is of what comes then, as it is where another state follows."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO
from rotsolve.algebra.units.dimension import ACCELERATION, ANGULAR_ACCELERATION, FORCE, POWER, TORQUE
from rotsolve.core.quantity import QUANTITIES
from rotsolve.language.problem import EXTREMES, Condition, Problem, State
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.rubs import rubs

HEREAFTER = "after that"
BY_FORCES = (FORCE, TORQUE, ACCELERATION, ANGULAR_ACCELERATION, POWER)
RATES = ("velocity", "angular_velocity", "speed")
PLACES = ("displacement", "rotation", "angle", "height", "position", "elongation")


def changes_at_last(configuration: Configuration) -> bool:
    """Whether friction changes at the last state, as something sticks or comes to rest, and a force or acceleration is asked there."""
    lines = configuration.problem.states[-1].conditions if configuration.problem.states else ()
    return any(map(comes_to_hold, lines)) and asks_forces_at_last(configuration)


def sticks_at_last(problem: Problem) -> bool:
    """Whether the last state says that something sticks or rolls, to which a motion leads."""
    if len(problem.states) < 2:
        return False
    last = problem.states[-1]
    said = any(line.word in ("sticks", "rolls") for line in last.conditions)
    return said and not any(event.to == last.name for event in problem.events)


def asks_forces_at_last(configuration: Configuration) -> bool:
    """Whether a force or acceleration is asked of the last state, to which a motion leads, where something rubs."""
    problem = configuration.problem
    if len(problem.states) < 2:
        return False
    last = problem.states[-1].name
    struck = any(event.to == last for event in problem.events)
    terms = [term for find in problem.finds for term in find.terms if term.at == last]
    asked = any(QUANTITIES[term.path.quantity].dimension in BY_FORCES for term in terms)
    return asked and not struck and bool(rubs(configuration))


def comes_to_hold(line: Condition) -> bool:
    """Whether a line says that something sticks, rolls or is at rest, as what has come to its farthest place is."""
    still = line.path is not None and line.path.quantity in RATES and line.value == ZERO
    farthest = line.path is not None and line.path.quantity in PLACES and line.word in EXTREMES
    return line.rest or line.word in ("sticks", "rolls") or still or farthest


def with_hereafter(problem: Problem, senses: tuple[tuple[str, int], ...] = ()) -> Problem:
    """The problem with a state of which nothing is told behind its last one, at which all that rubs has these senses, if known."""
    *before, last = problem.states
    return replace(problem, states=(*before, replace(last, senses=senses or last.senses), State(HEREAFTER)))
