"""Numbers: an answer in closed form with other letters written in it, and other numbers put in."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified, evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.formula import ONE, Call, Formula
from rotsolve.core.derivation import Answer


def reread(answer: Answer, letters: Mapping[str, Formula], values: Mapping[str, Formula]) -> Answer:
    """An answer with something else written for letters, and with other numbers; without one where it has no closed form."""
    closed = None if answer.closed is None else answer.closed.substitute(letters)
    value = None
    if closed is not None:
        signed = (
            Call("abs", (closed,)) if answer.components else closed
        )  # the size of a vector, whatever its letters come to
        value = number(signed, ONE if answer.unit is None else answer.unit.factor, values)
    parts = tuple(reread(part, letters, values) for part in answer.components)
    return replace(answer, formula=closed, closed=closed, value=value, components=parts, remark=(), angle=None)


def number(closed: Formula, factor: Formula, values: Mapping[str, Formula]) -> Certified | None:
    """The value in a unit; None where there is none."""
    if closed.symbols() - set(values):
        return None
    try:
        return evaluate(closed / factor, values)
    except Undefined:
        return None
