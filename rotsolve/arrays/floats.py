"""Floats: a program over NumPy arrays, in pieces that fit into the processor's cache. NumPy is imported here and for balls alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.arrays.program import NotForMany, Program

PIECE = 16_384  # values worked on at a time
WORDS: dict[str, Any] = {"asin": np.arcsin, "acos": np.arccos, "atan": np.arctan, "atan2": np.arctan2}
PLAIN = ("add", "subtract", "multiply", "divide", "negative", "power", "sqrt", "sin", "cos", "tan", "exp", "log", "abs")


class Step(NamedTuple):
    """An operation on registers, and the register that its result takes; None where it is a single number."""

    function: Any
    operands: tuple[int, ...]
    result: int
    buffer: int | None


def run(program: Program, values: Mapping[str, Any], bounds: int) -> list[Any]:
    """The results for all sets of values, without the last ones, the `bounds`: where one of them is negative, NaN."""
    inputs = [np.asarray(values[name], dtype=np.float64) for name in program.inputs]
    shape = np.broadcast_shapes(*(item.shape for item in inputs))
    columns = [np.broadcast_to(item, shape).reshape(-1) if item.ndim else item for item in inputs]
    size = int(np.prod(shape))
    results = [np.empty(size) for _ in program.results[: len(program.results) - bounds]]
    numbers = [evaluate(constant, {}, digits=17).float for constant in program.constants]
    steps, buffers = registered(program, [item.ndim > 0 for item in inputs])
    room = [np.empty(min(PIECE, size)) for _ in range(buffers)]
    with np.errstate(all="ignore"):
        for start in range(0, size, PIECE):
            piece = slice(start, min(start + PIECE, size))
            cut = [buffer[: piece.stop - start] for buffer in room]
            places: list[Any] = [item[piece] if item.ndim else item for item in columns]
            places += [*numbers, *(None for _ in steps)]
            for function, operands, result, buffer in steps:
                out = None if buffer is None else cut[buffer]
                places[result] = function(*(places[operand] for operand in operands), out=out)
            write(results, piece, [places[place] for place in program.results])
    return [result.reshape(shape) for result in results]


def positive(values: Any) -> bool:
    """Whether all values are positive numbers."""
    return bool(np.all(np.greater(np.asarray(values, dtype=np.float64), 0)))


def registered(program: Program, runs: Sequence[bool]) -> tuple[list[Step], int]:
    """The operations with buffers for their results, each free again behind its last use, and how many buffers that takes."""
    first = len(program.inputs) + len(program.constants)
    last = {place: number for number, item in enumerate(program.operations) for place in item.operands}
    last |= {place: len(program.operations) for place in program.results}
    varies = [*runs, *(False for _ in program.constants)]
    held: dict[int, int] = {}
    free: list[int] = []
    steps, made = list[Step](), 0
    for number, operation in enumerate(program.operations):
        place, buffer, operands = first + number, None, operation.operands
        varies.append(any(varies[operand] for operand in operands))
        for operand in {operand for operand in operands if operand in held and last[operand] == number}:
            free.append(held.pop(operand))
        if varies[place]:
            buffer, made = (free.pop(), made) if free else (made, made + 1)
            held[place] = buffer
        steps.append(Step(function_of(operation.word), operands, place, buffer))
    return steps, made


def write(results: Sequence[Any], piece: slice, found: Sequence[Any]) -> None:
    """The results of a piece, NaN where a bound does not hold."""
    for result, values in zip(results, found, strict=False):
        result[piece] = values
    for bound in found[len(results) :]:
        broken = np.logical_not(np.greater_equal(bound, 0))
        if np.any(broken):
            for result in results:
                result[piece][np.broadcast_to(broken, result[piece].shape)] = np.nan


def function_of(word: str) -> Any:
    """NumPy's function for an operation."""
    if word in WORDS:
        return WORDS[word]
    if word not in PLAIN:
        raise NotForMany(f"NumPy has no function {word}; ask for certified values")
    return getattr(np, word)
