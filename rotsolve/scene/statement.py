"""Statement: the text of a problem, in which `{m}` stands for a given with its value, `m = 2 kg`, and `{value of m}` for `2 kg` alone."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from msgspec import Struct

from rotsolve.core.faults import Span
from rotsolve.language.problem import Wording
from rotsolve.language.words import hint, quoted
from rotsolve.scene.scope import Scope
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


def read_wordings(scope: Scope, node: Node, asked: Iterable[str], lines: tuple[str, ...]) -> tuple[Wording, ...]:
    """How answers are asked for, in the order of the file."""
    found = []
    for name, (_, item) in scope.entries(node, "`ask`", asked).items():
        if isinstance(item, Text):
            check_slots(scope, item, lines, f"the wording of `{name}`")
            found.append(Wording(name, item.value.strip(), item.span))
        else:
            scope.fault(item, f"the wording of `{name}` wants a text", "put it in quotes", "form")
    return tuple(found)


def check_slots(scope: Scope, node: Node, lines: tuple[str, ...], what: str = "`text`") -> None:
    """A fault for each slot that names none, at its place; the lines of a text that is folded are searched for it."""
    names = scope.names("given")
    for slot in slots(node.value) if isinstance(node, Text) else ():
        if slot.name not in names:
            found = ((number, line.find(slot.text)) for number, line in enumerate(lines, 1) if number >= node.span.line)
            place = next((Span(number, at + 1, len(slot.text)) for number, at in found if at >= 0), node.span)
            message = f"{quoted(slot.text)} in {what} names no given"
            scope.fault(place, message, hint(slot.name, names, "givens"), "unknown")
