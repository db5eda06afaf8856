"""Schema: the language as a JSON Schema for editors: which keys each shape and element has, what they mean, an example of each, snippets.

What a map means is told by one of its keys (`shape`, `string`, `force`), so each meaning is a definition of its own behind an `if`:
an editor shows the help of that shape alone, and a validator complains of its keys alone.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from rotsolve.elements.tables import SHAPES
from rotsolve.language.grammar import BODY, DEDUCT, IS, MARKING, PART, PHASE, SECTIONS, STATE, WHICH
from rotsolve.language.keys import Key, keys_of
from rotsolve.scene.bodies import keys_allowed
from rotsolve.scene.elements import TABLES
from rotsolve.scene.examples import as_data, example_body, example_element, example_value, with_stops
from rotsolve.scene.reference import element_text, key_meaning
from rotsolve.scene.scope import NAME

DIALECT = "https://json-schema.org/draft/2020-12/schema"
SCALAR: dict[str, Any] = {"type": ["string", "number", "boolean"]}
WORDS: dict[str, Any] = {"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}]}
PLACE: dict[str, Any] = {"type": "array", "items": SCALAR, "minItems": 2, "maxItems": 3}
EITHER: dict[str, Any] = {"anyOf": [SCALAR, PLACE]}
LIMITS: dict[str, Any] = {"type": "array", "items": SCALAR, "minItems": 2, "maxItems": 2}
POINT: dict[str, Any] = {"anyOf": [{"type": "string"}, PLACE]}
THREE: dict[str, Any] = {"type": "array", "items": SCALAR, "minItems": 3, "maxItems": 3}
ABOUT: dict[str, Any] = {
    "type": "object",
    "properties": {
        "value": SCALAR,
        "principal": THREE,
        "tensor": {"type": "array", "items": THREE, "minItems": 3, "maxItems": 3},
        "about": {"type": "string"},
    },
    "additionalProperties": False,
}
GRAVITY_IN: dict[str, Any] = {
    "type": "object",
    "properties": {"size": SCALAR, "in": {"type": "string"}},
    "additionalProperties": False,
    "required": ["in"],
}
ROTATION: dict[str, Any] = {
    "type": "object",
    "properties": {"about": EITHER, "by": SCALAR},
    "additionalProperties": False,
    "required": ["about", "by"],
}
CHOICE: dict[str, Any] = {
    "type": "object",
    "properties": {
        WHICH: {
            "type": "object",
            "additionalProperties": SCALAR,
            "minProperties": 2,
            "description": "options by label: quantities, or comparisons such as `3 < n < 6`",
        },
        IS: {
            "type": "string",
            "pattern": r"^\s*(largest|smallest|(above|below)\s+\S.*)$",
            "description": "which quantity: `largest`, `smallest`, `above X`, `below X`",
        },
    },
    "required": [WHICH],
    "additionalProperties": False,
}
NO_ELEMENT: dict[str, Any] = {"additionalProperties": False, "minProperties": 1}  # which none of its keys tells
FRICTION, DEDUCTIONS = (
    {"anyOf": [SCALAR, {"type": "object", "properties": dict.fromkeys(words, SCALAR), "additionalProperties": False}]}
    for words in (("static", "kinetic"), DEDUCT)
)
PLAIN = "without a shape"
SCENE = {  # one of all that a scene has most often
    "title": "Block hanging from a string wound on a solid disc",
    "given": {"m": "2 kg", "M": "5 kg", "R": "0.2 m"},
    "bodies": {
        "block": {"mass": "m", "moves": "down"},
        "disc": {"shape": "disc", "mass": "M", "radius": "R", "turns": "clockwise"},
    },
    "connections": {"axle": {"axle": "disc"}, "cord": {"string": ["disc", "block"]}},
    "find": {"a": "block.acceleration", "T": "cord.tension"},
}


def json_schema() -> dict[str, Any]:
    """The schema of a scene file."""
    return {
        "$schema": DIALECT,
        "title": "rotsolve scene",
        "description": "a problem of turning bodies, as docs/language.md describes it",
        "type": "object",
        "properties": {
            name: described(section_schema(name, key), name, key, SCENE.get(name)) for name, key in SECTIONS.items()
        },
        "required": [name for name, key in SECTIONS.items() if key.required],
        "additionalProperties": False,
        "examples": [SCENE],
        "$defs": {
            **body_schemas("body", {}),
            **body_schemas("part", PART),
            **{name: definition for section in TABLES for name, definition in element_schemas(section)},
        },
    }


def described(schema: dict[str, Any], word: str, key: Key, example: Any = None) -> dict[str, Any]:
    """The schema of a key with its help and an example for editors."""
    text = example_value(key)
    example = example or (as_data(text) if text else None)
    shown = {} if example is None else {"examples": [example]}
    return {**schema, "title": word, "description": key_meaning(key), **shown}


def named_map(schema: dict[str, Any]) -> dict[str, Any]:
    """A map from names to things."""
    return {"type": "object", "propertyNames": {"pattern": f"^{NAME.pattern}$"}, "additionalProperties": schema}


def section_schema(name: str, key: Key) -> dict[str, Any]:
    """The schema of a top-level key."""
    if name in TABLES:
        return named_map(one_of_elements(name))
    special: dict[str, dict[str, Any]] = {
        "given": named_map(SCALAR),
        "bodies": named_map({"anyOf": [{"enum": list(SHAPES.words)}, reference_to("body")]}),
        "states": named_map({"anyOf": [{"const": "at rest"}, {**map_schema(STATE), "additionalProperties": True}]}),
        "phases": named_map(map_schema(PHASE)),
        "find": {**named_map({"anyOf": [{"type": ["string", "number"]}, CHOICE]}), "minProperties": 1},
        "ask": named_map({"type": "string"}),
        "answers": {"type": "object"},
        "marking": named_map({"anyOf": [SCALAR, map_schema(MARKING)]}),
        "vary": named_map({"anyOf": [{"type": "string"}, {"type": "array", "items": SCALAR, "minItems": 1}]}),
        "assume": {"anyOf": [SCALAR, {"type": "array", "items": SCALAR}]},
        "unknown": WORDS,
    }
    return special.get(name) or value_schema(key)


def map_schema(keys: dict[str, Key]) -> dict[str, Any]:
    return {
        "type": "object",
        "properties": {word: described(value_schema(key), word, key) for word, key in keys.items()},
        "required": [word for word, key in keys.items() if key.required],
        "additionalProperties": False,
    }


def one_of_elements(section: str) -> dict[str, Any]:
    """An element of a section: a word alone, or a map with the one word that tells what it is."""
    alone, several = by_keys(section)
    named = [(cls, {"type": "object", "required": [cls.word]}) for cls in several]
    chosen = {
        "type": "object",
        "properties": {cls.word: {"title": cls.word, "description": cls.about} for cls in several},
        "allOf": [
            *({"if": has, "then": reference_to(definition_name(section, cls.word))} for cls, has in named),
            {"if": {"not": {"anyOf": [has for _, has in named]}}, "then": NO_ELEMENT},
        ],
        "defaultSnippets": [snippet(cls.word, cls.about, example_element(cls)) for cls in several],
    }
    return {"anyOf": [chosen, *({"const": cls.word, "title": cls.word, "description": cls.about} for cls in alone)]}


def element_schemas(section: str) -> Iterable[tuple[str, dict[str, Any]]]:
    """The elements of a section that are maps, each with its own keys."""
    kind, _ = TABLES[section]
    for cls in by_keys(section)[1]:
        about = {"title": cls.word, "description": element_text(cls, kind), "examples": [as_data(example_element(cls))]}
        yield definition_name(section, cls.word), {**map_schema(dict(keys_of(cls))), **about}


def by_keys(section: str) -> tuple[list[Any], list[Any]]:
    """The elements of a section that are one word alone (`floor: level`), and those that are maps."""
    table = TABLES[section][1]
    alone = [cls for cls in table if not any(key.required for _, key in keys_of(cls))]
    return alone, [cls for cls in table if cls not in alone]


def one_of_shapes(role: str) -> dict[str, Any]:
    """A body or part: by its shape one definition, without one that of all bodies."""
    return {
        "type": "object",
        "properties": {"shape": {"enum": list(SHAPES.words)}},
        "allOf": [
            *(
                {
                    "if": {"properties": {"shape": {"const": shape.word}}, "required": ["shape"]},
                    "then": reference_to(definition_name(role, shape.word)),
                }
                for shape in SHAPES
            ),
            {"if": {"not": {"required": ["shape"]}}, "then": reference_to(definition_name(role, PLAIN))},
        ],
        "defaultSnippets": [snippet(shape.word, shape.about, example_body(shape), shape.word) for shape in SHAPES],
    }


def body_schemas(role: str, more: dict[str, Key]) -> dict[str, dict[str, Any]]:
    """Bodies or parts of every shape, and those without one; a key that all bodies have is told once."""
    common = {**BODY, **more}
    told = {word: described(value_schema(key), word, key) for word, key in common.items()}
    plain = {"title": role, "type": "object", "properties": told, "additionalProperties": False}
    found = {role: one_of_shapes(role), definition_name(role, PLAIN): plain}
    for shape in SHAPES:
        own = dict(keys_of(shape))
        properties = {
            word: described(value_schema(own[word]), word, own[word])
            if word in own
            else reference_to(f"{definition_name(role, PLAIN)}/properties/{word}")
            for word in keys_allowed(shape, tuple(more))
        }
        found[definition_name(role, shape.word)] = {
            "title": shape.word,
            "description": element_text(shape, "shape"),
            "type": "object",
            "properties": {**properties, "shape": {"const": shape.word, "description": shape.about}},
            "required": ["shape", *(word for word, key in own.items() if key.required)],
            "additionalProperties": False,
            "examples": [as_data(example_body(shape))],
        }
    return found


def definition_name(role: str, word: str) -> str:
    return f"{role}_{word.replace(' ', '_')}"


def reference_to(name: str) -> dict[str, Any]:
    return {"$ref": f"#/$defs/{name}"}


def snippet(word: str, about: str, example: str, kept: str = "") -> dict[str, Any]:
    """What an editor offers to write: an example whose values are stops of the tab key."""
    return {"label": word, "description": about, "body": with_stops(as_data(example), kept)}


def value_schema(key: Key) -> dict[str, Any]:
    """The schema of one value, by its kind."""
    kinds: dict[str, dict[str, Any]] = {
        **dict.fromkeys(
            ("text", "word", "file", "room", "quantity", "density", "marks", "tolerance", "deduction"), SCALAR
        ),
        **dict.fromkeys(("place", "spot", "vector"), PLACE),
        **dict.fromkeys(("direction", "axis", "axis in space", "amount", "motion"), EITHER),
        "gravity": {"anyOf": [SCALAR, GRAVITY_IN]},
        "true": {"enum": [True, "true"]},
        "flag": {"enum": [True, False, "true", "false", "yes", "no"]},
        "choice": {"enum": list(key.choices)},
        "shape": {"enum": list(SHAPES.words)},
        "name": {"type": "string"},
        "names": WORDS,
        "region": named_map(LIMITS),
        "profile": named_map({"anyOf": [SCALAR, LIMITS]}),
        "corners": several(PLACE, key),
        "quantities": several(SCALAR, key),
        "radii": {"type": "object", "additionalProperties": SCALAR},
        "point": POINT,
        "points": several(POINT, key),
        "points map": named_map(PLACE),
        "parts": named_map(reference_to("part")),
        "map of directions": {"type": "object", "additionalProperties": {"enum": list(key.choices)}},
        "friction": FRICTION,
        "inertia": {"anyOf": [SCALAR, ABOUT]},
        "turns": {"anyOf": [ROTATION, {"type": "array", "items": ROTATION, "minItems": 1}]},
        "count": {"anyOf": [{"type": "integer", "minimum": 1}, {"type": "string"}]},
        "deductions": DEDUCTIONS,
    }
    return kinds.get(key.kind, {})


def several(item: dict[str, Any], key: Key) -> dict[str, Any]:
    """A list of as many as the key takes; of what may be one alone, that too."""
    low, high = key.count or (1, 50)
    listed = {"type": "array", "items": item, "minItems": low, "maxItems": high}
    return {"anyOf": [{"type": "string"}, listed]} if low == 1 else listed
