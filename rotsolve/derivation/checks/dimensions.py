"""Dimensions: both sides of every answer are of the same kind."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import ZERO, Symbol
from rotsolve.algebra.units.dimension import DimensionError, dimension_of
from rotsolve.core.derivation import Check
from rotsolve.core.quantity import DIMENSIONS
from rotsolve.search.search import Search


def dimensions(search: Search) -> Iterator[Check]:
    """Whether every closed form has the dimension of what was asked."""
    known = {given.name: given.dimension for given in search.givens.values() if given.dimension is not None}
    checked = 0
    for answered in search.answered:
        formula, wanted = answered.found.formula, answered.asked.dimension
        if formula is None or wanted is None or formula == ZERO or not formula.symbols() <= set(known) | {"time"}:
            continue
        try:
            if not dimension_of(formula, {**known, "time": DIMENSIONS["time"]}).matches(wanted):
                yield Check(("the dimension of ", Symbol(answered.asked.find.name), " is wrong"), False)
            checked += 1
        except DimensionError as error:
            yield Check((f"the dimensions of an answer do not agree: {error}",), False)
    if checked:
        yield Check(("dimensions agree",))
