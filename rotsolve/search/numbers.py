"""Numbers: what the scene and the answers so far tell of the size and sign of a formula."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from math import floor
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.certified.ball import decided_by_size, ends
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.formula import Formula
from rotsolve.core.symbols import is_quantity

if TYPE_CHECKING:
    from rotsolve.core.passage import Travel

FIGURES = (15, 60, 240)  # significant figures at which a number is looked at, one after the other, until it tells


class Numbers(Struct, frozen=True):
    """Numbers by the values of the givens; `with_answers` puts in what is found, `aside` finds a letter without a derivation, and `unreal`
    tells whether the root of a negative number stands in a formula, also by answers that are numbers alone."""

    signs: SignOracle
    with_answers: Callable[[Formula], Formula]
    aside: Callable[[str], Formula | None]
    unreal: Callable[[Formula], bool]

    def of(self, value: Formula) -> float | None:
        """A rough value, 0 where no precision tells it from 0; None where it is not real or a given has no number."""
        number = self.signs.supposed(value)
        return None if number is None else number.float if number.sign else 0.0

    def found(self, value: Formula) -> float | None:
        """A rough value with the answers put in."""
        return self.of(self.with_answers(value))

    def side(self, value: Formula) -> int | None:
        """The sign of a value, 0 where no precision tells it from 0; None where it is not real or a given has no number."""
        number = self.signs.supposed(value)
        return None if number is None else number.sign or 0

    def whole(self, value: Formula) -> int | None:
        """The greatest whole number that is not greater than a value; None where the numbers do not tell."""
        if not self.signs.lacking(value):
            decided_by_size()
        number = self.signs.supposed(value)
        if number is None:
            return None
        for figures in FIGURES:
            low, high = ends(number.refine(figures))
            exact = high - low < Fraction(1, 2) and number.equals(Fraction(floor(high)))
            if floor(low) == floor(high) or exact:
                for bound in (floor(high), floor(high) + 1):
                    self.side(value - bound)
                return floor(high)
        return None

    def least(self, values: Sequence[Formula]) -> int:
        """The place of the smallest value, the first of several; of letters it is a condition that it is."""
        if len(values) > 1 and not any(map(self.signs.lacking, values)):
            decided_by_size()
            return min(range(len(values)), key=lambda place: self.of(values[place]) or 0.0)
        best = 0
        for place, value in enumerate(values):
            best = place if place and self.side(value - values[best]) == -1 else best
        return best

    def sign(self, values: Iterable[Formula | None]) -> int:
        """The sign of the first value that has one, with the answers put in; 0 where none has."""
        for value in values:
            side = self.side(self.with_answers(value)) if value is not None else None
            if side:
                return side
        return 0

    def onset(self, travel: Travel) -> int:
        """Which way a body sets out: as it moves at the start, else, from rest, as it is pushed; 0 where nothing tells.

        A speed at the start that is a letter of its own, as that of a wheel that another one turns, is found aside.
        """
        side = self.side(self.with_answers(travel.before))
        if side is None and (speed := self.push(travel.before)) is not None:
            side = self.side(self.with_answers(speed))
        return self.sign((self.push(travel.initial),)) if side == 0 else side or 0

    def push(self, acceleration: Formula | None) -> Formula | None:
        """An acceleration or a speed at the start of a motion, found aside where it is a letter."""
        if not is_quantity(acceleration):
            return acceleration
        return self.aside(acceleration.name)
