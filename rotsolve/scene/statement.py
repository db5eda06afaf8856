"""Statement: the text of a problem, in which `{m}` stands for a given with its value, `m = 2 kg`, and `{value of m}` for `2 kg` alone."""

from __future__ import annotations

import re
from collections.abc import Iterator

from msgspec import Struct

from rotsolve.core.faults import Span
from rotsolve.language.words import hint, quoted
from rotsolve.scene.scope import UNKNOWN, Scope
from rotsolve.scene.tree import Node, Text

BRACES = re.compile(r"\{\{|\}\}|\{(?P<inner>[^{}]*)\}")
ALONE = "value of "


class Slot(Struct, frozen=True):
    """A place in the text where a given is told: with its letter, or by its value `alone`; `text` is the place as written."""

    name: str
    alone: bool
    text: str


def prose_and_slots(text: str) -> Iterator[str | Slot]:
    """The text in pieces of prose and slots; `{{` and `}}` are braces."""
    position = 0
    for match in BRACES.finditer(text):
        yield text[position : match.start()]
        position = match.end()
        inner = match["inner"]
        if inner is None:
            yield match[0][0]
            continue
        words = " ".join(inner.split())
        yield Slot(words.removeprefix(ALONE), words.startswith(ALONE), match[0])
    yield text[position:]


def slots(text: str) -> Iterator[Slot]:
    """The slots of a text."""
    return (part for part in prose_and_slots(text) if isinstance(part, Slot))


def check_slots(scope: Scope, node: Node, lines: tuple[str, ...]) -> None:
    """A fault for each slot that names none, at its place; the lines of a text that is folded are searched for it."""
    names = scope.names("given")
    for slot in slots(node.value) if isinstance(node, Text) else ():
        if slot.name not in names:
            found = ((number, line.find(slot.text)) for number, line in enumerate(lines, 1) if number >= node.span.line)
            place = next((Span(number, at + 1, len(slot.text)) for number, at in found if at >= 0), node.span)
            message = f"{quoted(slot.text)} in `text` names no given"
            help = hint(slot.name, names, "givens")
            scope.fault(place, message, help, "unknown", cause=f"{UNKNOWN}{slot.name}")
