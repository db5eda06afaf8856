"""Scene: a problem in which mistakes are made: its part that is asked for, its facts, and its answers, right and with a mistake."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from msgspec import Struct

from rotsolve.algebra.formula import Formula
from rotsolve.core.derivation import Answer
from rotsolve.core.facts import BodyFacts, Facts
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.grading.mistakes.differing import Differing
from rotsolve.grading.mistakes.mistake import Change, Mistake
from rotsolve.grading.mistakes.numbers import reread
from rotsolve.inquiry.answering import answer
from rotsolve.inquiry.checks import disagreement
from rotsolve.inquiry.compose import Composer
from rotsolve.inquiry.friction import decide
from rotsolve.inquiry.history import History
from rotsolve.inquiry.inquiry import Inquiry
from rotsolve.inquiry.planning import families_for
from rotsolve.language.problem import Find, Problem
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.positive import positive_letters
from rotsolve.pipeline import asked_part

ROUNDS = 2  # times that a question is asked
NO_ANSWER = (Unsolvable, SceneError, ValueError, ArithmeticError)  # what a scene that makes no sense ends in


class Scene(Struct, frozen=True, dict=True):
    """A problem that has been read, with all that its mistakes have in common worked out once."""

    whole: Problem

    @cached_property
    def configuration(self) -> Configuration:
        return asked_part(self.whole)

    @property
    def problem(self) -> Problem:
        """The part that is asked for, with letters for what the scene leaves out."""
        return self.configuration.problem

    @cached_property
    def modes(self) -> Mapping[str, str]:
        """What slips, and which way."""
        return decide(self.configuration).modes

    @cached_property
    def history(self) -> History:
        return History(self.configuration, self.modes)

    @cached_property
    def moments(self) -> tuple[Facts, ...]:
        """The facts at all states."""
        return tuple(self.history.facts(state.name) for state in self.configuration.timeline.states)

    @cached_property
    def bodies(self) -> Mapping[str, BodyFacts]:
        """The facts of each body by its name, at the first state at which it is there."""
        found: dict[str, BodyFacts] = {}
        for body in (body for facts in self.moments for body in facts.bodies):
            found.setdefault(body.name, body)
        return found

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
        return self._wrong(given, self.answers, self.problem.values)

    def with_values(
        self, mistake: Mistake, answers: Mapping[str, Answer], values: Mapping[str, Formula]
    ) -> Mapping[str, Answer] | None:
        """The answers that a mistake changes, from those for the numbers of the scene, for other numbers; nothing is solved again."""
        right = {name: reread(one, {}, values) for name, one in self.answers.items()}
        if mistake.change.reread:
            return self._wrong(self._reread(mistake.change, values), right, values)
        return self._wrong({name: reread(one, {}, values) for name, one in answers.items()}, right, values)

    def _wrong(
        self, given: Mapping[str, Answer], right: Mapping[str, Answer], values: Mapping[str, Formula]
    ) -> Mapping[str, Answer] | None:
        """Those of some answers that are not right, as far as they are not; None where all are."""
        differing = Differing(frozenset(positive_letters(self.problem.givens)), values)
        pairs = ((name, differing.left_of(one, right[name])) for name, one in given.items() if name in right)
        return {name: wrong for name, wrong in pairs if wrong is not None} or None

    def _reread(self, change: Change, values: Mapping[str, Formula]) -> Mapping[str, Answer]:
        """The right answers with other letters and numbers in them."""
        wrong = {name: values[name] * factor for name, factor in change.factors.items() if name in values}
        return {name: reread(one, change.letters, {**values, **wrong}) for name, one in self.answers.items()}

    def _answers(self, change: Change) -> Mapping[str, Answer]:
        """The answers of the scene with a change in it, right ones among them."""
        if change.reread:
            return self._reread(change, self.problem.values)
        problem = self.problem if change.problem is None else change.problem(self.problem)
        configuration = Configuration(problem, change.altered)
        modes = self.modes if change.problem is None else decide(configuration).modes
        families = tuple(family for family in families_for(None) if family not in change.aside)
        inquiry = Inquiry(History(configuration, modes), families, confirming=True)
        answers = answers_of(inquiry)
        return {} if change.throughout and disagreement(inquiry) is not None else answers


def answers_of(inquiry: Inquiry) -> dict[str, Answer]:
    """The answers to those questions that have one, by name; the others may need what is left out, or one that comes later."""
    pending = list(inquiry.history.configuration.problem.finds)
    for _ in range(ROUNDS):
        waiting: list[Find] = []
        later = False  # whether something was answered after a question that was not
        for find in pending:
            try:
                answer(inquiry, find)
            except NO_ANSWER:
                waiting.append(find)
            else:
                later = later or bool(waiting)
        pending = waiting if later else []
    return {one.name: one for one in Composer(inquiry).results.answers()}
