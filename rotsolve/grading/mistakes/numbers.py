"""Numbers misread: what is put in for a given at the end, in an answer that is right otherwise."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified, evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.formula import ONE, Formula
from rotsolve.core.derivation import Answer


def reread(right: Answer, letters: Mapping[str, Formula], values: Mapping[str, Formula]) -> Answer:
    """An answer with something else written for letters, and other numbers put in."""
    closed = None if right.closed is None else right.closed.substitute(letters)
    value = None
    if closed is not None and right.value is not None:
        value = number(closed, ONE if right.unit is None else right.unit.factor, values)
    parts = tuple(reread(part, letters, values) for part in right.components)
    return replace(right, formula=closed, closed=closed, value=value, components=parts, remark=(), angle=None)


def number(closed: Formula, factor: Formula, values: Mapping[str, Formula]) -> Certified | None:
    """The value in a unit; None where there is none."""
    if closed.symbols() - set(values):
        return None
    try:
        return evaluate(closed / factor, values)
    except Undefined:
        return None
