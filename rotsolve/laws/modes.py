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


class Carried(Struct, frozen=True):
    """The accelerations of bodies: their letters by those of the rates in any small motion, and the values of those that are given."""

    letters: Mapping[str, str] = {}
    given: Mapping[str, Formula] = {}


class FreeWays(Struct, frozen=True):
    """How a group can move: the letters of its independent rates, and all others by them and by those that are given."""

    rates: tuple[str, ...]
    tied: Mapping[str, Formula]
    carried: Carried = Carried()

    @property
    def virtual(self) -> dict[str, Formula]:
        """All rates by the independent ones, where what is given does not move."""
        still = dict.fromkeys(self.carried.given, ZERO)
        return {name: told.substitute(still) for name, told in self.tied.items()} | still


def independent_ways(
    facts: Facts, group: frozenset[str], rates: Sequence[str], vanishes: Callable[[Formula], bool], carried: Carried
) -> FreeWays | None:
    """The independent ones of `rates`, the most wanted first, by the rules; None where a rule tells none of them."""
    tied: dict[str, Formula] = {}
    for rule in facts.rules:
        if not group & set(rule.bodies):
            continue
        gap = simplify((rule.velocity[0] - rule.velocity[1]).substitute(tied))
        if is_zero(gap):
            continue
        held = (name for name in reversed(rates) if name in gap.symbols() and name not in carried.given)
        name = next((name for name in held if not vanishes(differentiate(gap, name))), "")
        value = solve_linear(gap, name) if name else None
        if value is None:
            return None
        tied = {other: simplify(told.substitute({name: value})) for other, told in tied.items()} | {name: value}
    own = tuple(name for name in rates if name not in tied and name not in carried.given)
    return FreeWays(own, tied, carried)


def generalized_forces(bodies: Sequence[BodyFacts], ways: FreeWays) -> list[Formula]:
    """What pushes along each way: the power of all forces and couples per independent rate, less that of m a of what is carried along."""
    power = total([size * rate for body in bodies for size, rate in supplied(body)]).substitute(ways.virtual)
    pushes = [differentiate(power, name) for name in ways.rates]
    if ways.carried.given:
        own = dict.fromkeys((ways.carried.letters[name] for name in ways.rates), ZERO)
        given = {ways.carried.letters[name]: value for name, value in ways.carried.given.items()}
        taken = inertial_power(bodies, ways).substitute(own).substitute(given)
        pushes = [push - differentiate(taken, name) for push, name in zip(pushes, ways.rates, strict=True)]
    still = dict.fromkeys(ways.rates, ZERO)
    return [simplify(push.substitute(still)) for push in pushes]


def inertial_power(bodies: Sequence[BodyFacts], ways: FreeWays) -> Formula:
    """The power of all m a and I α, by the independent rates, their accelerations and those that are given."""
    letters = ways.carried.letters
    grown = {name: Symbol(letters[name]) for name in (*ways.rates, *ways.carried.given)}
    accelerations = {letters[name]: told.substitute(grown) for name, told in ways.tied.items()}
    power = total([masses(body, size) * rate for body in bodies for size, rate in gained(body)])
    return power.substitute(accelerations).substitute(ways.virtual)


def inertias(bodies: Sequence[BodyFacts], ways: FreeWays) -> Matrix:
    """M: how much m a and I α per rate of one way grow with the acceleration of another."""
    power = inertial_power(bodies, ways)
    own = [ways.carried.letters[name] for name in ways.rates]
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
