"""Apart: a question that has no answer takes no other with it; why it has none is told beside the answers of the others."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from msgspec.structs import replace

from rotsolve.algebra.effort import Exhausted
from rotsolve.core.derivation import Refusal
from rotsolve.core.faults import UNSOLVED, Contradicted, Fault, Impossible, NeverReached, Unsolvable
from rotsolve.core.letters import letters_of
from rotsolve.language.block import asked_block
from rotsolve.language.problem import Find, Problem, asked_before, before
from rotsolve.search.answering import Unanswered, needed_for, with_named
from rotsolve.solution import Solution, with_refused

TAKES_LONG, ALONE = "it takes too long to work out beside the other questions", "ask for it in a scene of its own"
TRIES = 3  # each with the work that a scene may take
SolveFor = Callable[[tuple[Find, ...]], Solution]  # solves for some of a problem's questions


def each_where_answered(problem: Problem, solve: SolveFor) -> Solution:
    """The questions of a problem that `solve` answers, together; why it answers others not is told beside them."""
    try:
        return solve(problem.finds)
    except Unsolvable as error:
        if len(problem.finds) < 2 or (isinstance(error, Contradicted) and not isinstance(error, NeverReached)):
            raise
        solution, refused = solved_without(error, problem, solve)
    return with_refused([Refusal(name, error.fault) for name, error in refused.items()], problem, solution)


def those_in_time(problem: Problem, solve: Callable[[Problem], Solution], tries: int = TRIES) -> Solution:
    """The solution for the questions that can be answered with the work that a scene may take: those that had been answered with half of
    it, else without the one that takes it all, or without what is asked of the last state where none is known to."""
    try:
        return solve(problem)
    except Exhausted as error:
        kept = with_named({*error.done}, problem) or left_without(error.stuck, problem) or earlier(problem)
        if tries == 1 or not kept or len(kept) == len(problem.finds):
            raise
    solution = those_in_time(replace(problem, finds=kept), solve, tries - 1)
    left = {find.group: find for find in problem.finds if find not in kept}
    refused = [Refusal(name, Fault(TAKES_LONG, find.span, ALONE, UNSOLVED)) for name, find in left.items()]
    return with_refused(refused, problem, solution)


def left_without(name: str, problem: Problem) -> tuple[Find, ...]:
    """The questions of a problem without one, and those that hang on it."""
    return tuple(
        find for find in problem.finds if name and all(one.name != name for one in with_named({find.name}, problem))
    )


def earlier(problem: Problem) -> tuple[Find, ...]:
    """The questions of a problem that speak of earlier states than the others; nothing where all speak of one."""
    ways = (asked_before(place, problem) for place in range(len(problem.states) - 1, 0, -1))
    return next(
        (with_named({find.name for find in kept}, problem) for kept in ways if 0 < len(kept) < len(problem.finds)), ()
    )


def solved_without(error: Unsolvable, problem: Problem, solve: SolveFor) -> tuple[Solution, Mapping[str, Unsolvable]]:
    """The solution without the questions that have no answer, and these with their reasons: those that an error names, if it does."""
    known, every = refused_by(error, problem), dict[str, Unsolvable]()
    for refused in (known,) if isinstance(error, NeverReached) else (known, None):
        refused = told_apart(problem, solve) if refused is None else refused
        refused = {**taken_along(refused, problem), **refused}
        every |= refused
        kept = tuple(find for find in problem.finds if find.name not in refused)
        if not kept or len(kept) == len(problem.finds):
            continue
        try:
            return solve(kept), refused
        except NeverReached as sooner:
            solution, more = solved_without(sooner, replace(problem, finds=kept), solve)
            return solution, {**refused, **more}
        except Unsolvable:
            continue
    if isinstance(error, Unanswered) and every.keys() - error.refused.keys():  # alone it had an answer, or so it seemed
        raise Unanswered({find.name: every[find.name] for find in problem.finds if find.name in every})
    raise error


def refused_by(error: Unsolvable, problem: Problem) -> Mapping[str, Unsolvable]:
    """The questions that an error itself says have no answer: of a state that is never reached all that ask of it or later."""
    if isinstance(error, NeverReached):
        early = before(error.state, problem)
        return {find.name: error for find in problem.finds if early is None or find not in early.finds}
    return error.refused if isinstance(error, Unanswered) else {}


def taken_along(refused: Mapping[str, Unsolvable], problem: Problem) -> dict[str, Unsolvable]:
    """What else has no answer where the data leave none for an unknown that a state tells: what is asked of that state or later."""
    asked = problem.sought
    found: dict[str, Unsolvable] = {}
    for name, error in refused.items():
        error = error.refused.get(name, error) if isinstance(error, Unanswered) else error
        told = [state.name for state in problem.states if name in set(letters_of(state.conditions))]
        early = before(told[0], problem) if told else None
        hopeless = isinstance(error, Impossible) or (isinstance(error, Contradicted) and told)
        if name not in asked or not hopeless or isinstance(error, NeverReached):
            continue
        for find in problem.finds:
            block = asked_block(replace(problem, finds=(find,)))
            spoken_of = (block.states, block.bodies, block.connections, block.actions)  # a place on a rod stands there
            if (early is None or find not in early.finds) and name in set(letters_of(spoken_of)):
                found[find.name] = error
    return found


def told_apart(problem: Problem, solve: SolveFor) -> dict[str, Unsolvable]:
    """The questions of a scene that have no answer, by name, each with its reason: what is found with all it needs, and nothing else."""
    refused: dict[str, Unsolvable] = {}
    for find in problem.finds:
        for finds in needed_for(find, problem):
            try:
                solve(finds)
            except Unsolvable as error:
                refused.setdefault(find.name, error)
            else:
                refused.pop(find.name, None)
                break
    return refused
