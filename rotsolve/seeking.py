"""Seeking: questions that seek the value of an open letter, `F where N = P`, beside questions for which it stands for any.

Each question stands alone: what seeks a letter is refused beside answers that hang on it, and wants a scene of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import Symbol
from rotsolve.core.derivation import Refusal
from rotsolve.core.faults import Fault, SceneError, Unsolvable
from rotsolve.search.letterspace import ranged_over

if TYPE_CHECKING:
    from rotsolve.core.derivation import Answer
    from rotsolve.language.problem import Find, Problem
    from rotsolve.solution import Solution

SolveFor = Callable[[tuple["Find", ...]], "Solution"]  # solves for some of a problem's questions


def left_without_seeking(problem: Problem, solve: SolveFor) -> Solution | None:
    """The solution without the questions that seek an open letter on which others hang: their conditions, or, where those seek another
    letter, their answers. None of other scenes."""
    plain = {given.name for given in problem.givens if given.value is None and not given.asked}
    sought = {find.group: letters for find in problem.finds if (letters := letters_sought(find) & plain)}
    others = tuple(
        find for find in problem.finds if find.group not in sought and not find.formula.symbols() & sought.keys()
    )
    first = next(iter(sought.values()), set())
    alike = tuple(find for find in problem.finds if sought.get(find.group) == first)
    for kept in (others, (*others, *alike)):
        left = [find for find in problem.finds if find not in kept]
        if not kept or not any(find.group in sought for find in left):
            continue
        try:
            solution = solve(kept)
        except (Unsolvable, SceneError):
            return None
        letters = {name for find in left for name in sought.get(find.group, ())}
        hangs = {name for answer in solution.derivation.answers for name in letters_of_answer(answer, sought)}
        if hangs & letters:
            return without_seeking(left, sorted(hangs & letters), problem, solution)
    return None


def without_seeking(left: list[Find], letters: list[str], problem: Problem, solution: Solution) -> Solution:
    """The solution for the others, and why it has no answer to what is left."""
    words = f"what else is asked holds only for some values of `{', '.join(letters)}`, of which this seeks one"
    refused = [
        Refusal(find.group, Fault(words, find.span, "ask for it in a scene of its own", "unsolvable")) for find in left
    ]
    finds = tuple(dict.fromkeys((Symbol(find.group),) for find in problem.finds))
    derivation = replace(solution.derivation, refused=(*solution.derivation.refused, *refused), finds=finds)
    return replace(solution, problem=problem, derivation=derivation)


def letters_sought(find: Find) -> set[str]:
    """The letter of `F where N = P` and of `x where Q is smallest`, and the places over which an extremum is sought."""
    return ranged_over(find) | ({find.seeks} if find.seeks else set())


def letters_of_answer(answer: Answer, sought: Mapping[str, set[str]]) -> set[str]:
    """The letters on which it hangs whether an answer holds, in any of its cases, and on which the value of a letter hangs."""
    cases = (answer, *answer.otherwise)
    found = {name for case in cases for one in case.conditions for name in (one.left - one.right).symbols()}
    if answer.name in sought:
        found |= {name for case in cases if case.closed is not None for name in case.closed.symbols()}
    return found - sought.get(answer.name, set())
