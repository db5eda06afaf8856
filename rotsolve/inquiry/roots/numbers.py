"""Numbers: what the scene and the answers so far tell of the size and sign of a formula, roughly."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from msgspec import Struct

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.registry import SEPARATOR


def rough(value: Formula, values: Mapping[str, Formula]) -> float | None:
    """A rough value; None where it is not real or a given has no number."""
    try:
        return evaluate(value, values, digits=8).float
    except (Undefined, ValueError, ZeroDivisionError):
        return None


class Numbers(Struct, frozen=True):
    """Rough numbers by the values of the givens; `with_answers` puts in what is found, `aside` finds a letter without a derivation."""

    values: Mapping[str, Formula]
    with_answers: Callable[[Formula], Formula]
    aside: Callable[[str], Formula | None]

    def of(self, value: Formula) -> float | None:
        """A rough value; None where it is not real or a given has no number."""
        return rough(value, self.values)

    def found(self, value: Formula) -> float | None:
        """A rough value with the answers put in."""
        return self.of(self.with_answers(value))

    def sign(self, values: Iterable[Formula | None]) -> int:
        """The sign of the first value that has one, with the answers put in; 0 where none has."""
        for value in values:
            size = self.found(value) if value is not None else None
            if size:
                return 1 if size > 0 else -1
        return 0

    def push(self, acceleration: Formula | None) -> Formula | None:
        """The acceleration that starts the motion, found aside."""
        if acceleration is None or not isinstance(acceleration, Symbol) or SEPARATOR not in acceleration.name:
            return acceleration
        return self.aside(acceleration.name)
