"""Lazy: the answers for sets of givens in arrays of dask: arrays of dask, of which each piece is worked out when it is asked for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from rotsolve.algebra.certified.alone import ALONE
from rotsolve.arrays import ManyAnswers, checked, single_answers
from rotsolve.arrays.many import worked_out_sets

if TYPE_CHECKING:
    from rotsolve.solution import Solution


def lazy_answers(solution: Solution, values: Mapping[str, Any], certified: bool) -> ManyAnswers:
    """Arrays of dask by the names of the answers, with `reasons` that are such arrays too."""
    from dask import array

    checked(solution.problem.givens, (), values)
    columns = array.broadcast_arrays(*map(array.asarray, values.values()))
    nothing = np.empty((0,) * columns[0].ndim, dtype=object)
    told = {"names": tuple(values), "solution": solution, "certified": certified}
    pieces = array.map_blocks(piece_answers, *columns, **told, dtype=object, meta=nothing)

    def part(name: str, place: int | None, kind: Any) -> Any:
        return array.map_blocks(part_of_piece, pieces, name, place, dtype=kind, meta=nothing.astype(kind))

    found, reasons, units = {}, {}, {}
    for name, answer in single_answers(solution.derivation.answers):
        kind = object if answer.word else np.float64
        parts = tuple(part(name, place, kind) for place in range(1 + (certified and not answer.word)))
        found[name] = parts if len(parts) > 1 else parts[0]
        reasons[name] = part(name, None, object)
        units[name] = answer.unit.text if answer.unit else ""
    return ManyAnswers(found, reasons, units)


def piece_answers(*columns: Any, names: tuple[str, ...], solution: Solution, certified: bool) -> ManyAnswers:
    """The answers for a piece of the sets."""
    with ALONE:
        return worked_out_sets(solution, dict(zip(names, columns, strict=True)), certified)


def part_of_piece(piece: ManyAnswers, name: str, place: int | None) -> Any:
    """The numbers of one answer, the bounds on their errors, or the reasons why it has none."""
    if place is None:
        return piece.reasons[name]
    return piece[name][place] if isinstance(piece[name], tuple) else piece[name]
