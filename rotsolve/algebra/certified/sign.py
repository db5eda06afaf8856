"""Signs: the one place where it is told which sign a formula has: by certified numbers, else by what is known of its letters.

What hangs on a sign is never guessed. A sign that numbers have told is noted, so that whoever puts other numbers into the answers
knows where they hold: every number that is looked at goes to the witness, what decided how a formula is made to `decided` too.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping

from msgspec import Struct, field

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.ball import Certified, evaluate, suppose
from rotsolve.algebra.certified.balls import Undefined, with_values
from rotsolve.algebra.exact.normal import Fractions, is_zero, simplify
from rotsolve.algebra.formula import ONE, ZERO, Call, Formula, Integral, Number, Symbol, negate

ACUTE = "acute"


class SignOracle(Struct, frozen=True):
    """What is known of the letters of a scene: the values of its givens, which are surely positive, and what limits the others.

    `limits` says `acute` of an angle from 0 to π/2 and another word of what is never negative; asked only where nothing else tells.
    """

    values: Mapping[str, Formula]
    positive: frozenset[str] = frozenset()
    limits: Callable[[], Mapping[str, str]] = dict  # nothing is known of any
    decided: dict[Formula, int] = field(default_factory=dict)  # the signs on which it hung how formulas are made
    trials: Mapping[str, Formula] = field(default_factory=dict)  # numbers of one case, for letters that have none
    integrals: dict[object, Formula | None] = field(default_factory=dict)  # carried out, as these signs would have it
    free: set[str] = field(
        default_factory=set
    )  # letters that stand for any value meanwhile, within no limits and in no case

    def decide(self, value: Formula) -> int | None:
        """−1, 0 or 1, on which it will hang how formulas are made; None where nothing tells the sign."""
        sign = self.sign(value)
        if sign is not None and value.symbols():
            self.decided[value] = sign
        return sign

    def sign(self, value: Formula) -> int | None:
        """−1, 0 or 1; None where neither numbers nor letters tell."""
        sign = self.by_numbers(value)
        return self.by_letters(value) if sign is None else sign

    def by_numbers(self, value: Formula) -> int | None:
        """The sign of the number that a formula has with the values of the givens; None where one lacks, or it is not real."""
        number = self.number(value)
        return None if number is None else number.sign

    def number(self, value: Formula) -> Certified | None:
        """The certified number itself; None where a letter has no value, or it is not real."""
        if self.lacking(value):
            return None
        try:
            return evaluate(value, self.values, digits=8)
        except (Undefined, ValueError, ZeroDivisionError):
            return None

    def unbarred(self, value: Formula) -> Formula:
        """A formula without the bars round what has a sign that is told: x for |x| where x > 0."""

        def change(node: Formula) -> Formula:
            if not isinstance(node, Call) or node.function != "abs":
                return node
            (inside,) = node.arguments
            sign = self.decide(inside)
            return inside * (sign or 0) if sign or inside == ZERO else node

        return value.transform(change, "abs")

    def taken(self, value: Formula) -> int | None:
        """The sign on which it will hang what is written: that which is sure, else that in the case that is looked at."""
        sign = self.decide(value)
        return self.side_at_trial(value) if sign is None else sign

    def supposed(self, value: Formula) -> Certified | None:
        """The number, of letters without one that in the case that is looked at: its sign is a condition of all that follows.

        So is it that the roots in it are real, or which is not.
        """
        value = self.with_asked(value)
        lacking = self.lacking(value)
        if not lacking:
            return self.number(value)
        if not self.trials.keys() >= set(lacking):
            return None  # of what is asked nothing is supposed
        for limit in real_where(value):
            if self.side_at_trial(limit) == -1:
                return None
        self.side_at_trial(value)
        return self.at_trial(value)

    def side_at_trial(self, value: Formula) -> int | None:
        """The sign of a formula in the case that is looked at, which is a condition of all that follows."""
        value = span_of_roots(self.with_asked(value))
        number = self.at_trial(value)
        if number is not None:
            suppose(value, number.sign or 0)
        return None if number is None else number.sign or 0

    def with_asked(self, value: Formula) -> Formula:
        """A formula with what is supposed of letters that are asked for, in the letters on which that hangs."""
        asked = {name: own for name, own in self.trials.items() if name in value.symbols() and own.symbols()}
        return value.substitute(asked) if asked else value

    def as_meant(self, value: Formula) -> int | None:
        """The sign where all letters without a number are positive, which is then supposed of them; None where that does not tell it."""
        acute = [name for name, limits in self.limits().items() if limits == ACUTE] if self.trials else []
        open_ = not self.free.isdisjoint(value.symbols())
        sign = sign_within(value, self.positive | self.trials.keys(), acute) if self.trials and not open_ else None
        if sign is not None:
            suppose(value, sign)
        return sign

    def at_trial(self, value: Formula) -> Certified | None:
        """The number of a formula in the case that is looked at."""
        if not self.free.isdisjoint(value.symbols()):
            return None
        try:
            return evaluate(value, {**self.values, **self.trials}, digits=8)
        except (Undefined, ValueError, ZeroDivisionError):
            return None

    def negative(self, value: Formula, roots: Mapping[str, Certified]) -> bool:
        """Whether a formula is certainly negative with the values and with certified roots."""
        try:
            return evaluate(value, self.values, roots=roots, digits=8).sign == -1
        except (Undefined, ValueError, ZeroDivisionError):
            return False

    def lacking(self, value: Formula) -> list[str]:
        """The letters of a formula that have no value, in order."""
        return sorted(value.symbols() - self.values.keys())

    def by_letters(self, value: Formula) -> int | None:
        """The sign as far as letters that are positive, or within limits, tell it: that which it has within them, not at their ends."""
        try:
            value = simplify(value, positive=self.positive)
        except ZeroDivisionError:  # has no value, as N/f with no friction
            return None
        if value == ZERO:
            return 0
        if not self.lacking(value):  # what lacks a value has cancelled out
            return self.by_numbers(value)
        sign = sign_within(value, self.positive)
        if sign is None:
            names = value.symbols() - self.free
            known = {name: limits for name, limits in self.limits().items() if name in names}
            acute = {name for name, limits in known.items() if limits == ACUTE}
            sign = sign_within(value, {*self.positive, *known}, acute) if known else None
        return sign

    def whatever_way(self, value: Formula) -> int | None:
        """The sign of what is the same for a letter and for that with a minus sign, as a² is: where none of these letters is 0."""
        value = simplify(value, positive=self.positive)
        even = [name for name in value.symbols() if is_zero(value - value.substitute({name: negate(Symbol(name))}))]
        return sign_within(value, self.positive | frozenset(even))

    def of_sizes(self, value: Formula) -> int | None:
        """The sign in the case that is looked at, else that where letters without a value stand for sizes of any kind, all positive."""
        sign = self.by_numbers(value)
        if sign is not None or not self.lacking(value):
            return sign
        if (sign := self.by_letters(value)) is not None or (sign := self.side_at_trial(value)) is not None:
            return sign
        value = simplify(with_values(value, self.values), positive=self.positive)
        acute = {name for name, limits in self.limits().items() if limits == ACUTE}
        sign = 0 if value == ZERO else sign_within(value, value.symbols(), acute)
        return self.of_powers(value) if sign is None else sign

    def of_powers(self, value: Formula) -> int | None:
        """The sign of c xⁿ yᵐ … for positive letters, that of c; xᵢ ∂v/∂xᵢ = nᵢ v tells such a formula from others."""
        names = self.lacking(value)
        degrees = [simplify(Symbol(name) * differentiate(value, name) / value) for name in names]
        if not all(isinstance(degree, Number) for degree in degrees):
            return None
        return self.by_numbers(value.substitute(dict.fromkeys(names, ONE)))


def span_of_roots(value: Formula) -> Formula:
    """How far an integral of a root goes, which has its sign, since no root is negative; all others as they are."""
    whole = simplify(value) if value.holds(Integral) else value
    if isinstance(whole, Integral) and isinstance(whole.integrand, Call) and whole.integrand.function == "sqrt":
        return whole.upper - whole.lower
    return value


def real_where(value: Formula) -> Iterator[Formula]:
    """What must not be negative for a formula to be real: what stands under roots and in logarithms, how far sines are from 1."""
    for node in value.walk(Call):
        if isinstance(node, Call) and node.function in ("sqrt", "log"):
            yield node.arguments[0]
        elif isinstance(node, Call) and node.function in ("asin", "acos"):
            yield ONE - node.arguments[0]
            yield ONE + node.arguments[0]


def sign_within(value: Formula, positive: Collection[str], acute: Collection[str] = ()) -> int | None:
    """The sign of a formula above and below the line, where positive letters and acute angles tell it."""
    from rotsolve.algebra.exact.field import PolynomialSigns

    problem = Fractions([value], positive=positive)
    parts = problem.field.cancel(problem.ratio())
    signs = PolynomialSigns(problem.field, positive, acute)
    found = [1 if signs.nonnegative(part) else -1 if signs.nonnegative(-part) else 0 for part in parts]
    return found[0] * found[1] or None
