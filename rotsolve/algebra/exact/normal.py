"""Exact: equality, textbook form and coefficients of formulas as rational functions in symbols and atoms.

Symbols are real; only the names in `positive` are taken to be positive. Answers are equal to the input by construction.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from functools import cached_property, lru_cache

from rotsolve.algebra.exact.field import Field, Poly, Ratio
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.exact.rewrite import Rewriter
from rotsolve.algebra.exact.shape import Shaper
from rotsolve.algebra.formula import ZERO, Call, Formula, Number, Symbol, add, call, negate

REMEMBERED = 4096  # answers of each function here; three of four questions of a scene have been asked before
WRITTEN = "written"  # under this name a formula in textbook form keeps the order of letters and the signs that it is written for
LONGER, FEW_TERMS = 3, 30  # a way of writing with so many times the terms, and so many more, is none of the shortest
LATELY = 64  # formulas of which the polynomials are kept: an equation is asked for its degree, then for its roots
VARIANT_LIMIT = 200  # terms; a fraction this long is no textbook answer in any form


class Fractions:
    """Formulas that are handled together: rewritten, with one field for all."""

    def __init__(
        self,
        formulas: Sequence[Formula],
        order: Sequence[str] = (),
        positive: Collection[str] = (),
        *,
        split_logs: bool = False,
        extra: Iterable[str] = (),
        constants_apart: bool = False,
    ) -> None:
        self.order, self.positive = tuple(order), frozenset(positive)
        rewrite = Rewriter(formulas, self.order, positive, split_logs, constants_apart)
        self.constants_tied = rewrite.constants_tied
        self.formulas = [rewrite(formula) for formula in formulas]
        self.field = Field([*self.formulas, *(Symbol(name) for name in extra)])

    @cached_property
    def shaper(self) -> Shaper:
        """What writes fractions of the field; many problems only ask whether something is zero."""
        return Shaper(self.field, self.order, self.positive)

    def ratio(self, k: int = 0) -> Ratio:
        """Formula k as a fraction; ZeroDivisionError where its denominator vanishes."""
        num, den = self.field.convert(self.formulas[k])
        self.field.check_divisor(den)
        return num, den

    def numerator(self, k: int = 0) -> Poly:
        """The reduced numerator of formula k with common factors cancelled."""
        num, den = self.ratio(k)
        return self.field.cancel((self.field.reduce(num), self.field.reduce(den)))[0]

    def shortest(self, ratio: Ratio) -> Formula:
        """The shortest textbook form of a fraction among the ways to use sin² + cos² = 1 and to clear roots."""
        ring = self.field
        best: Formula | None = None
        seen: list[Ratio] = []
        most = LONGER * sum(map(len, ratio)) + FEW_TERMS
        for candidate in self._variants(ratio):
            reduced = ring.cancel(candidate)
            if reduced not in seen and (best is None or sum(map(len, reduced)) <= most):
                seen.append(reduced)
                shown = self.shaper.ratio(reduced)
                if best is None or length(shown) < length(best):
                    best = shown
        assert best is not None
        best.__dict__[WRITTEN] = concerning(best, self.order, self.positive)
        return best

    def _variants(self, ratio: Ratio) -> Iterable[Ratio]:
        ring = self.field
        num, den = ratio
        if not ring.pairs and not ring.roots:
            return (ratio,)
        sines = ring.reduce(num), ring.reduce(den)
        if not len(sines[0]):
            return (sines,)
        found = [ratio, sines]
        if len(sines[0]) + len(sines[1]) > VARIANT_LIMIT:
            return found
        for pair in ring.pairs[:3]:
            found.append((ring.reduce_to_cos(sines[0], pair), ring.reduce_to_cos(sines[1], pair)))
        if len(ring.pairs) > 1:
            num, den = sines
            for pair in ring.pairs:
                num, den = ring.reduce_to_cos(num, pair), ring.reduce_to_cos(den, pair)
            found.append((num, den))
        united = ring.squares_united(sines[0]), ring.squares_united(sines[1])
        found += [united] if united != sines else []
        cleared = ring.rationalised(sines)
        return [*found, cleared] if cleared is not None else found


def concerning(
    f: Formula, order: Sequence[str], positive: Collection[str], *extra: str
) -> tuple[tuple[str, ...], frozenset[str]]:
    """What an order of letters and their signs say of a formula: the same for many scenes, so that its answer is known from another."""
    names = f.symbols().union(extra) if extra else f.symbols()
    return tuple([name for name in order if name in names]), names.intersection(positive)


def is_zero(f: Formula, positive: Collection[str] = frozenset()) -> bool:
    """Whether the formula vanishes identically."""
    return _is_zero(f, f.symbols().intersection(positive))


@lru_cache(REMEMBERED)
def _is_zero(f: Formula, positive: frozenset[str]) -> bool:
    problem = Fractions([f], positive=positive, split_logs=True)
    num, _ = problem.ratio()
    return not len(problem.field.reduce(num))


def without_direction(f: Formula) -> bool:
    """Whether a formula holds atan2(0, 0), the angle of what is nothing, whatever its letters are."""
    angles = (node for node in f.walk("atan2") if isinstance(node, Call) and node.function == "atan2")
    return any(all(map(is_zero, angle.arguments)) for angle in angles)


def equal(a: Formula, b: Formula, positive: Collection[str] = frozenset()) -> bool:
    """Whether two formulas are equal wherever both are defined."""
    if a == b:
        return True
    gap = add(a, negate(b))
    return is_zero(gap, positive) or ((like := with_like_angles(gap, positive)) is not gap and is_zero(like, positive))


def with_like_angles(f: Formula, positive: Collection[str]) -> Formula:
    """The formula with equal angles written alike: a fraction over a sum has several forms, (a + b)/(1 + a) = a/(1 + a) + b/(1 + a)."""
    angles: list[Formula] = []

    def change(node: Formula) -> Formula:
        if not isinstance(node, Call) or node.function not in ("sin", "cos") or not node.arguments[0].children():
            return node
        (angle,) = node.arguments
        like = next((known for known in angles if equal(known, angle, positive)), None)
        angles.extend([] if like else [angle])
        return call(node.function, like) if like else node

    return f.transform(change, "sin", "cos")


def simplify(f: Formula, *, order: Sequence[str] = (), positive: Collection[str] = ()) -> Formula:
    """The formula in factored textbook form, symbols in the given order."""
    if isinstance(f, (Symbol, Number)):
        return f
    order, positive = concerning(f, order, positive)
    return f if f.__dict__.get(WRITTEN) == (order, positive) else _simplify(f, order, positive)


@lru_cache(REMEMBERED)
def _simplify(f: Formula, order: tuple[str, ...], positive: frozenset[str]) -> Formula:
    problem = Fractions([f], order, positive)
    shown = problem.shortest(problem.ratio())
    if not problem.constants_tied:
        return shown
    apart = Fractions([f], order, positive, constants_apart=True)
    return min(shown, apart.shortest(apart.ratio()), key=length)


def coefficients(
    f: Formula, unknown: str, *, order: Sequence[str] = (), positive: Collection[str] = ()
) -> tuple[Formula, ...] | None:
    """(c₀, c₁, …) of the numerator of f as a polynomial in the unknown; None when the unknown is inside an atom."""
    return _coefficients(f, unknown, *concerning(f, order, positive, unknown))


@lru_cache(REMEMBERED)
def _coefficients(
    f: Formula, unknown: str, order: tuple[str, ...], positive: frozenset[str]
) -> tuple[Formula, ...] | None:
    problem, parts = expanded(f, unknown, order, positive)
    if parts is None:
        return None
    return tuple(problem.shortest((part, problem.field.one)) if len(part) else ZERO for part in parts)


def degree(f: Formula, unknown: str, *, order: Sequence[str] = (), positive: Collection[str] = ()) -> int | None:
    """The highest power of the unknown in the numerator of f; None when the unknown is inside an atom."""
    parts = expanded(f, unknown, *concerning(f, order, positive, unknown))[1]
    return None if parts is None else len(parts) - 1


def monomials(f: Formula, unknown: str, *, order: Sequence[str] = (), positive: Collection[str] = ()) -> int:
    """How many terms the numerator of f has, multiplied out: how long what is solved for the unknown gets is told before it is written."""
    parts = expanded(f, unknown, *concerning(f, order, positive, unknown))[1]
    return sum(map(len, parts or ()))


@lru_cache(LATELY)
def expanded(
    f: Formula, unknown: str, order: tuple[str, ...], positive: frozenset[str]
) -> tuple[Fractions, list[Poly] | None]:
    """The numerator of f by powers of the unknown, and the problem in which it is; None when the unknown is inside an atom."""
    problem = Fractions([f], order, positive, extra=(unknown,))
    parts = polynomial(problem, unknown)
    if not problem.constants_tied or parts is None:
        return problem, parts
    apart = Fractions([f], order, positive, extra=(unknown,), constants_apart=True)
    other = polynomial(apart, unknown)
    same = other is not None and [not len(part) for part in other] == [not len(part) for part in parts]
    return (apart, other) if same else (problem, parts)  # no identity between the constants makes a power vanish


def polynomial(problem: Fractions, unknown: str) -> list[Poly] | None:
    """The numerator of the problem's formula by powers of the unknown; None when it is inside an atom."""
    ring = problem.field
    num = problem.numerator()
    used = num.degrees()
    if any(used[i] and ring.mentions(i, unknown) for i in range(len(ring.atoms))):
        return None
    return ring.coefficients(num, ring.index[Symbol(unknown)])
