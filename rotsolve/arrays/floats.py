"""Floats: a program over NumPy arrays, in pieces that fit into the processor's cache. NumPy is imported here and for balls alone."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from msgspec.structs import astuple

from rotsolve.algebra.flints import arb
from rotsolve.algebra.tape import Operation
from rotsolve.arrays import NotForMany, Program

PIECE = 16_384  # values worked on at a time
RENAMED = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "atan2": "arctan2"}  # to NumPy's names
PLAIN = ("add", "subtract", "multiply", "divide", "negative", "power", "sqrt", "sin", "cos", "tan", "exp", "log", "abs")


class Instruction(NamedTuple):
    """An operation on registers, and the register that its result takes; None where it is a single number."""

    function: Any
    operands: tuple[int, ...]
    result: int
    buffer: int | None


def float_results(program: Program, values: Mapping[str, Any], bounds: int) -> list[Any]:
    """The results for all sets of values, without the last ones, the `bounds`: where one of them is negative, NaN."""
    inputs = {name: np.asarray(column, dtype=np.float64) for name, column in values.items()}
    shape = np.broadcast_shapes(*(item.shape for item in inputs.values()))
    columns = {name: np.broadcast_to(item, shape).reshape(-1) for name, item in inputs.items() if item.ndim}
    size = int(np.prod(shape))
    results = [np.empty(size) for _ in program.results[: len(program.results) - bounds]]
    instructions, buffers = registered(program, set(columns))
    room = [np.empty(min(PIECE, size)) for _ in range(buffers)]
    places: list[Any] = [single_number(operation, inputs) for operation in program.operations]
    varying = [(place, columns[item.name]) for place, item in enumerate(program.operations) if item.name in columns]
    with np.errstate(all="ignore"):
        for start in range(0, size, PIECE):
            piece = slice(start, min(start + PIECE, size))
            cut = [buffer[: piece.stop - start] for buffer in room]
            for place, column in varying:
                places[place] = column[piece]
            for function, operands, result, buffer in instructions:
                out = None if buffer is None else cut[buffer]
                places[result] = function(*(places[operand] for operand in operands), out=out)
            write_piece(results, piece, [places[place] for place in program.results])
    return [result.reshape(shape) for result in results]


def single_number(operation: Operation, inputs: Mapping[str, Any]) -> Any:
    """The number that a constant is, or an input without a length."""
    if operation.kind == "number":
        return float(arb(operation.numbers[0]).mid())
    return inputs[operation.name] if operation.kind == "letter" else None


def all_positive(values: Any) -> bool:
    """Whether all values are positive numbers."""
    return bool(np.all(np.greater(np.asarray(values, dtype=np.float64), 0)))


def registered(program: Program, columns: Collection[str]) -> tuple[list[Instruction], int]:
    """The operations with buffers for their results, each free again behind its last use, and how many buffers that takes."""
    last = {place: number for number, item in enumerate(program.operations) for place in item.values}
    last |= dict.fromkeys(program.results, len(program.operations))
    varies: list[bool] = []
    held: dict[int, int] = {}
    free: list[int] = []
    found, made = list[Instruction](), 0
    for place, (kind, operands, _, name) in enumerate(map(astuple, program.operations)):
        varies.append(name in columns or any(varies[operand] for operand in operands))
        if kind in ("letter", "number"):
            continue
        for operand in {operand for operand in operands if operand in held and last[operand] == place}:
            free.append(held.pop(operand))
        buffer = None
        if varies[place]:
            buffer, made = (free.pop(), made) if free else (made, made + 1)
            held[place] = buffer
        found.append(Instruction(numpy_function(kind), operands, place, buffer))
    return found, made


def write_piece(results: Sequence[Any], piece: slice, found: Sequence[Any]) -> None:
    """The results of a piece, NaN where a bound does not hold."""
    for result, values in zip(results, found, strict=False):
        result[piece] = values
    for bound in found[len(results) :]:
        broken = np.logical_not(np.greater_equal(bound, 0))
        if np.any(broken):
            for result in results:
                result[piece][np.broadcast_to(broken, result[piece].shape)] = np.nan


def numpy_function(word: str) -> Any:
    """NumPy's function for an operation."""
    if word not in PLAIN and word not in RENAMED:
        raise NotForMany(f"NumPy has no function {word}; ask for certified values")
    return getattr(np, RENAMED.get(word, word))
