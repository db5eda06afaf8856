"""Answers: an asked quantity with its solution, a choice with what decides it, and why there may be none, with its place in the file."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.core.faults import Fault, Span, Unsolvable

if TYPE_CHECKING:
    from rotsolve.language.problem import Find, Problem
    from rotsolve.plan import Shortage
    from rotsolve.questions.find import Asked
    from rotsolve.solver.steps import Found


class Answered(Struct, frozen=True):
    """An asked quantity with its solution and the pool indices of the equations that settled it."""

    asked: Asked
    found: Found
    used: tuple[int, ...]
    steps: tuple[int, int] = (0, 0)  # the steps of the solver that belong to it, from and up to
    parts: tuple[Answered, ...] = ()  # the components of a vector
    aside: bool = False  # settled on the way to another answer: the scene does not ask for it

    @property
    def find(self) -> Find:
        return self.asked.find


class Compared(Struct, frozen=True):
    """Two quantities of a choice with the relation between them that holds."""

    left: Answered
    relation: str
    right: Answered


class OptionResult(Struct, frozen=True):
    """One option of a choice: whether it is chosen, its quantity where one alone is asked, and the comparisons that tell."""

    label: str
    holds: bool
    own: Answered | None
    compared: tuple[Compared, ...]

    @property
    def sides(self) -> tuple[Answered, ...]:
        """All that is compared."""
        own = () if self.own is None else (self.own,)
        return (*own, *(side for item in self.compared for side in (item.left, item.right)))


class Chosen(Struct, frozen=True):
    """The answer to a choice."""

    find: Find
    verdicts: tuple[OptionResult, ...]

    @property
    def word(self) -> str:
        """The labels of the options that hold."""
        return ", ".join(verdict.label for verdict in self.verdicts if verdict.holds) or "none"

    @property
    def sides(self) -> tuple[Answered, ...]:
        return tuple(side for verdict in self.verdicts for side in verdict.sides)


class NoAnswer(ValueError):
    """Nothing settles an asked quantity; `shortage` tells what is open where that is why, `equation` what contradicts the others."""

    def __init__(
        self,
        words: str,
        shortage: Shortage | None = None,
        equation: int | None = None,
        *,
        open_form: bool = False,
        met: tuple[str, ...] = (),
    ) -> None:
        super().__init__(words)
        self.shortage = shortage
        self.equation = equation
        self.open_form = open_form  # whether only a closed form is missing
        self.met = met  # the unknowns of plans that did not do


CHECK_DATA = "check the givens and what the states say"


def unsolvable(
    problem: Problem,
    message: str,
    span: Span | None = None,
    help: str = "",
    *,
    kind: str = "",
    others: Sequence[Fault] = (),
) -> Unsolvable:
    """A message with its place in the file, and those of other questions."""
    return Unsolvable(message, span=span, help=help, lines=problem.lines, file=problem.file, kind=kind, others=others)
