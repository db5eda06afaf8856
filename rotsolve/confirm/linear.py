"""Linear equations, in numbers, where some may say the same and some unknowns may be left open: elimination with full pivoting."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct

SMALL = 1e-10  # below this, relative to its row and column, a number is rounding


class Solved(Struct, frozen=True):
    """A solution, the unknowns that the equations leave open (taken as 0, or moved by those), and the largest clash, relative."""

    values: list[float]
    open: frozenset[int]
    clash: float


class General(Struct, frozen=True):
    """All solutions: one of them, the directions in which it may go on, and what is left of equations that say nothing new, 0 if true.

    `size` is that of the largest number of the scaled equations, beside which what is left counts.
    """

    values: list[float]
    free: list[list[float]]
    left: list[float]
    size: float


def solved(rows: Sequence[dict[int, float]], right: Sequence[float], size: int) -> Solved:
    """The solution of Σ rows[k][i] x[i] = right[k], x[i] of the unknowns that nothing tells 0."""
    rows, right, scale, pivots = reduced(rows, right, size)
    taken = dict(pivots)
    values, loose = [0.0] * size, {index for index in range(size) if index not in taken}
    for index, number in pivots:
        values[index] = right[number]
        if any(abs(part) > SMALL * 10 for other, part in rows[number].items() if other != index):
            loose.add(index)
    left, most = clashing(right, values, pivots)
    clash = max(map(abs, left), default=0.0) / most
    return Solved([value * part for value, part in zip(values, scale, strict=True)], frozenset(loose), clash)


def solved_generally(rows: Sequence[dict[int, float]], right: Sequence[float], size: int) -> General:
    """All solutions of such equations; what is left of each equation is linear in the right sides."""
    rows, right, scale, pivots = reduced(rows, right, size)
    taken, values, free = dict(pivots), [0.0] * size, []
    for index, number in pivots:
        values[index] = right[number]
    for loose in (index for index in range(size) if index not in taken):
        way = [0.0] * size
        way[loose] = scale[loose]
        for index, number in pivots:
            way[index] = -rows[number].get(loose, 0.0) * scale[index]
        free.append(way)
    left, most = clashing(right, values, pivots)
    return General([value * part for value, part in zip(values, scale, strict=True)], free, left, most)


def clashing(
    right: Sequence[float], values: Sequence[float], pivots: Sequence[tuple[int, int]]
) -> tuple[list[float], float]:
    """The right sides of the equations that were not needed, and the size of the largest number."""
    used = {number for _, number in pivots}
    most = max([abs(value) for value in values] + [abs(value) for value in right] + [1e-300])
    return [value for number, value in enumerate(right) if number not in used], most


def reduced(
    rows: Sequence[dict[int, float]], right: Sequence[float], size: int
) -> tuple[list[dict[int, float]], list[float], list[float], list[tuple[int, int]]]:
    """The equations after elimination, with the scales of the unknowns and (unknown, row) for each pivot.

    Gauss–Jordan: rows and columns are scaled to the size 1 first, so that kilograms and metres do not decide what is small.
    """
    rows, columns = [dict(row) for row in rows], [0.0] * size
    right = list(right)
    for row in rows:
        for index, part in row.items():
            columns[index] = max(columns[index], abs(part))
    scale = [1.0 / part if part else 1.0 for part in columns]
    for number, row in enumerate(rows):
        for index in row:
            row[index] *= scale[index]
        weight = max(map(abs, row.values()), default=0.0)
        if weight:
            rows[number] = {index: part / weight for index, part in row.items()}
            right[number] /= weight
    return rows, right, scale, [pivot for group in linked(rows) for pivot in pivots_of(group, rows, right)]


def linked(rows: Sequence[dict[int, float]]) -> list[list[int]]:
    """The rows in groups that share no unknown: each is solved by itself, so that bodies that do not touch cost no more together."""
    groups: dict[int, list[int]] = {}  # by unknown: the rows of its group, the same list for all of them
    alone = []
    for number, row in enumerate(rows):
        met = {id(group): group for index in row if (group := groups.get(index)) is not None}
        own = max(met.values(), key=len, default=[])
        for group in met.values():
            if group is not own:
                own += group
                groups.update({index: own for member in group for index in rows[member]})
        own.append(number)
        groups.update(dict.fromkeys(row, own))
        alone += [] if row else [own]
    return [*{id(group): group for group in groups.values()}.values(), *alone]


def pivots_of(group: Sequence[int], rows: list[dict[int, float]], right: list[float]) -> list[tuple[int, int]]:
    """Reduces the rows of a group in place; (unknown, row) for each pivot. What is left of the other rows is rounding."""
    pivots, left = [], set(group)
    largest = {number: largest_in_row(rows[number]) for number in group}
    while left:
        best, place = SMALL, None
        for number in left:
            size, index = largest[number]
            if size > best:
                best, place = size, (index, number)
        if place is None:
            break
        index, number = place
        left.discard(number)
        pivots.append(place)
        factor = 1.0 / rows[number][index]
        row = {key: part * factor for key, part in rows[number].items()}
        row[index], rows[number] = 1.0, row
        right[number] *= factor
        for other in group:
            target = rows[other]
            share = target.pop(index, 0.0) if other != number else 0.0
            if share:
                for key, part in row.items():
                    if key != index:
                        target[key] = target.get(key, 0.0) - share * part
                right[other] -= share * right[number]
                largest[other] = largest_in_row(target) if other in left else largest[other]
    return pivots


def largest_in_row(row: dict[int, float]) -> tuple[float, int]:
    """The size of the largest number of a row, and its unknown."""
    best, place = 0.0, 0
    for index, part in row.items():
        if abs(part) > best:
            best, place = abs(part), index
    return best, place
