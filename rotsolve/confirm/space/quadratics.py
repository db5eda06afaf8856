"""Quadratics: the roots that quadratic equations in several rates share, as a steady motion has them.

Rates that no equation holds together, as of bodies that do not touch, are solved for apart: of a single one all roots are found, however
far they lie from each other; of several those that Newton's iteration comes to.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import islice, product

from rotsolve.confirm.linear import solved_generally

RIGHT = 1e-8  # of the largest number: what is left of an equation that holds
ROOTS = 8  # how many are told apart
STEPS = 40  # of Newton's iteration
NONE = 1e-11  # of the largest number in a row: what stands before a rate that is not in it

Model = tuple[
    list[float], list[list[float]], list[list[list[float]]]
]  # r₀ + Σ b_i x_i + Σ c_ij x_i x_j, component by component


def quadratic(over: Callable[[Sequence[float]], list[float]], count: int, scale: float) -> Model | None:
    """What is left over as a quadratic of the rates in units of a scale; None where it is nothing whatever they are."""

    def at(**parts: float) -> list[float]:
        return over([scale * parts.get(f"x{k}", 0.0) for k in range(count)])

    base = at()
    linear, square = [], [[base] * count for _ in range(count)]
    for i in range(count):
        up, down = at(**{f"x{i}": 1.0}), at(**{f"x{i}": -1.0})
        linear.append([(a - b) / 2 for a, b in zip(up, down, strict=True)])
        square[i][i] = [(a + b) / 2 - c for a, b, c in zip(up, down, base, strict=True)]
        for j in range(i):
            both = at(**{f"x{i}": 1.0, f"x{j}": 1.0})
            alone = [base, linear[i], linear[j], square[i][i], square[j][j]]
            mixed = [value - sum(parts) for value, *parts in zip(both, *alone, strict=True)]
            square[i][j] = square[j][i] = [part / 2 for part in mixed]
    size = max((abs(part) for row in (base, *linear, *(c for cs in square for c in cs)) for part in row), default=0.0)
    rate_parts = [part for row in (*linear, *(c for cs in square for c in cs)) for part in row]
    if max(map(abs, rate_parts), default=0.0) <= RIGHT * max(size, RIGHT):
        return None
    return base, linear, square


def shared_roots(model: Model) -> list[list[float]]:
    """The rates with which all equations hold, in units of the scale; of each group that is solved apart one with one."""
    base, linear, _ = model
    groups = rate_groups(model)
    size = row_sizes(model)
    alone = [n for n in range(len(base)) if not any(n in rows for _, rows in groups)]
    if any(abs(base[n]) > RIGHT * max(size, default=0.0) for n in alone):
        return []
    found = [list(roots_of_group(model, places, rows)) for places, rows in groups]
    roots = []
    for several in islice(product(*found), ROOTS):
        root = [0.0] * len(linear)
        for (places, _), values in zip(groups, several, strict=True):
            for place, value in zip(places, values, strict=True):
                root[place] = value
        roots.append(root)
    return roots


def rate_groups(model: Model) -> list[tuple[list[int], list[int]]]:
    """The rates that equations hold together, each group with its equations."""
    base, linear, square = model
    sizes, count = row_sizes(model), len(linear)
    held = []
    for n in range(len(base)):
        parts = [max(abs(linear[i][n]), *(abs(square[i][j][n]) for j in range(count))) for i in range(count)]
        held.append({i for i, part in enumerate(parts) if part > NONE * sizes[n]})
    groups: list[set[int]] = []
    for names in filter(None, held):
        touched = [group for group in groups if group & names]
        groups = [group for group in groups if not group & names] + [names.union(*touched)]
    return [(sorted(group), [n for n, names in enumerate(held) if names & group]) for group in groups]


def row_sizes(model: Model) -> list[float]:
    """The largest number of each equation."""
    base, linear, square = model
    return [
        max(abs(part) for part in (base[n], *(b[n] for b in linear), *(c[n] for row in square for c in row)))
        for n in range(len(base))
    ]


def roots_of_group(model: Model, places: Sequence[int], rows: Sequence[int]) -> Iterator[list[float]]:
    """The roots of some rates by the equations that hold them."""
    base, linear, square = model
    own: Model = (
        [base[n] for n in rows],
        [[linear[i][n] for n in rows] for i in places],
        [[[square[i][j][n] for n in rows] for j in places] for i in places],
    )
    if len(places) == 1:
        yield from ([root] for root in common_roots(own))
        return
    found: list[list[float]] = []
    for start in starts(len(places)):
        root = newton(own, start)
        if root is not None and all(math.dist(root, other) > 1e-6 * (1.0 + math.hypot(*root)) for other in found):
            found.append(root)
            yield root


def common_roots(model: Model) -> list[float]:
    """The real roots that all components of a quadratic of one rate share."""
    base, (linear,), ((square,),) = model
    sizes = [max(abs(a), abs(b), abs(c)) for a, b, c in zip(base, linear, square, strict=True)]
    best = max(range(len(sizes)), key=sizes.__getitem__)
    roots = quadratic_roots(square[best], linear[best], base[best])
    most = sizes[best]

    def holds(x: float) -> bool:
        left = (c + b * x + a * x * x for a, b, c in zip(square, linear, base, strict=True))
        return all(abs(part) <= 1e-7 * most * (1.0 + x * x) for part in left)

    return [root for root in roots if holds(root)]


def quadratic_roots(a: float, b: float, c: float) -> list[float]:
    """The real roots of a x² + b x + c, the smaller one first."""
    if abs(a) <= 1e-13 * max(abs(b), abs(c)):
        return [-c / b] if b else []
    inside = b * b - 4 * a * c
    if inside < -1e-13 * b * b or (inside < 0 and not b):
        return []
    whole = -0.5 * (b + math.copysign(math.sqrt(max(inside, 0.0)), b))
    roots = {whole / a, c / whole if whole else 0.0}
    return sorted(roots)


def starts(count: int) -> list[list[float]]:
    """Where Newton's iteration sets out from."""
    sizes = (0.31, -0.47, 2.3, -3.1, 0.05)
    return [[sizes[(number + k * (1 + number // 5)) % 5] for k in range(count)] for number in range(5 * min(count, 3))]


def newton(model: Model, start: Sequence[float]) -> list[float] | None:
    """A root near a start, by Gauss's and Newton's steps; None where it comes to none."""
    base, linear, square = model
    x, count = list(start), len(start)
    size = max((abs(part) for row in (base, *linear, *(c for cs in square for c in cs)) for part in row), default=1.0)
    for _ in range(STEPS):
        slopes = [
            [linear[i][n] + 2 * sum(square[i][j][n] * x[j] for j in range(count)) for i in range(count)]
            for n in range(len(base))
        ]
        left = [base[n] + sum(x[i] * (linear[i][n] + slopes[n][i]) for i in range(count)) / 2 for n in range(len(base))]
        if max(map(abs, left), default=0.0) <= 1e-12 * size * (1.0 + max(map(abs, x)) ** 2):
            return x
        rows = [{j: sum(slope[i] * slope[j] for slope in slopes) for j in range(count)} for i in range(count)]
        right = [-sum(slope[i] * part for slope, part in zip(slopes, left, strict=True)) for i in range(count)]
        step = solved_generally(rows, right, count).values
        x = [part + move for part, move in zip(x, step, strict=True)]
        if not all(map(math.isfinite, x)) or max(map(abs, x)) > 1e6:
            return None
    return None
