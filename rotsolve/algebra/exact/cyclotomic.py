"""Cyclotomic: whether a number made of sines and cosines of rational parts of a turn is nothing, as sin 20° + sin 140° + sin 260° is.

With ζ = e^(2πi/n) each of them is a sum of two powers, cos (2πk/n) = (ζᵏ + ζ⁻ᵏ)/2 and sin (2πk/n) = cos (2πk/n − π/2), and a polynomial
in ζ over the rationals is nothing where the cyclotomic polynomial Φ_n divides it, which is the least that has this root: for n = 360
it has degree 96. All else in the formula is taken as independent, so that what is found nothing is so.
"""

from __future__ import annotations

from fractions import Fraction
from math import lcm

from rotsolve.algebra.exact import angles
from rotsolve.algebra.exact.field import Poly
from rotsolve.algebra.exact.normal import Fractions
from rotsolve.algebra.flints import fmpz_poly
from rotsolve.algebra.formula import PI, Call, Formula, Symbol, power

ZETA = "#zeta"
ORDER_LIMIT = 7200  # equal parts of a turn, each of 3′: beyond it the polynomials are too long


def turns_of(node: Formula) -> Fraction | None:
    """The part of a turn whose sine or cosine a call is; None of all others."""
    if not isinstance(node, Call) or node.function not in ("sin", "cos"):
        return None
    try:
        terms = angles.linear(node.arguments[0], ())
    except ValueError:  # roots of what is no polynomial: no part of a turn is written so
        return None
    if not terms.keys() <= {PI}:
        return None
    turns = terms.get(PI, Fraction(0)) / 2
    return turns - Fraction(1, 4) if node.function == "sin" else turns


def vanishes_by_turns(f: Formula) -> bool:
    """Whether a formula is nothing by what sines and cosines of parts of a turn have to do with each other."""
    found = {node: turns for node in f.walk(Call) if (turns := turns_of(node)) is not None}
    order = lcm(*(turns.denominator for turns in found.values()))
    if not found or order > ORDER_LIMIT:
        return False

    def by_powers(node: Formula) -> Formula:
        if node not in found:
            return node
        k = int(found[node] * order)
        first, last = (power(Symbol(ZETA), e % order) for e in (k, -k))
        return (first + last) / 2

    problem = Fractions([f.transform(by_powers, "sin", "cos")], extra=(ZETA,))
    above, below = problem.ratio()
    return divided_by_cyclotomic(above, problem, order) and not divided_by_cyclotomic(below, problem, order)


def divided_by_cyclotomic(value: Poly, problem: Fractions, order: int) -> bool:
    """Whether Φ_n divides each coefficient of a polynomial, taken as one in ζ alone."""
    place = problem.field.index[Symbol(ZETA)]
    parts: dict[tuple[int, ...], dict[int, int]] = {}
    for exponents, coefficient in problem.field.terms(problem.field.reduce(value)).items():
        others = (*exponents[:place], *exponents[place + 1 :])
        part, e = parts.setdefault(others, {}), exponents[place] % order
        part[e] = part.get(e, 0) + int(coefficient)
    ring = fmpz_poly
    least = ring.cyclotomic(order)
    return all(not ring([part.get(e, 0) for e in range(order)]) % least for part in parts.values())
