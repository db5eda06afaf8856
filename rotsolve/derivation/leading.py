"""Leading: what an answer comes to where one of its letters is small beside another: the leading term of its exact form, m = ε M, ε → 0."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from fractions import Fraction
from itertools import permutations
from math import factorial

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.ball import Certified
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Integral, Number, Symbol, sqrt
from rotsolve.algebra.units.dimension import NONE
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.numbers import value_of
from rotsolve.core.derivation import Words
from rotsolve.language.problem import SMALL_BESIDE
from rotsolve.search.search import Search

ORDERS = 7  # of √(m/M) up to which a term is looked for
RATIO = "small ratio"  # the letter δ = √(m/M)
NEAR = 1e-10  # a ratio at which the exact form is seen to be its leading term,
ALIKE = 1e-3  # and how near to it that has to be
FAR_OFF = 0.5  # of the exact value, by which a leading term that is told may be off
DIGITS = 4
TRIALS = (0.83, 1.37, 0.59, 1.91, 1.13, 0.71, 1.57)


def leading_words(
    formula: Formula, unit: Unit | None, search: Search, value: Callable[[Formula], Certified | None]
) -> Words:
    """ "≈ 2 m g/M = 0.0392 m/s² for m ≪ M", of what the scene assumes to be small; `value` is a number in the unit of the answer."""
    pairs = [pair for pair in pairs_of(search.scene.configuration.problem.assume) if pair[0] in formula.symbols()]
    if not pairs:
        return ()
    said: list[str | Formula] = []
    for small, large in pairs:
        said += [" and " if said else "", Symbol(small), " ≪ ", Symbol(large)]
    told = {name: value for name, value in search.signs.values.items() if name in formula.symbols()}
    form, term = formula, leading_order(formula, pairs, search.signs.positive)
    if term is not None and is_zero(term.substitute(told)):  # 1 − e of an elastic blow: the next term tells
        plain = {given.name for given in search.givens.values() if given.dimension == NONE}
        form = formula.substitute({name: value for name, value in told.items() if name in plain})
        term = leading_order(form, pairs, search.signs.positive)
    if term is None:
        return ("no leading term is found for ", *said)
    if is_zero(term - form):
        return ()
    number, exact = value(term), value(formula)
    far = number is not None and exact is not None and abs(number.float - exact.float) > FAR_OFF * abs(exact.float)
    if far or is_zero(term.substitute(told)):
        return ("no leading term in letters holds with these numbers for ", *said)
    worth: Words = ()
    if number is not None and not isinstance(term, Number):
        worth = (f" = {(unit.after if unit is not None else str)(number.text(DIGITS))}",)
    return ("≈ ", search.solver.simplify(term), *worth, " for ", *said)


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
