"""Marking: how answers are marked: points alone (`T: 3`), or a map with tolerance, form, unit, sign, deductions; `all` for every answer."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from msgspec.structs import replace

from rotsolve.algebra.formula import Number
from rotsolve.algebra.units.dimension import NONE, Dimension
from rotsolve.algebra.units.quantities import UnitValue, parse_quantity
from rotsolve.language.grammar import DEDUCT, MARKING
from rotsolve.language.keys import Key
from rotsolve.language.marks import ALL, FLAWS, Deduction, Marking, Tolerance
from rotsolve.language.words import quoted
from rotsolve.scene.elements import read_value
from rotsolve.scene.literals import dimension_in_words, parsed_quantity
from rotsolve.scene.scope import Scope
from rotsolve.scene.tree import Map, Node, Text

FIGURES = re.compile(r"(\d+)\s+figures?")
MOST_FIGURES = 15
MOST_POINTS = 1000


def read_marking(scope: Scope, node: Node, asked: Mapping[str, Dimension | None]) -> tuple[Marking, ...]:
    """What the section says of each answer, on top of what it says of all."""
    entries = scope.entries(node, "`marking`", [ALL, *asked], own=True)
    usual = Marking(ALL)
    if ALL in entries:
        usual = of_answer(scope, usual, *entries[ALL], None)
    own = [
        of_answer(scope, replace(usual, name=name), key, item, asked[name])
        for name, (key, item) in entries.items()
        if name != ALL
    ]
    if ALL in entries:
        others = {name: dimension for name, dimension in asked.items() if name not in entries}
        for name, dimension in others.items():
            check_measure(scope, usual.tolerance, entries[ALL][1], name, dimension)
    return (*own, usual)


def of_answer(scope: Scope, usual: Marking, key: Text, node: Node, dimension: Dimension | None) -> Marking:
    """The marking of one answer: points, or a map of what differs from what is usual."""
    written = replace(usual, span=key.span)
    if isinstance(node, Text):
        points = read_marks(scope, MARKING["points"], node, "points")
        return written if points is None else replace(written, points=points)
    entries = scope.entries(node, f"the marking of `{usual.name}`", MARKING)
    found = {word: READERS[MARKING[word].kind](scope, MARKING[word], item, word) for word, (_, item) in entries.items()}
    known = {word: value for word, value in found.items() if value is not None}
    if "deduct" in known:
        known["deduct"] = tuple((dict(usual.deduct) | known["deduct"]).items())
    marking = replace(written, **known)
    if "tolerance" in known:
        check_measure(scope, marking.tolerance, entries["tolerance"][1], usual.name, dimension)
    return marking


def check_measure(scope: Scope, tolerance: Tolerance, node: Node, name: str, dimension: Dimension | None) -> None:
    """A fault where an amount is of another dimension than the answer."""
    if tolerance.amount is None or dimension is None:
        return
    found = parse_quantity(tolerance.text).dimension
    if not found.matches(dimension):
        shown = "has no unit" if found == NONE else f"is {dimension_in_words(found)}"
        message = f"the tolerance {quoted(tolerance.text)} {shown}, but `{name}` is {dimension_in_words(dimension)}"
        scope.fault(node, message, "write a share, `1 %`, an amount with its unit, or `3 figures`", "dimension")


def read_tolerance(scope: Scope, key: Key, node: Node, label: str) -> Tolerance | None:
    """`2 %`, `0.05 m/s^2` or `3 figures`."""
    text = node.value.strip() if isinstance(node, Text) else ""
    figures = FIGURES.fullmatch(text)
    if figures and 1 <= int(figures[1]) <= MOST_FIGURES:
        return Tolerance(text, figures=int(figures[1]))
    amount = None if figures else parsed_quantity(text)
    if amount is not None and amount.unit is not None and amount.unit.text == "%":
        share = amount.value
        if isinstance(share, Number) and 0 <= share.value < 1:
            return Tolerance(text, share=share.value)
    elif amount is not None and not text.startswith(("-", "−")):
        return Tolerance(text, amount=amount.value)
    return scope.fault(node, f"`{label}` can't be {node.shown}", "write `2 %`, `0.05 m/s^2` or `3 figures`", "form")


def read_deductions(scope: Scope, key: Key, node: Node, label: str) -> dict[str, Deduction] | None:
    """What each flaw costs; one value stands for all of them."""
    if not isinstance(node, Map):
        cost = read_deduction(scope, key, node, label)
        return None if cost is None else dict.fromkeys(FLAWS, cost)
    entries = scope.entries(node, f"`{label}`", DEDUCT)
    found = {word: read_deduction(scope, DEDUCT[word], item, word) for word, (_, item) in entries.items()}
    return {word: cost for word, cost in found.items() if cost is not None}


def read_deduction(scope: Scope, key: Key, node: Node, label: str) -> Deduction | None:
    """`25 %` of the points, or a number of marks."""
    amount = parsed_quantity(node.value.strip()) if isinstance(node, Text) else None
    if amount is not None and amount.unit is not None and amount.unit.text == "%":
        share = amount.value
        if isinstance(share, Number) and 0 <= share.value <= 1:
            return Deduction(share.value, share=True)
    elif (marks := plain_number(amount)) is not None:
        return Deduction(marks)
    return scope.fault(node, f"`{label}` can't be {node.shown}", "write a share, `25 %`, or marks, `1/2`", "form")


def read_marks(scope: Scope, key: Key, node: Node, label: str) -> Fraction | None:
    """A number of marks."""
    marks = plain_number(parsed_quantity(node.value.strip()) if isinstance(node, Text) else None)
    if marks is None:
        help = f"write a number from 0 to {MOST_POINTS}, such as 2"
        scope.fault(node, f"`{label}` can't be {node.shown}", help, "form")
    return marks


def plain_number(amount: UnitValue | None) -> Fraction | None:
    """A number of points without a unit."""
    if amount is None or amount.unit is not None or not isinstance(amount.value, Number):
        return None
    return amount.value.value if 0 <= amount.value.value <= MOST_POINTS else None


READERS: dict[str, Callable[[Scope, Key, Node, str], Any]] = {
    "marks": read_marks,
    "tolerance": read_tolerance,
    "choice": lambda scope, key, node, label: read_value(scope, key, node, label, ""),
    "deductions": read_deductions,
}
