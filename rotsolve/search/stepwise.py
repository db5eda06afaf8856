"""Stepwise: the definitions that lead to a question serve that question alone: as laws they would lead anywhere."""

from __future__ import annotations

from collections.abc import Collection

from msgspec import Struct, field

from rotsolve.core.equation import Equation
from rotsolve.plan import Plan, Planner
from rotsolve.questions.question import Asked


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
        """The steps of other questions."""
        return set(self.places.values()) - self.steps.get(letter, set())

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
