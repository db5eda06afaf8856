"""Values: a scalar as an exact formula in SI units, with its dimension and limits checked."""

from __future__ import annotations

import re

from rotsolve.algebra.certified.witness import note
from rotsolve.algebra.formula import ONE, PI, ZERO, Formula, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.dimension import DimensionError, dimension_of
from rotsolve.algebra.units.quantities import UnitError, parse_quantity
from rotsolve.core.quantity import DIMENSIONS
from rotsolve.language.words import quoted
from rotsolve.scene.tree.nodes import List, Node, Text
from rotsolve.scene.values.dims import infer
from rotsolve.scene.values.expressions import PathReader, expression
from rotsolve.scene.values.literals import (
    COMMA,
    EXPRESSION,
    LITERAL,
    Want,
    dimension_holds,
    limits_hold,
    unit_fault,
    unknown,
    whole_literal,
)
from rotsolve.scene.values.rough import size
from rotsolve.scene.values.scope import Scope

__all__ = ["Want", "value"]


def value(scope: Scope, node: Node, want: Want, paths: PathReader | None = None) -> Formula | None:
    """The formula that a scalar writes; None after a fault."""
    if not isinstance(node, Text):
        found = "a list" if isinstance(node, List) else "a map"
        scope.fault(node, f"`{want.label}` wants one value, but this is {found}", kind="form")
        return None
    if not node.value.strip():
        scope.fault(node, f"`{want.label}` is empty", kind="form")
        return None
    if node.value.strip() == "unknown":
        return unknown(scope, node, want)
    literal = LITERAL.fullmatch(node.value)
    if literal and (result := whole_literal(scope, node, want, (literal["unit"] or "").strip())) is not EXPRESSION:
        return result
    if comma_fault(scope, node):
        return None
    formula = expression(scope, node, want, paths)
    if formula is None or not check_dimension(scope, node, formula, want):
        return None
    return formula if check_limits(scope, node, formula, want) else None


def comma_fault(scope: Scope, node: Text) -> bool:
    """`12,5 kg`: reported with the point that was meant."""
    if "," not in node.value or not re.match(COMMA, node.value):
        return False
    try:
        parse_quantity(node.value)
    except UnitError as error:
        unit_fault(scope, node, error)
        return True
    return False


def check_dimension(scope: Scope, node: Text, formula: Formula, want: Want) -> bool:
    """Whether the formula has the dimension that is wanted; a letter of unknown dimension gets it from here."""
    wanted = DIMENSIONS[want.dimension] if want.dimension else None
    known = {**scope.dimensions, **want.extra, "time": DIMENSIONS["time"]}
    missing = [name for name in sorted(formula.symbols()) if known.get(name) is None]
    if missing:
        found = infer(formula, missing, known, wanted)
        if found is not None:
            scope.dimensions[missing[0]] = found
        return True
    try:
        dimension = dimension_of(formula, {name: known[name] for name in formula.symbols()})  # type: ignore[misc]
    except DimensionError as error:
        message = as_written(scope, formula, error.message)
        scope.fault(node, f"the dimensions in {quoted(node.value)} don't agree: {message}", kind="dimension")
        return False
    shown, given = node.value.strip(), scope.givens.get(node.value.strip())
    unit = given.unit.text if given and given.unit else ""
    if given is not None and given.value is not None:
        shown = f"{shown} = {given.text}"
    return dimension_holds(scope, node, want, dimension, shown, unit, formula == ZERO)


def as_written(scope: Scope, formula: Formula, message: str) -> str:
    """The message with letters that the reader made replaced by what the scene says."""
    for name in formula.symbols():
        given = scope.givens.get(name)
        if given is not None and given.automatic:
            message = message.replace(to_text(Symbol(name)), given.text)
    return message


def gaps(formula: Formula, limits: str) -> tuple[Formula, ...]:
    """What is not negative where a value lies within its limits."""
    if not limits or not formula.symbols():
        return ()
    above = {"fraction": ONE - formula, "acute": PI / 2 - formula}
    return (formula, above[limits]) if limits in above else (formula,)


def check_limits(scope: Scope, node: Text, formula: Formula, want: Want) -> bool:
    number = size(formula, scope.numbers) if want.limits else None
    for gap in gaps(formula, want.limits):
        note(gap)
    shown = node.value.strip()
    given = scope.givens.get(shown)
    if given is not None and given.text:
        shown = f"{shown} = {given.text}"
    return limits_hold(scope, node, number, want, shown)
