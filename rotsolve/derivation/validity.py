"""Validity: for which numbers the closed forms of a solved scene hold: what must not be negative, and what its own numbers have decided."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import PI, Formula, Number, Power, Product, Quotient, Sum, Symbol
from rotsolve.core.writing import spoken
from rotsolve.derivation.requirements import concerns, margin_of, requirements_by_state
from rotsolve.motion.rubs import rubs
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search

SLIPS, ROOT = "what slips and which way", "which root of an equation is meant"


class Validity(Struct, frozen=True):
    """The closed forms hold for `positive` letters that are so, where none of the `bounds` is negative, and while what was `decided` by
    numbers would be decided alike."""

    positive: frozenset[str]
    bounds: tuple[Formula, ...]
    decided: tuple[str, ...]


def validity(search: Search) -> Validity:
    """What strings, contacts and friction have to obey, as formulas of the givens; what else the numbers of the scene decided."""
    positive = search.solver.positive
    aside = Search(search.scene, families_for(None))
    bounds: dict[Formula, None] = {}
    decided: dict[str, None] = {}
    for _, needs in requirements_by_state(search):
        for need in needs:
            if concerns(need, search):
                gap = margin_of(need, search, aside)[1]
                if gap is None:
                    decided[f"whether {spoken(need.owner)} holds"] = None
                elif not (is_zero(gap, positive) or surely_positive(gap, positive)):
                    bounds[gap] = None
    if rubs(search.scene.configuration):
        decided[SLIPS] = None
    if any(step.reason for step in search.solver.steps):
        decided[ROOT] = None
    return Validity(positive, tuple(bounds), tuple(decided))


def surely_positive(value: Formula, positive: frozenset[str]) -> bool:
    """Whether a formula is made of positive letters and numbers by sums, products, quotients and powers alone."""
    match value:
        case Symbol(name):
            return name in positive
        case Number(number):
            return number > 0
        case Sum() | Product() | Quotient():
            return all(surely_positive(part, positive) for part in value.children())
        case Power(base, _):
            return surely_positive(base, positive)
    return value == PI
