"""Modes: small motions of tied bodies in several ways, M q̈ + K q = 0 and det(K − ω² M) = 0.

The equations of motion are those of d'Alembert: in every motion that the rules allow the forces have the power of m a and I α together,
so that each independent rate has a row of its own, in which no ideal support occurs (Goldstein, Poole & Safko, Classical Mechanics,
§1.4, §6.2).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from msgspec import Struct

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.linear import solve_linear
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Symbol, add, multiply, negate, total
from rotsolve.core.facts import BodyFacts, Facts
from rotsolve.laws.groups import gained, supplied

Matrix = tuple[tuple[Formula, ...], ...]


class FreeWays(Struct, frozen=True):
    """How a group can move: the letters of its independent rates, and all others by them."""

    rates: tuple[str, ...]
    tied: Mapping[str, Formula]


def free_ways(
    facts: Facts, group: frozenset[str], rates: Sequence[str], vanishes: Callable[[Formula], bool]
) -> FreeWays | None:
    """The independent ones of `rates`, the most wanted first, by the rules; None where a rule tells none of them."""
    tied: dict[str, Formula] = {}
    for rule in facts.rules:
        if not group & set(rule.bodies):
            continue
        gap = simplify((rule.velocity[0] - rule.velocity[1]).substitute(tied))
        if is_zero(gap):
            continue
        held = (name for name in reversed(rates) if name in gap.symbols())
        name = next((name for name in held if not vanishes(differentiate(gap, name))), "")
        value = solve_linear(gap, name) if name else None
        if value is None:
            return None
        tied = {other: simplify(told.substitute({name: value})) for other, told in tied.items()} | {name: value}
    return FreeWays(tuple(name for name in rates if name not in tied), tied)


def generalized_forces(bodies: Sequence[BodyFacts], ways: FreeWays) -> list[Formula]:
    """The generalized force of each way: the power of all forces and couples per independent rate."""
    power = total([size * rate for body in bodies for size, rate in supplied(body)]).substitute(dict(ways.tied))
    return [simplify(differentiate(power, name)) for name in ways.rates]


def inertias(bodies: Sequence[BodyFacts], ways: FreeWays, accelerations: Mapping[str, str]) -> Matrix:
    """M: how much m a and I α per rate of one way grow with the acceleration of another; `accelerations` by the letters of rates."""
    tied = dict(ways.tied)
    power = total([masses(body, size) * rate for body in bodies for size, rate in gained(body)])
    grown = {name: Symbol(accelerations[name]) for name in ways.rates}
    power = power.substitute({accelerations[name]: told.substitute(grown) for name, told in tied.items()}).substitute(
        tied
    )
    own = [accelerations[name] for name in ways.rates]
    still = dict.fromkeys((*ways.rates, *own), ZERO)
    return tuple(
        tuple(simplify(differentiate(differentiate(power, rate), name).substitute(still)) for name in own)
        for rate in ways.rates
    )


def masses(body: BodyFacts, size: Formula) -> Formula:
    """A mass, or a moment of inertia written out."""
    if body.inertia is not None and size == body.inertia.letter:
        return body.inertia.formula
    return size


def characteristic(inertia: Matrix, stiffness: Matrix, square: Formula) -> Matrix:
    """K − ω² M."""
    rows = zip(stiffness, inertia, strict=True)
    return tuple(
        tuple(add(back, negate(multiply(square, mass))) for back, mass in zip(*row, strict=True)) for row in rows
    )


def determinant(matrix: Matrix) -> Formula:
    """det, by its first row."""
    if not matrix:
        return ONE
    terms = [multiply(part, signed_minor(matrix, 0, place)) for place, part in enumerate(matrix[0])]
    return terms[0] if len(terms) == 1 else total(terms)


def signed_minor(matrix: Matrix, row: int, column: int) -> Formula:
    """(−1)^(i + j) times the determinant without a row and a column."""
    rest = tuple(
        tuple(part for place, part in enumerate(line) if place != column)
        for number, line in enumerate(matrix)
        if number != row
    )
    value = determinant(rest)
    return negate(value) if (row + column) % 2 else value


def shapes(matrix: Matrix) -> Iterator[tuple[Formula, ...]]:
    """The amplitudes of a mode, as far as each row of the others tells them: the cofactors of a row of K − ω² M."""
    for row in reversed(range(len(matrix))):
        yield tuple(signed_minor(matrix, row, column) for column in range(len(matrix)))
