"""Balls: a formula over real balls (arb) and complex balls (acb), at the precision that is set."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from operator import add, mul
from typing import Any

from msgspec.structs import replace

from rotsolve.algebra.effort import exert
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.flints import arb, fmpz
from rotsolve.algebra.formula import (
    ELLIPTIC,
    Call,
    Constant,
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
)

Ball = Any  # flint's arb or acb
Values = Mapping[str, Formula | Fraction | int]
# the parts of an integrand by their identities, each with what it is at all places, None where it hangs on the place
Steady = dict[int, tuple[Formula, Ball | None]]

PARTS_A_STEP = 120  # of an integrand, each as often as it is evaluated


class Undefined(ValueError):
    """The formula has no real value there; says why in words."""


def with_values(f: Formula, values: Values) -> Formula:
    """The formula with all values put in, also values that are formulas of other values."""
    known = {name: formula(value) for name, value in values.items()}
    for _ in range(len(known) + 1):
        names = f.symbols() & known.keys()
        if not names:
            return f
        f = f.substitute({name: known[name] for name in names})
    raise Undefined("a value refers to itself")


def rational_ball(node: Number) -> Ball:
    """A rational number as a ball."""
    value = node.value
    if value.denominator == 1:
        return arb(value.numerator)
    return arb(fmpz(value.numerator)) / fmpz(value.denominator)


def whole_power(base: Ball, n: int) -> Ball:
    """baseⁿ; around zero by multiplication, where flint's own power gives no number."""
    if not base.contains(0):
        return base**n
    result, square = arb(1), base
    while n:
        result = result * square if n & 1 else result
        square, n = square * square, n >> 1
    return result


def _arc_within(function: str, x: Ball) -> Ball:
    """arcsin or arccos of what lies of a ball within ±1: rises or falls between its ends, which a ball of both would stick out of."""
    low = arb(-1) if x.lower() < -1 else x.lower()
    high = arb(1) if x.upper() > 1 else x.upper()
    return low.asin().union(high.asin()) if function == "asin" else low.acos().union(high.acos())


class RealBalls:
    """Evaluates formulas over arb; `is_zero` decides borderline arguments exactly, `clip` cuts intervals to the domain."""

    def __init__(
        self,
        values: Mapping[str, Formula],
        *,
        bound: Mapping[str, Ball] | None = None,
        is_zero: Callable[[Formula], bool] | None = None,
        clip: bool = False,
    ) -> None:
        self.values = values
        self.memo: dict[str, Ball] = dict(bound or {})
        self.calls: dict[Call, Ball] = {}  # a closed form holds the same ones many times
        self.open: set[str] = set()
        self.worked = 0  # parts of integrands that have been evaluated and are not yet counted as steps
        self.steady: dict[str, Steady] = {}  # by the letter that is not
        self.is_zero = is_zero
        self.clip = clip

    def __call__(self, node: Formula) -> Ball:
        return _REAL[type(node)](self, node)

    def symbol(self, node: Symbol) -> Ball:
        found = self.memo.get(node.name)
        if found is None:
            if node.name not in self.values:
                raise Undefined(f"{node.name} has no value")
            if node.name in self.open:
                raise Undefined(f"the value of {node.name} refers to itself")
            self.open.add(node.name)
            found = self.memo[node.name] = self(self.values[node.name])
        return found

    def sum(self, node: Sum) -> Ball:
        return reduce(add, map(self, node.terms))

    def product(self, node: Product) -> Ball:
        return reduce(mul, map(self, node.factors))

    def quotient(self, node: Quotient) -> Ball:
        return self(node.numerator) / self._divisor(node.denominator)

    def _divisor(self, node: Formula) -> Ball:
        below = self(node)
        if below.is_zero() or (self.is_zero and below.contains(0) and self.is_zero(node)):
            raise Undefined("division by zero")
        return below

    def power(self, node: Power) -> Ball:
        if isinstance(node.exponent, Number) and node.exponent.value.denominator == 1:
            n = node.exponent.value.numerator
            return whole_power(self(node.base), n) if n >= 0 else 1 / self._divisor(node.base) ** -n
        base, exponent = self(node.base), self(node.exponent)
        if base < 0:
            raise Undefined("a fractional power of a negative number")
        return base**exponent

    def call(self, node: Call) -> Ball:
        found = self.calls.get(node)
        if found is None:
            found = self.calls[node] = self._call(node)
        return found

    def _call(self, node: Call) -> Ball:
        name = node.function
        x = self(node.arguments[0])
        if name in ("sin", "cos", "exp", "atan", "tan"):
            return getattr(x, name)()
        if name == "abs":
            return abs(x)
        if name == "sqrt":
            return self._sqrt(node, x)
        if name == "log":
            if x <= 0:
                raise Undefined("the logarithm of a number that is not positive")
            return x.log()
        if name == "atan2":
            return self._atan2(node, x, self(node.arguments[1]))
        if name == "ellipk":
            if x >= 1:
                raise Undefined("the elliptic integral K of 1 or more")
            from rotsolve.algebra.flints import acb

            return acb(x).elliptic_k().real
        if name in ELLIPTIC:
            return self._elliptic(node, x, *map(self, node.arguments[1:]))
        return self._arc(node, x)

    def _elliptic(self, node: Call, *arguments: Ball) -> Ball:
        """sn, cn, dn, am, F and Π, of a parameter that is exactly 0 or 1 too."""
        from rotsolve.algebra.certified.elliptic import OF_PARAMETER

        *first, m = arguments
        end = next((end for end in (0, 1) if m.contains(end) and not m.is_exact()), None)
        if end is not None and self.is_zero and self.is_zero(node.arguments[-1] - end):
            m = arb(end)
        if m < 0 or m > 1:
            raise Undefined(f"an elliptic function of a parameter that is {'negative' if m < 0 else 'above 1'}")
        return OF_PARAMETER[node.function](*first, m)

    def _sqrt(self, node: Call, x: Ball) -> Ball:
        if x < 0:
            raise Undefined("the square root of a negative number")
        if not x >= 0:
            if self.clip:
                return x.nonnegative_part().sqrt()
            if self.is_zero and self.is_zero(node.arguments[0]):
                return arb(0)
        return x.sqrt()

    def _arc(self, node: Call, x: Ball) -> Ball:
        if abs(x) > 1:
            raise Undefined(f"{node.function} of a number beyond 1")
        if not abs(x) <= 1:
            if self.clip:
                return _arc_within(node.function, x)
            if self.is_zero and self.is_zero(node.arguments[0] ** 2 - 1):  # its square: a root over all needs no sign
                x = arb(1 if x > 0 else -1)
        return x.asin() if node.function == "asin" else x.acos()

    def _atan2(self, node: Call, y: Ball, x: Ball) -> Ball:
        if self.is_zero:
            y = arb(0) if y.contains(0) and self.is_zero(node.arguments[0]) else y
            x = arb(0) if x.contains(0) and self.is_zero(node.arguments[1]) else x
        if y.is_zero() and x.is_zero():
            raise Undefined("atan2(0, 0)")
        return arb.atan2(y, x)

    def integral(self, node: Integral) -> Ball:
        exert(1)
        from rotsolve.algebra.certified.turning import integral_to_rest

        turning = integral_to_rest(node, self)
        if turning is not None:
            return turning
        lower, upper = self(node.lower), self(node.upper)
        if node.integrand.holds("abs") and node.integrand != (signed := self.without_size(node, lower, upper)):
            return self(replace(node, integrand=signed)) if signed is not None else arb.nan()
        from rotsolve.algebra.certified.complexballs import certified_integral

        return certified_integral(node, lower, upper, self)

    def work(self, parts: int) -> None:
        """Count the parts of an integrand at one of its places: one that does not converge is not gone on with for long."""
        self.worked += parts
        if self.worked >= PARTS_A_STEP:
            steps, self.worked = divmod(self.worked, PARTS_A_STEP)
            exert(steps)

    def without_size(self, node: Integral, lower: Ball, upper: Ball) -> Formula | None:
        """The integrand with ±x for |x|, at whose kink no rule for smooth ones gets past; None where the sign of x may change."""
        x = Symbol(node.variable)
        size = Call("abs", (x,))
        sign = 1 if lower >= 0 and upper >= 0 else -1 if lower <= 0 and upper <= 0 else 0
        if not sign:
            return None if any(part == size for part in node.integrand.walk("abs")) else node.integrand
        return node.integrand.transform(lambda part: (x if sign == 1 else Negative(x)) if part == size else part, "abs")

    def vanishes(self, value: Formula) -> bool:
        """Whether a value is exactly zero."""
        try:
            ball = self(value)
            return bool(ball.is_finite() and ball.contains(0)) and is_zero(with_values(value, self.values))
        except (Undefined, ZeroDivisionError):
            return False

    def over(self, letter: str, place: Ball, node: Formula) -> Ball:
        """The complex ball of a formula where a letter has one."""
        from rotsolve.algebra.certified.complexballs import ComplexBalls

        return ComplexBalls(self, {letter: place}, False, self.steady.setdefault(letter, Steady()))(node)


_REAL: dict[type[Formula], Callable[[RealBalls, Any], Ball]] = {
    Number: lambda self, node: rational_ball(node),
    Symbol: RealBalls.symbol,
    Constant: lambda self, node: arb.pi(),
    Sum: RealBalls.sum,
    Product: RealBalls.product,
    Quotient: RealBalls.quotient,
    Negative: lambda self, node: -self(node.operand),
    Power: RealBalls.power,
    Call: RealBalls.call,
    Integral: RealBalls.integral,
}
