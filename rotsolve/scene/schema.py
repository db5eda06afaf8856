"""json_schema: the language as a JSON Schema for editors, made from the same tables that the reader reads."""

from __future__ import annotations

from typing import Any

from rotsolve.elements.shapes import SHAPES
from rotsolve.language.keys import Key, keys_of
from rotsolve.language.sections import BODY, DEDUCT, MARKING, PART, PHASE, SECTIONS
from rotsolve.scene.phrase.choices import IS, WORD
from rotsolve.scene.reader.elements import TABLES
from rotsolve.scene.values.scope import NAME

SCALAR: dict[str, Any] = {"type": ["string", "number", "boolean"]}
ANYTHING: dict[str, Any] = {}
PLACE: dict[str, Any] = {"type": "array", "items": SCALAR, "minItems": 2, "maxItems": 3}
LIMITS: dict[str, Any] = {"type": "array", "items": SCALAR, "minItems": 2, "maxItems": 2}
POINT: dict[str, Any] = {"anyOf": [{"type": "string"}, PLACE]}
TENSOR: dict[str, Any] = {"type": "array", "items": {"anyOf": [SCALAR, {"type": "array", "items": SCALAR}]}}
ABOUT: dict[str, Any] = {
    "type": "object",
    "properties": {"value": SCALAR, "about": {"type": "string"}},
    "additionalProperties": False,
    "required": ["value"],
}
CHOICE: dict[str, Any] = {
    "type": "object",
    "properties": {
        WORD: {
            "type": "object",
            "additionalProperties": SCALAR,
            "minProperties": 2,
            "description": "options by label: quantities, or comparisons such as `3 < n < 6`",
        },
        IS: {"type": "string", "description": "which quantity: `largest`, `smallest`, `above X`, `below X`"},
    },
    "required": [WORD],
    "additionalProperties": False,
}
FRICTION: dict[str, Any] = {
    "anyOf": [
        SCALAR,
        {"type": "object", "properties": {"static": SCALAR, "kinetic": SCALAR}, "additionalProperties": False},
    ]
}
DEDUCTIONS: dict[str, Any] = {
    "anyOf": [SCALAR, {"type": "object", "properties": dict.fromkeys(DEDUCT, SCALAR), "additionalProperties": False}]
}


def json_schema() -> dict[str, Any]:
    """The schema of a scene file."""
    properties = {name: described(section(name, key), key) for name, key in SECTIONS.items()}
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "rotsolve scene",
        "type": "object",
        "properties": properties,
        "required": [name for name, key in SECTIONS.items() if key.required],
        "additionalProperties": False,
        "$defs": {"body": body({}), "part": body(PART)},
    }


def described(schema: dict[str, Any], key: Key) -> dict[str, Any]:
    """The schema of a key with its help for editors."""
    text = key.help + (" (not solved yet)" if key.later else "")
    return {**schema, "description": text}


def named(schema: dict[str, Any]) -> dict[str, Any]:
    """A map from names to things."""
    return {"type": "object", "propertyNames": {"pattern": f"^{NAME.pattern}$"}, "additionalProperties": schema}


def section(name: str, key: Key) -> dict[str, Any]:
    """The schema of a top-level key."""
    if name in TABLES:
        return named({"anyOf": [element(cls) for cls in TABLES[name][1]] + words(name)})
    special: dict[str, dict[str, Any]] = {
        "given": named(SCALAR),
        "bodies": named({"anyOf": [{"enum": [shape.word for shape in SHAPES]}, {"$ref": "#/$defs/body"}]}),
        "states": named({"anyOf": [{"const": "at rest"}, {"type": "object"}]}),
        "phases": named(table(PHASE)),
        "find": {**named({"anyOf": [{"type": ["string", "number"]}, CHOICE]}), "minProperties": 1},
        "answers": {"type": "object"},
        "marking": named({"anyOf": [SCALAR, table(MARKING)]}),
        "vary": named({"anyOf": [{"type": "string"}, {"type": "array", "items": SCALAR, "minItems": 1}]}),
        "assume": {"anyOf": [SCALAR, {"type": "array", "items": SCALAR}]},
        "unknown": {"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}]},
    }
    return special.get(name) or value(key)


def words(name: str) -> list[dict[str, Any]]:
    """Elements that are one word alone: `floor: level`."""
    alone = [cls.word for cls in TABLES[name][1] if not any(key.required for _, key in keys_of(cls))]
    return [{"enum": alone}] if alone else []


def element(cls: type) -> dict[str, Any]:
    """The schema of one element."""
    return table(dict(keys_of(cls)))


def table(keys: dict[str, Key]) -> dict[str, Any]:
    return {
        "type": "object",
        "properties": {word: described(value(key), key) for word, key in keys.items()},
        "required": [word for word, key in keys.items() if key.required],
        "additionalProperties": False,
    }


def body(more: dict[str, Key]) -> dict[str, Any]:
    """A body: the keys of all bodies and of all shapes."""
    keys: dict[str, Key] = {}
    for shape in SHAPES:
        keys |= dict(keys_of(shape))
    properties = {word: described(value(key, word), key) for word, key in {**keys, **BODY, **more}.items()}
    for word in ("sides", "corners"):  # their number depends on the shape
        properties[word] = {
            "type": "array",
            "minItems": 2,
            "description": BODY[word].help if word in BODY else keys[word].help,
        }
    return {"type": "object", "properties": properties, "additionalProperties": False}


def value(key: Key, word: str = "") -> dict[str, Any]:
    """The schema of one value, by its kind."""
    kinds: dict[str, dict[str, Any]] = {
        "text": SCALAR,
        "quantity": SCALAR,
        "gravity": SCALAR,
        "density": SCALAR,
        "flag": {"enum": [True, False, "true", "false", "yes", "no"]},
        "choice": {"enum": list(key.choices)},
        "shape": {"enum": [shape.word for shape in SHAPES]},
        "name": {"type": "string"},
        "names": {"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}]},
        "place": PLACE,
        "spot": PLACE,
        "region": named(LIMITS),
        "profile": named({"anyOf": [SCALAR, LIMITS]}),
        "places": {"type": "array", "items": PLACE},
        "quantities": {"type": "array", "items": SCALAR},
        "radii": {"type": "object", "additionalProperties": SCALAR},
        "point": POINT,
        "points": points(key),
        "points map": named(PLACE),
        "parts": named({"$ref": "#/$defs/part"}),
        "map of directions": {"type": "object", "additionalProperties": {"enum": list(key.choices)}},
        "direction": {"anyOf": [SCALAR, PLACE]},
        "vector": PLACE,
        "friction": FRICTION,
        "inertia": {"anyOf": [SCALAR, TENSOR, ABOUT]},
        "count": {"anyOf": [{"type": "integer", "minimum": 1}, {"type": "string"}]},
        "axis": {"anyOf": [SCALAR, PLACE]},
        "motion": {"anyOf": [SCALAR, PLACE]},
        "marks": SCALAR,
        "tolerance": SCALAR,
        "deductions": DEDUCTIONS,
        "deduction": SCALAR,
    }
    return kinds.get(key.kind, ANYTHING)


def points(key: Key) -> dict[str, Any]:
    low, high = key.count or (1, 50)
    several = {"type": "array", "items": POINT, "minItems": low, "maxItems": high}
    return {"anyOf": [{"type": "string"}, several]} if low == 1 else several
