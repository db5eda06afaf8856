"""Held: of the sets of one case those with the smallest and largest values and some between, held against the assembly of all bodies."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import numpy as np
from msgspec.structs import replace

from rotsolve.algebra.formula import Number
from rotsolve.arrays import single_answers
from rotsolve.arrays.cases import GivenSets, SetCase, form_numbers
from rotsolve.confirm.course.samples import with_givens
from rotsolve.confirm.verdicts import judged_numbers
from rotsolve.core.symbols import TIME
from rotsolve.language.problem import Problem
from rotsolve.motion.complete import configured
from rotsolve.motion.configuration import Configuration

LOOKS = 12  # sets beside those with the smallest and the largest value of a given


def case_contradicted(case: SetCase, given: GivenSets, here: Any, problem: Problem) -> bool:
    """Whether the assembly contradicts what a case says of one of its sets; `problem` has letters for what the scene leaves out."""
    if TIME in given.columns or case.solution is None:
        return False
    places = np.flatnonzero(here)[rows_held(given.part(here))]
    chosen = np.zeros(given.size, dtype=bool)
    chosen[places] = True
    found = {name: form_numbers(form, given, chosen, False)[0] for name, form in case.forms.items()}
    return any(
        contradicted_at(problem, case, given.row(int(place)), {name: float(one[k]) for name, one in found.items()})
        for k, place in enumerate(np.flatnonzero(chosen))
    )


def made_complete(problem: Problem) -> Configuration:
    """The scene with letters for what it leaves out."""
    if problem.space:
        from rotsolve.space.complete import configured_in_space

        return configured_in_space(problem)
    return configured(problem)


def rows_held(columns: Mapping[str, Any]) -> list[int]:
    """The numbers of the sets that are looked at."""
    size = min((len(column) for column in columns.values()), default=0)
    chosen = (
        {int(place) for column in columns.values() for place in (np.argmin(column), np.argmax(column))}
        if size
        else set()
    )
    return sorted(chosen | {round(part) for part in np.linspace(0, size - 1, min(size, LOOKS))})


def contradicted_at(problem: Problem, case: SetCase, point: Mapping[str, float], said: Mapping[str, float]) -> bool:
    """Whether the assembly contradicts answers at one set of givens, both in SI units."""
    assert case.solution is not None
    set_ = {name: Number(Fraction(repr(size))) for name, size in point.items()}
    givens = tuple([replace(item, value=set_[item.name]) if item.name in set_ else item for item in problem.givens])
    own = replace(problem, givens=givens)
    sizes: dict[str, dict[str, float]] = {}
    for name, _ in single_answers(case.solution.derivation.answers):
        if not math.isnan(said.get(name, math.nan)):
            whole, _, part = name.partition(".")
            sizes.setdefault(whole, {})[part] = said[name]
    letter = case.solution.trace.letter
    verdicts = judged_numbers(case.solution.derivation.answers, own, letter, with_givens(own, {}), sizes)
    return any(verdict.holds is False for verdict in verdicts)
