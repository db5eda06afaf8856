"""Definitions: what is asked and is no letter of the laws gets one of its own; steps that lead to a question serve that question alone."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING

from msgspec import Struct, field

from rotsolve.algebra.exact.normal import degree
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.matching import Plan
from rotsolve.plan import Planner

if TYPE_CHECKING:
    from rotsolve.core.equation import Equation
    from rotsolve.language.problem import Given
    from rotsolve.questions.find import Asked
    from rotsolve.search.answers import Answered
    from rotsolve.solver.steps import Step


class Definitions(Struct):
    """The definitions of all questions so far, by their places in the planner's pool."""

    planner: Planner
    givens: Mapping[str, Given]
    places: dict[str, int] = field(default_factory=dict)  # by the letter of the question

    def enter(self, asked: Asked, earlier: Sequence[Answered]) -> None:
        """Define the letter of a question, once."""
        if asked.direct or asked.letter in self.places:
            return
        made_of = [item.asked.section for item in earlier if item.asked.letter in asked.formula.symbols()]
        section = asked.section or (made_of[-1] if made_of else "")
        label, remark = asked.label or "definition", asked.said or ((asked.remark,) if asked.remark else ())
        definition = asked.law.equation(Symbol(asked.letter), asked.formula, section, (), remark, cost=1, words=label)
        self.places[asked.letter] = self.planner.extend(definition)

    def formula(self, letter: str) -> Formula | None:
        """What an asked letter was defined to stand for."""
        return self.planner.pool[self.places[letter]].right if letter in self.places else None

    def spent(self, asked: Asked, steps: Sequence[Step]) -> set[int]:
        """The definition of an answered question where it must serve no other; else it becomes the last way to what it is made of.

        A size, a component or a loss does not lead back, nor what the `steps` of its own answer have turned round already.
        """
        place = self.places.get(asked.letter)
        if place is None:
            return set()
        turned_round = any(step.target == ("law", place) and step.sources == () for step in steps)
        if asked.whole or turned_round or not self._leads_back(asked.formula):
            return {place}
        self.planner.dear.add(place)
        return set()

    def _leads_back(self, meaning: Formula) -> bool:
        """Whether a definition may tell what it is made of: a single unknown, in proportion or with a sum, as in φ = θ + π/2."""
        names = {name for name in meaning.symbols() if name not in self.givens or self.givens[name].asked}
        return len(names) == 1 and degree(meaning, names.pop()) == 1


class Stepwise(Struct):
    """The steps of all questions so far, by their places in the planner's pool."""

    planner: Planner
    steps: dict[str, set[int]] = field(default_factory=dict)  # by the letter of the question
    places: dict[Equation, int] = field(default_factory=dict)

    def take(self, asked: Asked) -> None:
        """Enter the definitions of a question."""
        for step in asked.definitions:
            if step not in self.places:
                self.places[step] = self.planner.extend(step)
        if asked.definitions:
            self.steps[asked.letter] = {self.places[step] for step in asked.definitions}

    def foreign(self, letter: str) -> set[int]:
        """The steps of other questions, of which none tells this letter."""
        others = {place for step, place in self.places.items() if step.defines != letter}
        return others - self.steps.get(letter, set())

    def plan(self, letter: str, known: Collection[str], definition: int | None, banned: set[int]) -> Plan | None:
        """The plan that the steps of a question make, with what was found before and what the laws define."""
        own = self.steps.get(letter)
        if not own:
            return None
        pool = self.planner.pool
        open_ = {index for index in own if not pool[index].left.symbols() <= set(known)}
        told = {name for index in open_ for name in pool[index].left.symbols()}
        allowed = open_ | {
            index for index, equation in enumerate(pool) if equation.defines and equation.defines not in told
        }
        if definition is not None:
            allowed.add(definition)
        plan = self.planner.plan(letter, known, sorted(allowed - banned))
        return plan if isinstance(plan, Plan) else None
