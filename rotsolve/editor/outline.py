"""Outline: the tree of a text that is still being written, and where in it the text ends.

YAML's parser gives up at the first bracket that is not closed yet. This reads on: it takes what is indented less as the end of what is
open, a word without a colon for a key without a value. Of a text that is YAML it makes the tree that `scene.tree` makes of it.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from msgspec import Struct, field

from rotsolve.core.faults import Span
from rotsolve.scene.tree import List, Map, Node, Text

KEY = re.compile(r"""(?P<key>"(?:[^"\\]|\\.)*"|'(?:[^']|'')*'|[^\s"'\[\]{},&*!|>%@`#-].*?|-(?=\S).*?)\s*:(?=\s|$)""")
QUOTED = re.compile(r""""(?:[^"\\]|\\.)*"?|'(?:[^']|'')*'?""")
PLAIN = re.compile(r".*?(?=\s+#|\s*$)")  # in a block, to the end of the line or a comment
PLAIN_WITHIN = re.compile(r".*?(?=\s*[,\[\]{}]|\s*:(?=[\s,\[\]{}]|$)|\s+#|\s*$)")  # within brackets
BLOCK_TEXT = re.compile(r"[|>][-+0-9]*\s*(?:#.*)?$")
ESCAPES = {"n": "\n", "t": "\t", "0": "\0"}


class TextEnd(NamedTuple):
    """Where a text ends: the keys that lead there (numbers in lists), whether a key or a value is written, and from which column on.

    `role` is "key", "value", "either" on a line of its own below a key, or "" where nothing of the language stands: in a comment, a text
    of several lines, behind a closing bracket.
    """

    path: tuple[str | int, ...]
    role: str
    typed: str
    within: bool  # between brackets


class OpenNode(Struct):
    """A map or list that is still open: in a block with its indentation, within brackets with the bracket that opens it."""

    opened: str  # "{", "[", or "" of a map and "-" of a list in a block
    indent: int
    span: Span
    entries: list[tuple[Text, Node]] = field(default_factory=list)
    items: list[Node] = field(default_factory=list)
    key: Text | None = None  # the one whose value comes next

    @property
    def listed(self) -> bool:
        return self.opened in ("[", "-")

    @property
    def within(self) -> bool:
        return self.opened in ("{", "[")

    def put(self, node: Node) -> None:
        """A value, or in a map without a key before it a key without a value."""
        if self.listed:
            self.items.append(node)
        elif self.key is not None:
            self.entries.append((self.key, node))
            self.key = None
        elif isinstance(node, Text):
            self.entries.append((node, empty_value(node.span)))

    def node(self) -> Node:
        if self.key is not None:
            self.put(empty_value(self.key.span))
        return List(tuple(self.items), self.span) if self.listed else Map(tuple(self.entries), self.span)

    @property
    def step(self) -> str | int | None:
        """The key or number of what is being written in it; None where that is a key itself."""
        return len(self.items) if self.listed else None if self.key is None else self.key.value


def empty_value(span: Span) -> Text:
    """The value of a key without one."""
    return Text("", span)


def outlined(text: str) -> Node:
    """The tree of a text, as far as it goes."""
    return Outliner(text).whole()


def place_after(text: str) -> TextEnd:
    """Where a text ends."""
    return Outliner(text).place()


class Outliner:
    """Reads a text line by line; what is still open when it ends is where it ends."""

    def __init__(self, text: str) -> None:
        self.lines = text.split("\n")
        self.number = 0
        self.root: Node = empty_value(Span(1, 1))
        self.frames: list[OpenNode] = []
        self.block_text: int | None = None  # the indentation of the key whose text of several lines is read
        self.mark("key", 0)
        for self.number, line in enumerate(self.lines):  # noqa: B020
            self.read_line(line)

    def whole(self) -> Node:
        while self.frames:
            self.close()
        return self.root

    def place(self) -> TextEnd:
        number, column = self.start
        typed = self.lines[-1][column:] if number == len(self.lines) - 1 else ""
        within = bool(self.frames) and self.frames[-1].within
        return TextEnd(self.path, self.role, typed, within)

    def mark(self, role: str, column: int) -> None:
        """What is written from here on."""
        steps = [frame.step for frame in (self.frames[:-1] if role == "key" else self.frames)]
        self.path = tuple("" if step is None else step for step in steps)
        self.role, self.start = role, (self.number, column)

    def span(self, column: int, length: int) -> Span:
        return Span(self.number + 1, column + 1, max(1, length))

    def text(self, written: str, column: int) -> Text:
        """A scalar as it is written."""
        quote = written[:1] if written[:1] in ("'", '"') else ""
        if not quote:
            return Text(written, self.span(column, len(written)))
        value = written[1:].removesuffix(quote) if len(written) > 1 else ""
        doubled, escaped = "''", re.compile(r"\\(.)")
        single = quote == "'"
        value = (
            value.replace(doubled, quote)
            if single
            else escaped.sub(lambda match: ESCAPES.get(match[1], match[1]), value)
        )
        return Text(value, self.span(column, len(written)), False, value == written[1 : 1 + len(value)])

    def open(self, opened: str, indent: int, column: int) -> None:
        if self.frames and self.frames[-1].opened == "" and self.frames[-1].indent == indent and not opened:
            return  # the map is open already
        self.frames.append(OpenNode(opened, indent, self.span(column, 1)))

    def close(self) -> None:
        node = self.frames.pop().node()
        if self.frames:
            self.frames[-1].put(node)
        else:
            self.root = node

    def read_line(self, line: str) -> None:
        content, indent = line.strip(), len(line) - len(line.lstrip(" "))
        if self.block_text is not None:
            if not content or indent > self.block_text:
                self.role = ""
                return
            self.block_text = None
        if not content:
            self.blank(indent)
        elif content[0] == "#" or content in ("---", "..."):
            self.role = ""
        elif self.frames and self.frames[-1].within and not self.left(line, indent):
            self.brackets(line, indent)
        else:
            self.block(line, indent)

    def left(self, line: str, indent: int) -> bool:
        """Whether a line, by a key indented no more than theirs, shows that brackets above it are never closed. They are then."""
        around = max((frame.indent for frame in self.frames if not frame.within), default=-1)
        if indent > around or not KEY.match(line, indent):
            return False
        while self.frames and self.frames[-1].within:
            self.close()
        return True

    def blank(self, indent: int) -> None:
        """A line on which nothing stands yet: what may come there by its indentation."""
        if self.number < len(self.lines) - 1:
            return
        if self.frames and self.frames[-1].within:
            self.slot(indent)
            return
        self.dedent(indent)
        top = self.frames[-1] if self.frames else None
        if top is not None and top.key is not None and indent > top.indent:
            self.mark("either", indent)
        else:
            self.mark("key" if top is None or not top.listed else "", indent)

    def slot(self, column: int) -> None:
        """Within brackets, where the next key or value comes."""
        frame = self.frames[-1]
        self.mark("value" if frame.listed or frame.key is not None else "key", column)

    def dedent(self, indent: int) -> None:
        while len(self.frames) > 1 and self.frames[-1].indent > indent:
            self.close()

    def block(self, line: str, indent: int) -> None:
        """A line in no brackets."""
        item = re.match(r"-(?=\s|$)", line[indent:])
        self.dedent(indent)
        while self.frames and self.frames[-1].opened == "-" and self.frames[-1].indent >= indent and not item:
            self.close()
        if not item:
            self.entry(line, indent)
            return
        if not (self.frames and self.frames[-1].opened == "-" and self.frames[-1].indent == indent):
            self.frames.append(OpenNode("-", indent, self.span(indent, 1)))
        inner = len(line) - len(line[indent + 1 :].lstrip())
        self.mark("value", inner)
        if line[inner:]:
            self.entry(line, inner)

    def entry(self, line: str, column: int) -> None:
        """A key with what follows it on its line, or a value on a line of its own."""
        top = self.frames[-1] if self.frames else None
        match = KEY.match(line, column)
        if match:
            self.open("", column, column)
            frame = self.frames[-1]
            if frame.key is not None:
                frame.put(empty_value(frame.key.span))
            self.mark("key", column)
            frame.key = self.text(match["key"], column)
            self.value(line, match.end())
        elif top is not None and (top.listed or (top.key is not None and column > top.indent)):
            self.value(line, column, "value" if top.listed else "either")
        elif top is not None and column > top.indent and top.entries:  # a plain text goes on
            self.start = (self.number, column)
            self.role = "value"
        elif line[column] in "{[\"'":
            self.value(line, column)
        else:  # a key without a colon yet
            self.open("", column, column)
            frame = self.frames[-1]
            if frame.key is not None:
                frame.put(empty_value(frame.key.span))
            self.mark("key", column)
            frame.put(self.text(PLAIN.match(line, column)[0], column))  # type: ignore[index]  # it fits everything

    def value(self, line: str, column: int, role: str = "value") -> None:
        """What stands from a column to the end of the line."""
        column += len(line[column:]) - len(line[column:].lstrip())
        rest = line[column:]
        self.mark(role, column)
        if not rest:
            return
        if rest[0] == "#":
            self.role = ""
        elif rest[0] in "{[":
            self.frames.append(OpenNode(rest[0], len(line), self.span(column, len(rest))))
            self.slot(column + 1)
            self.brackets(line, column + 1)
        elif self.frames and BLOCK_TEXT.match(rest):
            self.block_text, self.role = self.frames[-1].indent, ""
            self.frames[-1].put(Text("", self.span(column, 1), False, False))
        else:
            written = (QUOTED if rest[0] in "\"'" else PLAIN).match(line, column)
            scalar = written[0] if written else rest
            self.put(self.text(scalar, column))
            if line[column + len(scalar) :].lstrip().startswith("#"):
                self.role = ""

    def put(self, text: Text) -> None:
        if self.frames:
            self.frames[-1].put(text)
        else:
            self.root = text

    def brackets(self, line: str, column: int) -> None:
        """The line from a column on, between brackets."""
        while column < len(line) and self.frames and self.frames[-1].within:
            frame, letter = self.frames[-1], line[column]
            if letter == "#" and line[column - 1 : column].isspace():
                self.role = ""
                return
            if letter in "{[":
                self.frames.append(OpenNode(letter, len(line), self.span(column, 1)))
                self.slot(column + 1)
            elif letter in "}]":
                self.close()
                self.role = ""
            elif letter == ",":
                if frame.key is not None:
                    frame.put(empty_value(frame.key.span))
                self.slot(column + 1)
            elif not letter.isspace():
                column = self.scalar(frame, line, column)
                continue
            elif self.start == (self.number, column) and self.role:
                self.start = (self.number, column + 1)  # what is written begins behind the blanks
            column += 1

    def scalar(self, frame: OpenNode, line: str, column: int) -> int:
        """A key or value between brackets; where it ends."""
        found = (QUOTED if line[column] in "\"'" else PLAIN_WITHIN).match(line, column)
        written = found[0] if found and found[0] else line[column]
        end = column + len(written)
        self.slot(column)
        colon = re.compile(r"\s*:").match(line, end)
        if not frame.listed and frame.key is None and colon:
            frame.key = self.text(written, column)
            self.slot(colon.end())
            return colon.end()
        frame.put(self.text(written, column))
        return end
