"""Rivals: other values that a letter of the scene may have as well as that of its answer.

An equation for a letter that is asked for may have several roots. Those that the scene lets it be are put into the scene like the answer
itself; where every line then holds, the question has several answers, of which one alone is half of the truth.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import ANGLE
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.samples import Fits, Numbers, holding
from rotsolve.confirm.numbers import value_of
from rotsolve.confirm.verdicts import SAME, not_so, said_of
from rotsolve.core.derivation import Answer, AnswerConfirmation
from rotsolve.language.problem import Find, Given, Problem

Said = dict[str, float | str]
Judge = Callable[
    [Find, Said, Numbers], AnswerConfirmation
]  # what the assembly says of an answer, at numbers for all letters
ASK = {False: "tell more of it", True: "ask for the `smallest` or the `largest` one"}


def rivalled(
    verdicts: dict[str, AnswerConfirmation],
    answers: Sequence[Answer],
    problem: Problem,
    known: Numbers,
    fits: Fits,
    judge: Judge,
) -> dict[str, AnswerConfirmation]:
    """The verdicts on answers at some numbers, where a letter with several values that all do is not confirmed, nor what hangs on it."""
    finds = {find.group: find for find in problem.finds}
    givens: dict[Formula, Given] = {Symbol(given.name): given for given in problem.givens}
    for several in answers:
        find, verdict = finds[several.name], verdicts[several.name]
        answer, given = holding(several, known), givens.get(find.formula)
        if not verdict.holds or answer is None or given is None:
            continue
        for value in values_beside(answer, find, given, known, verdict.answered[0]):
            numbers = {**known, given.name: value, find.name: value}
            if fits(numbers) and judge(find, {"": value}, numbers).holds:
                why = f"{given.name} = {value:g} in SI units makes it so too: {ASK[find.where is not None]}"
                told = {several.name: several}
                if given.asked:
                    told |= {
                        one.name: one for one in answers if changes_with(one, finds[one.name], known, numbers, judge)
                    }
                letters = {name: known[name] for name in known if name in answer.rivals[0].symbols()}
                verdicts |= {name: not_so(name, why, problem, letters) for name in told}
                break
    return verdicts


def values_beside(answer: Answer, find: Find, given: Given, known: Numbers, said: float) -> Iterator[float]:
    """The values of the other roots that the letter can have: of the sign of a size, an angle like that of the answer; beyond the answer
    where the largest or the smallest is asked for."""
    angle = given.dimension == ANGLE
    for root in answer.rivals:
        try:
            value = float(value_of(root, known))
        except (NotConfirmed, ArithmeticError, ValueError, TypeError):
            continue
        apart = abs(math.remainder(value - said, math.tau) if angle else value - said)
        if not math.isfinite(value) or apart <= SAME * max(abs(value), abs(said)):
            continue
        if angle and not (0.0 < value < math.pi / 2 if 0.0 < said < math.pi / 2 else abs(value) <= math.pi):
            continue
        inside = {"largest": value < said, "smallest": value > said}.get(find.modifier, False)
        if (angle or value >= 0.0 or said < 0.0) and not inside:
            yield value


def changes_with(answer: Answer, find: Find, known: Numbers, numbers: Numbers, judge: Judge) -> bool:
    """Whether an answer is another with other numbers."""
    own = holding(answer, known)
    said = {} if own is None else said_of(own, known)
    return bool(said) and judge(find, said, numbers).holds is not True
