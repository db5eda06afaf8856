"""Principal moments and axes: in closed form where one axis shows: one without products of inertia, (1, 1, 1) of three alike, or any of
which the moment is a root without roots of det (I − λ 1) = 0, as symmetry makes one.

An axis on which no product of inertia stands is a principal one, and leaves a quadratic for the others:
λ = (I_a + I_b)/2 ± √(((I_a − I_b)/2)² + I_ab²). Else the cubic is taken into factors; where it has none, see `principal_cubic`.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.exact.normal import Fractions, coefficients, degree, is_zero, simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ONE, ZERO, Formula, Symbol, add, negate, sqrt
from rotsolve.core.facts import square
from rotsolve.core.vectors.tensor import InertiaTensor
from rotsolve.core.vectors.triple import (
    Triple,
    X,
    Y,
    Z,
    cross_product,
    dot_product,
    length_of,
    scaled_by,
    tidied,
    triple,
    vector_sum,
)
from rotsolve.language.problem import Path
from rotsolve.paths.meaning import NotYet, path_text

Spelled = Callable[[Formula], Formula]
Nothing = Callable[[Formula], bool]  # whether a formula is nothing, by its letters or their numbers
Side = Callable[[Formula], "int | None"]
Found = tuple[Formula, Triple | None]  # a principal moment, with its axis where that is told
BESIDE = {"x": ("yy", "zz", "yz"), "y": ("zz", "xx", "zx"), "z": ("xx", "yy", "xy")}
WAYS = {"x": X, "y": Y, "z": Z}
ROWS = (("xx", "xy", "zx"), ("xy", "yy", "yz"), ("zx", "yz", "zz"))
MOMENT = "#moment"  # λ, as no scene calls it
FACTORED = (
    300  # nodes of a tensor, whose cubic is taken into factors: beyond it takes seconds, and longer ones have had none
)
IN_PLANE = 100  # nodes of the three entries in a plane that are spelled out under a root
PRODUCTS = {"x": ("xy", "zx"), "y": ("xy", "yz"), "z": ("zx", "yz")}


def principal(tensor: InertiaTensor, spelled: Spelled, vanishes: Nothing) -> list[Found]:
    """The three moments with their axes, of a tensor whose letters are spelled out to see what vanishes or is alike; none where no axis
    shows."""
    free = bare_axes(tensor, spelled, vanishes)
    if len(free) == 3:
        return [(tensor.entry(axis * 2), WAYS[axis]) for axis in "xyz"]
    if free:
        return [(tensor.entry(free[0] * 2), WAYS[free[0]]), *in_plane(tensor, free[0], spelled)]
    if all_alike(tensor, spelled, vanishes):
        third = ONE / sqrt(3 * ONE)
        lone = simplify(add(tensor.xx, 2 * tensor.xy))
        other = simplify(add(tensor.xx, negate(tensor.xy)))
        return [(lone, (third, third, third)), (other, None), (other, None)]
    return by_factors(tensor, spelled)


def bare_axes(tensor: InertiaTensor, spelled: Spelled, vanishes: Nothing) -> list[str]:
    """The axes on which no product of inertia stands."""

    def none(word: str) -> bool:
        entry = tensor.entry(word)
        return entry == ZERO or vanishes(spelled(entry))

    return [axis for axis in "xyz" if all(map(none, PRODUCTS[axis]))]


def all_alike(tensor: InertiaTensor, spelled: Spelled, vanishes: Nothing) -> bool:
    """Whether all three moments are the same, and all three products."""
    gaps = (tensor.xx - tensor.yy, tensor.yy - tensor.zz, tensor.xy - tensor.yz, tensor.yz - tensor.zx)
    return all(gap == ZERO or vanishes(spelled(gap)) for gap in gaps)


def in_plane(tensor: InertiaTensor, axis: str, spelled: Spelled) -> list[Found]:
    """The two moments across a principal axis, the smaller one first; the axis of λ is along (I_ab, λ − I_a) in that plane."""
    one, other, product = (tensor.entry(word) for word in BESIDE[axis])
    if sum(length(spelled(part)) for part in (one, other, product)) > IN_PLANE:
        spelled = itself  # what the entries stand for would fill pages
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


def itself(value: Formula) -> Formula:
    """A formula in the letters of the moments and products of inertia."""
    return value


def by_factors(tensor: InertiaTensor, spelled: Spelled) -> list[Found]:
    """The three moments by the factors of det (I − λ 1), a linear one first, with its axis where it is alone; none where there is none."""
    rows = [triple([spelled(tensor.entry(word)) for word in words]) for words in ROWS]
    found: list[Found] = []
    for part, e in cubic_factors(rows):
        roots = rising_roots(part, spelled)
        alone = e == 1 and (len(roots) == 2 or not found)
        found += [(root, lone_way(rows, root, spelled) if alone else None) for root in roots] * e
    return found if len(found) == 3 else []


def cubic_factors(rows: list[Triple]) -> list[tuple[Formula, int]]:
    """The factors of det (I − λ 1) with how often each stands, those of the lowest degree first; none of a long tensor."""
    if sum(length(part) for row in rows for part in row) > FACTORED:
        return []
    moment = Symbol(MOMENT)
    shifted = [triple([part - moment if i == j else part for j, part in enumerate(row)]) for i, row in enumerate(rows)]
    problem = Fractions([dot_product(shifted[0], cross_product(shifted[1], shifted[2]))], extra=(MOMENT,))
    _, factors = problem.field.factor(problem.numerator())
    parts = [(problem.shaper.poly(part), e) for part, e in factors]
    return sorted(
        ((part, e) for part, e in parts if MOMENT in part.symbols()),
        key=lambda item: (degree(item[0], MOMENT) or 0, item[1]),
    )


def rising_roots(part: Formula, spelled: Spelled) -> list[Formula]:
    """The root of a linear factor, or s/2 ∓ √(s²/4 − p) of λ² − s λ + p; none of others."""
    free, *more = coefficients(part, MOMENT) or (ZERO,)
    if len(more) == 1:
        return [spelled(negate(free) / more[0])]
    if len(more) != 2:
        return []
    middle = spelled(negate(more[0]) / (2 * more[1]))
    root = sqrt(spelled(add(square(middle), negate(free / more[1]))))
    return [spelled(middle - root), spelled(middle + root)]


def lone_way(rows: list[Triple], moment: Formula, spelled: Spelled) -> Triple | None:
    """The axis of a moment that is alone: square to two rows of I − λ 1."""
    shifted = [
        triple([spelled(part - moment) if i == j else part for j, part in enumerate(row)]) for i, row in enumerate(rows)
    ]
    for one, other in combinations(shifted, 2):
        normal = triple([spelled(part) for part in cross_product(one, other)])
        if any(part != ZERO for part in normal):
            size = spelled(length_of(normal))
            return triple([spelled(part / size) for part in normal])
    return None


def principal_moment(
    tensor: InertiaTensor, spelled: Spelled, number: int, path: Path, vanishes: Nothing, side: Side
) -> Formula | None:
    """The first, second or third of them, from the smallest on, None where no axis shows; `side` tells the sign of a difference."""
    found = principal(tensor, spelled, vanishes)
    return found[rising_order(found, spelled, path, side)[number - 1]][0] if found else None


def rising_order(found: list[Found], spelled: Spelled, path: Path, side: Side) -> list[int]:
    """The places of principal moments from the smallest on; refused where that hangs on letters."""
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
    return ordered


def told_by_kind(found: list[Found], one: int, other: int, spelled: Spelled) -> int | None:
    """Which of two moments is larger whatever the letters are: the second by a root of two, the sum of both others, as of a lamina, one
    that is a number of times the other."""
    third = 3 - one - other
    moments = [moment for moment, _ in found]
    if third == 0 and found[2][1] is not None and found[2][1] not in WAYS.values():
        return 1 if one == 2 else -1
    for larger, smaller, sign in ((one, other, 1), (other, one, -1)):
        if is_zero(spelled(moments[larger] - moments[smaller] - moments[third])):
            return sign
    ratio = ONE if moments[other] == ZERO else spelled(moments[one] / moments[other])  # no moment is negative
    if ratio == ONE or ratio.symbols():
        return None
    return 1 if evaluate(ratio - ONE, {}).float > 0 else -1


def numbered_axis(
    tensor: InertiaTensor, spelled: Spelled, number: int, path: Path, vanishes: Nothing, side: Side
) -> tuple[Formula, Triple] | None:
    """The first, second or third moment from the smallest on, with its axis; None where no axis shows.

    Refused where another moment equals it: any line across the third axis is one then.
    """
    found = principal(tensor, spelled, vanishes)
    if not found:
        return None
    one = rising_order(found, spelled, path, side)[number - 1]
    moment, way = found[one]
    alike = any(vanishes(spelled(moment - other)) for place, (other, _) in enumerate(found) if place != one)
    if alike or way is None:
        message = f"`{path_text(path)}`: two principal moments are equal, and all lines in a plane are axes of theirs"
        raise NotYet(message, path.span, f"ask for the axis of the third: `{path.owner}.principal_axis`")
    return moment, way


def lone_axis(tensor: InertiaTensor, spelled: Spelled, path: Path, vanishes: Nothing) -> tuple[Formula, Triple]:
    """The one moment that no other equals, and its axis."""

    def nothing(value: Formula) -> bool:
        return vanishes(spelled(value))

    found = principal(tensor, spelled, vanishes)
    for number, (moment, way) in enumerate(found):
        others = [item for place, (item, _) in enumerate(found) if place != number]
        alone = way is not None and not any(nothing(moment - other) for other in others)
        if way is not None and alone and nothing(others[0] - others[1]):
            return moment, way
    raise NotYet(f"`{path_text(path)}`: no principal moment stands alone beside two that are equal", path.span)
