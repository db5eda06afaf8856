"""Limits: what becomes of an answer when a mass is left out, as a reader can check."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.exact.writing.length import length
from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.core.derivation import Check, Words
from rotsolve.core.quantity import DIMENSIONS
from rotsolve.search.search import Search

SHORT = 3  # a limit is told when its value is no longer than this many nodes


def limits(search: Search) -> Iterator[Check]:
    """What becomes of an answer when a mass is left out or an angle is square: the most telling one."""
    best: tuple[int, Words] | None = None
    for answered in search.wholes()[:2]:
        formula = answered.found.formula
        if answered.asked.find.runs or formula is None or formula.symbols() == frozenset():
            continue
        for given in search.givens.values():
            if given.name not in formula.symbols() or given.dimension != DIMENSIONS["mass"]:
                continue
            value = limit(formula, given.name, search)
            if value is None or length(value) > SHORT or value == formula or length(formula) < 6:
                continue
            words: Words = (Symbol(given.name), " → 0 gives ", Symbol(answered.asked.find.name), " = ", value)
            if value != ZERO and (best is None or length(value) < best[0]):
                best = (length(value), words)
    if best is not None:
        yield Check(best[1])


def limit(formula: Formula, name: str, search: Search) -> Formula | None:
    """The formula with a letter set to zero, None where it has no value there."""
    try:
        return search.solver.simplify(formula.substitute({name: ZERO}))
    except (ZeroDivisionError, ValueError):
        return None
