"""Results: answers as they are printed: the exact form, the certified value in a unit, the direction in words."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from rotsolve.algebra.certified.ball import Certified, evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import length
from rotsolve.algebra.formula import ONE, Formula, Symbol
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.algebra.units.quantities import unit_for
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.core.derivation import Answer, Equality
from rotsolve.core.heading import RIGHT, UP, Vector
from rotsolve.core.registry import SEPARATOR
from rotsolve.inquiry.answering import Answered, Inquiry
from rotsolve.solver import Found

LONG = 220  # nodes of a formula beyond which it is left in letters found before


NAMING = ("torque", "impulse", "frequency")  # quantities whose unit the dimension alone does not tell


@dataclass(frozen=True)
class Results:
    """The answers of an inquiry; `printed` turns letters of the laws into printed ones."""

    inquiry: Inquiry
    printed: Callable[[Formula], Formula]

    def answer(self, answered: Answered) -> Answer:
        """The exact form, the certified value and the direction in words."""
        asked, found = answered.asked, answered.found
        formula = self.printed(self._readable(answered)) if found.formula is not None else None
        unit = asked.find.unit or unit_of(
            asked.dimension, asked.find.terms[0].path.quantity if len(asked.find.terms) == 1 else ""
        )
        value = self._value_in(found, unit)
        direction, signed = self._direction(answered, value)
        return Answer(
            asked.find.name, Symbol(asked.find.name), formula, value, unit, asked.dimension, direction, signed
        )

    def _readable(self, answered: Answered) -> Formula:
        """The closed form; one that no page would hold stays in the letters found before."""
        formula = answered.found.formula
        assert formula is not None
        steps = self.inquiry.solver.steps[slice(*answered.steps)]
        if length(formula) <= LONG or not steps:
            return formula
        return readable(steps[-1].chain)[-1].right

    def _value_in(self, found: Found, unit: Unit | None) -> Certified | None:
        """The certified value in a unit."""
        factor = unit.factor if unit is not None else ONE
        if found.formula is not None:
            return self.value(found.formula / factor)
        number = found.number
        if number is None or factor == ONE:
            return number
        scale = evaluate(factor, {}, digits=30)
        return Certified(
            number.ball / scale.ball,
            lambda digits: number.refine(digits + 3) / scale.refine(digits + 3),
            lambda _: False,
        )

    def value(self, formula: Formula) -> Certified | None:
        if formula.symbols() - set(self.inquiry.values):
            return None
        try:
            return evaluate(formula, self.inquiry.values)
        except Undefined:
            return None

    def _direction(self, answered: Answered, value: Certified | None) -> tuple[str, bool]:
        """Direction in words, and whether the number is still printed with its sign."""
        asked = answered.asked
        if asked.vector is not None:
            heading = self.heading_words(asked.vector)
            return heading, not heading
        quantity = self.inquiry.history.registry.quantities.get(asked.letter)
        words = asked.words
        if quantity is not None and any((quantity.positive, quantity.negative)):
            words = (quantity.positive, quantity.negative) if quantity.kind != "angle" else ("", "")
        if not any(words) or value is None or not value.sign:
            return "", True
        return words[0 if value.sign > 0 else 1], False

    def heading_words(self, vector: Vector) -> str:
        """Down and to the right, with the angle left to the numbers."""
        sides = []
        for axis in (UP, RIGHT):
            component = self.inquiry.solver.with_answers(self._solved(vector.along(axis)))
            if any(SEPARATOR in name for name in component.symbols()):
                component = self.inquiry.apart().settled(component) or component
            try:
                sides.append(evaluate(component, self.inquiry.values, digits=3).sign or 0)
            except (Undefined, ValueError):
                return ""
        rise = {1: "up", -1: "down", 0: ""}[sides[0]]
        side = {1: "to the right", -1: "to the left", 0: ""}[sides[1]]
        return " and ".join(part for part in (rise, side) if part)

    def _solved(self, value: Formula) -> Formula:
        """All letters in a formula by what the steps found for them."""
        for step in reversed(self.inquiry.solver.steps):
            if step.result in value.symbols():
                value = value.substitute({step.result: step.chain[-1].right})
        return value


def readable(chain: tuple[Equality, ...]) -> tuple[Equality, ...]:
    """A chain of equalities without a last one that no page would hold."""
    if len(chain) > 1 and length(chain[-1].right) > LONG >= length(chain[-2].right):
        return chain[:-1]
    return chain


def unit_of(dimension: Dimension | None, quantity: str) -> Unit | None:
    """The unit that the field uses for a dimension; none for a pure number."""
    return None if dimension is None else unit_for(dimension, quantity if quantity in NAMING else None)
