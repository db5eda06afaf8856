"""Asked: a question as one formula over the letters of the laws; of a vector with the questions for its components."""

from __future__ import annotations

from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, Symbol, add, sqrt
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.derivation import Words
from rotsolve.core.equation import DEFINITION, Equation, Law
from rotsolve.core.registry import SEPARATOR
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, UP, Vector
from rotsolve.language.problem import Find, Path

if TYPE_CHECKING:
    from rotsolve.equations.swings.swing import Swing


class Asked(Struct, frozen=True):
    """An asked quantity: its name, what it is made of, and the letter that stands for it in the laws.

    `letter` is the quantity's own letter where the question is just that quantity, else a letter made for the question; `section` is
    where its definition belongs. `parts` are the questions for the components of a vector, which are answered before its size; each
    of them, and each quantity that a choice compares, knows its `whole` by name. `moving` is a velocity without which the question
    has no meaning; `said` is a remark with formulas in it, `definitions` are the steps that lead to the formula, and
    `laws` what this question alone speaks of, such as when a wheel reverses.
    """

    find: Find
    formula: Formula
    letter: str
    dimension: Dimension | None
    vector: Vector | None = None
    remark: str = ""
    label: str = ""
    law: Law = DEFINITION
    section: str = ""
    words: tuple[str, str] = ("", "")
    parts: tuple[Asked, ...] = ()
    whole: str = ""
    moving: Vector = NOWHERE
    said: Words = ()
    definitions: tuple[Equation, ...] = ()
    laws: tuple[Equation, ...] = ()
    swings: tuple[tuple[Swing, str], ...] = ()  # with what is asked of each: its period or frequency

    @property
    def direct(self) -> bool:
        """Whether the question is a single quantity of the laws."""
        return isinstance(self.formula, Symbol) and self.formula.name == self.letter

    def same_as(self, other: Asked) -> bool:
        """Whether both ask for the same, under whatever names."""
        return self.letter == other.letter or (self.formula, self.section) == (other.formula, other.section)

    @property
    def of_givens(self) -> bool:
        """Whether the question is made of givens alone, so that no law has a say in it."""
        return not self.find.terms and not any(SEPARATOR in name for name in self.formula.symbols())

    @property
    def points(self) -> bool:
        """Whether a vector or a part of one is asked, not a mere speed."""
        return self.vector is not None and self.find.terms[0].path.quantity != "speed"

    @property
    def resolves(self) -> bool:
        """Whether a whole vector is asked, not one component of it."""
        return self.vector is not None and whole_vector(self.find.terms[0].path)


def whole_vector(path: Path) -> bool:
    """Whether a path that may be a vector asks for all of it: not for one component, nor a mere speed."""
    return path.quantity != "speed" and path.component in (None, "gravity")


def in_parts(question: Asked) -> Asked:
    """The question for a vector with those for its components in front: v_x and v_y, then v = √(v_x² + v_y²).

    A vector of one part needs none: its size and its direction are seen at once.
    """
    vector = question.vector
    if (
        vector is None
        or not question.resolves
        or len(vector.parts) < 2
        or ZERO in (vector.along(RIGHT), vector.along(UP))
    ):
        return question
    parts = tuple(component(question, vector, axis) for axis in "xy")
    headings = [heading for _, heading in vector.parts]
    if len(headings) == 2 and (headings[0] - headings[1]).cos() == ZERO and headings[0].terms:
        return replace(question, parts=parts)  # such as √(a_t² + a_n²), shorter than by x and y
    size = sqrt(add(*(Symbol(part.letter) ** 2 for part in parts)))
    return replace(question, formula=size, parts=parts)


def component(question: Asked, vector: Vector, axis: str) -> Asked:
    """The question for one component of a vector."""
    find = question.find
    path = replace(find.terms[0].path, component=axis)
    own = replace(find, name=f"{find.name}_{axis}", terms=(replace(find.terms[0], path=path),))
    formula = vector.along(RIGHT if axis == "x" else UP)
    direct = isinstance(formula, Symbol) and SEPARATOR in formula.name
    letter = formula.name if isinstance(formula, Symbol) and direct else SEPARATOR.join((question.letter, axis))
    side, words = ("horizontally", ("right", "left")) if axis == "x" else ("vertically", ("up", "down"))
    return Asked(
        own,
        formula,
        letter,
        question.dimension,
        label=f"{question.label}, {side}",
        law=question.law,
        section=question.section,
        words=words,
        whole=find.name,
    )
