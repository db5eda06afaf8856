"""Principal moments by the cubic det(I − λ 1) = 0, where no axis shows: its three roots are real, since I is symmetric.

With m = (trace I)/3, p² = Σ (I − m 1)ᵢⱼ²/6 and q = det(I − m 1)/2 they are m + 2 p cos(φ + 120°), m + 2 p cos(φ − 120°) and
m + 2 p cos φ, from the smallest on, φ = ⅓ arccos(q/p³) from 0 to 60° (O. K. Smith, Communications of the ACM 4 (1961), 168).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction

from rotsolve.algebra.formula import PI, Call, Formula, Number, add, multiply, negate, sqrt
from rotsolve.algebra.units.dimension import ANGLE, Dimension
from rotsolve.algebra.units.dimension import INERTIA as KG_M2
from rotsolve.core.vectors.tensor import InertiaTensor

Letter = Callable[[str, str, Formula, Dimension], Formula]  # of a word and a letter for a value
ALIKE = 1e-12
MEAN = "mean of the principal moments, (trace I)/3"
SPREAD = "spread of the principal moments, by the squares of all entries of I less their mean"
ANGLE_OF_ROOTS = "angle of the cubic for the principal moments, by the determinant of that"


def nearly_alike(tensor: InertiaTensor, number: Callable[[Formula], float | None]) -> bool:
    """Whether numbers do not tell two principal moments apart: |cos 3φ| is 1 then, which no ball around it shows."""
    found = [number(tensor.entry(word)) for word in ("xx", "yy", "zz", "xy", "yz", "zx")]
    if any(value is None for value in found):
        return False
    x, y, z, xy, yz, zx = (value or 0.0 for value in found)
    mean = (x + y + z) / 3
    x, y, z = x - mean, y - mean, z - mean
    spread = math.sqrt((x * x + y * y + z * z + 2 * (xy * xy + yz * yz + zx * zx)) / 6)
    determinant = x * y * z + 2 * xy * yz * zx - x * yz * yz - y * zx * zx - z * xy * xy
    return spread < ALIKE * mean or abs(determinant) > 2 * (1 - ALIKE) * spread**3


def principal_by_cubic(tensor: InertiaTensor, number: int, letter: Letter) -> Formula:
    """The first, second or third principal moment, from the smallest on, by letters for m, p and φ."""
    mean = letter(MEAN, "I_m", (tensor.xx + tensor.yy + tensor.zz) / 3, KG_M2)
    x, y, z = (add(own, negate(mean)) for own in (tensor.xx, tensor.yy, tensor.zz))
    beside = add(tensor.xy**2, add(tensor.yz**2, tensor.zx**2))
    spread = letter(SPREAD, "p", sqrt((x**2 + y**2 + z**2 + 2 * beside) / 6), KG_M2)
    products = x * tensor.yz**2 + y * tensor.zx**2 + z * tensor.xy**2
    determinant = x * y * z + 2 * tensor.xy * tensor.yz * tensor.zx - products
    angle = letter(ANGLE_OF_ROOTS, "phi", Call("acos", (determinant / (2 * spread**3),)) / 3, ANGLE)
    turn = multiply(Number(Fraction((1, -1, 0)[number - 1] * 2, 3)), PI)
    return add(mean, 2 * spread * Call("cos", (add(angle, turn),)))
