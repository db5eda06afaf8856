"""Certified signs: of a formula by its number, else from what is known of its letters."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import Problem, simplify
from rotsolve.algebra.exact.signs import Signs
from rotsolve.algebra.formula import ZERO, Formula


def sign_of(value: Formula, values: Mapping[str, Formula], positive: Collection[str]) -> int | None:
    """−1, 0 or 1; None where neither the number nor the letters that are positive tell."""
    value = simplify(value, positive=positive)
    if value == ZERO:
        return 0
    if not value.symbols() - set(values):
        try:
            return evaluate(value, values, digits=6).sign
        except (Undefined, ValueError):
            return None
    problem = Problem([value], positive=positive)
    top, bottom = problem.field.cancel(problem.ratio())
    signs = Signs(problem.field, positive)
    found = [1 if signs.nonnegative(part) else -1 if signs.nonnegative(-part) else 0 for part in (top, bottom)]
    return found[0] * found[1] or None
