"""Elimination: linear equations between power series, whose coefficients change with the motion."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from operator import mul

from rotsolve.simulation.tape.tape import Scalar, Tape

Series = list[Scalar]
Lists = Mapping[int, Series]  # by the places of their values on the tape
Made = tuple[
    Callable[[], None], Callable[[int], None] | None
]  # what begins a series, and what appends to it; nothing to a constant's


def solver_of(tape: Tape, name: str, lists: Lists) -> Made:
    """Linear equations A x = b: A₀ xₖ = bₖ − Σ Aⱼ xₖ₋ⱼ, j from 1, with A₀ factored once; what is constant in A drops out of the sum."""
    block = tape.blocks[int(name)]
    owns = [lists[place] for place in unknowns_of(tape, name)]
    rows = [[lists[value] for value in row] for row in block.rows]
    right = [lists[value] for value in block.right]
    moving = [tape.constant(value) is None for value in block.right]
    changing = [
        [(own, lists[value]) for own, value in zip(owns, row, strict=True) if tape.constant(value) is None]
        for row in block.rows
    ]
    lines = list(zip(right, moving, changing, strict=True))
    held: list[Callable[[list[Scalar]], list[Scalar]]] = []

    def start() -> None:
        held[:] = [factored([[series[0] for series in row] for row in rows])]
        for own, value in zip(owns, held[0]([series[0] for series in right]), strict=True):
            own.append(value)

    def step(order: int) -> None:
        rest = []
        for series, moves, pairs in lines:
            total = series[order] if moves else 0
            for own, coefficient in pairs:
                total = total - sum(map(mul, own, coefficient[order:0:-1]))
            rest.append(total)
        for own, value in zip(owns, held[0](rest), strict=True):
            own.append(value)

    return start, step


def unknowns_of(tape: Tape, name: str) -> list[int]:
    """The places of the unknowns of a block, in their order."""
    found = [
        (int(item.numbers[0].p), place)
        for place, item in enumerate(tape.operations)
        if (item.kind, item.name) == ("unknown", name)
    ]
    return [place for _, place in sorted(found)]


def factored(table: list[list[Scalar]]) -> Callable[[list[Scalar]], list[Scalar]]:
    """What solves A x = b for this A: by elimination with the largest pivot of each column."""
    size = len(table)
    order = list(range(size))
    for k in range(size):
        best = max(range(k, size), key=lambda i: abs(float(table[i][k])))
        table[k], table[best] = table[best], table[k]
        order[k], order[best] = order[best], order[k]
        for i in range(k + 1, size):
            table[i][k] = table[i][k] / table[k][k]
            for j in range(k + 1, size):
                table[i][j] = table[i][j] - table[i][k] * table[k][j]

    if size == 2:
        return solver_of_two(table, order[0] == 1)

    def solve(right: list[Scalar]) -> list[Scalar]:
        found = [right[i] for i in order]
        for i in range(size):
            for j in range(i):
                found[i] = found[i] - table[i][j] * found[j]
        for i in reversed(range(size)):
            for j in range(i + 1, size):
                found[i] = found[i] - table[i][j] * found[j]
            found[i] = found[i] / table[i][i]
        return found

    return solve


def solver_of_two(table: list[list[Scalar]], turned: bool) -> Callable[[list[Scalar]], list[Scalar]]:
    """The same for two unknowns, the commonest case, written out; `turned` where the rows have been exchanged."""
    (a, b), (factor, d) = table

    def solve(right: list[Scalar]) -> list[Scalar]:
        first, second = (right[1], right[0]) if turned else right
        y = (second - factor * first) / d
        return [(first - b * y) / a, y]

    return solve
