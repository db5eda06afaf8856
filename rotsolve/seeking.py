"""Seeking: questions that seek the value of an open letter, `F where N = P`, beside questions for which it stands for any.

Each question stands alone: what seeks a letter is refused beside answers that hang on it, and wants a scene of its own. Where
something rubs, how it moves goes by the value that is sought: the letter is then an unknown of the scene.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.core.derivation import Refusal
from rotsolve.core.faults import Fault, SceneError, Unsolvable
from rotsolve.motion.complete import configured
from rotsolve.motion.rubs import rubs
from rotsolve.search.answering import with_named
from rotsolve.search.answers import unsolvable
from rotsolve.search.letterspace import ranged_over

if TYPE_CHECKING:
    from rotsolve.core.derivation import Answer, Check
    from rotsolve.language.problem import Find, Problem
    from rotsolve.solution import Solution

SolveFor = Callable[[tuple["Find", ...]], "Solution"]  # solves for some of a problem's questions


def with_sought_unknown(problem: Problem) -> Problem:
    """The problem with the letter unknown that its only question, beside those that it names, seeks by an equation while something rubs."""
    found = sought_while_rubbing(problem)
    if not found or with_named({found[0].name}, problem) != problem.finds:
        return problem
    return with_unknown(found[0].seeks, problem)


def with_unknown(letter: str, problem: Problem) -> Problem:
    """The problem with a letter that the scene asks for."""
    givens = tuple([replace(item, asked=True) if item.name == letter else item for item in problem.givens])
    return replace(problem, givens=givens)


def sought_while_rubbing(problem: Problem) -> list[Find]:
    """The questions `F where N = P` for open letters, where something rubs."""
    plain = {given.name for given in problem.givens if given.value is None and not given.asked}
    conditions = [(find, find.where) for find in problem.finds if find.seeks in plain and find.where is not None]
    found = [find for find, where in conditions if where.phrase is not None and where.word is None]
    return found if found and not problem.space and rubs(configured(problem)) else []


def held_alone(problem: Problem, solution: Solution, solve: SolveFor) -> Solution:
    """The solution without the questions whose answer alone, by how things rub at the value sought, is another than beside others."""
    refused = []
    for find in sought_while_rubbing(problem):
        beside = next((answer for answer in solution.derivation.answers if answer.name == find.group), None)
        alone = with_named({find.name}, problem)
        if beside is None or alone == problem.finds:
            continue
        try:
            answers = solve(alone).derivation.answers
        except (Unsolvable, SceneError):
            answers = ()
        own = next((answer for answer in answers if answer.name == find.group), None)
        if own is None or not same_cases(own, beside):
            words = f"how things rub hangs on the `{find.seeks}` that this seeks, and beside it `{find.seeks}` is any"
            refused.append(
                Refusal(find.group, Fault(words, find.span, "ask for it in a scene of its own", "unsolvable"))
            )
    return without_refused(refused, problem, solution)


def sought_twice_while_rubbing(problem: Problem) -> list[Find]:
    """The questions `smallest F where N = P` for a letter that another one seeks too, where something rubs: it may stick at one value of it
    and slip at the other."""
    sought = [find.seeks for find in problem.finds if find.seeks]
    found = [find for find in problem.finds if find.seeks and sought.count(find.seeks) > 1]
    return found if found and not problem.space and rubs(configured(problem)) else []


def with_all_verges(problem: Problem, solution: Solution, solve: SolveFor) -> Solution:
    """The solution with what does not hold at each of several verges, `smallest mu where A sticks`, or values of one letter, and without
    those that alone hold in other cases: together they are held against the value of one."""
    verges = [find for find in problem.finds if find.verge] or sought_twice_while_rubbing(problem)
    beside = {answer.name: answer for answer in solution.derivation.answers}
    objections: list[Check] = []
    refused: list[Refusal] = []
    for find in verges if len(verges) > 1 else ():
        try:
            alone = solve((find,))
        except (Unsolvable, SceneError):
            continue
        objections += [check for check in alone.checks if check.holds is False and check not in solution.checks]
        own = next((answer for answer in alone.derivation.answers if answer.name == find.group), None)
        if own is not None and find.group in beside and not within_cases(beside[find.group], own):
            words = (
                f"in what cases this holds hangs on the `{find.seeks}` that it seeks, and another is sought beside it"
            )
            refused.append(
                Refusal(find.group, Fault(words, find.span, "ask for it in a scene of its own", "unsolvable"))
            )
    told = replace(solution.derivation, checks=(*solution.derivation.checks, *dict.fromkeys(objections)))
    return without_refused(refused, problem, replace(solution, derivation=told))


def without_refused(refused: list[Refusal], problem: Problem, solution: Solution) -> Solution:
    """The solution without answers that it should not give, and why; the first of these alone where no other is left."""
    names = {item.name for item in refused}
    kept = tuple(answer for answer in solution.derivation.answers if answer.name not in names)
    if refused and not kept:
        raise unsolvable(problem, refused[0].fault.message, refused[0].fault.span, refused[0].fault.help)
    told = (*solution.derivation.refused, *refused)
    return replace(solution, derivation=replace(solution.derivation, answers=kept, refused=told))


def within_cases(one: Answer, other: Answer) -> bool:
    """Whether an answer says nothing but what another says, in the same cases or within them."""
    from rotsolve.derivation.cases import same_form

    cases = (other, *other.otherwise)
    return all(
        any(same_form(case, wide) and set(wide.conditions) <= set(case.conditions) for wide in cases)
        for case in (one, *one.otherwise)
    )


def same_cases(one: Answer, other: Answer) -> bool:
    """Whether two answers say the same in the same cases."""
    from rotsolve.derivation.cases import same_form

    cases = [(answer, *answer.otherwise) for answer in (one, other)]
    return len(cases[0]) == len(cases[1]) and all(
        same_form(first, last) and first.conditions == last.conditions for first, last in zip(*cases, strict=True)
    )


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


def where_none_seeks(problem: Problem, solution: Solution, solve: SolveFor) -> Solution:
    """The solution with what the letters that are sought may be for the others, for which they stand for any value; that for the others
    anew where all that seeks is refused."""
    plain = {given.name for given in problem.givens if given.value is None and not given.asked}
    sought = {find.group: letters for find in problem.finds if (letters := letters_sought(find) & plain)}
    kept = tuple(find for find in problem.finds if find.group not in sought)
    refused = [item for item in solution.derivation.refused if item.name in sought]
    none_seeks = bool(refused) and sought.keys() <= {item.name for item in refused}
    if not kept or not (none_seeks or hangs_on(set().union(*sought.values()), solution, sought)):
        return solution
    from rotsolve.solution import with_refused

    try:
        others = solve(kept)
    except (Unsolvable, SceneError):
        return solution
    if none_seeks:
        return with_refused(refused, problem, others)
    told = solution.derivation.conventions
    more = tuple(line for line in others.derivation.conventions if line not in told)
    return replace(solution, derivation=replace(solution.derivation, conventions=(*told, *more)))


def hangs_on(letters: set[str], solution: Solution, sought: Mapping[str, set[str]]) -> bool:
    """Whether one of some letters stands in an answer that does not seek them."""
    answers = [case for one in solution.derivation.answers if one.name not in sought for case in (one, *one.otherwise)]
    parts = [part for one in answers for part in (one, *one.components, *(entry for row in one.rows for entry in row))]
    return any(part.closed is not None and letters & part.closed.symbols() for part in parts)


def without_seeking(left: list[Find], letters: list[str], problem: Problem, solution: Solution) -> Solution:
    """The solution for the others, and why it has no answer to what is left."""
    words = f"what else is asked holds only for some values of `{', '.join(letters)}`, of which this seeks one"
    refused = [
        Refusal(find.group, Fault(words, find.span, "ask for it in a scene of its own", "unsolvable")) for find in left
    ]
    from rotsolve.solution import with_refused

    return with_refused(refused, problem, solution)


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
