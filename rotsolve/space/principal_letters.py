"""Principal moments and axes by letters that are worked out one by one, where no closed form is as short as a line.

Across an axis on which no product of inertia stands, by Mohr's circle: λ = I_m ± R with I_m = (I_a + I_b)/2 and
R = √(((I_a − I_b)/2)² + I_ab²), the axis of the larger one at α from a, tan 2α = 2 I_ab/(I_a − I_b).

Else by the cubic det(I − λ 1) = 0, whose three roots are real, since I is symmetric: with m = (trace I)/3, p² = Σ (I − m 1)ᵢⱼ²/6 and
q = det(I − m 1)/2 they are m + 2 p cos(φ + 120°), m + 2 p cos(φ − 120°) and m + 2 p cos φ, from the smallest on, φ = ⅓ arccos(q/p³) from
0 to 60° (O. K. Smith, Communications of the ACM 4 (1961), 168). The axis of λ is square to two rows of I − λ 1.
"""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import combinations

from rotsolve.algebra.formula import PI, ZERO, Call, Formula, Number, add, multiply, negate, sqrt
from rotsolve.algebra.units.dimension import ANGLE
from rotsolve.algebra.units.dimension import INERTIA as KG_M2
from rotsolve.core.facts import square
from rotsolve.core.vectors.triple import Triple, cross_product, length_of, scaled_by, triple, vector_sum
from rotsolve.language.problem import Path
from rotsolve.paths.meaning import NotYet
from rotsolve.space.principal import BESIDE, ROWS, WAYS, Found, ToldTensor, less_moment

ALIKE = 1e-12
PRINCIPAL = "principal moment of inertia, a root λ of det(I − λ 1) = 0"
MEAN_ACROSS = "mean of both principal moments across {axis}"
RADIUS_ACROSS = "half of what both principal moments across {axis} differ by"
ANGLE_ACROSS = "angle from {axis} to the axis of the larger one, tan 2α = 2 {product}/({one} − {other})"
MEAN = "mean of the principal moments, (trace I)/3"
SPREAD = "spread of the principal moments, by the squares of all entries of I less their mean"
ANGLE_OF_ROOTS = "angle of the cubic for the principal moments, by the determinant of that"
SQUARE_TO_ROWS = "along a principal axis, square to two rows of I − λ 1"
Letters = tuple[Formula, Formula, Formula]


# across an axis on which no product of inertia stands


def circle_in_plane(told: ToldTensor, axis: str) -> tuple[Formula, Formula]:
    """I_m − R and I_m + R."""
    one, other, product = (told.tensor.entry(word) for word in BESIDE[axis])
    mean = told.part(MEAN_ACROSS.format(axis=axis), "I", "m", (one + other) / 2, KG_M2)
    radius = sqrt(add(square((one - other) / 2), square(product)))
    half = told.part(RADIUS_ACROSS.format(axis=axis), "R", "", radius, KG_M2)
    return add(mean, negate(half)), add(mean, half)


def angle_in_plane(told: ToldTensor, axis: str) -> tuple[Triple, Triple]:
    """(−sin α, cos α) of the smaller moment and (cos α, sin α) of the larger one."""
    one, other, product = (told.tensor.entry(word) for word in BESIDE[axis])
    first, second = (word[0] for word in BESIDE[axis][:2])
    names = {"axis": first, "one": f"I_{first}", "other": f"I_{second}", "product": f"I_{first}{second}"}
    value = Call("atan2", (2 * product, one - other)) / 2
    angle = told.part(ANGLE_ACROSS.format(**names), "alpha", "", value, ANGLE)
    along, beside = Call("cos", (angle,)), Call("sin", (angle,))
    a, b = WAYS[first], WAYS[second]
    larger = vector_sum(scaled_by(along, a), scaled_by(beside, b))
    return vector_sum(scaled_by(negate(beside), a), scaled_by(along, b)), larger


# where no axis shows


def by_cubic(told: ToldTensor, path: Path) -> list[Found]:
    """The three moments from the smallest on, by letters for m, p and φ; refused where two are equal by numbers."""
    if nearly_alike(told):
        message = f"two principal moments of `{path.owner}` are equal, and no axis shows by its letters"
        raise NotYet(message, path.span, "ask for `inertia_tensor`, or draw it along its axes")
    mean, spread, angle = parts_of_cubic(told)
    found: list[Found] = []
    for number, third in enumerate((1, -1, 0), 1):
        turn = multiply(Number(Fraction(third * 2, 3)), PI)
        root = add(mean, 2 * spread * Call("cos", (add(angle, turn),)))
        found.append((told.part(PRINCIPAL, "lambda", str(number), root, KG_M2), None))
    return found


def nearly_alike(told: ToldTensor) -> bool:
    """Whether numbers do not tell two principal moments apart: |cos 3φ| is 1 then, which no ball around it shows."""
    found = [told.number(told.tensor.entry(word)) for word in ("xx", "yy", "zz", "xy", "yz", "zx")]
    x, y, z, xy, yz, zx = (math.nan if number is None else number.float for number in found)
    mean = (x + y + z) / 3
    x, y, z = x - mean, y - mean, z - mean
    spread = math.sqrt((x * x + y * y + z * z + 2 * (xy * xy + yz * yz + zx * zx)) / 6)
    determinant = x * y * z + 2 * xy * yz * zx - x * yz * yz - y * zx * zx - z * xy * xy
    return spread < ALIKE * mean or abs(determinant) > 2 * (1 - ALIKE) * spread**3


def parts_of_cubic(told: ToldTensor) -> Letters:
    """Letters for m, p and φ."""
    tensor = told.tensor
    mean = told.part(MEAN, "I", "m", (tensor.xx + tensor.yy + tensor.zz) / 3, KG_M2)
    x, y, z = (add(own, negate(mean)) for own in (tensor.xx, tensor.yy, tensor.zz))
    beside = add(tensor.xy**2, add(tensor.yz**2, tensor.zx**2))
    spread = told.part(SPREAD, "p", "", sqrt((x**2 + y**2 + z**2 + 2 * beside) / 6), KG_M2)
    products = x * tensor.yz**2 + y * tensor.zx**2 + z * tensor.xy**2
    determinant = x * y * z + 2 * tensor.xy * tensor.yz * tensor.zx - products
    angle = told.part(ANGLE_OF_ROOTS, "phi", "", Call("acos", (determinant / (2 * spread**3),)) / 3, ANGLE)
    return mean, spread, angle


def square_to_rows(told: ToldTensor, moment: Formula, number: int) -> Triple:
    """The axis of a moment that is alone, square to those two rows of I − λ 1 that are farthest from one line."""
    rows = [triple([told.tensor.entry(word) for word in words]) for words in ROWS]
    pairs = list(combinations(less_moment(rows, moment, lambda part: part), 2))
    one, other = max(pairs, key=lambda pair: in_numbers(told, pair))
    normal = [
        part if part == ZERO else told.part(SQUARE_TO_ROWS, "n", f"{axis}{number}", part, KG_M2**2)
        for axis, part in zip("xyz", cross_product(one, other), strict=True)
    ]
    size = length_of(triple(normal))
    return triple([part / size for part in normal])


def in_numbers(told: ToldTensor, pair: tuple[Triple, Triple]) -> float:
    """How long the vector product of two rows is; 0 where their letters have no numbers."""
    parts = [told.number(part) for part in cross_product(*pair)]
    return math.hypot(*(0.0 if part is None else part.float for part in parts))
