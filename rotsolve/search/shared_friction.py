"""Shared friction: whether what rubs holds a body in balance together, where the laws do not tell the share of each.

Statics leaves open which of two rough blocks in a row holds how much of a load. They hold it where nothing would begin to move if it were
let go at rest: along each way of moving, friction at its greatest is no less than what drives it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial

from msgspec.structs import replace

from rotsolve.core.facts import TOUCHES
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.language.problem import Condition, Problem, State
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.rubs import Rub, against_most, rubs_at
from rotsolve.paths.meaning import NotYet
from rotsolve.search.answers import NoAnswer
from rotsolve.search.friction import Trials


def suffices_together(configuration: Configuration, state: str) -> bool | None:
    """Whether all that rubs holds at a first state that is in balance; None where the laws do not tell how it would begin to move."""
    problem = configuration.problem
    if state != problem.states[0].name or problem.sought:
        return None
    trials = Trials(Configuration(released(configuration, problem.states[0]), configuration.alteration))
    rubbing = list(rubs_at(trials.configuration, state))
    try:
        trials.decide_from(state, rubbing, ())
        if any(rub.key not in trials.modes for rub in rubbing):
            return None
        groups = trials.moving_together(rubbing)
        pressed = all(surfaces_push(modes, group, trials) for group in groups for modes in telling_ways(group, trials))
    except (SceneError, Unsolvable, NotYet, NoAnswer):
        return None
    return all(map(partial(kept_still, trials=trials), rubbing)) if pressed else None


def released(configuration: Configuration, state: State) -> Problem:
    """The problem at a state alone, at rest instead of in balance, with what acts there."""
    at_rest = Condition(None, rest=True, owner="all", span=state.span)
    first = replace(state, balance=False, conditions=(*state.conditions, at_rest))
    actions = tuple(replace(action, from_=None, to=None) for action in configuration.actions(state.name))
    connections = tuple(configuration.connections(state.name))
    return replace(
        configuration.problem,
        states=(first,),
        phases=(),
        events=(),
        finds=(),
        actions=actions,
        connections=connections,
    )


def kept_still(rub: Rub, trials: Trials) -> bool:
    return trials.modes[rub.key] == rub.mode(0)


def telling_ways(group: list[Rub], trials: Trials) -> Iterator[dict[str, str]]:
    """The ways of moving by which it is told what a group does: as it moves, else as it does not, against all the friction there can be."""
    if not all(kept_still(rub, trials) for rub in group):
        yield {}
    elif len(group) > 1 and any(rub.contact for rub in group):
        for senses in trials.ways(group):
            yield {rub.key: against_most(rub.mode(sense)) for rub, sense in senses.items()}


def surfaces_push(modes: Mapping[str, str], group: list[Rub], trials: Trials) -> bool:
    """Whether surfaces push in a way of moving: friction of one that would have to pull is none, and what it tells is void."""
    search = trials.search({**trials.modes, **modes})
    own = {rub.owner for rub in group}
    needs = search.scene.facts(group[0].state).requirements
    pushes = [search.settled(need.left - need.right) for need in needs if need.kind == TOUCHES and need.owner in own]
    numbers = [None if push is None else search.number(push) for push in pushes]
    return all(number is not None and number >= 0 for number in numbers)
