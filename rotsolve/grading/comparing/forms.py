"""Forms: whether two formulas are one, by polynomials that are laid out once for a reference.

A formula q √p, with q and p rational in the letters and in the sines and cosines of letters, is compared by q and p themselves: two such
are equal where q₁² p₁ = q₂² p₂ and the signs of q₁ and q₂ agree.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from fractions import Fraction
from itertools import pairwise
from math import ceil, comb, prod

from rotsolve.algebra.exact.field import RADICALS, TRIG, Field, PolynomialSigns, Ratio, is_integer_power
from rotsolve.algebra.formula import (
    FUNCTIONS,
    PI,
    Call,
    Formula,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
)

LETTERED = tuple(FUNCTIONS.keys() - set(RADICALS))
HUGE = 10**9  # beyond this nobody counts terms
NESTED = 8  # times that a term is worked with in a root within a root
Rooted = tuple[Ratio, Ratio]  # q and p of q √p


class Beyond(ValueError):
    """The formula is not of this form, or has what the reference has not."""


class Yardstick:
    """A reference in the form q √p, with the field in which formulas are held against it.

    Other functions, as arccos(1 − x), stand in the field as letters; the same function of an equal argument is the same letter.
    """

    def __init__(
        self,
        reference: Formula,
        letters: Iterable[str],
        positive: Collection[str],
        ranks: Iterable[Sequence[str]] = (),
    ) -> None:
        found: dict[Call, Symbol] = {}
        reference = _with_letters(reference, lambda call: found.setdefault(call, Symbol(f"#{len(found)}")))
        atoms = [node for node in reference.walk(*TRIG) if isinstance(node, Call) and node.function in TRIG]
        self.field = Field([*atoms, PI, *(Symbol(name) for name in letters), *found.values()])
        calls = found.items()  # inner ones come first
        self.calls = [(call.function, self._arguments(call), symbol) for call, symbol in calls]
        self.signs = PolynomialSigns(self.field, positive)
        self.steps = list(self.field.gens)  # each letter of a rank as the one below it and a positive step
        for ranked in ranks:
            for lower, higher in pairwise(self.field.index[Symbol(name)] for name in ranked):
                self.steps[higher] = self.steps[lower] + self.field.gens[higher]
        self.own = self.rooted(reference)

    def equals(self, formula: Formula) -> bool | None:
        """Whether the formula is the reference; None where only the whole exact layer can tell."""
        try:
            found = self._compared(self.rooted(_with_letters(formula, self._letter)))
        except (ValueError, ArithmeticError):
            return None
        return None if found is False and self.calls else found  # letters for functions may depend on each other

    def _compared(self, rooted: Rooted) -> bool | None:
        (q, p), (own_q, own_p) = rooted, self.own
        if self._same(p, own_p):
            return self._same(q, own_q)
        if not self._same(self._times(self._times(q, q), p), self._times(self._times(own_q, own_q), own_p)):
            return False
        above, below = self._times(q, own_q)
        ranked = (above * below).compose(*self.steps, ctx=self.field.context)
        return True if self.signs.nonnegative(ranked) else None

    def _letter(self, call: Call) -> Symbol:
        """The letter of a function that the reference has too."""
        arguments = self._arguments(call)
        for function, own, symbol in self.calls:
            if function == call.function and all(map(self._same, arguments, own)):
                return symbol
        raise Beyond

    def _arguments(self, call: Call) -> list[Ratio]:
        return [self._rational(argument) for argument in call.arguments]

    def rooted(self, node: Formula) -> Rooted:
        """q and p of a formula q √p."""
        one = self.field.one, self.field.one
        if not _has_root(node):
            return self.field.convert(node), one
        if isinstance(node, Call) and node.function in RADICALS:
            inner = self._rational(node.arguments[0])
            return one, inner if node.function == "sqrt" else self._times(inner, inner)  # |x| = √(x²)
        if isinstance(node, Negative):
            q, p = self.rooted(node.operand)
            return (-q[0], q[1]), p
        if isinstance(node, Product):
            return self._product(node.factors)
        if isinstance(node, Quotient):
            (q, p), (below, root) = self.rooted(node.numerator), self.rooted(node.denominator)
            self.field.check_divisor(below[0])
            self.field.check_divisor(root[0])
            return self._times(q, below[::-1]), self._times(p, root[::-1])
        if isinstance(node, Power) and isinstance(node.exponent, Number):
            return self._power(node.base, node.exponent.value)
        raise Beyond

    def _product(self, factors: tuple[Formula, ...]) -> Rooted:
        q, p = self.rooted(factors[0])
        for factor in factors[1:]:
            more_q, more_p = self.rooted(factor)
            q, p = self._times(q, more_q), self._times(p, more_p)
        return q, p

    def _power(self, base: Formula, exponent: Fraction) -> Rooted:
        """(q √p)ⁿ, or b^(n/2) as b^((n−1)/2) √b."""
        if exponent.denominator == 1:
            (q, p), n = self.rooted(base), exponent.numerator
            half, odd = divmod(n, 2)
            whole = self._times(self._raised(q, n), self._raised(p, half))
            return whole, p if odd else (self.field.one, self.field.one)
        if exponent.denominator != 2:
            raise Beyond
        value = self._rational(base)
        return self._raised(value, (exponent.numerator - 1) // 2), value

    def _rational(self, node: Formula) -> Ratio:
        if _has_root(node):
            raise Beyond
        return self.field.convert(node)

    def _raised(self, ratio: Ratio, n: int) -> Ratio:
        if n < 0:
            self.field.check_divisor(ratio[0])
            ratio, n = ratio[::-1], -n
        return ratio[0] ** n, ratio[1] ** n

    @staticmethod
    def _times(left: Ratio, right: Ratio) -> Ratio:
        return left[0] * right[0], left[1] * right[1]

    def _same(self, left: Ratio, right: Ratio) -> bool:
        return not len(self.field.reduce(left[0] * right[1] - right[0] * left[1]))


def _with_letters(formula: Formula, letter: Callable[[Call], Symbol]) -> Formula:
    """The formula with letters for functions that are no roots and no sine or cosine of a letter; tan x is sin x/cos x."""

    def change(node: Formula) -> Formula:
        if not isinstance(node, Call) or node.function in RADICALS:
            return node
        if isinstance(node.arguments[0], Symbol) and node.function in (*TRIG, "tan"):
            return node if node.function in TRIG else Quotient(*(Call(name, node.arguments) for name in TRIG))
        return letter(node)

    return formula.transform(change, *LETTERED)


def _has_root(node: Formula) -> bool:
    return node.holds(*RADICALS) or any(
        not is_integer_power(power) for power in node.walk(Power) if isinstance(power, Power)
    )


def term_count(node: Formula) -> int:
    """About how many terms the exact layer works with: those of the formula multiplied out, and more of them within functions."""
    return sum(_term_counts(node))


def _term_counts(node: Formula) -> tuple[int, int]:
    """Bounds on the terms of the numerator and of the denominator."""
    if isinstance(node, (Number, Symbol)):
        return 1, 1
    above, below = 1, 1
    if isinstance(node, (Sum, Product)):
        parts = [_term_counts(child) for child in node.children()]
        below = prod([part[1] for part in parts])
        counts = [above * (below // under if isinstance(node, Sum) else 1) for above, under in parts]
        above = sum(counts) if isinstance(node, Sum) else prod(counts)
    elif isinstance(node, Quotient):
        (above, below), (over, under) = _term_counts(node.numerator), _term_counts(node.denominator)
        above, below = above * under, below * over
    elif isinstance(node, Power) and isinstance(node.exponent, Number):
        n, (above, below) = ceil(abs(node.exponent.value)), _term_counts(node.base)
        above, below = (comb(count + n - 1, n) if count > 1 else 1 for count in (above, below))
    elif isinstance(node, Negative):
        above, below = _term_counts(node.operand)
    else:
        within = isinstance(node, Call) and node.function in RADICALS and node.arguments[0].holds(*RADICALS)
        above += (NESTED if within else 1) * sum([sum(_term_counts(child)) for child in node.children()])
    return min(above, HUGE), min(below, HUGE)
