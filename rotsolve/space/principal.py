"""Principal moments and axes: in closed form where one axis shows: one without products of inertia, (1, 1, 1) of three alike, or any of
which the moment is a root without roots of det (I − λ 1) = 0, as symmetry makes one.

An axis on which no product of inertia stands is a principal one, and leaves a quadratic for the others:
λ = (I_a + I_b)/2 ± √(((I_a − I_b)/2)² + I_ab²). Else the cubic is taken into factors. Where it has none, and where a closed form would be
longer than a line, moments and axes go by letters that are worked out one by one: see `principal_letters`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import cached_property
from itertools import combinations
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.certified.ball import Certified, decided_by_size, evaluate
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.exact.normal import Fractions, coefficients, degree, is_zero, simplify
from rotsolve.algebra.exact.order import LINE, length
from rotsolve.algebra.formula import ONE, ZERO, Formula, Integral, Symbol, add, negate, sqrt
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.facts import square
from rotsolve.core.vectors.tensor import ENTRIES, InertiaTensor
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

if TYPE_CHECKING:
    from rotsolve.space.arrangement import JointedBodies
    from rotsolve.space.inertia import Tensors

Spelled = Callable[[Formula], Formula]
Found = tuple[Formula, Triple | None]  # a principal moment, with its axis where that is told
BESIDE = {"x": ("yy", "zz", "yz"), "y": ("zz", "xx", "zx"), "z": ("xx", "yy", "xy")}
WAYS = {"x": X, "y": Y, "z": Z}
ROWS = (("xx", "xy", "zx"), ("xy", "yy", "yz"), ("zx", "yz", "zz"))
MOMENT = "#moment"  # λ, as no scene calls it
FACTORED = (
    300  # nodes of a tensor, whose cubic is taken into factors: beyond it takes seconds, and longer ones have had none
)
PUT_IN = 1000  # nodes of entries with all put in, which no simpler form makes short
IN_PLANE = 100  # nodes of the three entries in a plane that are spelled out under a root
PRODUCTS = {"x": ("xy", "zx"), "y": ("xy", "yz"), "z": ("zx", "yz")}


class ToldTensor(Struct, dict=True):
    """The tensor of a body about a point, of which principal moments and axes are told, in letters that `tensors` define."""

    tensor: InertiaTensor
    tensors: Tensors
    signs: SignOracle
    held: JointedBodies
    name: str
    spot: str

    def spelled(self, value: Formula) -> Formula:
        """A formula with what its letters stand for."""
        return self.tensors.spelled(value)

    def worked_out(self, value: Formula) -> Formula:
        """A formula with what its letters stand for, and its integrals carried out."""
        value = self.spelled(value)
        if not value.holds(Integral):
            return value
        from rotsolve.algebra.calculus.integral import carried_out

        return simplify(carried_out(value, self.tensors.positive), positive=self.tensors.positive)

    def number(self, value: Formula) -> Certified | None:
        """The number of a formula in these letters; None where one has none."""
        return self.tensors.number(value, self.signs)

    def vanishes(self, value: Formula) -> bool:
        """Whether a formula is nothing, by its letters or their numbers."""
        number = self.number(value)  # which costs less than to spell a long one out
        return value == ZERO or (not (number is not None and number.sign) and self.held.vanishes(self.spelled(value)))

    def doubtful(self, value: Formula) -> bool:
        """Whether a formula has a number that no precision tells from nothing, though it is not seen to be that."""
        number = self.number(value)
        if (number is not None and number.sign is not None) or self.vanishes(value):
            return False
        return self.signs.trials.keys() >= set(self.signs.lacking(self.spelled(value)))

    def side(self, gap: Formula) -> int | None:
        """The sign of a difference, of a long tensor by its numbers alone."""
        number = self.number(gap) if self.long else None
        if number is not None and number.sign:
            decided_by_size()
            return number.sign
        value = self.worked_out(gap)
        sign = self.signs.decide(value)
        return self.signs.whatever_way(value) if sign is None else sign

    def size(self, *words: str) -> int:
        """How long its entries are, or some of them."""
        entries = [self.tensor.entry(word) for word in words or ENTRIES]
        whole = sum(length(self.tensors.put_in(entry)) for entry in entries)
        return whole if whole > PUT_IN else sum(length(self.spelled(entry)) for entry in entries)

    @cached_property
    def long(self) -> bool:
        """Whether the entries are so long that they are worked out by themselves: what they stand for would fill pages."""
        return self.size() > IN_PLANE

    def part(self, words: str, letter: str, index: str, value: Formula, dimension: Dimension) -> Formula:
        """A letter for a part of the roots, with what it stands for; of a long tensor its entries are worked out first."""
        if self.long:
            self.tensors.work_out_first(self.tensor)
        return self.tensors.part(self.name, self.spot, words, letter, index, value, dimension)


class PrincipalRoots(Struct):
    """The three moments with their axes; `rising` where they are those of a cubic, from the smallest on, each with an axis of its own."""

    found: list[Found]
    rising: bool = False


def principal(told: ToldTensor, path: Path) -> PrincipalRoots:
    """The three moments with their axes, of a tensor whose letters are spelled out to see what vanishes or is alike."""
    tensor = told.tensor
    free = bare_axes(told)
    if len(free) == 3:
        return PrincipalRoots([(tensor.entry(axis * 2), WAYS[axis]) for axis in "xyz"])
    if free:
        return PrincipalRoots([(tensor.entry(free[0] * 2), WAYS[free[0]]), *in_plane(told, free[0])])
    if all_alike(told):
        third = ONE / sqrt(3 * ONE)
        lone = simplify(add(tensor.xx, 2 * tensor.xy))
        other = simplify(add(tensor.xx, negate(tensor.xy)))
        return PrincipalRoots([(lone, (third, third, third)), (other, None), (other, None)])
    found = by_factors(told)
    if found:
        return PrincipalRoots(found)
    from rotsolve.space.principal_letters import by_cubic

    return PrincipalRoots(by_cubic(told, path), rising=True)


def bare_axes(told: ToldTensor) -> list[str]:
    """The axes on which no product of inertia stands."""
    return [axis for axis in "xyz" if all(told.vanishes(told.tensor.entry(word)) for word in PRODUCTS[axis])]


def all_alike(told: ToldTensor) -> bool:
    """Whether all three moments are the same, and all three products."""
    tensor = told.tensor
    gaps = (tensor.xx - tensor.yy, tensor.yy - tensor.zz, tensor.xy - tensor.yz, tensor.yz - tensor.zx)
    return all(map(told.vanishes, gaps))


def in_plane(told: ToldTensor, axis: str) -> list[Found]:
    """The two moments across a principal axis, the smaller one first, with their axes: in closed form where that is at most a line."""
    from rotsolve.space.principal_letters import angle_in_plane, circle_in_plane

    closed = closed_in_plane(told, axis) if told.size(*BESIDE[axis]) <= IN_PLANE else []
    moments: Sequence[Formula] = [moment for moment, _ in closed]
    ways: Sequence[Triple] = [way for _, way in closed]
    if not within_line(moments):
        moments = circle_in_plane(told, axis)
    if not all(map(within_line, ways)) or not ways:
        ways = angle_in_plane(told, axis)
    return list(zip(moments, ways, strict=True))


def within_line(parts: Sequence[Formula]) -> bool:
    """Whether there are formulas, and none is longer than a line."""
    return bool(parts) and max(map(length, parts)) <= LINE


def closed_in_plane(told: ToldTensor, axis: str) -> list[tuple[Formula, Triple]]:
    """In closed form: the axis of λ is along (I_ab, λ − I_a) in the plane across a principal axis."""
    spelled = told.spelled
    one, other, product = (told.tensor.entry(word) for word in BESIDE[axis])
    middle, half = spelled((one + other) / 2), spelled((one - other) / 2)
    root = spelled(sqrt(add(square(half), square(spelled(product)))))
    found = []
    for moment in (spelled(middle - root), spelled(middle + root)):
        a, b = spelled(product), spelled(moment - one)
        whole = spelled(sqrt(add(square(a), square(b))))
        a, b = spelled(a / whole), spelled(b / whole)
        first, second = (WAYS[word[0]] for word in BESIDE[axis][:2])
        found.append((moment, tidied(vector_sum(scaled_by(a, first), scaled_by(b, second)))))
    return found


def by_factors(told: ToldTensor) -> list[Found]:
    """The three moments by the factors of det (I − λ 1), a linear one first, with its axis where it is alone; none where there is none."""
    found: list[Found] = []
    rows = told_rows(told)
    for part, e in cubic_factors(rows):
        roots = rising_roots(part, told.spelled)
        alone = e == 1 and (len(roots) == 2 or not found)
        axes = [
            lone_way(told, rows, root, number) if alone else None for number, root in enumerate(roots, len(found) + 1)
        ]
        found += list(zip(roots, axes, strict=True)) * e
    return found if len(found) == 3 else []


def told_rows(told: ToldTensor) -> list[Triple]:
    """The rows of a tensor, spelled out; none of one that is far too long for that."""
    spelled = told.spelled
    return (
        [triple([spelled(told.tensor.entry(word)) for word in words]) for words in ROWS]
        if told.size() <= PUT_IN
        else []
    )


def cubic_factors(rows: list[Triple]) -> list[tuple[Formula, int]]:
    """The factors of det (I − λ 1) with how often each stands, those of the lowest degree first; none of a long tensor."""
    if not rows or sum(length(part) for row in rows for part in row) > FACTORED:
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


def lone_way(told: ToldTensor, rows: list[Triple], moment: Formula, number: int) -> Triple | None:
    """The axis of a moment that is alone: square to two rows of I − λ 1."""
    from rotsolve.space.principal_letters import square_to_rows

    spelled = told.spelled
    if length(moment) > LINE:
        return square_to_rows(told, moment, number)
    for one, other in combinations(less_moment(rows, moment, spelled), 2):
        normal = triple([spelled(part) for part in cross_product(one, other)])
        if any(part != ZERO for part in normal):
            size = spelled(length_of(normal))
            way = triple([spelled(part / size) for part in normal])
            return way if within_line(way) else square_to_rows(told, moment, number)
    return None


def less_moment(rows: Sequence[Triple], moment: Formula, spelled: Spelled) -> list[Triple]:
    """The rows of I − λ 1."""
    return [
        triple([spelled(part - moment) if i == j else part for j, part in enumerate(row)]) for i, row in enumerate(rows)
    ]


def principal_moment(told: ToldTensor, number: int, path: Path) -> Formula:
    """The first, second or third of them, from the smallest on."""
    roots = principal(told, path)
    one = rising_order(told, roots, path)[number - 1]
    refuse_doubtful(told, roots, others_than(one), path)
    return roots.found[one][0]


def rising_order(told: ToldTensor, roots: PrincipalRoots, path: Path) -> list[int]:
    """The places of principal moments from the smallest on; refused where that hangs on letters."""
    if roots.rising:
        return [0, 1, 2]
    moments = [moment for moment, _ in roots.found]
    ordered: list[int] = []
    for one in range(len(moments)):
        place = 0
        while place < len(ordered):
            sign = which_larger(told, roots.found, one, ordered[place])
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


def which_larger(told: ToldTensor, found: list[Found], one: int, other: int) -> int | None:
    """The sign of the difference of two moments, by their kind or by their letters and numbers; None where nothing tells."""

    def by_side() -> int | None:
        return told.side(found[one][0] - found[other][0])

    def by_kind() -> int | None:
        return told_by_kind(found, one, other, told.worked_out)

    signs = (way() for way in ((by_side, by_kind) if told.long else (by_kind, by_side)))
    sign = next((sign for sign in signs if sign is not None), None)
    if sign is not None or found[other][0] == ZERO:
        return sign
    return told.signs.decide(told.worked_out(found[one][0] / found[other][0]) - ONE)  # what has no number may cancel


def told_by_kind(found: list[Found], one: int, other: int, worked_out: Spelled) -> int | None:
    """Which of two moments is larger whatever the letters are: the second by a root of two, the sum of both others, as of a lamina, one
    that is a number of times the other."""
    third = 3 - one - other
    moments = [moment for moment, _ in found]
    if third == 0 and found[2][1] is not None and found[2][1] not in WAYS.values():
        return 1 if one == 2 else -1
    for larger, smaller, sign in ((one, other, 1), (other, one, -1)):
        if is_zero(worked_out(moments[larger] - moments[smaller] - moments[third])):
            return sign
    ratio = ONE if moments[other] == ZERO else worked_out(moments[one] / moments[other])  # no moment is negative
    return None if ratio == ONE or ratio.symbols() else evaluate(ratio - ONE, {}, digits=8).sign


def refuse_doubtful(told: ToldTensor, roots: PrincipalRoots, pairs: Iterable[tuple[int, int]], path: Path) -> None:
    """Refuse moments of which no precision tells whether they are equal: what an axis of theirs is hangs on that."""
    if not roots.rising and any(in_doubt(told, roots.found, *pair) for pair in pairs):
        message = f"`{path_text(path)}`: two principal moments are equal, or nearly: no precision tells which"
        help = "write what is alike by one letter, as angles `u` and `u + 60 deg`, or ask for `inertia_tensor`"
        raise NotYet(message, path.span, help)


def in_doubt(told: ToldTensor, found: list[Found], one: int, other: int) -> bool:
    """Whether nothing tells two moments apart; of one beside two that are nearly equal their mean tells, in which their root cancels."""
    (first, _), (second, _), (third, _) = (found[place] for place in (one, other, 3 - one - other))
    if not told.doubtful(first - second):
        return False
    for lone, near, far in ((first, second, third), (second, first, third)):
        number = told.number(told.spelled(lone - (near + far) / 2))
        if number is not None and number.sign and told.doubtful(near - far):
            return False
    return True


def others_than(one: int) -> list[tuple[int, int]]:
    """The places of a moment and of each of both others."""
    return [(one, other) for other in range(3) if other != one]


def numbered_axis(told: ToldTensor, number: int, path: Path) -> tuple[Formula, Triple]:
    """The first, second or third moment from the smallest on, with its axis.

    Refused where another moment equals it: any line across the third axis is one then.
    """
    roots = principal(told, path)
    one = rising_order(told, roots, path)[number - 1]
    moment, way = roots.found[one]
    if roots.rising:
        from rotsolve.space.principal_letters import square_to_rows

        return moment, square_to_rows(told, moment, number)
    refuse_doubtful(told, roots, others_than(one), path)
    if way is None or any(told.vanishes(moment - roots.found[other][0]) for _, other in others_than(one)):
        message = f"`{path_text(path)}`: two principal moments are equal, and all lines in a plane are axes of theirs"
        raise NotYet(message, path.span, f"ask for the axis of the third: `{path.owner}.principal_axis`")
    return moment, way


def lone_axis(told: ToldTensor, path: Path) -> tuple[Formula, Triple]:
    """The one moment that no other equals, and its axis."""
    roots = principal(told, path)

    def nothing(value: Formula) -> bool:
        return not roots.rising and told.vanishes(value)

    for number, (moment, way) in enumerate(roots.found):
        others = [item for place, (item, _) in enumerate(roots.found) if place != number]
        alone = way is not None and not any(nothing(moment - other) for other in others)
        if way is not None and alone and nothing(others[0] - others[1]):
            return moment, way
    refuse_doubtful(told, roots, combinations(range(3), 2), path)
    raise NotYet(f"`{path_text(path)}`: no principal moment stands alone beside two that are equal", path.span)
