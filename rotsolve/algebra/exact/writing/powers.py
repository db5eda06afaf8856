"""Powers: a polynomial in one letter, written by its powers: ω₀ + a t − ½ b t²."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import Problem, degree, is_zero, simplify
from rotsolve.algebra.formula import ZERO, Formula, Symbol, total

LONGEST = 12  # powers of a polynomial that is written by them


def in_powers(value: Formula, name: str, *, order: Sequence[str] = (), positive: Collection[str] = ()) -> Formula:
    """The terms c₀ + c₁ x + c₂ x² + … with cₙ = f⁽ⁿ⁾(0)/n!; as it stands where it is no polynomial in the letter."""
    if name not in value.symbols() or degree(value, name) is None or is_below(value, name):
        return value
    terms: list[Formula] = []
    slope, factor = value, 1
    for power in range(LONGEST):
        part = simplify(slope.substitute({name: ZERO}) / factor, order=order, positive=positive)
        terms.append(simplify(part * Symbol(name) ** power, order=order, positive=positive))
        slope, factor = simplify(differentiate(slope, name)), factor * (power + 1)
        if is_zero(slope):
            return total(terms)
    return value


def is_below(value: Formula, name: str) -> bool:
    """Whether a letter stands below the line."""
    problem = Problem([value], extra=(name,))
    _, bottom = problem.field.cancel(problem.ratio())
    return bool(bottom.degrees()[problem.field.index[Symbol(name)]])
