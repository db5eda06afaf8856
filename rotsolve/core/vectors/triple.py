"""Vectors of three components, and rotations as three rows: what geometry in space is written with.

Rotation about a unit vector n by φ, counterclockwise as seen against it: R v = v cos φ + (n × v) sin φ + n (n · v)(1 − cos φ) (Rodrigues;
Goldstein, Poole & Safko, Classical Mechanics, §4.7). Sums and products leave out zeros
and ones, so that components come out as M g l sin θ.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Negative, add, multiply, negate, sqrt
from rotsolve.core.vectors.heading import heading

Triple = tuple[Formula, Formula, Formula]
Rows = tuple[Triple, Triple, Triple]
NOTHING: Triple = (ZERO, ZERO, ZERO)
X: Triple = (ONE, ZERO, ZERO)
Y: Triple = (ZERO, ONE, ZERO)
Z: Triple = (ZERO, ZERO, ONE)
AS_DRAWN: Rows = (X, Y, Z)
AXES = ("x", "y", "z")


def triple(parts: Sequence[Formula]) -> Triple:
    """Three components as a vector."""
    x, y, z = parts
    return (x, y, z)


def vector_sum(*vectors: Triple) -> Triple:
    """The sum of vectors."""
    result = NOTHING
    for x, y, z in vectors:
        result = (add(result[0], x), add(result[1], y), add(result[2], z))
    return result


def minus(vector: Triple) -> Triple:
    x, y, z = vector
    return (negate(x), negate(y), negate(z))


def way_between(start: Triple, end: Triple) -> Triple:
    """The way from one place to another."""
    return NOTHING if start == end else vector_sum(end, minus(start))


def scaled_by(factor: Formula, vector: Triple) -> Triple:
    x, y, z = vector
    return (multiply(factor, x), multiply(factor, y), multiply(factor, z))


def cross_product(one: Triple, other: Triple) -> Triple:
    """one × other."""
    (a, b, c), (x, y, z) = one, other
    return (
        add(multiply(b, z), negate(multiply(c, y))),
        add(multiply(c, x), negate(multiply(a, z))),
        add(multiply(a, y), negate(multiply(b, x))),
    )


def dot_product(one: Triple, other: Triple) -> Formula:
    """one · other."""
    result: Formula = ZERO
    for a, x in zip(one, other, strict=True):
        result = add(result, multiply(a, x))
    return result


def square(value: Formula) -> Formula:
    """value², without a sign under the square."""
    operand = value.operand if isinstance(value, Negative) else value
    return ZERO if operand == ZERO else operand**2


def square_of(vector: Triple) -> Formula:
    """|v|²."""
    result: Formula = ZERO
    for part in vector:
        result = add(result, square(part))
    return result


def length_of(vector: Triple) -> Formula:
    """|v|: of one component its size."""
    parts = [part for part in vector if part != ZERO]
    return sqrt(square_of(vector)) if len(parts) != 1 else simplify(sqrt(square(parts[0])))


def unit_along(direction: Triple, positive: frozenset[str] = frozenset()) -> Triple:
    """The unit vector along a direction."""
    length = simplify(sqrt(square_of(direction)), positive=positive)
    if length == ONE:
        return direction
    x, y, z = (part if part == ZERO else part / length for part in direction)
    return (x, y, z)


def is_axis(vector: Triple) -> bool:
    """Whether a unit vector lies along one of the axes."""
    return sum(part != ZERO for part in vector) == 1


def turn_about(about: Triple, by: Formula) -> Rows:
    """The rows of the rotation about a unit vector by an angle."""
    angle = heading(by)
    return turn_by(about, angle.cos(), angle.sin())


def in_turn(turns: Iterable[tuple[Triple, Formula]], positive: frozenset[str] = frozenset()) -> Rows:
    """The rotation that turns one after the other come to, about axes that stay in space."""
    rows = AS_DRAWN
    for about, by in turns:
        rows = after(turn_about(unit_along(about, positive), by), rows)
    return rows


def turn_by(about: Triple, cos: Formula, sin: Formula) -> Rows:
    """The rows of the rotation about a unit vector by an angle of which cosine and sine are told."""
    columns = []
    for own in AS_DRAWN:
        share = dot_product(about, own)
        if is_axis(about):  # what lies along the axis stays, what lies across it turns
            columns.append(
                own if share != ZERO else vector_sum(scaled_by(cos, own), scaled_by(sin, cross_product(about, own)))
            )
            continue
        along = multiply(share, add(ONE, negate(cos)))
        columns.append(
            tidied(vector_sum(scaled_by(cos, own), scaled_by(sin, cross_product(about, own)), scaled_by(along, about)))
        )
    return transposed((columns[0], columns[1], columns[2]))


def aligning(axis: Triple, direction: Triple) -> Rows:
    """The rows of the least rotation that puts one of the axes along a unit vector."""
    across, cos = cross_product(axis, direction), dot_product(axis, direction)
    if across == NOTHING:
        return AS_DRAWN if cos == ONE else turn_by((axis[1], axis[2], axis[0]), negate(ONE), ZERO)
    sin = length_of(across)
    about = across if sin == ONE else tidied(scaled_by(ONE / sin, across))
    return turn_by(about, cos, sin)


def rotated(rows: Rows, vector: Triple) -> Triple:
    """R v."""
    return (dot_product(rows[0], vector), dot_product(rows[1], vector), dot_product(rows[2], vector))


def transposed(rows: Rows) -> Rows:
    """Rᵀ, the rotation back."""
    a, b, c = rows
    return ((a[0], b[0], c[0]), (a[1], b[1], c[1]), (a[2], b[2], c[2]))


def after(second: Rows, first: Rows) -> Rows:
    """The rotation that is one after the other: R₂ R₁."""
    columns = [rotated(second, column) for column in transposed(first)]
    return transposed((columns[0], columns[1], columns[2]))


def tidied(vector: Triple) -> Triple:
    """The vector with its components simplified."""
    x, y, z = (simplify(part) for part in vector)
    return (x, y, z)
