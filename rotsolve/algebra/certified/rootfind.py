"""Root finding: the real roots of a formula in an interval, each isolated and certified by interval Newton."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache, partial

from msgspec import Struct

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.ball import BITS_PER_DIGIT, Certified, Precision, decided_by_size, ends, evaluate
from rotsolve.algebra.certified.balls import Ball, RealBalls, Undefined, Values, with_values
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.flints import arb, fmpq
from rotsolve.algebra.formula import Formula, Integral, Number, formula

BUDGET = 3000  # intervals looked at
INTEGRAL = 60  # as how many one counts where an integral has to be worked out for it
KEPT = 64  # searches that are kept
SPLIT = Fraction(489, 1000)  # not the middle, where roots of tidy problems are
PLACES = [Fraction(place, 1009) for place in (-983, -744, -493, -239, 17, 251, 602, 891)]  # where an identity shows
NARROW = 60  # bits of relative width below which an undecided interval is given up


class Roots(Struct, frozen=True):
    """Certified simple roots in rising order; `complete` tells whether they are certainly all."""

    roots: tuple[Certified, ...]
    complete: bool


class _Function(Struct, frozen=True):
    """A formula of one variable with its derivative, over balls."""

    f: Formula
    slope: Formula
    name: str

    def __call__(self, x: Ball) -> Ball:
        return RealBalls({}, bound={self.name: x}, clip=True)(self.f)

    def rate(self, x: Ball) -> Ball:
        return RealBalls({}, bound={self.name: x}, clip=True)(self.slope)


def _point(value: Fraction) -> Ball:
    return arb(fmpq(value.numerator, value.denominator))


def _interval(low: Fraction, high: Fraction) -> Ball:
    return _point(low).union(_point(high))


def real_roots(
    f: Formula,
    name: str,
    values: Values,
    low: Formula | Fraction | int,
    high: Formula | Fraction | int,
    digits: int = 15,
) -> Roots:
    """All simple roots of f = 0 for `name` from low to high, within bounded work."""
    decided_by_size()
    g = with_values(f, {key: value for key, value in values.items() if key != name})
    with Precision(_bits(digits)):
        first, last = _end(low, values, False), _end(high, values, True)
    return _roots(g, name, first, last, digits)


def _bits(digits: int) -> int:
    return int(digits * BITS_PER_DIGIT) + 64


@lru_cache(KEPT)
def _roots(f: Formula, name: str, first: Fraction, last: Fraction, digits: int) -> Roots:
    """The same with all values put in: one that is looked for again, in another attempt at a scene, is not worked out again."""
    function = _Function(f, differentiate(f, name), name)
    with Precision(_bits(digits)):
        isolated, complete = _isolate(function, first, last)
        found = [_certify(function, piece, digits) for piece in isolated]
    return Roots(tuple(sorted(found, key=lambda root: root.float)), complete)


def is_identity(f: Formula, name: str, values: Values, reach: int) -> bool:
    """Whether f = 0 for every `name`: it is exactly so wherever it is looked at from −reach to reach and is defined at all.

    It finds what the exact layer can't know of letters: ln(u/v) + ln(v/u), where the signs of u and v depend on the unknown.
    """
    g = with_values(f, {key: value for key, value in values.items() if key != name})
    function = _Function(g, g, name)
    told = [_vanishes(function, reach * place) for place in PLACES]
    return sum(one is not None for one in told) > 1 and all(one is not False for one in told)


def _end(value: Formula | Fraction | int, values: Values, upper: bool) -> Fraction:
    """An end of the interval as a fraction, rounded outwards."""
    resolved = with_values(formula(value), values)
    if isinstance(resolved, Number):
        return resolved.value
    return ends(RealBalls({})(resolved))[1 if upper else 0]


def _isolate(function: _Function, first: Fraction, last: Fraction) -> tuple[list[tuple[Fraction, Fraction]], bool]:
    """Intervals with exactly one root each (a point where the root is exact), and whether nothing was given up."""
    found: list[tuple[Fraction, Fraction]] = [(x, x) for x in dict.fromkeys((first, last)) if _vanishes(function, x)]
    exact = {x for x, _ in found}
    stack, complete, work = [(first, last)], True, 0
    each = INTEGRAL if function.f.holds(Integral) else 1
    limit = max(abs(first), abs(last), last - first) / (1 << NARROW)
    while stack:
        low, high = stack.pop()
        work += each
        if work > BUDGET:
            return found, False
        verdict = _look(function, low, high, exact)
        if verdict == "one":
            found.append((low, high))
        elif verdict != "none":
            if high - low <= limit:
                complete = False
                continue
            piece = _narrowed(function, low, high) if verdict == "edge" else (low, high)
            if piece is not None and 2 * (piece[1] - piece[0]) < high - low:
                stack.append(piece)
            elif piece is not None:
                middle = low + (high - low) * SPLIT
                stack += [(middle, high), (low, middle)]
    return found, complete


def _narrowed(function: _Function, low: Fraction, high: Fraction) -> tuple[Fraction, Fraction] | None:
    """What Newton's step leaves of an interval in which f rises or falls throughout; None where that has no root."""
    box, middle = _interval(low, high), _point((low + high) / 2)
    step = middle - function(middle) / function.rate(box)
    if not step.overlaps(box):
        return None
    first, last = ends(step)
    return max(first, low), min(last, high)


def _vanishes(function: _Function, x: Fraction) -> bool | None:
    """Whether x is a root, exactly; None where the function is not defined."""
    try:
        if not function(_point(x)).contains(0):
            return False
        return is_zero(function.f.substitute({function.name: Number(x)}))
    except (Undefined, ZeroDivisionError):
        return None


def _look(function: _Function, low: Fraction, high: Fraction, exact: set[Fraction]) -> str:
    """none, one (root inside), edge (perhaps at an end) or unsure for an interval; roots at exact ends are not counted again."""
    box = _interval(low, high)
    try:
        value = function(box)
    except Undefined:
        return "none"
    if value.is_finite() and not value.contains(0):
        return "none"
    try:
        rate = function.rate(box)
        if not rate.is_finite() or rate.contains(0) or not value.is_finite():
            return "unsure"
        if low in exact or high in exact:
            return "none"
        left, right = function(_point(low)), function(_point(high))
    except Undefined:
        return "unsure"
    if left.contains(0) or right.contains(0):
        return "edge"
    return "none" if (left > 0) == (right > 0) else "one"


def _certify(function: _Function, piece: tuple[Fraction, Fraction], digits: int) -> Certified:
    low, high = piece
    if low < 0 < high and _vanishes(function, Fraction(0)):
        low = high = Fraction(0)
    if low == high:
        return evaluate(Number(low), {})
    refine = partial(_newton, function, low, high)
    return Certified(refine(digits), refine, partial(_is_root, function, low, high))


def _is_root(function: _Function, low: Fraction, high: Fraction, value: Fraction) -> bool:
    """Whether the root between two numbers is this one."""
    return low < value < high and bool(_vanishes(function, value))


def _newton(function: _Function, low: Fraction, high: Fraction, digits: int) -> Ball:
    """Interval Newton on an interval where the slope keeps its sign: every step keeps the root."""
    needed = int(digits * BITS_PER_DIGIT) + 4
    with Precision(needed + 60):
        box = _interval(low, high)
        for _ in range(400):
            if box.rel_accuracy_bits() >= needed:
                return box
            middle = box.mid()
            step = middle - function(middle) / function.rate(box)
            new = step.intersection(box) if step.is_finite() and step.overlaps(box) else box
            if new.rad() > box.rad() * arb("0.7"):
                new = _halve(function, box, new)
            box = new
    return box


def _halve(function: _Function, box: Ball, new: Ball) -> Ball:
    """The half of the box in which the sign changes, where Newton is too slow."""
    low, high = (_point(end) for end in ends(box))
    middle = box.mid()
    at = function(middle)
    if at.contains(0):
        return new
    same = (function(low) > 0) == (at > 0)
    half = middle.union(high) if same else low.union(middle)
    return new.intersection(half) if new.overlaps(half) else half
