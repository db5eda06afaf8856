"""Conclusions: answers that follow from a condition on other answers, each with its one line of algebra."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.derivation import Equality, Words
from rotsolve.core.equation import FOUND
from rotsolve.questions.find import Asked
from rotsolve.search.answers import Answered
from rotsolve.search.search import Search
from rotsolve.solver.steps import Found, Ref, Step


class Conclusion(Struct, frozen=True):
    """The line of a condition: "dB/dx = 0", what that comes to as an equation, and why it is this root."""

    said: str
    equation: Equality
    reason: Words


def by_condition(
    search: Search, question: Asked, value: Formula, line: Conclusion, quantity: Answered, *, aside: bool
) -> Answered:
    """An answer that solves what an answer before it, as a function of a letter, has to fulfil."""
    chain = (line.equation, Equality(Symbol(question.letter), value))
    steps = add_step(search, question, ("words", line.said), (ref_of(quantity, search),), chain, line.reason)
    return remember_answer(search, Answered(question, Found(question.letter, value), (), steps, aside=aside))


def by_answers(
    search: Search, asked: Asked, found: Found, line: Sequence[Equality], sources: Sequence[Answered]
) -> None:
    """An answer that puts answers before into the first of them."""
    refs = [ref_of(source, search) for source in sources]
    remember_answer(search, Answered(asked, found, (), add_step(search, asked, refs[0], refs[1:], line, ())))


def add_step(
    search: Search, asked: Asked, target: Ref, sources: Sequence[Ref], chain: Sequence[Equality], reason: Words
) -> tuple[int, int]:
    """The line of algebra, and where it stands among the steps."""
    steps = search.solver.steps
    steps.append(Step(len(steps) + 1, target, tuple(sources), tuple(chain), asked.letter, asked.section, reason))
    return len(steps) - 1, len(steps)


def remember_answer(search: Search, answered: Answered) -> Answered:
    """Remember an answer for the next question."""
    search.solver.solved[answered.asked.letter] = answered.found
    search.known.add(answered.asked.letter)
    search.answered.append(answered)
    return answered


def ref_of(answered: Answered, search: Search) -> Ref:
    """The step that gave an answer, or its one law where it needed none."""
    steps = search.solver.steps[slice(*answered.steps)]
    return ("step", steps[-1].number) if steps else ("law", answered.used[0])


def forget(answered: Answered, search: Search) -> None:
    """Let a quantity be settled anew from its closed form, since a letter in that has got a value."""
    letter, formula = answered.asked.letter, answered.found.formula
    del search.solver.solved[letter]
    search.known.discard(letter)
    if formula is not None:
        result = FOUND.equation(Symbol(letter), formula, answered.asked.section, cost=1)
        search.solver.derived.append((result, ref_of(answered, search)))
        search.remember()
