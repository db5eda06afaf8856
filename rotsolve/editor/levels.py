"""Levels: which keys may stand at a place of a scene, and what the value of one takes, by the tables that the reader reads."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rotsolve.editor.scene_text import SceneText, Steps
from rotsolve.elements.tables import SHAPES
from rotsolve.language.grammar import BODY, DEDUCT, IS, MARKING, PART, PHASE, SECTIONS, STATE, WHICH
from rotsolve.language.keys import Key, keys_of
from rotsolve.language.marks import ALL
from rotsolve.language.shape import Shape
from rotsolve.scene.answers import KEYS
from rotsolve.scene.bodies import keys_allowed
from rotsolve.scene.elements import TABLES
from rotsolve.scene.tree import Map, Node, Text
from rotsolve.scene.vary import WHERE

OF_ENTRIES: dict[str, Mapping[str, Key]] = {  # the keys that all entries of a section have
    "states": STATE,
    "phases": PHASE,
    "marking": MARKING,
    "answers": {word: Key("text", f"the {word} that is published") for word in KEYS},
    "find": {
        WHICH: Key("map", "options by label, of which one is asked"),
        IS: Key("text", "which of them: `largest`, `smallest`, `above X`, `below X`"),
    },
}
WITHIN_VALUES: dict[str, Mapping[str, Key]] = {  # the keys that a value of a kind has where it is a map
    "deductions": DEDUCT,
    "friction": {
        "static": Key("quantity", "coefficient while it sticks", dimension="number"),
        "kinetic": Key("quantity", "coefficient while it slips", dimension="number"),
    },
    "inertia": {
        "value": Key("quantity", "moment of inertia", dimension="moment of inertia"),
        "about": Key("name", "the point about which it is"),
        "principal": Key("quantities", "the three principal moments", dimension="moment of inertia", space=True),
        "tensor": Key("place", "the rows of the tensor", space=True),
    },
    "turns": {
        "about": Key("axis in space", "the axis about which it is turned"),
        "by": Key("quantity", "the angle", dimension="angle"),
    },
    "gravity": {
        "size": Key("quantity", "its size", dimension="acceleration"),
        "in": Key("name", "the body with which it turns", refers=("body",)),
    },
}


def shape_written(node: Node | None) -> type[Shape] | None:
    """The shape that a body or part names."""
    written = node.get("shape") if isinstance(node, Map) else None
    return SHAPES.of(written.value.strip()) if isinstance(written, Text) else None


def class_at(section: str, node: Node | None) -> Any:
    """The class of an element by the word of its table that it holds; None where it holds none yet."""
    if section not in TABLES:
        return None
    entries = [key for key, _ in node.entries] if isinstance(node, Map) else [node] if isinstance(node, Text) else []
    return next((cls for entry in entries if (cls := TABLES[section][1].of(entry.value.strip()))), None)


def keys_at(scene: SceneText, path: Steps) -> Mapping[str, Key]:
    """The keys of the language that may stand in the map at a place; none where keys are names."""
    if not path:
        return SECTIONS
    section, node = str(path[0]), scene.node(path)
    if len(path) == 2 and section in TABLES:
        cls = class_at(section, node)
        return dict(keys_of(cls)) if cls is not None else element_words(section)
    if section == "bodies" and len(path) > 1 and (len(path) == 2 or path[-2] in ("parts", "holes")):
        return keys_of_body(node, PART if len(path) > 2 else {})
    if len(path) == 2 and section in OF_ENTRIES:
        return OF_ENTRIES[section]
    key = key_at(scene, path)
    if key is None:
        return {}
    if key.kind == "radii":
        return {word: Key("quantity", f"the {word} radius", dimension="length") for word in key.choices}
    return WITHIN_VALUES.get(key.kind, {})


def element_words(section: str) -> dict[str, Key]:
    """The words of a section of which an element has one, as keys: what follows each is what it acts on."""
    return {cls.word: dict(keys_of(cls))[cls.word] for cls in TABLES[section][1] if cls.word in dict(keys_of(cls))}


def keys_of_body(node: Node | None, more: Mapping[str, Key]) -> dict[str, Key]:
    """The keys of a body or part, those of its shape among them."""
    shape = shape_written(node)
    known = {**BODY, **(dict(keys_of(shape)) if shape is not None else {}), **more}
    return {word: known[word] for word in dict.fromkeys(("shape", *keys_allowed(shape, tuple(more))))}


def key_at(scene: SceneText, path: Steps) -> Key | None:
    """What the value at the end of a way is declared to be; that of a list for its items."""
    while path and isinstance(path[-1], int):
        path = path[:-1]
    if not path:
        return None
    word, section = str(path[-1]), str(path[0])
    found = keys_at(scene, path[:-1]).get(word)
    if found is None and len(path) == 3 and section in TABLES:  # of an element that does not say yet what it is
        found = next((keys[word] for cls in TABLES[section][1] if word in (keys := dict(keys_of(cls)))), None)
    return found


def names_as_keys(scene: SceneText, path: Steps) -> list[str]:
    """The names that may be keys at a place: answers are of what is asked, variations of what is given."""
    asked = scene.names_in("find")
    if path == ("answers",):
        return asked
    if path == ("marking",):
        return [ALL, *asked]
    if path == ("vary",):
        return [WHERE, *scene.names_in("given")]
    key = key_at(scene, path) if path else None
    return scene.scope.names(*key.refers) if key is not None and key.kind == "map of directions" else []
