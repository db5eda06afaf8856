"""Program: formulas as one list of elementary operations, each value worked out once; it is data, and knows no arithmetic."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from msgspec import Struct

from rotsolve.algebra.formula import (
    ONE,
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

MOST = 64  # the highest whole power that is multiplied out


class NotForMany(ValueError):
    """Answers that are not to be had for other givens without solving the scene again; says why in words."""


class Operation(Struct, frozen=True):
    """One operation by its word (add, subtract, multiply, divide, negative, power, or a function's name) on earlier values."""

    word: str
    operands: tuple[int, ...]


class Program(Struct, frozen=True):
    """Values 0, 1, … are the inputs, then the constants, then what each operation gives; `results` are the places of the formulas."""

    inputs: tuple[str, ...]
    constants: tuple[Formula, ...]
    operations: tuple[Operation, ...]
    results: tuple[int, ...]


def program(formulas: Iterable[Formula], inputs: Iterable[str], known: Mapping[str, Formula]) -> Program:
    """The formulas as functions of the inputs; other letters have the values that are `known`."""
    writer = Writer(tuple(inputs), known)
    asked = tuple(formulas)
    for formula in asked:
        writer.collect(formula)
    results = tuple(writer.place(formula) for formula in asked)
    return Program(writer.inputs, tuple(writer.constants), tuple(writer.operations), results)


class Writer:
    """Writes operations behind each other; a formula, and an operation on the same values, is written once."""

    def __init__(self, inputs: tuple[str, ...], known: Mapping[str, Formula]) -> None:
        self.inputs = inputs
        self.known = known
        self.constants: dict[Formula, int] = {}
        self.operations: dict[Operation, int] = {}
        self.places: dict[Formula, int] = {Symbol(name): index for index, name in enumerate(inputs)}
        self.open: set[str] = set()

    def collect(self, formula: Formula) -> None:
        """Find all constants, which come before the operations; refuse letters without a value, or with one that refers to itself."""
        if formula in self.places or formula in self.constants:
            return
        if isinstance(formula, (Number, Constant)):
            self.constants[formula] = len(self.inputs) + len(self.constants)
        elif isinstance(formula, Symbol):
            if formula.name not in self.known or formula.name in self.open:
                raise NotForMany(f"`{formula.name}` has no value")
            self.open.add(formula.name)
            self.collect(self.known[formula.name])
            self.open.remove(formula.name)
        elif isinstance(formula, Power) and isinstance(formula.exponent, Number):
            self.collect(formula.base)
            self.collect(formula.exponent)
            self.collect(ONE)
        else:
            for child in formula.children():
                self.collect(child)

    def place(self, formula: Formula) -> int:
        """The place of a formula's value."""
        if formula in self.constants:
            return self.constants[formula]
        if formula not in self.places:
            self.places[formula] = self._written(formula)
        return self.places[formula]

    def _written(self, formula: Formula) -> int:
        match formula:
            case Symbol(name):
                return self.place(self.known[name])
            case Sum(terms):
                return self._sum(terms)
            case Product(factors):
                return self._chained("multiply", factors)
            case Quotient(numerator, denominator):
                return self._operation("divide", self.place(numerator), self.place(denominator))
            case Negative(operand):
                return self._operation("negative", self.place(operand))
            case Power(base, exponent):
                return self._power(base, exponent)
            case Call(function, arguments):
                return self._operation(function, *map(self.place, arguments))
        raise NotForMany("an integral has no form that could be evaluated for many values at once")

    def _operation(self, word: str, *operands: int) -> int:
        operation = Operation(word, operands)
        start = len(self.inputs) + len(self.constants)
        return self.operations.setdefault(operation, start + len(self.operations))

    def _chained(self, word: str, parts: tuple[Formula, ...]) -> int:
        place = self.place(parts[0])
        for part in parts[1:]:
            place = self._operation(word, place, self.place(part))
        return place

    def _sum(self, terms: tuple[Formula, ...]) -> int:
        """Terms with a minus are subtracted."""
        place = self.place(terms[0])
        for term in terms[1:]:
            minus = isinstance(term, Negative)
            part = self.place(term.operand if isinstance(term, Negative) else term)
            place = self._operation("subtract" if minus else "add", place, part)
        return place

    def _power(self, base: Formula, exponent: Formula) -> int:
        """A whole power by squaring, one over it where it is negative; any other as it stands."""
        if not isinstance(exponent, Number) or exponent.value.denominator > 1 or abs(exponent.value) > MOST:
            return self._operation("power", self.place(base), self.place(exponent))
        square, n = self.place(base), abs(exponent.value.numerator)
        result: int | None = None
        while n:
            if n & 1:
                result = square if result is None else self._operation("multiply", result, square)
            n >>= 1
            square = self._operation("multiply", square, square) if n else square
        one = self.place(ONE)
        if result is None:
            return one
        return self._operation("divide", one, result) if exponent.value < 0 else result
