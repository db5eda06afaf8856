"""Ways: how a scene is answered by some laws, and which mistakes are on none of them: what no answer takes can be as wrong as it likes."""

from __future__ import annotations

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Witness, witnessed
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Find
from rotsolve.plan import alike_to_plans
from rotsolve.questions.find import question_for
from rotsolve.search.answering import answer
from rotsolve.search.answers import Answered
from rotsolve.search.search import Search

ROUNDS = 2  # times that a question is asked
NO_ANSWER = (Unsolvable, SceneError, ValueError, ArithmeticError)  # what a scene that makes no sense ends in


class Way(Struct, frozen=True):
    """The right scene answered by some laws, and what was asked of numbers on the way."""

    search: Search
    witness: Witness

    @classmethod
    def by(cls, scene: SceneEquations, families: tuple[str, ...]) -> Way:
        """How the scene is answered by some families of laws, as far as these tell its answers."""
        with witnessed() as witness:
            search = Search(scene, families)
            ask_all(search)
        return cls(search, witness)

    def passes_by(self, altered: SceneEquations) -> bool:
        """Whether the same scene with something altered is answered in just the same way: it puts the same questions, plans can't tell
        its equations from the right ones, and no plan that was carried out takes one that differs."""
        ground, configuration = self.search.ground, self.search.scene.configuration
        if ground is None or len(configuration.problem.sought) > 1 or configuration.mentions.runs:
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


def ask_all(search: Search) -> None:
    """Ask all questions of a scene as far as they have answers; a later one may be what an earlier one waits for."""
    pending = list(search.scene.configuration.problem.finds)
    for _ in range(ROUNDS):
        waiting: list[Find] = []
        later = False  # whether something was answered after a question that was not
        for find in pending:
            try:
                answer(search, find)
            except NO_ANSWER:
                waiting.append(find)
            else:
                later = later or bool(waiting)
        pending = waiting if later else []
