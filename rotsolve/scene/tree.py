"""The YAML text as a tree of texts, lists and maps with their places; nothing of YAML's own types is ever built.

The tree is made from parse events, so that limits hold before anything grows: aliases are refused where they stand.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

import yaml
from msgspec import Struct
from msgspec.structs import replace

from rotsolve.core.faults import Fault, SceneError, Span
from rotsolve.language.words import quoted

BYTES = 1_000_000
DEPTH, NODES = 40, 100_000
LOADER: Any = yaml.CSafeLoader if hasattr(yaml, "CSafeLoader") else yaml.SafeLoader


class Text(Struct, frozen=True):
    """A scalar as written. `exact` when column and characters of `value` correspond one to one in the source."""

    value: str
    span: Span
    plain: bool = True
    exact: bool = True

    @property
    def empty(self) -> bool:
        """Nothing at all: YAML's null."""
        return self.plain and not self.value

    def part(self, start: int, end: int) -> Span:
        """The place of value[start:end]."""
        if not self.exact:
            return self.span
        shift = 0 if self.plain else 1
        return Span(self.span.line, self.span.column + shift + start, max(1, end - start))

    def cut(self, start: int, end: int) -> Text:
        """value[start:end] without the blanks round it, in its place."""
        text = self.value[start:end]
        start += len(text) - len(text.lstrip())
        return Text(text.strip(), self.part(start, start + len(text.strip())), True, self.exact)

    @property
    def shown(self) -> str:
        """What messages say that stands here."""
        return quoted(self.value)


class List(Struct, frozen=True):
    """A sequence."""

    items: tuple[Node, ...]
    span: Span
    shown: ClassVar[str] = "a list"


class Map(Struct, frozen=True):
    """A mapping, its entries in the order of the file (a duplicate key is still there)."""

    entries: tuple[tuple[Text, Node], ...]
    span: Span
    shown: ClassVar[str] = "a map"

    def get(self, name: str) -> Node | None:
        return next((value for key, value in self.entries if key.value == name), None)

    def key(self, name: str) -> Text | None:
        return next((key for key, _ in self.entries if key.value == name), None)


Node = Text | List | Map


def compose(source: str, file: str) -> tuple[Node, tuple[str, ...]]:
    """The tree of the one document in `source`, and its lines."""
    lines = tuple(source.split("\n"))
    try:
        return TreeBuilder(source, lines).document(), lines
    except SceneError as error:
        raise SceneError(error.faults, lines, file) from None
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        from rotsolve.scene import traps

        marked = isinstance(error, yaml.MarkedYAMLError)
        fault = traps.yaml_fault(error, lines) if marked else traps.no_yaml(quoted(str(error)))
        raise SceneError([fault], lines, file) from None


class TreeBuilder:
    """Builds the tree from the parser's events, counting nodes and levels on the way."""

    def __init__(self, source: str, lines: tuple[str, ...]) -> None:
        self.lines = lines
        self.events: Iterator[Any] = yaml.parse(source, Loader=LOADER)
        self.count = 0

    def document(self) -> Node:
        result: Node | None = None
        for event in self.events:
            if isinstance(event, yaml.DocumentStartEvent):
                if result is not None:
                    help = "one file holds one scene: remove the line `---`"
                    stop("a second document starts here", self.span(event), help)
                result = self.node(next(self.events), 0)
        if result is None or (isinstance(result, Text) and result.empty):
            stop("the file is empty", None, "a scene needs at least `bodies` and `find`")
        assert result is not None
        return result

    def node(self, event: Any, depth: int) -> Node:
        self.check(event, depth)
        if isinstance(event, yaml.ScalarEvent):
            return self.text(event)
        if isinstance(event, yaml.SequenceStartEvent):
            items: list[Node] = []
            while not isinstance(following := next(self.events), yaml.SequenceEndEvent):
                items.append(self.node(following, depth + 1))
            return List(tuple(items), self.span(event, following))
        entries: list[tuple[Text, Node]] = []
        while not isinstance(following := next(self.events), yaml.MappingEndEvent):
            key = self.node(following, depth + 1)
            if not isinstance(key, Text):
                stop("a name must be a single word", key.span, "write `name: value`", "yaml")
            elif key.plain and key.value == "<<":
                from rotsolve.scene import traps

                raise SceneError([traps.merge(key.span)])
            else:
                entries.append((key, self.node(next(self.events), depth + 1)))
        return Map(tuple(entries), self.span(event, following))

    def check(self, event: Any, depth: int) -> None:
        """Refuse what no scene needs: aliases, anchors, tags, and too much of anything."""
        self.count += 1
        if isinstance(event, yaml.AliasEvent) or event.anchor or event.tag or depth > DEPTH or self.count > NODES:
            self.refuse(event, depth)

    def refuse(self, event: Any, depth: int) -> None:
        from rotsolve.scene import traps

        start = Span(event.start_mark.line + 1, event.start_mark.column + 1)
        if isinstance(event, yaml.AliasEvent):
            raise SceneError([traps.alias(event.anchor, self.span(event))])
        if event.anchor:
            raise SceneError([traps.anchor(event.anchor, replace(start, length=len(event.anchor) + 1))])
        if event.tag:
            raise SceneError([traps.tag(event.tag, start)])
        if depth > DEPTH:
            message, help = traps.TOO_DEEP
            stop(message, self.span(event), help, "limit")
        if self.count > NODES:
            stop(f"more than {NODES} values in one file", self.span(event), "split the scene", "limit")

    def text(self, event: Any) -> Text:
        """A scalar; block texts and texts over several lines have one place only."""
        plain = not event.style
        line = self.lines[event.start_mark.line] if event.start_mark.line < len(self.lines) else ""
        exact = line[event.start_mark.column + (not plain) :].startswith(event.value)
        return Text(event.value, self.span(event), plain, exact)

    def span(self, event: Any, last: Any = None) -> Span:
        start, end = event.start_mark, (last or event).end_mark
        line = self.lines[start.line] if start.line < len(self.lines) else ""
        length = end.column - start.column if end.line == start.line else len(line.rstrip()) - start.column
        return Span(start.line + 1, start.column + 1, max(1, length))


def stop(message: str, span: Span | None, help: str, kind: str = "yaml") -> None:
    """Raise one fault at once: what follows in the file can't be trusted."""
    raise SceneError([Fault(message, span, help, kind)])
