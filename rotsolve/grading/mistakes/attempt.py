"""Attempt: a scene answered question by question, with a mistake in it or without; the route by which the right one is answered tells which
mistakes change nothing: what no answer takes can be as wrong as it likes."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Witness, witnessed
from rotsolve.algebra.effort import Exhausted
from rotsolve.core.derivation import Answer
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.derivation.compose import DerivationComposer
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Find
from rotsolve.plan import alike_to_plans
from rotsolve.questions.find import question_for
from rotsolve.search.answering import answer
from rotsolve.search.answers import Answered
from rotsolve.search.consistency import disagreement
from rotsolve.search.search import Search

NO_ANSWER = (Unsolvable, SceneError, ValueError, ArithmeticError)  # what a scene that makes no sense ends in


class Route(Struct, frozen=True):
    """The right scene answered by some laws, and what was asked of numbers on the way."""

    search: Search
    witness: Witness

    @classmethod
    def by(cls, scene: SceneEquations, families: tuple[str, ...], *, confirming: bool = False) -> Route:
        """How the scene is answered by some families of laws, as far as these tell its answers; `confirming` as mistakes are tried."""
        with witnessed() as witness:
            search = Search(scene, families, confirming=confirming)
            Attempt(search).ask_all()
        return cls(search, witness)

    def passes_by(self, altered: SceneEquations) -> bool:
        """Whether the same scene with something altered is answered in just the same way: it puts the same questions, plans can't tell
        its equations from the right ones, and no plan that was carried out takes one that differs."""
        ground, scene = self.search.ground, self.search.scene
        mentions, problem = scene.configuration.mentions, scene.configuration.problem
        if ground is None or problem.sought or mentions.runs or scene.swings:  # which look at laws beside their plans
            return False
        right, wrong = ground.equations, altered.with_asked(self.search.families)
        if len(right) != len(wrong):
            return False
        pairs = enumerate(zip(right, wrong, strict=True))
        differing = [place for place, (one, other) in pairs if one is not other and one != other]
        if not ground.tried.isdisjoint(differing):
            return False
        if not all(alike_to_plans(right[place], wrong[place], ground.known) for place in differing):
            return False
        return all(self._same_question(item, altered) for item in self.search.answered if not item.aside)

    def _same_question(self, item: Answered, altered: SceneEquations) -> bool:
        """Whether an altered scene asks what was asked here."""
        try:
            again = question_for(item.find, altered, self.search.letters())
        except NO_ANSWER:
            return False
        return replace(item.asked, whole=again.whole, swings=()) == replace(again, swings=())


class Attempt:
    """A scene with something altered, answered question by question as far as it is asked.

    `throughout`: all laws speak of what is altered alike, so that they must agree with each other.
    """

    def __init__(self, search: Search, *, throughout: bool = False) -> None:
        self.search, self.throughout = search, throughout
        self._ahead = list(search.scene.configuration.problem.finds)
        self._waiting: list[Find] = []  # those without an answer yet
        self._later = False  # whether something was answered after a question that was not

    def answer(self, name: str) -> Answer | None:
        """The answer of a name, whatever all laws say together; the questions before it are answered first."""
        while any(find.group == name for find in self._ahead):
            self._ask(self._ahead.pop(0))
        if any(find.group == name for find in self._waiting):
            self.ask_all()
        return answers_of(self.search).get(name)

    def answers(self) -> Mapping[str, Answer]:
        """All answers by name; none where laws that must agree do not."""
        self.ask_all()
        return {} if self.throughout and disagreement(self.search) is not None else answers_of(self.search)

    def ask_all(self) -> None:
        """Ask all questions that are left, as far as they have answers; a later one may be what an earlier one waits for."""
        while self._ahead:
            self._ask(self._ahead.pop(0))
        if self._later:
            waiting, self._waiting, self._later = self._waiting, [], False
            for find in waiting:
                self._ask(find)
            self._later = False  # there is no third time

    def _ask(self, find: Find) -> None:
        try:
            answer(self.search, find)
        except Exhausted:  # no more is asked; what was answered before stands
            self._ahead, self._waiting = [], []
            for item in [item for item in self.search.wholes() if item.find.group == find.group]:
                self.search.take_back(item)
            raise
        except NO_ANSWER:
            self._waiting.append(find)
        else:
            self._later = self._later or bool(self._waiting)


def answers_of(search: Search) -> dict[str, Answer]:
    """What a search has answered, by name."""
    return {one.name: one for one in DerivationComposer(search).results.answers()}
