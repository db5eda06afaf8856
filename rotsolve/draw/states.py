"""States: at which states of a scene its questions look, so that what acts is drawn there and then."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.language.problem import Find, Problem, Term
from rotsolve.motion.timeline import Timeline, timeline


def states_asked(problem: Problem) -> tuple[str, ...]:
    """The states of which the questions ask, in the order of time: of a phase or an event the one at which it begins."""
    line = timeline(problem)
    asked = {state for find in problem.finds for term in terms_asked(find) for state in moments_of(term, line)}
    return tuple(name for name in line.named if name in asked)


def terms_asked(find: Find) -> tuple[Term, ...]:
    """All that a question speaks of, with what holds where it asks."""
    phrase = find.where.phrase if find.where is not None else None
    return (*find.terms, *(phrase.terms if phrase is not None else ()))


def moments_of(term: Term, line: Timeline) -> Iterator[str]:
    """The state at which a quantity is asked."""
    if term.at is not None:
        yield term.at
    elif term.start is not None:
        yield term.start
    elif term.during is not None:
        interval = line.interval(term.during)
        if interval is not None:
            yield interval.start
