"""Reference: the language as markdown, and as a JSON Schema for editors, made from the tables that the reader reads."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from rotsolve.algebra.units.dimension import describe
from rotsolve.algebra.units.unit_table import AMBIGUOUS, UNITS
from rotsolve.core.quantity import QUANTITIES, QuantityKind
from rotsolve.elements.tables import SHAPES
from rotsolve.language.grammar import BODY, CLAUSES, DEDUCT, IS, MARKING, MODIFIERS, PART, PHASE, SECTIONS, WHICH
from rotsolve.language.keys import Key, keys_of
from rotsolve.language.words import hint, quoted
from rotsolve.scene.elements import TABLES
from rotsolve.scene.scope import NAME

BEGIN = "<!-- generated from the tables: begin -->"
END = "<!-- generated: end -->"
LATER = " *(not solved yet)*"
IN_SPACE = " *(in space)*"
IN_PLANE = " *(in the plane)*"


def describe_all() -> str:
    """The whole reference, plain enough for a terminal."""
    return "\n\n".join(reference_chapters())


def describe_word(name: str) -> str:
    """What one word means, in every place where it can stand. Raises KeyError with a hint for an unknown word."""
    wanted = " ".join(name.split())
    entries = [*word_entries(), ("units", chapter_text("Units", unit_rows()))]
    found = [text for word, text in entries if word == wanted]
    if not found:
        known = dict.fromkeys(word for word, _ in entries)
        raise KeyError(f"unknown word {quoted(name)}; {hint(wanted, known, 'words')}")
    return "\n\n".join(dict.fromkeys(found))


def generate() -> str:
    """The generated part of docs/language.md."""
    return f"{BEGIN}\n\n{describe_all()}\n\n{END}\n"


def word_entries() -> Iterator[tuple[str, str]]:
    """Every word of the language with its text."""
    for word, key in SECTIONS.items():
        yield word, f"`{word}` (top level): {key.help}{later_mark(key.later)}"
    for shape in SHAPES:
        yield shape.word, element_text(shape, "shape")
    for kind, table in TABLES.values():
        for cls in table:
            yield cls.word, element_text(cls, kind)
    for entry in QUANTITIES.values():
        about = f"`{entry.word}` (quantity): {entry.help}{later_mark(entry.later)}"
        about += f"; of: {', '.join(entry.owners)}" if entry.owners else ""
        yield entry.word, about + (f"; components: {', '.join(entry.components)}" if entry.components else "")
    for title, keys in (("body", BODY), ("part", PART), ("phase", PHASE), ("marking", MARKING), ("deduction", DEDUCT)):
        for word, key in keys.items():
            yield word, f"`{word}` (of a {title}): {key_meaning(key)}"
    for modifier in MODIFIERS:
        yield modifier, f"`{modifier}`: stands before an expression of `find` and belongs to the whole of it"
    for clause in CLAUSES:
        yield clause, f"`{clause}`: begins a clause of `find`, after the expression"


def reference_chapters() -> Iterator[str]:
    """The reference by chapter."""
    yield chapter_text("Top level", key_rows(SECTIONS.items()))
    yield chapter_text("Keys of a body", key_rows(BODY.items()))
    yield chapter_text("Keys of a part or hole, beside those of a body", key_rows(PART.items()))
    yield chapter_text("Shapes", [element_text(shape, "shape") for shape in SHAPES])
    for section, (kind, table) in TABLES.items():
        yield chapter_text(section.capitalize(), [element_text(cls, kind) for cls in table])
    yield chapter_text("Keys of a phase", key_rows(PHASE.items()))
    yield chapter_text("Keys of an answer's marking", key_rows(MARKING.items()))
    yield chapter_text("Keys of `deduct`", key_rows(DEDUCT.items()))
    lines = ["| word | letter | of | components | meaning |", "| --- | --- | --- | --- | --- |"]
    lines += [quantity_row(entry) for entry in QUANTITIES.values()]
    yield "### Quantities\n\n" + "\n".join(lines)
    yield chapter_text("Units", unit_rows())


def unit_rows() -> Iterator[str]:
    """The units by what they measure, `length: m, cm, …`; those that have several meanings, with what to write."""
    kinds: dict[str, list[str]] = {}
    for name, unit in UNITS.items():
        if name in (unit.text, "deg"):  # not the other spellings of one
            kinds.setdefault(describe(unit.dimension), []).append(name)
    for measure, names in kinds.items():
        yield f"{measure}: " + ", ".join(f"`{name}`" for name in names)
    for name, help in AMBIGUOUS.items():
        yield f"`{name}` has several meanings: {help}"


def chapter_text(title: str, items: Iterable[str]) -> str:
    return f"### {title}\n\n" + "\n".join(f"- {item}" for item in items)


def key_rows(keys: Iterable[tuple[str, Key]]) -> list[str]:
    return [f"`{word}`: {key_meaning(key)}" for word, key in keys]


def key_meaning(key: Key) -> str:
    """The help of a key with its choices, limits and example."""
    text = key.help
    if key.choices and not any(choice in key.help for choice in key.choices[:1]):
        text += f": {', '.join(key.choices)}"
    details = [key.dimension or "", key.limits, "required" if key.required else "", "may vary" if key.varies else ""]
    shown = ", ".join(detail for detail in details if detail)
    text += f" ({shown})" if shown else ""
    text += f", e.g. `{key.example}`" if key.example else ""
    return text + later_mark(key.later) + (IN_SPACE if key.space else IN_PLANE if key.plane else "")


def later_mark(flag: bool) -> str:
    return LATER if flag else ""


def element_text(cls: Any, kind: str) -> str:
    """An element with its keys, points, quantities and words."""
    world = IN_SPACE if not getattr(cls, "planar", True) else "" if getattr(cls, "spatial", True) else IN_PLANE
    lines = [f"`{cls.word}` ({kind}): {cls.about}{later_mark(cls.later)}{world}"]
    lines += [f"  - `{word}`: {key_meaning(key)}" for word, key in keys_of(cls)]
    if kind == "shape":
        lines.append(f"  - points: {', '.join((*cls.points, 'cm'))}")
    if getattr(cls, "quantities", ()):
        beside = getattr(cls, "quantities_in_space", ())
        more = f"; in space also {', '.join(beside)}" if beside else ""
        lines.append(f"  - quantities: {', '.join(cls.quantities)}{more}")
    if getattr(cls, "words", ()):
        lines.append(f"  - in a state it can be said to be: {', '.join(cls.words)}")
    return "\n".join(lines)


def quantity_row(entry: QuantityKind) -> str:
    lists = (", ".join(entry.owners), ", ".join(entry.components))
    meaning = entry.help + later_mark(entry.later) + (IN_SPACE if entry.space else "")
    return f"| {' | '.join((f'`{entry.word}`', entry.letter, *lists, meaning))} |"


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
        IS: {"type": "string", "description": "which quantity: `largest`, `smallest`, `above X`, `below X`"},
    },
    "required": [WHICH],
    "additionalProperties": False,
}
FRICTION, DEDUCTIONS = (
    {"anyOf": [SCALAR, {"type": "object", "properties": dict.fromkeys(words, SCALAR), "additionalProperties": False}]}
    for words in (("static", "kinetic"), DEDUCT)
)


def json_schema() -> dict[str, Any]:
    """The schema of a scene file."""
    properties = {name: described(section_schema(name, key), key) for name, key in SECTIONS.items()}
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "rotsolve scene",
        "type": "object",
        "properties": properties,
        "required": [name for name, key in SECTIONS.items() if key.required],
        "additionalProperties": False,
        "$defs": {"body": body_schema({}), "part": body_schema(PART)},
    }


def described(schema: dict[str, Any], key: Key) -> dict[str, Any]:
    """The schema of a key with its help for editors."""
    text = key.help + (" (not solved yet)" if key.later else "")
    return {**schema, "description": text}


def named_map(schema: dict[str, Any]) -> dict[str, Any]:
    """A map from names to things."""
    return {"type": "object", "propertyNames": {"pattern": f"^{NAME.pattern}$"}, "additionalProperties": schema}


def section_schema(name: str, key: Key) -> dict[str, Any]:
    """The schema of a top-level key."""
    if name in TABLES:
        return named_map({"anyOf": [map_schema(dict(keys_of(cls))) for cls in TABLES[name][1]] + single_words(name)})
    special: dict[str, dict[str, Any]] = {
        "given": named_map(SCALAR),
        "bodies": named_map({"anyOf": [{"enum": list(SHAPES.words)}, {"$ref": "#/$defs/body"}]}),
        "states": named_map({"anyOf": [{"const": "at rest"}, {"type": "object"}]}),
        "phases": named_map(map_schema(PHASE)),
        "find": {**named_map({"anyOf": [{"type": ["string", "number"]}, CHOICE]}), "minProperties": 1},
        "answers": {"type": "object"},
        "marking": named_map({"anyOf": [SCALAR, map_schema(MARKING)]}),
        "vary": named_map({"anyOf": [{"type": "string"}, {"type": "array", "items": SCALAR, "minItems": 1}]}),
        "assume": {"anyOf": [SCALAR, {"type": "array", "items": SCALAR}]},
        "unknown": WORDS,
    }
    return special.get(name) or value_schema(key)


def single_words(name: str) -> list[dict[str, Any]]:
    """Elements that are one word alone: `floor: level`."""
    alone = [cls.word for cls in TABLES[name][1] if not any(key.required for _, key in keys_of(cls))]
    return [{"enum": alone}] if alone else []


def map_schema(keys: dict[str, Key]) -> dict[str, Any]:
    return {
        "type": "object",
        "properties": {word: described(value_schema(key), key) for word, key in keys.items()},
        "required": [word for word, key in keys.items() if key.required],
        "additionalProperties": False,
    }


def body_schema(more: dict[str, Key]) -> dict[str, Any]:
    """A body: the keys of all bodies and of all shapes."""
    declared = [entry for shape in SHAPES for entry in keys_of(shape)]
    keys = {**dict(declared), **BODY, **more}
    properties = {word: described(value_schema(key), key) for word, key in keys.items()}
    counts = {word: {key.count for other, key in declared if other == word} for word, _ in declared}
    for word in (word for word, found in counts.items() if len(found) > 1):  # their number depends on the shape
        properties[word] = {"type": "array", "minItems": 2, "description": keys[word].help}
    return {"type": "object", "properties": properties, "additionalProperties": False}


def value_schema(key: Key) -> dict[str, Any]:
    """The schema of one value, by its kind."""
    kinds: dict[str, dict[str, Any]] = {
        **dict.fromkeys(("text", "quantity", "density", "marks", "tolerance", "deduction"), SCALAR),
        **dict.fromkeys(("place", "spot", "vector"), PLACE),
        **dict.fromkeys(("direction", "axis", "axis in space", "amount", "motion"), EITHER),
        "gravity": {"anyOf": [SCALAR, GRAVITY_IN]},
        "flag": {"enum": [True, False, "true", "false", "yes", "no"]},
        "choice": {"enum": list(key.choices)},
        "shape": {"enum": list(SHAPES.words)},
        "name": {"type": "string"},
        "names": WORDS,
        "region": named_map(LIMITS),
        "profile": named_map({"anyOf": [SCALAR, LIMITS]}),
        "corners": {"type": "array", "items": PLACE},
        "quantities": {"type": "array", "items": SCALAR},
        "radii": {"type": "object", "additionalProperties": SCALAR},
        "point": POINT,
        "points": points_schema(key),
        "points map": named_map(PLACE),
        "parts": named_map({"$ref": "#/$defs/part"}),
        "map of directions": {"type": "object", "additionalProperties": {"enum": list(key.choices)}},
        "friction": FRICTION,
        "inertia": {"anyOf": [SCALAR, ABOUT]},
        "turns": {"anyOf": [ROTATION, {"type": "array", "items": ROTATION, "minItems": 1}]},
        "count": {"anyOf": [{"type": "integer", "minimum": 1}, {"type": "string"}]},
        "deductions": DEDUCTIONS,
    }
    return kinds.get(key.kind, {})


def points_schema(key: Key) -> dict[str, Any]:
    low, high = key.count or (1, 50)
    several = {"type": "array", "items": POINT, "minItems": low, "maxItems": high}
    return {"anyOf": [{"type": "string"}, several]} if low == 1 else several
