"""Contradictory: which law or line of the scene the data break, and where."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from rotsolve.algebra.formula import Formula
from rotsolve.core.equation import Equation
from rotsolve.core.faults import Span, Unsolvable
from rotsolve.elements.connections.touch import Touch
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Problem
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.timeline import Interval
from rotsolve.paths import path_text
from rotsolve.search.explain.unsolvable import CHECK_DATA, unsolvable


def contradicted(equation: Equation, scene: SceneEquations, fallback: Span | None = None) -> Unsolvable:
    """Which law or line the data break; over a phase, that its end is never reached."""
    problem, timeline = scene.configuration.problem, scene.configuration.timeline
    line = next((condition for stated, condition in scene.stated if stated is equation), None)
    if line is not None:
        path = path_text(line.path) if line.path is not None else line.owner
        message = f"the data contradict each other: what `{equation.section}` says of `{path}` can not be"
        if line.rest:
            message = f"the data contradict each other: `at rest: {line.owner}` can not hold at `{equation.section}`"
        return unsolvable(problem, message, line.span or fallback, CHECK_DATA)
    broken = f"“{equation.label}” can not hold; {CHECK_DATA}"
    interval = timeline.interval(equation.section)
    if interval is None:
        state = next((state for state in timeline.states if state.name and state.name == equation.section), None)
        where = f" at `{state.name}`" if state is not None else ""
        span = state.span if state is not None and state.span is not None else fallback
        return unsolvable(problem, f"the data contradict each other{where}", span, broken)
    if interval.event is not None:
        message = f"the data contradict each other: `{interval.end}` can not follow from `{interval.start}` by `{interval.name}`"
    else:
        message = f"`{interval.end}` is never reached from `{interval.start}`"
    return unsolvable(problem, message, timeline.state(interval.end).span or fallback, broken)


def said_otherwise(configuration: Configuration, modes: Mapping[str, str]) -> Iterator[Unsolvable]:
    """Contacts that a state says to stick where friction is too weak for it, or to slip where it is strong enough."""
    problem = configuration.problem
    numbered = {given.name for given in problem.givens if given.value is not None}
    for state in configuration.timeline.states:
        contacts = {item.name: item for item in configuration.connections(state.name) if isinstance(item, Touch)}
        for line in state.conditions if configuration.phase_start(state.name) == state.name else ():
            contact = contacts.get(line.path.owner) if line.path is not None else None
            if contact is None or contact.grip().kind != "coefficient" or not known(contact.grip().static, numbered):
                continue
            slips = modes.get(f"{contact.name}@{state.name}", "sticks").startswith("slips")
            if line.word in ("sticks", "rolls") and slips:
                yield unsolvable(
                    problem, f"`{contact.name}` slips at `{state.name}`: friction is too weak to hold it", line.span
                )
            elif line.word == "slips" and not slips:
                yield unsolvable(
                    problem, f"`{contact.name}` does not slip at `{state.name}`: friction is strong enough", line.span
                )


def known(value: Formula | None, numbered: Collection[str]) -> bool:
    """Whether a value is there, with all its letters."""
    return value is not None and value.symbols() <= set(numbered)


def turns_back(interval: Interval, problem: Problem) -> Unsolvable:
    """The time of a motion that comes back on its way, which is told for one way only."""
    span = next((state.span for state in problem.states if state.name == interval.end), None)
    message = f"the motion turns back from `{interval.start}` to `{interval.end}`: its time is not solved as a whole"
    return unsolvable(problem, message, span, "name the turning point as a state, such as `{block.velocity: 0}`")
