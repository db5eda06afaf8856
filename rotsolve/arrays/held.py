"""Held: of many sets of givens those with the smallest and largest values and some between, held against the assembly of all bodies."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from msgspec.structs import replace

from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.formula import Number
from rotsolve.arrays import NotForMany, single_answers
from rotsolve.confirm.course.samples import with_givens
from rotsolve.confirm.numbers import value_of
from rotsolve.confirm.verdicts import judged_numbers
from rotsolve.core.derivation import Answer
from rotsolve.core.limits import Limit
from rotsolve.core.symbols import TIME
from rotsolve.language.problem import Problem
from rotsolve.motion.complete import configured
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.limits import limits_of_scene

WAY_OUT = "leave such sets out, or ask `as_decided`"
LOOKS = 12  # sets beside those with the smallest and the largest value of a given


def hold_sets(
    problem: Problem, answers: Sequence[Answer], letter: Any, values: Mapping[str, Any], found: Mapping[str, Any]
) -> None:
    """NotForMany, with the set, where no such scene can be or the assembly contradicts its answers; `found` in the answers' units."""
    if TIME in values:
        return
    inputs = np.broadcast_arrays(*(np.asarray(column, dtype=np.float64) for column in values.values()))
    columns = {name: column.reshape(-1) for name, column in zip(values, inputs, strict=True)}
    results = {name: np.asarray(result).reshape(-1) for name, result in found.items()}
    scene = made_complete(problem)
    whole, limits = scene.problem, tuple(limits_of_scene(scene))
    for row in rows_held(columns):
        point = {name: float(column[row]) for name, column in columns.items()}
        hold_limits(limits, problem, point)
        for name, why in contradicted_at(
            whole, answers, letter, point, {key: float(one[row]) for key, one in results.items()}
        ):
            objection = f"an assembly of all bodies' equations contradicts `{name}` with {said_numbers(point)}{why}"
            raise NotForMany(f"{objection}: {WAY_OUT}")


def hold_limits(limits: Iterable[Limit], problem: Problem, point: Mapping[str, float]) -> None:
    """NotForMany, with the set and what is the matter, where no such scene can be: of moments that no body has."""
    decimals = {name: Number(Fraction(repr(size))) for name, size in point.items() if math.isfinite(size)}
    signs = SignOracle({**problem.values, **decimals})
    for limit in limits:
        sign = signs.by_numbers(limit.gap) if limit.gap.symbols() & decimals.keys() else None
        if sign == -1 or (sign == 0 and limit.strict):
            raise NotForMany(f"with {said_numbers(point)} {limit.words}: {WAY_OUT}")


def said_numbers(point: Mapping[str, float]) -> str:
    return ", ".join(f"{key} = {size:.4g}" for key, size in point.items())


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


def contradicted_at(
    problem: Problem, answers: Sequence[Answer], letter: Any, point: Mapping[str, float], said: Mapping[str, float]
) -> Iterator[tuple[str, str]]:
    """The answers that the assembly contradicts at one set of givens, with the reason; a set without a number says nothing."""
    set_ = {name: Number(Fraction(size)) for name, size in point.items()}
    givens = tuple([replace(item, value=set_[item.name]) if item.name in set_ else item for item in problem.givens])
    own = replace(problem, givens=givens)
    numbers = with_givens(own, {})
    sizes: dict[str, dict[str, float]] = {}
    for name, answer in single_answers(answers):
        if not math.isnan(said[name]):
            factor = 1.0 if answer.unit is None else float(value_of(answer.unit.factor, {}))
            whole, _, part = name.partition(".")
            sizes.setdefault(whole, {})[part] = said[name] * factor
    for verdict in judged_numbers(answers, own, letter, numbers, sizes):
        if verdict.holds is False:
            yield verdict.name, "" if verdict.found else f" ({verdict.why})"
