"""Formula: a small immutable expression tree that keeps what was written, in the order in which it was written.

A formula is data only: nothing here simplifies beyond the trivial (x + 0, 1 x, 0 x, −(−x)), so that `m g − T` stays `m g − T`.
The normal form lives in `exact`, numbers in `ball`, printed text in `text`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from functools import reduce
from typing import Any

from msgspec import Struct

FUNCTIONS = {  # name -> number of arguments
    **dict.fromkeys(("sqrt", "sin", "cos", "tan", "asin", "acos", "atan"), 1),
    "atan2": 2,
    **dict.fromkeys(("exp", "log", "abs"), 1),
    "ellipk": 1,  # K(m) = ∫ dφ/√(1 − m sin²φ) over a quarter turn, the complete elliptic integral of the first kind
    "ellipf": 2,  # F(φ, m), the same from 0 to φ
    "ellippi": 2,  # Π(n, m) = ∫ dφ/((1 − n sin²φ) √(1 − m sin²φ)) over a quarter turn, the complete one of the third kind
    "ellippiinc": 3,  # Π(n, φ, m), the same from 0 to φ
    **dict.fromkeys(
        ("ellipsn", "ellipcn", "ellipdn"), 2
    ),  # of u and m: sin φ, cos φ and √(1 − m sin²φ) where u = F(φ, m)
    "ellipam": 2,  # of u and m: that φ
}
ELLIPTIC = {
    "ellipk": "K",
    "ellipf": "F",
    "ellippi": "Π",
    "ellippiinc": "Π",
    "ellipsn": "sn",
    "ellipcn": "cn",
    "ellipdn": "dn",
    "ellipam": "am",
}  # as they are printed


def united(sets: Iterable[frozenset[Any]]) -> frozenset[Any]:
    """The union of some sets; where one holds all the others, that one."""
    whole: frozenset[Any] = frozenset()
    for one in sets:
        if not one <= whole:
            whole = one if whole <= one else whole | one
    return whole


class Formula(Struct, frozen=True, dict=True, cache_hash=True):
    """Base of all nodes; operators build trees and drop only trivial zeros and ones.

    A node remembers its hash, its free symbols and what occurs in it, so that equal parts and parts without a letter are cheap.
    """

    def children(self) -> tuple[Formula, ...]:
        return ()

    def with_children(self, children: tuple[Formula, ...]) -> Formula:
        return self

    def __add__(self, other: Formula | int | Fraction) -> Formula:
        return add(self, formula(other))

    def __radd__(self, other: Formula | int | Fraction) -> Formula:
        return add(formula(other), self)

    def __sub__(self, other: Formula | int | Fraction) -> Formula:
        return add(self, negate(formula(other)))

    def __rsub__(self, other: Formula | int | Fraction) -> Formula:
        return add(formula(other), negate(self))

    def __mul__(self, other: Formula | int | Fraction) -> Formula:
        return multiply(self, formula(other))

    def __rmul__(self, other: Formula | int | Fraction) -> Formula:
        return multiply(formula(other), self)

    def __truediv__(self, other: Formula | int | Fraction) -> Formula:
        return divide(self, formula(other))

    def __rtruediv__(self, other: Formula | int | Fraction) -> Formula:
        return divide(formula(other), self)

    def __pow__(self, other: Formula | int | Fraction) -> Formula:
        exponent = formula(other)
        power = exponent.value if isinstance(exponent, Number) else 0
        if power == 1 or (isinstance(self, Number) and self.value in (0, 1) and power > 0):
            return self
        if power == 2:  # (−x)² = x², (√x)² = x
            base = self.operand if isinstance(self, Negative) else self
            return base.arguments[0] if isinstance(base, Call) and base.function == "sqrt" else Power(base, exponent)
        return Power(self, exponent)

    def __neg__(self) -> Formula:
        return negate(self)

    def walk(self, *within: str | type[Formula]) -> Iterator[Formula]:
        """Every node of the tree, this one first; only those that hold what is named, where it is."""
        stack: list[Formula] = [self]
        while stack:
            node = stack.pop()
            if not within or node.holds(*within):
                yield node
                stack.extend(reversed(node.children()))

    def symbols(self) -> frozenset[str]:
        """Names of the free symbols (a variable of integration is bound, hence not among them)."""
        try:
            names: frozenset[str] = self.__dict__["names"]
        except KeyError:
            names = self.__dict__["names"] = self._symbols()
        return names

    def _symbols(self) -> frozenset[str]:
        return united([child.symbols() for child in self.children()])

    def holds(self, *wanted: str | type[Formula]) -> bool:
        """Whether one of some functions, by its name, or nodes of some kind occur in the tree."""
        return not self._contents().isdisjoint(wanted)

    def _contents(self) -> frozenset[str | type[Formula]]:
        """The functions and the kinds of nodes in the tree."""
        try:
            contents: frozenset[str | type[Formula]] = self.__dict__["contents"]
        except KeyError:
            own = (type(self), self.function) if isinstance(self, Call) else (type(self),)
            contents = united([*[child._contents() for child in self.children()], frozenset(own)])
            self.__dict__["contents"] = contents
        return contents

    def substitute(self, values: Mapping[str, Formula]) -> Formula:
        """The same formula with symbols replaced; trivial zeros and ones that this makes are dropped."""
        return self if self.symbols().isdisjoint(values) else self._substitute(values)

    def _substitute(self, values: Mapping[str, Formula]) -> Formula:
        return self.with_children(tuple([child.substitute(values) for child in self.children()]))

    def transform(self, change: Callable[[Formula], Formula], *within: str | type[Formula]) -> Formula:
        """Rebuild bottom-up, passing every node through `change`, or only those that hold what is named; unchanged parts keep
        their written form."""
        if within and not self.holds(*within):
            return self
        old = self.children()
        if not old:
            return change(self)
        new = tuple([child.transform(change, *within) for child in old])
        for before, after in zip(old, new, strict=True):
            if before is not after:
                return change(self.with_children(new))
        return change(self)


class Number(Formula, frozen=True):
    """An exact rational number."""

    value: Fraction


class Symbol(Formula, frozen=True):
    """A letter, by its ASCII name as in the scene: `m1`, `theta0`, `a_end`."""

    name: str

    def _symbols(self) -> frozenset[str]:
        return frozenset((self.name,))

    def _substitute(self, values: Mapping[str, Formula]) -> Formula:
        return values[self.name]


class Decimal(Symbol, frozen=True):
    """A number that stands for a letter where a formula is printed with numbers put in, by its text: 0.8660. Nothing calculates with it."""


class Constant(Formula, frozen=True):
    """A mathematical constant; only `pi`."""

    name: str


class Sum(Formula, frozen=True):
    """terms[0] + terms[1] + …; a difference is a sum with a `Negative` term."""

    terms: tuple[Formula, ...]

    def children(self) -> tuple[Formula, ...]:
        return self.terms

    def with_children(self, children: tuple[Formula, ...]) -> Formula:
        return reduce(add, children)


class Product(Formula, frozen=True):
    """factors[0] · factors[1] · …"""

    factors: tuple[Formula, ...]

    def children(self) -> tuple[Formula, ...]:
        return self.factors

    def with_children(self, children: tuple[Formula, ...]) -> Formula:
        return reduce(multiply, children)


class Quotient(Formula, frozen=True):
    """numerator / denominator."""

    numerator: Formula
    denominator: Formula

    def children(self) -> tuple[Formula, ...]:
        return (self.numerator, self.denominator)

    def with_children(self, children: tuple[Formula, ...]) -> Formula:
        return divide(children[0], children[1])


class Power(Formula, frozen=True):
    """base ^ exponent."""

    base: Formula
    exponent: Formula

    def children(self) -> tuple[Formula, ...]:
        return (self.base, self.exponent)

    def with_children(self, children: tuple[Formula, ...]) -> Formula:
        return children[0] ** children[1]


class Negative(Formula, frozen=True):
    """− operand."""

    operand: Formula

    def children(self) -> tuple[Formula, ...]:
        return (self.operand,)

    def with_children(self, children: tuple[Formula, ...]) -> Formula:
        return negate(children[0])


class Call(Formula, frozen=True):
    """function(arguments…); the functions are those of `FUNCTIONS`."""

    function: str
    arguments: tuple[Formula, ...]

    def children(self) -> tuple[Formula, ...]:
        return self.arguments

    def with_children(self, children: tuple[Formula, ...]) -> Formula:
        return Call(self.function, children)


class Integral(Formula, frozen=True):
    """∫ integrand d(variable) from lower to upper, not yet carried out."""

    integrand: Formula
    variable: str
    lower: Formula
    upper: Formula

    def children(self) -> tuple[Formula, ...]:
        return (self.integrand, self.lower, self.upper)

    def with_children(self, children: tuple[Formula, ...]) -> Formula:
        return Integral(children[0], self.variable, children[1], children[2])

    def _symbols(self) -> frozenset[str]:
        return united([self.integrand.symbols() - {self.variable}, self.lower.symbols(), self.upper.symbols()])

    def _substitute(self, values: Mapping[str, Formula]) -> Formula:
        inside = {name: value for name, value in values.items() if name != self.variable}
        lower, upper = self.lower.substitute(values), self.upper.substitute(values)
        return Integral(self.integrand.substitute(inside), self.variable, lower, upper)


ZERO = Number(Fraction(0))
ONE = Number(Fraction(1))
HALF = Number(Fraction(1, 2))
PI = Constant("pi")


def formula(value: Formula | int | Fraction) -> Formula:
    """`value` as a formula; numbers must be exact, so a float is refused."""
    if isinstance(value, Formula):
        return value
    if isinstance(value, (int, Fraction)):
        return Number(Fraction(value))
    raise TypeError(f"not an exact number: {value!r}")


def add(left: Formula, right: Formula) -> Formula:
    """left + right, one flat sum."""
    if isinstance(left, Number):
        if not left.value:
            return right
        if isinstance(right, Number):
            return Number(left.value + right.value)
    elif isinstance(right, Number) and not right.value:
        return left
    terms = left.terms if isinstance(left, Sum) else (left,)
    return Sum((*terms, *(right.terms if isinstance(right, Sum) else (right,))))


def negate(operand: Formula) -> Formula:
    """− operand."""
    if isinstance(operand, Negative):
        return operand.operand
    if isinstance(operand, Number):
        return Number(-operand.value)
    if isinstance(operand, Sum):
        return Sum(tuple(negate(term) for term in operand.terms))
    return Negative(operand)


def multiply(left: Formula, right: Formula) -> Formula:
    """left · right, one flat product with the sign in front."""
    if isinstance(left, Number):
        if not left.value or (isinstance(right, Number) and not right.value):
            return ZERO
        if left.value == 1:
            return right
        if isinstance(right, Number):
            return left if right.value == 1 else Number(left.value * right.value)
    elif isinstance(right, Number):
        if not right.value:
            return ZERO
        if right.value == 1:
            return left
    if isinstance(left, Negative):
        return negate(multiply(left.operand, right))
    if isinstance(right, Negative):
        return negate(multiply(left, right.operand))
    if isinstance(right, Number):
        left, right = right, left
    if isinstance(left, Number) and left.value.numerator < 0:
        return negate(multiply(Number(-left.value), right))
    factors = left.factors if isinstance(left, Product) else (left,)
    more = right.factors if isinstance(right, Product) else (right,)
    if isinstance(factors[0], Number) and isinstance(more[0], Number):
        number = Number(factors[0].value * more[0].value)
        rest = (*factors[1:], *more[1:])
        factors, more = ((number,), rest) if number != ONE else ((), rest)
    elif isinstance(more[0], Number):
        factors, more = (more[0], *factors), more[1:]
    merged = (*factors, *more)
    return merged[0] if len(merged) == 1 else Product(merged)


def divide(numerator: Formula, denominator: Formula) -> Formula:
    """numerator / denominator."""
    if isinstance(denominator, Number) and denominator.value == 1:
        return numerator
    if isinstance(numerator, Number):
        if not numerator.value:
            return ZERO
        if isinstance(denominator, Number) and denominator.value:
            return Number(numerator.value / denominator.value)
    if isinstance(numerator, Negative):
        return negate(divide(numerator.operand, denominator))
    if isinstance(denominator, Negative):
        return negate(divide(numerator, denominator.operand))
    return Quotient(numerator, denominator)


def power(base: Formula, n: int) -> Formula:
    """base ^ n, as it stands."""
    return ONE if n == 0 else base if n == 1 else Power(base, Number(Fraction(n)))


def call(function: str, *arguments: Formula) -> Formula:
    """function(arguments…), arity checked."""
    if FUNCTIONS.get(function) != len(arguments):
        raise ValueError(f"{function} does not take {len(arguments)} arguments")
    return Call(function, tuple(arguments))


def sqrt(argument: Formula) -> Formula:
    return argument if argument in (ZERO, ONE) else Call("sqrt", (argument,))


def total(terms: list[Formula] | tuple[Formula, ...]) -> Formula:
    """The sum of all terms, ZERO where there are none."""
    flat: list[Formula] = []
    for term in terms:
        if isinstance(term, Sum):
            flat += term.terms
        elif isinstance(term, Number) and (not term.value or (len(flat) == 1 and isinstance(flat[0], Number))):
            flat = [add(flat[0], term)] if term.value else flat
        else:
            flat.append(term)
    return Sum(tuple(flat)) if len(flat) > 1 else flat[0] if flat else ZERO
