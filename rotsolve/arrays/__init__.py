"""Arrays: one solved problem for many sets of givens at once: its closed forms as a program over floats (NumPy) or certified balls."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from rotsolve.algebra.formula import Formula
from rotsolve.arrays.program import NotForMany, program
from rotsolve.core.symbols import TIME

if TYPE_CHECKING:
    from rotsolve.core.derivation import Answer
    from rotsolve.derivation.validity import Validity
    from rotsolve.language.problem import Given

__all__ = ["NotForMany", "evaluate_many"]


def evaluate_many(
    answers: tuple[Answer, ...], givens: tuple[Given, ...], valid: Validity, values: Mapping[str, Any], certified: bool
) -> dict[str, Any]:
    """The answers by name, in their units; arrays of values with arrays of errors where `certified`."""
    try:
        from rotsolve.arrays.balls import ball_results
        from rotsolve.arrays.floats import all_positive, float_results
    except ModuleNotFoundError:
        raise NotForMany("arrays take NumPy: pip install 'rotsolve[arrays]'") from None
    known = {given.name: given.value for given in givens if given.value is not None}
    strange = sorted(values.keys() - {given.name for given in givens} - {TIME})
    if strange:
        raise NotForMany(f"no given `{strange[0]}`; there are {', '.join(given.name for given in givens)}")
    forms = {answer.name: in_its_unit(answer) for answer in answers}
    bounds = [*valid.bounds, *valid.sides]
    work = program([*forms.values(), *bounds], values, known)
    for name in sorted(values.keys() & valid.positive):
        if not all_positive(values[name]):
            raise NotForMany(f"`{name}` has to be positive")
    found = (ball_results if certified else float_results)(work, values, len(bounds))
    return dict(zip(forms, found, strict=True))


def in_its_unit(answer: Answer) -> Formula:
    """The closed form of the number that stands before the answer's unit."""
    if answer.closed is None:
        raise NotForMany(f"`{answer.name}` has no closed form: solve the scene again for each set of givens")
    return answer.closed / answer.unit.factor if answer.unit is not None else answer.closed
