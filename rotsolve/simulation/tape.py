"""Tape of a motion: sums as linear combinations, products with their numbers in front, functions with their rates, unknowns of equations.

So what cancels is gone, and the least is left to be run as power series in time (`series`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from typing import Any

from msgspec import Struct, field

from rotsolve.algebra.flints import arb, fmpq
from rotsolve.algebra.formula import Formula
from rotsolve.algebra.tape import MOST, ONE, ZERO, Exact, Operation, Tape, Unwritable, flint_fraction

Scalar = Any  # float or arb


class Block(Struct, frozen=True):
    """Linear equations Σ rows[i][j] x[j] = right[i] whose coefficients change with the motion, solved at every moment anew."""

    rows: tuple[tuple[int, ...], ...]
    right: tuple[int, ...]


class SeriesTape(Tape):
    """A tape of what changes in time.

    Beside 'number' and 'letter' it has 'sum' c + Σ cᵢ xᵢ; 'times' x y; 'over' x/y; 'power' x^c; 'abs' x; 'sin' and 'cos' of x, one after
    the other; 'atan2' of y, x and x² + y²; 'exp', 'log', 'atan', 'asin', 'acos' of x, whose rate is that of x times the second value;
    'unknown' number c of a block.
    """

    blocks: list[Block] = field(default_factory=list)

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

    def total(self, terms: Iterable[Formula], place: Callable[[Formula], int]) -> int:
        return self.add(*map(place, terms))

    def negative(self, value: int) -> int:
        return self.scaled(value, -ONE)

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

    def raised(self, base: int, exponent: int) -> int:
        number = self.constant(exponent)
        if not isinstance(number, fmpq):
            raise Unwritable("a formula of this kind")
        return self.power(base, Fraction(int(number.p), int(number.q)))

    def power(self, base: int, exponent: Fraction) -> int:
        """base^exponent: small whole powers by multiplication."""
        number = self.constant(base)
        if number is not None:
            return self.number(number_to(number, exponent))
        if exponent < 0:
            return self.over(self.number(ONE), self.power(base, -exponent))
        if exponent.denominator == 1 and exponent <= MOST:
            return self.whole_power(base, exponent.numerator)
        return self.write(Operation("power", (base,), (flint_fraction(exponent),)))

    def function(self, name: str, *arguments: int) -> int:
        """A function of values, with what its power series takes; of constants a constant."""
        numbers = [self.constant(argument) for argument in arguments]
        if name == "atan2" and all(number is not None for number in numbers):
            return self.number(arb.atan2(*map(arb, numbers)))
        if name == "atan2":
            y, x = arguments
            return self.write(Operation("atan2", (y, x, self.add(self.times(x, x), self.times(y, y)))))
        if len(arguments) > 1:
            raise Unwritable("a formula of this kind")
        (argument,), (number,) = arguments, numbers
        if number is not None:
            return self.number(function_value(name, number))
        if name == "sqrt":
            return self.power(argument, Fraction(1, 2))
        if name == "tan":
            return self.over(self.function("sin", argument), self.function("cos", argument))
        if name in ("sin", "cos"):  # always both, each the rate of the other
            return {word: self.write(Operation(word, (argument,))) for word in ("sin", "cos")}[name]
        if name in ("abs", "exp"):
            return self.write(Operation(name, (argument,)))
        return self.write(Operation(name, (argument, self._rate(name, argument))))

    def _rate(self, name: str, x: int) -> int:
        """The derivative of a function: 1/x, 1/(1 + x²), ±1/√(1 − x²)."""
        one = self.number(ONE)
        if name == "log":
            return self.over(one, x)
        if name == "atan":
            return self.over(one, self.add(one, self.times(x, x)))
        if name in ("asin", "acos"):
            root = self.power(self.sum([(one, ONE), (self.times(x, x), -ONE)]), Fraction(1, 2))
            return self.over(one if name == "asin" else self.number(-ONE), root)
        raise Unwritable(f"`{name}` of what changes in time")

    def unknowns(self, block: Block) -> list[int]:
        """The unknowns of linear equations as values."""
        if block not in self.blocks:
            self.blocks.append(block)
        name = str(self.blocks.index(block))
        held = tuple(dict.fromkeys(value for row in (*block.rows, block.right) for value in row))
        return [self.write(Operation("unknown", held, (fmpq(k),), name)) for k in range(len(block.right))]

    def unknowns_of(self, name: str) -> list[int]:
        """The places of the unknowns of a block, in their order."""
        own = [place for place, item in enumerate(self.operations) if (item.kind, item.name) == ("unknown", name)]
        return sorted(own, key=lambda place: int(self.operations[place].numbers[0].p))

    def needed(self, wanted: Iterable[int]) -> list[int]:
        """All places on which the wanted values rest, in order; a sine comes with its cosine, an unknown with all of its block."""
        found: set[int] = set()
        pending = list(wanted)
        while pending:
            place = pending.pop()
            if place not in found:
                found.add(place)
                operation = self.operations[place]
                pending += operation.values
                if operation.kind in ("sin", "cos"):
                    pending.append(place + 1 if operation.kind == "sin" else place - 1)
                if operation.kind == "unknown":
                    pending += self.unknowns_of(operation.name)
        return sorted(found)

    def letters_under(self, *places: int) -> set[str]:
        """The letters on which values rest."""
        found = (self.operations[place] for place in self.needed(places))
        return {operation.name for operation in found if operation.kind == "letter"}


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
    return ball.sqrt() ** exponent.numerator if exponent.denominator == 2 else ball ** arb(flint_fraction(exponent))


def function_value(name: str, number: Exact) -> Exact:
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
