"""Arrays: one solved problem for many sets of givens at once: its closed forms as a program over floats (NumPy) or certified balls."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from functools import reduce
from operator import and_
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.certified.balls import with_values
from rotsolve.algebra.formula import Formula, Integral
from rotsolve.algebra.tape import BITS, Operation, Tape
from rotsolve.core.faults import RotsolveError
from rotsolve.core.symbols import TIME

if TYPE_CHECKING:
    from rotsolve.core.derivation import Answer
    from rotsolve.language.problem import Given


class NotForMany(RotsolveError, ValueError):
    """Answers that are not to be had for other givens without solving the scene again; says why in words."""


class ManyAnswers(dict[str, Any]):
    """Arrays by the names of the answers, NaN where a set has no number; `reasons` says why, '' where there is one.

    A choice has words, '' where it has none. `units` are those of the arrays. It is a dict, of which `pandas.DataFrame(…)` makes a table.
    """

    def __init__(self, found: Mapping[str, Any], reasons: Mapping[str, Any], units: Mapping[str, str]) -> None:
        super().__init__(found)
        self.reasons = reasons
        self.units = dict(units)

    @property
    def valid(self) -> Any:
        """Which sets have all their answers."""
        return reduce(and_, [reasons == "" for reasons in self.reasons.values()])

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (dict(self), self.reasons, self.units)


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


def single_answers(answers: Iterable[Answer]) -> Iterator[tuple[str, Answer]]:
    """Each answer by its name; of vectors in space and tensors each component by its own, `L.x`."""
    for answer in answers:
        if answer.rows:
            yield from ((f"{answer.name}.{part.name}", part) for part in answer.components)
        else:
            yield answer.name, answer


def checked(givens: tuple[Given, ...], positive: Collection[str], values: Mapping[str, Any]) -> dict[str, Formula]:
    """The values that givens have, once all that are put in are known by name and are positive where they have to be."""
    from rotsolve.arrays.floats import all_positive

    strange = sorted(values.keys() - {given.name for given in givens} - {TIME})
    if strange:
        raise NotForMany(f"no given `{strange[0]}`; there are {', '.join(given.name for given in givens)}")
    for name in sorted(values.keys() & set(positive)):
        if not all_positive(values[name]):
            raise NotForMany(f"`{name}` has to be positive")
    known = {given.name: given.value for given in givens if given.value is not None}
    for name in sorted(values.keys() & known.keys()):
        if letters := sorted(with_values(known[name], known).symbols()):
            raise NotForMany(
                f"`{name}` is made of {', '.join(f'`{letter}`' for letter in letters)}: give values to these"
            )
    return known


def in_its_unit(answer: Answer) -> Formula:
    """The closed form of the number that stands before the answer's unit."""
    if answer.closed is None:
        raise NotForMany(f"`{answer.name}` has no closed form: solve the scene again for each set of givens")
    return answer.closed / answer.unit.factor if answer.unit is not None else answer.closed
