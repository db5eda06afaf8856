"""Domains: between which values a letter of the scene can lie, and which of two closed forms is the larger there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields, is_dataclass

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import Problem, simplify
from rotsolve.algebra.exact.signs import Signs
from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.elements.shapes import Rod
from rotsolve.inquiry.answering import Inquiry
from rotsolve.inquiry.signs import is_angle
from rotsolve.scene.model import Path, PointRef


@dataclass(frozen=True)
class Domain:
    """From `low` to `high`, both ends included; None where there is no end on that side."""

    low: Formula | None
    high: Formula | None


def domain_of(letter: str, inquiry: Inquiry) -> Domain:
    """A place along a rod lies between its ends, an angle may be any, everything else with a dimension is positive."""
    arrangement = inquiry.history.arrangement
    for ref in points_of(arrangement.problem):
        body = arrangement.bodies.get(ref.owner)
        if ref.argument == Symbol(letter) and body is not None and isinstance(body.shape, Rod):
            return Domain(ZERO, body.shape.extent())
    given = inquiry.givens[letter]
    return Domain(None if given.dimension is None or is_angle(given) else ZERO, None)


def points_of(item: object) -> Iterator[PointRef | Path]:
    """All points and paths that a scene speaks of."""
    if isinstance(item, (PointRef, Path)):
        yield item
    elif isinstance(item, tuple):
        for part in item:
            yield from points_of(part)
    elif is_dataclass(item) and not isinstance(item, Formula):
        for entry in fields(item):
            yield from points_of(getattr(item, entry.name))


def sign_of(value: Formula, inquiry: Inquiry) -> int | None:
    """The certified sign of a formula: by its number, else from the signs of its letters; None where neither tells."""
    value = simplify(value, order=inquiry.solver.order, positive=inquiry.solver.positive)
    if value == ZERO:
        return 0
    if not value.symbols() - set(inquiry.values):
        try:
            return evaluate(value, inquiry.values, digits=6).sign
        except (Undefined, ValueError):
            return None
    problem = Problem([value], positive=inquiry.solver.positive)
    top, bottom = problem.field.cancel(problem.ratio())
    signs = Signs(problem.field, inquiry.solver.positive)
    found = [1 if signs.nonnegative(part) else -1 if signs.nonnegative(-part) else 0 for part in (top, bottom)]
    return found[0] * found[1] or None
