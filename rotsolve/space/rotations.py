"""Rotations: the axis of the one rotation that several come to (Euler's theorem): n ∝ (R₃₂ − R₂₃, R₁₃ − R₃₁, R₂₁ − R₁₂).

Goldstein, Poole & Safko, Classical Mechanics, §4.6.
"""

from __future__ import annotations

from collections.abc import Callable

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import Formula, add, negate
from rotsolve.core.vectors.triple import Rows, Triple, unit_along
from rotsolve.language.problem import Path
from rotsolve.paths.meaning import NotYet, path_text


def axis_of(rows: Rows, path: Path, vanishes: Callable[[Formula], bool]) -> Triple:
    """The unit vector about which R turns counterclockwise, by less than half a turn."""
    parts = tuple(simplify(add(rows[i][j], negate(rows[j][i]))) for i, j in ((2, 1), (0, 2), (1, 0)))
    x, y, z = parts
    if all(map(vanishes, parts)):
        raise NotYet(f"`{path_text(path)}`: a whole turn, or half a turn, has no one axis that this tells")
    found = unit_along((x, y, z))
    return (simplify(found[0]), simplify(found[1]), simplify(found[2]))
