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
from rotsolve.elements.tables import ACTIONS, CONNECTIONS, EVENTS, SHAPES, SURFACES
from rotsolve.language.grammar import BODY, IS, PHASE, SECTIONS, WHICH
from rotsolve.language.keys import keys_of
from rotsolve.language.kinds import Kinds
from rotsolve.language.words import an, hint, nearest_name, quoted
from rotsolve.scene.scope import Scope
from rotsolve.scene.tree import List, Map, Node, Text

Entry = tuple[Text, Node]
NAMING = (
    "given",
    "surfaces",
    "bodies",
    "connections",
    "actions",
    "states",
    "phases",
    "events",
    "find",
    "answers",
    "marking",
    "vary",
)
ASSIGNED = r"(?s:(?P<name>[A-Za-z]\w*(?:\.\w+)*)(?:\s*=\s*|:|\s+)(?P<value>\S.*))"  # compiled where one is met
ONE = {
    "surfaces": "surface",
    "bodies": "body",
    "connections": "connection",
    "actions": "action",
    "events": "event",
    "states": "state",
}
ELEMENTS: dict[str, Kinds[Any]] = {
    "surfaces": SURFACES,
    "connections": CONNECTIONS,
    "actions": ACTIONS,
    "events": EVENTS,
}
AT_REST = "at rest"
LIKE = 0.75  # how like a section a word is that is taken for it
WHOLE, REST = r"[-+−]?\d+", r"\d+(\s*[^\W\d].*|\s*)"


def mended(root: Map, scope: Scope) -> Map:
    """The tree of a scene with what is mended in it; each fault is noted."""
    root = values_given(replace(root, entries=tuple((key, each_map(node, scope)) for key, node in root.entries)), scope)
    root = indented_below(root, SECTIONS, scope)
    root = by_their_names(root, scope)
    root = replace(root, entries=tuple((key, mended_section(key, node, scope)) for key, node in root.entries))
    return in_their_sections(root, scope)


def each_map(node: Node, scope: Scope) -> Node:
    """A node in which what stands alone in each map has its value, that of maps within others first."""
    if isinstance(node, List):
        return replace(node, items=tuple(each_map(item, scope) for item in node.items))
    if isinstance(node, Map):
        return values_given(
            replace(node, entries=tuple((key, each_map(item, scope)) for key, item in node.entries)), scope
        )
    return node


def is_empty(node: Node) -> bool:
    return isinstance(node, Text) and node.empty


def values_given(node: Map, scope: Scope) -> Map:
    """A map in which what stands alone between commas is given its value: `m = 2 kg`, `m:2 kg`, `mass m`, and `0,2 m` its point."""
    entries: list[Entry] = []
    for key, value in node.entries:
        before = entries[-1][1] if entries else None
        if not is_empty(value):
            entries.append((key, value))
        elif isinstance(before, Text) and re.fullmatch(WHOLE, before.value.strip()) and re.fullmatch(REST, key.value):
            from rotsolve.scene.traps import null_fault

            whole = f"{before.value.strip()}.{key.value}"
            fault, start = null_fault(key.value, key.span, before.value), before.span
            if start.line == key.span.line:
                fault = replace(fault, span=replace(start, length=key.span.column + key.span.length - start.column))
            scope.faults.append(fault)
            entries[-1] = (entries[-1][0], Text(whole, before.span, True, False))
        elif (said := re.fullmatch(ASSIGNED, key.value)) and key.value != AT_REST:
            from rotsolve.scene.traps import null_fault

            scope.faults.append(null_fault(key.value, key.span, before.value if isinstance(before, Text) else ""))
            value = key.cut(*said.span("value"))
            quotes = value.value[:1] in ("'", '"') and value.value[-1:] == value.value[:1] and len(value.value) > 1
            entries.append((key.cut(*said.span("name")), value.cut(1, len(value.value) - 1) if quotes else value))
        else:
            entries.append((key, value))
    return replace(node, entries=tuple(entries))


def indented_below(node: Map, own: Collection[str], scope: Scope, below: Collection[str] = ()) -> Map:
    """A map in which entries that can't be its own are those of the one before them: of a scene what is no section, of a section what is
    `below` its entries."""
    entries: list[Entry] = []
    begun = False  # whether what is not indented has been told of the last entry
    for key, value in node.entries:
        belongs = key.value in below if below else key.value not in own
        if not (
            entries and belongs and not is_empty(value) and (begun or belongs_below(entries[-1], key, value, below))
        ):
            begun = False
            entries.append((key, value))
            continue
        (name, held), begun = entries[-1], begun or told_indent(entries[-1][0], key, scope)
        taken = held.entries if isinstance(held, Map) else ()
        more = [(key, value)] if below else split_off(key, value, frozenset(words_below(name.value)))
        entries[-1] = (name, Map((*taken, *more), held.span if taken else key.span))
    return replace(node, entries=tuple(entries))


def told_indent(name: Text, key: Text, scope: Scope) -> bool:
    """The fault of a name that is not indented below the one to which it belongs."""
    begin = Related(name.span, f"`{name.value}` begins here")
    help = "put two blanks in front of it, and of what follows that belongs to it"
    message = f"{quoted(key.value)} is not indented below `{name.value}`, to which it belongs"
    scope.fault(key, message, help, "form", related=(begin,))
    return True


def belongs_below(last: Entry, key: Text, value: Node, below: Collection[str]) -> bool:
    """Whether an entry can be one of those of the name before it: of one that has none, or of a section with lines like it."""
    name, held = last
    if is_empty(held) or below:
        return is_empty(held) and (bool(below) or name.value in NAMING)
    if not isinstance(held, Map) or name.value not in NAMING or nearest_name(key.value, SECTIONS, LIKE) is not None:
        return False
    if held.span.line == name.span.line or not held.entries:  # in brackets
        return False
    if name.value == home_of(value):
        return True
    inner = frozenset(words_below(name.value))
    kind = Map if inner else type(held.entries[-1][1])
    return isinstance(value, kind) and (
        not isinstance(value, Map) or not inner or any(word.value in inner for word, _ in value.entries)
    )


def split_off(key: Text, value: Node, below: Collection[str]) -> list[Entry]:
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
        guess = nearest_name(key.value, SECTIONS, LIKE) if key.value not in SECTIONS else None
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
            told = {entry.value for entry, _ in first[1].entries}
            own = (entry for entry in value.entries if entry[0].value not in told)
            entries[key.value] = (first[0], replace(first[1], entries=(*first[1].entries, *own)))
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
    said = (
        re.fullmatch(ASSIGNED, node.value.strip())
        if key.value in NAMING and isinstance(node, Text) and node.exact
        else None
    )
    if isinstance(node, Text) and said is not None:
        from rotsolve.scene.traps import without_colon

        scope.faults.append(without_colon(node.value, node.span))
        return Map(((node.cut(*said.span("name")), node.cut(*said.span("value"))),), node.span)
    if not isinstance(node, Map) or not any(is_empty(value) for _, value in node.entries):
        return node
    below = frozenset(words_below(key.value))  # of all classes, which a scene without a fault does not load
    return indented_below(node, (), scope, below) if below else node


def words_below(section: str) -> Iterator[str]:
    """The keys of what a section holds."""
    tables: dict[str, Kinds[Any]] = {**ELEMENTS, "bodies": SHAPES}
    for cls in tables.get(section, ()):
        yield from (word for word, _ in keys_of(cls))
    yield from {"bodies": BODY, "phases": PHASE}.get(section, ())


def in_their_sections(root: Map, scope: Scope) -> Map:
    """A scene in which what plainly belongs into another section stands there."""
    joints = frozenset(key.value for name, node in root.entries if name.value == "connections" for key in keys_in(node))
    kept: dict[str, list[Entry]] = {}
    moved: dict[str, list[Entry]] = {}
    for section, node in root.entries:
        entries = node.entries if section.value in (*ONE, "find") and isinstance(node, Map) else ()
        for key, value in entries:
            home = home_of(value) if not at_home(section.value, value, joints) else ""
            if home and home != section.value:
                what = f"{an(ONE[home])}" if home in ONE else "a question" if home == "find" else "an answer"
                message = f"`{key.value}` is {what}, and stands below `{section.value}`"
                scope.fault(key, message, f"put its line below `{home}:`", "key")
                moved.setdefault(home, []).append((key, value))
                kept.setdefault(section.value, list(entries)).remove((key, value))
    if not moved:
        return root
    found: list[Entry] = []
    for key, node in root.entries:
        own = kept.get(key.value, list(node.entries) if isinstance(node, Map) else [])
        whole = [
            *own,
            *(entry for entry in moved.pop(key.value, ()) if entry[0].value not in {word.value for word, _ in own}),
        ]
        found.append(
            (key, Map(tuple(whole), node.span) if isinstance(node, Map) or (whole and is_empty(node)) else node)
        )
    scope.lost.update(key.value for entries in moved.values() for key, _ in entries)
    return replace(root, entries=tuple(found))


def keys_in(node: Node) -> Iterator[Text]:
    """The keys of a map; none of anything else."""
    yield from (key for key, _ in (node.entries if isinstance(node, Map) else ()))


def at_home(section: str, value: Node, joints: Collection[str]) -> bool:
    """Whether a section may have such an entry, right or not; states name connections in their lines, which are called as they like."""
    if isinstance(value, Text):
        resting = value.value.strip() == AT_REST and section in ELEMENTS
        return section == "find" or not (resting or begins_with_path(value.value))
    if not isinstance(value, Map) or not value.entries:
        return True
    words = [key.value for key in keys_in(value)]
    if section == "find":
        return WHICH in words or IS in words
    if section == "states":
        return any(state_line(word) or word in joints for word in words)
    if section in ELEMENTS:
        return not set(ELEMENTS[section].words).isdisjoint(words)
    return any(word in BODY for word in words) or not frozenset(words_below(section)).isdisjoint(words)


def state_line(word: str) -> bool:
    """Whether a key is a line of a state: a path, or a word that only states have."""
    return begins_with_path(word) or word in (AT_REST, "balance", "steady", "time") or " of " in word


def begins_with_path(text: str) -> bool:
    """Whether the first word of a text is a path, `block.velocity`."""
    word = text.split()[0] if text.strip() else ""
    return "." in word and word[0].isalpha() and all(part.isidentifier() for part in word.split("."))


def home_of(value: Node) -> str:
    """The section to which an entry belongs; '' where it is not plain."""
    if isinstance(value, Text):
        return "states" if value.value.strip() == AT_REST else "find"
    words = [key.value for key in keys_in(value)]
    if {"formula", "value"} & set(words):
        return "answers"
    named = [section for section, table in ELEMENTS.items() if not set(table.words).isdisjoint(words)]
    if len(named) == 1:
        return named[0]
    if {"shape", "mass", "inertia"} & set(words):
        return "bodies"
    return "states" if any(state_line(word) for word in words) else ""
