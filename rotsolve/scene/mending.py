"""Mending: what is plainly meant by a tree that is none of a scene, read as that beside its fault, so that nothing follows from it.

Lines that are not indented belong to the name above them that has none; `m = 2 kg` in brackets is `m: 2 kg`, and a comma that splits a
number a point; a section by a name that is nearly right is that section.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from typing import Any

from msgspec.structs import replace

from rotsolve.core.faults import Related
from rotsolve.elements.actions import ACTIONS
from rotsolve.elements.connections import CONNECTIONS
from rotsolve.elements.events import EVENTS
from rotsolve.elements.shapes import SHAPES
from rotsolve.elements.surfaces import SURFACES
from rotsolve.language.grammar import BODY, PHASE, SECTIONS
from rotsolve.language.keys import keys_of
from rotsolve.language.words import hint, nearest_name, quoted
from rotsolve.scene.scope import Scope
from rotsolve.scene.traps import null_fault
from rotsolve.scene.tree import List, Map, Node, Text

Entry = tuple[Text, Node]
NAMING = ("given", "surfaces", "bodies", "connections", "actions", "states", "phases", "events", "find")
ASSIGNED = re.compile(r"(?P<name>[A-Za-z]\w*(?:\.\w+)*)(?:\s*=\s*|:|\s+)(?P<value>\S.*)", re.DOTALL)
WHOLE, REST = re.compile(r"[-+−]?\d+"), re.compile(r"\d+(\s*[^\W\d].*|\s*)")


def mended(root: Map, scope: Scope) -> Map:
    """The tree of a scene with what is mended in it; each fault is noted."""
    root = with_values(replace(root, entries=tuple((key, each_map(node, scope)) for key, node in root.entries)), scope)
    root = indented_below(root, SECTIONS, scope)
    root = by_their_names(root, scope)
    return replace(root, entries=tuple((key, mended_section(key, node, scope)) for key, node in root.entries))


def each_map(node: Node, scope: Scope) -> Node:
    """A node in which what stands alone in each map has its value, that of maps within others first."""
    if isinstance(node, List):
        return replace(node, items=tuple(each_map(item, scope) for item in node.items))
    if isinstance(node, Map):
        return with_values(
            replace(node, entries=tuple((key, each_map(item, scope)) for key, item in node.entries)), scope
        )
    return node


def is_empty(node: Node) -> bool:
    return isinstance(node, Text) and node.empty


def with_values(node: Map, scope: Scope) -> Map:
    """A map in which what stands alone between commas is given its value: `m = 2 kg`, `m:2 kg`, `mass m`, and `0,2 m` its point."""
    entries: list[Entry] = []
    for key, value in node.entries:
        before = entries[-1][1] if entries else None
        if not is_empty(value):
            entries.append((key, value))
        elif isinstance(before, Text) and WHOLE.fullmatch(before.value.strip()) and REST.fullmatch(key.value):
            whole = f"{before.value.strip()}.{key.value}"
            scope.faults.append(null_fault(key.value, key.span, before.value))
            entries[-1] = (entries[-1][0], Text(whole, before.span, True, False))
        elif (said := ASSIGNED.fullmatch(key.value)) and key.value != "at rest":
            scope.faults.append(null_fault(key.value, key.span, before.value if isinstance(before, Text) else ""))
            entries.append((key.cut(*said.span("name")), key.cut(*said.span("value"))))
        else:
            entries.append((key, value))
    return replace(node, entries=tuple(entries))


def indented_below(node: Map, own: Collection[str], scope: Scope, below: Collection[str] = ()) -> Map:
    """A map in which entries that can't be its own are those of the empty one before them: of a scene what is no section, of a section
    what is `below` its entries."""
    entries: list[Entry] = []
    taken: list[Entry] = []
    for key, value in node.entries:
        last = entries[-1] if entries else None
        belongs = key.value in below if below else key.value not in own
        names = last is not None and (bool(below) or last[0].value in NAMING)
        if last is None or not names or not belongs or is_empty(value) or not (taken or is_empty(last[1])):
            taken = []
            entries.append((key, value))
            continue
        if not taken:
            begin = Related(last[0].span, f"`{last[0].value}` begins here")
            help = "put two blanks in front of it, and of what follows that belongs to it"
            message = f"{quoted(key.value)} is not indented below `{last[0].value}`, to which it belongs"
            scope.fault(key, message, help, "form", related=(begin,))
        taken += [(key, value)] if below else beside(key, value, frozenset(words_below(last[0].value)))
        entries[-1] = (last[0], Map(tuple(taken), taken[0][0].span))
    return replace(node, entries=tuple(entries))


def beside(key: Text, value: Node, below: Collection[str]) -> list[Entry]:
    """An entry, and behind it those within it that are none of its keys, but as it is: they were indented, and it was not."""
    inner = value.entries if isinstance(value, Map) and below else ()
    others = [(word, item) for word, item in inner if word.value not in below and isinstance(item, Map)]
    if not others or not isinstance(value, Map):
        return [(key, value)]
    return [(key, replace(value, entries=tuple(entry for entry in inner if entry not in others))), *others]


def by_their_names(root: Map, scope: Scope) -> Map:
    """A scene whose sections have their right names, where these are nearly said and not there beside, and each once."""
    names = {key.value for key, _ in root.entries}
    entries: dict[str, Entry] = {}
    more: list[Entry] = []
    for key, value in root.entries:
        guess = nearest_name(key.value, SECTIONS) if key.value not in SECTIONS else None
        if guess is not None and guess not in names and not is_empty(value):
            scope.fault(key, f"unknown key {quoted(key.value)} in a scene", hint(key.value, SECTIONS, "keys"), "key")
            names.add(guess)
            key = replace(key, value=guess)
        first = entries.get(key.value)
        if first is None:
            entries[key.value] = (key, value)
        elif isinstance(value, Map) and isinstance(first[1], Map):
            here = Related(first[0].span, "the first is here")
            help = "put all of them below the first: YAML would keep only one"
            scope.fault(key, f"{quoted(key.value)} stands twice in a scene", help, "duplicate", related=(here,))
            entries[key.value] = (first[0], replace(first[1], entries=(*first[1].entries, *value.entries)))
        else:
            more.append((key, value))
    return replace(root, entries=(*entries.values(), *more))


def mended_section(key: Text, node: Node, scope: Scope) -> Node:
    """A section: a list of `- name: value` as a map, and what is not indented below a name as its own."""
    if key.value in NAMING and isinstance(node, List):
        parts = [item.entries for item in node.items if isinstance(item, Map) and len(item.entries) == 1]
        if len(parts) == len(node.items) and parts:
            help = "leave out the `-` and the brackets of a list: write `name: value` lines"
            scope.fault(node, f"`{key.value}` wants `name: value` lines, but this is a list", help, "form")
            return Map(tuple(entry for entries in parts for entry in entries), node.span)
    below = frozenset(words_below(key.value))
    return indented_below(node, (), scope, below) if below and isinstance(node, Map) else node


def words_below(section: str) -> Iterator[str]:
    """The keys of what a section holds."""
    tables: dict[str, list[type[Any]]] = {
        "surfaces": SURFACES,
        "connections": CONNECTIONS,
        "actions": ACTIONS,
        "events": EVENTS,
        "bodies": SHAPES,
    }
    for cls in tables.get(section, ()):
        yield from (word for word, _ in keys_of(cls))
    yield from {"bodies": BODY, "phases": PHASE}.get(section, ())
