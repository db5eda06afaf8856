"""Validity: for which numbers the closed forms of a solved scene hold: what must not be negative, and what its own numbers have decided."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.writing import spoken
from rotsolve.derivation.requirements import concerns, margin_of, requirements_by_state
from rotsolve.motion.rubs import rubs
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search

SLIPS, ROOT = "what slips and which way", "which root of an equation is meant"


class Validity(Struct, frozen=True):
    """The closed forms hold for `positive` letters that are so, where none of the `bounds` is negative, none of the `sides` on which the
    scene's own numbers lie, and while what else was `decided` by numbers would be decided alike."""

    positive: frozenset[str]
    bounds: tuple[Formula, ...]
    decided: tuple[str, ...]
    sides: tuple[Formula, ...] = ()


def validity(search: Search) -> Validity:
    """What strings, contacts and friction have to obey, as formulas of the givens; what else the numbers of the scene decided."""
    positive = search.solver.positive
    by_letters = SignOracle({}, positive)
    bounds: dict[Formula, None] = {}
    sides: dict[Formula, None] = {}
    decided: dict[str, None] = {}
    for _, needs in requirements_by_state(search):
        for need in needs:
            if concerns(need, search):
                gap = margin_of(need, search, families_for(None))[1]
                if gap is None:
                    decided[f"whether {spoken(need.owner)} holds"] = None
                elif by_letters.by_letters(gap) not in (0, 1):
                    bounds[gap] = None
    if rubs(search.scene.configuration):
        decided[SLIPS] = None
    if any(step.reason for step in search.solver.steps):
        decided[ROOT] = None
    for value, sign in (search.scene.configuration.signs.decided | search.signs.decided).items():
        if by_letters.by_letters(value) is not None:
            continue
        if sign:
            sides[simplify(value * sign, positive=positive)] = None
        else:
            decided[f"that {to_text(value)} vanishes"] = None
    return Validity(positive, tuple(bounds), tuple(decided), tuple(sides))
