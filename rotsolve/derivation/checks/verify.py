"""Checks: all that is held against the answers, the second law first."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.derivation import Check
from rotsolve.core.equation import FAMILIES
from rotsolve.derivation.checks.dimensions import dimensions
from rotsolve.derivation.checks.limits import limits
from rotsolve.derivation.checks.requirements import requirements
from rotsolve.derivation.checks.second_law import second_law
from rotsolve.derivation.checks.verges import nudged
from rotsolve.derivation.compose import Letters
from rotsolve.search.search import Search


def checks(search: Search, letters: Letters) -> tuple[Check, ...]:
    """All checks of a solved search, the second law first."""
    return (
        *alone(search),
        *second_law(search, letters),
        *dimensions(search),
        *limits(search),
        *requirements(search, letters),
        *nudged(search),
    )


def alone(search: Search) -> Iterator[Check]:
    """Which answers took more than the law that was asked for."""
    if search.helped:
        names: list[str | Formula] = []
        for name in search.helped:
            names += [", ", Symbol(name)] if names else [Symbol(name)]
        yield Check(
            (f"{FAMILIES[search.families[0]].words} alone does not give ", *names, ": Newton's laws were used as well")
        )
