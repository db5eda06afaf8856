"""Within: a letter that is asked for lies where its key lets it be: no friction is negative, and no place beyond the end of its rod."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.formula import ONE, PI, Formula, negate
from rotsolve.core.faults import Unsolvable
from rotsolve.language.problem import Given, Problem
from rotsolve.motion.positive import limited_values
from rotsolve.search.answers import unsolvable
from rotsolve.search.letterspace import places_on_rods
from rotsolve.search.search import Search

LOWEST = {  # by what a key says of its values
    "positive": "must be positive",
    "nonnegative": "can't be negative",
    "fraction": "must lie from 0 to 1",
    "acute": "must lie from 0 to 90°",
}
HIGHEST = {"fraction": ONE, "acute": PI / 2}


class Bound(Struct, frozen=True):
    """What is not negative where an asked letter is what it can be, if `strict` not zero either, and what is said where it is not."""

    gap: Formula
    asked: Given
    words: str
    strict: bool = False


def bounds_of_asked(problem: Problem) -> Iterator[Bound]:
    """Where the letters that are asked for have to lie: by the keys under which they stand, and on the rods on which they are places."""
    asked = {item.name: item for item in problem.givens if item.asked}
    for owner, value, limits in limited_values(problem) if asked else ():
        for name in sorted(value.symbols() & asked.keys()):
            words = f"in `{owner}` it {LOWEST[limits]}"
            yield Bound(value, asked[name], words, strict=limits == "positive")
            if limits in HIGHEST:
                yield Bound(HIGHEST[limits] - value, asked[name], words)
    for owner, place, reach in places_on_rods(problem) if asked else ():
        for name in sorted((place.symbols() | reach.symbols()) & asked.keys()):
            words = f"it is a place on `{owner}`, which ends before"
            yield Bound(place, asked[name], words)
            yield Bound(reach - place, asked[name], words)


def out_of_bounds(search: Search) -> Iterator[Unsolvable]:
    """Asked letters whose answer is none that they can be; of letters the case has the condition that they are."""
    problem = search.scene.configuration.problem
    for bound in bounds_of_asked(problem):
        if beyond_its_bound(bound, search):
            message = f"no `{bound.asked.name}` that it can be makes it so: {bound.words}"
            yield unsolvable(problem, message, bound.asked.span, "check what the scene says of it")


def beyond_its_bound(bound: Bound, search: Search) -> bool:
    """Whether the answers make negative what may not be, or zero."""
    value, roots = bound.gap, {}
    for name in bound.gap.symbols() & search.solver.solved.keys():
        found = search.solver.solved[name]
        if found.formula is not None:
            value = value.substitute({name: found.formula})
        elif found.number is not None:
            roots[name] = found.number
    if roots:
        try:
            return evaluate(value, search.values, roots=roots).sign == -1
        except Undefined:
            return False
    if bound.strict:
        return search.numbers.side(value) in (0, -1)
    return search.numbers.side(negate(value)) == 1  # so that letters have the condition ≥ 0
