"""Sequence: whether events, phases and actions fit the order of the states; one that does not would silently do nothing."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from rotsolve.core.faults import Unsolvable
from rotsolve.language.problem import Problem


def check_sequence(problem: Problem) -> None:
    """A fault for what joins no neighbouring states, for two events at once, and for an action that never acts."""
    states = {state.name: state for state in problem.states}
    order = {name: index for index, name in enumerate(states)}
    taken: dict[tuple[str, str], str] = {}
    for name, start, end in joined(problem):
        if order[end] != order[start] + 1:
            pairs = "; ".join(f"from {first} to {second}" for first, second in pairwise(order))
            help = f"states follow each other as they are written: {pairs}"
            message = f"`{name}` does not lead from a state to the next one"
            raise Unsolvable(message, span=states[end].span, help=help)
        other = taken.setdefault((start, end), name)
        if other != name:
            message = f"`{other}` and `{name}` happen between the same states: that is not solved yet"
            help = "give each a state of its own to lead to, and let the second start where the first ends"
            raise Unsolvable(message, span=states[end].span, help=help)
    for action in problem.actions:
        begins = order.get(action.from_ or "", 0)
        if action.to is not None and order[action.to] <= begins:
            help = f"a force that acts at a state and then no longer: `removes: {action.name}` among the events"
            raise Unsolvable(f"`{action.name}` ends before it begins to act", span=states[action.to].span, help=help)


def joined(problem: Problem) -> Iterator[tuple[str, str, str]]:
    """The events with the states that they join, and the phases in which a connection does not act."""
    for event in problem.events:
        if event.from_ is not None and event.to is not None:
            yield event.name, event.from_, event.to
    for phase in problem.phases:
        if phase.without:
            yield phase.name, phase.start, phase.end
