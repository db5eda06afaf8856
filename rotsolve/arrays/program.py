"""Program: the closed forms of answers as one list of operations on the givens; floats and balls run it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from msgspec import Struct

from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.formula import Formula, Integral
from rotsolve.algebra.tape import BITS, Operation, Tape


class NotForMany(ValueError):
    """Answers that are not to be had for other givens without solving the scene again; says why in words."""


class Program(Struct, frozen=True):
    """The operations of a tape, and the places of the results."""

    operations: list[Operation]
    results: list[int]


def program(formulas: Iterable[Formula], inputs: Iterable[str], known: Mapping[str, Formula]) -> Program:
    """The formulas as functions of the inputs; other letters have the values that are `known`."""
    tape, found = Tape(), dict[Formula, int]()
    letters = {name: tape.letter(name) for name in inputs}

    def place(formula: Formula, within: tuple[str, ...] = ()) -> int:
        if formula.holds(Integral):
            raise NotForMany("an integral has no form that could be evaluated for many values at once")
        for name in sorted(formula.symbols() - letters.keys()):
            if name not in known or name in within:
                raise NotForMany(f"`{name}` has no value")
            letters[name] = place(known[name], (*within, name))
        return tape.formula(formula, letters, found)

    with Precision(BITS):
        results = [place(formula) for formula in formulas]
    return Program(tape.operations, results)
