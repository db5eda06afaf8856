"""Floats: a program over NumPy arrays, in pieces that fit into the processor's cache. NumPy is imported here alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.arrays.program import NotForMany, Program

PIECE = 8192  # values worked on at a time
WORDS: dict[str, Any] = {
    "asin": np.arcsin,
    "acos": np.arccos,
    "atan": np.arctan,
    "atan2": np.arctan2,
}
PLAIN = ("add", "subtract", "multiply", "divide", "negative", "power", "sqrt", "sin", "cos", "tan", "exp", "log", "abs")


def run(program: Program, values: Mapping[str, Any], bounds: int) -> list[Any]:
    """The results for all sets of values, without the last ones, the `bounds`: where one of them is negative, NaN."""
    functions = [function_of(operation.word) for operation in program.operations]
    inputs = [np.asarray(values[name], dtype=np.float64) for name in program.inputs]
    shape = np.broadcast_shapes(*(item.shape for item in inputs))
    flat = [np.broadcast_to(item, shape).reshape(-1) if item.ndim else item for item in inputs]
    results = [np.empty(int(np.prod(shape))) for _ in program.results[: len(program.results) - bounds]]
    constants = [evaluate(constant, {}, digits=17).float for constant in program.constants]
    with np.errstate(all="ignore"):
        for start in range(0, len(results[0]) if results else 0, PIECE):
            piece = slice(start, start + PIECE)
            places: list[Any] = [item[piece] if item.ndim else item for item in flat]
            places += constants
            for function, operation in zip(functions, program.operations, strict=True):
                places.append(function(*(places[index] for index in operation.operands)))
            write(results, piece, [places[index] for index in program.results])
    return [result.reshape(shape) for result in results]


def write(results: Sequence[Any], piece: slice, found: Sequence[Any]) -> None:
    """The results of a piece, NaN where a bound does not hold."""
    bounds = found[len(results) :]
    broken = np.logical_not(np.logical_and.reduce([np.greater_equal(bound, 0) for bound in bounds])) if bounds else None
    for result, values in zip(results, found, strict=False):
        result[piece] = values
        if broken is not None and np.any(broken):
            result[piece][...] = np.where(broken, np.nan, result[piece])


def function_of(word: str) -> Any:
    """NumPy's function for an operation."""
    if word in WORDS:
        return WORDS[word]
    if word not in PLAIN:
        raise NotForMany(f"NumPy has no function {word}; ask for certified values")
    return getattr(np, word)
