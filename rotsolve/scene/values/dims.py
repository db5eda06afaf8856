"""Dimensions in messages, and the dimension of an unknown letter from where it is used."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from rotsolve.algebra.formula import Formula, Negative, Sum, Symbol
from rotsolve.algebra.units.dimension import MASS, NONE, Dimension, DimensionError, describe, dimension_of


def an(word: str) -> str:
    """The word with its article."""
    return f"{'an' if word[:1] in 'aeiou' else 'a'} {word}"


def named(dimension: Dimension) -> str:
    """The dimension in words, with article and unit: `a force (N)`."""
    return describe(dimension, article=True)


def fits(found: Dimension, wanted: Dimension) -> bool:
    return found.matches(wanted)


def infer(
    formula: Formula, missing: list[str], known: Mapping[str, Dimension | None], wanted: Dimension | None
) -> Dimension | None:
    """The dimension of the one unknown letter of a formula whose dimension is wanted; None where it can't be told.

    The letter is tried as a pure number and as a mass: in a product of powers, the difference is its exponent.
    """
    if len(missing) != 1 or wanted is None:
        return None
    if formula == Symbol(missing[0]):
        return wanted
    if isinstance(formula, Negative):
        return infer(formula.operand, missing, known, wanted)
    if isinstance(formula, Sum):  # every term has the dimension of the whole
        holders = [term for term in formula.terms if missing[0] in term.symbols()]
        return infer(holders[0], missing, known, wanted) if len(holders) == 1 else None
    others = {name: found for name in formula.symbols() if (found := known.get(name)) is not None}
    try:
        plain = dimension_of(formula, {**others, missing[0]: NONE})
        probe = dimension_of(formula, {**others, missing[0]: MASS})
    except DimensionError:
        return None
    exponent = probe.mass - plain.mass
    return None if exponent == 0 else (wanted / plain) ** (1 / Fraction(exponent))
