"""Periodic: after how much of a letter a function repeats itself."""

from __future__ import annotations

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import PI, Call, Formula


def period_of(function: Formula, letter: str) -> Formula | None:
    """2π/n of a function in which a letter x stands in sin n x and cos n x only."""
    calls = {node for node in function.walk(Call) if isinstance(node, Call) and letter in node.symbols()}
    outside = function.transform(lambda node: PI if node in calls else node, Call)
    if not calls or letter in outside.symbols() or any(node.function not in ("sin", "cos") for node in calls):
        return None
    slopes = {simplify(differentiate(node.arguments[0], letter)) for node in calls}
    slope = slopes.pop()
    return None if slopes or letter in slope.symbols() else 2 * PI / slope
