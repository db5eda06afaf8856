"""Scene: a problem in which mistakes are made: its part that is asked for, its facts, and its answers, right and with a mistake."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property

from msgspec import Struct

from rotsolve.core.derivation import Answer
from rotsolve.core.facts import BodyFacts, Facts
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.grading.mistakes.differing import differing
from rotsolve.grading.mistakes.mistake import Change, Mistake
from rotsolve.grading.mistakes.numbers import reread
from rotsolve.inquiry.answering import answer
from rotsolve.inquiry.compose import Composer
from rotsolve.inquiry.friction import decide
from rotsolve.inquiry.history import History
from rotsolve.inquiry.inquiry import Inquiry
from rotsolve.inquiry.planning import families_for
from rotsolve.motion.arrangement import Arrangement
from rotsolve.motion.positive import positive_letters
from rotsolve.pipeline import asked_part
from rotsolve.scene.model import Problem

NO_ANSWER = (Unsolvable, SceneError, ValueError, ArithmeticError)  # what a scene that makes no sense ends in


class Scene(Struct, frozen=True, dict=True):
    """A problem that has been read, with all that its mistakes have in common worked out once."""

    whole: Problem

    @cached_property
    def arrangement(self) -> Arrangement:
        return asked_part(self.whole)

    @property
    def problem(self) -> Problem:
        """The part that is asked for, with letters for what the scene leaves out."""
        return self.arrangement.problem

    @cached_property
    def modes(self) -> Mapping[str, str]:
        """What slips, and which way."""
        return decide(self.arrangement).modes

    @cached_property
    def history(self) -> History:
        return History(self.arrangement, self.modes)

    @cached_property
    def moments(self) -> tuple[Facts, ...]:
        """The facts at all states."""
        return tuple(self.history.facts(state.name) for state in self.arrangement.timeline.states)

    def bodies(self) -> Iterator[BodyFacts]:
        """The facts of each body, at the first state at which it is there."""
        seen: set[str] = set()
        for body in (body for facts in self.moments for body in facts.bodies):
            if body.name not in seen:
                seen.add(body.name)
                yield body

    @cached_property
    def answers(self) -> Mapping[str, Answer]:
        """The right answers by name."""
        return answers_of(Inquiry(self.history, families_for(None)))

    def with_mistake(self, mistake: Mistake) -> Mapping[str, Answer] | None:
        """The answers that the mistake changes; None where it changes none, or the scene has no answer then."""
        try:
            given = self._answers(mistake.change)
        except NO_ANSWER:
            return None
        positive = positive_letters(self.problem.givens)
        both = ((name, wrong, self.answers.get(name)) for name, wrong in given.items())
        pairs = ((name, differing(wrong, right, positive)) for name, wrong, right in both if right is not None)
        return {name: wrong for name, wrong in pairs if wrong is not None} or None

    def _answers(self, change: Change) -> Mapping[str, Answer]:
        """The answers of the scene with a change in it, right ones among them."""
        if change.letters or change.numbers:
            values = {**self.problem.values, **change.numbers}
            return {name: reread(one, change.letters, values) for name, one in self.answers.items()}
        problem = self.problem if change.problem is None else change.problem(self.problem)
        arrangement = Arrangement(problem, change.altered)
        modes = self.modes if change.modes_kept else decide(arrangement).modes
        families = tuple(family for family in families_for(None) if family != change.aside)
        return answers_of(Inquiry(History(arrangement, modes), families, confirming=True))


def answers_of(inquiry: Inquiry) -> dict[str, Answer]:
    """The answers to those questions that have one, by name; the others may need what is left out."""
    pending = list(inquiry.history.arrangement.problem.finds)
    while pending:
        waiting = []
        for find in pending:
            try:
                answer(inquiry, find)
            except NO_ANSWER:
                waiting.append(find)
        if len(waiting) == len(pending):
            break
        pending = waiting
    return {one.name: one for one in Composer(inquiry).results.answers()}
