"""Steps: equations on their way through the eliminations, the lines that are written of each, and the ways in which a plan can fail."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from fractions import Fraction
from functools import reduce
from operator import mul

from msgspec import Struct, field

from rotsolve.algebra.certified.ball import Certified
from rotsolve.algebra.formula import (
    ONE,
    PI,
    ZERO,
    Formula,
    Integral,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
    formula,
    negate,
)
from rotsolve.core.derivation import Equality, Words
from rotsolve.core.writing import flat, positive_first

# ('law', index in the pool) | ('step', number of the step) | ('known', an answer found before) | ('words', what is to hold)
Ref = tuple[str, "int | str"]


class PickedRoot(Struct, frozen=True):
    """The root that is meant, why, and the whole turns that an angle has gone beyond it, or the whole periods of a time.

    One that does not fit has not the sign that the scene tells; one is `guessed` where others fit as well, all or those that are `alike`,
    and `reached` where it is the first place on the way.
    """

    root: int
    words: Words = ()
    turns: Fraction = Fraction(0)
    period: Formula = 2 * PI
    fits: bool = True
    guessed: bool = False
    alike: tuple[int, ...] = ()
    reached: bool = False

    def of(self, roots: Sequence[Formula]) -> Formula:
        """The root itself, with its whole turns."""
        root = roots[self.root]
        return root + Number(self.turns) * self.period if self.turns else root


# the letter, its roots, and how much later they hold again, where they do
Chooser = Callable[[str, Sequence[Formula], "Formula | None"], "PickedRoot | None"]


class Redundant(ValueError):
    """An equation of a plan says nothing new once the others are put in."""

    def __init__(self, index: int) -> None:
        super().__init__(f"equation {index} says nothing new")
        self.index = index


class Contradiction(ValueError):
    """The equations of a plan can not all hold."""

    def __init__(self, index: int) -> None:
        super().__init__(f"equation {index} contradicts the others")
        self.index = index


class NoClosedForm(ValueError):
    """No unknown can be isolated."""


class NoRealValue(NoClosedForm):
    """Numbers have been looked through, and none satisfies the equation."""


class Unprintable(ValueError):
    """A closed form would be longer than what a page can hold."""


class NumbersWanted(ValueError):
    """A closed form would be so, and letters have no numbers to go on with."""


class Step(Struct, frozen=True):
    """One line of algebra: what is put into what, the chain of equalities, the unknown that it isolates."""

    number: int
    target: Ref
    sources: tuple[Ref, ...]
    chain: tuple[Equality, ...]
    result: str
    section: str
    reason: Words = ()
    divisor: Ref | None = None  # the equation by which the target was divided


class Found(Struct, frozen=True):
    """A solved unknown: closed form in givens, or a certified root of the last equation."""

    name: str
    formula: Formula | None
    number: Certified | None = None
    others: tuple[Formula, ...] = ()


class Item(Struct):
    """An equation on its way: what it has become, and what has been put in since it was written."""

    ref: Ref
    index: int
    left: Formula
    right: Formula
    section: str
    sources: list[Ref] = field(default_factory=list)
    divisor: Ref | None = None

    def unknowns(self, names: Collection[str]) -> set[str]:
        return set((self.left.symbols() | self.right.symbols()) & set(names))


def inner(item: Item) -> set[str]:
    """Letters inside integrals, where a bound variable hides nothing."""
    nodes = (node for side in (item.left, item.right) for node in side.walk(Integral))
    return {name for node in nodes if isinstance(node, Integral) for name in node.integrand.symbols()}


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


def held_as_factor(item: Item, name: str) -> tuple[Formula, Formula] | None:
    """One side of an equation, and what the unknown is multiplied with that is the other: F d and I of F d = I α."""
    for side, other in ((item.right, item.left), (item.left, item.right)):
        if name not in other.symbols() and not isinstance(side, Negative) and monomial(other):
            factor = cofactor(side, name)
            if factor is not None:
                return other, factor
    return None


def put_square(value: Formula, name: str, into: Formula) -> Formula:
    """A formula with the square of a letter replaced: in (v/r)² with v² = g r that is g r/r²."""

    def change(node: Formula) -> Formula:
        if not isinstance(node, Power) or node.exponent != formula(2):
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


def elimination_kind(item: Item, name: str, names: Collection[str], items: Sequence[Item]) -> int:
    """How little it takes to eliminate an unknown, of the unknowns `names` of an equation among all `items`.

    0: it is the only one, and alone on one side; 1: it is the only one; 2: one term equals another, with two unknowns; 3: it is the
    only one, as its square alone, which another equation holds too; 4: else.
    """
    if len(names) > 1:
        return 2 if len(names) == 2 and monomial(item.left) and monomial(item.right) else 4
    if isolated(item, name):
        return 0
    sides = (side for other in items if other is not item for side in (other.left, other.right))
    return 3 if only_squared(item, name) and any(holds_square(side, name) for side in sides) else 1


def line_of(item: Item, name: str, value: Formula, more: Sequence[Equality] = ()) -> list[Equality]:
    """The line of an elimination; `more` stands before its result."""
    chain = []
    if item.sources and isolated(item, name) is None:
        chain.append(Equality(item.left, item.right))
    elif item.sources and isolated(item, name) != value:
        chain.append(Equality(Symbol(name), isolated(item, name) or value))
    chain.extend(more)
    result = Equality(Symbol(name), value)
    if not chain or chain[-1] != result:
        chain.append(result)
    return chain


def line_in_letters(item: Item, name: str, first: Sequence[Equality], final: Formula) -> list[Equality]:
    """A line whose `first` equalities are in letters found before, and whose last has them put in."""
    chain = [equality for k, equality in enumerate(first) if k == 0 or equality != first[k - 1]]
    if isolated(item, name) is None and any(ref[0] != "known" for ref in item.sources):
        chain.insert(0, Equality(item.left, item.right))
    return [*chain, Equality(Symbol(name), final)]
