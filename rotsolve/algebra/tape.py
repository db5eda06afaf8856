"""Tape: formulas as one list of operations, each value once: constants exact, sums as linear combinations of earlier values.

A tape is data: what a value is worth at a moment, or as a power series in time, is worked out by `series`.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from msgspec import Struct, field

from rotsolve.algebra.flints import arb, fmpq, fmpz
from rotsolve.algebra.formula import (
    Call,
    Constant,
    Formula,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
)

Scalar = Any  # float or arb
Exact = Any  # fmpq where the number is rational, else a narrow arb
BITS = 640  # at which constants that are not rational are worked out
CHAINED = ("exp", "log", "atan", "asin", "acos")  # their rate is that of the argument times another value of the tape
ZERO, ONE, HALF = fmpq(0), fmpq(1), fmpq(1, 2)


class Unwritable(ValueError):
    """A formula that has no power series here; says why in words."""


class Operation(Struct, frozen=True):
    """One value: `kind` of earlier values (their places on the tape), with exact `numbers`.

    'number' c; 'letter' name; 'sum' c + Σ cᵢ xᵢ; 'times' x y; 'over' x/y; 'power' x^c; 'sin', 'cos', 'abs' x; 'exp', 'log',
    'atan', 'asin', 'acos' of x, whose rate is that of x times the second value; 'unknown' number c of a `Block`.
    """

    kind: str
    values: tuple[int, ...] = ()
    numbers: tuple[Exact, ...] = ()
    name: str = ""


class Block(Struct, frozen=True):
    """Linear equations Σ rows[i][j] x[j] = right[i] whose coefficients change with the motion, solved at every moment anew."""

    rows: tuple[tuple[int, ...], ...]
    right: tuple[int, ...]


class Tape(Struct):
    """Operations in order; the same value is never written twice."""

    operations: list[Operation] = field(default_factory=list)
    blocks: list[Block] = field(default_factory=list)
    places: dict[Any, int] = field(default_factory=dict)

    def write(self, operation: Operation) -> int:
        """The place of a value, written at the end where it is new."""
        key = (operation.kind, operation.values, tuple(map(mark, operation.numbers)), operation.name)
        if key not in self.places:
            self.places[key] = len(self.operations)
            self.operations.append(operation)
        return self.places[key]

    def number(self, value: Exact) -> int:
        """A constant."""
        return self.write(Operation("number", (), (value,)))

    def letter(self, name: str) -> int:
        """What changes by itself: a number of the state, or time."""
        return self.write(Operation("letter", name=name))

    def constant(self, place: int) -> Exact | None:
        """The number that a value is, None where it changes."""
        operation = self.operations[place]
        return operation.numbers[0] if operation.kind == "number" else None

    def combination(self, place: int) -> tuple[Exact, dict[int, Exact]]:
        """A value as c + Σ cᵢ xᵢ."""
        operation = self.operations[place]
        if operation.kind == "number":
            return operation.numbers[0], {}
        if operation.kind == "sum":
            return operation.numbers[0], dict(zip(operation.values, operation.numbers[1:], strict=True))
        return ZERO, {place: ONE}

    def combined(self, constant: Exact, terms: Mapping[int, Exact]) -> int:
        """The value c + Σ cᵢ xᵢ, xᵢ no sums themselves."""
        kept = {place: factor for place, factor in sorted(terms.items()) if not vanishes(factor)}
        if not kept:
            return self.number(constant)
        if vanishes(constant) and list(kept.values()) == [ONE]:
            (place,) = kept
            return place
        return self.write(Operation("sum", tuple(kept), (constant, *kept.values())))

    def add(self, *values: int) -> int:
        return self.sum([(value, ONE) for value in values])

    def sum(self, weighted: list[tuple[int, Exact]]) -> int:
        """Σ weight · value."""
        constant: Exact = ZERO
        terms: dict[int, Exact] = {}
        for value, weight in weighted:
            own, parts = self.combination(value)
            constant = constant + weight * own
            for place, factor in parts.items():
                terms[place] = terms.get(place, ZERO) + weight * factor
        return self.combined(constant, terms)

    def scaled(self, value: int, factor: Exact) -> int:
        return self.sum([(value, factor)])

    def times(self, left: int, right: int) -> int:
        """The product, numbers drawn out in front."""
        front: Exact = ONE
        factors = []
        for value in (left, right):
            constant, terms = self.combination(value)
            if not terms:
                front = front * constant
            elif len(terms) == 1 and vanishes(constant):
                ((place, factor),) = terms.items()
                front = front * factor
                factors.append(place)
            else:
                factors.append(value)
        if len(factors) == 2:
            product = self.write(Operation("times", (min(factors), max(factors))))
            return self.scaled(product, front)
        return self.scaled(factors[0], front) if factors else self.number(front)

    def over(self, above: int, below: int) -> int:
        """The quotient; a constant divisor is a factor."""
        divisor = self.constant(below)
        if divisor is not None:
            if vanishes(divisor):
                raise Unwritable("division by zero")
            return self.scaled(above, 1 / divisor)
        constant, terms = self.combination(above)
        if len(terms) == 1 and vanishes(constant):
            ((place, factor),) = terms.items()
            return self.scaled(self.write(Operation("over", (place, below))), factor)
        return self.number(ZERO) if self.constant(above) == 0 else self.write(Operation("over", (above, below)))

    def power(self, base: int, exponent: Fraction) -> int:
        """base^exponent: small whole powers by multiplication."""
        number = self.constant(base)
        if number is not None:
            return self.number(number_to(number, exponent))
        if exponent < 0:
            return self.over(self.number(ONE), self.power(base, -exponent))
        if exponent.denominator == 1 and exponent <= 8:
            result = self.number(ONE)
            for _ in range(exponent.numerator):
                result = self.times(base, result)
            return result
        return self.write(Operation("power", (base,), (rational(exponent),)))

    def function(self, name: str, argument: int) -> int:
        """A function of one value."""
        number = self.constant(argument)
        if number is not None:
            return self.number(function_of(name, number))
        if name == "sqrt":
            return self.power(argument, Fraction(1, 2))
        if name == "tan":
            return self.over(self.function("sin", argument), self.function("cos", argument))
        if name in ("sin", "cos"):  # always both, each the rate of the other
            places = {word: self.write(Operation(word, (argument,))) for word in ("sin", "cos")}
            return places[name]
        if name == "abs":
            return self.write(Operation(name, (argument,)))
        if name == "exp":
            return self.write(Operation(name, (argument,)))
        if name == "log":
            return self.write(Operation(name, (argument, self.over(self.number(ONE), argument))))
        if name in CHAINED:
            square = self.times(argument, argument)
            if name == "atan":
                rate = self.over(self.number(ONE), self.add(self.number(ONE), square))
            else:
                root = self.power(self.sum([(self.number(ONE), ONE), (square, -ONE)]), Fraction(1, 2))
                rate = self.over(self.number(ONE if name == "asin" else -ONE), root)
            return self.write(Operation(name, (argument, rate)))
        raise Unwritable(f"`{name}` of what changes in time")

    def unknowns(self, block: Block) -> list[int]:
        """The unknowns of linear equations as values."""
        if block not in self.blocks:
            self.blocks.append(block)
        name = str(self.blocks.index(block))
        held = tuple(dict.fromkeys(value for row in (*block.rows, block.right) for value in row))
        return [self.write(Operation("unknown", held, (fmpq(k),), name)) for k in range(len(block.right))]

    def formula(self, node: Formula, letters: Mapping[str, int]) -> int:
        """A formula as a value; `letters` are the places of its letters."""
        match node:
            case Number(value):
                return self.number(rational(value))
            case Symbol(name):
                if name not in letters:
                    raise Unwritable(name)
                return letters[name]
            case Constant():
                return self.number(arb.pi())
            case Sum(terms):
                return self.add(*(self.formula(term, letters) for term in terms))
            case Negative(operand):
                return self.scaled(self.formula(operand, letters), -ONE)
            case Product(factors):
                result = self.formula(factors[0], letters)
                for factor in factors[1:]:
                    result = self.times(result, self.formula(factor, letters))
                return result
            case Quotient(above, below):
                return self.over(self.formula(above, letters), self.formula(below, letters))
            case Power(base, exponent):
                number = self.constant(self.formula(exponent, letters))
                if isinstance(number, fmpq):
                    return self.power(self.formula(base, letters), Fraction(int(number.p), int(number.q)))
            case Call(name, (argument,)):
                return self.function(name, self.formula(argument, letters))
            case Call("atan2", (above, below)):
                y, x = (self.constant(self.formula(part, letters)) for part in (above, below))
                if x is not None and y is not None:
                    return self.number(arb.atan2(arb(y), arb(x)))
        raise Unwritable("a formula of this kind")


def rational(value: Fraction) -> Exact:
    return fmpq(fmpz(value.numerator), fmpz(value.denominator))


def mark(number: Exact) -> tuple[int, int]:
    """What tells a number from others."""
    if isinstance(number, fmpq):
        return int(number.p), int(number.q)
    mantissa, exponent = number.mid().man_exp()
    return int(mantissa), -int(exponent)


def vanishes(number: Exact) -> bool:
    """Whether a constant is zero: one that is not rational is, when `BITS` bits do not tell it from zero."""
    return bool(number == 0) if isinstance(number, fmpq) else bool(number.contains(0))


def number_to(number: Exact, exponent: Fraction) -> Exact:
    """number^exponent."""
    if exponent.denominator == 1:
        if vanishes(number) and exponent < 0:
            raise Unwritable("division by zero")
        return number**exponent.numerator
    ball = arb(number)
    if ball < 0:
        raise Unwritable("the root of a negative number")
    return ball.sqrt() ** exponent.numerator if exponent.denominator == 2 else ball ** arb(rational(exponent))


def function_of(name: str, number: Exact) -> Exact:
    """A function of a constant."""
    if name == "abs":
        return abs(number)
    if number == 0 and name in ("sin", "cos", "tan", "exp"):
        return ZERO if name in ("sin", "tan") else ONE
    if name == "sqrt":
        return number_to(number, Fraction(1, 2))
    value = getattr(arb(number), name, None)
    if value is None:
        raise Unwritable(f"`{name}`")
    return value()
