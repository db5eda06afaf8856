"""Names: the letters that a student's line may use."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.letters import spellings
from rotsolve.core.registry import TIME

SHORT_TIME = "t"


class Names(Struct, frozen=True, dict=True):
    """Letters that the scene declares, by their ASCII names: its givens, and the quantities that it asks for.

    `asked` is the one that the line is to tell: `a = …` may stand in front. Without it a line with `=` is an equation.
    `words` are the answers to a question that asks for a word. Where the time is among the letters, t means it unless t is declared.
    """

    givens: frozenset[str]
    answers: frozenset[str] = frozenset()
    asked: str = ""
    words: tuple[str, ...] = ()

    @classmethod
    def of(
        cls, givens: Iterable[str], answers: Iterable[str] = (), asked: str = "", words: Iterable[str] = ()
    ) -> Names:
        return cls(frozenset(givens), frozenset(answers), asked, tuple(words))

    @cached_property
    def letters(self) -> frozenset[str]:
        """All names that may be typed."""
        names = self.givens | self.answers
        return names | {SHORT_TIME} if TIME in names else names

    def meant(self, formula: Formula) -> Formula:
        """The formula with the time by its name in the scene."""
        if TIME not in self.letters or SHORT_TIME in self.givens or SHORT_TIME in self.answers:
            return formula
        return formula.substitute({SHORT_TIME: Symbol(TIME)})

    def is_asked(self, typed: str) -> bool:
        """Whether a spelling means the quantity that is asked for: `ω₀` is omega0."""
        if typed == self.asked or self.asked in spellings(typed):
            return True
        return typed not in self.letters and alike(typed, self.asked)


def alike(typed: str, name: str) -> bool:
    """Whether a spelling differs from a name in underlines or capitals alone, `Fx` for F_x, or is w for ω."""
    if typed[:1] == "w" and name == f"omega{typed[1:]}":
        return True
    return len(typed) > 1 and typed.replace("_", "").casefold() == name.replace("_", "").casefold()
