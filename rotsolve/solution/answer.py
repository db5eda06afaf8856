"""Answer: one answer as Python uses it: a number with certified digits, an exact form, a SymPy expression, or what a notebook shows."""

from __future__ import annotations

import builtins
from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from rotsolve.core.derivation import Answer
from rotsolve.language.words import hint

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula


class AnswerView(Struct, frozen=True, eq=False):
    """One answer, ready for use in Python. Numbers are in `unit`, signed in the declared sense; `float(answer)` is the number.

    Two are equal where they say the same: name, form, number to as many digits as are shown, unit and direction.
    """

    answer: Answer
    digits: int = 4
    letters: tuple[str, ...] = ()  # those of the scene

    @property
    def name(self) -> str:
        """The name under `find`."""
        return self.answer.name

    @property
    def formula(self) -> Formula | None:
        """The exact form as a formula; None where there is no closed form."""
        return self.answer.formula

    @property
    def exact(self) -> str | None:
        """The exact form as a textbook prints it."""
        from rotsolve.algebra.notation.text import to_text

        return None if self.answer.formula is None else to_text(self.answer.formula)

    @property
    def value(self) -> str | None:
        """The number as text, every digit of it certified, as `-4.5e-05` where it is small; None without one."""
        return self.certified(self.digits)

    def certified(self, digits: int) -> str | None:
        """The number to so many significant digits, correctly rounded, each of them certified; None without a number.

        Fewer stand there where the number is exact, or where no more can be certified. TypeError and ValueError as for `solve`.
        """
        from rotsolve.algebra.certified.ball import refuse_digits
        from rotsolve.page.values import certified_digits, machine_number

        refuse_digits(digits)
        return machine_number(certified_digits(self.answer.value, digits)[0]) or None

    @property
    def float(self) -> builtins.float | None:
        """The number as a float; None without one."""
        return None if self.answer.value is None else self.answer.value.float

    @property
    def si(self) -> builtins.float | None:
        """The number in SI units, angles in radians."""
        return None if self.answer.value is None else self.in_unit("")

    def in_unit(self, unit: str) -> builtins.float:
        """The number in another unit, `answer.in_unit("cm/s^2")`; in SI for ''. ValueError for a unit of something else."""
        from rotsolve.algebra.certified.ball import multiple_of
        from rotsolve.algebra.formula import ONE
        from rotsolve.algebra.units.dimension import describe
        from rotsolve.algebra.units.quantities import parse_unit

        if not isinstance(unit, str):
            raise TypeError(f"a unit is a text, not {unit!r}")
        float(self)
        assert self.answer.value is not None
        own, told = self.answer.unit, parse_unit(unit) if unit else None
        if told is not None and (own is None or not told.dimension.matches(own.dimension)):
            measured = "a number" if own is None else describe(own.dimension, article=True)
            raise ValueError(f"`{unit}` is no unit of `{self.name}`, which is {measured}")
        factor = ONE if own is None else own.factor
        return multiple_of(self.answer.value, factor if told is None else factor / told.factor).float

    @property
    def unit(self) -> str:
        """The unit of `value`, '' for a pure number."""
        return "" if self.answer.unit is None else self.answer.unit.text

    @property
    def direction(self) -> str:
        """The direction in words, '' where there is none."""
        return self.answer.direction

    @property
    def angle(self) -> builtins.float | None:
        """The angle of a slanted vector to the horizontal, in degrees; None of all else."""
        return None if self.answer.angle is None else self.answer.angle.float

    @property
    def conditions(self) -> tuple[str, ...]:
        """What letters have to fulfil for it to hold: ("P ≤ μ m g",)."""
        from rotsolve.algebra.notation.text import to_text

        sides = ((to_text(one.left), one.relation, to_text(one.right)) for one in self.answer.conditions)
        return tuple(map(" ".join, sides))

    @property
    def otherwise(self) -> tuple[AnswerView, ...]:
        """The answers under other conditions."""
        return tuple(AnswerView(other, self.digits, self.letters) for other in self.answer.otherwise)

    @property
    def branches(self) -> tuple[AnswerView, ...]:
        """It and the answers under other conditions."""
        return self, *self.otherwise

    @property
    def word(self) -> str:
        """The answer to a question that asks for a word: "slips"."""
        return self.answer.word

    @property
    def components(self) -> Mapping[str, AnswerView]:
        """The parts of a vector answer by name: `v_x` and `v_y` of `v`."""
        return MappingProxyType(
            {part.name: AnswerView(part, self.digits, self.letters) for part in self.answer.components}
        )

    def __getitem__(self, name: str) -> AnswerView:
        """A part of a vector or tensor: `solution["v"]["v_x"]`."""
        if name not in self.components:
            raise KeyError(f"`{self.name}` has no part `{name}`: {hint(name, tuple(self.components), 'parts')}")
        return self.components[name]

    def __float__(self) -> builtins.float:
        """The number, in `unit`; TypeError where there is none, which says what there is."""
        if self.answer.value is not None:
            return self.answer.value.float
        if self.word:
            raise TypeError(f"`{self.name}` is no number but a word: {self.word!r}")
        if self.answer.rows:
            parts = ", ".join(f"[{name!r}]" for name in self.components)
            raise TypeError(f"`{self.name}` is no single number: take one of its parts, {parts}")
        raise TypeError(
            f"`{self.name}` has no number, since letters have none: solve with `settings`, or put values in by `subs`"
        )

    @property
    def sympy(self) -> Any:
        """The exact form in the letters of the scene, in SI units, as a SymPy expression of plain symbols; SymPy is imported here."""
        from rotsolve.algebra.sympy_bridge import to_sympy

        form = self.answer.formula if self.answer.closed is None else self.answer.closed
        return None if form is None else to_sympy(form, plain=True)

    def subs(self, values: Mapping[Any, Any] | None = None, /, **letters: Any) -> Any:
        """The exact form with SymPy values for letters, by their names: `answer.subs(m=2, M=0)`; all at once, in SI units.

        KeyError for a name that is no letter of the scene, TypeError without an exact form.
        """
        from rotsolve.solution.symbols import substituted

        if self.sympy is None:
            raise TypeError(f"`{self.name}` has no exact form")
        return substituted(self.sympy, self.letters, {**(values or {}), **letters})

    def to(self, format: str = "text") -> str:
        """The answer as a document of one row would print it: 'text', 'markdown', 'latex', 'typst' or 'html'."""
        from rotsolve.page.blocks import Answers, FixedPage
        from rotsolve.page.formats import WIDTH, format_named
        from rotsolve.page.values import answer_rows

        page = FixedPage((Answers(tuple(answer_rows(self.answer, self.digits))),))
        return format_named(format).body(page, WIDTH)

    def __eq__(self, other: object) -> bool:
        return self._said == other._said if isinstance(other, AnswerView) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._said)

    @property
    def _said(self) -> tuple[Any, ...]:
        """All that it says."""
        told = self.answer
        return (
            str(self),
            told.name,
            told.formula,
            told.conditions,
            told.unit,
            tuple(item._said for item in self.otherwise),
        )

    def __deepcopy__(self, _: Any) -> AnswerView:
        return self

    def __format__(self, form: str) -> str:
        return format(float(self), form) if form else str(self)

    def __repr__(self) -> str:
        return f"<AnswerView {self}>"

    def __str__(self) -> str:
        from rotsolve.page.text import answer_text
        from rotsolve.page.values import answer_row

        return answer_text(answer_row(self.answer, self.digits))

    def _repr_html_(self) -> str:
        from rotsolve.page.html_rows import notebook_piece

        return notebook_piece(self.to("html"))

    def _repr_latex_(self) -> str:
        return self.to("latex")
