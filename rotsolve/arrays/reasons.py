"""Reasons: why sets have no number, kept as numbers of texts: of a million sets nearly all have the same, and few are ever read."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np


class Reasons(Mapping[str, Any]):
    """By the names of the answers an array of texts, one a set, "" where it has its number; each is made when it is asked for."""

    def __init__(self, shape: tuple[int, ...], names: Iterable[str] = (), first: str = "") -> None:
        self.shape = shape
        self.texts: list[str] = [""]
        self.codes = {name: np.full(shape, self.code(first), dtype=np.int32) for name in names}
        self.made: dict[str, Any] = {}

    def code(self, text: str) -> int:
        """The number of a text."""
        if text not in self.texts:
            self.texts.append(text)
        return self.texts.index(text)

    def tell(self, name: str, rows: Any, text: str) -> None:
        """Some sets have this reason."""
        self.codes[name][rows] = self.code(text)
        self.made.pop(name, None)

    def answered(self, name: str) -> Any:
        """Which sets have their number."""
        return self.codes[name] == 0

    def __getitem__(self, name: str) -> Any:
        if name not in self.made:
            self.made[name] = np.array(self.texts, dtype=object)[self.codes[name]]
        return self.made[name]

    def __contains__(self, name: object) -> bool:
        return name in self.codes

    def __iter__(self) -> Iterator[str]:
        return iter(self.codes)

    def __len__(self) -> int:
        return len(self.codes)
