"""Names: the letters that a student's line may use."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import Struct

from rotsolve.algebra.notation.letters import spellings


class Names(Struct, frozen=True):
    """Letters that the scene declares, by their ASCII names: its givens, and the quantities that it asks for.

    `asked` is the one that the line is to tell: `a = …` may stand in front. Without it a line with `=` is an equation.
    `words` are the answers to a question that asks for a word.
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

    @property
    def letters(self) -> frozenset[str]:
        return self.givens | self.answers

    def is_asked(self, typed: str) -> bool:
        """Whether a spelling means the quantity that is asked for: `ω₀` is omega0."""
        return typed == self.asked or self.asked in spellings(typed)
