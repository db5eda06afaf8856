"""Answers: published results beside the asked quantities: a number with its unit, a formula, a word, or a list of a vector's components."""

from __future__ import annotations

from typing import Any

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.notation.tokens import FormulaError
from rotsolve.core.faults import Fault
from rotsolve.language.problem import Published, TimeValue
from rotsolve.language.words import quoted
from rotsolve.scene.literals import LITERAL, Want, parsed_quantity
from rotsolve.scene.scope import Scope
from rotsolve.scene.tree import List, Node, Text
from rotsolve.scene.values import expression, read_time

KEYS = ("formula", "symbolic", "value", "at", "tolerance", "word")
FORM = "write `4.9 N`, a formula, a word, or `{formula: …, value: …, tolerance: …}`"


def read_published(scope: Scope, name: str, key: Text, node: Node, asked: dict[str, Any]) -> Published | None:
    """One entry of `answers`."""
    if isinstance(node, (Text, List)):
        return read_single(scope, name, key, node, asked)
    entries = scope.entries(node, f"answer `{name}`", KEYS)
    found: dict[str, Any] = {}
    texts = []
    for word, (_, written) in entries.items():
        if word in ("formula", "symbolic") and isinstance(written, List):
            found["formulas"] = component_formulas(scope, written, asked)
            texts.append(joined_items(written))
        elif word == "word" and isinstance(written, Text):
            texts.append(written.value.strip())
        elif word in ("formula", "symbolic") and isinstance(written, Text):
            found["formula"] = answer_formula(scope, written, asked)
            texts.append(written.value)
        elif word == "at":
            found["at"] = time_of(scope, written)
        elif word == "tolerance":
            found["tolerance"] = tolerance_of(scope, written)
        else:
            published = read_single(scope, name, key, written, asked)
            if published is not None:
                found |= {"value": published.value, "unit": published.unit, "values": published.values}
                texts.append(published.text)
    if not texts:
        return scope.fault(key, f"the answer `{name}` is empty", FORM, "form")
    return Published(name, " = ".join(texts), span=key.span, **found)


def read_single(scope: Scope, name: str, key: Text, node: Node, asked: dict[str, Any]) -> Published | None:
    """A list of numbers or formulas, a number with its unit, a formula, or a word."""
    if isinstance(node, List):
        return read_several(scope, name, key, node, asked)
    if not isinstance(node, Text):
        return scope.fault(node, f"the answer `{name}` can't be a map here", FORM, "form")
    text = node.value.strip()
    if name in scope.choices:
        return Published(name, text, span=key.span)
    if LITERAL.fullmatch(text) and (quantity := parsed_quantity(text)) is not None:
        return Published(name, text, None, quantity.value, quantity.unit, key.span)
    if is_words(text, {*scope.givens, *asked}):
        return Published(name, text, span=key.span)
    formula = answer_formula(scope, node, asked)
    return None if formula is None else Published(name, text, formula, span=key.span)


def is_words(text: str, names: set[str]) -> bool:
    """Whether the text is prose (`up the slope`): words only, the first of them no letter of the scene."""
    words = text.replace(",", " ").replace("-", " ").split()
    if not words or not all(word.isalpha() for word in words) or words[0] in names:
        return False
    try:
        parse(text, names)
    except FormulaError:
        return True
    return False


def read_several(scope: Scope, name: str, key: Text, node: List, asked: dict[str, Any]) -> Published | None:
    """The components of a vector, or the entries of a matrix row by row: numbers with units, or formulas."""
    items = flattened(node)
    for item in items:
        if not isinstance(item, Text):
            return scope.fault(item, f"an item of the answer `{name}` is a map", "write `[1.2 N, 3.4 N]`", "form")
    if not items:
        return scope.fault(node, f"the answer `{name}` is empty", FORM, "form")
    quantities = [parsed_quantity(item.value.strip()) for item in items if isinstance(item, Text)]
    numbers = [quantity for quantity in quantities if quantity is not None]
    if len(numbers) < len(quantities):
        return Published(name, joined_items(node), span=key.span, formulas=component_formulas(scope, node, asked))
    values: tuple[Formula, ...] = tuple(quantity.value for quantity in numbers)
    unit = next((quantity.unit for quantity in numbers if quantity.unit is not None), None)
    return Published(name, joined_items(node), None, None, unit, key.span, values)


def flattened(node: List) -> list[Node]:
    """The items of a list, of a matrix row by row."""
    return [part for item in node.items for part in (flattened(item) if isinstance(item, List) else [item])]


def joined_items(node: List) -> str:
    return ", ".join(item.value.strip() for item in flattened(node) if isinstance(item, Text))


def component_formulas(scope: Scope, node: List, asked: dict[str, Any]) -> tuple[Formula, ...]:
    """The formulas of a vector's components or of a matrix's entries."""
    found = [answer_formula(scope, item, asked) for item in flattened(node) if isinstance(item, Text)]
    return tuple(formula for formula in found if formula is not None)


def time_of(scope: Scope, node: Node) -> TimeValue | None:
    """When a function of time has the published number."""
    try:
        return read_time(node.value if isinstance(node, Text) else "")
    except ValueError:
        return scope.fault(node, "`at` wants a time, such as `2 s`", kind="form")


def tolerance_of(scope: Scope, node: Node) -> Formula | None:
    quantity = parsed_quantity(node.value.strip()) if isinstance(node, Text) else None
    if quantity is None:
        scope.fault(node, "`tolerance` wants a number, such as `1 %` or `0.05 N`", kind="form")
    return quantity.value if quantity else None


def answer_formula(scope: Scope, node: Text, asked: dict[str, Any]) -> Formula | None:
    """The formula of a published answer, over givens and other answers."""
    before = len(scope.faults)
    formula = expression(scope, node, Want("answer", letter="x", extra=dict(asked), varies=True), None)
    if formula is None and len(scope.faults) == before:
        scope.faults.append(Fault(f"{quoted(node.value)} is no answer", node.span, FORM, "formula"))
    return formula
