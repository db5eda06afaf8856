"""Tape: formulas as one list of operations, each value once, with exact constants.

A tape is data. `arrays` runs it as it stands, over NumPy arrays or balls; that of `simulation` draws sums and products together, and is
run as power series in time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import reduce
from typing import Any

from msgspec import Struct, field

from rotsolve.algebra.flints import arb, fmpq, fmpz
from rotsolve.algebra.formula import Call, Constant, Formula, Negative, Number, Power, Product, Quotient, Sum, Symbol

Exact = Any  # fmpq where the number is rational, else a narrow arb
BITS = 640  # at which constants that are not rational are worked out
MOST = 64  # the highest whole power that is multiplied out
ZERO, ONE, HALF = fmpq(0), fmpq(1), fmpq(1, 2)


class Unwritable(ValueError):
    """A formula that has no place on a tape: says why in words; `letter` is one without a value."""

    def __init__(self, words: str, letter: str = "") -> None:
        super().__init__(words)
        self.letter = letter


class Operation(Struct, frozen=True):
    """One value: `kind` of earlier values (their places on the tape), with exact `numbers`.

    'number' c; 'letter' name; 'add', 'subtract', 'multiply', 'divide', 'power' of two values; 'negative'; a function by its name.
    """

    kind: str
    values: tuple[int, ...] = ()
    numbers: tuple[Exact, ...] = ()
    name: str = ""


class Tape(Struct):
    """Operations in order; the same value is never written twice."""

    operations: list[Operation] = field(default_factory=list)
    places: dict[Any, int] = field(default_factory=dict)

    def write(self, operation: Operation) -> int:
        """The place of a value, written at the end where it is new."""
        key = (operation.kind, operation.values, tuple(map(identity, operation.numbers)), operation.name)
        if key not in self.places:
            self.places[key] = len(self.operations)
            self.operations.append(operation)
        return self.places[key]

    def number(self, value: Exact) -> int:
        """A constant."""
        return self.write(Operation("number", (), (value,)))

    def letter(self, name: str) -> int:
        """What has no value yet: an input, a number of the state of motion, time."""
        return self.write(Operation("letter", name=name))

    def constant(self, place: int) -> Exact | None:
        """The number that a value is, None where it changes."""
        operation = self.operations[place]
        return operation.numbers[0] if operation.kind == "number" else None

    def formula(self, node: Formula, letters: Mapping[str, int], known: dict[Formula, int] | None = None) -> int:
        """A formula as a value; `letters` are the places of its letters, `known` those of formulas of the same letters."""
        found: dict[Formula, int] = {} if known is None else known

        def place(node: Formula) -> int:
            if node not in found:
                found[node] = self._formula(node, letters, place)
            return found[node]

        return place(node)

    def _formula(self, node: Formula, letters: Mapping[str, int], place: Callable[[Formula], int]) -> int:
        match node:
            case Number(value):
                return self.number(flint_fraction(value))
            case Symbol(name):
                if name not in letters:
                    raise Unwritable(f"`{name}`", name)
                return letters[name]
            case Constant():
                return self.number(arb.pi())
            case Sum(terms):
                return self.total(terms, place)
            case Negative(operand):
                return self.negative(place(operand))
            case Product(factors):
                return reduce(self.times, map(place, factors))
            case Quotient(above, below):
                return self.over(place(above), place(below))
            case Power(base, exponent):
                number = place(exponent)
                return self.raised(place(base), number)
            case Call(name, arguments):
                return self.function(name, *map(place, arguments))
        raise Unwritable("a formula of this kind")

    def total(self, terms: Iterable[Formula], place: Callable[[Formula], int]) -> int:
        """A sum; terms with a minus are subtracted."""
        first, *others = terms
        result = place(first)
        for term in others:
            if isinstance(term, Negative):
                result = self.write(Operation("subtract", (result, place(term.operand))))
            else:
                result = self.write(Operation("add", (result, place(term))))
        return result

    def negative(self, value: int) -> int:
        return self.write(Operation("negative", (value,)))

    def times(self, left: int, right: int) -> int:
        return self.write(Operation("multiply", (left, right)))

    def over(self, above: int, below: int) -> int:
        return self.write(Operation("divide", (above, below)))

    def raised(self, base: int, exponent: int) -> int:
        """A whole power by squaring, one over it where it is negative; any other as it stands."""
        number = self.constant(exponent)
        if not isinstance(number, fmpq) or number.q != 1 or abs(number) > MOST:
            return self.write(Operation("power", (base, exponent)))
        power = self.whole_power(base, abs(int(number.p)))
        return self.over(self.number(ONE), power) if number < 0 else power

    def whole_power(self, base: int, n: int) -> int:
        """baseⁿ, n ≥ 0, by squaring."""
        result: int | None = None
        while n:
            if n & 1:
                result = base if result is None else self.times(result, base)
            n >>= 1
            base = self.times(base, base) if n else base
        return self.number(ONE) if result is None else result

    def function(self, name: str, *arguments: int) -> int:
        return self.write(Operation(name, arguments))


def flint_fraction(value: Fraction) -> Exact:
    """A fraction as flint has them."""
    return fmpq(fmpz(value.numerator), fmpz(value.denominator))


def identity(number: Exact) -> tuple[int, ...]:
    """What tells a number from others."""
    if isinstance(number, fmpq):
        return int(number.p), int(number.q)
    return tuple(int(part) for point in (number.mid(), number.rad()) for part in point.man_exp())
