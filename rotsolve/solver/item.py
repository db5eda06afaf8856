"""Items: equations on their way through the eliminations, and how an unknown stands in them."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from functools import reduce
from operator import mul

from msgspec import Struct, field

from rotsolve.algebra.formula import (
    ONE,
    ZERO,
    Formula,
    Integral,
    Negative,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
    formula,
    negate,
)
from rotsolve.core.writing import flat, positive_first
from rotsolve.solver.step import Ref

TWO = formula(2)


class Item(Struct):
    """An equation on its way: what it has become, and what has been put in since it was written."""

    ref: Ref
    index: int
    left: Formula
    right: Formula
    section: str
    sources: list[Ref] = field(default_factory=list)

    def unknowns(self, names: Collection[str]) -> set[str]:
        return set((self.left.symbols() | self.right.symbols()) & set(names))


def inner(item: Item) -> set[str]:
    """Letters inside integrals, where a bound variable hides nothing."""
    return {
        name
        for side in (item.left, item.right)
        for node in side.walk(Integral)
        if isinstance(node, Integral)
        for name in node.integrand.symbols()
    }


def isolated(item: Item, name: str) -> Formula | None:
    """The other side where the unknown stands alone on one and does not occur there."""
    letter = Symbol(name)
    if item.left == letter and name not in item.right.symbols():
        return item.right
    if item.right == letter and name not in item.left.symbols():
        return item.left
    return None


def moved_alone(item: Item, name: str) -> Formula | None:
    """The unknown alone where it is a term of its own: the other terms moved across as they are written."""
    letter = Symbol(name)
    terms = [(term, 1) for term in flat([item.left])] + [(term, -1) for term in flat([item.right])]
    own = [(term, side) for term, side in terms if name in term.symbols()]
    if len(own) != 1 or own[0][0] not in (letter, negate(letter)) or len(terms) < 3:
        return None
    sign = own[0][1] * (1 if own[0][0] == letter else -1)
    return positive_first([negate(term) if side == sign else term for term, side in terms if (term, side) != own[0]])


def cofactor(base: Formula, name: str) -> Formula | None:
    """What a letter is multiplied with in a single term: 1/r in v/r."""
    if name not in base.symbols():
        return None
    if base == Symbol(name):
        return ONE
    if isinstance(base, Negative):
        return cofactor(base.operand, name)  # its square is the same
    if isinstance(base, Quotient) and name not in base.denominator.symbols():
        above = cofactor(base.numerator, name)
        return None if above is None else above / base.denominator
    if isinstance(base, Product):
        others = [factor for factor in base.factors if name not in factor.symbols()]
        held = [factor for factor in base.factors if name in factor.symbols()]
        inner = cofactor(held[0], name) if len(held) == 1 else None
        return None if inner is None else reduce(mul, others, inner)
    return None


def put_square(value: Formula, name: str, into: Formula) -> Formula:
    """A formula with the square of a letter replaced: in (v/r)² with v² = g r that is g r/r²."""

    def change(node: Formula) -> Formula:
        if not isinstance(node, Power) or node.exponent != TWO:
            return node
        factor = cofactor(node.base, name)
        if factor is None:
            return node
        above, below = (factor.numerator, factor.denominator) if isinstance(factor, Quotient) else (factor, ONE)
        return above**2 * into / below**2

    return value.transform(change)


def only_squared(item: Item, name: str) -> bool:
    """Whether a letter occurs in an equation as its square alone."""
    return not any(name in put_square(side, name, ZERO).symbols() for side in (item.left, item.right))


def holds_square(side: Formula, name: str) -> bool:
    """Whether the square of a letter occurs in a formula."""
    return name in side.symbols() and put_square(side, name, ZERO) != side


def monomial(value: Formula) -> bool:
    """Whether a formula is a single term without sums."""
    return not value.holds(Sum, Integral)


def kind_of(item: Item, name: str, names: Collection[str], items: Sequence[Item]) -> int:
    """How little it takes to eliminate an unknown, of the unknowns `names` of an equation among all `items`.

    0: it is the only one, and alone on one side; 1: it is the only one; 2: one term equals another, with two unknowns; 3: it is the
    only one, as its square alone, which another equation holds too; 4: else.
    """
    if len(names) > 1:
        return 2 if len(names) == 2 and monomial(item.left) and monomial(item.right) else 4
    if isolated(item, name):
        return 0
    squared = only_squared(item, name) and any(
        holds_square(side, name) for other in items if other is not item for side in (other.left, other.right)
    )
    return 3 if squared else 1
