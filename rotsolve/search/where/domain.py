"""Domains: between which values a letter of the scene can lie, and the signs of what the givens settle."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.certified import sign
from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.elements.shapes import Rod
from rotsolve.language.problem import points_of
from rotsolve.motion.positive import is_angle
from rotsolve.search.search import Search


class Domain(Struct, frozen=True):
    """From `low` to `high`, both ends included; None where there is no end on that side."""

    low: Formula | None
    high: Formula | None


def domain_of(letter: str, search: Search) -> Domain:
    """A place along a rod lies between its ends, an angle may be any, everything else with a dimension is positive."""
    configuration = search.scene.configuration
    for ref in points_of(configuration.problem):
        body = configuration.bodies.get(ref.owner)
        if ref.argument == Symbol(letter) and body is not None and isinstance(body.shape, Rod):
            return Domain(ZERO, body.shape.extent())
    given = search.givens[letter]
    return Domain(None if given.dimension is None or is_angle(given) else ZERO, None)


def sign_of(value: Formula, search: Search) -> int | None:
    """The certified sign of a formula at the givens; None where they do not tell."""
    return sign.sign_of(value, search.values, search.solver.positive)
