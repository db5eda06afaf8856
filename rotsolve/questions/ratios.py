"""Ratios: what a question that divides one thing by another is called, where its parts tell."""

from __future__ import annotations

from collections.abc import Mapping

from rotsolve.algebra.formula import PI, Formula, Quotient, Symbol
from rotsolve.algebra.units.dimension import ANGULAR_VELOCITY, NONE, Dimension, DimensionError, dimension_of
from rotsolve.core.writing import spoken
from rotsolve.language.problem import Find

FRICTION = "friction over normal force"  # the least coefficient that keeps it from slipping
ENERGIES = ("kinetic_energy", "potential_energy", "energy")


def label_of(find: Find, dimensions: Mapping[str, Dimension]) -> str:
    """What a `find` line that is a quotient is called, by the `dimensions` of its letters; nothing where its parts do not tell."""
    formula = find.formula
    if not isinstance(formula, Quotient):
        return ""
    top, bottom = formula.numerator, formula.denominator
    paths = {f"#{index}": term.path for index, term in enumerate(find.terms)}
    upper, lower = (paths.get(side.name) if isinstance(side, Symbol) else None for side in (top, bottom))
    sides = [(path.quantity, path.owner) for path in (upper, lower) if path is not None]
    if [quantity for quantity, _ in sides] == ["friction_force", "normal_force"] and sides[0][1] == sides[1][1]:
        return FRICTION
    above, below = dimension_in(top, dimensions), dimension_in(bottom, dimensions)
    if top == 2 * PI and below == ANGULAR_VELOCITY:
        return "period, the time of one turn"
    if above is None or above != below or above == NONE:
        return ""
    return f"share of the {spoken(lower.quantity)}" if lower is not None and lower.quantity in ENERGIES else "ratio"


def dimension_in(formula: Formula, dimensions: Mapping[str, Dimension]) -> Dimension | None:
    """The dimension of a part of a question, where it is known."""
    try:
        return dimension_of(formula, dimensions)
    except (DimensionError, KeyError, ValueError):
        return None
