"""Answering: every question of a scene in turn.

One that waits for another is tried again; where a law asked for does not reach, Newton's laws help out.
"""

from __future__ import annotations

from collections.abc import Sequence

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.core.equation import NEWTON
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import RIGHT, UP, Vector
from rotsolve.inquiry.answers import Answered, NoAnswer
from rotsolve.inquiry.explain.unsolvable import unsolvable
from rotsolve.inquiry.finds import asked, entries
from rotsolve.inquiry.inquiry import Inquiry
from rotsolve.inquiry.planning import families_for
from rotsolve.inquiry.questions import NotYet, Unclear, resting
from rotsolve.language.problem import Find


def answer_all(inquiry: Inquiry, finds: Sequence[Find]) -> None:
    """Answer all questions; one that has to wait for another (an asked letter that a later line settles) is tried again."""
    pending = list(finds)
    while pending:
        waiting: list[tuple[Find, Unsolvable]] = []
        for find in pending:
            try:
                answer(inquiry, find)
            except Unsolvable as error:
                waiting.append((find, error))
        if len(waiting) == len(pending):
            raise waiting[0][1]
        pending = [find for find, _ in waiting]


def answer(inquiry: Inquiry, find: Find) -> None:
    """Answer one question, entry by entry where it asks for a matrix or vector."""
    for part in entries(find, inquiry.history):
        if part.name not in inquiry.letters():
            answer_one(inquiry, part)


def answer_one(inquiry: Inquiry, find: Find) -> None:
    """Answer one question for a single quantity, or say why there is no answer."""
    problem = inquiry.history.configuration.problem
    try:
        if find.choice is not None:
            from rotsolve.inquiry.choices import choose

            inquiry.chosen.append(choose(find, find.choice, inquiry, lambda side: by_law(inquiry, side, find.name)))
        elif not by_condition(inquiry, find):
            by_law(inquiry, find)
    except (NotYet, Unclear) as error:
        raise unsolvable(problem, str(error), error.span or find.span, error.help) from None
    except NoAnswer as error:
        from rotsolve.inquiry.explain.missing import no_answer, refuse_unsolved

        if error.shortage is not None:
            refuse_unsolved(inquiry, error.shortage, find)
        raise no_answer(error, inquiry, find) from None


def by_condition(inquiry: Inquiry, find: Find) -> bool:
    """Answer a question with a condition, or for an extremum over a letter; False where it is neither."""
    if find.where is None and not find.extreme:
        return False
    from rotsolve.inquiry.where import answer_where, over_a_letter

    if find.where is None and not over_a_letter(find, inquiry):
        return False
    answer_where(inquiry, find)
    return True


def by_law(inquiry: Inquiry, find: Find, whole: str = "") -> Answered:
    """Answer by the inquiry's laws; where a law asked for does not reach (no energy tells a tension), Newton's laws help out.

    `whole` names the choice to which the question belongs.
    """
    question = asked(find, inquiry.history, inquiry.letters(), inquiry.beside())
    question = replace(question, whole=whole)
    if question.moving.parts and stands(question.moving, inquiry):
        raise NotYet(resting(find.terms[0].path))
    try:
        return inquiry.answer(question)
    except NoAnswer as error:
        if NEWTON in inquiry.families:
            raise
        laws = inquiry.families
        inquiry.families = (*laws, NEWTON)
        try:
            answered = inquiry.answer(question)
        except NoAnswer:
            raise error from None
        finally:
            inquiry.families = laws
        name = whole or find.name
        inquiry.helped += [name] if name not in inquiry.helped else []
        return answered


def stands(velocity: Vector, inquiry: Inquiry) -> bool:
    """Whether a velocity turns out to be nothing."""
    aside = Inquiry(inquiry.history, families_for(None))
    parts = [aside.settled(velocity.along(axis)) for axis in (RIGHT, UP)]
    return all(part is not None and is_zero(part, inquiry.solver.positive) for part in parts)
