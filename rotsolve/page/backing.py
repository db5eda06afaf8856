"""Backing: from an answer back by the steps of its section to the laws on which it rests."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property

from msgspec import Struct

from rotsolve.algebra.formula import Formula
from rotsolve.core.derivation import LawLine, Move, Section


class Backing(Struct, frozen=True, dict=True):
    """The steps of one section; `counts` says which of its laws are looked for."""

    section: Section
    counts: Callable[[LawLine], bool]

    @cached_property
    def laws(self) -> dict[str, LawLine]:
        """The laws by their marks: "(3)"."""
        return {f"({law.number})": law for law in self.section.laws}

    @cached_property
    def moves(self) -> dict[str, Move]:
        """The numbered steps by their marks."""
        return {f"({move.number})": move for move in self.section.moves if move.number is not None}

    def rests(self, letter: Formula) -> bool:
        """Whether a letter rests on one of the laws that count, as the steps of this section go."""
        seen: set[str] = set()
        return any(self._marked(mark, seen) for mark in self._marks_of(letter, frozenset()))

    def _marks_of(self, letter: Formula, before: frozenset[Formula]) -> Iterator[str]:
        """The marks of what tells a letter: laws with it alone on the left, and what the steps to it are made of."""
        if letter in before:
            return
        yield from (mark for mark, law in self.laws.items() if law.equation.left == letter)
        for move in self.section.moves:
            if any(line.left == letter for line in move.chain[-1:]):
                yield from self._sources_of(move, before | {letter})

    def _sources_of(self, move: Move, before: frozenset[Formula] = frozenset()) -> Iterator[str]:
        """The marks of all that a step is made of."""
        if move.into:
            yield move.into
        for cited in move.put:
            if cited.mark:
                yield cited.mark
            elif cited.letter is not None:
                yield from self._marks_of(cited.letter, before)

    def _marked(self, mark: str, seen: set[str]) -> bool:
        """Whether what stands under a mark rests on a law that counts."""
        if mark in seen:
            return False
        seen.add(mark)
        if mark in self.laws:
            return self.counts(self.laws[mark])
        move = self.moves.get(mark)
        return move is not None and any(self._marked(one, seen) for one in self._sources_of(move))
