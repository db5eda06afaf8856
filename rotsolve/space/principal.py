"""Principal moments and axes: in closed form where one axis shows: one without products of inertia, or (1, 1, 1) of three alike.

det (I − λ 1) = 0. An axis on which no product of inertia stands is a principal one, and leaves a quadratic for the others:
λ = (I_a + I_b)/2 ± √(((I_a − I_b)/2)² + I_ab²).
"""

from __future__ import annotations

from collections.abc import Callable

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, add, negate, sqrt
from rotsolve.core.facts import square
from rotsolve.core.vectors.tensor import InertiaTensor
from rotsolve.core.vectors.triple import Triple, X, Y, Z, scaled_by, tidied, vector_sum
from rotsolve.language.problem import Path
from rotsolve.paths.meaning import NotYet, path_text

Spelled = Callable[[Formula], Formula]
Nothing = Callable[[Formula], bool]  # whether a formula is nothing, by its letters or their numbers
Side = Callable[[Formula], "int | None"]
Found = tuple[Formula, Triple | None]  # a principal moment, with its axis where that is told
BESIDE = {"x": ("yy", "zz", "yz"), "y": ("zz", "xx", "zx"), "z": ("xx", "yy", "xy")}
WAYS = {"x": X, "y": Y, "z": Z}
PRODUCTS = {"x": ("xy", "zx"), "y": ("xy", "yz"), "z": ("zx", "yz")}


def principal(tensor: InertiaTensor, spelled: Spelled, path: Path, vanishes: Nothing) -> list[Found]:
    """The three moments with their axes, of a tensor whose letters are spelled out to see what vanishes or is alike."""

    def nothing(value: Formula) -> bool:
        return value == ZERO or vanishes(spelled(value))

    free = [axis for axis in "xyz" if all(nothing(tensor.entry(word)) for word in PRODUCTS[axis])]
    if len(free) == 3:
        return [(tensor.entry(axis * 2), WAYS[axis]) for axis in "xyz"]
    if free:
        return [(tensor.entry(free[0] * 2), WAYS[free[0]]), *in_plane(tensor, free[0], spelled)]
    alike = [tensor.xx - tensor.yy, tensor.yy - tensor.zz, tensor.xy - tensor.yz, tensor.yz - tensor.zx]
    if all(map(nothing, alike)):
        third = ONE / sqrt(3 * ONE)
        lone = simplify(add(tensor.xx, 2 * tensor.xy))
        other = simplify(add(tensor.xx, negate(tensor.xy)))
        return [(lone, (third, third, third)), (other, None), (other, None)]
    raise NotYet(
        f"`{path_text(path)}` has no closed form that shows: no axis of the body is a principal one",
        path.span,
        "ask for `inertia_tensor`; principal moments by a cubic are not solved yet",
    )


def in_plane(tensor: InertiaTensor, axis: str, spelled: Spelled) -> list[Found]:
    """The two moments across a principal axis, the smaller one first; the axis of λ is along (I_ab, λ − I_a) in that plane."""
    one, other, product = (tensor.entry(word) for word in BESIDE[axis])
    middle, half = spelled((one + other) / 2), spelled((one - other) / 2)
    root = spelled(sqrt(add(square(half), square(spelled(product)))))
    found: list[Found] = []
    for moment in (spelled(middle - root), spelled(middle + root)):
        a, b = spelled(product), spelled(moment - one)
        whole = spelled(sqrt(add(square(a), square(b))))
        a, b = spelled(a / whole), spelled(b / whole)
        first, second = (WAYS[word[0]] for word in BESIDE[axis][:2])
        found.append((moment, tidied(vector_sum(scaled_by(a, first), scaled_by(b, second)))))
    return found


def principal_moment(
    tensor: InertiaTensor, spelled: Spelled, number: str, path: Path, vanishes: Nothing, side: Side
) -> Formula:
    """The first, second or third of them, from the smallest on; `side` tells the sign of a difference."""
    found = principal(tensor, spelled, path, vanishes)
    moments = [moment for moment, _ in found]
    ordered: list[int] = []
    for one in range(len(moments)):
        place = 0
        while place < len(ordered):
            sign = told_by_kind(found, one, ordered[place], spelled)
            sign = side(spelled(moments[one] - moments[ordered[place]])) if sign is None else sign
            if sign is None:
                help = "give numbers to the letters, or ask for `inertia_tensor`"
                raise NotYet(
                    f"`{path_text(path)}`: which principal moment is smaller hangs on the letters", path.span, help
                )
            if sign < 0:
                break
            place += 1
        ordered.insert(place, one)
    return moments[ordered[int(number) - 1]]


def told_by_kind(found: list[Found], one: int, other: int, spelled: Spelled) -> int | None:
    """Which of two moments is larger whatever the letters are: the second by a root of two, and the sum of both others, as of a lamina."""
    third = 3 - one - other
    moments = [moment for moment, _ in found]
    if third == 0 and found[2][1] is not None and found[2][1] not in WAYS.values():
        return 1 if one == 2 else -1
    for larger, smaller, sign in ((one, other, 1), (other, one, -1)):
        if is_zero(spelled(moments[larger] - moments[smaller] - moments[third])):
            return sign
    return None


def lone_axis(tensor: InertiaTensor, spelled: Spelled, path: Path, vanishes: Nothing) -> Triple:
    """The axis of the one moment that no other equals."""

    def nothing(value: Formula) -> bool:
        return vanishes(spelled(value))

    found = principal(tensor, spelled, path, vanishes)
    for number, (moment, way) in enumerate(found):
        others = [item for place, (item, _) in enumerate(found) if place != number]
        alone = way is not None and not any(nothing(moment - other) for other in others)
        if way is not None and alone and nothing(others[0] - others[1]):
            return way
    raise NotYet(f"`{path_text(path)}`: no principal moment stands alone beside two that are equal", path.span)
