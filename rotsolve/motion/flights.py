"""Flights: what leaves a surface and goes on: from the state that says so the contact is gone, and no line leads its body any longer.

And what goes on evenly by itself while all else comes to a balance, as a ball that has struck.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.core.writing import spoken
from rotsolve.language.elements import Event
from rotsolve.language.problem import Condition, Problem, State

if TYPE_CHECKING:
    from rotsolve.motion.configuration import Configuration


def with_flights(problem: Problem) -> Problem:
    """The problem with an event, and a state right after it, for each state but the last that says that a body leaves a surface."""
    states: list[State] = []
    events: list[Event] = list(problem.events)
    struck = {event.from_ for event in events}
    for number, state in enumerate(problem.states, 1):
        states.append(state)
        told = [line for line in state.conditions if line.word == "leaves" and line.path is not None]
        if not told or number == len(problem.states) or state.balance or state.name in struck:
            continue
        left = [item for item in problem.connections if item.name in {owner_of(line) for line in told} and item.lying()]
        if left:
            from rotsolve.elements.events import Leaves

            flying = unused("flight", problem, states)
            names = tuple(item.name for item in left)
            words = f"{spoken(left[0].lying())} flies on"
            events.append(Leaves(name=unused("leaving", problem, events), from_=state.name, to=flying, removes=names))
            states.append(State(flying, span=state.span, opened=words))
    return (
        problem if len(states) == len(problem.states) else replace(problem, states=tuple(states), events=tuple(events))
    )


def unused(word: str, problem: Problem, made: Sequence[State | Event]) -> str:
    """A name that nothing else has."""
    named = (problem.states, problem.events, problem.phases, problem.bodies, problem.connections, problem.actions, made)
    taken = {item.name for items in named for item in items} | {given.name for given in problem.givens}
    numbered = (f"{word}{number}" for number in range(2, len(taken) + 3))
    return next(name for name in (word, *numbered) if name not in taken)


def owner_of(line: Condition) -> str:
    """The element of which a line says a word."""
    return line.path.owner if line.path is not None else line.owner


def going_on_evenly(state: str, configuration: Configuration) -> frozenset[str]:
    """The bodies that nothing holds or pushes at a state to which a motion leads: also in balance they go on as they went, a = 0."""
    before = configuration.timeline.before(state)
    if before is None or before.event is not None or configuration.timeline.at_rest(before):
        return frozenset()
    touched = {
        ref.owner for item in configuration.acting(state) for ref in item.touches()
    } & configuration.bodies.keys()
    held = {configuration.host(owner, state) for owner in touched}
    return frozenset(body.name for body in configuration.present(state) if body.name not in held)
