"""Elements: entries of `surfaces`, `connections`, `actions` and `events`, each by the word that it carries."""

from __future__ import annotations

from typing import Any

from rotsolve.elements.actions import ACTIONS
from rotsolve.elements.connections import CONNECTIONS
from rotsolve.elements.events import EVENTS
from rotsolve.elements.surfaces import SURFACES
from rotsolve.language.keys import Element, keys_of
from rotsolve.language.problem import PointRef
from rotsolve.language.words import hint, nearest, quoted
from rotsolve.scene.reader.declared import missing, read_keys
from rotsolve.scene.tree.nodes import Map, Node, Text
from rotsolve.scene.values.scope import Scope

TABLES: dict[str, tuple[str, tuple[type[Any], ...]]] = {  # section -> kind, table
    "surfaces": ("surface", SURFACES),
    "connections": ("connection", CONNECTIONS),
    "actions": ("action", ACTIONS),
    "events": ("event", EVENTS),
}
PLURAL = {"surface": "surfaces", "connection": "connections", "action": "actions", "event": "events"}


def read_element(scope: Scope, section: str, name: str, key: Text, node: Node) -> object | None:
    """One element of a section."""
    kind, table = TABLES[section]
    if isinstance(node, Text):
        return plain_word(scope, kind, table, name, node)
    if not isinstance(node, Map):
        scope.fault(node, f"{kind} `{name}` wants `{{{table[-1].word}: …}}`, but this is a list", "", "form")
        return None
    cls = class_of(scope, kind, table, name, key, node)
    if cls is None:
        return None
    scope.elements[name] = cls
    entries = scope.entries(node, f"{kind} `{name}`", [word for word, _ in keys_of(cls)])
    if cls.later:
        scope.later(node.key(cls.word), cls.word)
    missing(scope, cls, key, name, {**entries, **{entry.value: (entry, value) for entry, value in node.entries}})
    found = read_keys(scope, cls, name, entries)
    element = cls(name, **found) if complete(cls, found) else None
    if element is not None:
        scope.touched[name] = tuple(point.owner for point in points_in(element) if point.owner)
    return element


def complete(cls: type[Element], found: dict[str, Any]) -> bool:
    return all(word in found or f"{word}_" in found for word, declared in keys_of(cls) if declared.required)


def plain_word(scope: Scope, kind: str, table: tuple[type[Any], ...], name: str, node: Text) -> object | None:
    """An element that is one word, such as `level`."""
    word = " ".join(node.value.split())
    alone = {cls.word: cls for cls in table if not any(declared.required for _, declared in keys_of(cls))}
    cls = alone.get(word)
    if cls is not None:
        if cls.later:
            scope.later(node, word)
        scope.elements[name] = cls
        return cls(name)  # type: ignore[no-any-return]
    known = next((item for item in table if item.word == word), None)
    if known is not None:
        example = next((declared.example for _, declared in keys_of(known) if declared.example), "…")
        scope.fault(node, f"`{word}` wants a value", f"write `{name}: {{{word}: {example}}}`", "form")
    else:
        scope.unknown(node, word, kind, [item.word for item in table], PLURAL[kind])
    return None


def class_of(
    scope: Scope, kind: str, table: tuple[type[Any], ...], name: str, key: Text, node: Map
) -> type[Any] | None:
    """The class by the one word of the table that the map holds."""
    words = [entry.value for entry, _ in node.entries]
    found = [cls for cls in table if cls.word in words]
    if len(found) == 1:
        return found[0]
    known = [cls.word for cls in table]
    if len(found) > 1:  # an axle with a `force`: the first of them in the file decides what is meant
        both = " and ".join(f"`{cls.word}`" for cls in found[:2])
        scope.fault(key, f"`{name}` is both {both}", "give each a name of its own", "form")
        return None
    for entry, _ in node.entries:
        if nearest(entry.value, known):
            scope.fault(
                entry, f"unknown {kind} {quoted(entry.value)}", hint(entry.value, known, PLURAL[kind]), "unknown"
            )
            return None
    scope.fault(
        key,
        f"`{name}` doesn't say what kind of {kind} it is",
        hint("", known, PLURAL[kind]),
        "missing",
    )
    return None


def points_in(element: Element) -> list[PointRef]:
    """All points that an element names."""
    found: list[PointRef] = []
    for name in element.__struct_fields__:
        item = getattr(element, name)
        for point in item if isinstance(item, tuple) else (item,):
            if isinstance(point, PointRef):
                found.append(point)
    return found
