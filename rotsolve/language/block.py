"""Block: the part of a scene that its questions can depend on. What stands beside it is left out before any law is written.

What one connection, action, event or line of a state speaks of together may depend on each other; so may what holds the same unknown
letter and, where there are several states, all that can tell how long the motion takes. What lies on the same surface is not tied.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Sequence

from msgspec.structs import replace

from rotsolve.core.letters import leaves_of
from rotsolve.core.symbols import paths_in
from rotsolve.language.elements import Action, Connection
from rotsolve.language.keys import varying_values
from rotsolve.language.problem import Path, Problem

CLOCK = "the clock"  # in a tie: what can tell, or depends on, how long a motion takes
EVERY = "all"  # the owner of a line that speaks of all bodies


def asked_block(problem: Problem) -> Problem:
    """The problem without the bodies, connections and actions that no question can depend on; itself where there are none such."""
    loose = loose_letters(problem)
    if len(problem.bodies) < 2 or spoken_of_as_a_whole(problem, loose):
        return problem
    named, kept = names_of_parts(problem), asked_parts(problem, loose)
    return problem if kept == named else with_only(problem, kept, named - kept)


def asked_parts(problem: Problem, loose: frozenset[str] | None = None) -> set[str]:
    """The names of the bodies, connections and actions on which a question can depend, one by one: all of what it asks of all bodies."""
    loose, named = loose_letters(problem) if loose is None else loose, names_of_parts(problem)
    # of a surface whose slope or size is asked for, what lies on it may tell that
    surfaces = [item.name for item in problem.surfaces if not loose.isdisjoint(names_in(item))]
    return reached(roots(problem), ties(problem, loose), {CLOCK, *named, *loose, *surfaces}) & named


def spoken_of_at(problem: Problem, name: str) -> Problem:
    """The problem with no bodies but those of which a state speaks, and what hangs together with these; itself where it speaks of none, or
    of all at once."""
    lines = [line for state in problem.states if state.name == name for line in state.conditions]
    named = names_of_parts(problem)
    events = [tuple(names_in(event)) for event in problem.events]
    touching = [(item.name, *(ref.owner for ref in item.touches())) for item in acting(problem)]
    kept = reached({one for line in lines for one in names_in(line)}, [*touching, *events], named)
    if not kept or kept == named or any(line.path is None and line.owner in ("", EVERY) for line in lines):
        return problem
    return with_only(problem, kept, named - kept)


def names_of_parts(problem: Problem) -> set[str]:
    """The names of all bodies, and of all that acts on them."""
    return {body.name for body in problem.bodies} | {item.name for item in acting(problem)}


def with_only(problem: Problem, kept: Collection[str], dropped: Collection[str]) -> Problem:
    """The problem without some parts, and without what the states say of them."""
    states = []
    for state in problem.states:
        lines = [line for line in state.conditions if not any(name in dropped for name in names_in(line))]
        states.append(replace(state, conditions=tuple(lines)))
    return replace(
        problem,
        bodies=tuple([body for body in problem.bodies if body.name in kept]),
        connections=tuple([item for item in problem.connections if item.name in kept]),
        actions=tuple([item for item in problem.actions if item.name in kept]),
        states=tuple(states),
    )


def reached(names: Iterable[str], ties: Iterable[Sequence[str]], linking: Collection[str]) -> set[str]:
    """What can be reached from some names over ties; only names that are `linking` tie."""
    holders = defaultdict[str, list[Sequence[str]]](list)
    for tie in ties:
        for name in tie:
            holders[name].append(tie)
    found, pending = set[str](), list(names)
    while pending:
        name = pending.pop()
        if name in linking and name not in found:
            found.add(name)
            pending += [other for tie in holders.get(name, ()) for other in tie]
    return found


def acting(problem: Problem) -> tuple[Connection | Action, ...]:
    """All that acts on bodies."""
    return (*problem.connections, *problem.actions)


def left_out(whole: Problem, block: Problem) -> list[str]:
    """The names of the bodies that were left out."""
    kept = {body.name for body in block.bodies}
    return [body.name for body in whole.bodies if body.name not in kept]


def spoken_of_as_a_whole(problem: Problem, loose: frozenset[str]) -> bool:
    """Whether a question or a later state speaks of all bodies at once, or gravity is what is asked."""
    if any(speaks_of_all(term.path) for find in problem.finds for term in find.terms):
        return True
    if problem.gravity is not None and not loose.isdisjoint(problem.gravity.symbols()):
        return True
    later = problem.states[1:]
    lines = [line for state in later for line in state.conditions]
    lines += [find.where for find in problem.finds if find.where is not None]
    if any(state.balance or state.steady for state in later):
        return True
    return any(speaks_of_all(line.path) if line.path is not None else line.owner == EVERY for line in lines)


def speaks_of_all(path: Path) -> bool:
    """Whether a path speaks of all bodies: an energy of the whole."""
    return not path.owner and path.quantity != "time"


def loose_letters(problem: Problem) -> frozenset[str]:
    """The letters that are asked for, and those that are made of them."""
    loose = {given.name for given in problem.givens if given.asked}
    made = {given.name: given.value.symbols() for given in problem.givens if given.value is not None} if loose else {}
    while fresh := {name for name, letters in made.items() if letters & loose} - loose:
        loose |= fresh
    return frozenset(loose)


def roots(problem: Problem) -> Iterator[str]:
    """What the questions speak of; how long the motion takes, where there is one from state to state."""
    yield from names_in(problem.finds)
    if len(problem.states) > 1:
        yield CLOCK


def ties(problem: Problem, loose: frozenset[str]) -> Iterator[Sequence[str]]:
    """What depends on each other, name by name."""
    for item in acting(problem):
        varied = [owner for value in varying_values(item) for _, owner, _ in paths_in(value)]
        yield [item.name, *(ref.owner for ref in item.touches()), *varied]
    for event in problem.events:
        yield (CLOCK, *names_in(event))
    for phase in problem.phases:
        yield (CLOCK, *phase.without)
    for number, state in enumerate(problem.states):
        for line in state.conditions:
            yield (*((CLOCK,) if number else ()), *names_in(line))
    if loose:
        for given in problem.givens:
            yield (given.name, *loose.intersection(names_in(given.value)))
        for part in (*problem.bodies, *problem.surfaces, *acting(problem)):
            yield (part.name, *loose.intersection(names_in(part)))


def names_in(item: object) -> Iterator[str]:
    """All names that a part of a scene speaks of: of parts, of letters, of the bodies in a value that varies."""
    for leaf in leaves_of(item):
        if isinstance(leaf, str):
            yield leaf
        else:
            yield from leaf.symbols()
            yield from (owner for _, owner, _ in paths_in(leaf))
