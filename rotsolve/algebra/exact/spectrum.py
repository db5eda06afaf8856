"""Spectrum: all roots of a polynomial that has real roots only, in closed form where its factors are of the third degree at most."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from fractions import Fraction

from rotsolve.algebra.exact.normal import concerning, expanded, simplify
from rotsolve.algebra.exact.roots import solve_polynomial
from rotsolve.algebra.formula import PI, Formula, Number, Symbol, call, sqrt

CUBIC = 4  # coefficients of a polynomial of the third degree


def spectrum_roots(
    f: Formula, unknown: str, *, order: Sequence[str] = (), positive: Collection[str] = ()
) -> list[Formula] | None:
    """The roots of f = 0, each as often as it is one; None where a factor is of a higher degree than the third."""
    problem, parts = expanded(f, unknown, *concerning(f, order, positive, unknown))
    if parts is None:
        return None
    place = problem.field.index[Symbol(unknown)]
    _, factors = problem.field.factor(problem.numerator())
    found: list[Formula] = []
    for factor, times in factors:
        powers = problem.field.coefficients(factor, place)
        if len(powers) < 2:
            continue
        if len(powers) > CUBIC:
            return None
        if len(powers) == CUBIC:
            written = [problem.shaper.poly(part) for part in powers]
            roots = [simplify(root, order=order, positive=positive) for root in of_cubic(written)]
        else:
            whole = problem.shaper.poly(factor)
            roots = solve_polynomial(whole, unknown, order=order, positive=positive)
            roots = roots * 2 if len(powers) == 3 and len(roots) == 1 else roots
        found += roots * times
    return found


def of_cubic(powers: Sequence[Formula]) -> Iterator[Formula]:
    """The three real roots of c₀ + c₁ x + c₂ x² + c₃ x³: −c₂/3 c₃ + 2 √(p/3) cos((θ − 2 π k)/3) with x³ = p x + q behind the shift."""
    free, linear, square, cube = powers
    mean = square / (3 * cube)
    p = simplify(3 * mean**2 - linear / cube)
    q = simplify(mean * linear / cube - 2 * mean**3 - free / cube)
    angle = call("acos", simplify(q / 2) / sqrt((p / 3) ** 3))
    for k in range(3):
        turned = angle - Number(Fraction(2 * k)) * PI if k else angle
        yield 2 * sqrt(p / 3) * call("cos", turned / 3) - mean
