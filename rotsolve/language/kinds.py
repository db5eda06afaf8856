"""Kinds: the classes of one sort of element, each by its word, and loaded when a scene says that word.

A scene has four kinds of elements and knows of sixty. Loading the other fifty-six took a tenth of a cold run (callgrind, `block-on-disc`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from importlib import import_module
from typing import Any, Generic, TypeVar, overload

from rotsolve.language.keys import Element

Kind = TypeVar("Kind", bound=Element)


class Kinds(Sequence[type[Kind]], Generic[Kind]):
    """The classes of a package or module by their words, in the order told: each row is a word and where its class is.

    A class is found as `module.Class` within a package, or as `Class` in a module. Who iterates loads them all; `words` and `of` load
    nothing that is not asked for. One from elsewhere is added with `append`.
    """

    def __init__(self, package: str, rows: dict[str, str]) -> None:
        self.package = package
        self.places: dict[str, str | type[Kind]] = dict(rows)

    @property
    def words(self) -> tuple[str, ...]:
        """The words of all kinds."""
        return tuple(self.places)

    def of(self, word: str) -> type[Kind] | None:
        """The class that a word names."""
        place = self.places.get(word)
        if isinstance(place, str):
            module, _, name = f"{self.package}.{place}".rpartition(".")
            place = self.places[word] = getattr(import_module(module), name)
        return place

    def append(self, kind: type[Kind]) -> None:
        """Another kind, by its own word."""
        self.places[kind.word] = kind

    def remove(self, kind: type[Kind]) -> None:
        """Take a kind away."""
        del self.places[kind.word]

    def __iter__(self) -> Iterator[type[Kind]]:
        for word in self.words:
            kind = self.of(word)
            assert kind is not None
            yield kind

    def __len__(self) -> int:
        return len(self.places)

    @overload
    def __getitem__(self, index: int) -> type[Kind]: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[type[Kind]]: ...
    def __getitem__(self, index: Any) -> Any:
        return list(self)[index]
