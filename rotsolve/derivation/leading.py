"""Leading: what an answer comes to where one of its letters is small beside another: the leading term of its exact form, m = ε M, ε → 0."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from fractions import Fraction
from itertools import permutations
from math import factorial

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Integral, Number, Symbol, sqrt
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.numbers import value_of
from rotsolve.language.problem import SMALL_BESIDE

ORDERS = 7  # of √(m/M) up to which a term is looked for
RATIO = "small ratio"  # the letter δ = √(m/M)
NEAR, ALIKE = (
    1e-10,
    1e-3,
)  # a ratio at which the exact form is seen to be its leading term, and how near to it that has to be
TRIALS = (0.83, 1.37, 0.59, 1.91, 1.13, 0.71, 1.57)


def pairs_of(assumed: Sequence[str]) -> tuple[tuple[str, str], ...]:
    """The letters of `m << M`, the small one first."""
    words = [word.split(f" {SMALL_BESIDE} ") for word in assumed]
    return tuple((word[0], word[1]) for word in words if len(word) == 2)


def leading_order(formula: Formula, pairs: Sequence[tuple[str, str]], positive: Collection[str]) -> Formula | None:
    """The leading term, the same in whatever order the letters are made small; None where none is found."""
    found = {leading_in_turn(formula, order, positive) for order in permutations(pairs)}
    first = next(iter(found))
    if first is None or None in found or any(not is_zero(first - other) for other in found if other is not None):
        return None
    return first


def leading_in_turn(formula: Formula, pairs: Sequence[tuple[str, str]], positive: Collection[str]) -> Formula | None:
    """The leading term as one letter after the other becomes small."""
    for small, large in pairs:
        if small in formula.symbols():
            term = leading_term(formula, small, large, positive)
            if term is None or not comes_near(formula, term, small, large):
                return None
            formula = term
    return formula


def leading_term(formula: Formula, small: str, large: str, positive: Collection[str]) -> Formula | None:
    """The first term in powers of √(m/M) that does not vanish, of what grows without bounds that of its reciprocal."""
    if formula.holds(Integral):
        return None
    above = frozenset((*positive, RATIO, large))
    inside = formula.substitute({small: Symbol(RATIO) ** 2 * Symbol(large)})
    found = first_power(inside, above)
    if found is None and (turned := first_power(ONE / inside, above)) is not None:
        found = turned[0], -turned[1]
        return simplify(sqrt(Symbol(small) / Symbol(large)) ** found[1] / found[0], positive=above)
    if found is None:
        return None
    return simplify(found[0] * sqrt(Symbol(small) / Symbol(large)) ** found[1], positive=above)


def first_power(inside: Formula, positive: Collection[str]) -> tuple[Formula, int] | None:
    """The first coefficient of a Taylor series about 0 that does not vanish, with its order; None of what has no such series."""
    current = inside
    for order in range(ORDERS):
        try:
            current = simplify(current, positive=positive)
            value = simplify(current.substitute({RATIO: ZERO}), positive=positive)
        except (ZeroDivisionError, ValueError):
            return None
        if not is_zero(value):
            return simplify(value / Number(Fraction(factorial(order))), positive=positive), order
        current = differentiate(current, RATIO)
    return None


def comes_near(formula: Formula, term: Formula, small: str, large: str) -> bool:
    """Whether the exact form is the leading term where the ratio is next to nothing, with some numbers for all letters."""
    names = sorted((formula.symbols() | term.symbols()) - {small})
    values: Mapping[str, float] = {name: TRIALS[k % len(TRIALS)] * (1 + k / 31) for k, name in enumerate(names)}
    try:
        numbers = {**values, small: values.get(large, 1.0) * NEAR}
        exact, short = (float(value_of(side, numbers)) for side in (formula, term))
    except (NotConfirmed, ArithmeticError, ValueError):
        return True  # the numbers do not suit the formula
    return abs(exact - short) <= ALIKE * abs(short)
