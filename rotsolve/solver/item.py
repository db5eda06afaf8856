"""Items: equations on their way through the eliminations, and how an unknown stands in them."""

from __future__ import annotations

from collections.abc import Collection

from msgspec import Struct, field

from rotsolve.algebra.formula import ZERO, Formula, Integral, Sum, Symbol, negate
from rotsolve.core.writing import flat, positive_first
from rotsolve.solver.step import Ref


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


def put_square(value: Formula, square: Formula, into: Formula) -> Formula:
    """A formula with a square replaced."""
    return value.transform(lambda node: into if node == square else node)


def only_squared(item: Item, name: str) -> bool:
    """Whether a letter occurs in an equation as its square alone."""
    square = Symbol(name) ** 2
    return not any(name in put_square(side, square, ZERO).symbols() for side in (item.left, item.right))


def monomial(value: Formula) -> bool:
    """Whether a formula is a single term without sums."""
    return not value.holds(Sum, Integral)


def kind_of(item: Item, name: str, names: Collection[str]) -> int:
    """How little it takes to eliminate an unknown, of the unknowns `names` of an equation.

    0: it is the only one, and alone on one side; 1: it is the only one; 2: one term equals another, with two unknowns; 3: else.
    """
    if len(names) == 1:
        return 0 if isolated(item, name) else 1
    return 2 if len(names) == 2 and monomial(item.left) and monomial(item.right) else 3
