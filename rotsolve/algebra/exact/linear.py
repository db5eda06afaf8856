"""Linear: one linear equation, and exact systems of them by fraction-free elimination that leaves the asked unknown to the end."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from functools import lru_cache

from rotsolve.algebra.exact.field import Field, Poly, Ratio
from rotsolve.algebra.exact.normal import REMEMBERED, Fractions, concerning, expanded
from rotsolve.algebra.formula import Formula, Symbol

Row = dict[int, Poly]  # generator of the unknown -> coefficient; CONSTANT -> the rest
CONSTANT = -1


class Singular(ValueError):
    """The equations do not settle all unknowns, or contradict each other."""


class NotLinear(ValueError):
    """An equation is not linear in the unknowns."""


def solve_linear(
    f: Formula, unknown: str, *, order: Sequence[str] = (), positive: Collection[str] = ()
) -> Formula | None:
    """The unknown from f = 0; None when f is not linear in it or does not hold it."""
    return _solve_linear(f, unknown, *concerning(f, order, positive, unknown))


@lru_cache(REMEMBERED)
def _solve_linear(f: Formula, unknown: str, order: tuple[str, ...], positive: frozenset[str]) -> Formula | None:
    problem, parts = expanded(f, unknown, order, positive)
    if parts is None or len(parts) != 2:
        return None
    return problem.shortest((-parts[0], parts[1]))


def solve_all(
    equations: Sequence[Formula], unknowns: Sequence[str], order: Sequence[str] = (), positive: Collection[str] = ()
) -> dict[str, Formula]:
    """All unknowns from equations (each a formula that is zero) that are linear in them, by one elimination."""
    problem = Fractions(equations, order, positive, extra=unknowns)
    return {name: problem.shortest(ratio) for name, ratio in eliminated(problem, unknowns).items()}


def eliminated(problem: Fractions, unknowns: Sequence[str]) -> dict[str, Ratio]:
    """All unknowns of a linear problem as fractions in lowest terms, not yet written as a textbook would."""
    ring, columns = problem.field, {problem.field.index[Symbol(name)]: name for name in unknowns}
    others = [j for j in range(len(ring.atoms)) if j not in columns]
    bound = {j: name for j in others for name in unknowns if ring.mentions(j, name)}  # roots, sines and the like
    rows = {k: _row(problem, k, columns, bound) for k in range(len(problem.formulas))}
    pivots = _eliminate(ring, rows, set(columns))
    used = set(pivots.values())
    for k, row in rows.items():
        if k not in used and row:
            raise Singular(f"equation {k + 1} contradicts the others")
    missing = next((name for i, name in columns.items() if i not in pivots), None)
    if missing is not None:
        raise Singular(f"{missing} is not settled: too few equations")
    found: dict[int, Ratio] = {}
    for i, k in reversed(pivots.items()):  # a pivot's row holds no unknown that was cleared before it
        found[i] = _solved(ring, rows[k], i, found)
    return {name: found[i] for i, name in columns.items()}


def _solved(ring: Field, row: Row, column: int, found: Mapping[int, Ratio]) -> Ratio:
    """The unknown of a column from its row, the others being found."""
    others = [i for i in row if i not in (column, CONSTANT)]
    below = ring.one
    for i in others:
        under = found[i][1]
        if below != under:  # nearly always all unknowns have one denominator
            below = under if below.is_one() else below * (under / below.gcd(under))
    above = row.get(CONSTANT, ring.zero) * below
    for i in others:
        top, under = found[i]
        above = above + row[i] * (top if under == below else top * (below / under))
    return ring.cancel((ring.reduce(-above), ring.reduce(below * row[column])))


def _row(problem: Fractions, k: int, columns: dict[int, str], bound: Mapping[int, str]) -> Row:
    """Equation k as coefficients of the unknowns and the rest; refused where an unknown is `bound` in a root or a sine."""
    ring = problem.field
    poly = problem.numerator(k)
    degrees = poly.degrees()
    for j, name in bound.items():
        if degrees[j]:
            raise NotLinear(f"equation {k + 1} is not linear in {name}")
    row: Row = {}
    for i in (i for i in columns if degrees[i]):
        slope = poly.derivative(i)
        held = () if slope.is_constant() else slope.degrees()
        if degrees[i] > 1 or (held and any(held[j] for j in columns)):
            raise NotLinear(f"equation {k + 1} is not linear in {columns[i]}")
        row[i] = slope
        poly = poly - slope * ring.gens[i]
    if len(poly):
        row[CONSTANT] = poly
    return row


def _eliminate(ring: Field, rows: dict[int, Row], columns: set[int]) -> dict[int, int]:
    """Clear all the columns that can be; returns them in order, each with the row used as its pivot."""
    pivots: dict[int, int] = {}
    used: set[int] = set()
    while columns:
        holders: dict[int, list[int]] = {}
        for k, row in rows.items():
            if k not in used:
                for i in row:
                    if i in columns:
                        holders.setdefault(i, []).append(k)
        if not holders:
            return pivots
        column, pivot = _best(rows, holders)
        for k in holders[column]:
            if k != pivot:
                rows[k] = _combine(ring, rows[k], rows[pivot], column)
        used.add(pivot)
        pivots[column] = pivot
        columns.discard(column)
    return pivots


def _best(rows: dict[int, Row], holders: dict[int, list[int]]) -> tuple[int, int]:
    """The column and pivot row that make the least work: few entries to clear, short pivot."""
    best: tuple[tuple[int, int, int], int, int] | None = None
    for column, members in holders.items():
        for k in members:
            row = rows[k]
            cost = ((len(members) - 1) * (len(row) - 1), len(row[column]), len(row))
            if best is None or cost < best[0]:
                best = (cost, column, k)
    assert best is not None
    return best[1], best[2]


def _combine(ring: Field, row: Row, pivot: Row, column: int) -> Row:
    """The row with the column cleared by the pivot row, divided by what its entries have in common."""
    a, p = row[column], pivot[column]
    common = a.gcd(p)
    if not common.is_one():
        a, p = a / common, p / common
    result: Row = {i: value * p for i, value in row.items() if i != column}
    for i, value in pivot.items():
        if i != column:
            result[i] = result[i] - value * a if i in result else -value * a
    result = {i: reduced for i, value in result.items() if len(reduced := ring.reduce(value))}
    return _primitive(result)


def _primitive(row: Row) -> Row:
    """The row divided by the greatest common divisor of its entries."""
    common: Poly = None
    for value in sorted(row.values(), key=len):
        common = value if common is None else common.gcd(value)
        if common.is_one():
            return row
    return row if common is None else {i: value / common for i, value in row.items()}
