"""Steps: what solving leaves behind: lines of algebra, solved unknowns, and the ways in which a plan can fail."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import NamedTuple

from msgspec import Struct

from rotsolve.algebra.certified.ball import Certified
from rotsolve.algebra.formula import PI, Formula, Number
from rotsolve.core.derivation import Equality, Words

# ('law', index in the pool) | ('step', number of the step) | ('known', an answer found before) | ('words', what is to hold)
Ref = tuple[str, "int | str"]


class Choice(NamedTuple):
    """The root that is meant, why, and the whole turns that an angle has gone beyond it, or the whole periods of a time."""

    root: int
    words: Words = ()
    turns: Fraction = Fraction(0)
    period: Formula = 2 * PI

    def of(self, roots: Sequence[Formula]) -> Formula:
        """The root itself, with its whole turns."""
        root = roots[self.root]
        return root + Number(self.turns) * self.period if self.turns else root


# the letter, its roots, and how much later they hold again, where they do
Chooser = Callable[[str, Sequence[Formula], "Formula | None"], "Choice | None"]


class Redundant(ValueError):
    """An equation of a plan says nothing new once the others are put in."""

    def __init__(self, index: int) -> None:
        super().__init__(f"equation {index} says nothing new")
        self.index = index


class Contradiction(ValueError):
    """The equations of a plan can not all hold."""

    def __init__(self, index: int) -> None:
        super().__init__(f"equation {index} contradicts the others")
        self.index = index


class NoClosedForm(ValueError):
    """No unknown can be isolated."""


class Step(Struct, frozen=True):
    """One line of algebra: what is put into what, the chain of equalities, the unknown that it isolates."""

    number: int
    target: Ref
    sources: tuple[Ref, ...]
    chain: tuple[Equality, ...]
    result: str
    section: str
    reason: Words = ()


class Found(Struct, frozen=True):
    """A solved unknown: closed form in givens, or a certified root of the last equation."""

    name: str
    formula: Formula | None
    number: Certified | None = None
    others: tuple[Formula, ...] = ()
