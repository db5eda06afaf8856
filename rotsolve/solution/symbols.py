"""Symbols: the letters of a scene as SymPy has them, for `subs`, `limit`, `solve`. SymPy is imported when one is asked for."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Any

from rotsolve.language.words import hint


class Symbols(Mapping[str, Any]):
    """SymPy's symbols by the names of letters: `symbols["m"]`, or `symbols.m`.

    They are those of `sympy.Symbol("m")`, about which nothing is assumed. `assumed` are others of the same names, real or positive as
    the scene has it: put them in by `answer.subs(symbols.assumed)`.
    """

    def __init__(self, names: Collection[str], positive: Collection[str]) -> None:
        self._names, self._positive = tuple(names), frozenset(positive)

    def __getitem__(self, name: str) -> Any:
        from sympy import Symbol

        if name not in self._names:
            raise KeyError(no_such_letter(name, self._names))
        return Symbol(name)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self._names:
            raise AttributeError(no_such_letter(name, () if name.startswith("_") else self._names))
        return self[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._names]

    @property
    def assumed(self) -> dict[str, Any]:
        """Symbols of the same names that are positive, as masses and lengths are, or else real."""
        from sympy import Symbol

        return {
            name: Symbol(name, positive=True) if name in self._positive else Symbol(name, real=True)
            for name in self._names
        }

    def __repr__(self) -> str:
        return f"<Symbols {', '.join(self._names)}>"


def no_such_letter(name: str, names: Collection[str]) -> str:
    """That there is no letter of a name, with those that there are."""
    return f"no letter `{name}`: {hint(name, tuple(names), 'letters')}"


def substituted(expression: Any, letters: Collection[str], values: Mapping[Any, Any]) -> Any:
    """A SymPy expression with values for letters, by their names; KeyError for what is no letter of the scene."""
    told = {str(letter): value for letter, value in values.items()}
    for name in told:
        if letters and name not in letters:
            raise KeyError(no_such_letter(name, letters))
    pairs = [(symbol, told[symbol.name]) for symbol in expression.free_symbols if symbol.name in told]
    return expression.subs(pairs, simultaneous=True)
