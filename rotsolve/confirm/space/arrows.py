"""Arrows: vectors of three floats and rotations as three rows, by components along the axes of space."""

from __future__ import annotations

import math

Arrow = tuple[float, float, float]
Turned = tuple[Arrow, Arrow, Arrow]  # the rows of a matrix
STILL: Arrow = (0.0, 0.0, 0.0)
X: Arrow = (1.0, 0.0, 0.0)
Y: Arrow = (0.0, 1.0, 0.0)
Z: Arrow = (0.0, 0.0, 1.0)
ALONG = (X, Y, Z)
TINY = 1e-12  # of a sine or cosine: rounding
ROUNDING = 1e-15  # of the sine or cosine of a right angle


def sum_of(*arrows: Arrow) -> Arrow:
    return (sum(a[0] for a in arrows), sum(a[1] for a in arrows), sum(a[2] for a in arrows))


def less(a: Arrow, b: Arrow) -> Arrow:
    """a − b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scaled(factor: float, a: Arrow) -> Arrow:
    return (factor * a[0], factor * a[1], factor * a[2])


def crossed(a: Arrow, b: Arrow) -> Arrow:
    """a × b."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def inner_product(a: Arrow, b: Arrow) -> float:
    """a · b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def arrow_length(a: Arrow) -> float:
    return math.sqrt(inner_product(a, a))


def normed(a: Arrow) -> Arrow:
    """The unit vector along an arrow; ZeroDivisionError for one of no length."""
    return scaled(1.0 / arrow_length(a), a)


def times_arrow(rows: Turned, a: Arrow) -> Arrow:
    """R a."""
    (p, q, r), (s, t, u), (v, w, k) = rows  # written out, as this is most of what following a motion takes
    x, y, z = a
    return (p * x + q * y + r * z, s * x + t * y + u * z, v * x + w * y + k * z)


def rows_back(rows: Turned) -> Turned:
    """Rᵀ."""
    a, b, c = rows
    return ((a[0], b[0], c[0]), (a[1], b[1], c[1]), (a[2], b[2], c[2]))


def product_of(first: Turned, second: Turned) -> Turned:
    """A B."""
    columns = rows_back(second)
    return (times_arrow(columns, first[0]), times_arrow(columns, first[1]), times_arrow(columns, first[2]))


def rotation_about(axis: Arrow, angle: float) -> Turned:
    """The rotation about an axis, counterclockwise as seen against it: n nᵀ + cos φ (1 − n nᵀ) + sin φ [n]×.

    Right angles are exact: what is thin along an axis of space has no inertia about it, and 10⁻¹⁷ of one would be some.
    """
    (x, y, z), c, s = (
        normed(axis),
        *(0.0 if abs(part) < ROUNDING else part for part in (math.cos(angle), math.sin(angle))),
    )
    a, b, d = scaled(1.0 - c, (x, y, z))
    return (
        (a * x + c, b * x - s * z, d * x + s * y),
        (a * y + s * z, b * y + c, d * y - s * x),
        (a * z - s * y, b * z + s * x, d * z + c),
    )


def least_turn(start: Arrow, end: Arrow) -> Turned:
    """The least rotation that takes one unit vector to another; to the opposite one that about y of z, about z of x, about x of y."""
    axis, cosine = crossed(start, end), inner_product(start, end)
    if arrow_length(axis) < TINY:
        along = next((ALONG[k - 1] for k in range(3) if abs(start[k]) > 1.0 - TINY), None)
        return ALONG if cosine > 0 else rotation_about(along or square_to(start), math.pi)
    return rotation_about(axis, math.atan2(arrow_length(axis), cosine))


def square_to(a: Arrow) -> Arrow:
    """A direction square to another: of one along an axis the next of x, y, z."""
    other = min(range(3), key=lambda k: abs(a[k]))
    return normed(crossed(a, ALONG[other]))


def seen_from(rows: Turned, matrix: Turned) -> Turned:
    """R A Rᵀ: a matrix of turned axes in those of space."""
    return product_of(product_of(rows, matrix), rows_back(rows))
