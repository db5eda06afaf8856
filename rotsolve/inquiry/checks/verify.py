"""Checks: all that is held against the answers, the second law first."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.derivation import Check
from rotsolve.inquiry.checks.dimensions import dimensions
from rotsolve.inquiry.checks.limits import limits
from rotsolve.inquiry.checks.requirements import requirements
from rotsolve.inquiry.checks.second_law import second_law
from rotsolve.inquiry.checks.verges import nudged
from rotsolve.inquiry.compose import Letters
from rotsolve.inquiry.inquiry import Inquiry
from rotsolve.inquiry.planning import SAID


def checks(inquiry: Inquiry, letters: Letters) -> tuple[Check, ...]:
    """All checks of a solved inquiry, the second law first."""
    return (
        *alone(inquiry),
        *second_law(inquiry, letters),
        *dimensions(inquiry),
        *limits(inquiry),
        *requirements(inquiry, letters),
        *nudged(inquiry),
    )


def alone(inquiry: Inquiry) -> Iterator[Check]:
    """Which answers took more than the law that was asked for."""
    if inquiry.helped:
        names: list[str | Formula] = []
        for name in inquiry.helped:
            names += [", ", Symbol(name)] if names else [Symbol(name)]
        yield Check((f"{SAID[inquiry.families[0]]} alone does not give ", *names, ": Newton's laws were used as well"))
