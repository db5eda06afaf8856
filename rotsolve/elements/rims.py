"""Rims: the radius at which strings, belts and surfaces touch a round body."""

from __future__ import annotations

from rotsolve.algebra.formula import Formula
from rotsolve.elements.shapes import Particle, Shape
from rotsolve.language.problem import Body

PARTICLE = Particle()


def shape_of(body: Body) -> Shape:
    """The shape of a body; one without a shape is a particle."""
    return body.shape or PARTICLE


def rim_radius(body: Body, point: str | None) -> Formula | None:
    """Radius of the rim that a point names: a name of `radii`, else the shape's rim, else the last named of a stepped drum."""
    for name, radius in body.radii:
        if name == point:
            return radius
    shape = shape_of(body)
    for name, radius in getattr(shape, "radii", ()):
        if name == point:
            return radius  # type: ignore[no-any-return]
    if shape.outer is not None:
        return shape.outer
    if body.radius is not None:
        return body.radius
    return body.radii[-1][1] if body.radii else None
