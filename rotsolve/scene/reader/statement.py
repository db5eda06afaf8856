"""The statement of a problem: whether each `{m}` in it names a given."""

from __future__ import annotations

from rotsolve.core.faults import Span
from rotsolve.language.words import hint, quoted
from rotsolve.scene.statement import slots
from rotsolve.scene.tree.nodes import Node, Text
from rotsolve.scene.values.scope import Scope


def check_slots(scope: Scope, node: Node, lines: tuple[str, ...]) -> None:
    """A fault for each slot that names none, at its place; the lines of a text that is folded are searched for it."""
    names = scope.names("given")
    for slot in slots(node.value) if isinstance(node, Text) else ():
        if slot.name not in names:
            found = ((number, line.find(slot.text)) for number, line in enumerate(lines, 1) if number >= node.span.line)
            place = next((Span(number, at + 1, len(slot.text)) for number, at in found if at >= 0), node.span)
            message = f"{quoted(slot.text)} in `text` names no given"
            scope.fault(place, message, hint(slot.name, names, "givens"), "unknown")
