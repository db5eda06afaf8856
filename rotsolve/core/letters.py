"""Letters: the order in which a textbook writes letters in a product, by what they measure."""

from __future__ import annotations

from collections.abc import Iterable

from rotsolve.algebra.units.dimension import Dimension, rank_of


def letter_order(letters: Iterable[tuple[str, Dimension | None]]) -> tuple[str, ...]:
    """Names in the order of a printed product; equal ranks keep the order in which they come."""
    ranked = [(rank_of(dimension), index, name) for index, (name, dimension) in enumerate(letters)]
    return tuple(name for _, _, name in sorted(ranked))
