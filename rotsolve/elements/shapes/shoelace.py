"""Shoelace: area, centre of mass and moment of inertia of a uniform polygon from its corners, by sums over its edges."""

from __future__ import annotations

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import Formula, total
from rotsolve.elements.shapes.shape import Place


def edges(corners: tuple[Place, ...]) -> list[tuple[Place, Place, Formula]]:
    """The edges of a polygon with twice the signed area of the triangle that each spans with the origin."""
    pairs = zip(corners, (*corners[1:], corners[0]), strict=True)
    return [(p, q, p[0] * q[1] - q[0] * p[1]) for p, q in pairs]


def area(corners: tuple[Place, ...]) -> Formula:
    """A = ½ Σ p × q."""
    return simplify(total([spanned for _, _, spanned in edges(corners)]) / 2)


def centroid(corners: tuple[Place, ...]) -> Place:
    """Σ (p + q) (p × q)/(6 A), the shoelace formula."""
    around = edges(corners)
    six = 3 * total([spanned for _, _, spanned in around])
    x, y = (simplify(total([(p[axis] + q[axis]) * spanned for p, q, spanned in around]) / six) for axis in (0, 1))
    return (x, y)


def moment(corners: tuple[Place, ...], mass: Formula) -> Formula:
    """M Σ (p·p + p·q + q·q) (p × q)/(6 Σ p × q), about the origin, less M d² of the centroid."""
    around = edges(corners)
    origin = total([(dot(p, p) + dot(p, q) + dot(q, q)) * spanned for p, q, spanned in around])
    centre = centroid(corners)
    return mass * simplify(origin / (6 * total([spanned for _, _, spanned in around])) - dot(centre, centre))


def products(corners: tuple[Place, ...], mass: Formula) -> tuple[Formula, Formula, Formula]:
    """M times the means of x², y² and x y about the centroid (C. Steger, On the Calculation of Arbitrary Moments of Polygons)."""
    around, centre = edges(corners), centroid(corners)
    whole = total([spanned for _, _, spanned in around])

    def mean(i: int, j: int) -> Formula:
        terms = [(2 * p[i] * p[j] + p[i] * q[j] + q[i] * p[j] + 2 * q[i] * q[j]) * spanned for p, q, spanned in around]
        return mass * simplify(total(terms) / (12 * whole) - centre[i] * centre[j])

    return mean(0, 0), mean(1, 1), mean(0, 1)


def dot(p: Place, q: Place) -> Formula:
    """p · q."""
    return p[0] * q[0] + p[1] * q[1]
