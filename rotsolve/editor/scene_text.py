"""Scene text: one version of a text as an editor asks about it: its faults, its tree as far as it goes, what the reader knows by it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from functools import cached_property
from typing import NamedTuple

from rotsolve.core.faults import Fault, SceneError, Span
from rotsolve.editor.outline import TextEnd, outlined, place_after
from rotsolve.language.grammar import SECTIONS
from rotsolve.scene.read import Sections, read_text
from rotsolve.scene.scope import Scope
from rotsolve.scene.tree import BYTES, List, Map, Node, Text

Steps = tuple[str | int, ...]


class ScalarAt(NamedTuple):
    """The scalar at a place: the way to it, whether it is a key, itself, and how many characters of it stand before the place."""

    path: Steps
    is_key: bool
    text: Text
    offset: int


class SceneText:
    """A version of a text; what is asked of it is worked out once."""

    def __init__(self, text: str) -> None:
        self.whole = text
        same = text.replace("\r\n", "\n").replace("\r", "\n")
        self.text = same if len(same) <= BYTES else ""  # of what is no scene nothing is told but its fault
        self.lines = self.text.split("\n")

    @cached_property
    def is_scene(self) -> bool:
        """Whether a text has anything of a scene: an editor asks about all YAML, of which most is none."""
        tree = self.tree
        return len(self.whole) > BYTES or (
            isinstance(tree, Map) and any(key.value in SECTIONS for key, _ in tree.entries)
        )

    @cached_property
    def faults(self) -> tuple[Fault, ...]:
        """All faults for which the reader refuses the text, if it is a scene at all."""
        if not self.is_scene:
            return ()
        try:
            read_text(self.whole)
        except SceneError as error:
            return error.faults
        return ()

    @cached_property
    def tree(self) -> Node:
        return outlined(self.text)

    @cached_property
    def scope(self) -> Scope:
        """What the reader knows of names, bodies and letters when it has read the text as far as that goes."""
        scope = Scope()
        with suppress(SceneError):
            Sections(scope, self.tree, {}).problem("", tuple(self.lines))
        return scope

    def ending_before(self, line: int, column: int) -> TextEnd:
        """Where the text before a place ends; line and column count from 0."""
        above = self.lines[:line]
        return place_after("\n".join((*above, self.line(line)[:column])))

    def line(self, number: int) -> str:
        return self.lines[number] if number < len(self.lines) else ""

    def node(self, path: Steps) -> Node | None:
        """What stands at the end of a way; None where it leads nowhere."""
        node: Node | None = self.tree
        for step in path:
            if isinstance(node, Map):
                node = node.get(str(step))
            elif isinstance(node, List) and isinstance(step, int) and step < len(node.items):
                node = node.items[step]
            else:
                return None
        return node

    def names_in(self, *sections: str) -> list[str]:
        """The keys of sections, read or not."""
        nodes = (self.node((section,)) for section in sections)
        return [key.value for node in nodes if isinstance(node, Map) for key, _ in node.entries]

    def at(self, line: int, column: int) -> ScalarAt | None:
        """The scalar at a place, or that ends there; line and column count from 0."""
        for path, is_key, text, _ in scalars(self.tree, ()):
            if covers(text.span, line, column):
                return ScalarAt(path, is_key, text, column - text.span.column + 1)
        return None


def scalars(node: Node, path: Steps) -> Iterator[ScalarAt]:
    """All keys and values of a tree that are written, in the order of the text."""
    if isinstance(node, Text):
        if node.value:
            yield ScalarAt(path, False, node, 0)
    elif isinstance(node, List):
        for number, item in enumerate(node.items):
            yield from scalars(item, (*path, number))
    else:
        for key, value in node.entries:
            yield ScalarAt((*path, key.value), True, key, 0)
            yield from scalars(value, (*path, key.value))


def covers(span: Span, line: int, column: int) -> bool:
    return span.line == line + 1 and span.column - 1 <= column <= span.column - 1 + span.length
