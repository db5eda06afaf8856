"""Many: the answers for many sets of givens: each set by the case that it is of, each case solved once; what has no number says why."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from msgspec import Struct

from rotsolve.algebra.formula import ONE, Formula
from rotsolve.algebra.units.dimension import base_unit_text
from rotsolve.arrays import ManyAnswers, NotForMany, checked, in_its_unit, program, single_answers
from rotsolve.arrays.balls import ball_results
from rotsolve.arrays.cases import (
    GivenSets,
    Resolving,
    Row,
    SetCase,
    case_of_set,
    number_in_unit_of,
    numbers_of_forms,
    picking,
    says_the_same,
    sets_like,
)
from rotsolve.arrays.floats import float_results
from rotsolve.arrays.held import case_contradicted, made_complete
from rotsolve.arrays.reasons import Reasons
from rotsolve.core.symbols import TIME
from rotsolve.motion.limits import limits_of_scene

if TYPE_CHECKING:
    from rotsolve.algebra.units.unit_table import Unit
    from rotsolve.solution import Resolved, Solution

OTHERWISE = "what the closed form needs does not hold for these numbers"
NO_SUCH = "these numbers have no such answer"
UNTOLD = "its number is beyond those of floats"
MOST = 100  # sets that are solved for one call
TOO_MANY = (
    f"not worked out: {MOST} sets that differ in what decides were solved before it; ask for it in a call of its own"
)
Contradicting = Callable[[SetCase, GivenSets, Any], bool]


class Sets(Struct):
    """Sets of givens that are being answered: what solves one, what else decides, and what an assembly holds against them."""

    given: GivenSets
    solve: Resolving
    limits: Sequence[Formula]
    case_contradicted: Contradicting
    units: dict[str, Unit | None]
    certified: bool
    reasons: Reasons
    numbers: dict[str, tuple[Any, ...]] = {}

    def answer(self, cases: list[SetCase]) -> None:
        """Answer all sets, by the `cases` that are known and by others, which are entered there."""
        left = self.entered()
        for case in cases:
            if left.any():
                left &= ~self.spread(case, sets_like(case, self.given, left))
        for _ in range(MOST):
            if not left.any():
                return
            first = int(np.argmax(left))
            case = case_of_set(self.solve, self.given, first, self.limits)
            here = self.like(case, left, first)
            left &= ~self.spread(case, here, first)
            if case.general:
                cases.append(case)
        for name in self.units:
            self.reasons.tell(name, left, TOO_MANY)

    def entered(self) -> Any:
        """The sets that are numbers; the others are told to be none."""
        left = np.ones(self.given.size, dtype=bool)
        for letter, column in self.given.columns.items():
            none = left & ~np.isfinite(column)
            if none.any():
                for name in self.units:
                    self.reasons.tell(name, none, f"`{letter}` is no number")
                left &= ~none
        return left

    def like(self, case: SetCase, left: Any, first: int) -> Any:
        """The sets that are of a case; that of its own alone, where another that is solved too, or an assembly, says otherwise."""
        alone = self.given.only(first)
        try:
            here = (sets_like(case, self.given, left) | alone) if case.general else alone
        except NotForMany:  # what decides has no form that could be evaluated
            here = alone
        others = np.flatnonzero(here & ~alone)
        if len(others):
            probed = case_of_set(self.solve, self.given, int(others[-1]), self.limits)
            case.general = says_the_same(case, probed, self.given, int(others[-1]))
            case.general = case.general and not self.case_contradicted(case, self.given, here)
        elif case.general:
            case.general = False  # nothing has been seen of others
        return here if case.general else alone

    def spread(self, case: SetCase, here: Any, first: int | None = None) -> Any:
        """Enter what a case says of its sets, the `first` of which was solved; these sets."""
        rows = picking(here)
        for name in dict.fromkeys((*self.units, *case.numbers, *case.reasons)):
            self.units.setdefault(name, case.units.get(name))
            if name not in self.reasons:
                self.reasons.codes[name] = np.full(self.given.size, self.reasons.code(NO_SUCH), dtype=np.int32)
            reason = case.reason(name)
            self.reasons.tell(name, rows, reason and f"as for {case.at}: {reason}")
            if reason and first is not None:
                self.reasons.tell(name, first, reason)
        forms = {name: form / self.factor(name) for name, form in case.forms.items() if case.general}
        found = numbers_of_forms(forms, self.given, rows, self.certified) if forms else {}
        for name, number in case.numbers.items():
            if isinstance(number, str):
                self.enter(name, rows, (number,), ("",))
            else:
                self.enter(name, rows, found.get(name) or number_in_unit_of(number, self.units[name]))
        return here

    def factor(self, name: str) -> Formula:
        """What an answer is counted in."""
        unit = self.units[name]
        return ONE if unit is None else unit.factor

    def enter(
        self, name: str, rows: Any, values: tuple[Any, ...], empty: tuple[Any, ...] = (math.nan, math.inf)
    ) -> None:
        """The values of some sets, and what stands where there are none."""
        kind: Any = object if isinstance(values[0], str) else np.float64
        count = 2 if self.certified and kind is np.float64 else 1
        if name not in self.numbers:
            self.numbers[name] = tuple(np.full(self.given.size, one, dtype=kind) for one in empty[:count])
        for whole, part in zip(self.numbers[name], values, strict=False):
            whole[rows] = part
        if kind is np.float64 and not np.isfinite(values[0]).all():
            none = ~np.isfinite(self.numbers[name][0])
            self.reasons.tell(name, none & self.reasons.answered(name), UNTOLD)

    def result(self, shape: tuple[int, ...]) -> ManyAnswers:
        """All answers, as arrays of a shape."""
        found: dict[str, Any] = {}
        empty = (math.nan, math.inf)[: 1 + self.certified]
        for name in self.units:
            own = self.numbers.get(name) or tuple(np.full(self.given.size, one) for one in empty)
            parts = tuple(part.reshape(shape) for part in own)
            found[name] = parts if self.certified and len(parts) > 1 else parts[0]
        self.reasons.codes = {name: codes.reshape(shape) for name, codes in self.reasons.codes.items()}
        return ManyAnswers(found, self.reasons, {name: unit.text if unit else "" for name, unit in self.units.items()})


def real_numbers(name: str, column: Any) -> Any:
    """The numbers of a given; what an array masks is none. Raises NotForMany for complex ones."""
    if np.iscomplexobj(column):
        raise NotForMany(f"`{name}` has complex numbers")
    return column.astype(float).filled(math.nan) if isinstance(column, np.ma.MaskedArray) else column


def answers_of_sets(solution: Solution, values: Mapping[str, Any], certified: bool) -> ManyAnswers:
    """The answers to all sets of values; NotForMany where none has one. Of arrays of dask they are such arrays, made piece by piece."""
    if any(type(item).__module__.startswith("dask.") for item in values.values()):
        from rotsolve.arrays.lazy import lazy_answers

        return lazy_answers(solution, values, certified)
    found = worked_out_sets(solution, values, certified)
    reasons = found.reasons
    assert isinstance(reasons, Reasons)
    if reasons and not any(reasons.answered(name).any() for name in reasons):
        reason = next((text for texts in reasons.values() for text in texts.reshape(-1)), "no set is given")
        raise NotForMany(f"none of the sets has an answer: {reason}")
    return found


def answers_as_decided(solution: Solution, values: Mapping[str, Any], certified: bool) -> ManyAnswers:
    """The closed forms of a solution for all sets, NaN where a string would go slack, a contact open, or a sign be another."""
    assert solution.trace.validity is not None
    answers, valid = dict(single_answers(solution.derivation.answers)), solution.trace.validity()
    known = checked(solution.problem.givens, valid.positive, values)
    forms = [in_its_unit(answer) for answer in answers.values()]
    bounds = [*valid.bounds, *valid.sides, *(limit for limit in valid.limits if limit.symbols() <= values.keys())]
    work = program([*forms, *bounds], values, known)
    found = dict(zip(answers, (ball_results if certified else float_results)(work, values, len(bounds)), strict=True))
    numbers = {name: result[0] if certified else result for name, result in found.items()}
    reasons = Reasons(np.shape(next(iter(numbers.values()))), numbers)
    for name, result in numbers.items():
        if (none := np.isnan(result)).any():
            reasons.tell(name, none, OTHERWISE)
    return ManyAnswers(found, reasons, {name: one.unit.text if one.unit else "" for name, one in answers.items()})


def worked_out_sets(solution: Solution, values: Mapping[str, Any], certified: bool) -> ManyAnswers:
    """The answers by the cases that the solution remembers, and by others, which are entered there."""
    problem = solution.problem
    known = checked(problem.givens, (), values)
    inputs = {name: np.asarray(column, dtype=np.float64) for name, column in values.items()}
    shape = np.broadcast_shapes(*(item.shape for item in inputs.values()))
    columns = {name: np.broadcast_to(item, shape).reshape(-1) for name, item in inputs.items()}
    open_ = [given.name for given in problem.givens if given.value is None and not given.asked]
    given = GivenSets(math.prod(shape), columns, known, frozenset(open_) - columns.keys())
    whole = made_complete(problem)
    limits = [limit.gap for limit in limits_of_scene(whole)]
    units = {name: answer.unit for name, answer in single_answers(solution.derivation.answers)}
    contradicted, reasons = partial(case_contradicted, problem=whole.problem), Reasons((given.size,), units, NO_SUCH)
    sets = Sets(given, partial(resolved, solution), limits, contradicted, units, certified, reasons)
    sets.answer(solution.cases.setdefault(frozenset(values), []))
    return sets.result(shape)


def resolved(solution: Solution, row: Row) -> Resolved:
    """A scene solved for one set of values in SI units."""
    assert solution.trace.anew is not None
    dimensions = {given.name: given.dimension for given in solution.problem.givens}
    settings = {}
    for name, size in row.items():
        dimension = dimensions.get(name)
        settings[name] = f"{size!r} {base_unit_text(dimension) if dimension else ''}".rstrip()
    moment = f"{settings.pop(TIME)} s" if TIME in settings else None
    return solution.trace.anew(settings, moment)
