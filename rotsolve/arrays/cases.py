"""Cases of arrays: many sets of givens, each answered in its own case, which is solved in letters at the first set that is of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np

from rotsolve.algebra.formula import ONE, Formula, Number
from rotsolve.algebra.units.dimension import is_positive
from rotsolve.arrays import NotForMany, checked, in_its_unit, program, single_answers
from rotsolve.arrays.balls import ball_results
from rotsolve.arrays.floats import float_results
from rotsolve.core.faults import Fault, SceneError, Unsolvable
from rotsolve.core.symbols import TIME

if TYPE_CHECKING:
    from rotsolve.derivation.requirements import Validity
    from rotsolve.language.problem import Given
    from rotsolve.solution import Solution

MOST = 20  # cases that are solved; sets beyond have no numbers
Solving = Callable[[Mapping[str, Formula]], "tuple[Solution, Mapping[Formula, int]]"]


def evaluate_by_cases(
    solve: Solving, givens: tuple[Given, ...], valid: Validity, values: Mapping[str, Any], certified: bool
) -> dict[str, Any]:
    """The answers by name, in their units, as `evaluate_many` gives them; NaN for sets without an answer."""
    known = checked(givens, [given.name for given in givens if is_positive(given.dimension)], values)
    inputs = {name: np.asarray(column, dtype=np.float64) for name, column in values.items()}
    shape = np.broadcast_shapes(*(item.shape for item in inputs.values()))
    columns = {name: np.broadcast_to(item, shape).reshape(-1) for name, item in inputs.items()}
    limits = [limit for limit in valid.limits if limit.symbols() <= values.keys()]
    left, found, reason = within(limits, columns, known), dict[str, list[Any]](), ""
    for _ in range(MOST):
        if not left.any():
            break
        first = int(np.argmax(left))
        own = {name: repr(float(column[first])) for name, column in columns.items() if name != TIME}
        point = {name: Number(Fraction(text)) for name, text in own.items()}  # 0.6 as it is typed: 0.6² + 0.8² = 1
        try:
            solution, signs = solve(point)
        except (Unsolvable, SceneError) as error:
            left[first], reason = False, reason or f": {first_fault(error).message}"
            continue
        here = np.zeros_like(left)
        here[left] = within(sides_of(signs), {name: column[left] for name, column in columns.items()}, known)
        here[first] = True
        left &= ~here
        if any(check.holds is False for check in solution.derivation.checks):
            continue
        chosen = {name: column[here] for name, column in columns.items()}
        forms = {name: in_its_unit(answer) for name, answer in single_answers(solution.derivation.answers)}
        work = program(forms.values(), chosen, known)
        results = ball_results(work, chosen, 0) if certified else float_results(work, chosen, 0)
        for name, result in zip(forms, results, strict=True):
            parts = result if certified else (result,)
            whole = found.setdefault(name, [np.full(left.shape, np.nan) for _ in parts])
            for all_sets, part in zip(whole, parts, strict=True):
                all_sets[here] = part
    if not found:
        raise NotForMany(f"none of the sets has an answer{reason}")
    told = {name: tuple(part.reshape(shape) for part in parts) for name, parts in found.items()}
    return told if certified else {name: parts[0] for name, parts in told.items()}


def first_fault(error: Unsolvable | SceneError) -> Fault:
    return error.fault if isinstance(error, Unsolvable) else error.faults[0]


def sides_of(signs: Mapping[Formula, int]) -> list[Formula]:
    """What must not be negative for formulas to have signs."""
    sides = {1: (ONE,), -1: (-ONE,), 0: (ONE, -ONE)}
    return [value * side for value, sign in signs.items() for side in sides[sign]]


def within(sides: Sequence[Formula], columns: Mapping[str, Any], known: Mapping[str, Formula]) -> Any:
    """For which sets no side is negative."""
    work = program([ONE, *sides], columns, known)
    (result,) = float_results(work, columns, len(sides))
    return np.broadcast_to(np.isfinite(result), next(iter(columns.values())).shape).copy()
