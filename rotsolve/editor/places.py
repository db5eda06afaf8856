"""Places: the names of a text for an outline view, and where the name at a place is declared."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from rotsolve.core.faults import Span
from rotsolve.editor.help import word_under
from rotsolve.editor.scene_text import SceneText
from rotsolve.scene.tree import Map, Node, Text


class OutlineEntry(NamedTuple):
    """A section, or a name in one: where it stands, how far what belongs to it goes (in lines from 1), and what it is."""

    name: str
    span: Span
    last: int
    detail: str
    inner: tuple[OutlineEntry, ...] = ()


def symbols(scene: SceneText) -> Iterator[OutlineEntry]:
    """The sections with their names."""
    tree = scene.tree
    for key, node in tree.entries if isinstance(tree, Map) else ():
        inner = tuple(
            OutlineEntry(name.value, name.span, last_line(value, name), value.value if isinstance(value, Text) else "")
            for name, value in (node.entries if isinstance(node, Map) else ())
        )
        yield OutlineEntry(
            key.value, key.span, last_line(node, key), node.value if isinstance(node, Text) else "", inner
        )


def last_line(node: Node, key: Text) -> int:
    """The last line on which something of a value stands."""
    if isinstance(node, Map):
        return max((last_line(value, name) for name, value in node.entries), default=key.span.line)
    if isinstance(node, Text):
        return max(node.span.line, key.span.line)
    return max((last_line(item, key) for item in node.items), default=key.span.line)


def declared_at(scene: SceneText, line: int, column: int) -> Span | None:
    """Where the name at a place is declared; line and column count from 0."""
    found = scene.at(line, column)
    word = word_under(found) if found is not None else None
    return scene.scope.places.get(word[0]) if word is not None else None
